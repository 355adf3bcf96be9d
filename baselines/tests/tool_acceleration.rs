//! The tool's acceleration along random joint paths of two links: a certified optimum and a greedy profile wherever it binds.

mod support;

use proptest::prelude::*;
use slideway_baselines::time_optimal::{ROW_TOLERANCE, reachable_profile, time_optimum};
use slideway_path::{LinearLimit, PathSample, SampledPath};
use support::{RandomSpline, violation_at_nodes};

/// Pairs of sides of the polygon, as a scenario has them.
const PAIRS: usize = 16;

/// Lengths of the links, m.
const LINKS: [f64; 2] = [0.5, 0.4];

/// First and second derivative of the tool's position by `s` at joint angles `q`:
/// `p = Σ l_i (cos φ_i, sin φ_i)` with `φ_i = q_1 + .. + q_i`, so `p' = Σ l_i φ_i' (-sin, cos)` and
/// `p'' = Σ l_i (φ_i'' (-sin, cos) - φ_i'² (cos, sin))`.
fn tool_derivatives(q: &[f64], sample: &PathSample) -> [[f64; 3]; 2] {
    let (mut first, mut second) = ([0.0; 3], [0.0; 3]);
    let (mut angle, mut rate, mut bend) = (0.0, 0.0, 0.0);
    for (i, length) in LINKS.into_iter().enumerate() {
        (angle, rate, bend) = (angle + q[i], rate + sample.first[i], bend + sample.second[i]);
        let (sin, cos) = f64::sin_cos(angle);
        for (axis, [out, across]) in [[cos, -sin], [sin, cos]].into_iter().enumerate() {
            first[axis] += length * rate * across;
            second[axis] += length * (bend * across - rate * rate * out);
        }
    }
    [first, second]
}

/// A random spline of two joints whose tool's acceleration is limited, in m/s², under a speed limit common to both joints.
fn path(seed: u64, speed: f64, acceleration: f64, intervals: usize) -> SampledPath {
    let spline = RandomSpline { speed: vec![speed; 2], ..RandomSpline::new(seed, 2) };
    let mut path = SampledPath { acceleration: None, ..spline.sample(intervals, 0) };
    let mut q = vec![0.3, 0.9];
    let mut before: Option<PathSample> = None;
    for node in &mut path.pieces[0].nodes {
        // The trapezium of the rates: the joints need not be the spline's to the last digit, only close to each other.
        if let Some(before) = before.replace(node.clone()) {
            let half = 0.5 * (node.s - before.s);
            (0..2).for_each(|i| q[i] += half * (node.first[i] + before.first[i]));
        }
        let [first, second] = tool_derivatives(&q, node);
        node.limits = LinearLimit::tool_acceleration(first, second, acceleration, PAIRS);
    }
    path
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn where_the_tool_s_acceleration_binds_the_optimum_is_certified_and_the_greedy_profile_keeps_every_row(
        seed in any::<u64>(),
        speed in 1.0..4.0_f64,
        acceleration in (-1.5..0.7_f64).prop_map(|e| 10.0_f64.powf(e)),
        intervals in 100..300_usize,
    ) {
        let path = path(seed, speed, acceleration, intervals);
        let optimum = time_optimum(&path).map_err(|e| TestCaseError::fail(e.to_string()))?;
        prop_assert!(optimum.is_certified(), "gap {}, {:?}", optimum.gap(), optimum.status);
        // It binds: without it the same path is faster.
        prop_assert!(time_optimum(&path.under_speed_limits_alone()).is_ok_and(|free| free.upper_s < optimum.lower_s));
        let greedy = reachable_profile(&path).map_err(|e| TestCaseError::fail(e.to_string()))?;
        prop_assert!(greedy.largest_excess <= ROW_TOLERANCE && greedy.duration_s >= optimum.lower_s);
        for profile in [&optimum.pieces[0].b, &greedy.pieces[0].b] {
            let violation = violation_at_nodes(&path, 0, profile);
            prop_assert!(violation <= ROW_TOLERANCE, "{violation}");
        }
    }

    #[test]
    fn rows_that_weigh_the_acceleration_next_to_nothing_change_no_optimum(
        seed in any::<u64>(),
        acceleration in (-1.5..0.7_f64).prop_map(|e| 10.0_f64.powf(e)),
        weight in (-320.0..-13.0_f64).prop_map(|e| 10.0_f64.powf(e)),
    ) {
        let exact = path(seed, 2.0, acceleration, 150);
        // As a user's own rows might have it: noise where a zero is meant.
        let mut noisy = exact.clone();
        for limit in noisy.pieces[0].nodes.iter_mut().flat_map(|node| &mut node.limits) {
            limit.acceleration += if limit.acceleration == 0.0 { weight } else { 0.0 };
        }
        let [exact, other] = [&exact, &noisy].map(time_optimum);
        let (exact, other) = (exact.expect("solvable"), other.map_err(|e| TestCaseError::fail(e.to_string()))?);
        prop_assert!(other.is_certified(), "gap {}, {:?}", other.gap(), other.status);
        // Both intervals contain their optimum, and the optima differ by the noise alone.
        prop_assert!(other.lower_s <= exact.upper_s * (1.0 + 1e-9) && exact.lower_s <= other.upper_s * (1.0 + 1e-9));
        let greedy = reachable_profile(&noisy).map_err(|e| TestCaseError::fail(e.to_string()))?;
        prop_assert!(greedy.largest_excess <= ROW_TOLERANCE);
    }
}
