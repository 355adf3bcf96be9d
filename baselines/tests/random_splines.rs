//! Random joint splines of 6 and 7 joints: both solvers on the same rows.

mod support;

use slideway_baselines::time_optimal::{reachable_profile, refine_optimum, refine_profile, time_optimum};
use support::{RandomSpline, violation_at_nodes};

/// The whole set in an optimised build; a debug build checks a part of it.
const PATHS: u64 = if cfg!(debug_assertions) { 6 } else { 200 };

fn joints(seed: u64) -> usize {
    6 + usize::from(seed % 2 == 1)
}

#[test]
fn both_solvers_keep_the_limits_and_the_certificate_closes_on_every_path() {
    let (mut widest, mut furthest, mut exceeded) = (0.0_f64, 0.0_f64, f64::NEG_INFINITY);
    for seed in 0..PATHS {
        let path = RandomSpline::new(seed, joints(seed)).sample(1000, 0);
        let optimum = time_optimum(&path).expect("solvable");
        let greedy = reachable_profile(&path).expect("feasible");
        for profile in [&optimum.pieces[0].b, &greedy.pieces[0].b] {
            let violation = violation_at_nodes(&path, 0, profile);
            exceeded = exceeded.max(violation);
            assert!(violation <= 1e-9, "path {seed}: {violation}");
        }
        assert!(optimum.gap() <= 1e-5, "path {seed}: gap {}, {:?}", optimum.gap(), optimum.status);
        assert!(greedy.duration_s >= optimum.lower_s, "path {seed}");
        let above = greedy.duration_s / optimum.lower_s - 1.0;
        assert!(above <= 5e-4, "path {seed}: {above} above the lower bound");
        (widest, furthest) = (widest.max(optimum.gap()), furthest.max(above));
    }
    println!("{PATHS} paths: gap {widest:.1e}, greedy above the lower bound {furthest:.1e}, violation {exceeded:.1e}");
}

#[test]
fn the_greedy_profile_approaches_the_optimum_as_the_grid_gets_finer() {
    let grids = [125, 250, 500, 1000];
    let mut above = [0.0; 4];
    for seed in 0..6 {
        let spline = RandomSpline::new(seed, joints(seed));
        for (above, intervals) in above.iter_mut().zip(grids) {
            let path = spline.sample(intervals, 0);
            let greedy = reachable_profile(&path).expect("feasible").duration_s;
            *above += greedy / time_optimum(&path).expect("solvable").upper_s - 1.0;
        }
    }
    println!("mean share above the optimum on {grids:?}: {:?}", above.map(|a| a / 6.0));
    assert!(above.windows(2).all(|w| w[1] < w[0]), "{above:?}");
}

#[test]
fn refinement_keeps_the_limits_between_the_nodes_too() {
    for seed in 0..6 {
        let spline = RandomSpline::new(seed, joints(seed));
        let path = spline.sample(100, 7);
        let coarse = time_optimum(&path).expect("solvable");
        let greedy = reachable_profile(&path).expect("feasible");
        assert!(coarse.between.largest() > 1e-6 && greedy.between.largest() > 1e-6, "nothing to refine");
        let refined = refine_optimum(&path, 1e-6).expect("refinable");
        assert!(refined.result.between.largest() <= 1e-6);
        assert!(refined.result.gap() <= 1e-5, "gap {}", refined.result.gap());
        // More rows, so no faster than without them.
        assert!(refined.result.upper_s >= coarse.lower_s);
        let refined_greedy = refine_profile(&path, 1e-6).expect("refinable");
        assert!(refined_greedy.result.between.largest() <= 1e-6);
        assert!(refined_greedy.result.duration_s >= coarse.lower_s);
        println!(
            "path {seed}: {:.1e} between nodes, {} rounds, {} samples; greedy {:.1e}, {} rounds, {} samples",
            coarse.between.largest(),
            refined.rounds,
            refined.added,
            greedy.between.largest(),
            refined_greedy.rounds,
            refined_greedy.added,
        );
    }
}
