use crate::{DhRow, SerialArm};
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
