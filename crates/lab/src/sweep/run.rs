use super::error::SweepError;
use super::plan::SweepPlan;
use super::row::SweepRow;
use rayon::prelude::*;
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
pub fn run_sweep<E: From<SweepError> + Send>(
    plan: &SweepPlan,
    pending: &[usize],
    jobs: NonZeroUsize,
    sink: &RowSink<'_, E>,
) -> Result<Vec<SweepRow>, E> {
    let jobs = jobs.get().min(pending.len().max(1));
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(jobs)
        .build()
        .map_err(|error| SweepError::Threads { jobs, reason: error.to_string() })?;
    let one = |&run: &usize| {
        let row = plan.run(run)?;
        sink(&row)?;
        Ok(row)
    };
    // Pieces of one run: neighbouring runs may differ in length by a hundred.
    pool.install(|| pending.par_iter().with_max_len(1).map(one).collect())
}
