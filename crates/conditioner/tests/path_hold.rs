//! A sample that cannot be served is answered with the last position at rest, and the run goes on from there.

mod support;

use slideway_conditioner::PathConditioner;
use slideway_conditioner::path::{
    ConstraintSample, HoldReason, Margin, Motion, PathForm, PathOutcome, PathSettings, SwitchingLaw, Walk,
};
use support::{
    PATH_RATE, distance, explicit, first_example, helix, helix_beside_sphere, implicit, one_ellipsoid,
    plane_and_sphere, trap_example,
};

const PERIOD: f64 = 1e-3;

fn appendix() -> PathForm {
    PathForm::Appendix { law: SwitchingLaw::Normalised { amplitude: 0.1 } }
}

/// The reference of example 9.1 at sample `k`, in motion.
fn reference(k: u32) -> Motion<3> {
    let time = f64::from(k) * PERIOD;
    let (position, derivative) = helix_beside_sphere(PATH_RATE * time);
    Motion { time, position, velocity: derivative.map(|d| d * PATH_RATE) }
}

#[test]
fn after_a_hold_a_pushed_reference_in_motion_resumes_from_rest_where_it_stood() {
    for form in [explicit(0.1), implicit(), appendix()] {
        let conditioner = PathConditioner::<3, 2>::new(first_example(PERIOD, form)).expect("valid settings");
        let mut state = conditioner.on_reference();
        let mut before = conditioner.step(&mut state, &reference(0), plane_and_sphere);
        for k in 1..2500 {
            before = conditioner.step(&mut state, &reference(k), plane_and_sphere);
        }
        let away = distance(&before.motion.position, &reference(2499).position);
        assert!(away > 0.01, "{form:?}: in the middle of example 9.1 the push is one of centimetres, not {away} m");
        // From rest, |ḟ| of the push filter stays below α (‖f‖ + U), here with 0.1 m each; the appendix's scheme moves with the
        // reference on top.
        let farthest = PERIOD * (PATH_RATE * 0.1 * 2.0_f64.sqrt() + 20.0 * (0.1 + 0.1));
        let bad = Motion { time: f64::NAN, ..reference(2500) };
        let held = conditioner.step(&mut state, &bad, plane_and_sphere).motion;
        // In the appendix's scheme too, which has decided by then where to go next.
        assert_eq!(held.position, before.motion.position, "{form:?}");
        for _ in 0..3 {
            let step = conditioner.step(&mut state, &bad, plane_and_sphere);
            assert_eq!(step.outcome, PathOutcome::Held(HoldReason::ReferenceNotFinite));
            assert_eq!((step.motion.position, step.motion.velocity), (held.position, [0.0; 3]));
            assert_eq!(state.pace(), 0.0);
        }
        let mut last = conditioner.step(&mut state, &reference(2503), plane_and_sphere);
        // Reference plus push, minus one another: two roundings of 0.3 m.
        assert!(distance(&last.motion.position, &held.position) < 1e-15, "{form:?}");
        assert_eq!(last.motion.velocity, [0.0; 3], "{form:?}");
        for k in 2504..2600 {
            let step = conditioner.step(&mut state, &reference(k), plane_and_sphere);
            let moved = distance(&step.motion.position, &last.motion.position);
            assert!(moved <= farthest, "{form:?}: {moved} m in one sample");
            last = step;
        }
    }
}

#[test]
fn after_a_hold_the_pace_rises_from_zero_with_its_filter() {
    let settings: PathSettings<1> = trap_example(Walk::Paper, 2.0, 1);
    let conditioner = PathConditioner::<3, 1>::new(settings).expect("valid settings");
    let mut state = conditioner.on_reference();
    let (position, _) = helix(0.0);
    let good = Motion { time: 0.0, position, velocity: [0.0; 3] };
    let followed = conditioner.step(&mut state, &good, one_ellipsoid);
    // A part in 1e15 for each rounding of the filter.
    assert!((followed.pace - 1.0).abs() < 1e-15 && state.pace() == followed.pace);
    conditioner.step(&mut state, &Motion { time: f64::INFINITY, ..good }, one_ellipsoid);
    assert_eq!(state.pace(), 0.0);
    for k in 1..100 {
        let step = conditioner.step(&mut state, &good, one_ellipsoid);
        // First order, 20 rad/s, 0.2 ms; some roundings a sample.
        let risen = 1.0 - (-20.0 * 2e-4 * f64::from(k)).exp();
        assert!((step.pace - risen).abs() < 1e-13, "{} at {k}, stated {risen}", step.pace);
        assert_eq!(state.pace(), step.pace);
    }
}

/// A constraint of the appendix's next position that cannot be read: the position before it is held, where it could be.
#[test]
fn the_appendix_scheme_holds_inside_although_it_has_decided_to_go_on() {
    let settings = PathSettings::<1> {
        sampling_period: 0.01,
        push_cutoff: 20.0,
        approach: [0.1],
        margin: Margin::None,
        form: appendix(),
        trap: None,
    };
    let conditioner = PathConditioner::<1, 1>::new(settings).expect("valid settings");
    let wall = |motion: &Motion<1>| {
        let value = motion.position[0];
        [ConstraintSample { value, gradient: [1.0], time_rate: 0.0, gradient_rate: [0.0], time_rate_rate: 0.0 }]
    };
    let blind = |motion: &Motion<1>| wall(motion).map(|s| ConstraintSample { value: f64::NAN, ..s });
    let at = |position: f64| Motion { time: 0.0, position: [position], velocity: [0.0] };
    for reference in [at(0.02), at(f64::NAN)] {
        let mut state = conditioner.on_reference();
        conditioner.step(&mut state, &at(-0.01), wall);
        // Decides to go to 0.02 next, beyond the wall.
        let inside = conditioner.step(&mut state, &at(0.02), wall).motion.position;
        let held = conditioner.step(&mut state, &reference, blind);
        assert!(matches!(held.outcome, PathOutcome::Held(_)));
        assert_eq!(held.motion.position, inside);
        assert!(inside[0] <= 0.0);
    }
}
