//! The conventional potential field of `[G12] eq 31-34`.

use slideway_conditioner::path::{ConstraintSample, Motion};

/// Parameters of the field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PotentialField {
    /// Sampling period, s.
    pub period: f64,
    /// Attraction `ξ1`, 1/s.
    pub attraction: f64,
    /// Repulsion `ξ2`, m⁴/s.
    pub repulsion: f64,
    /// Distance of influence `ρ0`, m.
    pub influence: f64,
}

impl PotentialField {
    /// One sample: `p* = p_ref + f`, then `f` advanced by an Euler step of
    ///
    /// ```text
    /// ḟ = ξ1 (p_ref - p*) + Σ ξ2 (1/ρ_i - 1/ρ0) ρ_i⁻² ∇ρ_i      over the constraints with ρ_i < ρ0
    /// ```
    ///
    /// `ρ_i` is the distance to the boundary to first order, `-σ_i / ‖∇σ_i‖`, and the distance itself where `σ` is one.
    /// Once a boundary is crossed the field has no meaning: `None`.
    pub fn step<const M: usize>(
        &self,
        correction: &mut [f64; 3],
        reference: &Motion<3>,
        constraints: impl Fn(&Motion<3>) -> [ConstraintSample<3>; M],
    ) -> Option<[f64; 3]> {
        let mut position = reference.position;
        for (p, f) in position.iter_mut().zip(correction.iter()) {
            *p += f;
        }
        // [G12] eq 33: attraction; the sum of both forces is [G12] eq 31.
        let mut force = correction.map(|f| -self.attraction * f);
        for sample in constraints(&Motion { position, ..*reference }) {
            let steepness = sample.gradient.iter().map(|g| g * g).sum::<f64>().sqrt();
            let distance = -sample.value / steepness;
            if distance.is_nan() || distance <= 0.0 {
                return None;
            }
            if distance < self.influence {
                // [G12] eq 34
                let strength = self.repulsion * (1.0 / distance - 1.0 / self.influence) / (distance * distance);
                for (f, g) in force.iter_mut().zip(&sample.gradient) {
                    *f -= strength * g / steepness;
                }
            }
        }
        // [G12] eq 32, over one sample.
        for (c, f) in correction.iter_mut().zip(&force) {
            *c += self.period * f;
        }
        Some(position)
    }
}
