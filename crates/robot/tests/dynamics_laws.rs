//! Laws that the dynamics of every arm obeys, on random chains of revolute and prismatic joints.

use nalgebra::{Matrix3, Rotation3, Translation3, Unit, Vector3};
use proptest::prelude::*;
use slideway_robot::{
    Drive, DriveEffects, Dynamics, Friction, Joint, JointKind, JointVector, LinkInertia, MassMatrix, Pose, SerialArm,
};

const N: usize = 5;

type Numbers = [f64; N];

fn vector3() -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-1.0..1.0_f64).prop_map(Vector3::from)
}

fn joint() -> impl Strategy<Value = Joint> {
    (vector3(), vector3(), vector3(), any::<bool>()).prop_map(|(shift, turn, axis, slides)| Joint {
        origin: Pose::from_parts(Translation3::from(shift), Rotation3::from_scaled_axis(turn * 3.0)),
        axis: Unit::try_new(axis, 1e-3).unwrap_or_else(Vector3::x_axis),
        kind: if slides { JointKind::Prismatic } else { JointKind::Revolute },
        offset: shift.x,
    })
}

/// A rigid body: any symmetric positive definite matrix does as far as these laws go.
fn link() -> impl Strategy<Value = LinkInertia> {
    (0.1..2.0_f64, vector3(), vector3(), prop::array::uniform3(0.01..0.5_f64)).prop_map(|(mass, com, turn, moments)| {
        let turn = Rotation3::from_scaled_axis(turn * 3.0).into_inner();
        let inertia = turn * Matrix3::from_diagonal(&moments.into()) * turn.transpose();
        LinkInertia { mass, com: com * 0.5, inertia: (inertia + inertia.transpose()) * 0.5 }
    })
}

fn dynamics() -> impl Strategy<Value = Dynamics<N>> {
    (prop::array::uniform5(joint()), prop::array::uniform5(link()), prop::array::uniform5(0.0..1.0_f64)).prop_map(
        |(joints, links, extra)| {
            let drives = extra.map(|x| Drive {
                reflected_inertia: x,
                friction: Friction { viscous: 0.3 * x, forward: 0.5 * x, backward: 0.7 * x },
            });
            Dynamics::new(SerialArm::new(joints, Pose::identity()), links)
                .and_then(|d| d.with_drives(drives))
                .expect("rigid bodies")
        },
    )
}

fn vector() -> impl Strategy<Value = JointVector<N>> {
    prop::array::uniform5(-2.0..2.0_f64).prop_map(|v: Numbers| JointVector::from(v))
}

const ALL: DriveEffects = DriveEffects { rotor_inertia: true, friction: true };

/// The naive twin of the mass matrix: one inverse dynamics per column.
fn mass_by_columns(arm: &Dynamics<N>, q: &JointVector<N>) -> MassMatrix<N> {
    let still = arm.clone().with_gravity(Vector3::zeros());
    let mut matrix = MassMatrix::<N>::zeros();
    for j in 0..N {
        let mut unit = JointVector::<N>::zeros();
        unit[j] = 1.0;
        matrix.set_column(j, &still.inverse(q, &JointVector::<N>::zeros(), &unit));
    }
    matrix
}

/// `d/dh M(q + h q̇)` by central differences.
fn mass_rate(arm: &Dynamics<N>, q: &JointVector<N>, qd: &JointVector<N>) -> MassMatrix<N> {
    let h = 1e-5;
    (arm.mass_matrix(&(q + qd * h)) - arm.mass_matrix(&(q - qd * h))) / (2.0 * h)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn composite_mass_matrix_equals_its_naive_twin_and_is_symmetric_positive_definite(arm in dynamics(), q in vector()) {
        for arm in [arm.clone(), arm.with_effects(DriveEffects { rotor_inertia: true, friction: false })] {
            let mass = arm.mass_matrix(&q);
            let naive = mass_by_columns(&arm, &q);
            // Positions within 10 m, moments of size 1e3: some hundred roundings of 1e-16 relative to the largest entry.
            prop_assert!((mass - naive).norm() <= 1e-13 * mass.norm());
            prop_assert_eq!(mass, mass.transpose());
            prop_assert!(mass.cholesky().is_some());
        }
    }

    #[test]
    fn inverse_dynamics_is_affine_in_the_acceleration_with_the_mass_matrix_as_slope(
        arm in dynamics(), q in vector(), qd in vector(), a in vector(), b in vector(),
    ) {
        let arm = arm.with_effects(ALL);
        let difference = arm.inverse(&q, &qd, &a) - arm.inverse(&q, &qd, &b);
        let mass = arm.mass_matrix(&q);
        let size = arm.inverse(&q, &qd, &a).norm() + arm.inverse(&q, &qd, &b).norm() + mass.norm();
        prop_assert!((difference - mass * (a - b)).norm() <= 1e-12 * size);
    }

    #[test]
    fn torque_is_the_sum_of_its_parts(arm in dynamics(), q in vector(), qd in vector(), qdd in vector()) {
        let arm = arm.with_effects(ALL);
        let sum = arm.mass_matrix(&q) * qdd + arm.coriolis_torque(&q, &qd) + arm.gravity_torque(&q) + arm.friction(&qd);
        prop_assert!((sum - arm.inverse(&q, &qd, &qdd)).norm() <= 1e-12 * (1.0 + sum.norm() + arm.mass_matrix(&q).norm()));
    }

    #[test]
    fn forward_dynamics_undoes_inverse_dynamics(arm in dynamics(), q in vector(), qd in vector(), qdd in vector()) {
        let arm = arm.with_effects(ALL);
        let torque = arm.inverse(&q, &qd, &qdd);
        let found = arm.forward(&q, &qd, &torque).expect("positive definite");
        // A backward stable solve loses the condition of M, bounded by norm over smallest eigenvalue.
        let mass = arm.mass_matrix(&q);
        let condition = mass.norm() / mass.symmetric_eigenvalues().min();
        prop_assert!((found - qdd).norm() <= 1e-14 * condition * (1.0 + torque.norm() / mass.norm() + qdd.norm()));
    }

    #[test]
    fn power_of_the_torque_is_the_rate_of_the_energy(arm in dynamics(), q in vector(), qd in vector(), qdd in vector()) {
        let h = 1e-5;
        let energy = |t: f64| {
            let (q, qd) = (q + qd * t + qdd * (0.5 * t * t), qd + qdd * t);
            arm.kinetic_energy(&q, &qd) + arm.potential_energy(&q)
        };
        let rate = (energy(h) - energy(-h)) / (2.0 * h);
        let power = arm.inverse(&q, &qd, &qdd).dot(&qd);
        // Rounding 1e-16 E / h plus h² times a third derivative: 1e-10 of what the energy and its rates are made of.
        let size = energy(0.0).abs() + arm.kinetic_energy(&q, &qd) + 100.0 + power.abs();
        prop_assert!((rate - power).abs() <= 1e-6 * size, "{rate} and {power}");
    }

    #[test]
    fn coriolis_torque_takes_the_half_of_the_mass_rate_that_does_no_work(arm in dynamics(), q in vector(), qd in vector()) {
        // q̇ᵀ (Ṁ - 2C) q̇ = 0 with c = C q̇.
        let work = qd.dot(&(mass_rate(&arm, &q, &qd) * qd)) - 2.0 * qd.dot(&arm.coriolis_torque(&q, &qd));
        prop_assert!(work.abs() <= 1e-7 * (1.0 + arm.mass_matrix(&q).norm() * qd.norm().powi(3)), "{work}");
    }

    #[test]
    fn coriolis_torque_is_that_of_the_christoffel_symbols(arm in dynamics(), q in vector(), qd in vector()) {
        // c_i = (Ṁ q̇)_i - ½ q̇ᵀ (∂M/∂q_i) q̇
        let along = mass_rate(&arm, &q, &qd) * qd;
        let expected = JointVector::<N>::from_fn(|i, _| {
            let mut unit = JointVector::<N>::zeros();
            unit[i] = 1.0;
            along[i] - 0.5 * qd.dot(&(mass_rate(&arm, &q, &unit) * qd))
        });
        let size = 1.0 + arm.mass_matrix(&q).norm() * qd.norm_squared() * 10.0;
        prop_assert!((expected - arm.coriolis_torque(&q, &qd)).norm() <= 1e-7 * size);
    }

    #[test]
    fn gravity_torque_is_the_slope_of_the_potential_energy(arm in dynamics(), q in vector(), d in vector()) {
        let h = 1e-5;
        let slope = (arm.potential_energy(&(q + d * h)) - arm.potential_energy(&(q - d * h))) / (2.0 * h);
        let torque = arm.gravity_torque(&q);
        prop_assert!((slope - torque.dot(&d)).abs() <= 1e-7 * (100.0 + torque.norm() * d.norm()));
    }

    #[test]
    fn friction_always_takes_power(arm in dynamics(), qd in vector()) {
        let friction = arm.clone().with_effects(ALL).friction(&qd);
        prop_assert!((0..N).all(|i| friction[i] * qd[i] >= 0.0));
        prop_assert_eq!(arm.friction(&qd), JointVector::<N>::zeros(), "off by default");
    }

    #[test]
    fn a_link_cut_in_two_and_joined_again_moves_as_before(a in link(), b in link(), turn in vector3(), shift in vector3()) {
        let frame = Pose::from_parts(Translation3::from(shift), Rotation3::from_scaled_axis(turn));
        let (before, after) = (a.joined(&b).seen_from(&frame), a.seen_from(&frame).joined(&b.seen_from(&frame)));
        prop_assert!((before.com - after.com).norm() < 1e-14 * 10.0);
        prop_assert!((before.inertia - after.inertia).norm() < 1e-13 * before.inertia.norm());
    }
}

#[test]
fn a_pendulum_and_an_elevator_have_the_textbook_torques() {
    let joint = |kind, axis| Joint { origin: Pose::identity(), axis, kind, offset: 0.0 };
    let rod = LinkInertia { mass: 2.0, com: Vector3::new(0.5, 0.0, 0.0), inertia: Matrix3::from_diagonal_element(0.1) };
    // Turning about -y lifts the rod along x: τ = (I + m l²) q̈ + m g l cos q.
    let pendulum = SerialArm::new([joint(JointKind::Revolute, -Vector3::y_axis())], Pose::identity());
    let torque = Dynamics::new(pendulum, [rod]).expect("a rod").inverse(&[0.3].into(), &[7.0].into(), &[2.0].into());
    assert!((torque[0] - (0.6 * 2.0 + 2.0 * 9.81 * 0.5 * 0.3_f64.cos())).abs() < 1e-12);
    let elevator = SerialArm::new([joint(JointKind::Prismatic, Vector3::z_axis())], Pose::identity());
    let force = Dynamics::new(elevator, [rod]).expect("a rod").inverse(&[0.3].into(), &[7.0].into(), &[2.0].into());
    assert!((force[0] - 2.0 * (9.81 + 2.0)).abs() < 1e-12);
}

#[test]
fn links_and_drives_that_no_machine_has_are_refused_with_their_place() {
    let joint = Joint { origin: Pose::identity(), axis: Vector3::z_axis(), kind: JointKind::Revolute, offset: 0.0 };
    let arm = SerialArm::new([joint; 2], Pose::identity());
    let rod = LinkInertia { mass: 1.0, com: Vector3::zeros(), inertia: Matrix3::identity() };
    let skewed = Matrix3::new(1.0, 0.5, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);
    for (bad, says) in [
        (LinkInertia { mass: -1.0, ..rod }, "link 2: its mass is -1"),
        (LinkInertia { mass: f64::NAN, ..rod }, "link 2: its mass is NaN"),
        (LinkInertia { inertia: -Matrix3::identity(), ..rod }, "negative principal moment"),
        (LinkInertia { inertia: skewed, ..rod }, "not symmetric"),
        (LinkInertia { com: Vector3::new(f64::NAN, 0.0, 0.0), ..rod }, "not finite"),
    ] {
        let error = Dynamics::new(arm.clone(), [rod, bad]).expect_err("no rigid body");
        assert!(error.to_string().contains(says), "{error}");
    }
    let drive = Drive { reflected_inertia: -0.1, ..Drive::default() };
    let error = Dynamics::new(arm, [rod; 2]).and_then(|d| d.with_drives([Drive::default(), drive]));
    assert!(error.expect_err("negative").to_string().contains("joint 2: its reflected inertia is -0.1"));
}

#[test]
fn an_arm_without_mass_has_no_forward_dynamics_and_nan_none_either() {
    let joint = Joint { origin: Pose::identity(), axis: Vector3::z_axis(), kind: JointKind::Revolute, offset: 0.0 };
    let arm = SerialArm::new([joint], Pose::identity());
    let empty = Dynamics::new(arm.clone(), [LinkInertia::default()]).expect("massless");
    assert!(empty.forward(&[0.0].into(), &[0.0].into(), &[1.0].into()).is_err());
    let rod = LinkInertia { mass: 1.0, com: Vector3::zeros(), inertia: Matrix3::identity() };
    let arm = Dynamics::new(arm, [rod]).expect("a rod");
    assert!(arm.forward(&[f64::NAN].into(), &[0.0].into(), &[1.0].into()).is_err());
    assert!(arm.forward(&[0.0].into(), &[0.0].into(), &[f64::INFINITY].into()).is_err());
}
