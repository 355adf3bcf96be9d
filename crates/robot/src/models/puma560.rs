use crate::{DhRow, Drive, Dynamics, DynamicsError, Friction, LinkInertia, SerialArm};
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::FRAC_PI_2;

/// The PUMA-560 of `[G11]`: standard DH, base frame at the shoulder, tool at the wrist centre.
///
/// Lengths as in Corke's Robotics Toolbox; the pedestal's height (0.67183 m) is left out, as in the paper.
#[must_use]
pub fn puma560() -> SerialArm<6> {
    let row = |a, alpha, d| DhRow { a, alpha, d, offset: 0.0 };
    let rows = [
        row(0.0, FRAC_PI_2, 0.0),
        row(0.4318, 0.0, 0.0),
        row(0.0203, -FRAC_PI_2, 0.15005),
        row(0.0, FRAC_PI_2, 0.4318),
        row(0.0, -FRAC_PI_2, 0.0),
        row(0.0, 0.0, 0.0),
    ];
    SerialArm::from_finite_dh(rows)
}

/// The PUMA-560 with masses, rotors and friction: Armstrong, Khatib and Burdick 1986, as collected in Corke's Robotics
/// Toolbox. No payload.
///
/// # Errors
///
/// None with the numbers below; the check of [`Dynamics::new`] is not bypassed.
pub fn puma560_dynamics() -> Result<Dynamics<6>, DynamicsError> {
    let link = |mass, [x, y, z]: [f64; 3], [xx, yy, zz]: [f64; 3]| LinkInertia {
        mass,
        com: Vector3::new(x, y, z),
        inertia: Matrix3::from_diagonal(&Vector3::new(xx, yy, zz)),
    };
    let links = [
        link(0.0, [0.0, 0.0, 0.0], [0.0, 0.35, 0.0]),
        link(17.4, [-0.3638, 0.006, 0.2275], [0.13, 0.524, 0.539]),
        link(4.8, [-0.0203, -0.0141, 0.070], [0.066, 0.086, 0.0125]),
        link(0.82, [0.0, 0.019, 0.0], [1.8e-3, 1.3e-3, 1.8e-3]),
        link(0.34, [0.0, 0.0, 0.0], [0.3e-3, 0.4e-3, 0.3e-3]),
        link(0.09, [0.0, 0.0, 0.032], [0.15e-3, 0.15e-3, 0.04e-3]),
    ];
    // Gear ratio, rotor inertia, and on the motor's side viscous and Coulomb friction forward and backward.
    let drive =
        |gear, rotor, viscous, forward, backward| Drive::geared(gear, rotor, Friction { viscous, forward, backward });
    let drives = [
        drive(-62.6111, 200e-6, 1.48e-3, 0.395, 0.435),
        drive(107.815, 200e-6, 0.817e-3, 0.126, 0.071),
        drive(-53.7063, 200e-6, 1.38e-3, 0.132, 0.105),
        drive(76.0364, 33e-6, 71.2e-6, 11.2e-3, 16.9e-3),
        drive(71.923, 33e-6, 82.6e-6, 9.26e-3, 14.5e-3),
        drive(76.686, 33e-6, 36.7e-6, 3.96e-3, 10.5e-3),
    ];
    Dynamics::from_dh_links(puma560(), links)?.with_drives(drives)
}
