//! The orientation convention of `[G11]`: `R = Rz(α) Ry(β) Rx(γ)`, triples kept continuous.

use nalgebra::{Matrix3, Rotation3, Vector3};
use std::f64::consts::{PI, TAU};

/// Roll-pitch-yaw triple `[α, β, γ]` in rad: `R = Rz(α) Ry(β) Rx(γ)`.
pub type EulerAngles = Vector3<f64>;

/// The rotation of a triple.
#[must_use]
pub fn rotation(euler: &EulerAngles) -> Rotation3<f64> {
    Rotation3::from_axis_angle(&Vector3::z_axis(), euler[0])
        * Rotation3::from_axis_angle(&Vector3::y_axis(), euler[1])
        * Rotation3::from_axis_angle(&Vector3::x_axis(), euler[2])
}

/// The map from Euler rates to angular velocity in the base frame, `ω = E(α, β) [α̇, β̇, γ̇]`.
///
/// Its determinant is `-cos β`: it exists everywhere, its inverse does not at `β = ±π/2`.
#[must_use]
pub fn rate_map(euler: &EulerAngles) -> Matrix3<f64> {
    let (sa, ca) = euler[0].sin_cos();
    let (sb, cb) = euler[1].sin_cos();
    Matrix3::new(0.0, -sa, ca * cb, 0.0, ca, sa * cb, 1.0, 0.0, -sb)
}

/// Angular acceleration that constant Euler rates produce: `Ė(α, β) [α̇, β̇, γ̇]`.
#[must_use]
pub fn rate_map_bias(euler: &EulerAngles, rates: &Vector3<f64>) -> Vector3<f64> {
    let (sa, ca) = euler[0].sin_cos();
    let (sb, cb) = euler[1].sin_cos();
    let (da, db) = (rates[0], rates[1]);
    let rate = Matrix3::new(
        0.0,
        -ca * da,
        -sa * cb * da - ca * sb * db,
        0.0,
        -sa * da,
        ca * cb * da - sa * sb * db,
        0.0,
        0.0,
        -cb * db,
    );
    rate * rates
}

/// `|cos β|` below which `α` and `γ` cannot be told apart from a rotation matrix.
///
/// At `|cos β| = c` the entries that `α` is read from are of size `c` and carry a rounding of about 1e-16, hence an error
/// of `1e-16 / c` in the angle; keeping the previous `α` instead makes an error of the order of its change over a
/// sample. At 1e-9 the former is 1e-7 rad, well below any tolerance in use.
const GIMBAL: f64 = 1e-9;

/// The triple of a rotation that lies nearest to `previous`.
///
/// Every rotation has two families of triples, `(α, β, γ)` and `(α + π, π - β, γ + π)`, each up to whole turns.
/// At `β = ±π/2` only `α ∓ γ` is determined: `α` is kept from `previous`.
#[must_use]
pub fn nearest(rotation: &Rotation3<f64>, previous: &EulerAngles) -> EulerAngles {
    let r = rotation.matrix();
    let cos_beta = r[(0, 0)].hypot(r[(1, 0)]);
    let beta = (-r[(2, 0)]).atan2(cos_beta);
    let (alpha, gamma) = if cos_beta > GIMBAL {
        (r[(1, 0)].atan2(r[(0, 0)]), r[(2, 1)].atan2(r[(2, 2)]))
    } else {
        // Rz(-α) R = Ry(β) Rx(γ) has [0, cos γ, -sin γ] as its second row.
        let (sa, ca) = previous[0].sin_cos();
        let second = Vector3::new(-sa, ca, 0.0).transpose() * r;
        (previous[0], (-second[2]).atan2(second[1]))
    };
    let first = nearest_turns(&EulerAngles::new(alpha, beta, gamma), previous);
    let second = nearest_turns(&EulerAngles::new(alpha + PI, PI - beta, gamma + PI), previous);
    if (first - previous).norm_squared() <= (second - previous).norm_squared() { first } else { second }
}

/// Shifts each angle by whole turns to lie nearest to its predecessor.
fn nearest_turns(euler: &EulerAngles, previous: &EulerAngles) -> EulerAngles {
    euler.zip_map(previous, |angle, before| angle - TAU * ((angle - before) / TAU).round())
}
