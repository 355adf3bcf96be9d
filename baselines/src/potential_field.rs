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

/// Two integrations of a step that are this near to each other agree, m: well below the millimetre to which deviations are told.
const AGREED: f64 = 1e-5;

/// Halvings of a step: beyond them the field is too stiff to be followed.
const HALVINGS: u32 = 16;

impl PotentialField {
    /// One sample: `p* = p_ref + f`, then `f` advanced over the sampling period along
    ///
    /// ```text
    /// ḟ = ξ1 (p_ref - p*) + Σ ξ2 (1/ρ_i - 1/ρ0) ρ_i⁻² ∇ρ_i      over the constraints with ρ_i < ρ0
    /// ```
    ///
    /// `ρ_i` is the distance to the boundary to first order, `-σ_i / ‖∇σ_i‖`, and the distance itself where `σ` is one. A single Euler
    /// step where it agrees with two of half the length to 0.01 mm, else such halves, and theirs: close to a boundary the force grows
    /// with `ρ⁻³`, and a step of a whole period would fling the point away. Once a boundary is crossed, or where 2¹⁶ steps do not
    /// follow it, the field has no meaning: `None`.
    pub fn step<const M: usize>(
        &self,
        correction: &mut [f64; 3],
        reference: &Motion<3>,
        constraints: impl Fn(&Motion<3>) -> [ConstraintSample<3>; M],
    ) -> Option<[f64; 3]> {
        let rate = |correction: &[f64; 3]| self.rate(correction, reference, &constraints);
        let position = placed(reference, correction);
        *correction = integrated(correction, self.period, HALVINGS, &rate)?;
        Some(position)
    }

    /// `ḟ`; `None` outside.
    fn rate<const M: usize>(
        &self,
        correction: &[f64; 3],
        reference: &Motion<3>,
        constraints: &impl Fn(&Motion<3>) -> [ConstraintSample<3>; M],
    ) -> Option<[f64; 3]> {
        let position = placed(reference, correction);
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
        Some(force)
    }
}

fn placed(reference: &Motion<3>, correction: &[f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| reference.position[i] + correction[i])
}

/// `f` after a time, by Euler steps that agree with their halves; `None` where no step left does.
fn integrated(
    from: &[f64; 3],
    time: f64,
    halvings: u32,
    rate: &impl Fn(&[f64; 3]) -> Option<[f64; 3]>,
) -> Option<[f64; 3]> {
    // [G12] eq 32
    let euler = |from: &[f64; 3], time: f64| -> Option<[f64; 3]> {
        let rate = rate(from)?;
        Some(std::array::from_fn(|i| from[i] + time * rate[i]))
    };
    let whole = euler(from, time)?;
    let halves = euler(from, 0.5 * time).and_then(|half| euler(&half, 0.5 * time));
    let agree = |other: &[f64; 3]| whole.iter().zip(other).all(|(a, b)| (a - b).abs() <= AGREED);
    // Where a step of this length ends there has to be a field too.
    if halves.as_ref().is_some_and(agree) && rate(&whole).is_some() {
        return Some(whole);
    }
    let left = halvings.checked_sub(1)?;
    integrated(&integrated(from, 0.5 * time, left, rate)?, 0.5 * time, left, rate)
}
