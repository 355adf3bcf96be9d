use nalgebra::Rotation3;
use proptest::prelude::{prop_assert, proptest};
use slideway_proofs::natural_speed::CLAIM;
use slideway_robot::augmented::{PathTangent, SingularityConsistent, SpeedFactor};
use slideway_robot::models::Model;
use slideway_robot::{JointVector, Task, Twist};

use crate::support::{Outcome, config, counterexample, holds, joints, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// The two-joint arm at two elbow angles, `det J = sin q2`, each at its own `b`: equal path speeds, other determinants.
fn varying_b_is_not_proportional([b1, b2]: [f64; 2], [det1, det2]: [f64; 2]) -> Outcome {
    let arm = Model::Planar2R.describe()?.arm::<2>()?;
    let inversion = SingularityConsistent::new(Task::PlanarPosition, SpeedFactor::Determinant, 2)?;
    let tangent = PathTangent { twist: Twist::new(1.0, 0.0, 0.0, 0.0, 0.0, 0.0), slope: Twist::zeros() };
    let path_speed = |b: f64, det: f64| {
        let q = JointVector::<2>::new(0.3, det.asin());
        inversion.flow(&arm, &q, &tangent).motion(b, 0.0).path_speed
    };
    let (s1, s2) = (path_speed(b1, det1), path_speed(b2, det2));
    assert!((s1 - b1 * det1).abs() <= 1e-14 && (s2 - b2 * det2).abs() <= 1e-14);
    assert!(s1 * det2 - s2 * det1 >= 0.04, "{s1} {s2}");
    Ok(())
}

#[test]
fn without_a_constant_b_path_speeds_are_not_as_the_determinants() -> Outcome {
    varying_b_is_not_proportional([1.0, 0.5], [0.4, 0.8])?;
    let model = counterexample(&CLAIM, "constant-b")?;
    let value = |name| model.value(name);
    varying_b_is_not_proportional([value("k1")?, value("k2")?], [value("det1")?, value("det2")?])
}

proptest! {
    #![proptest_config(config())]

    // A circle of the two-joint arm, compared at two places with one b: the tool's speed by finite differences of its
    // position, h² times third derivatives of order ten over six, roundings 1e-16 / h.
    #[test]
    fn tool_speeds_at_two_places_are_as_the_determinants(
        q1 in joints::<2>(-3.0..3.0),
        q2 in joints::<2>(-3.0..3.0),
        angle in -3.0..3.0_f64,
        b in 0.1..3.0_f64,
    ) {
        let arm = Model::Planar2R.describe()?.arm::<2>()?;
        let inversion = SingularityConsistent::new(Task::PlanarPosition, SpeedFactor::Determinant, 2)?;
        let along = Rotation3::from_axis_angle(&nalgebra::Vector3::z_axis(), angle) * nalgebra::Vector3::x();
        let twist = Twist::new(along.x, along.y, 0.0, 0.0, 0.0, 0.0);
        let h = 1e-5;
        let speed = |q: JointVector<2>| {
            let rate = inversion.direction(&arm, &q, &twist).joints * b;
            let at = |k: f64| arm.forward(&(q + rate * (k * h))).translation.vector;
            (at(1.0) - at(-1.0)).norm() / (2.0 * h)
        };
        let (q1, q2) = (JointVector::from(q1), JointVector::from(q2));
        let gap = speed(q1) * q2[1].sin().abs() - speed(q2) * q1[1].sin().abs();
        // Joint speeds up to 3 · 3 rad/s: third derivatives up to 2 · 18³.
        prop_assert!(gap.abs() <= 2.0 * 12_000.0 * h * h / 6.0 + 1e-10, "{gap}");
    }
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
