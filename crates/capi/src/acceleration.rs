use slideway_conditioner as core_laws;
use slideway_conditioner::acceleration::{AccelerationState, LookAhead, LookAheadSettings, Recovery};
use slideway_conditioner::{AccelerationLimits, AccelerationRegulator, AffineSpeed, SpeedLimits};

use crate::command::AccelerationCommand;
use crate::dispatch::with_joints;
use crate::memory::{
    CALLERS_MEMORY, Header, Kind, check_pointer, deliver, end, header, numbers, object_size, place, read_in, sized,
    value,
};
use crate::refusal::{Refusal, Refused, report};
use crate::speed::first;
use crate::status::Status;
use crate::{ACCELERATION_SIZE_MAX, MAX_JOINTS};

/// A speed regulator under limits on joint speed and joint acceleration, with its state and its look-ahead.
///
/// One object is used by one thread at a time.
pub struct Acceleration {
    _opaque: (),
}

impl Kind for Acceleration {
    const NUMBER: u32 = u32::from_be_bytes(*b"acc\x01");
}

/// Parameters of an acceleration-limited regulator. Of an array the first `joints` elements count.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct AccelerationSettings {
    /// Size of this structure as the caller knows it: `sizeof(slideway_acceleration_settings)`.
    pub size: u32,
    /// Number of joints, from 1 to `SLIDEWAY_MAX_JOINTS`.
    pub joints: u32,
    /// One of `slideway_recovery_kind`.
    pub recovery: u32,
    /// Nothing; 0.
    pub reserved: u32,
    /// Lower joint-speed limits, negative, rad/s.
    pub lower_speed: [f64; MAX_JOINTS],
    /// Upper joint-speed limits, positive, rad/s.
    pub upper_speed: [f64; MAX_JOINTS],
    /// Lower joint-acceleration limits, negative, rad/s^2.
    pub lower_acceleration: [f64; MAX_JOINTS],
    /// Upper joint-acceleration limits, positive, rad/s^2.
    pub upper_acceleration: [f64; MAX_JOINTS],
    /// Sampling period, s.
    pub sampling_period: f64,
    /// Filter bandwidth, rad/s; times the sampling period at most 1.
    pub bandwidth: f64,
    /// Target rate of the path parameter, 1/s: above what the limits allow.
    pub target_rate: f64,
    /// Gain of the position loop, 1/s; times the sampling period at most one half. For `SLIDEWAY_RECOVERY_KIND_BRAKING`.
    pub gain: f64,
    /// Share of the acceleration limits, in [0, 1), that the look-ahead leaves to the position loop and the discretisation.
    pub look_ahead_margin: f64,
}

sized!(AccelerationSettings);

/// The regulator behind a pointer to an [`Acceleration`], with its look-ahead, limits and state.
pub(crate) struct Loop<const N: usize> {
    regulator: AccelerationRegulator<N>,
    pub(crate) look_ahead: LookAhead<N>,
    limits: SpeedLimits<N>,
    state: AccelerationState<N>,
}

const _: () = assert!(object_size::<Loop<MAX_JOINTS>>() <= ACCELERATION_SIZE_MAX);

fn recovery(settings: &AccelerationSettings) -> Result<Recovery, Status> {
    match settings.recovery {
        0 => Ok(Recovery::AsDemanded),
        1 => Ok(Recovery::Braking { gain: settings.gain }),
        _ => Err(Status::Choice),
    }
}

impl<const N: usize> Loop<N> {
    fn new(settings: &AccelerationSettings) -> Result<Self, Refused> {
        let limits = SpeedLimits::new(first(&settings.lower_speed), first(&settings.upper_speed))?;
        let acceleration_limits =
            AccelerationLimits::new(first(&settings.lower_acceleration), first(&settings.upper_acceleration))?;
        let regulator = AccelerationRegulator::new(core_laws::acceleration::AccelerationSettings {
            speed_limits: limits,
            acceleration_limits,
            sampling_period: settings.sampling_period,
            bandwidth: settings.bandwidth,
            target_rate: settings.target_rate,
            recovery: recovery(settings)?,
        })?;
        let look_ahead = LookAhead::new(LookAheadSettings {
            speed_limits: limits,
            acceleration_limits,
            sampling_period: settings.sampling_period,
            target_rate: settings.target_rate,
            margin: settings.look_ahead_margin,
        })?;
        Ok(Self { regulator, look_ahead, limits, state: AccelerationState::at_rest() })
    }
}

/// Bytes of memory that an acceleration-limited regulator of this many joints takes; 0 for a number of joints that there is none for.
#[unsafe(no_mangle)]
pub extern "C" fn slideway_acceleration_size(joints: u32) -> usize {
    let size: Result<usize, Status> = with_joints!(joints, N => Ok(object_size::<Loop<N>>()));
    size.unwrap_or(0)
}

/// Makes an acceleration-limited regulator, robot and reference at rest, in memory of the caller's; as `slideway_speed_place`.
///
/// # Safety
///
/// As `slideway_speed_place`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_acceleration_place(
    memory: *mut u8,
    bytes: usize,
    settings: *const AccelerationSettings,
    acceleration: *mut *mut Acceleration,
    why: *mut Refusal,
) -> Status {
    // SAFETY: the caller's promise.
    let result = unsafe { make(memory, bytes, settings, acceleration, CALLERS_MEMORY) };
    // SAFETY: the caller's promise.
    unsafe { report(result, why) }
}

/// # Safety
///
/// As [`slideway_acceleration_place`].
pub(crate) unsafe fn make(
    memory: *mut u8,
    bytes: usize,
    settings: *const AccelerationSettings,
    acceleration: *mut *mut Acceleration,
    owner: u32,
) -> Result<(), Refused> {
    check_pointer(acceleration)?;
    // SAFETY: not null, aligned, writable by the caller's promise.
    unsafe { acceleration.write(core::ptr::null_mut()) };
    // SAFETY: the caller's promise.
    let settings = unsafe { read_in(settings) }?;
    let head =
        Header { kind: Acceleration::NUMBER, joints: settings.joints, constraints: 0, owner, busy: 0, reserved: 0 };
    with_joints!(settings.joints, N => {
        let value = Loop::<N>::new(&settings)?;
        // SAFETY: the caller's promise.
        unsafe { place(memory, bytes, head, value) }.map_err(Refused::from)
    })?;
    // SAFETY: as above.
    unsafe { acceleration.write(memory.cast()) };
    Ok(())
}

/// Ends an acceleration-limited regulator in memory of the caller's, who may then use the memory for something else.
///
/// # Safety
///
/// `acceleration` is null or an object of this kind that no other thread uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_acceleration_drop(acceleration: *mut Acceleration) -> Status {
    // SAFETY: the caller's promise.
    unsafe { end(acceleration, CALLERS_MEMORY) }.err().unwrap_or(Status::Ok)
}

/// Sets the state: the factor, from 0 at rest to 1, and the joint speed that the robot has, rad/s, inside the limits. `joint_speed` may
/// be null for joints at rest. Without effect on failure.
///
/// # Safety
///
/// `acceleration` is null or an object of this kind that no other thread uses; `joint_speed` is null or points to as many numbers as it
/// has joints; `why` is null or points to a refusal.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_acceleration_set_state(
    acceleration: *mut Acceleration,
    factor: f64,
    joint_speed: *const f64,
    why: *mut Refusal,
) -> Status {
    // SAFETY: the caller's promise.
    let result = unsafe { set_state(acceleration, factor, joint_speed) };
    // SAFETY: the caller's promise.
    unsafe { report(result, why) }
}

/// # Safety
///
/// As [`slideway_acceleration_set_state`].
unsafe fn set_state(acceleration: *mut Acceleration, factor: f64, joint_speed: *const f64) -> Result<(), Refused> {
    // SAFETY: the caller's promise.
    let head = unsafe { header(acceleration.cast_const()) }?;
    with_joints!(head.joints, N => {
        let speed = if joint_speed.is_null() {
            [0.0; N]
        } else {
            // SAFETY: the caller's promise.
            unsafe { numbers::<N>(joint_speed) }?
        };
        // SAFETY: living, of this number of joints.
        let this = unsafe { value::<_, Loop<N>>(acceleration) };
        this.state = AccelerationState::moving(factor, speed, &this.limits)?;
        Ok(())
    })
}

/// One sample: from the desired joint speed in two parts, `feedback + factor * feedforward` in rad/s, to a command that keeps the limits
/// on speed and acceleration. The parts are those of `slideway_speed_step_affine`.
///
/// `ceiling` is the largest path rate, 1/s, from `slideway_look_ahead_rate` or `..._within`; `INFINITY` without look-ahead. The limits
/// win over the ceiling: joints that cannot slow down faster pull the reference along. A ceiling that is NaN counts as 0.
///
/// A NaN or an infinity in the demand is no error: the joints brake as fast as they may. If the call fails the command, where it could be
/// written, says standstill, and the state does not change.
///
/// At most 2N + 1 passes over the N joints, where the demand is out of reach; a few otherwise.
///
/// # Safety
///
/// `acceleration` is null or an object of this kind that no other thread uses; the inputs are null or point to as many numbers as it has
/// joints; `command` is null or points to a command.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_acceleration_step(
    acceleration: *mut Acceleration,
    feedback: *const f64,
    feedforward: *const f64,
    ceiling: f64,
    command: *mut AccelerationCommand,
) -> Status {
    // SAFETY: the caller's promise; the command is checked first.
    let run = || unsafe { step(acceleration, feedback, feedforward, ceiling, command) };
    // SAFETY: the caller's promise.
    unsafe { deliver(command, run) }
}

/// # Safety
///
/// As [`slideway_acceleration_step`], and the command may be written.
unsafe fn step(
    acceleration: *mut Acceleration,
    feedback: *const f64,
    feedforward: *const f64,
    ceiling: f64,
    command: *mut AccelerationCommand,
) -> Result<(), Status> {
    // SAFETY: the caller's promise.
    let head = unsafe { header(acceleration.cast_const()) }?;
    with_joints!(head.joints, N => {
        // SAFETY: the caller's promise.
        let feedback = unsafe { numbers::<N>(feedback) }?;
        // SAFETY: the caller's promise.
        let feedforward = unsafe { numbers::<N>(feedforward) }?;
        // SAFETY: living, of this number of joints.
        let this = unsafe { value::<_, Loop<N>>(acceleration) };
        let demand = AffineSpeed { feedback, feedforward };
        let decided = this.regulator.step_below(&mut this.state, &demand, ceiling);
        // SAFETY: checked by the caller; the inputs were copied.
        unsafe { &mut *command }.fill(&decided);
        Ok(())
    })
}
