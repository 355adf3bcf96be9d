use slideway_conditioner::acceleration::Preview as CorePreview;

use crate::acceleration::{Acceleration, Loop};
use crate::dispatch::with_joints;
use crate::memory::{check_pointer, header, read_in, sized, slice, slice_mut, value};
use crate::status::Status;

/// Joint speeds per unit of path rate on the path ahead, `dq / d lambda`, at equidistant nodes that are fixed to the path.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Preview {
    /// Size of this structure as the caller knows it: `sizeof(slideway_preview)`.
    pub size: u32,
    /// Number of nodes; fewer than two give a rate of 0. At the last one the robot must be able to stand.
    pub count: u32,
    /// Distance of the current path parameter beyond the first node, not negative.
    pub offset: f64,
    /// Distance of the nodes in the path parameter.
    pub spacing: f64,
    /// `count` rows of as many numbers as the regulator has joints, row after row. Only read during the call.
    pub path_speeds: *const f64,
}

sized!(Preview);

/// # Safety
///
/// `preview.path_speeds` is null or points to `preview.count` rows of `N` numbers that nobody writes while the result lives.
unsafe fn rows<'a, const N: usize>(preview: &Preview) -> Result<CorePreview<'a, N>, Status> {
    // SAFETY: the caller's promise; rows of `N` numbers lie one after the other as `[f64; N]` do.
    let path_speeds = unsafe { slice(preview.path_speeds.cast::<[f64; N]>(), preview.count as usize) }?;
    Ok(CorePreview { offset: preview.offset, spacing: preview.spacing, path_speeds })
}

/// The largest path rate, 1/s, from which the path can be followed to a stop inside the window ahead: the ceiling for
/// `slideway_acceleration_step`. `*rate` is 0 on failure and for a preview of no use.
///
/// At most one small linear program a stretch between two nodes (`8N + 8` Newton steps of `N` operations for N joints, two or three as
/// a rule), and 40 bisections. The state of the regulator plays no part and does not change.
///
/// # Safety
///
/// `acceleration` is null or an object of this kind that no other thread uses; `preview` is null or points to a preview whose rows are
/// there; `rate` is null or may be written.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_look_ahead_rate(
    acceleration: *const Acceleration,
    preview: *const Preview,
    rate: *mut f64,
) -> Status {
    // SAFETY: the caller's promise.
    let question = || unsafe { greatest_rate(acceleration, preview) };
    // SAFETY: the caller's promise.
    unsafe { answer(rate, question) }
}

/// Runs a question for a rate; 0 where it cannot be answered.
///
/// # Safety
///
/// `rate` is null or may be written.
unsafe fn answer(rate: *mut f64, question: impl FnOnce() -> Result<f64, Status>) -> Status {
    if let Err(status) = check_pointer(rate) {
        return status;
    }
    let found = question();
    // SAFETY: not null, aligned, writable.
    unsafe { rate.write(found.unwrap_or(0.0)) };
    found.err().unwrap_or(Status::Ok)
}

/// # Safety
///
/// As [`slideway_look_ahead_rate`].
unsafe fn greatest_rate(acceleration: *const Acceleration, preview: *const Preview) -> Result<f64, Status> {
    // SAFETY: the caller's promise.
    let head = unsafe { header(acceleration) }?;
    // SAFETY: the caller's promise.
    let preview = unsafe { read_in(preview) }?;
    with_joints!(head.joints, N => {
        // SAFETY: the caller's promise.
        let preview = unsafe { rows::<N>(&preview) }?;
        // SAFETY: living, of this number of joints; only read.
        let this = unsafe { value::<_, Loop<N>>(acceleration.cast_mut()) };
        Ok(this.look_ahead.greatest_rate(&preview))
    })
}

/// The greatest square of the path rate at each node from which the last one can be reached at rest, for a path that is known as a
/// whole: computed once, then `slideway_look_ahead_rate_within` gives the rate of `slideway_look_ahead_rate` at a fraction of the cost.
/// `preview.offset` plays no part.
///
/// `ranges` is `preview.count` numbers long. At most one small linear program a stretch between two nodes.
///
/// # Safety
///
/// As [`slideway_look_ahead_rate`]; `ranges` is null or points to `preview.count` writable numbers outside of the rows.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_look_ahead_ranges(
    acceleration: *const Acceleration,
    preview: *const Preview,
    ranges: *mut f64,
) -> Status {
    // SAFETY: the caller's promise.
    unsafe { fill_ranges(acceleration, preview, ranges) }.err().unwrap_or(Status::Ok)
}

/// # Safety
///
/// As [`slideway_look_ahead_ranges`].
unsafe fn fill_ranges(
    acceleration: *const Acceleration,
    preview: *const Preview,
    ranges: *mut f64,
) -> Result<(), Status> {
    // SAFETY: the caller's promise.
    let head = unsafe { header(acceleration) }?;
    // SAFETY: the caller's promise.
    let preview = unsafe { read_in(preview) }?;
    with_joints!(head.joints, N => {
        // SAFETY: the caller's promise.
        let rows = unsafe { rows::<N>(&preview) }?;
        // SAFETY: the caller's promise.
        let ranges = unsafe { slice_mut(ranges, rows.path_speeds.len()) }?;
        // SAFETY: living, of this number of joints; only read.
        let this = unsafe { value::<_, Loop<N>>(acceleration.cast_mut()) };
        this.look_ahead.ranges(rows.spacing, rows.path_speeds, ranges);
        Ok(())
    })
}

/// The rate of `slideway_look_ahead_rate`, to the last bit, from ranges that were computed before over the same nodes, or over a longer
/// path: then `preview` begins at a later node and `ranges` at the same one. `ranges` is `preview.count` numbers long.
///
/// At most 40 bisections and one test a node that one sample can reach.
///
/// # Safety
///
/// As [`slideway_look_ahead_rate`]; `ranges` is null or points to `preview.count` numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn slideway_look_ahead_rate_within(
    acceleration: *const Acceleration,
    preview: *const Preview,
    ranges: *const f64,
    rate: *mut f64,
) -> Status {
    // SAFETY: the caller's promise.
    let question = || unsafe { rate_within(acceleration, preview, ranges) };
    // SAFETY: the caller's promise.
    unsafe { answer(rate, question) }
}

/// # Safety
///
/// As [`slideway_look_ahead_rate_within`].
unsafe fn rate_within(
    acceleration: *const Acceleration,
    preview: *const Preview,
    ranges: *const f64,
) -> Result<f64, Status> {
    // SAFETY: the caller's promise.
    let head = unsafe { header(acceleration) }?;
    // SAFETY: the caller's promise.
    let preview = unsafe { read_in(preview) }?;
    with_joints!(head.joints, N => {
        // SAFETY: the caller's promise.
        let rows = unsafe { rows::<N>(&preview) }?;
        // SAFETY: the caller's promise.
        let ranges = unsafe { slice(ranges, rows.path_speeds.len()) }?;
        // SAFETY: living, of this number of joints; only read.
        let this = unsafe { value::<_, Loop<N>>(acceleration.cast_mut()) };
        Ok(this.look_ahead.greatest_rate_within(&rows, ranges))
    })
}
