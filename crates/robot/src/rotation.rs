use nalgebra::{Rotation3, Vector3};

/// The rotation vector (axis times angle, rad) of a rotation, accurate for small angles.
///
/// The antisymmetric part of `R` is `sin θ` times the axis and its trace `1 + 2 cos θ`; taking the angle from the trace
/// alone, as an arc cosine, would lose half of the digits near zero. Near half a turn the axis comes from nalgebra.
#[must_use]
pub fn rotation_vector(rotation: &Rotation3<f64>) -> Vector3<f64> {
    let r = rotation.matrix();
    let sine = Vector3::new(r[(2, 1)] - r[(1, 2)], r[(0, 2)] - r[(2, 0)], r[(1, 0)] - r[(0, 1)]) * 0.5;
    let cosine = (r.trace() - 1.0) * 0.5;
    let norm = sine.norm();
    if cosine < 0.0 && norm < 1e-4 {
        return rotation.scaled_axis();
    }
    // atan2(x, c) / x tends to 1 at x = 0.
    if norm > 0.0 { sine * (norm.atan2(cosine) / norm) } else { sine }
}
