//! Control in the space of the tool, on random arms and on the PUMA-560.

mod support;

use nalgebra::{Matrix3, Vector3};
use proptest::prelude::*;
use slideway_motion::control::task_space::{
    GuardedJoint, JointGuard, OperationalSettings, OperationalSpace, RateController, RateLaw, ToolFeedback, ToolGains,
    ToolReference, ToolState, VirtualMass, pose_error,
};
use slideway_motion::control::{SensorMotion, WristSensor};
use slideway_robot::{
    Dynamics, GRAVITY, InverseMethod, JointVector, LinkInertia, PositionRange, SerialArm, Task, Twist, models,
};
use support::{REACH, arm, vector};

fn gains(linear: f64) -> ToolGains {
    ToolGains::uniform(linear, linear).expect("not negative")
}

fn unlimited<const N: usize>() -> JointVector<N> {
    JointVector::from_element(f64::INFINITY)
}

fn space(dynamics: Dynamics<3>, largest_inertia: f64) -> OperationalSpace<3> {
    let settings = OperationalSettings { length: 1.0, largest_inertia, posture_damping: 0.0 };
    OperationalSpace::new(dynamics, Task::Position, settings, unlimited()).expect("sound settings")
}

fn linear(v: [f64; 3]) -> Twist {
    Twist::new(v[0], v[1], v[2], 0.0, 0.0, 0.0)
}

fn position_jacobian(arm: &SerialArm<3>, q: &JointVector<3>) -> Matrix3<f64> {
    arm.jacobian(q).fixed_rows::<3>(0).into_owned()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    /// The twin inverts `J M⁻¹ Jᵀ` as it is printed.
    #[test]
    fn away_from_singularities_the_tool_accelerates_as_asked(
        dynamics in arm(), q in vector::<3>(3.0), qd in vector::<3>(1.0), a in prop::array::uniform3(-3.0..3.0_f64)
    ) {
        let jacobian = position_jacobian(dynamics.arm(), &q);
        prop_assume!(jacobian.determinant().abs() > 1e-3);
        let mass = dynamics.mass_matrix(&q);
        let inverse_inertia = jacobian * mass.try_inverse().expect("regular") * jacobian.transpose();
        let heaviest = 1.0 / inverse_inertia.symmetric_eigenvalues().min();
        prop_assume!(heaviest < 1e5);
        let acceleration = linear(a);
        let output = space(dynamics.clone(), 1e6).step(&q, &qd, &acceleration, &Twist::zeros());
        let bias = dynamics.arm().bias_acceleration(&q, &qd);
        let qdd = dynamics.forward(&q, &qd, &output.torque).expect("a mass matrix");
        let reached = (jacobian * qdd + bias.fixed_rows::<3>(0)) - acceleration.fixed_rows::<3>(0);
        let inertia = inverse_inertia.try_inverse().expect("regular");
        let force = inertia * (acceleration - bias).fixed_rows::<3>(0);
        let twin = jacobian.transpose() * force + dynamics.coriolis_torque(&q, &qd) + dynamics.gravity_torque(&q);
        // Both lose the digits of an inertia of up to 1e5 kg over the lightest, about 0.1: 1e6 roundings of 1e-16 in each of some
        // ten sums, of forces as large as the torque.
        let size = 1.0 + output.torque.amax() + force.amax();
        prop_assert!((output.torque - twin).amax() <= 1e-9 * size, "{}", (output.torque - twin).amax());
        prop_assert!(reached.amax() <= 1e-9 * size && output.shortfall.amax() <= 1e-9 * size, "{reached}");
    }

    #[test]
    fn near_a_singularity_acceleration_and_shortfall_are_bounded(
        dynamics in arm(), q in vector::<3>(3.0), a in prop::array::uniform3(-3.0..3.0_f64), heaviest in 1.0..50.0_f64
    ) {
        let acceleration = linear(a);
        let rest = JointVector::zeros();
        let output = space(dynamics.clone(), heaviest).step(&q, &rest, &acceleration, &Twist::zeros());
        let qdd = dynamics.forward(&q, &rest, &output.torque).expect("a mass matrix");
        let energy_norm = (2.0 * dynamics.kinetic_energy(&q, &qdd)).sqrt();
        prop_assert!(energy_norm <= heaviest.sqrt() * acceleration.norm() * (1.0 + 1e-9), "{energy_norm}");
        prop_assert!(output.shortfall.norm() <= acceleration.norm() * (1.0 + 1e-9));
        // And it is what the arm misses.
        let reached = position_jacobian(dynamics.arm(), &q) * qdd;
        let missed = acceleration.fixed_rows::<3>(0) - reached;
        prop_assert!((missed - output.shortfall.fixed_rows::<3>(0)).amax() <= 1e-9 * (1.0 + acceleration.norm()));
    }

    /// Accelerations held over each sample, whatever is wanted; the peak between samples is in closed form.
    #[test]
    fn guarded_joints_stay_in_their_range_between_samples_too(
        wanted in prop::collection::vec((-200.0..200.0_f64, 1..40_u32), 1..30),
        deceleration in 1.0..50.0_f64, period in 1e-4..2e-2_f64, start in -0.99..0.99_f64
    ) {
        let range = PositionRange { lower: -1.0, upper: 1.0 };
        let guard = JointGuard::new([Some(GuardedJoint { range, deceleration })], period).expect("sound");
        let (mut q, mut v) = (start, 0.0_f64);
        for (wanted, samples) in wanted {
            for _ in 0..samples {
                let (held, _) = guard.hold_back(&[q].into(), &[v].into(), &[wanted].into());
                let a = held[0];
                let turns = -v / a;
                let peak = if turns > 0.0 && turns < period { q + 0.5 * v * turns } else { q };
                q += period * (v + 0.5 * period * a);
                v += period * a;
                // A sample's rounding of 1e-16 grows by the square root at the stop: v is good to sqrt(2 a 1e-16) = 1e-7 there.
                prop_assert!(peak.abs() <= 1.0 + 1e-9 && q.abs() <= 1.0 + 1e-9, "{q} {v} {peak}");
                prop_assert!(a.abs() <= deceleration * (1.0 + 1e-6) || a == wanted || a * v >= -1e-9 , "{a} {v}");
            }
        }
    }

    /// `V = ½ eᵀ K e` under `q̇ = Jᵀ K e` for periods inside `0.1 / (k (r² + r |e|))`, with the reach `r`: to first order the step takes
    /// `T |Jᵀ K e|²`, the rest is at most `T² |q̇|² k (|J|² + |e| |∂J|)/2`, both norms below `3 r²` and `3 r`, which is a third of it.
    #[test]
    fn transpose_control_never_raises_its_potential(
        dynamics in arm(), q in vector::<3>(3.0), goal in vector::<3>(3.0), k in 0.1..10.0_f64
    ) {
        let kinematics = dynamics.arm().clone();
        let desired = ToolReference::at_rest(kinematics.forward(&goal));
        let controller = RateController::new(
            kinematics.clone(), Task::Position, RateLaw::Transpose, gains(k), JointVector::from_element(2.0),
        ).expect("sound");
        let potential = |q: &JointVector<3>| {
            let error = Task::Position.select(&pose_error(&desired.pose, &kinematics.forward(q)));
            gains(k).energy(&error)
        };
        let period = 0.1 / (k * (REACH * REACH + REACH * 2.0 * REACH));
        let mut q = q;
        for _ in 0..200 {
            let before = potential(&q);
            let output = controller.step(&desired, &q);
            prop_assert!(output.rates.amax() <= 2.0 * (1.0 + 1e-15));
            q += output.rates * period;
            prop_assert!(potential(&q) <= before * (1.0 + 1e-14));
        }
    }

    #[test]
    fn the_pseudo_inverse_makes_the_error_die_out_at_its_gain(
        dynamics in arm(), q in vector::<3>(3.0), goal in vector::<3>(3.0), k in 0.1..10.0_f64
    ) {
        let jacobian = position_jacobian(dynamics.arm(), &q);
        prop_assume!(jacobian.determinant().abs() > 1e-3);
        let law = RateLaw::PseudoInverse(InverseMethod::TruncatedSvd { cutoff: 1e-9 });
        let kinematics = dynamics.arm().clone();
        let desired = ToolReference::at_rest(kinematics.forward(&goal));
        let controller =
            RateController::new(kinematics.clone(), Task::Position, law, gains(k), unlimited()).expect("sound");
        let rate = jacobian * controller.step(&desired, &q).rates;
        let error = pose_error(&desired.pose, &kinematics.forward(&q)).fixed_rows::<3>(0).into_owned();
        // A determinant of 1e-3 at lengths of 1.75 m bounds the condition number by 1e4.
        prop_assert!((rate - error * k).amax() <= 1e-11 * (1.0 + k));
    }

    /// The twin: what the joints have to carry more with the load than without it.
    #[test]
    fn the_wrist_sensor_feels_what_the_joints_carry(
        dynamics in arm(), q in vector::<3>(3.0), qd in vector::<3>(2.0), qdd in vector::<3>(5.0),
        mass in 0.1..3.0_f64, com in prop::array::uniform3(-0.1..0.1_f64), touch in vector::<6>(10.0)
    ) {
        let inertia = Matrix3::from_diagonal(&Vector3::new(1e-3, 2e-3, 2.5e-3));
        let load = LinkInertia { mass, com: Vector3::from(com), inertia };
        let sensor = WristSensor::new(load, GRAVITY).expect("a rigid body");
        let motion = SensorMotion::of(dynamics.arm(), &q, &qd, &qdd);
        let mut links = *dynamics.links();
        links[2] = links[2].joined(&load.seen_from(dynamics.arm().tool()));
        let loaded = Dynamics::new(dynamics.arm().clone(), links).expect("rigid bodies");
        let carried = loaded.inverse(&q, &qd, &qdd) - dynamics.inverse(&q, &qd, &qdd);
        let felt = sensor.external(&Twist::zeros(), &motion);
        let torque = dynamics.arm().jacobian(&q).transpose() * felt;
        // Differences of torques of a few hundred N·m.
        prop_assert!((torque - carried).amax() <= 1e-11, "{torque} {carried}");
        let external = sensor.external(&sensor.sensed(&touch, &motion), &motion);
        prop_assert!((external - touch).amax() <= 1e-12);
    }

    /// Pushed in any direction the tool moves as the mass chosen, away from singularities.
    #[test]
    fn a_virtual_mass_obeys_its_equation(
        dynamics in arm(), q in vector::<3>(3.0), qd in vector::<3>(0.5), push in prop::array::uniform3(-10.0..10.0_f64),
        offset in prop::array::uniform3(-0.1..0.1_f64)
    ) {
        let jacobian = position_jacobian(dynamics.arm(), &q);
        prop_assume!(jacobian.determinant().abs() > 1e-2);
        let law = VirtualMass::new(gains(4.0), gains(300.0), gains(60.0)).expect("positive");
        let actual = ToolState::of(dynamics.arm(), &q, &qd);
        let mut pose = actual.pose;
        pose.translation.vector += Vector3::from(offset);
        let external = linear(push);
        let desired = ToolReference::at_rest(pose);
        let torque = law.step(&space(dynamics.clone(), 1e6), &desired, [&q, &qd], &external).torque;
        let pushed = torque + dynamics.arm().jacobian(&q).transpose() * external;
        let qdd = dynamics.forward(&q, &qd, &pushed).expect("a mass matrix");
        let reached = jacobian * qdd + dynamics.arm().bias_acceleration(&q, &qd).fixed_rows::<3>(0);
        let velocity = actual.twist.fixed_rows::<3>(0).into_owned();
        let wanted = (Vector3::from(push) + Vector3::from(offset) * 300.0 - velocity * 60.0) / 4.0;
        // Effective inertias up to 1e4 kg, as above.
        prop_assert!((reached - wanted).amax() <= 1e-8 * (1.0 + wanted.amax()), "{reached} {wanted}");
    }
}

#[test]
fn feedback_of_the_tool_pulls_towards_its_reference() {
    let feedback = ToolFeedback { proportional: gains(100.0), derivative: gains(20.0) };
    let arm = models::puma560();
    let actual = ToolState::of(&arm, &JointVector::from_element(0.3), &JointVector::zeros());
    let mut pose = actual.pose;
    pose.translation.vector.x += 0.1;
    let acceleration = feedback.acceleration(&ToolReference::at_rest(pose), &actual);
    assert!((acceleration - linear([10.0, 0.0, 0.0])).amax() < 1e-12, "{acceleration}");
}

#[test]
fn nan_asks_for_no_torque_and_no_speed() {
    let dynamics = models::puma560_dynamics().expect("the built-in arm");
    let settings = OperationalSettings { length: 0.3, largest_inertia: 50.0, posture_damping: 2.0 };
    let space = OperationalSpace::new(dynamics.clone(), Task::Pose, settings, unlimited()).expect("sound settings");
    let q = JointVector::from_element(f64::NAN);
    let output = space.step(&q, &JointVector::zeros(), &Twist::zeros(), &Twist::zeros());
    assert!(output.torque == JointVector::<6>::zeros() && output.cut == [true; 6]);
    let rates = RateController::new(dynamics.arm().clone(), Task::Pose, RateLaw::Transpose, gains(1.0), unlimited())
        .expect("sound");
    let desired = ToolReference::at_rest(dynamics.arm().forward(&JointVector::zeros()));
    assert!(rates.step(&desired, &q).rates == JointVector::<6>::zeros());
    let bad = OperationalSettings { largest_inertia: 0.0, ..settings };
    assert!(OperationalSpace::new(dynamics, Task::Pose, bad, unlimited()).is_err());
}
