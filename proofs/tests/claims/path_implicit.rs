use proptest::prelude::{prop_assert, prop_assume, proptest};
use proptest::test_runner::TestCaseError;
use slideway_conditioner::PathConditioner;
use slideway_conditioner::path::{Constraint, ConstraintSample, HoldReason, Motion, PathOutcome};
use slideway_conditioner::shapes::HalfSpace;
use slideway_proofs::path_implicit::CLAIM;

use crate::path_support::{
    APPROACH, Body, PERIOD, RECOVERY, Sketch, Suprema, Swing, implicit, norm, runs, settings, sketch, swing,
};
use crate::support::{Outcome, counterexample, holds, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// Two walls with the cosine `b` of their normals, `φ_1 = p` and `φ_2 = q` above zero.
fn opposed_walls_are_held(b: f64, p: f64, q: f64) -> Outcome {
    let (one, two) = (HalfSpace::new(&[1.0, 0.0], -p)?, HalfSpace::new(&[b, (1.0 - b * b).sqrt()], -q)?);
    let conditioner = PathConditioner::<2, 2>::new(settings(implicit()))?;
    let mut state = conditioner.on_reference();
    let reference = Motion { time: 0.0, position: [0.0; 2], velocity: [0.0; 2] };
    // From an admissible start: the walls come up at the second sample.
    let far = HalfSpace::new(&[1.0, 0.0], 1.0)?;
    conditioner.step(&mut state, &reference, |m| [far.sample(m), far.sample(m)]);
    let step = conditioner.step(&mut state, &reference, |m| [one.sample(m), two.sample(m)]);
    assert!(matches!(step.outcome, PathOutcome::Held(HoldReason::Contradiction(_))), "{:?}", step.outcome);
    assert_eq!((step.motion.position, step.motion.velocity), ([0.0; 2], [0.0; 2]));
    Ok(())
}

#[test]
fn dependent_walls_without_a_common_side_are_held() -> Outcome {
    opposed_walls_are_held(-1.0, 0.1, 0.3)?;
    let model = counterexample(&CLAIM, "independence")?;
    opposed_walls_are_held(model.value("b")?, model.value("p")?, model.value("q")?)
}

fn empty_gradient_is_held(phi: f64) -> Outcome {
    let conditioner = PathConditioner::<2, 1>::new(settings(implicit()))?;
    let mut state = conditioner.on_reference();
    let reference = Motion { time: 0.0, position: [0.0; 2], velocity: [0.0; 2] };
    let flat = |value| {
        move |_: &Motion<2>| {
            [ConstraintSample {
                value,
                gradient: [0.0; 2],
                time_rate: 0.0,
                gradient_rate: [0.0; 2],
                time_rate_rate: 0.0,
            }]
        }
    };
    conditioner.step(&mut state, &reference, flat(-1.0));
    let step = conditioner.step(&mut state, &reference, flat(phi));
    assert!(matches!(step.outcome, PathOutcome::Held(_)), "{:?}", step.outcome);
    Ok(())
}

#[test]
fn an_empty_gradient_is_held() -> Outcome {
    empty_gradient_is_held(0.3)?;
    let model = counterexample(&CLAIM, "gradient")?;
    assert_eq!(model.value("rr")?, 0.0);
    empty_gradient_is_held(model.value("phi")?)
}

/// Sketches to bodies around the start of the reference.
fn bodies<const M: usize>(sketches: [Sketch; M], start: &Motion<3>) -> Option<[Body; M]> {
    let found = sketches.map(|sketch| sketch.around(start));
    if found.iter().any(Option::is_none) {
        return None;
    }
    Some(found.map(|body| body.unwrap_or(Body::Wall(HalfSpace::new(&[1.0, 0.0, 0.0], 0.0).expect("a normal")))))
}

/// A run from an admissible start with the reference's velocity. Says how many samples acted.
///
/// Rounding of `φ`: rows of condition up to 1e3, times 1e-16, times positions and `K` times velocities as they occur.
fn stays_inside<const M: usize>(swing: &Swing, bodies: &[Body; M], samples: u32) -> Result<u32, TestCaseError> {
    let conditioner = PathConditioner::<3, M>::new(settings(implicit()))?;
    let mut state = conditioner.on_reference();
    let (mut suprema, mut closest, mut start, mut acted) = (Suprema::default(), f64::INFINITY, [0.0; M], 0);
    for k in 0..samples {
        let reference = swing.at(k);
        let step = conditioner.step(&mut state, &reference, |m| bodies.each_ref().map(|body| body.sample(m)));
        let rounding = 1e-12 * (1.0 + norm(&step.motion.position) + APPROACH * norm(&step.motion.velocity));
        if k == 0 {
            start = step.sigma;
        }
        let held = matches!(step.outcome, PathOutcome::Held(_));
        // A held sample starts anew: its motion is no longer that of the filter.
        let rate = std::array::from_fn(|i| step.motion.velocity[i] - reference.velocity[i]);
        suprema.see(swing, &step.correction, &rate, &step.push);
        for i in 0..M {
            closest = bodies[i].radius(step.sigma[i]).min(closest);
            prop_assert!(step.phi[i] <= rounding || held, "φ = {:e} at {k}", step.phi[i]);
            let bulge = suprema.bulge(1.0 / closest.max(0.02));
            prop_assert!(step.sigma[i] <= start[i].max(0.0) + bulge + rounding, "σ = {:e} at {k}", step.sigma[i]);
        }
        prop_assert!(!held || M > 1, "{:?} at {k}", step.outcome);
        acted += u32::from(step.outcome == PathOutcome::Acting);
    }
    Ok(acted)
}

proptest! {
    #![proptest_config(runs())]

    #[test]
    fn one_wall_or_ball_is_kept_at_every_sample(swing in swing(), one in sketch(3)) {
        let bodies = bodies([one], &swing.at(0));
        prop_assume!(bodies.is_some());
        // Only runs in which something acted count.
        prop_assume!(stays_inside(&swing, &bodies.expect("assumed"), 1000)? > 0);
    }

    #[test]
    fn pairs_of_walls_and_balls_are_kept_at_every_sample(swing in swing(), one in sketch(3), two in sketch(3)) {
        let bodies = bodies([one, two], &swing.at(0));
        prop_assume!(bodies.is_some());
        // Only runs in which something acted count.
        prop_assume!(stays_inside(&swing, &bodies.expect("assumed"), 600)? > 0);
    }

    #[test]
    fn triples_of_walls_and_balls_are_kept_at_every_sample(
        swing in swing(),
        one in sketch(3),
        two in sketch(3),
        three in sketch(3),
    ) {
        let bodies = bodies([one, two, three], &swing.at(0));
        prop_assume!(bodies.is_some());
        // Only runs in which something acted count.
        prop_assume!(stays_inside(&swing, &bodies.expect("assumed"), 600)? > 0);
    }

    // From outside φ falls by at least the recovery of a sample until it is gone. Rounding as above.
    #[test]
    fn from_outside_phi_falls_at_the_recovery_rate(swing in swing(), one in sketch(2), depth in 0.0..0.3) {
        let body = one.around(&swing.at(0));
        prop_assume!(body.is_some());
        let body = body.expect("assumed");
        let conditioner = PathConditioner::<3, 1>::new(settings(implicit()))?;
        // Behind the nearest point of the boundary, and not at the centre of a ball.
        let inward = depth * one.radius;
        let position = swing.at(0).position;
        let gap = -body.sample(&Motion { velocity: [0.0; 3], ..swing.at(0) }).value;
        let start = std::array::from_fn(|i| position[i] + (gap + inward) * one.normal[i]);
        let mut state = conditioner.at_rest(&start)?;
        let mut before = f64::INFINITY;
        for k in 0..600 {
            let step = conditioner.step(&mut state, &swing.at(k), |m| [body.sample(m)]);
            prop_assert!(!matches!(step.outcome, PathOutcome::Held(_)), "{:?}", step.outcome);
            let limit = (before - RECOVERY * PERIOD).max(0.0);
            prop_assert!(step.phi[0] <= limit + 1e-12, "{} {limit} at {k}", step.phi[0]);
            before = step.phi[0];
        }
    }
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
