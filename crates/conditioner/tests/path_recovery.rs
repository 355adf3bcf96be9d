//! Starting outside the allowed set, moving constraints, joint space.

mod support;

use slideway_conditioner::PathConditioner;
use slideway_conditioner::path::bounds::recovery_time;
use slideway_conditioner::path::{Constraint, Margin, Motion, PathForm, PathOutcome, PathSettings};
use slideway_conditioner::shapes::{Ball, HalfSpace, Moving, Oscillation, Side};
use support::{explicit, first_example, implicit};

#[test]
fn from_outside_the_implicit_form_returns_monotonically_in_the_stated_time() {
    let (outside, margin, rate) = (0.08, 0.002, 0.5);
    let settings = PathSettings {
        form: PathForm::Implicit { recovery_rate: rate },
        margin: Margin::Fixed([margin]),
        approach: [0.1],
        trap: None,
        sampling_period: 1e-3,
        push_cutoff: 20.0,
    };
    let conditioner = PathConditioner::<2, 1>::new(settings).expect("valid settings");
    let plane = HalfSpace::new(&[1.0, 0.0], 0.0).expect("a normal");
    let mut state = conditioner.at_rest(&[outside, 0.0]).expect("a finite position");
    let (mut before, mut inside_after) = (f64::INFINITY, f64::INFINITY);
    for k in 0..2000 {
        let time = f64::from(k) * 1e-3;
        // The reference stays outside: it does nothing to help.
        let reference = Motion { time, position: [0.1, 0.0], velocity: [0.0; 2] };
        let step = conditioner.step(&mut state, &reference, |m| [plane.sample(m)]);
        assert!(!matches!(step.outcome, PathOutcome::Held(_)));
        assert!(step.sigma[0] <= before + 1e-15, "σ rose from {before} to {}", step.sigma[0]);
        before = step.sigma[0];
        if before <= 0.0 {
            inside_after = inside_after.min(time);
        }
    }
    let stated = recovery_time(outside, margin, rate, 0.1);
    assert!(inside_after <= stated, "inside after {inside_after} s, stated {stated} s");
}

#[test]
fn from_outside_the_explicit_form_returns_too() {
    let conditioner = PathConditioner::<3, 2>::new(first_example(1e-3, explicit(0.5))).expect("valid settings");
    let mut state = conditioner.at_rest(&[0.0, 0.05, 0.2]).expect("a finite position");
    let mut sigma = f64::INFINITY;
    for k in 0..1000 {
        let reference = Motion { time: f64::from(k) * 1e-3, position: [0.0, 0.05, 0.2], velocity: [0.0; 3] };
        sigma = conditioner.step(&mut state, &reference, support::plane_and_sphere).sigma[0];
    }
    assert!(sigma < 0.0, "{sigma}");
}

#[test]
fn a_moving_ball_pushes_a_standing_reference_out_of_its_way() {
    let ball = Ball::new([0.0, 0.0], 0.1, Side::Outside).expect("a radius");
    let swing = Oscillation { amplitude: [0.3, 0.0], frequency: 2.0, phase: 0.3 };
    let obstacle = Moving { shape: ball, trajectory: swing };
    let settings = PathSettings {
        form: implicit(),
        margin: Margin::Fixed([1e-4]),
        approach: [0.1],
        trap: None,
        sampling_period: 1e-3,
        push_cutoff: 20.0,
    };
    let conditioner = PathConditioner::<2, 1>::new(settings).expect("valid settings");
    let mut state = conditioner.on_reference();
    let mut acted = 0;
    for k in 0..6000 {
        let reference = Motion { time: f64::from(k) * 1e-3, position: [0.25, 0.01], velocity: [0.0; 2] };
        let step = conditioner.step(&mut state, &reference, |m| [obstacle.sample(m)]);
        assert!(step.sigma[0] <= 0.0, "σ = {} at sample {k}", step.sigma[0]);
        acted += u32::from(step.outcome == PathOutcome::Acting);
    }
    assert!(acted > 100, "the obstacle was felt in {acted} samples only");
}

#[test]
fn six_joints_keep_a_limit_and_a_combined_constraint() {
    let limit = HalfSpace::new(&[0.0, 1.0, 0.0, 0.0, 0.0, 0.0], 0.5).expect("a normal");
    let sum = HalfSpace::new(&[1.0, 1.0, 0.0, 0.0, 1.0, 0.0], 0.3).expect("a normal");
    let settings = PathSettings {
        form: implicit(),
        margin: Margin::Fixed([1e-4; 2]),
        approach: [0.1, 0.05],
        trap: None,
        sampling_period: 1e-3,
        push_cutoff: 20.0,
    };
    let conditioner = PathConditioner::<6, 2>::new(settings).expect("valid settings");
    let mut state = conditioner.on_reference();
    let mut shares = [0.0_f64; 2];
    for k in 0..6000 {
        let t = f64::from(k) * 1e-3;
        let position: [f64; 6] = core::array::from_fn(|i| 0.8 * (t + i as f64).sin());
        let velocity: [f64; 6] = core::array::from_fn(|i| 0.8 * (t + i as f64).cos());
        let reference = Motion { time: t, position, velocity };
        let step = conditioner.step(&mut state, &reference, |m| [limit.sample(m), sum.sample(m)]);
        // The reference starts outside of the second limit and is brought back within the first second.
        if t > 1.0 {
            assert!(step.sigma.iter().all(|&s| s <= 0.0), "σ = {:?} at {t} s", step.sigma);
        }
        for (most, share) in shares.iter_mut().zip(&step.share) {
            *most = most.max(*share);
        }
    }
    assert!(shares.iter().all(|&s| s > 0.5), "both constraints have to act: {shares:?}");
}
