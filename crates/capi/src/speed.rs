use slideway_conditioner as core_laws;
use slideway_conditioner::{Advance, AffineSpeed, ImplicitSpeedRegulator, SpeedLimits, SpeedRegulator, SpeedState};

use crate::choices::{SaturationKind, SpeedLaw};
use crate::command::SpeedCommand;
use crate::dispatch::with_joints;
use crate::memory::{
    CALLERS_MEMORY, Header, Kind, check_pointer, deliver, end, header, numbers, object_size, place, read_in, sized,
    value,
};
use crate::refusal::{Refusal, Refused, report};
use crate::status::Status;
use crate::{MAX_JOINTS, SPEED_SIZE_MAX};

/// A speed regulator with its state: how fast the reference may go on so that every joint keeps its speed limits.
///
/// One object is used by one thread at a time.
pub struct Speed {
    _opaque: (),
}

impl Kind for Speed {
    const NUMBER: u32 = u32::from_be_bytes(*b"spd\x01");
}

/// Parameters of a speed regulator. Of an array the first `joints` elements count.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct SpeedSettings {
    /// Size of this structure as the caller knows it: `sizeof(slideway_speed_settings)`.
    pub size: u32,
    /// Number of joints, from 1 to `SLIDEWAY_MAX_JOINTS`.
    pub joints: u32,
    /// One of `slideway_speed_law`.
    pub law: u32,
    /// One of `slideway_saturation_kind`.
    pub saturation: u32,
    /// Lower joint-speed limits, negative, rad/s (m/s for a sliding joint).
    pub lower: [f64; MAX_JOINTS],
    /// Upper joint-speed limits, positive, rad/s (m/s for a sliding joint).
    pub upper: [f64; MAX_JOINTS],
    /// Sampling period, s.
    pub sampling_period: f64,
    /// Filter bandwidth, rad/s; times the sampling period at most 1.
    pub bandwidth: f64,
    /// Target rate of the path parameter, 1/s: above what the limits allow.
    pub target_rate: f64,
}

sized!(SpeedSettings);

/// The law of an object.
enum Law<const N: usize> {
    Explicit(SpeedRegulator<N>),
    Implicit(ImplicitSpeedRegulator<N>),
}

/// The regulator behind a pointer to a [`Speed`], with its state.
pub(crate) struct Loop<const N: usize> {
    law: Law<N>,
    state: SpeedState,
}

const _: () = assert!(object_size::<Loop<MAX_JOINTS>>() <= SPEED_SIZE_MAX);

/// The first `N` of a field's numbers.
pub(crate) fn first<const N: usize>(numbers: &[f64]) -> [f64; N] {
    let mut first = [f64::NAN; N];
    for (slot, number) in first.iter_mut().zip(numbers) {
        *slot = *number;
    }
    first
}

impl<const N: usize> Loop<N> {
    fn new(settings: &SpeedSettings) -> Result<Self, Refused> {
        let advance = SpeedLaw::from_number(settings.law)?;
        let core = core_laws::SpeedSettings {
            saturation: SaturationKind::from_number(settings.saturation)?,
            limits: SpeedLimits::new(first(&settings.lower), first(&settings.upper))?,
            sampling_period: settings.sampling_period,
            bandwidth: settings.bandwidth,
            target_rate: settings.target_rate,
            advance: advance.unwrap_or(Advance::Synchronised),
        };
        let law = match advance {
            Some(_) => Law::Explicit(SpeedRegulator::new(core)?),
            None => Law::Implicit(ImplicitSpeedRegulator::new(core)?),
        };
        Ok(Self { law, state: SpeedState::at_rest() })
    }

    fn requested_rate(&self) -> f64 {
        match &self.law {
            Law::Explicit(law) => law.requested_rate(&self.state),
            Law::Implicit(law) => law.target_rate(),
        }
    }

    fn set_limits(&mut self, limits: SpeedLimits<N>) {
        self.law = match &self.law {
            Law::Explicit(law) => Law::Explicit(law.with_limits(limits)),
            Law::Implicit(law) => Law::Implicit(law.with_limits(limits)),
        };
    }
}

/// Bytes of memory that a speed regulator of this many joints takes; 0 for a number of joints that there is none for.
#[unsafe(no_mangle)]
pub extern "C" fn slideway_speed_size(joints: u32) -> usize {
    let size: Result<usize, Status> = with_joints!(joints, N => Ok(object_size::<Loop<N>>()));
    size.unwrap_or(0)
}

/// Makes a speed regulator, reference at rest, in memory of the caller's; no allocation.
///
/// `memory` lies on a multiple of `SLIDEWAY_ALIGNMENT`, has `bytes` bytes, at least `slideway_speed_size`, and belongs to the object
/// until `slideway_speed_drop`. `*speed` becomes the object, or null on failure. `why` may be null.
///
/// # Safety
///
/// Every pointer is null or points to what its type says, `memory` to `bytes` writable bytes that nobody else uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_speed_place(
    memory: *mut u8,
    bytes: usize,
    settings: *const SpeedSettings,
    speed: *mut *mut Speed,
    why: *mut Refusal,
) -> Status {
    // SAFETY: the caller's promise.
    let result = unsafe { make(memory, bytes, settings, speed, CALLERS_MEMORY) };
    // SAFETY: the caller's promise.
    unsafe { report(result, why) }
}

/// # Safety
///
/// As [`slideway_speed_place`].
pub(crate) unsafe fn make(
    memory: *mut u8,
    bytes: usize,
    settings: *const SpeedSettings,
    speed: *mut *mut Speed,
    owner: u32,
) -> Result<(), Refused> {
    check_pointer(speed)?;
    // SAFETY: not null, aligned, writable by the caller's promise.
    unsafe { speed.write(core::ptr::null_mut()) };
    // SAFETY: the caller's promise.
    let settings = unsafe { read_in(settings) }?;
    let head = Header { kind: Speed::NUMBER, joints: settings.joints, constraints: 0, owner, busy: 0, reserved: 0 };
    with_joints!(settings.joints, N => {
        let value = Loop::<N>::new(&settings)?;
        // SAFETY: the caller's promise.
        unsafe { place(memory, bytes, head, value) }.map_err(Refused::from)
    })?;
    // SAFETY: as above.
    unsafe { speed.write(memory.cast()) };
    Ok(())
}

/// Ends a speed regulator in memory of the caller's, who may then use the memory for something else.
///
/// # Safety
///
/// `speed` is null or an object of this kind that no other thread uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_speed_drop(speed: *mut Speed) -> Status {
    // SAFETY: the caller's promise.
    match unsafe { end(speed, CALLERS_MEMORY) } {
        Ok(_) => Status::Ok,
        Err(status) => status,
    }
}

/// The path rate, 1/s, with which the controller is to compute this sample's desired joint speed: the factor times the target rate.
/// For the implicit law, which decides the factor afterwards, the target rate itself. 0 for what is no object.
///
/// # Safety
///
/// `speed` is null or an object of this kind that no other thread uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_speed_requested_rate(speed: *const Speed) -> f64 {
    // SAFETY: the caller's promise.
    let Ok(head) = (unsafe { header(speed) }) else { return 0.0 };
    let rate: Result<f64, Status> = with_joints!(head.joints, N => {
        // SAFETY: living, of this number of joints; only read.
        let this = unsafe { value::<_, Loop<N>>(speed.cast_mut()) };
        Ok(this.requested_rate())
    });
    rate.unwrap_or(0.0)
}

/// Sets the factor: 0 for a reference at rest, up to 1 for one that already moves. Without effect on failure.
///
/// # Safety
///
/// `speed` is null or an object of this kind that no other thread uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_speed_set_factor(speed: *mut Speed, factor: f64) -> Status {
    // SAFETY: the caller's promise.
    let head = match unsafe { header(speed.cast_const()) } {
        Ok(head) => head,
        Err(status) => return status,
    };
    let state = match SpeedState::moving(factor) {
        Ok(state) => state,
        Err(error) => return Refused::from(error).status,
    };
    let result: Result<(), Status> = with_joints!(head.joints, N => {
        // SAFETY: living, of this number of joints.
        let this = unsafe { value::<_, Loop<N>>(speed) };
        this.state = state;
        Ok(())
    });
    result.err().unwrap_or(Status::Ok)
}

/// Changes the speed limits, for limits that vary along the path; the state is kept. Without effect on failure.
///
/// # Safety
///
/// `speed` is null or an object of this kind that no other thread uses; `lower` and `upper` are null or point to as many numbers as it
/// has joints; `why` is null or points to a refusal.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_speed_set_limits(
    speed: *mut Speed,
    lower: *const f64,
    upper: *const f64,
    why: *mut Refusal,
) -> Status {
    // SAFETY: the caller's promise.
    let result = unsafe { set_limits(speed, lower, upper) };
    // SAFETY: the caller's promise.
    unsafe { report(result, why) }
}

/// # Safety
///
/// As [`slideway_speed_set_limits`].
unsafe fn set_limits(speed: *mut Speed, lower: *const f64, upper: *const f64) -> Result<(), Refused> {
    // SAFETY: the caller's promise.
    let head = unsafe { header(speed.cast_const()) }?;
    with_joints!(head.joints, N => {
        // SAFETY: the caller's promise.
        let lower = unsafe { numbers::<N>(lower) }?;
        // SAFETY: the caller's promise.
        let upper = unsafe { numbers::<N>(upper) }?;
        let limits = SpeedLimits::new(lower, upper)?;
        // SAFETY: living, of this number of joints.
        let this = unsafe { value::<_, Loop<N>>(speed) };
        this.set_limits(limits);
        Ok(())
    })
}

/// One sample of an explicit law (paper, synchronised): from the desired joint speed, rad/s, to the command.
///
/// A NaN or an infinity in `desired` is no error: it commands a standstill and holds the reference. If the call fails the command, where
/// it could be written, says standstill.
///
/// At most five passes over the joints, whatever the data; no loop depends on it.
///
/// # Safety
///
/// `speed` is null or an object of this kind that no other thread uses; `desired` is null or points to as many numbers as it has
/// joints; `command` is null or points to a command.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_speed_step(
    speed: *mut Speed,
    desired: *const f64,
    command: *mut SpeedCommand,
) -> Status {
    // SAFETY: the caller's promise; the command is checked first.
    let run = || unsafe { explicit(speed, desired, command) };
    // SAFETY: the caller's promise.
    unsafe { deliver(command, run) }
}

/// # Safety
///
/// As [`slideway_speed_step`], and the command may be written.
unsafe fn explicit(speed: *mut Speed, desired: *const f64, command: *mut SpeedCommand) -> Result<(), Status> {
    // SAFETY: the caller's promise.
    let head = unsafe { header(speed.cast_const()) }?;
    with_joints!(head.joints, N => {
        // SAFETY: living, of this number of joints.
        let this = unsafe { value::<_, Loop<N>>(speed) };
        let Law::Explicit(law) = &this.law else { return Err(Status::Law) };
        // SAFETY: the caller's promise.
        let desired = unsafe { numbers::<N>(desired) }?;
        let decided = law.step(&mut this.state, &desired);
        // SAFETY: checked by the caller; the inputs were copied.
        unsafe { &mut *command }.fill(&decided);
        Ok(())
    })
}

/// One sample of the implicit law: from the desired joint speed in two parts to the command.
///
/// The controller asks for `feedback + factor * feedforward`, rad/s: `feedback` is what it wants with the reference standing still,
/// `feedforward` what the reference at the target rate adds to it. Two evaluations of any controller give both:
/// `feedback = at(0)`, `feedforward = at(target rate) - at(0)`.
///
/// NaN and failure as in `slideway_speed_step`.
///
/// # Safety
///
/// As `slideway_speed_step`, for both inputs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_speed_step_affine(
    speed: *mut Speed,
    feedback: *const f64,
    feedforward: *const f64,
    command: *mut SpeedCommand,
) -> Status {
    // SAFETY: the caller's promise; the command is checked first.
    let run = || unsafe { affine(speed, feedback, feedforward, command) };
    // SAFETY: the caller's promise.
    unsafe { deliver(command, run) }
}

/// # Safety
///
/// As [`slideway_speed_step_affine`], and the command may be written.
unsafe fn affine(
    speed: *mut Speed,
    feedback: *const f64,
    feedforward: *const f64,
    command: *mut SpeedCommand,
) -> Result<(), Status> {
    // SAFETY: the caller's promise.
    let head = unsafe { header(speed.cast_const()) }?;
    with_joints!(head.joints, N => {
        // SAFETY: living, of this number of joints.
        let this = unsafe { value::<_, Loop<N>>(speed) };
        let Law::Implicit(law) = &this.law else { return Err(Status::Law) };
        // SAFETY: the caller's promise.
        let feedback = unsafe { numbers::<N>(feedback) }?;
        // SAFETY: the caller's promise.
        let feedforward = unsafe { numbers::<N>(feedforward) }?;
        let decided = law.step(&mut this.state, &AffineSpeed { feedback, feedforward });
        // SAFETY: checked by the caller; the inputs were copied.
        unsafe { &mut *command }.fill(&decided);
        Ok(())
    })
}
