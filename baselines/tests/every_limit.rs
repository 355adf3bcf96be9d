//! Torque, tool limits, asymmetric and varying limits, given rates at the ends, and what is said where nothing is feasible.

mod support;

use slideway_baselines::time_optimal::{
    OptimumError, TimeOptimum, needed_widening, reachable_profile, refine_optimum, time_optimum,
};
use slideway_path::{EndRate, LimitKind, LinearLimit, PathSample, SampledPath, SpeedLimit};
use support::{RandomSpline, straight, violation_at_nodes};

/// A straight motion of one joint with `s` in rad and a limit per node.
fn with_limits(distance: f64, intervals: usize, limits: impl Fn(f64) -> Vec<LinearLimit>) -> SampledPath {
    let mut path = SampledPath { acceleration: None, ..straight(distance, 1e3, 1.0, intervals) };
    for node in &mut path.pieces[0].nodes {
        (node.s, node.first) = (node.s * distance, vec![1.0]);
        node.limits = limits(node.s);
    }
    path
}

fn certified(path: &SampledPath) -> TimeOptimum {
    let optimum = time_optimum(path).expect("solvable");
    assert!(optimum.gap() <= 1e-5, "gap {}, {:?}", optimum.gap(), optimum.status);
    let greedy = reachable_profile(path).expect("feasible");
    assert!(greedy.duration_s >= optimum.lower_s);
    for b in [&optimum.pieces[0].b, &greedy.pieces[0].b] {
        assert!(violation_at_nodes(path, 0, b) <= 1e-9);
    }
    optimum
}

#[test]
fn a_link_lifted_against_constant_gravity_takes_the_time_of_its_two_accelerations() {
    // m s̈ + g between -u and u: up with a1 = (u - g)/m, down with a2 = (u + g)/m. From rest to rest over d,
    // T = √(2 d (1/a1 + 1/a2)); the switch at d a2/(a1 + a2) is a node: (0.7 + 0.3) / (2 · 0.7) of 140 nodes is 100.
    let (m, g, u, d) = (2.0, 0.3, 0.7, 1.4);
    let torque = |_| vec![LinearLimit::joint_torque(0, [m, 0.0, g], -u, u)];
    let (up, down) = ((u - g) / m, (u + g) / m);
    let exact = (2.0 * d * (1.0 / up + 1.0 / down)).sqrt();
    let optimum = certified(&with_limits(d, 140, torque));
    assert!((optimum.duration_s / exact - 1.0).abs() < 1e-6, "{} {exact}", optimum.duration_s);
    let greedy = reachable_profile(&with_limits(d, 140, torque)).expect("feasible");
    assert!((greedy.duration_s / exact - 1.0).abs() < 1e-6);
}

#[test]
fn a_pendulum_with_torque_to_spare_obeys_the_energy_balance() {
    // τ = m s̈ + g0 cos s, s from 0 to 1: under the upper bound u the energy is m ṡ²/2 = u s - g0 sin s, whatever the grid does
    // in between; rows at both ends of an interval keep b below it and approach it with the interval's length.
    let (m, g0, u) = (1.5, 2.0, 5.0);
    let torque = |s: f64| vec![LinearLimit::joint_torque(0, [m, 0.0, g0 * s.cos()], -1e3, u)];
    let mut errors = Vec::new();
    for intervals in [100, 400] {
        let mut path = with_limits(1.0, intervals, torque);
        path.pieces[0].end = EndRate::Free;
        let optimum = certified(&path);
        let b = *optimum.pieces[0].b.last().expect("nodes");
        let exact = 2.0 * (u - g0 * 1.0_f64.sin()) / m;
        assert!(b <= exact * (1.0 + 1e-9));
        errors.push(1.0 - b / exact);
    }
    // Lowest over an interval of a torque that changes by at most g0 Δs: a share of g0 Δs / (u - g0) at the most.
    assert!(errors[0] < 2.0 / 3.0 / 100.0 && errors[1] < 0.3 * errors[0], "{errors:?}");
}

#[test]
fn an_arm_that_cannot_hold_its_weight_is_told_which_joint_where_and_by_how_much() {
    // Joint 2 holds 1.0 at the start and lacks 25 % of its range there.
    let limits = |_| {
        vec![
            LinearLimit::joint_torque(0, [1.0, 0.0, 0.2], -1.0, 1.0),
            LinearLimit::joint_torque(1, [1.0, 0.0, 1.0], -0.8, 0.8),
        ]
    };
    let path = with_limits(1.0, 20, limits);
    for error in [time_optimum(&path).expect_err("infeasible"), reachable_profile(&path).expect_err("infeasible")] {
        let OptimumError::Infeasible { piece, kind, index, share, proven, .. } = error else { panic!("{error}") };
        assert_eq!((piece, kind, index, proven), (0, LimitKind::JointTorque, 1, true));
        // A lower bound, rounded down: the combination's coefficients cancel to rounding, some 1e-15 of 10, which the box
        // multiplies by its cap of (1e3)².
        assert!(share <= 0.25 && share > 0.25 - 1e-7, "{share}");
    }
    // What would do is told too, to 0.1 % of itself.
    let widening = needed_widening(&path).expect("some");
    assert!((0.25..0.25 * 1.002).contains(&widening), "{widening}");
}

#[test]
fn a_place_that_no_speed_carries_over_is_named() {
    // Between 0.60 and 0.65 joint 1 needs twice its torque, whatever the motion: no inertia, no rate helps.
    let weak = |s: f64| (0.599..0.651).contains(&s);
    let path = with_limits(1.0, 100, |s| {
        let g = if weak(s) { 2.0 } else { 0.0 };
        let m = if weak(s) { 0.0 } else { 1.0 };
        vec![
            LinearLimit::joint_torque(0, [m, 0.0, g], -1.0, 1.0),
            LinearLimit::joint_acceleration(1, 1.0, 0.0, -1.0, 1.0),
        ]
    });
    let error = time_optimum(&path).expect_err("infeasible");
    let OptimumError::Infeasible { node, s, kind, index, share, proven, .. } = error else { panic!("{error}") };
    assert_eq!((kind, index, proven), (LimitKind::JointTorque, 0, true));
    assert!((60..=65).contains(&node) && (s - node as f64 / 100.0).abs() < 1e-12);
    assert!((share - 1.0).abs() < 1e-9, "{share}");
    assert!(error.to_string().contains("the torque limit of joint 1 at s = 0.6"), "{error}");
}

#[test]
fn momentum_carries_over_a_place_where_the_torque_does_not() {
    // Over a short stretch gravity exceeds the torque: from rest there is no holding it, with a run-up there is. Energy: before it
    // the rate gains 2 (u - g)/m per unit of s, on it loses.
    let weak = |s: f64| (0.5..0.6).contains(&s);
    let path = with_limits(1.0, 100, |s| {
        vec![LinearLimit::joint_torque(0, [1.0, 0.0, if weak(s) { 1.5 } else { 0.0 }], -1.0, 1.0)]
    });
    let optimum = certified(&path);
    // On the stretch s̈ <= 1 - 1.5, so b falls by 2 · 0.5 · Δs per interval at the least.
    let b = &optimum.pieces[0].b;
    assert!((50..59).all(|k| b[k + 1] <= b[k] - 0.01 + 1e-9));
}

#[test]
fn a_start_too_fast_to_stop_is_told_its_acceleration_limit() {
    // From 3 rad/s with 1 rad/s² a stop takes 4.5 rad, of which there is 1.
    let mut path = straight(1.0, 10.0, 1.0, 50);
    path.pieces[0].start = EndRate::Given(3.0);
    let error = time_optimum(&path).expect_err("infeasible");
    let OptimumError::Infeasible { kind, index, share, proven, .. } = error else { panic!("{error}") };
    assert_eq!((kind, index, proven), (LimitKind::JointAcceleration, 0, true));
    // 4.5 times the limit would do: short by 3.5.
    assert!((share - 3.5).abs() < 1e-6, "{share}");
    let widening = needed_widening(&path).expect("some");
    assert!((3.5 - 1e-6..3.5 * 1.002).contains(&widening), "{widening}");
    path.pieces[0].start = EndRate::Given(11.0);
    let error = reachable_profile(&path).expect_err("infeasible");
    let OptimumError::Infeasible { node: 0, kind: LimitKind::JointSpeed, index: 0, share, .. } = error else {
        panic!("{error}")
    };
    assert!((share - 0.1).abs() < 1e-12);
}

#[test]
fn given_rates_at_both_ends_are_met_and_the_closed_form_holds() {
    // From 0.6 to 0.8 over 1 with acceleration 1: up to v² = (0.36 + 0.64 + 2)/2 = 1.5 at s = 0.57, a node of 100.
    let mut path = straight(1.0, 10.0, 1.0, 100);
    (path.pieces[0].start, path.pieces[0].end) = (EndRate::Given(0.6), EndRate::Given(0.8));
    let exact = 2.0 * 1.5_f64.sqrt() - 0.6 - 0.8;
    let optimum = certified(&path);
    assert!((optimum.duration_s / exact - 1.0).abs() < 1e-6, "{} {exact}", optimum.duration_s);
    for b in [&optimum.pieces[0].b, &reachable_profile(&path).expect("feasible").pieces[0].b] {
        assert!((b[0] - 0.36).abs() < 1e-15 && (b[100] - 0.64).abs() < 1e-15);
    }
}

#[test]
fn asymmetric_accelerations_give_the_two_slopes_of_the_triangle() {
    // a up 3, down 1 over 1: T = √(2 (1/3 + 1)), the switch at a quarter.
    let path = with_limits(1.0, 80, |_| vec![LinearLimit::joint_acceleration(0, 1.0, 0.0, -1.0, 3.0)]);
    assert!((certified(&path).duration_s / (8.0_f64 / 3.0).sqrt() - 1.0).abs() < 1e-6);
}

#[test]
fn a_speed_limit_that_varies_along_the_path_is_followed_where_it_binds() {
    let mut path = straight(1.0, 1.0, 1e3, 100);
    for node in &mut path.pieces[0].nodes {
        let limit = if node.s > 0.5 { 0.25 } else { 0.75 };
        node.speeds = vec![SpeedLimit::joint(0, node.first[0], -1.0, limit)];
    }
    let optimum = certified(&path);
    assert!((optimum.pieces[0].b[25].sqrt() - 0.75).abs() < 1e-6);
    assert!((optimum.pieces[0].b[75].sqrt() - 0.25).abs() < 1e-6);
}

#[test]
fn tool_limits_hold_on_an_arc() {
    // A circle of 0.5 m, s the angle: p' of length 0.5, p'' of length 0.5 across. Speed 1 m/s would be ṡ = 2; acceleration
    // 0.5 m/s² allows ṡ⁴ + s̈² <= 1, so ṡ = 1 in the middle, less what the polygon of 32 sides gives away.
    let radius = 0.5;
    let sample = |k: usize| {
        let s = 3.0 * k as f64 / 300.0;
        let (sin, cos) = s.sin_cos();
        let (first, second) = ([-radius * sin, radius * cos, 0.0], [-radius * cos, -radius * sin, 0.0]);
        PathSample {
            s,
            first: vec![1.0],
            second: vec![0.0],
            limits: LinearLimit::tool_acceleration(first, second, 0.5, 16),
            speeds: vec![SpeedLimit::tool(first, 1.0)],
            ..PathSample::default()
        }
    };
    let mut path = straight(1.0, 1e3, 1.0, 300);
    path.acceleration = None;
    path.pieces[0].nodes = (0..=300).map(sample).collect();
    let optimum = certified(&path);
    let b = &optimum.pieces[0].b;
    let polygon = (std::f64::consts::PI / 32.0).cos();
    assert!((b[150] <= 1.0) && b[150] >= polygon - 1e-6, "{}", b[150]);
    for k in 0..300 {
        let s_acceleration = (b[k + 1] - b[k]) / 0.02;
        assert!((b[k].powi(2) + s_acceleration.powi(2)).sqrt() <= 1.0 + 1e-9);
    }
    for node in &mut path.pieces[0].nodes {
        node.speeds = vec![SpeedLimit::tool([0.0, radius, 0.0], 0.25)];
    }
    assert!((certified(&path).pieces[0].b[150] - 0.25).abs() < 1e-6);
}

#[test]
fn torque_rows_with_gravity_are_certified_on_random_paths() {
    // Rows with offsets of both signs, so that no scaling towards rest mends a profile.
    let count = if cfg!(debug_assertions) { 6 } else { 60 };
    for seed in 0..count {
        let mut path = RandomSpline::new(1000 + seed, 6).sample(200, 3);
        let piece = &mut path.pieces[0];
        for sample in piece.nodes.iter_mut().chain(piece.between.iter_mut().flatten()) {
            for joint in 0..6 {
                let (first, second) = (sample.first[joint], sample.second[joint]);
                let inertia = 1.0 + 0.3 * (2.0 * sample.s + joint as f64).sin();
                let gravity = 4.0 * (3.0 * sample.s + 2.0 * joint as f64).cos();
                let bend = 0.3 * first * first * (2.0 * sample.s).cos();
                sample.limits.push(LinearLimit::joint_torque(
                    joint,
                    [inertia * first, inertia * second + bend, gravity],
                    -5.0,
                    6.0,
                ));
            }
        }
        certified(&path);
        if seed < 3 {
            assert!(refine_optimum(&path, 1e-6).expect("refinable").result.between.largest() <= 1e-6);
        }
    }
}

#[test]
fn numbers_that_are_none_are_refused_before_any_solver_sees_them() {
    for bad in [f64::NAN, f64::INFINITY] {
        let torque = with_limits(1.0, 10, |s| {
            vec![LinearLimit::joint_torque(0, [if s > 0.45 { bad } else { 1.0 }, 0.0, 0.0], -1.0, 1.0)]
        });
        assert!(matches!(reachable_profile(&torque), Err(OptimumError::NotFinite { node: 5, .. })));
    }
    let inverted = with_limits(1.0, 10, |_| vec![LinearLimit::joint_acceleration(0, 1.0, 0.0, 1.0, -1.0)]);
    assert!(reachable_profile(&inverted).is_err() && time_optimum(&inverted).is_err());
    let mut path = straight(1.0, 1.0, 1.0, 10);
    path.pieces[0].end = EndRate::Given(f64::NAN);
    assert!(time_optimum(&path).is_err());
    path.pieces[0].end = EndRate::Given(-0.5);
    assert!(time_optimum(&path).is_err());
    let inverted = SampledPath { speed_upper: vec![-1.0], ..straight(1.0, 1.0, 1.0, 10) };
    assert!(time_optimum(&inverted).is_err());
}
