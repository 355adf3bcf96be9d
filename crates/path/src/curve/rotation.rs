use super::error::CurveError;
use super::waypoints::{Spacing, parameters, segment};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use std::ops::Range;

/// A rotation along a path, with its derivatives by the path parameter in the base frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RotationPoint {
    /// The rotation `R(λ)`.
    pub rotation: UnitQuaternion<f64>,
    /// `ω(λ)` with `R' = [ω]× R`, rad.
    pub velocity: Vector3<f64>,
    /// `ω'(λ)`, rad.
    pub acceleration: Vector3<f64>,
}

/// Rotations with increasing path parameters, at least two, neighbours less than half a turn apart.
///
/// A rotation is a quaternion up to its sign: each is held with the sign that is nearer to the one before.
#[derive(Clone, Debug, PartialEq)]
pub struct RotationWaypoints {
    at: Vec<f64>,
    rotations: Vec<UnitQuaternion<f64>>,
}

/// Least angle by which neighbours must stay below half a turn, rad: an angle typed to three decimals does not say which way is meant.
const HALF_TURN_MARGIN: f64 = 1e-3;

/// Departure of a quaternion's length from 1 that is taken for rounding: six decimals.
const UNIT_TOLERANCE: f64 = 1e-6;

/// The rotation of a quaternion `w, x, y, z`, normalised.
///
/// # Errors
///
/// Its length is not 1 within 1e-6.
pub fn unit_quaternion([w, x, y, z]: [f64; 4]) -> Result<UnitQuaternion<f64>, CurveError> {
    let quaternion = Quaternion::new(w, x, y, z);
    let norm = quaternion.norm();
    if (norm - 1.0).abs() <= UNIT_TOLERANCE {
        Ok(UnitQuaternion::new_normalize(quaternion))
    } else {
        Err(CurveError::NotUnit { norm })
    }
}

impl RotationWaypoints {
    /// Rotations spaced over a range of the path parameter; the distance of two rotations is the angle between them.
    ///
    /// # Errors
    ///
    /// Fewer than two rotations, neighbours half a turn apart within 1e-3 rad, numbers that are not finite, path parameters
    /// too few, too many or not increasing, an empty range, equal neighbours where the spacing needs their angle.
    pub fn new(
        mut rotations: Vec<UnitQuaternion<f64>>,
        spacing: &Spacing,
        range: Range<f64>,
    ) -> Result<Self, CurveError> {
        if rotations.len() < 2 {
            return Err(CurveError::TooFew { found: rotations.len() });
        }
        if let Some(index) = rotations.iter().position(|q| !q.coords.iter().all(|x| x.is_finite())) {
            return Err(CurveError::NotFinite { index });
        }
        let angles: Vec<f64> = rotations.windows(2).map(|q| q[0].angle_to(&q[1])).collect();
        if let Some(i) = angles.iter().position(|&a| !(a < std::f64::consts::PI - HALF_TURN_MARGIN)) {
            return Err(CurveError::HalfTurn { before: i, index: i + 1, degrees: angles[i].to_degrees() });
        }
        let at = parameters(spacing, &angles, range)?;
        for i in 1..rotations.len() {
            if rotations[i - 1].coords.dot(&rotations[i].coords) < 0.0 {
                rotations[i] = UnitQuaternion::new_unchecked(-rotations[i].into_inner());
            }
        }
        Ok(Self { at, rotations })
    }

    /// Path parameters, increasing.
    #[must_use]
    pub fn at(&self) -> &[f64] {
        &self.at
    }

    /// The rotations, neighbours with the nearer sign.
    #[must_use]
    pub fn rotations(&self) -> &[UnitQuaternion<f64>] {
        &self.rotations
    }
}

/// Rotations joined by turns about fixed axes at even speed (spherical linear interpolation).
///
/// Between neighbours `R(λ) = exp(ω (λ - λ_i)) R_i` with `ω = log(R_{i+1} R_i⁻¹) / (λ_{i+1} - λ_i)`: the shortest way, `ω`
/// constant on each segment and with a corner at inner way-points.
#[derive(Clone, Debug, PartialEq)]
pub struct Slerp {
    waypoints: RotationWaypoints,
    /// `ω` on each segment, base frame.
    velocities: Vec<Vector3<f64>>,
}

impl Slerp {
    /// Turns between the rotations.
    #[must_use]
    pub fn new(waypoints: RotationWaypoints) -> Self {
        let pairs = waypoints.rotations.windows(2).zip(waypoints.at.windows(2));
        let velocities = pairs.map(|(q, at)| (q[1] * q[0].inverse()).scaled_axis() / (at[1] - at[0])).collect();
        Self { waypoints, velocities }
    }

    /// The rotation at a path parameter, at a corner with the derivatives of the segment that begins there; beyond the ends
    /// the outermost turns go on.
    #[must_use]
    pub fn at(&self, lambda: f64) -> RotationPoint {
        let i = segment(&self.waypoints.at, lambda);
        let velocity = self.velocities[i];
        let turn = UnitQuaternion::from_scaled_axis(velocity * (lambda - self.waypoints.at[i]));
        RotationPoint { rotation: turn * self.waypoints.rotations[i], velocity, acceleration: Vector3::zeros() }
    }

    /// Path parameters of the corners, where the angular velocity jumps.
    #[must_use]
    pub fn kinks(&self) -> Vec<f64> {
        // An angle between two quaternions is known to about 1e-16 rad; a corner that is meant turns by more than 1e-12.
        let inner = self.velocities.windows(2).zip(self.waypoints.at.windows(3));
        inner
            .filter(|(v, at)| (v[1] - v[0]).norm() * (at[1] - at[0]).min(at[2] - at[1]) > 1e-12)
            .map(|(_, at)| at[1])
            .collect()
    }

    /// The rotations.
    #[must_use]
    pub fn waypoints(&self) -> &RotationWaypoints {
        &self.waypoints
    }
}

/// Checks `ω` and `ω'` of a curve of rotations against central differences of the rotation and of `ω`.
#[cfg(test)]
pub(super) fn check_derivatives(curve: impl Fn(f64) -> RotationPoint, lambda: f64, tolerance: f64) {
    let h = 1e-5;
    let (before, point, after) = (curve(lambda - h), curve(lambda), curve(lambda + h));
    let velocity = (after.rotation * before.rotation.inverse()).scaled_axis() / (2.0 * h);
    let acceleration = (after.velocity - before.velocity) / (2.0 * h);
    assert!((velocity - point.velocity).norm() < tolerance, "ω at {lambda}: {velocity} {}", point.velocity);
    assert!(
        (acceleration - point.acceleration).norm() < tolerance,
        "ω' at {lambda}: {acceleration} {}",
        point.acceleration
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    fn turns(vectors: &[[f64; 3]]) -> Vec<UnitQuaternion<f64>> {
        vectors.iter().map(|v| UnitQuaternion::from_scaled_axis(Vector3::from(*v))).collect()
    }

    #[test]
    fn slerp_meets_its_rotations_and_turns_evenly_between_them() {
        let rotations = turns(&[[0.1, 0.2, -0.4], [1.0, -0.5, 0.3], [1.0, -0.5, 2.0]]);
        let waypoints = RotationWaypoints::new(rotations.clone(), &Spacing::Uniform, 0.0..2.0).expect("valid");
        let slerp = Slerp::new(waypoints);
        for (i, rotation) in rotations.iter().enumerate() {
            // A quaternion product rounds at 1e-16.
            assert!(slerp.at(i as f64).rotation.angle_to(rotation) < 1e-14);
        }
        for lambda in [0.1, 0.5, 0.9, 1.3, 1.9] {
            // The rotation is linear in its exponent: only rounding over 2e-5 is left.
            check_derivatives(|l| slerp.at(l), lambda, 1e-10);
        }
        assert_eq!(slerp.kinks(), [1.0]);
    }

    #[test]
    fn the_shortest_way_is_taken_whatever_the_signs_of_the_quaternions() {
        let mut rotations = turns(&[[0.0, 0.0, 0.1], [0.0, 0.0, 0.3], [0.0, 0.0, 0.5]]);
        rotations[1] = UnitQuaternion::new_unchecked(-rotations[1].into_inner());
        let waypoints = RotationWaypoints::new(rotations, &Spacing::Uniform, 0.0..2.0).expect("valid");
        let slerp = Slerp::new(waypoints);
        for lambda in [0.0, 0.7, 1.0, 1.6] {
            assert!((slerp.at(lambda).velocity - Vector3::new(0.0, 0.0, 0.2)).norm() < 1e-14);
        }
        assert!(slerp.kinks().is_empty());
    }

    #[test]
    fn spacing_by_chord_turns_at_even_speed() {
        let rotations = turns(&[[0.0, 0.0, 0.0], [0.0, 0.0, 0.3], [0.0, 0.0, 1.2]]);
        let waypoints = RotationWaypoints::new(rotations, &Spacing::Chord, 0.0..4.0).expect("valid");
        assert!((waypoints.at()[1] - 1.0).abs() < 1e-14);
    }

    #[test]
    fn half_a_turn_between_neighbours_is_refused_with_its_place_and_angle() {
        let pi = std::f64::consts::PI;
        for turn in [pi, pi - 5e-4, -pi + 5e-4, pi + 5e-4] {
            let rotations = turns(&[[0.3, 0.0, 0.0], [0.0; 3], [0.0, turn, 0.0]]);
            let error = RotationWaypoints::new(rotations, &Spacing::Uniform, 0.0..1.0).err();
            let Some(CurveError::HalfTurn { before: 1, index: 2, degrees }) = error else { panic!("{error:?}") };
            assert!((degrees - 180.0).abs() < 0.03);
        }
        let rotations = turns(&[[0.0; 3], [0.0, pi - 2e-3, 0.0]]);
        assert!(RotationWaypoints::new(rotations, &Spacing::Uniform, 0.0..1.0).is_ok());
    }

    #[test]
    fn a_quaternion_is_normalised_within_rounding_and_refused_beyond() {
        let near = unit_quaternion([0.877583, 0.0, 0.479426, 0.0]).expect("six decimals");
        assert!((near.norm() - 1.0).abs() < 1e-15);
        assert!(matches!(unit_quaternion([0.8, 0.0, 0.8, 0.0]), Err(CurveError::NotUnit { .. })));
        assert!(matches!(unit_quaternion([f64::NAN, 0.0, 0.8, 0.0]), Err(CurveError::NotUnit { .. })));
    }
}
