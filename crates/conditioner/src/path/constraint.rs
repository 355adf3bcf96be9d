use super::vector::finite;

/// A point in motion: where the reference or the conditioned reference is, and how fast it moves.
///
/// The space is whatever the caller conditions in: metres in a work space, radians in a joint space (`[G12] 5.3`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<const N: usize> {
    /// Time of the sample, s. Only moving constraints look at it.
    pub time: f64,
    /// Position `p`.
    pub position: [f64; N],
    /// Velocity `ṗ`, per second.
    pub velocity: [f64; N],
}

impl<const N: usize> Motion<N> {
    /// True if time, position and velocity are all finite.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        self.time.is_finite() && finite(&self.position) && finite(&self.velocity)
    }
}

/// One constraint `σ(p, t) <= 0` evaluated at one motion: all that a conditioner ever learns about it.
///
/// `σ` and its gradient serve the explicit forms; the reserve, the implicit form and the safe walk also use the two rates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConstraintSample<const N: usize> {
    /// `σ(p, t)`: positive outside the allowed set.
    pub value: f64,
    /// `∇σ(p, t)`, derivative by the position.
    pub gradient: [f64; N],
    /// `∂σ/∂t` at a fixed position, per second: 0 for a constraint that stands still.
    pub time_rate: f64,
    /// `H ṗ + ∂∇σ/∂t`, the rate of the gradient along the motion, per second.
    pub gradient_rate: [f64; N],
    /// `∂²σ/∂t² + (∂∇σ/∂t)ᵀ ṗ`, the rate of `time_rate` along the motion: 0 for a constraint that stands still.
    pub time_rate_rate: f64,
}

impl<const N: usize> ConstraintSample<N> {
    /// `σ̇ = ∇σᵀ ṗ + ∂σ/∂t`.
    #[inline(always)]
    #[must_use]
    pub fn rate(&self, velocity: &[f64; N]) -> f64 {
        super::vector::dot(&self.gradient, velocity) + self.time_rate
    }

    /// `φ = σ + K σ̇`, `[G12] eq 3`, with the explicit dependence on time of `[G12] 5.4`.
    #[inline(always)]
    #[must_use]
    pub fn phi(&self, approach: f64, velocity: &[f64; N]) -> f64 {
        // [G12] eq 3
        self.value + approach * self.rate(velocity)
    }
}

/// A constraint that can be evaluated at any motion.
///
/// [`crate::shapes`] has the common ones; a caller's own (a typed expression, a link of the robot seen from joint space)
/// implements this or hands the conditioner a closure.
pub trait Constraint<const N: usize> {
    /// `σ` and its derivatives at `motion`.
    ///
    /// Where `σ` is not differentiable the gradient is reported as zero, which the conditioner treats as empty.
    // [G12] eq 2: allowed is where no value is positive.
    fn sample(&self, motion: &Motion<N>) -> ConstraintSample<N>;
}

/// Evaluates a list of constraints at one motion: what [`crate::PathConditioner::step`] wants from its closure.
#[inline(always)]
pub fn sample_all<const N: usize, const M: usize>(
    constraints: &[&dyn Constraint<N>; M],
    motion: &Motion<N>,
) -> [ConstraintSample<N>; M] {
    constraints.map(|constraint| constraint.sample(motion))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_motion_is_finite_only_with_all_its_parts() {
        let good = Motion { time: 1.0, position: [2.0, 3.0], velocity: [4.0, 5.0] };
        assert!(good.is_finite());
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(!Motion { time: bad, ..good }.is_finite());
            assert!(!Motion { position: [2.0, bad], ..good }.is_finite());
            assert!(!Motion { velocity: [bad, 5.0], ..good }.is_finite());
        }
    }

    /// A wall `2 x <= 0.6 t` seen at 3 s from `x = 0.5`, which runs after it.
    #[test]
    fn rate_and_phi_count_the_motion_of_point_and_wall() {
        let (time, x, speed, approach) = (3.0, 0.5, [0.7, -9.0], 0.25);
        let wall = ConstraintSample {
            value: 2.0 * x - 0.6 * time,
            gradient: [2.0, 0.0],
            time_rate: -0.6,
            gradient_rate: [0.0; 2],
            time_rate_rate: 0.0,
        };
        // The gap closes by 2 * 0.7 - 0.6 = 0.8 per second, a quarter second ahead -0.8 + 0.25 * 0.8 = -0.6 is left.
        assert!((wall.rate(&speed) - 0.8).abs() < 1e-15);
        assert!((wall.phi(approach, &speed) + 0.6).abs() < 1e-15);
    }
}
