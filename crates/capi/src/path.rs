use slideway_conditioner::PathConditioner;
use slideway_conditioner::path::{Constraint as Evaluate, Motion, PathState, PathStep};

use crate::callback::Callback;
use crate::dispatch::{with_constraints, with_joints};
use crate::memory::{
    CALLERS_MEMORY, Header, Kind, check_pointer, deliver, end, header, numbers, object_size, place, read_in, set_busy,
    slice, value,
};
use crate::path_output::PathOutput;
use crate::path_settings::PathSettings;
use crate::refusal::{Refusal, Refused, report};
use crate::status::Status;
use crate::surface::Wall;
use crate::{MAX_CONSTRAINTS, MAX_JOINTS, PATH_SIZE_MAX};

/// A path conditioner with its constraints and its state: bends a reference along the boundary of the allowed set.
///
/// One object is used by one thread at a time.
pub struct Path {
    _opaque: (),
}

impl Kind for Path {
    const NUMBER: u32 = u32::from_be_bytes(*b"pth\x01");
}

/// The conditioner behind a pointer to a [`Path`], with its constraints and state.
pub(crate) struct Loop<const N: usize, const M: usize> {
    conditioner: PathConditioner<N, M>,
    walls: [Wall<N>; M],
    state: PathState<N, M>,
}

const _: () = assert!(object_size::<Loop<MAX_JOINTS, MAX_CONSTRAINTS>>() <= PATH_SIZE_MAX);

/// As `with_joints`, for both numbers.
macro_rules! with_sizes {
    ($joints:expr, $constraints:expr, $N:ident, $M:ident => $body:expr) => {
        with_joints!($joints, $N => with_constraints!($constraints, $M => $body))
    };
}

impl<const N: usize, const M: usize> Loop<N, M> {
    /// # Safety
    ///
    /// As [`slideway_path_place`], for the settings.
    unsafe fn new(settings: &PathSettings) -> Result<Self, Refused> {
        let conditioner = PathConditioner::new(settings.core()?)?;
        // SAFETY: the caller's promise.
        let given = unsafe { slice(settings.constraints, M) }?;
        let mut walls = [const { Wall::Callback(Callback::FAILING) }; M];
        for (index, (slot, constraint)) in walls.iter_mut().zip(given).enumerate() {
            // SAFETY: the caller's promise.
            let wall = unsafe { read_in(constraint) }.map_err(Refused::from).and_then(|constraint| {
                // SAFETY: the caller's promise.
                unsafe { constraint.wall() }
            });
            *slot = wall.map_err(|refused| Refused { constraint: index as u32, ..refused })?;
        }
        Ok(Self { state: conditioner.on_reference(), conditioner, walls })
    }

    #[inline(never)]
    fn step(&mut self, reference: &Motion<N>) -> PathStep<N, M> {
        let walls = &self.walls;
        self.conditioner.step(&mut self.state, reference, |motion| walls.each_ref().map(|wall| wall.sample(motion)))
    }
}

/// Bytes of memory that a path conditioner of this size takes; 0 for a size that there is none for.
#[unsafe(no_mangle)]
pub extern "C" fn slideway_path_size(coordinates: u32, constraints: u32) -> usize {
    let size: Result<usize, Status> = with_sizes!(coordinates, constraints, N, M => Ok(object_size::<Loop<N, M>>()));
    size.unwrap_or(0)
}

/// Makes a path conditioner, before its first sample, in memory of the caller's; as `slideway_speed_place`. The constraints are copied;
/// what a callback's context points to is not.
///
/// # Safety
///
/// As `slideway_speed_place`; the settings' pointers are null or point to what their fields say, and a callback may be called for as
/// long as the object lives.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_path_place(
    memory: *mut u8,
    bytes: usize,
    settings: *const PathSettings,
    path: *mut *mut Path,
    why: *mut Refusal,
) -> Status {
    // SAFETY: the caller's promise.
    let result = unsafe { make(memory, bytes, settings, path, CALLERS_MEMORY) };
    // SAFETY: the caller's promise.
    unsafe { report(result, why) }
}

/// # Safety
///
/// As [`slideway_path_place`].
pub(crate) unsafe fn make(
    memory: *mut u8,
    bytes: usize,
    settings: *const PathSettings,
    path: *mut *mut Path,
    owner: u32,
) -> Result<(), Refused> {
    check_pointer(path)?;
    // SAFETY: not null, aligned, writable by the caller's promise.
    unsafe { path.write(core::ptr::null_mut()) };
    // SAFETY: the caller's promise.
    let settings = unsafe { read_in(settings) }?;
    let (joints, constraints) = (settings.coordinates, settings.constraint_count);
    let head = Header { kind: Path::NUMBER, joints, constraints, owner, busy: 0, reserved: 0 };
    with_sizes!(joints, constraints, N, M => {
        // SAFETY: the caller's promise.
        let value = unsafe { Loop::<N, M>::new(&settings) }?;
        // SAFETY: the caller's promise.
        unsafe { place(memory, bytes, head, value) }.map_err(Refused::from)
    })?;
    // SAFETY: as above.
    unsafe { path.write(memory.cast()) };
    Ok(())
}

/// Ends a path conditioner in memory of the caller's, who may then use the memory for something else.
///
/// # Safety
///
/// `path` is null or an object of this kind that no other thread uses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_path_drop(path: *mut Path) -> Status {
    // SAFETY: the caller's promise.
    unsafe { end(path, CALLERS_MEMORY) }.err().unwrap_or(Status::Ok)
}

/// Starts anew: at rest at `position` wherever the reference is, or, if `position` is null, on the next reference and with its velocity.
/// Without effect on failure.
///
/// # Safety
///
/// `path` is null or an object of this kind that no other thread uses; `position` is null or points to as many numbers as it has
/// coordinates; `why` is null or points to a refusal.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_path_restart(path: *mut Path, position: *const f64, why: *mut Refusal) -> Status {
    // SAFETY: the caller's promise.
    let result = unsafe { restart(path, position) };
    // SAFETY: the caller's promise.
    unsafe { report(result, why) }
}

/// # Safety
///
/// As [`slideway_path_restart`].
unsafe fn restart(path: *mut Path, position: *const f64) -> Result<(), Refused> {
    // SAFETY: the caller's promise.
    let head = unsafe { header(path.cast_const()) }?;
    with_sizes!(head.joints, head.constraints, N, M => {
        // SAFETY: living, of this size.
        let this = unsafe { value::<_, Loop<N, M>>(path) };
        this.state = if position.is_null() {
            this.conditioner.on_reference()
        } else {
            // SAFETY: the caller's promise.
            let position = unsafe { numbers::<N>(position) }?;
            this.conditioner.at_rest(&position)?
        };
        Ok(())
    })
}

/// One sample: from the reference at `time` (s), its position and velocity, to the conditioned reference.
///
/// A NaN or an infinity in the reference is no error: the last position is given out again, at rest, and `hold_reason` says why. If the
/// call fails the output, where it could be written, keeps its position, at rest, with the reason `CALL_FAILED`.
///
/// The constraints are evaluated once where none acts, and at most `SLIDEWAY_MAX_EVALUATIONS` times (implicit form, reserve, trap
/// avoidance); each time but the last few a system of as many equations as there are constraints is solved, in at most
/// `2^constraints * (constraints + 1)` steps, one for each acting constraint as a rule.
///
/// # Safety
///
/// `path` is null or an object of this kind that no other thread uses; `position` and `velocity` are null or point to as many numbers as
/// it has coordinates; `output` is null or points to an output that no callback reads or writes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_path_step(
    path: *mut Path,
    time: f64,
    position: *const f64,
    velocity: *const f64,
    output: *mut PathOutput,
) -> Status {
    // SAFETY: the caller's promise; the output is checked first.
    let run = || unsafe { step(path, time, position, velocity, output) };
    // SAFETY: the caller's promise.
    unsafe { deliver(output, run) }
}

/// # Safety
///
/// As [`slideway_path_step`], and the output may be written.
unsafe fn step(
    path: *mut Path,
    time: f64,
    position: *const f64,
    velocity: *const f64,
    output: *mut PathOutput,
) -> Result<(), Status> {
    // SAFETY: the caller's promise.
    let head = unsafe { header(path.cast_const()) }?;
    with_sizes!(head.joints, head.constraints, N, M => {
        // SAFETY: the caller's promise.
        let position = unsafe { numbers::<N>(position) }?;
        // SAFETY: the caller's promise.
        let velocity = unsafe { numbers::<N>(velocity) }?;
        // SAFETY: living.
        unsafe { set_busy(path, 1) };
        // SAFETY: living, of this size; while it is busy no other call gets a reference to its value.
        let this = unsafe { value::<_, Loop<N, M>>(path) };
        let decided = this.step(&Motion { time, position, velocity });
        // SAFETY: living.
        unsafe { set_busy(path, 0) };
        // SAFETY: checked by the caller; the inputs were copied.
        unsafe { &mut *output }.fill(&decided);
        Ok(())
    })
}
