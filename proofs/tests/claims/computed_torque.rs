use nalgebra::Vector3;
use proptest::prelude::{prop_assert, proptest};
use slideway_motion::control::{Derivative, Pid, PidSettings, TorqueController, TorqueLaw};
use slideway_motion::{JointState, MotionError};
use slideway_proofs::computed_torque::CLAIM;
use slideway_robot::models::puma560_dynamics;
use slideway_robot::{Dynamics, JointVector};

use crate::natural_support::pendulum;
use crate::support::{Outcome, TS, config, counterexample, joints, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

fn pid(proportional: f64, derivative: f64) -> Result<Pid, MotionError> {
    Pid::new(PidSettings {
        proportional,
        integral: 0.0,
        derivative,
        derivative_from: Derivative::Measured,
        largest: 1e9,
        sampling_period: TS,
    })
}

/// Acceleration of an arm under the computed torque of a model.
fn reached<const N: usize>(
    arm: &Dynamics<N>,
    model: Dynamics<N>,
    feedback: Pid,
    desired: &JointState<N>,
    [q, qd]: [&JointVector<N>; 2],
) -> Result<JointVector<N>, MotionError> {
    let largest = JointVector::from_element(f64::INFINITY);
    let mut controller = TorqueController::new(model, TorqueLaw::ComputedTorque, [feedback; N], largest)?;
    Ok(arm.forward(q, qd, &controller.step(desired, q, qd).torque)?)
}

/// A mass that the model has wrong by a share accelerates by that share too much.
fn acceleration_is_missed(share: f64, wanted: f64) -> Outcome {
    let arm = pendulum(0.0)?;
    let model = arm.with_mass_errors(&[share])?;
    let zero = JointVector::<1>::zeros();
    let desired = JointState { q: zero, qd: zero, qdd: JointVector::from([wanted]) };
    let acceleration = reached(&arm, model, pid(1.0, 1.0)?, &desired, [&zero, &zero])?[0];
    assert!(acceleration - wanted >= 0.04, "{acceleration}");
    Ok(())
}

#[test]
fn a_wrong_mass_misses_the_acceleration() -> Outcome {
    acceleration_is_missed(0.1, 1.0)?;
    let model = counterexample(&CLAIM, "exact-model")?;
    acceleration_is_missed(model.value("s")?, model.value("a")?)
}

proptest! {
    #![proptest_config(config())]

    // The PUMA-560 in any field of gravity. Its mass matrix has condition numbers up to 1.1e5: 1e5 times some hundred roundings of
    // 1e-16, relative to the accelerations that its torques stand for; bias torques add to them.
    #[test]
    fn the_error_obeys_its_linear_equation(
        q in joints::<6>(-3.1..3.1), qd in joints::<6>(-2.0..2.0), error in joints::<6>(-0.5..0.5),
        rate in joints::<6>(-1.0..1.0), qdd in joints::<6>(-5.0..5.0), gravity in joints::<3>(-10.0..10.0),
        kp in 0.0..400.0_f64, kd in 0.0..40.0_f64,
    ) {
        let arm = puma560_dynamics()?.with_gravity(Vector3::from(gravity));
        let [q, qd, error, rate, qdd] = [q, qd, error, rate, qdd].map(JointVector::<6>::from);
        let desired = JointState { q: q + error, qd: qd + rate, qdd };
        let acceleration = reached(&arm, arm.clone(), pid(kp, kd)?, &desired, [&q, &qd])?;
        let wanted = qdd + error * kp + rate * kd;
        let left = (acceleration - wanted).amax();
        prop_assert!(left <= 1e-8 * (10.0 + wanted.amax()), "{left}");
    }
}
