//! The bracket of the path's time optimum against closed forms, another program's brackets, and itself.

#[path = "support/bracket_paths.rs"]
mod bracket_paths;
#[path = "support/numbers.rs"]
mod numbers;

use bracket_paths::{Cubics, blended, stored};
use numbers::Numbers;
use slideway_baselines::path_bracket::{
    BracketError, BracketOptions, End, JointLimits, JointPath, JointPathProblem, PathBracket, StopReason,
};

const REST: [End; 2] = [End::Rest, End::Rest];
const NONE: f64 = f64::INFINITY;

fn options(gap: f64) -> BracketOptions {
    BracketOptions { gap, ..BracketOptions::default() }
}

fn bracket(path: JointPath, limits: JointLimits, ends: [End; 2], gap: f64) -> PathBracket {
    let problem = JointPathProblem::new(path, limits, ends).expect("a problem");
    PathBracket::solve(&problem, &options(gap)).expect("a bracket")
}

/// The time is between the bounds and these are as close as asked; the time itself is known to a few units in the last place.
fn assert_brackets(bracket: &PathBracket, time: f64) {
    let slack = 1e-14 * time;
    assert!(
        bracket.certified && bracket.stop == StopReason::GapReached,
        "{} cells, gap {}",
        bracket.cells,
        bracket.gap
    );
    assert!(bracket.lower_s <= time + slack, "lower {} above {time}", bracket.lower_s);
    assert!(bracket.upper_s >= time - slack, "upper {} below {time}", bracket.upper_s);
    // Summed in plain arithmetic over the cells.
    assert!(
        bracket.profile.duration_s() <= bracket.upper_s * (1.0 + 1e-12),
        "profile {}",
        bracket.profile.duration_s()
    );
}

/// Rest to rest over a distance with acceleration `u`, braking `d` and speed `v`.
fn trapezoid(distance: f64, u: f64, d: f64, v: f64) -> f64 {
    let peak = (2.0 * distance / (1.0 / u + 1.0 / d)).sqrt();
    if peak <= v { (2.0 * distance * (1.0 / u + 1.0 / d)).sqrt() } else { distance / v + v / (2.0 * u) + v / (2.0 * d) }
}

fn limits(speed: f64, lower: f64, upper: f64) -> JointLimits {
    JointLimits::new(vec![speed], vec![lower], vec![upper]).expect("limits")
}

/// One joint, monotone, with uneven speed of `q`.
fn monotone() -> Cubics {
    let values: Vec<Vec<f64>> = [0.0, 0.3, 0.9, 1.4, 2.0].map(|q| vec![q]).to_vec();
    let slopes: Vec<Vec<f64>> = [0.8, 1.9, 2.2, 2.3, 1.1].map(|q| vec![q]).to_vec();
    Cubics::hermite(&[0.0, 0.2, 0.5, 0.7, 1.0], &values, &slopes)
}

/// One joint that turns at 1 and at 0.2.
fn turning() -> Cubics {
    let values: Vec<Vec<f64>> = [0.0, 1.0, 0.2, 0.9].map(|q| vec![q]).to_vec();
    let slopes: Vec<Vec<f64>> = [1.5, 0.0, 0.0, 2.0].map(|q| vec![q]).to_vec();
    Cubics::hermite(&[0.0, 0.5, 1.0, 1.4], &values, &slopes)
}

#[test]
fn a_line_from_rest_to_rest_takes_the_trapezoids_time() {
    let line = || JointPath::lines(vec![0.0, 1.0], &[vec![0.0, 0.0], vec![1.0, 1.0]]).expect("a line");
    let limits = JointLimits::symmetric(vec![0.1; 2], vec![100.0; 2]).expect("limits");
    for gap in [1e-4, 1e-6] {
        assert_brackets(&bracket(line(), limits.clone(), REST, gap), 10.001);
    }
}

#[test]
fn the_time_of_one_monotone_joint_does_not_depend_on_the_parameter() {
    for (v, lower, upper) in [(NONE, -3.0, 3.0), (NONE, -5.0, 3.0), (1.0, -5.0, 3.0)] {
        let time = trapezoid(2.0, upper, -lower, v);
        for gap in [1e-4, 1e-6] {
            assert_brackets(&bracket(monotone().path(), limits(v, lower, upper), REST, gap), time);
        }
    }
}

#[test]
fn a_joint_that_turns_rests_between_its_monotone_parts() {
    for (v, lower, upper) in [(NONE, -3.0, 3.0), (NONE, -5.0, 3.0), (0.9, -5.0, 3.0)] {
        let forth = |d: f64| trapezoid(d, upper, -lower, v);
        // On the way back the limits change roles.
        let time = forth(1.0) + trapezoid(0.8, -lower, upper, v) + forth(0.7);
        assert_brackets(&bracket(turning().path(), limits(v, lower, upper), REST, 1e-5), time);
    }
}

#[test]
fn of_two_proportional_joints_the_tighter_one_counts() {
    let mut path = monotone();
    for segment in &mut path.segments {
        let half = segment[0].iter().map(|c| 0.5 * c).collect();
        segment.push(half);
    }
    let limits = JointLimits::symmetric(vec![NONE; 2], vec![9.0, 1.0]).expect("limits");
    assert_brackets(&bracket(path.path(), limits, REST, 1e-5), trapezoid(1.0, 1.0, 1.0, NONE));
}

#[test]
fn under_a_speed_limit_alone_the_time_is_the_total_variation_to_the_last_places() {
    for (path, way) in [(monotone(), 2.0), (turning(), 2.5)] {
        let b = bracket(path.path(), limits(0.5, -NONE, NONE), REST, 1e-12);
        assert_brackets(&b, way / 0.5);
    }
}

#[test]
fn slower_joints_in_turn_take_the_integral_of_the_greatest_slowness() {
    // q1' = s, q2' = 1 - s on [0, 1], both with speed 1: the integral of max(s, 1 - s) is 3/4.
    let path = JointPath::new(vec![0.0, 1.0], vec![vec![vec![0.0, 0.0, 0.5], vec![0.0, 1.0, -0.5]]]).expect("a path");
    let limits = JointLimits::new(vec![1.0; 2], vec![-NONE; 2], vec![NONE; 2]).expect("limits");
    assert_brackets(&bracket(path, limits, REST, 1e-9), 0.75);
}

#[test]
fn free_ends_start_and_end_at_the_speed_limit() {
    let b = bracket(monotone().path(), limits(0.7, -5.0, 3.0), [End::Free; 2], 1e-6);
    assert_brackets(&b, 2.0 / 0.7);
    // From rest to free: accelerate to v, then go on.
    let b = bracket(monotone().path(), limits(0.7, -5.0, 3.0), [End::Rest, End::Free], 1e-6);
    assert_brackets(&b, 2.0 / 0.7 + 0.7 / 6.0);
}

#[test]
fn parabolic_blends_are_passed_as_fast_as_their_bend_allows() {
    // Four lines of 0.5 with blends of half-width w: 4 √2 - 3 √(2 w), from √(2 w) at the blends and bang-bang between.
    let points = [[0.0, 0.0], [0.5, 0.0], [0.5, 0.5], [1.0, 0.5], [1.0, 0.0]];
    let limits = JointLimits::symmetric(vec![10.0; 2], vec![1.0; 2]).expect("limits");
    for (half, printed) in [(0.01_f64, 5.232_590), (0.001, 5.522_690)] {
        let time = 4.0 * 2.0_f64.sqrt() - 3.0 * (2.0 * half).sqrt();
        assert!((time - printed).abs() < 1e-6);
        assert_brackets(&bracket(blended(&points, half), limits.clone(), REST, 1e-5), time);
    }
}

#[test]
fn at_corners_of_lines_the_robot_rests() {
    let points = [vec![0.0, 0.0], vec![1.0, 0.0], vec![1.0, 0.5], vec![0.0, 0.5]];
    let path = JointPath::lines(vec![0.0, 1.0, 1.5, 2.5], &points).expect("lines");
    let limits = JointLimits::symmetric(vec![1.0, 2.0], vec![3.0, 4.0]).expect("limits");
    let time = 2.0 * trapezoid(1.0, 3.0, 3.0, 1.0) + trapezoid(0.5, 4.0, 4.0, 2.0);
    assert_brackets(&bracket(path, limits, REST, 1e-6), time);
}

#[test]
fn a_corner_of_a_joint_without_acceleration_limits_is_no_rest() {
    // The first joint goes straight on; the second turns back at s = 1 and has a speed limit alone.
    let path = JointPath::lines(vec![0.0, 1.0, 2.0], &[vec![0.0, 0.0], vec![1.0, 0.5], vec![2.0, 0.0]]).expect("lines");
    let limits = JointLimits::new(vec![1.0, 1.0], vec![-2.0, -NONE], vec![2.0, NONE]).expect("limits");
    assert_brackets(&bracket(path, limits, REST, 1e-6), trapezoid(2.0, 2.0, 2.0, 1.0));
}

#[test]
fn a_path_with_its_own_rest_parameter_and_one_without_have_the_same_time() {
    // q = 3 s² - 2 s³: q' = 0 at both ends already.
    let clamped = JointPath::new(vec![0.0, 1.0], vec![vec![vec![0.0, 0.0, 3.0, -2.0]]]).expect("a path");
    assert_brackets(&bracket(clamped, limits(NONE, -2.0, 1.0), REST, 1e-6), trapezoid(1.0, 1.0, 2.0, NONE));
}

#[test]
fn degree_five_is_bracketed_like_degree_three() {
    // Monotone: q' = 1 + 4 s³ - 5 s⁴ + ... kept positive on [0, 1].
    let quintic = JointPath::new(vec![0.0, 1.0], vec![vec![vec![0.0, 1.0, 0.5, -0.3, 1.0, -0.7]]]).expect("a path");
    assert_brackets(&bracket(quintic, limits(0.8, -2.0, 1.0), REST, 1e-5), trapezoid(1.5, 1.0, 2.0, 0.8));
}

/// Lower bound, upper bound of another program: see `data/README.md`.
const OTHERS: [[f64; 2]; 10] = [
    [10.669333658334443, 10.669335480528106],
    [3.7768101765492537, 3.7768106262943633],
    [5.619629182825755, 5.619631982213159],
    [10.72383270794569, 10.723837891583145],
    [11.78670438211134, 11.786707042180211],
    [8.256922501474765, 8.256938856693973],
    [8.774468390785215, 8.774469447279337],
    [4.802808521496138, 4.802809084773877],
    [12.216977041798907, 12.216977681542469],
    [13.426913406184973, 13.426917587112072],
];

#[test]
fn brackets_of_the_ten_splines_overlap_another_programs_at_every_target() {
    let paths = stored(include_str!("data/ten-splines.txt"));
    assert_eq!(paths.len(), OTHERS.len());
    for (path, other) in paths.iter().zip(OTHERS) {
        let mut bounds = [0.0, NONE];
        for gap in [1e-4, 1e-5, 1e-6] {
            let b = PathBracket::solve(&path.problem, &options(gap)).expect("a bracket");
            println!(
                "{} gap {gap:e}: [{}, {}] with {} cells in {} rounds",
                path.name, b.lower_s, b.upper_s, b.cells, b.rounds
            );
            assert!(b.certified && b.gap <= gap && b.lower_s <= b.upper_s, "{}: gap {}", path.name, b.gap);
            assert!(b.lower_s <= other[1] && b.upper_s >= other[0], "{}: apart from the other program", path.name);
            bounds = [bounds[0].max(b.lower_s), bounds[1].min(b.upper_s)];
        }
        assert!(bounds[0] <= bounds[1], "{}: brackets of three targets are apart", path.name);
    }
}

/// Every fifth problem has acceleration limits alone.
fn has_no_speed_limit(seed: u64) -> bool {
    seed % 5 == 4
}

/// A random problem of 1 to 7 joints.
fn random(seed: u64) -> (Cubics, JointLimits, JointLimits) {
    let mut numbers = Numbers::new(seed);
    let joints = 1 + (seed % 7) as usize;
    let path = Cubics::random(&mut numbers, joints, 3 + (seed % 3) as usize);
    let mut list = |low: f64, high: f64| (0..joints).map(|_| numbers.between(low, high)).collect::<Vec<f64>>();
    let speed = if has_no_speed_limit(seed) { vec![NONE; joints] } else { list(0.5, 3.0) };
    let (upper, lower) = (list(1.0, 8.0), list(-8.0, -1.0));
    let swapped =
        JointLimits::new(speed.clone(), upper.iter().map(|u| -u).collect(), lower.iter().map(|l| -l).collect());
    (path, JointLimits::new(speed, lower, upper).expect("limits"), swapped.expect("limits"))
}

/// Problems of the set in an optimised build; a debug build checks a part of it.
const RANDOM: u64 = if cfg!(debug_assertions) { 6 } else { 40 };

#[test]
fn the_bracket_is_the_same_for_the_reversed_path_other_parameters_and_other_units() {
    for seed in 0..RANDOM {
        let (path, limits, _) = random(seed);
        let first = bracket(path.path(), limits.clone(), REST, 1e-5);
        assert!(first.certified, "seed {seed}: {:?} with gap {}", first.stop, first.gap);
        // Backwards the time runs the other way: speeds change sign, accelerations do not.
        let back = bracket(path.reversed().path(), limits.clone(), REST, 1e-5);
        let affine = bracket(path.rescaled(3.0, 40.0, 1.0).path(), limits.clone(), REST, 1e-5);
        for (name, other) in [("reversed", &back), ("affine", &affine)] {
            assert!(other.certified, "seed {seed}, {name}: {:?}", other.stop);
            assert!(other.lower_s <= first.upper_s && first.lower_s <= other.upper_s, "seed {seed}, {name}");
        }
    }
}

#[test]
fn other_units_of_the_joints_change_nothing_but_rounding() {
    for seed in 0..RANDOM / 4 {
        let (path, _, _) = random(seed);
        let joints = path.segments[0].len();
        let unit = |u: f64| JointLimits::symmetric(vec![1.5 * u; joints], vec![4.0 * u; joints]).expect("limits");
        let first = bracket(path.path(), unit(1.0), REST, 1e-5);
        // A power of two: every number is the same but for its exponent.
        let scaled = bracket(path.rescaled(0.0, 1.0, 1024.0).path(), unit(1024.0), REST, 1e-5);
        assert_eq!((first.lower_s, first.upper_s, first.cells), (scaled.lower_s, scaled.upper_s, scaled.cells));
        let odd = bracket(path.rescaled(0.0, 1.0, 1e3).path(), unit(1e3), REST, 1e-5);
        assert!(odd.lower_s <= first.upper_s && first.lower_s <= odd.upper_s);
    }
}

#[test]
fn a_mirrored_path_with_swapped_limits_has_the_same_bracket() {
    for seed in 0..RANDOM / 4 {
        let (path, limits, swapped) = random(seed);
        let first = bracket(path.path(), limits, REST, 1e-5);
        let mirrored = bracket(path.rescaled(0.0, 1.0, -1.0).path(), swapped, REST, 1e-5);
        assert!(first.certified && mirrored.certified);
        assert!(mirrored.lower_s <= first.upper_s && first.lower_s <= mirrored.upper_s);
    }
}

#[test]
fn profiles_keep_every_limit_at_dense_samples_and_end_where_the_path_does() {
    for seed in 0..RANDOM / 2 {
        let (path, limits, _) = random(seed);
        let (speed, lower, upper) = limit_lists(seed);
        let b = bracket(path.path(), limits, REST, 1e-4);
        assert!(b.certified, "seed {seed}");
        let samples = 4001;
        let mut last = f64::NEG_INFINITY;
        for k in 0..samples {
            let time = b.profile.duration_s() * k as f64 / (samples - 1) as f64;
            let state = b.profile.at_time(time);
            assert!(state.s >= last, "seed {seed}: backwards at {time}");
            last = state.s;
            for (j, [first, second]) in path.derivatives(state.s).into_iter().enumerate() {
                let (q_dot, q_ddot) = (first * state.s_dot, first * state.s_ddot + second * state.s_dot * state.s_dot);
                // Plain arithmetic; at knots the sample may see the bend of the wrong side, which the search for the place moves by rounding only.
                assert!(
                    q_dot.abs() <= speed[j] * (1.0 + 1e-9),
                    "seed {seed}, joint {j}: speed {q_dot} at s = {}",
                    state.s
                );
                let slack = 1e-9 * (upper[j] - lower[j]);
                let inside = q_ddot <= upper[j] + slack && q_ddot >= lower[j] - slack;
                assert!(inside, "seed {seed}, joint {j}: acceleration {q_ddot} at s = {}", state.s);
            }
        }
        let (start, end) = (b.profile.at_time(0.0), b.profile.at_time(f64::INFINITY));
        assert!(start.s_dot == 0.0 && end.s_dot.abs() < 1e-6);
        assert!((end.s - path.knots[path.knots.len() - 1]).abs() < 1e-9);
    }
}

/// The limits of [`random`] again, as lists.
fn limit_lists(seed: u64) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
    let mut numbers = Numbers::new(seed);
    let joints = 1 + (seed % 7) as usize;
    let _ = Cubics::random(&mut numbers, joints, 3 + (seed % 3) as usize);
    let mut list = |low: f64, high: f64| (0..joints).map(|_| numbers.between(low, high)).collect::<Vec<f64>>();
    let speed = if has_no_speed_limit(seed) { vec![NONE; joints] } else { list(0.5, 3.0) };
    let (upper, lower) = (list(1.0, 8.0), list(-8.0, -1.0));
    (speed, lower, upper)
}

#[test]
fn a_bracket_that_may_not_refine_is_honest() {
    let (path, limits, _) = random(3);
    let problem = JointPathProblem::new(path.path(), limits, REST).expect("a problem");
    let few = BracketOptions { gap: 1e-9, cells: 200, ..BracketOptions::default() };
    let b = PathBracket::solve(&problem, &few).expect("a bracket");
    assert!(!b.certified && b.stop == StopReason::CellsSpent && b.cells <= 200);
    assert!(0.0 < b.lower_s && b.lower_s < b.upper_s && b.gap > 1e-9);
    let fine = PathBracket::solve(&problem, &options(1e-6)).expect("a bracket");
    assert!(b.lower_s <= fine.upper_s && fine.lower_s <= b.upper_s);
    assert!(!b.worst.is_empty() && b.worst.windows(2).all(|w| w[0].gap_s >= w[1].gap_s));
}

#[test]
fn what_is_no_path_or_no_limit_is_refused_with_its_place() {
    let line = |c: Vec<f64>| JointPath::new(vec![0.0, 1.0], vec![vec![c]]);
    assert_eq!(line(vec![0.0, f64::NAN]), Err(BracketError::NotFinite { segment: 0, joint: 0 }));
    assert_eq!(line(vec![]), Err(BracketError::Degree { segment: 0, joint: 0, given: 0 }));
    assert_eq!(line(vec![0.0; 7]), Err(BracketError::Degree { segment: 0, joint: 0, given: 7 }));
    let two = |a: Vec<f64>, b: Vec<f64>, knots: Vec<f64>| JointPath::new(knots, vec![vec![a], vec![b]]);
    assert_eq!(
        two(vec![0.0, 1.0], vec![1.5, 1.0], vec![0.0, 1.0, 2.0]),
        Err(BracketError::Jump { joint: 0, s: 1.0, jump: 0.5 })
    );
    assert_eq!(two(vec![0.0, 1.0], vec![1.0, 1.0], vec![0.0, 1.0, 1.0]), Err(BracketError::Knot { knot: 2 }));
    assert_eq!(two(vec![0.0, 1.0], vec![1.0, 1.0], vec![0.0, f64::NAN, 2.0]), Err(BracketError::Knot { knot: 1 }));
    for (v, lower, upper) in
        [(0.0, -1.0, 1.0), (1.0, 1.0, 1.0), (1.0, -1.0, f64::NAN), (f64::NAN, -1.0, 1.0), (1.0, -NONE, 1.0)]
    {
        assert_eq!(JointLimits::new(vec![v], vec![lower], vec![upper]), Err(BracketError::Limit { joint: 0 }));
    }
    assert_eq!(line(vec![0.0, 1e40]), Err(BracketError::Size { segment: 0 }));
    let still = two(vec![0.0, 1.0], vec![1.0], vec![0.0, 1.0, 2.0]).expect("a path");
    assert_eq!(
        JointPathProblem::new(still, limits(1.0, -1.0, 1.0), REST),
        Err(BracketError::Still { from: 1.0, to: 2.0 })
    );
    let free = line(vec![0.0, 1.0]).expect("a path");
    assert_eq!(JointPathProblem::new(free, limits(NONE, -1.0, 1.0), [End::Free; 2]), Err(BracketError::FreeEnd));
}

#[test]
fn a_path_that_stands_without_turning_back_is_refused_with_its_place() {
    let solve = |path: JointPath| {
        let problem = JointPathProblem::new(path, limits(1.0, -1.0, 1.0), REST).expect("a problem");
        PathBracket::solve(&problem, &options(1e-4))
    };
    // q' = 3 (s - 0.3)².
    let inside = JointPath::new(vec![0.0, 1.0], vec![vec![vec![0.0, 0.27, -0.9, 1.0]]]).expect("a path");
    let Err(BracketError::Stall { s }) = solve(inside) else { panic!("not refused") };
    assert!((s - 0.3).abs() < 1e-6, "{s}");
    // q = s³ from rest.
    let end = JointPath::new(vec![0.0, 1.0], vec![vec![vec![0.0, 0.0, 0.0, 1.0]]]).expect("a path");
    assert_eq!(solve(end), Err(BracketError::Stall { s: 0.0 }));
    // Under speed limits alone a stall costs nothing.
    let inside = JointPath::new(vec![0.0, 1.0], vec![vec![vec![0.0, 0.27, -0.9, 1.0]]]).expect("a path");
    assert_brackets(&bracket(inside, limits(0.5, -NONE, NONE), REST, 1e-6), 0.37 / 0.5);
}

#[test]
fn options_out_of_range_are_refused() {
    let (path, limits, _) = random(1);
    let problem = JointPathProblem::new(path.path(), limits, REST).expect("a problem");
    for options in [
        BracketOptions { gap: f64::NAN, ..BracketOptions::default() },
        BracketOptions { gap: 0.0, ..BracketOptions::default() },
        BracketOptions { cells: 3, ..BracketOptions::default() },
    ] {
        assert!(matches!(PathBracket::solve(&problem, &options), Err(BracketError::Option { .. })));
    }
}
