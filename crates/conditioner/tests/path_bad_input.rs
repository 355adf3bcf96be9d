//! Inputs that no conditioner should be given, and this one's answers to them.

mod support;

use slideway_conditioner::path::{
    Constraint, ConstraintSample, HoldReason, Margin, Motion, PathForm, PathOutcome, PathQuantity, PathSettings,
    Reserve, SwitchingLaw, TrapPhase, TrapSettings, Walk, sample_all,
};
use slideway_conditioner::shapes::{Ball, HalfSpace, Side};
use slideway_conditioner::{ParameterError, PathConditioner};
use support::{explicit, first_example, implicit, plane_and_sphere, trap_example};

fn still(position: [f64; 3]) -> Motion<3> {
    Motion { time: 0.0, position, velocity: [0.0; 3] }
}

fn forms() -> [PathForm; 4] {
    let law = SwitchingLaw::Normalised { amplitude: 0.1 };
    [explicit(0.1), reserved(), PathForm::Appendix { law }, implicit()]
}

fn reserved() -> PathForm {
    let law = SwitchingLaw::Normalised { amplitude: 0.1 };
    PathForm::Sliding { law, reserve: Reserve::On { recovery_rate: 0.5 } }
}

#[test]
fn a_reference_that_is_not_finite_holds_the_last_position_and_recovers() {
    for form in forms() {
        let conditioner = PathConditioner::<3, 2>::new(first_example(1e-3, form)).expect("valid settings");
        let mut state = conditioner.on_reference();
        let good = still([0.0, -0.1, 0.2]);
        let before = conditioner.step(&mut state, &good, plane_and_sphere).motion.position;
        for bad in [f64::NAN, f64::INFINITY] {
            let step = conditioner.step(&mut state, &still([bad, -0.1, 0.2]), plane_and_sphere);
            assert_eq!(step.outcome, PathOutcome::Held(HoldReason::ReferenceNotFinite));
            assert_eq!((step.motion.position, step.motion.velocity), (before, [0.0; 3]));
            assert_eq!((step.pace, step.advance), (0.0, 0.0));
            assert!(step.correction.iter().all(|c| c.is_finite()));
        }
        let after = conditioner.step(&mut state, &good, plane_and_sphere);
        assert_eq!(after.outcome, PathOutcome::Free);
        assert!(support::distance(&after.motion.position, &before) < 1e-15);
    }
}

#[test]
fn a_constraint_that_is_not_finite_holds_and_is_named() {
    let bad = |motion: &Motion<3>| {
        let mut samples = plane_and_sphere(motion);
        samples[1].gradient[2] = f64::NAN;
        samples
    };
    for form in forms() {
        let conditioner = PathConditioner::<3, 2>::new(first_example(1e-3, form)).expect("valid settings");
        let mut state = conditioner.on_reference();
        let before = conditioner.step(&mut state, &still([0.0, -0.1, 0.2]), plane_and_sphere).motion.position;
        let step = conditioner.step(&mut state, &still([0.0, -0.1, 0.1]), bad);
        assert_eq!(step.outcome, PathOutcome::Held(HoldReason::ConstraintNotFinite(1)));
        assert_eq!(step.motion.position, before);
    }
}

#[test]
fn every_number_that_a_form_uses_is_checked_and_an_explicit_form_without_reserve_does_not_ask_for_rates() {
    type Spoil = fn(&mut ConstraintSample<3>, f64);
    let (value, gradient): (Spoil, Spoil) = (|s, bad| s.value = bad, |s, bad| s.gradient[1] = bad);
    let (time_rate, rate): (Spoil, Spoil) = (|s, bad| s.time_rate = bad, |s, bad| s.gradient_rate[2] = bad);
    for form in forms() {
        let conditioner = PathConditioner::<3, 2>::new(first_example(1e-3, form)).expect("valid settings");
        for (spoil, always) in [(value, true), (gradient, true), (time_rate, true), (rate, false)] {
            for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let step = conditioner.step(&mut conditioner.on_reference(), &still([0.0, -0.1, 0.2]), |motion| {
                    let mut samples = plane_and_sphere(motion);
                    spoil(&mut samples[1], bad);
                    samples
                });
                let held = step.outcome == PathOutcome::Held(HoldReason::ConstraintNotFinite(1));
                assert_eq!(held, always || form == implicit() || form == reserved(), "{form:?}: {:?}", step.outcome);
            }
        }
    }
}

#[test]
fn an_empty_gradient_on_an_active_constraint_holds_and_is_named() {
    // At the centre of a ball to be kept out of there is no way that is better than another.
    for form in [explicit(0.1), PathForm::Appendix { law: SwitchingLaw::Normalised { amplitude: 0.1 } }] {
        let conditioner = PathConditioner::<3, 2>::new(first_example(1e-3, form)).expect("valid settings");
        let step = conditioner.step(&mut conditioner.on_reference(), &still([0.0; 3]), plane_and_sphere);
        assert!(matches!(step.outcome, PathOutcome::Held(HoldReason::EmptyGradient(1))), "{:?}", step.outcome);
        assert_eq!(step.motion.velocity, [0.0; 3]);
    }
    // The implicit form asks only that φ falls: at an empty gradient nothing it could do makes it fall.
    let conditioner = PathConditioner::<3, 2>::new(first_example(1e-3, implicit())).expect("valid settings");
    let mut state = conditioner.on_reference();
    conditioner.step(&mut state, &still([0.0; 3]), plane_and_sphere);
    let step = conditioner.step(&mut state, &still([0.0; 3]), plane_and_sphere);
    assert_eq!(step.outcome, PathOutcome::Held(HoldReason::Contradiction(1)));
}

/// Two planes that face away from one another and leave nothing between.
fn contradictory(motion: &Motion<3>) -> [ConstraintSample<3>; 2] {
    let above = HalfSpace::new(&[0.0, 0.0, -1.0], -0.1).expect("a normal");
    let below = HalfSpace::new(&[0.0, 0.0, 1.0], -0.1).expect("a normal");
    sample_all(&[&above, &below], motion)
}

#[test]
fn contradictory_constraints_hold_at_rest() {
    for form in forms() {
        let conditioner = PathConditioner::<3, 2>::new(first_example(1e-3, form)).expect("valid settings");
        let mut state = conditioner.on_reference();
        let mut last = None;
        for k in 0..20 {
            let reference = Motion { time: f64::from(k) * 1e-3, ..still([0.01 * f64::from(k), 0.0, 0.0]) };
            last = Some(conditioner.step(&mut state, &reference, contradictory));
        }
        let step = last.expect("twenty steps");
        let held =
            matches!(step.outcome, PathOutcome::Held(HoldReason::OpposedGradients | HoldReason::Contradiction(_)));
        assert!(held, "{form:?} ended {:?}", step.outcome);
        assert!(step.motion.position.iter().all(|p| p.is_finite()) && step.motion.velocity == [0.0; 3]);
    }
}

#[test]
fn a_reference_that_jumps_into_the_forbidden_set_leaves_the_implicit_form_inside() {
    let settings = PathSettings { margin: Margin::Fixed([1e-4; 2]), ..first_example(1e-3, implicit()) };
    let conditioner = PathConditioner::<3, 2>::new(settings).expect("valid settings");
    let mut state = conditioner.on_reference();
    for k in 0..1000 {
        // A jump through plane and sphere: not what Assumption 1 allows.
        let position = if k < 100 { [0.0, -0.1, 0.0] } else { [0.0, 0.2, 0.0] };
        let reference = Motion { time: f64::from(k) * 1e-3, ..still(position) };
        let step = conditioner.step(&mut state, &reference, plane_and_sphere);
        if matches!(step.outcome, PathOutcome::Held(_)) {
            assert_eq!(step.motion.velocity, [0.0; 3]);
        }
        assert!(step.sigma.iter().all(|&s| s <= 0.0), "σ = {:?} at sample {k}", step.sigma);
    }
}

/// Three walls around the corner at the origin; the reference sits outside.
fn corner(motion: &Motion<3>) -> [ConstraintSample<3>; 3] {
    let wall = |i: usize| {
        let mut normal = [0.0; 3];
        normal[i] = 1.0;
        HalfSpace::new(&normal, 0.0).expect("a unit normal").sample(motion)
    };
    [wall(0), wall(1), wall(2)]
}

#[test]
fn a_walk_with_as_many_active_constraints_as_dimensions_is_reported_as_blocked() {
    let conditioner = PathConditioner::<3, 3>::new(trap_example(Walk::Paper, 2.0, 1)).expect("valid settings");
    let mut state = conditioner.at_rest(&[-1e-3; 3]).expect("a finite position");
    // Clearly inside and far away: the walk is wanted. All three walls are near, so it has nowhere to go.
    let step = conditioner.step(&mut state, &still([-1.0; 3]), corner);
    assert_eq!(step.trap, TrapPhase::Blocked);
    assert!(step.sigma.iter().all(|&s| s <= 0.0));
}

#[test]
fn parameters_out_of_range_are_named() {
    let good = first_example(1e-3, explicit(0.1));
    let cases = [
        (PathSettings { push_cutoff: f64::NAN, ..good }, PathQuantity::PushCutoff),
        (PathSettings { push_cutoff: 4e3, ..good }, PathQuantity::PushCutoff),
        (PathSettings { approach: [0.1, 0.0], ..good }, PathQuantity::Approach(1)),
        (PathSettings { margin: Margin::Fixed([-1.0, 0.0]), ..good }, PathQuantity::Margin(0)),
        (PathSettings { form: explicit(-1.0), ..good }, PathQuantity::Push),
        (PathSettings { form: PathForm::Implicit { recovery_rate: 0.0 }, ..good }, PathQuantity::RecoveryRate),
    ];
    for (settings, expected) in cases {
        match PathConditioner::<3, 2>::new(settings) {
            Err(ParameterError::Path { quantity, .. }) => assert_eq!(quantity, expected),
            other => panic!("{expected}: {other:?}"),
        }
    }
    let period = PathConditioner::<3, 2>::new(PathSettings { sampling_period: 0.0, ..good });
    assert_eq!(period, Err(ParameterError::SamplingPeriod(0.0)));
    let start = PathConditioner::<3, 2>::new(good).expect("valid").at_rest(&[0.0, f64::INFINITY, 0.0]);
    assert!(matches!(start, Err(ParameterError::Path { quantity: PathQuantity::Start(1), .. })));
}

/// The refusal of a trap example with one of its trap parameters changed; `None` if it is accepted.
fn refused(change: impl FnOnce(&mut TrapSettings)) -> Option<(PathQuantity, f64)> {
    let mut settings = trap_example::<1>(Walk::Safe { push_share: 0.4 }, 5.0, 1);
    let law = SwitchingLaw::Normalised { amplitude: 1.6 };
    settings.form = PathForm::Sliding { law, reserve: Reserve::On { recovery_rate: 1.0 } };
    change(settings.trap.as_mut().expect("the example walks"));
    match PathConditioner::<3, 1>::new(settings) {
        Ok(_) => None,
        Err(ParameterError::Path { quantity, value }) => Some((quantity, value)),
        Err(other) => panic!("{other}"),
    }
}

type Change = fn(&mut TrapSettings, f64);

const ABOVE_ZERO: [(PathQuantity, Change); 6] = [
    (PathQuantity::WalkCutoff, |trap, x| trap.walk_cutoff = x),
    (PathQuantity::PaceCutoff, |trap, x| trap.pace_cutoff = x),
    (PathQuantity::WalkSpeed, |trap, x| trap.walk_speed = x),
    (PathQuantity::ReturnGain, |trap, x| trap.return_gain = x),
    (PathQuantity::DirectionPeriod, |trap, x| trap.direction_period = x),
    (PathQuantity::DistanceThreshold, |trap, x| trap.distance_threshold = x),
];

const NOT_NEGATIVE: [(PathQuantity, Change); 3] = [
    (PathQuantity::WalkGrowth, |trap, x| trap.walk_growth = x),
    (PathQuantity::ClearanceThreshold, |trap, x| trap.clearance_threshold = x),
    (PathQuantity::ActivityThreshold, |trap, x| trap.activity_threshold = x),
];

#[test]
fn every_parameter_of_the_trap_avoidance_has_its_range() {
    for (quantity, change) in ABOVE_ZERO.into_iter().chain(NOT_NEGATIVE) {
        for value in [-1e-9, f64::INFINITY] {
            assert_eq!(refused(|trap| change(trap, value)), Some((quantity, value)), "{quantity}");
        }
        assert!(refused(|trap| change(trap, f64::NAN)).is_some_and(|(named, _)| named == quantity), "{quantity}");
        assert_eq!(refused(|trap| change(trap, 1e-9)), None, "{quantity}");
    }
    for (quantity, change) in ABOVE_ZERO {
        assert_eq!(refused(|trap| change(trap, 0.0)), Some((quantity, 0.0)));
    }
    for (quantity, change) in NOT_NEGATIVE {
        assert_eq!(refused(|trap| change(trap, 0.0)), None, "{quantity}");
    }
    // Sampled every 0.2 ms: π / T is 15 708 rad/s.
    for (quantity, change) in [ABOVE_ZERO[0], ABOVE_ZERO[1]] {
        assert_eq!(refused(|trap| change(trap, 15_700.0)), None, "{quantity}");
        assert_eq!(refused(|trap| change(trap, 15_710.0)), Some((quantity, 15_710.0)));
    }
}

#[test]
fn the_share_of_the_push_lies_between_nothing_and_all() {
    for push_share in [-0.1, 0.0, 1.0, 1.1, f64::INFINITY] {
        let answer = refused(|trap| trap.walk = Walk::Safe { push_share });
        assert_eq!(answer, Some((PathQuantity::PushShare, push_share)));
    }
    assert!(refused(|trap| trap.walk = Walk::Safe { push_share: f64::NAN }).is_some());
    for push_share in [1e-9, 0.5, 1.0 - 1e-9] {
        assert_eq!(refused(|trap| trap.walk = Walk::Safe { push_share }), None);
    }
}

#[test]
fn a_margin_may_be_zero_and_no_parameter_may_be_infinite() {
    let good = first_example(1e-3, explicit(0.1));
    let none = PathSettings { margin: Margin::Fixed([0.0; 2]), ..good };
    assert!(PathConditioner::<3, 2>::new(none).is_ok());
    for settings in [
        PathSettings { push_cutoff: f64::INFINITY, ..good },
        PathSettings { approach: [f64::INFINITY, 0.1], ..good },
        PathSettings { margin: Margin::Fixed([0.0, f64::INFINITY]), ..good },
        PathSettings { form: explicit(f64::INFINITY), ..good },
        PathSettings { form: PathForm::Implicit { recovery_rate: f64::INFINITY }, ..good },
    ] {
        assert!(PathConditioner::<3, 2>::new(settings).is_err(), "{settings:?}");
    }
}

#[test]
fn a_refusal_names_the_parameter_in_words_and_counts_from_one() {
    let good = first_example(1e-3, explicit(0.1));
    let refusal = PathConditioner::<3, 2>::new(PathSettings { approach: [0.1, 0.0], ..good }).expect_err("K is zero");
    assert_eq!(refusal.to_string(), "approach time K of constraint 2 (s) is 0, which is out of its range");
    assert_eq!(PathQuantity::Start(2).to_string(), "coordinate 3 of the starting position");
    let others = [
        PathQuantity::PushCutoff,
        PathQuantity::Approach(0),
        PathQuantity::Approach(1),
        PathQuantity::Margin(0),
        PathQuantity::Push,
        PathQuantity::RecoveryRate,
        PathQuantity::PushShare,
    ];
    let trap = ABOVE_ZERO.iter().chain(&NOT_NEGATIVE).map(|(quantity, _)| quantity.to_string());
    let mut names: Vec<String> = others.iter().map(ToString::to_string).chain(trap).collect();
    names.sort();
    assert!(names.windows(2).all(|pair| pair[0] != pair[1]), "two parameters with one name: {names:?}");
}

#[test]
fn the_safe_walk_is_refused_where_its_guarantee_does_not_hold() {
    let law = SwitchingLaw::Normalised { amplitude: 1.6 };
    let asked = trap_example::<1>(Walk::Safe { push_share: 0.4 }, 5.0, 1);
    for form in [explicit(1.6), PathForm::Appendix { law }, implicit()] {
        let refused = PathConditioner::<3, 1>::new(PathSettings { form, ..asked });
        assert_eq!(refused, Err(ParameterError::SafeWalkWithoutReserve));
    }
    let form = PathForm::Sliding { law, reserve: Reserve::On { recovery_rate: 1.0 } };
    assert!(PathConditioner::<3, 1>::new(PathSettings { form, ..asked }).is_ok());
}

#[test]
fn a_ball_reports_an_empty_gradient_at_its_centre() {
    let ball = Ball::new([1.0, 2.0, 3.0], 0.5, Side::Outside).expect("a positive radius");
    let sample = ball.sample(&still([1.0, 2.0, 3.0]));
    assert_eq!((sample.value, sample.gradient), (0.5, [-0.0; 3]));
}
