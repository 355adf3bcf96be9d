//! Times of the certified optimum by both solvers and of the greedy sweep over random splines of 1 to 7 joints, in one run:
//!
//! ```text
//! cargo run --release -p slideway-baselines --example solver_ratios -- [SPLINES]
//! ```
//!
//! Each time is the least of several runs, certificate included; a ratio is taken spline by spline and the median is shown.

#[path = "../tests/support/mod.rs"]
mod support;

use slideway_baselines::time_optimal::{Solver, reachable_profile, time_optimum_by};
use slideway_path::SampledPath;
use std::hint::black_box;
use std::time::Instant;
use support::RandomSpline;

fn least(runs: u32, mut work: impl FnMut()) -> f64 {
    let timed = |work: &mut dyn FnMut()| {
        let begin = Instant::now();
        work();
        begin.elapsed().as_secs_f64()
    };
    (0..runs).map(|_| timed(&mut work)).fold(f64::INFINITY, f64::min)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn optimum(runs: u32, path: &SampledPath, solver: Solver) -> f64 {
    least(runs, || drop(black_box(time_optimum_by(black_box(path), solver))))
}

fn main() {
    let splines = std::env::args().nth(1).and_then(|a| a.parse().ok()).unwrap_or(60);
    let path = |seed: u64, intervals| RandomSpline::new(seed, 1 + (seed % 7) as usize).sample(intervals, 0);
    for (intervals, runs) in [(100, 30), (1000, 10), (10_000, 3), (100_000, 1)] {
        let count = if intervals > 1000 { 7 } else { splines };
        let (mut structured, mut of_conic, mut of_sweep) = (Vec::new(), Vec::new(), Vec::new());
        for seed in 0..count {
            let path = path(seed, intervals);
            let ours = optimum(runs, &path, Solver::Structured);
            let sweep = least(runs, || drop(black_box(reachable_profile(black_box(&path)))));
            structured.push(1e3 * ours);
            of_sweep.push(ours / sweep);
            if intervals <= 1000 {
                of_conic.push(optimum(runs.min(2), &path, Solver::Conic) / ours);
            }
        }
        let conic = if of_conic.is_empty() { "not run".into() } else { format!("{:.1}", median(of_conic)) };
        println!(
            "{intervals} intervals, {count} splines: structured {:.3} ms, conic over structured {conic}, structured over sweep {:.2}",
            median(structured),
            median(of_sweep)
        );
    }
}
