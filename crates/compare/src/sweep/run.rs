use super::columns;
use super::row::SweepRow;
use slideway_lab::conditioning::{ConditionedTrace, PathMethodSummary, run_conditioner};
use slideway_lab::{Disturbances, MethodSummary, Subject, ThreadsError, in_parallel};
use slideway_path::ProblemError;
use std::num::NonZeroUsize;

/// Takes a row as soon as its run is finished, from any thread and in any order; an error ends the sweep.
pub type RowSink<'a, E> = dyn Fn(&SweepRow) -> Result<(), E> + Sync + 'a;

/// One run of a sweep.
#[derive(Clone, Debug)]
pub struct SweepRun {
    /// Its number.
    pub number: usize,
    /// Problem and method that are run.
    pub subject: Subject,
    /// Seed of the random walk and of the disturbances; the subject's own without it.
    pub seed: Option<u64>,
}

impl SweepRun {
    /// Runs it; the trace is dropped as soon as it is summarised.
    ///
    /// # Errors
    ///
    /// A subject that cannot be run.
    pub fn row(self) -> Result<SweepRow, ProblemError> {
        let Self { number: run, subject, seed } = self;
        match subject {
            Subject::Speed { mut experiment, method } => {
                if let Some(seed) = seed {
                    let disturbances = Disturbances { seed, ..experiment.disturbances().clone() };
                    *experiment = experiment.with_disturbances(&disturbances)?;
                }
                let summary = MethodSummary::new(&experiment.run(method)?);
                Ok(SweepRow { run, completed: summary.completed, broken: 0, values: columns::speed_values(&summary) })
            }
            Subject::Conditioning { mut problem, method } => {
                if let Some(seed) = seed {
                    problem.disturbances.seed = seed;
                    problem.trap.iter_mut().for_each(|trap| trap.seed = seed);
                }
                let trace = run_conditioner(&problem, method)?;
                let summary = PathMethodSummary::new(&problem, &trace, None, None);
                let values = columns::conditioning_values(&summary);
                Ok(SweepRow { run, completed: summary.completed, broken: broken(&trace), values })
            }
        }
    }
}

/// Makes the runs with the numbers `pending` on `jobs` threads and returns their rows in that order.
///
/// Rows do not depend on `jobs`: threads share nothing. Each holds one trace at a time. A sink that fails ends the sweep: so it is
/// cancelled, and so its progress is told.
///
/// # Errors
///
/// A run that cannot be made, or what the sink reports; the runs that were not begun by then are left out.
pub fn run_sweep<E: From<ThreadsError> + Send>(
    row_of: &(dyn Fn(usize) -> Result<SweepRow, E> + Sync),
    pending: &[usize],
    jobs: NonZeroUsize,
    sink: &RowSink<'_, E>,
) -> Result<Vec<SweepRow>, E> {
    let one = |&run: &usize| {
        let row = row_of(run)?;
        sink(&row)?;
        Ok(row)
    };
    in_parallel(pending, jobs, one)
}

/// Number of constraints that did not hold at every sample; a NaN does not hold.
fn broken(trace: &ConditionedTrace) -> usize {
    let holds = |i: usize| trace.samples.iter().all(|s| s.sigma[i] <= 0.0);
    (0..trace.constraints.len()).filter(|&i| !holds(i)).count()
}
