//! Claim `computed-torque`: under computed torque the error of every joint obeys the same linear equation.
//!
//! Hypotheses: the model is the arm's (`M`, `c`, `g`), `M` positive definite, torques inside their limits (N·m).
//!
//! ```text
//! M q̈ + c + g = τ = M (q̈d + Kp e + Kd ė) + c + g  =>  ë + Kd ė + Kp e = 0
//! ```
//!
//! Source: `[R16]`, computed torque control, whose acceleration has the errors `q - q_D` and the minus signs that go with them.
//!
//! Derivation. `M` is regular, so the two sides have the same acceleration; `e = qd - q`.
//!
//! Dropped hypothesis: the model is exact.

use nalgebra::Vector3;
use slideway_motion::control::{Derivative, Pid, PidSettings, TorqueController, TorqueLaw};
use slideway_motion::{JointState, MotionError};
use slideway_robot::models::puma560_dynamics;
use slideway_robot::{Dynamics, JointVector};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::draw::TS;
use crate::engine::{About, Choices, Cost, Engine, Stop};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "computed-torque",
    statement: "With an exact model the acceleration under computed torque is q̈d + Kp e + Kd ė: the error of every joint obeys ë + Kd ė + Kp e = 0.",
    source: "[R16] feed-forward torque control",
    verdict: Verdict::Holds,
    negations: &[Script { file: "computed-torque.smt2", text: include_str!("../smt/computed-torque.smt2") }],
    twins: &[Twin {
        without: "exact-model",
        script: Script {
            file: "computed-torque-without-exact-model.smt2",
            text: include_str!("../smt/computed-torque-without-exact-model.smt2"),
        },
    }],
    engines: &[Engine {
        name: "the_error_obeys_its_linear_equation",
        unit: "share of the slack",
        about: About::Other,
        cost: Cost::Sample,
        trial: linear_error,
    }],
};

/// Proportional (1/s²) and derivative (1/s) feedback of one joint, unlimited for any error met here.
///
/// # Errors
///
/// None for gains that are finite and not negative.
pub fn feedback(proportional: f64, derivative: f64) -> Result<Pid, MotionError> {
    Pid::new(PidSettings {
        proportional,
        integral: 0.0,
        derivative,
        derivative_from: Derivative::Measured,
        largest: 1e9,
        sampling_period: TS,
    })
}

/// Acceleration, rad/s², of an arm at `q`, `qd` under the computed torque of a model.
///
/// # Errors
///
/// A mass matrix that cannot be inverted.
pub fn reached<const N: usize>(
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

/// The PUMA-560 in any field of gravity.
///
/// Rounding. Its mass matrix has condition numbers up to 1.1e5: 1e5 times some hundred roundings of 1e-16 are 1e-8 at most,
/// relative to the accelerations that its torques stand for; bias torques, of the size of 10 rad/s², add to them.
fn linear_error(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let gravity = Vector3::from(choices.numbers::<3>(-10.0, 10.0));
    let mut joints = |size: f64| JointVector::<6>::from(choices.numbers::<6>(-size, size));
    let (q, qd, error, rate, qdd) = (joints(3.1), joints(2.0), joints(0.5), joints(1.0), joints(5.0));
    let (kp, kd) = (400.0 * choices.share(), 40.0 * choices.share());
    let arm = puma560_dynamics()?.with_gravity(gravity);
    let desired = JointState { q: q + error, qd: qd + rate, qdd };
    let acceleration = reached(&arm, arm.clone(), feedback(kp, kd)?, &desired, [&q, &qd])?;
    let wanted = qdd + error * kp + rate * kd;
    Ok(1.0 - (acceleration - wanted).amax() / (1e-8 * (10.0 + wanted.amax())))
}
