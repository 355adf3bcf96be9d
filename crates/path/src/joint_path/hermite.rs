//! The quintic between two points of a joint path with tangents and curvatures.

use nalgebra::SVector;
use slideway_robot::JointVector;

/// A polynomial of degree 5 in the distance `σ` from its first point.
#[derive(Clone, Debug)]
pub(super) struct Quintic<const N: usize> {
    /// Its length in `σ`.
    pub(super) length: f64,
    pub(super) powers: [JointVector<N>; 6],
}

/// Position with first and second derivative by a parameter.
#[derive(Clone, Copy, Debug)]
pub(super) struct Derivatives<const N: usize> {
    pub(super) q: JointVector<N>,
    pub(super) first: JointVector<N>,
    pub(super) second: JointVector<N>,
}

/// Steps of a search whose error shrinks by a power each step.
const STEPS: usize = 8;

impl<const N: usize> Quintic<N> {
    /// The quintic with given ends, whose parameter is length: its speed at the ends is 1, and its length such that it is 1 in the middle too,
    /// which leaves a difference of the sixth order. `weights` make speeds of one joint comparable with those of another.
    pub(super) fn between(a: &Derivatives<N>, b: &Derivatives<N>, weights: &JointVector<N>) -> Self {
        let chord = b.q - a.q;
        let shortest = chord.component_mul(weights).norm();
        let mut length = shortest;
        for _ in 0..STEPS {
            // p'(h / 2) = 15/8 chord/h - 7/16 (t0 + t1) + h/32 (k1 - k0); its first part is what the length changes.
            let rest = (a.first + b.first) * (-7.0 / 16.0) + (b.second - a.second) * (length / 32.0);
            let middle = (chord * (15.0 / (8.0 * length)) + rest).component_mul(weights).norm();
            length *= 1.0 + 8.0 / 15.0 * (middle - 1.0);
        }
        // An arc is longer than its chord, and a cell of a spline not twice as long; elsewhere the chord does.
        let usable = length >= 0.999 * shortest && length <= 2.0 * shortest;
        Self::with_length(a, b, if usable { length } else { shortest })
    }

    fn with_length(a: &Derivatives<N>, b: &Derivatives<N>, h: f64) -> Self {
        let (v0, v1) = (a.first * h, b.first * h);
        let (w0, w1) = (a.second * (h * h), b.second * (h * h));
        let d = b.q - a.q;
        let cubic = d * 10.0 - v0 * 6.0 - v1 * 4.0 - w0 * 1.5 + w1 * 0.5;
        let quartic = d * -15.0 + v0 * 8.0 + v1 * 7.0 + w0 * 1.5 - w1;
        let quintic = d * 6.0 - (v0 + v1) * 3.0 + (w1 - w0) * 0.5;
        let powers = [a.q, a.first, a.second * 0.5, cubic / h.powi(3), quartic / h.powi(4), quintic / h.powi(5)];
        Self { length: h, powers }
    }

    pub(super) fn at(&self, t: f64) -> Derivatives<N> {
        let zero = SVector::zeros();
        let (mut q, mut first, mut second) = (zero, zero, zero);
        for c in self.powers.iter().rev() {
            second = second * t + first * 2.0;
            first = first * t + q;
            q = q * t + c;
        }
        Derivatives { q, first, second }
    }

    /// The point nearest to a configuration, in the weighted distance, by Newton's method from a share of the length.
    pub(super) fn nearest(&self, q: &JointVector<N>, share: f64, weights: &JointVector<N>) -> Derivatives<N> {
        let mut t = share * self.length;
        for _ in 0..STEPS {
            let here = self.at(t);
            let away = (here.q - q).component_mul(weights);
            let along = here.first.component_mul(weights);
            let step = away.dot(&along) / along.norm_squared();
            if !step.is_finite() {
                break;
            }
            t = (t - step).clamp(0.0, self.length);
        }
        self.at(t)
    }
}

impl<const N: usize> Derivatives<N> {
    /// The same point by length: the direction of travel and its change, at right angles to it in the weighted sense; and the speed that is divided out.
    pub(super) fn by_length(&self, weights: &JointVector<N>) -> (Self, f64) {
        let weighted = self.first.component_mul(weights);
        let speed = weighted.norm();
        let along = self.second.component_mul(weights).dot(&weighted) / (speed * speed);
        let second = (self.second - self.first * along) / (speed * speed);
        (Self { q: self.q, first: self.first / speed, second }, speed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector2;

    #[test]
    fn a_quintic_meets_its_ends_and_follows_an_arc_to_the_sixth_order() {
        let weights = Vector2::new(1.0, 0.5);
        // A circle in the weighted sense, by its angle.
        let arc = |a: f64| Derivatives {
            q: Vector2::new(a.cos(), 2.0 * a.sin()),
            first: Vector2::new(-a.sin(), 2.0 * a.cos()),
            second: Vector2::new(-a.cos(), -2.0 * a.sin()),
        };
        let mut errors = Vec::new();
        for angle in [0.4, 0.2] {
            let quintic = Quintic::between(&arc(0.0), &arc(angle), &weights);
            let end = quintic.at(quintic.length);
            assert!((end.q - arc(angle).q).norm() + (end.first - arc(angle).first).norm() < 1e-13);
            assert!((end.second - arc(angle).second).norm() < 1e-11);
            // The length is the angle to the sixth order, with a constant below 1e-2.
            assert!((quintic.length / angle - 1.0).abs() < 1e-2 * angle.powi(6), "{}", quintic.length);
            errors.push((quintic.nearest(&arc(0.3 * angle).q, 0.25, &weights).q - arc(0.3 * angle).q).norm());
        }
        assert!(errors[0] < 1e-7 && errors[0] / errors[1] > 50.0, "{errors:?}");
    }
}
