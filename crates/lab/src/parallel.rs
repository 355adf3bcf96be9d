use rayon::prelude::*;
use std::num::NonZeroUsize;
use thiserror::Error;

/// The system gives no threads.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("cannot start {jobs} threads: {reason}")]
pub struct ThreadsError {
    /// Number of threads asked for.
    pub jobs: usize,
    /// Reason given by the system.
    pub reason: String,
}

impl ThreadsError {
    /// Remedy, in one sentence.
    #[must_use]
    pub fn remedy(&self) -> String {
        "ask for fewer with --jobs".into()
    }
}

/// Makes `one` of each item on `jobs` threads; the results in the order of the items.
///
/// Results do not depend on `jobs` as long as `one` is a function of its item alone. Each thread holds one item at a time.
///
/// # Errors
///
/// No threads, or what `one` reports first; items that were not begun by then are left out.
pub fn in_parallel<T: Sync, R: Send, E: From<ThreadsError> + Send>(
    items: &[T],
    jobs: NonZeroUsize,
    one: impl Fn(&T) -> Result<R, E> + Send + Sync,
) -> Result<Vec<R>, E> {
    let jobs = jobs.get().min(items.len().max(1));
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(jobs)
        .build()
        .map_err(|error| ThreadsError { jobs, reason: error.to_string() })?;
    // Pieces of one item: neighbours may differ in length by a hundred.
    pool.install(|| items.par_iter().with_max_len(1).map(one).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_in_the_order_of_the_items_for_any_number_of_jobs() {
        let items: Vec<u64> = (0..200).collect();
        for jobs in [1, 2, 7] {
            let jobs = NonZeroUsize::new(jobs).expect("positive");
            let found = in_parallel(&items, jobs, |&n| Ok::<_, ThreadsError>(n * n)).expect("threads");
            assert!(found.iter().zip(&items).all(|(f, n)| *f == n * n) && found.len() == items.len());
        }
    }

    #[test]
    fn an_error_of_one_item_ends_the_rest() {
        let wrong = || ThreadsError { jobs: 0, reason: "item 3".into() };
        let one = |&n: &i32| if n == 3 { Err(wrong()) } else { Ok(n) };
        assert_eq!(in_parallel(&[1, 2, 3, 4], NonZeroUsize::MIN, one), Err(wrong()));
    }
}
