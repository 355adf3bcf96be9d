//! Feedback: what the gains promise, on the PUMA-560 with its masses.

use proptest::prelude::*;
use slideway_motion::JointState;
use slideway_motion::control::{Derivative, Pid, PidSettings, PidState, TorqueController, TorqueLaw};
use slideway_robot::{Dynamics, JointVector, models};

const PERIOD: f64 = 1e-3;

fn settings() -> PidSettings {
    PidSettings {
        proportional: 100.0,
        integral: 0.0,
        derivative: 20.0,
        derivative_from: Derivative::Measured,
        largest: 1e6,
        sampling_period: PERIOD,
    }
}

fn pid(settings: PidSettings) -> Pid {
    Pid::new(settings).expect("sound settings")
}

fn arm() -> Dynamics<6> {
    models::puma560_dynamics().expect("the built-in arm")
}

fn controller(law: TorqueLaw) -> TorqueController<6> {
    TorqueController::new(arm(), law, [pid(settings()); 6], JointVector::from_element(f64::INFINITY)).expect("limits")
}

fn vector(size: f64) -> impl Strategy<Value = JointVector<6>> {
    prop::collection::vec(-size..size, 6).prop_map(JointVector::from_vec)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn output_and_integral_stay_inside_their_limit(
        errors in prop::collection::vec(prop_oneof![-1e3..1e3_f64, Just(f64::NAN), Just(f64::INFINITY)], 1..200),
        integral in 0.0..1e4_f64, bandwidth in 1.0..1e4_f64
    ) {
        let derivative_from = Derivative::Filtered { bandwidth };
        let pid = pid(PidSettings { integral, derivative_from, largest: 7.0, ..settings() });
        let mut state = PidState::default();
        for error in errors {
            let output = pid.step(&mut state, error, 0.0);
            prop_assert!(output.abs() <= 7.0 && state.integral().abs() <= 7.0, "{output} {state:?}");
        }
    }

    /// The rigid mass matrix has condition numbers up to 1.1e5, and 1e5 times the rounding of sums of about 1e3 is 1e-8.
    #[test]
    fn computed_torque_makes_the_error_linear(
        q in vector(2.0), qd in vector(1.0), error in vector(0.2), rate in vector(0.5), qdd in vector(2.0)
    ) {
        let desired = JointState { q: q + error, qd: qd + rate, qdd };
        let torque = controller(TorqueLaw::ComputedTorque).step(&desired, &q, &qd).torque;
        let acceleration = arm().forward(&q, &qd, &torque).expect("a mass matrix");
        let wanted = qdd + error * 100.0 + rate * 20.0;
        prop_assert!((acceleration - wanted).amax() <= 1e-8 * (1.0 + wanted.amax()));
    }

    #[test]
    fn an_arm_on_its_set_point_stays_there_under_every_law_with_a_model(q in vector(2.0)) {
        for law in [TorqueLaw::GravityCompensation, TorqueLaw::FeedForward, TorqueLaw::ComputedTorque] {
            let rest = JointState::at_rest(q);
            let torque = controller(law).step(&rest, &q, &rest.qd).torque;
            let acceleration = arm().forward(&q, &rest.qd, &torque).expect("a mass matrix");
            prop_assert!(acceleration.amax() <= 1e-8, "{law:?}: {acceleration}");
        }
    }
}

#[test]
fn the_filtered_derivative_of_a_ramp_is_its_slope() {
    let filtered = PidSettings {
        proportional: 0.0,
        derivative: 2.0,
        derivative_from: Derivative::Filtered { bandwidth: 50.0 },
        ..settings()
    };
    let pid = pid(filtered);
    let mut state = PidState::default();
    let output = (0..2000).fold(0.0, |_, k| pid.step(&mut state, 3.0 * PERIOD * f64::from(k), 0.0));
    // The transient has decayed by (1 + 50 T)^-2000, far below rounding.
    assert!((output - 6.0).abs() < 1e-9, "{output}");
}

/// A mass on a spring-less axis, pushed by a constant force, under PID: explicit Euler at a millisecond.
#[test]
fn the_integral_takes_away_a_constant_load_and_does_not_wind_up() {
    let pid = pid(PidSettings { integral: 200.0, largest: 20.0, ..settings() });
    let mut state = PidState::default();
    let (mut x, mut v, mut farthest) = (0.0_f64, 0.0_f64, 0.0_f64);
    for _ in 0..20_000 {
        // The step of 1 asks for 100, five times what there is.
        let force = pid.step(&mut state, 1.0 - x, -v) - 3.0;
        v += PERIOD * force;
        x += PERIOD * v;
        farthest = farthest.max(x);
    }
    // Slowest pole of s³ + 20 s² + 100 s + 200: about -3.6 / s, so after 20 s nothing is left of it.
    assert!((x - 1.0).abs() < 1e-9 && (state.integral() - 3.0).abs() < 1e-6, "{x}");
    // Wound up for the 0.3 s of the approach the integral would hold its limit and carry far past the target.
    assert!(farthest < 1.2, "{farthest}");
}

#[test]
fn torques_are_cut_at_their_limits_and_the_joints_named() {
    let largest = JointVector::from([1.0, 1e6, 1e6, 1e6, 1e6, 1e6]);
    let mut controller =
        TorqueController::new(arm(), TorqueLaw::Pid, [pid(settings()); 6], largest).expect("positive limits");
    let desired = JointState::at_rest(JointVector::from_element(0.5));
    let output = controller.step(&desired, &JointVector::zeros(), &JointVector::zeros());
    assert!(output.torque[0] == 1.0 && output.torque[1] == 50.0);
    assert_eq!(output.cut, [true, false, false, false, false, false]);
    let nan = controller.step(&desired, &JointVector::from_element(f64::NAN), &JointVector::zeros());
    assert!(nan.torque.amax() == 0.0);
}

#[test]
fn settings_out_of_range_are_refused() {
    let bad = [
        PidSettings { proportional: -1.0, ..settings() },
        PidSettings { integral: f64::NAN, ..settings() },
        PidSettings { largest: 0.0, ..settings() },
        PidSettings { derivative_from: Derivative::Filtered { bandwidth: 0.0 }, ..settings() },
    ];
    assert!(bad.into_iter().all(|settings| Pid::new(settings).is_err()));
}
