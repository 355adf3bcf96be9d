//! Counts of random programs with every kind of row that the structured solver certifies, and the steps that it takes:
//!
//! ```text
//! cargo run --release -p slideway-baselines --example robustness -- COUNT INTERVALS [FIRST]
//! ```
//!
//! Exit status 1 if any program was left without a certificate by the structured solver alone.

#[path = "../tests/support/mod.rs"]
mod support;

use slideway_baselines::time_optimal::{GAP_TOLERANCE, Solver, TimeOptimum, time_optimum};
use std::collections::BTreeMap;
use std::process::ExitCode;
use support::every_kind::every_kind;

/// The counts of one kind of program.
#[derive(Default)]
struct Counts {
    programs: usize,
    /// Certified by the first run, by the one with further correctors, by Clarabel, by none.
    by: [usize; 4],
    /// No profile, or no repair: a pointed error.
    errors: usize,
    steps: Vec<u32>,
    widest: f64,
}

fn main() -> ExitCode {
    let arguments: Vec<u64> = std::env::args().skip(1).filter_map(|a| a.parse().ok()).collect();
    let [count, intervals, first] = [0, 1, 2].map(|i| arguments.get(i).copied());
    let (count, intervals, first) = (count.unwrap_or(200), intervals.unwrap_or(1000) as usize, first.unwrap_or(0));
    let mut kinds: BTreeMap<String, Counts> = BTreeMap::new();
    for seed in first..first + count {
        let (kind, path) = every_kind(seed, intervals, 0);
        let counts = kinds.entry(format!("{kind:?}")).or_default();
        counts.programs += 1;
        match time_optimum(&path) {
            Ok(optimum) => counts.take(&optimum, &format!("{seed} {kind:?}")),
            Err(error) => {
                println!("{seed} {kind:?}: {error}");
                counts.errors += 1;
            }
        }
    }
    report(&mut kinds)
}

impl Counts {
    fn take(&mut self, optimum: &TimeOptimum, name: &str) {
        let last = &optimum.attempts[optimum.attempts.len() - 1];
        let place = match last.solver {
            _ if !(last.gap <= GAP_TOLERANCE) => 3,
            Solver::Conic => 2,
            Solver::Structured => optimum.attempts.len() - 1,
        };
        self.by[place] += 1;
        if place > 0 {
            println!("{name}: {:?}", optimum.attempts);
        }
        self.steps.push(optimum.attempts[0].iterations);
        self.widest = self.widest.max(optimum.gap());
    }
}

fn report(kinds: &mut BTreeMap<String, Counts>) -> ExitCode {
    let mut left = 0;
    println!(
        "kind: programs, errors, certified at once, with correctors, by Clarabel, by none; steps median, most; widest gap"
    );
    for (kind, counts) in kinds {
        counts.steps.sort_unstable();
        let [once, correctors, conic, none] = counts.by;
        left += conic + none;
        let (middle, most) = (counts.steps.get(counts.steps.len() / 2), counts.steps.last());
        println!(
            "{kind}: {}, {}, {once}, {correctors}, {conic}, {none}; {}, {}; {:.1e}",
            counts.programs,
            counts.errors,
            middle.unwrap_or(&0),
            most.unwrap_or(&0),
            counts.widest
        );
    }
    if left == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
