use super::error::SweepError;
use super::plan::SweepPlan;
use super::row::SweepRow;
use slideway_lab::{ThreadsError, in_parallel};
use std::num::NonZeroUsize;

/// Takes a row as soon as its run is finished, from any thread and in any order; an error ends the sweep.
pub type RowSink<'a, E> = dyn Fn(&SweepRow) -> Result<(), E> + Sync + 'a;

/// Makes the runs that are `pending` on `jobs` threads and returns their rows in the order of `pending`.
///
/// Rows do not depend on `jobs`: a run is a function of the plan and its number, and threads share nothing. Each thread
/// holds one trace at a time.
///
/// # Errors
///
/// A run that cannot be made, or what the sink reports; the runs that were not begun by then are left out.
pub fn run_sweep<E: From<SweepError> + From<ThreadsError> + Send>(
    plan: &SweepPlan,
    pending: &[usize],
    jobs: NonZeroUsize,
    sink: &RowSink<'_, E>,
) -> Result<Vec<SweepRow>, E> {
    let one = |&run: &usize| {
        let row = plan.run(run)?;
        sink(&row)?;
        Ok(row)
    };
    in_parallel(pending, jobs, one)
}
