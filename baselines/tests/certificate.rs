//! The certificate: right for any multipliers, tight with the solver's, blind to units.

mod support;

use proptest::prelude::*;
use slideway_baselines::time_optimal::{
    GAP_TOLERANCE, PieceProgram, feasible_time, lower_bound, repair, solve_conic, time_optimum,
};
use slideway_path::{PathSample, SampledPath};
use support::{one_piece, straight};

/// A smooth random joint path `q_i(s) = Σ_j c_ij sin(j π u + φ_ij)`, `u = s / length`, sampled on a uniform grid.
#[derive(Clone, Debug)]
struct RandomPath {
    /// Amplitudes and phases per joint.
    waves: Vec<[(f64, f64); 3]>,
    speed: Vec<f64>,
    acceleration: Vec<f64>,
}

impl RandomPath {
    /// `amplitude` scales the motion in rad, `length` is the range of `s`.
    fn sample(&self, intervals: usize, amplitude: f64, length: f64) -> SampledPath {
        let node = |k: usize| {
            let u = k as f64 / intervals as f64;
            let derivative = |order: i32| {
                self.waves
                    .iter()
                    .map(|waves| {
                        (1..)
                            .zip(waves)
                            .map(|(j, (c, phase))| {
                                let w = f64::from(j) * std::f64::consts::PI;
                                let angle = w * u + phase;
                                let value = if order == 1 { angle.cos() } else { -angle.sin() };
                                amplitude * c * value * (w / length).powi(order)
                            })
                            .sum()
                    })
                    .collect()
            };
            PathSample {
                s: u * length,
                lambda: u,
                first: derivative(1),
                second: derivative(2),
                ..PathSample::default()
            }
        };
        SampledPath {
            joints: self.waves.len(),
            speed_lower: self.speed.iter().map(|v| -v).collect(),
            speed_upper: self.speed.clone(),
            acceleration: Some(self.acceleration.clone()),
            pieces: vec![one_piece((0..=intervals).map(node).collect(), vec![])],
        }
    }
}

fn random_path(joints: usize) -> impl Strategy<Value = RandomPath> {
    let wave = (-1.0..1.0_f64, 0.0..6.3_f64);
    let waves = prop::collection::vec([wave.clone(), wave.clone(), wave], joints);
    let limits = || prop::collection::vec(0.2..3.0_f64, joints);
    (waves, limits(), limits()).prop_map(|(waves, speed, acceleration)| RandomPath { waves, speed, acceleration })
}

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

proptest! {
    #![proptest_config(config(60))]

    #[test]
    fn random_paths_are_certified_whatever_the_size_of_the_motion(path in random_path(6), size in -4..=0_i32) {
        let sampled = path.sample(100, 10f64.powi(size), 1.0);
        let optimum = time_optimum(&sampled).expect("solvable");
        prop_assert!(optimum.lower_s <= optimum.upper_s);
        prop_assert!(optimum.gap() <= GAP_TOLERANCE, "gap {} at size 1e{size}, {:?}", optimum.gap(), optimum.status);
    }

    #[test]
    fn the_answer_depends_neither_on_units_nor_on_the_scale_of_the_parameter(path in random_path(3), stretch in -4..=4_i32, milli in any::<bool>()) {
        let reference = time_optimum(&path.sample(60, 1.0, 1.0)).expect("solvable");
        let unit = if milli { 1e3 } else { 1.0 };
        let scaled = RandomPath {
            speed: path.speed.iter().map(|v| v * unit).collect(),
            acceleration: path.acceleration.iter().map(|a| a * unit).collect(),
            ..path
        };
        let other = time_optimum(&scaled.sample(60, unit, 10f64.powi(stretch))).expect("solvable");
        // Both are certified to 1e-6.
        prop_assert!((other.duration_s / reference.duration_s - 1.0).abs() < 2e-6);
    }
}

proptest! {
    #![proptest_config(config(500))]

    #[test]
    fn weak_duality_holds_for_nonsense_multipliers_and_profiles(
        path in random_path(2),
        seed in prop::collection::vec((1e-3..1.0_f64, -2.0..5.0_f64), 12),
        poison in any::<bool>(),
    ) {
        let sampled = path.sample(11, 1.0, 1.0);
        let program = PieceProgram::new(&sampled, 0).expect("moves");
        let profile: Vec<f64> = (0..12).map(|k| if program.free().contains(&k) { program.cap[k] * seed[k].0 } else { 0.0 }).collect();
        let mut multipliers: Vec<f64> = (0..program.row_count()).map(|i| 10f64.powf(seed[i % 12].1) - 1.0).collect();
        if poison { multipliers[0] = f64::NAN; }
        let lower = lower_bound(&program, &profile, &multipliers);
        // Any feasible profile will do as a witness; the repaired one is feasible.
        let witness = feasible_time(&program, &repair(&program, &profile).expect("positive"));
        prop_assert!(lower.lo <= witness.hi);
    }

    #[test]
    fn repaired_profiles_keep_every_row_and_cap(path in random_path(3), seed in prop::collection::vec(1e-6..3.0_f64, 21)) {
        let sampled = path.sample(20, 1.0, 1.0);
        let program = PieceProgram::new(&sampled, 0).expect("moves");
        let profile = repair(&program, &seed).expect("positive");
        for (k, &x) in profile.iter().enumerate() {
            prop_assert!(0.0 <= x && x <= program.cap[k]);
        }
        for row in program.rows() {
            // The program's own arithmetic: two products and a sum, each rounded once, of numbers whose sum is at most the bound.
            let terms = [row.before * profile[row.interval], row.after * profile[row.interval + 1]];
            let slack = 4.0 * f64::EPSILON * (terms[0].abs() + terms[1].abs() + row.bound.abs());
            prop_assert!(terms[0] + terms[1] <= row.bound + slack);
        }
    }
}

#[test]
fn triangle_profile_is_met_exactly_on_an_even_grid() {
    // b is linear in s under constant acceleration, so the discrete optimum equals the continuous one: T = 2 √(d / a).
    for distance in [1e-4, 1e-2, 1.0, 100.0] {
        let optimum = time_optimum(&straight(distance, 1e6, 2.0, 200)).expect("solvable");
        let exact = 2.0 * (distance / 2.0_f64).sqrt();
        assert!(optimum.is_certified(), "gap {}", optimum.gap());
        assert!((optimum.duration_s / exact - 1.0).abs() < 1e-6, "{} against {exact}", optimum.duration_s);
    }
}

#[test]
fn trapezoid_profile_is_met_where_the_switches_fall_on_nodes() {
    // v = 1, a = 1, d = 4: accelerates over 0.5, an eighth of the way; T = d/v + v/a = 5 s.
    let optimum = time_optimum(&straight(4.0, 1.0, 1.0, 80)).expect("solvable");
    assert!(optimum.is_certified());
    assert!((optimum.duration_s - 5.0).abs() < 5e-6);
    // s in shares of the way of 4: from rest with 1/4, at an even 1/4 from 1 s on, at rest again after 5 s. Solved to 1e-6.
    let motion = optimum.motion();
    for (t, s, s_dot, s_ddot) in [(0.5, 0.03125, 0.125, 0.25), (2.5, 0.5, 0.25, 0.0), (4.5, 0.96875, 0.125, -0.25)] {
        let state = motion.at_time(t);
        assert!((state.s - s).abs() < 1e-5, "{t}: {state:?}");
        assert!((state.s_dot - s_dot).abs() < 1e-5 && (state.s_ddot - s_ddot).abs() < 1e-4, "{t}: {state:?}");
    }
    let end = motion.at_time(9.0);
    assert!(end.s == 1.0 && end.s_dot < 1e-3 && motion.at_time(f64::NAN).s == 0.0, "{end:?}");
}

#[test]
fn without_acceleration_limits_the_closed_form_of_the_grid_is_met() {
    let path = SampledPath { acceleration: None, ..straight(2.0, 0.5, 1.0, 10) };
    let optimum = time_optimum(&path).expect("solvable");
    assert!(optimum.is_certified());
    assert!((optimum.duration_s - 4.0).abs() < 4e-6);
    assert!(optimum.lower_s <= 4.0 && 4.0 <= optimum.upper_s);
}

#[test]
fn an_answer_ten_times_too_slow_is_not_certified() {
    // What a naive formulation returns on tiny paths, with a claimed gap of 1e-10: the certificate must see it.
    let program = PieceProgram::new(&straight(1e-4, 1.0, 1.0, 100), 0).expect("moves");
    let answer = solve_conic(&program).expect("solvable");
    let slow: Vec<f64> = answer.b.iter().map(|x| x / 100.0).collect();
    let slow = repair(&program, &slow).expect("positive");
    let (upper, lower) = (feasible_time(&program, &slow), lower_bound(&program, &slow, &answer.multipliers));
    assert!((upper.hi - lower.lo) / lower.lo.abs() > 0.5);
}

#[test]
fn a_path_that_does_not_move_is_an_error() {
    assert!(time_optimum(&straight(0.0, 1.0, 1.0, 10)).is_err());
    assert!(time_optimum(&straight(f64::NAN, 1.0, 1.0, 10)).is_err());
}
