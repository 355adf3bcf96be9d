use nalgebra::Vector3;
use proptest::prelude::{prop_assert, proptest};
use slideway_motion::control::task_space::{Impedance, ToolGains, ToolReference};
use slideway_proofs::impedance_passivity::CLAIM;
use slideway_robot::models::puma560_dynamics;
use slideway_robot::{DriveEffects, Dynamics, JointVector, Task, Twist};

use crate::natural_support::pendulum;
use crate::support::{Outcome, config, counterexample, joints, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

fn unlimited<const N: usize>() -> JointVector<N> {
    JointVector::from_element(f64::INFINITY)
}

/// The level pendulum in zero-gravity mode with another weight gains kinetic energy at `v (gm - g)` though nobody pushes.
fn energy_comes_from_nowhere([v, g, gm]: [f64; 3]) -> Outcome {
    let (arm, free) = (pendulum(g)?, Impedance::zero_gravity(pendulum(gm)?, unlimited())?);
    let (q, qd) = (JointVector::<1>::zeros(), JointVector::from([v]));
    let torque = free.step(&ToolReference::at_rest(arm.arm().forward(&q)), &q, &qd).torque;
    let rate = qd.dot(&(arm.mass_matrix(&q) * arm.forward(&q, &qd, &torque)?));
    assert!(rate >= 0.04, "{rate}");
    Ok(())
}

#[test]
fn a_weight_that_is_not_the_arms_puts_energy_in() -> Outcome {
    energy_comes_from_nowhere([0.5, 0.5, 1.0])?;
    let model = counterexample(&CLAIM, "exact-weight")?;
    energy_comes_from_nowhere([model.value("v")?, model.value("g")?, model.value("gm")?])
}

/// Rate of kinetic and spring energy by central differences along the motion.
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

proptest! {
    #![proptest_config(config())]

    // The PUMA-560 with its rotors, pushed at the tool, its reference up to 6 · 0.3 rad away. A central difference with step h leaves
    // h² / 6 of the third derivative: energies E change at rates up to Ω = 1 + |q̇| + sqrt(|q̈|) each time they are differentiated.
    // Roundings of E over h: 1e-16 / 1e-5 = 1e-11, times some hundred.
    #[test]
    fn stored_energy_grows_by_the_pushs_work_less_the_dampers(
        q in joints::<6>(-3.1..3.1), qd in joints::<6>(-1.0..1.0), offset in joints::<6>(-0.3..0.3),
        push in joints::<6>(-20.0..20.0), stiffness in 0.0..1000.0_f64, damping in 0.0..100.0_f64,
    ) {
        let effects = DriveEffects { rotor_inertia: true, friction: false };
        let arm = puma560_dynamics()?.with_effects(effects);
        let [q, qd, offset] = [q, qd, offset].map(JointVector::<6>::from);
        let push = Twist::from(push);
        let gains = |x: f64| ToolGains::new(Vector3::new(x, 0.5 * x, 0.2 * x), 0.1 * x);
        let (k, d) = (gains(stiffness)?, gains(damping)?);
        let desired = ToolReference::at_rest(arm.arm().forward(&(q + offset)));
        let impedance = Impedance::new(arm.clone(), Task::Pose, k, d, unlimited())?;
        let jacobian = arm.arm().jacobian(&q);
        let torque = impedance.step(&desired, &q, &qd).torque + jacobian.transpose() * push;
        let qdd = arm.forward(&q, &qd, &torque)?;
        let h = 1e-5;
        let spring = |q: &JointVector<6>| impedance.energy(&desired, q);
        // Without gravity in the store: what carries the weight does its work.
        let twist = jacobian * qd;
        let rate = stored_rate(&arm, spring, [&q, &qd, &qdd], h);
        let supply = push.dot(&twist) - twist.dot(&d.times(&twist));
        let energy = 1.0 + arm.kinetic_energy(&q, &qd) + spring(&q) + arm.kinetic_energy(&q, &qdd);
        let omega = 1.0 + qd.norm() + qdd.norm().sqrt();
        let slack = energy * (h * h * omega.powi(3) + 1e-9);
        prop_assert!((rate - supply).abs() <= slack, "{rate} {supply} {slack:e}");
        prop_assert!(supply <= push.dot(&twist));
    }
}
