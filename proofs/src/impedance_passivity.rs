//! Claim `impedance-passivity`: impedance control stores no more energy than pushes put in.
//!
//! Hypotheses: `τ = Jᵀ (K e - D ẋ) + g(q)` with the arm's own `g` (N·m), `K` and `D` diagonal, `D >= 0`, the reference at rest, torques inside
//! their limits; for rotations one stiffness, and an error below half a turn.
//!
//! ```text
//! V = ½ q̇ᵀ M q̇ + ½ eᵀ K e          V̇ = q̇ᵀ p - ẋᵀ D ẋ <= q̇ᵀ p          p torques of what pushes the arm
//! ```
//!
//! Source: `[R16]` has the mass-spring-damper only, its spring and damper with the wrong signs, and no passivity.
//!
//! Derivation. `M q̈ = Jᵀ (K e - D ẋ) + p - C q̇`; `Ṁ = C + Cᵀ`, so that `½ q̇ᵀ Ṁ q̇` cancels `q̇ᵀ C q̇`; `ė = -J q̇`, so that the spring's rate
//! cancels `ẋᵀ K e`. For a rotation `½ k |log R|²` has the gradient `k log R`, the argument of the claim's linear rows again.
//!
//! Dropped hypothesis: the weight is exact.

use nalgebra::Vector3;
use slideway_motion::control::task_space::{Impedance, ToolGains, ToolReference};
use slideway_robot::models::puma560_dynamics;
use slideway_robot::{DriveEffects, Dynamics, JointVector, Task, Twist};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::engine::{About, Choices, Cost, Engine, Stop, exactly, worse};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "impedance-passivity",
    statement: "Under impedance control with exact gravity compensation and a reference at rest, kinetic and spring energy grow by no more than the work of what pushes the arm.",
    source: "ours; [R16] force and impedance control has the equation",
    verdict: Verdict::Ours,
    negations: &[Script { file: "impedance-passivity.smt2", text: include_str!("../smt/impedance-passivity.smt2") }],
    twins: &[Twin {
        without: "exact-weight",
        script: Script {
            file: "impedance-passivity-without-exact-weight.smt2",
            text: include_str!("../smt/impedance-passivity-without-exact-weight.smt2"),
        },
    }],
    engines: &[Engine {
        name: "stored_energy_grows_by_the_pushs_work_less_the_dampers",
        unit: "share of the slack",
        about: About::Other,
        cost: Cost::Sample,
        trial: stores_what_pushes_give,
    }],
};

/// Rate of kinetic and spring energy, W, by central differences over `h` along the motion.
fn stored_rate(
    arm: &Dynamics<6>,
    spring: impl Fn(&JointVector<6>) -> f64,
    [q, qd, qdd]: [&JointVector<6>; 3],
    h: f64,
) -> f64 {
    let stored = |h: f64| {
        let q = q + qd * h + qdd * (0.5 * h * h);
        arm.kinetic_energy(&q, &(qd + qdd * h)) + spring(&q)
    };
    (stored(h) - stored(-h)) / (2.0 * h)
}

/// The PUMA-560 with its rotors, pushed at the tool, its reference up to 6 · 0.3 rad away.
///
/// Slack. A central difference with step `h` leaves `h² / 6` of the third derivative: energies change at rates up to
/// `Ω = 1 + |q̇| + sqrt(|q̈|)` each time they are differentiated. Roundings of an energy over `h`: 1e-16 / 1e-5 = 1e-11, times some hundred.
/// The energy is stored without gravity: what carries the weight does its work.
fn stores_what_pushes_give(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let (stiffness, damping) = (1000.0 * choices.share(), 100.0 * choices.share());
    let push = Twist::from(choices.numbers::<6>(-20.0, 20.0));
    let mut joints = |size: f64| JointVector::<6>::from(choices.numbers::<6>(-size, size));
    let (q, qd, offset) = (joints(3.1), joints(1.0), joints(0.3));
    let arm = puma560_dynamics()?.with_effects(DriveEffects { rotor_inertia: true, friction: false });
    let gains = |x: f64| ToolGains::new(Vector3::new(x, 0.5 * x, 0.2 * x), 0.1 * x);
    let (k, d) = (gains(stiffness)?, gains(damping)?);
    let desired = ToolReference::at_rest(arm.arm().forward(&(q + offset)));
    let impedance = Impedance::new(arm.clone(), Task::Pose, k, d, JointVector::from_element(f64::INFINITY))?;
    let jacobian = arm.arm().jacobian(&q);
    let torque = impedance.step(&desired, &q, &qd).torque + jacobian.transpose() * push;
    let qdd = arm.forward(&q, &qd, &torque)?;
    let h = 1e-5;
    let spring = |q: &JointVector<6>| impedance.energy(&desired, q);
    let twist = jacobian * qd;
    let rate = stored_rate(&arm, spring, [&q, &qd, &qdd], h);
    let drained = twist.dot(&d.times(&twist));
    let supply = push.dot(&twist) - drained;
    let energy = 1.0 + arm.kinetic_energy(&q, &qd) + spring(&q) + arm.kinetic_energy(&q, &qdd);
    let omega = 1.0 + qd.norm() + qdd.norm().sqrt();
    let slack = energy * (h * h * omega.powi(3) + 1e-9);
    // Dampers only drain: to the last bit, a sum of squares.
    Ok(worse(1.0 - (rate - supply).abs() / slack, exactly(drained >= 0.0)))
}
