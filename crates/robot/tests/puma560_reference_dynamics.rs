//! Dynamics of the PUMA-560 against the twenty reference rows.

use nalgebra::Matrix6;
use serde_json::Value;
use slideway_robot::{DriveEffects, JointVector, models};

fn rows() -> Vec<Value> {
    let data: Value = serde_json::from_str(include_str!("puma560_dynamics.json")).expect("valid JSON");
    let rows = data["rows"].as_array().expect("rows").clone();
    assert_eq!(rows.len(), 20);
    rows
}

fn vector(row: &Value, key: &str) -> JointVector<6> {
    let numbers = row[key].as_array().unwrap_or_else(|| panic!("no {key}"));
    JointVector::from_iterator(numbers.iter().map(|x| x.as_f64().expect("number")))
}

fn matrix(row: &Value, key: &str) -> Matrix6<f64> {
    let lines = row[key].as_array().unwrap_or_else(|| panic!("no {key}"));
    Matrix6::from_fn(|i, j| lines[i][j].as_f64().expect("number"))
}

const RIGID: DriveEffects = DriveEffects { rotor_inertia: false, friction: false };
const ROTORS: DriveEffects = DriveEffects { rotor_inertia: true, friction: false };
const ALL: DriveEffects = DriveEffects { rotor_inertia: true, friction: true };

#[test]
fn inverse_dynamics_agree_to_1e_10_rigid_with_rotors_and_with_friction() {
    let puma = models::puma560_dynamics().expect("valid parameters");
    for row in rows() {
        let [q, qd, qdd] = ["q", "qd", "qdd"].map(|key| vector(&row, key));
        for (effects, key) in
            [(RIGID, "tau_rnea_rigid"), (ROTORS, "tau_rnea_armature"), (ALL, "tau_rtb_full_with_friction")]
        {
            let expected = vector(&row, key);
            let torque = puma.clone().with_effects(effects).inverse(&q, &qd, &qdd);
            assert!((torque - expected).norm() <= 1e-10 * expected.norm(), "{key}: {torque} for {expected}");
        }
    }
}

#[test]
fn mass_matrices_agree_to_1e_10_with_and_without_rotors() {
    let puma = models::puma560_dynamics().expect("valid parameters");
    for row in rows() {
        let q = vector(&row, "q");
        for (effects, key) in [(RIGID, "M_rigid"), (ROTORS, "M_armature")] {
            let expected = matrix(&row, key);
            let mass = puma.clone().with_effects(effects).mass_matrix(&q);
            assert!((mass - expected).norm() <= 1e-10 * expected.norm(), "{key}");
            // The wrist's entries are a thousand times smaller than the shoulder's: each diagonal entry by itself.
            for i in 0..6 {
                assert!((mass[(i, i)] - expected[(i, i)]).abs() <= 1e-10 * expected[(i, i)], "{key} {i}");
            }
        }
    }
}

#[test]
fn gravity_coriolis_and_friction_torques_agree_to_1e_10() {
    let puma = models::puma560_dynamics().expect("valid parameters").with_effects(ALL);
    for row in rows() {
        let (q, qd) = (vector(&row, "q"), vector(&row, "qd"));
        let close =
            |found: JointVector<6>, expected: JointVector<6>| (found - expected).norm() <= 1e-10 * expected.norm();
        assert!(close(puma.gravity_torque(&q), vector(&row, "gravity_torque")));
        assert!(close(puma.coriolis_torque(&q, &qd), vector(&row, "coriolis_torque")));
        // The reference counts friction as a torque on the joint, here it is what the motor spends on it.
        assert!(close(puma.friction(&qd), -vector(&row, "friction_rtb_friction_of_qd")));
    }
}

#[test]
fn forward_dynamics_agree_to_1e_8_rigid_with_rotors_and_with_friction() {
    let puma = models::puma560_dynamics().expect("valid parameters");
    for row in rows() {
        let [q, qd, torque] = ["q", "qd", "tau_in"].map(|key| vector(&row, key));
        for (effects, key) in
            [(RIGID, "qdd_fd_rigid"), (ROTORS, "qdd_fd_armature"), (ALL, "qdd_fd_rtb_full_with_friction")]
        {
            let expected = vector(&row, key);
            let found = puma.clone().with_effects(effects).forward(&q, &qd, &torque).expect("positive definite");
            assert!((found - expected).norm() <= 1e-8 * expected.norm(), "{key}: {found} for {expected}");
        }
    }
}
