//! The structured solver beside Clarabel on random programs with every kind of row; who answered is told.

mod support;

use slideway_baselines::time_optimal::{
    GAP_TOLERANCE, OptimumError, Solver, TimeOptimum, refine_optimum, time_optimum, time_optimum_by,
};
use slideway_path::{EndRate, LinearLimit, PathSample, SampledPath};
use support::every_kind::every_kind;
use support::{RandomSpline, one_piece, straight, violation_at_nodes};

/// Programs of the property; `PROGRAMS=1000` by hand.
fn programs() -> u64 {
    let by_hand = std::env::var("PROGRAMS").ok().and_then(|count| count.parse().ok());
    by_hand.unwrap_or(if cfg!(debug_assertions) { 63 } else { 189 })
}

fn by_structured_alone(optimum: &TimeOptimum) -> bool {
    optimum.is_certified() && optimum.attempts.iter().all(|attempt| attempt.solver == Solver::Structured)
}

#[test]
fn the_brackets_of_both_solvers_overlap_on_every_kind_of_program() {
    let (mut again, mut uncertified) = (0, 0);
    for seed in 0..programs() {
        let (kind, path) = every_kind(seed, 200, 0);
        let structured = time_optimum(&path).unwrap_or_else(|e| panic!("{seed} {kind:?}: {e}"));
        assert!(by_structured_alone(&structured), "{seed} {kind:?}: {:?}", structured.attempts);
        again += usize::from(structured.attempts.len() > 1);
        assert!(violation_at_nodes(&path, 0, &structured.pieces[0].b) <= 1e-9, "{seed} {kind:?}");
        // Clarabel may leave its bracket wide, or without an upper end; never apart from this one.
        match time_optimum_by(&path, Solver::Conic) {
            Ok(conic) => {
                uncertified += usize::from(!conic.is_certified());
                assert_eq!(conic.solvers, [Solver::Conic]);
                assert!(
                    structured.lower_s <= conic.upper_s && conic.lower_s <= structured.upper_s,
                    "{seed} {kind:?}: [{}, {}] and [{}, {}]",
                    structured.lower_s,
                    structured.upper_s,
                    conic.lower_s,
                    conic.upper_s
                );
            }
            Err(error) => {
                assert!(matches!(error, OptimumError::Unrepairable(_)), "{seed} {kind:?}: {error}");
                uncertified += 1;
            }
        }
    }
    println!("{} programs: {again} solved from inside, {uncertified} not certified by Clarabel", programs());
}

#[test]
fn a_dozen_steps_do_on_random_splines() {
    // Speed by its cause: a fault in a direction shows here before it shows in time.
    let mut steps: Vec<u32> = (0..40)
        .map(|seed| {
            let optimum = time_optimum(&RandomSpline::new(seed, 6).sample(300, 0)).expect("solvable");
            assert!(by_structured_alone(&optimum) && optimum.attempts.len() == 1, "{seed}: {:?}", optimum.attempts);
            optimum.iterations
        })
        .collect();
    steps.sort_unstable();
    assert!(steps[20] <= 13 && steps[39] <= 25, "{steps:?}");
}

#[test]
fn limits_between_the_nodes_are_kept_by_the_structured_solver_too() {
    for seed in [0, 8, 23, 30, 37, 44, 58] {
        let (kind, path) = every_kind(seed, 60, 3);
        let refined = refine_optimum(&path, 1e-6).unwrap_or_else(|e| panic!("{seed} {kind:?}: {e}"));
        assert!(by_structured_alone(&refined.result), "{seed} {kind:?}: {:?}", refined.result.attempts);
        assert!(refined.result.between.largest() <= 1e-6, "{seed} {kind:?}");
    }
}

#[test]
fn each_piece_names_its_solver_and_the_times_add_up() {
    let mut path = straight(1.0, 1.0, 1.0, 40);
    path.pieces.push(straight(1.0, 1.0, 1.0, 80).pieces[0].clone());
    path.pieces[0].end = EndRate::Given(0.5);
    path.pieces[1].start = EndRate::Given(0.5);
    for solver in [Solver::Structured, Solver::Conic] {
        let optimum = time_optimum_by(&path, solver).expect("solvable");
        assert!(optimum.gap() <= GAP_TOLERANCE);
        assert_eq!(optimum.solvers, [solver; 2]);
        assert_eq!(optimum.attempts.iter().map(|a| a.piece).collect::<Vec<_>>(), [0, 1]);
        assert_eq!(optimum.iterations, optimum.attempts.iter().map(|a| a.iterations).sum::<u32>());
        assert!(optimum.attempts.iter().all(|a| a.gap <= GAP_TOLERANCE && a.solver == solver));
    }
}

#[test]
fn under_speed_limits_alone_the_caps_are_the_answer() {
    let path = SampledPath { acceleration: None, ..straight(1.0, 0.5, 1.0, 20) };
    let optimum = time_optimum(&path).expect("solvable");
    // Twenty intervals, some ten outward roundings each.
    assert!(by_structured_alone(&optimum) && optimum.gap() <= 400.0 * f64::EPSILON, "{}", optimum.gap());
}

#[test]
fn a_row_of_one_node_alone_and_a_row_that_never_binds_are_no_trouble() {
    // Without inertia the row bounds b itself; the other has bounds far away and one that is infinite.
    let node = |k: u32| PathSample {
        s: f64::from(k) / 50.0,
        first: vec![1.0],
        second: vec![0.0],
        limits: vec![
            LinearLimit::joint_torque(0, [0.0, 1.0, 0.0], -1.0, 0.25),
            LinearLimit::joint_torque(0, [1.0, 0.0, 0.0], -2.0, f64::INFINITY),
        ],
        ..PathSample::default()
    };
    let mut path = straight(1.0, 10.0, 5.0, 50);
    path.pieces = vec![one_piece((0..=50).map(node).collect(), vec![])];
    let optimum = time_optimum(&path).expect("solvable");
    assert!(by_structured_alone(&optimum));
    assert!((optimum.pieces[0].b[25] - 0.25).abs() <= 1e-6);
}

#[test]
fn numbers_that_are_none_are_the_same_pointed_error_by_either_solver() {
    let path = straight(f64::NAN, 1.0, 1.0, 10);
    for solver in [Solver::Structured, Solver::Conic] {
        assert!(matches!(time_optimum_by(&path, solver), Err(OptimumError::NotFinite { piece: 0, node: 0 })));
    }
    let too_fast = |solver| {
        let mut path = straight(1.0, 10.0, 1.0, 50);
        path.pieces[0].start = EndRate::Given(3.0);
        time_optimum_by(&path, solver).expect_err("infeasible")
    };
    assert_eq!(too_fast(Solver::Structured), too_fast(Solver::Conic));
}
