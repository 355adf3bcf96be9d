//! Boundaries that are sharp against the sampling period: eight linearisations come near, and the push is brought inside.

use std::cell::Cell;

use slideway_conditioner::PathConditioner;
use slideway_conditioner::path::{
    Constraint, ConstraintSample, HoldReason, Margin, Motion, PathForm, PathOutcome, PathSettings, Reserve,
    SwitchingLaw, bounds,
};
use slideway_conditioner::shapes::{Moving, Polytope, Side, UniformMotion};

const PERIOD: f64 = 0.004;
const CUTOFF: f64 = 50.0;
const APPROACH: f64 = 0.08;
const RECOVERY: f64 = 1.0;

/// Largest excess over a limit that may be left, m: 1e-12 of `|σ| + ‖p‖ + K ‖ṗ‖`, which stay below 10, as in the claims.
const LEFT: f64 = 1e-11;

fn settings(form: PathForm) -> PathSettings<1> {
    PathSettings {
        sampling_period: PERIOD,
        push_cutoff: CUTOFF,
        approach: [APPROACH],
        margin: Margin::None,
        form,
        trap: None,
    }
}

struct Found {
    /// Samples in which the constraint acted.
    acted: u32,
    /// Largest excess over a limit at a sample that was not held.
    most: f64,
    /// In one sample.
    evaluations: u32,
}

/// A run along three sines against one constraint. The limit of `φ` is the band, or what the recovery leaves of an excess.
fn run(form: PathForm, speed: f64, amplitude: f64, constraint: impl Fn(&Motion<3>) -> ConstraintSample<3>) -> Found {
    let conditioner = PathConditioner::<3, 1>::new(settings(form)).expect("valid settings");
    let mut state = conditioner.on_reference();
    let mut found = Found { acted: 0, most: f64::NEG_INFINITY, evaluations: 0 };
    let mut beyond = f64::INFINITY;
    for k in 0..5000 {
        let time = f64::from(k) * PERIOD;
        let angles = [1.0, 2.0, 2.0].map(|w| w * speed).into_iter().zip([5.364, 4.737, 2.303]);
        let mut reference = Motion { time, position: [0.0; 3], velocity: [0.0; 3] };
        for (i, (w, phase)) in angles.enumerate() {
            reference.position[i] = (w * time + phase).sin();
            reference.velocity[i] = w * (w * time + phase).cos();
        }
        let count = Cell::new(0);
        let step = conditioner.step(&mut state, &reference, |m| {
            count.set(count.get() + 1);
            [constraint(m)]
        });
        found.evaluations = found.evaluations.max(count.get());
        if let PathOutcome::Held(_) = step.outcome {
            beyond = f64::INFINITY;
            continue;
        }
        found.acted += u32::from(step.outcome != PathOutcome::Free);
        let gradient = constraint(&step.motion).gradient.iter().map(|g| g * g).sum::<f64>().sqrt();
        let band = amplitude * bounds::push_per_sample(PERIOD, CUTOFF, APPROACH) * gradient;
        let excess = step.phi[0] - band;
        found.most = found.most.max(excess - (beyond - RECOVERY * PERIOD).max(0.0));
        beyond = excess;
    }
    found
}

/// Two faces 1.5 rad apart that move off, with their edge rounded off over some `1 / sharpness` metres.
fn edge(sharpness: f64) -> impl Constraint<3> {
    let normals = [[0.55, 0.75, -0.37], [-0.86, 0.5, 0.04]];
    let shape = Polytope::new(&normals, [-0.98, 0.54], sharpness, Side::Inside).expect("valid");
    Moving { shape, trajectory: UniformMotion { velocity: [0.12, -0.12, -0.12], acceleration: [0.0; 3] } }
}

#[test]
fn a_sharp_edge_is_kept_to_rounding_at_every_sample_that_is_not_held() {
    let explicit = |amplitude| PathForm::Sliding {
        law: SwitchingLaw::Normalised { amplitude },
        reserve: Reserve::On { recovery_rate: RECOVERY },
    };
    let implicit = PathForm::Implicit { recovery_rate: RECOVERY };
    for (form, amplitude) in [(implicit, 0.0), (explicit(1.0), 1.0)] {
        for speed in [0.3, 1.0, 2.0] {
            for sharpness in [7.0, 60.0] {
                let edge = edge(sharpness);
                let found = run(form, speed, amplitude, |m| edge.sample(m));
                assert!(found.acted > 1000, "the edge was felt in {} samples only", found.acted);
                let case = format!("{form:?} at {speed} rad/s and {sharpness} 1/m");
                assert!(found.most <= LEFT, "{case}: {:e}", found.most);
                // The free motion, eight linearisations, five steps back inside, and a held position.
                assert!(found.evaluations <= 15, "{case}: {} evaluations", found.evaluations);
            }
        }
    }
}

#[test]
fn a_limit_that_no_push_brings_back_to_rounding_is_held_and_named() {
    // Its φ is 1e-9 wherever the push takes it: small enough to pass for settled, and never kept.
    let stuck = |m: &Motion<3>| ConstraintSample {
        value: 1e-9 - APPROACH * m.velocity[0],
        gradient: [1.0, 0.0, 0.0],
        time_rate: 0.0,
        gradient_rate: [0.0; 3],
        time_rate_rate: 0.0,
    };
    let form = PathForm::Implicit { recovery_rate: RECOVERY };
    let conditioner = PathConditioner::<3, 1>::new(settings(form)).expect("valid settings");
    let mut state = conditioner.on_reference();
    let reference = |time| Motion { time, position: [3.0, 0.0, 0.0], velocity: [1.0, 0.0, 0.0] };
    let before = |_: &Motion<3>| [ConstraintSample { value: -1.0, ..stuck(&reference(0.0)) }];
    conditioner.step(&mut state, &reference(0.0), before);
    let step = conditioner.step(&mut state, &reference(PERIOD), |m| [stuck(m)]);
    assert_eq!(step.outcome, PathOutcome::Held(HoldReason::CorrectionNotFound));
    assert_eq!((step.motion.position, step.motion.velocity), ([3.0, 0.0, 0.0], [0.0; 3]));
}
