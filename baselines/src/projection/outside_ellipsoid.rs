//! Projection onto the outside of an ellipsoid: the set of `[G12]` example 9.2.

use super::{Projection, ProjectionError, distance};

/// `‖D⁻¹ (x - c)‖ >= 1` with semi-axes `D`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutsideEllipsoid<const N: usize> {
    /// Centre.
    pub centre: [f64; N],
    /// Semi-axes.
    pub semi_axes: [f64; N],
}

impl<const N: usize> OutsideEllipsoid<N> {
    /// `1 - ‖D⁻¹ (x - c)‖`.
    #[must_use]
    pub fn violation(&self, x: &[f64; N]) -> f64 {
        1.0 - (0..N).map(|i| ((x[i] - self.centre[i]) / self.semi_axes[i]).powi(2)).sum::<f64>().sqrt()
    }

    /// The nearest point of the set, from one root of a monotone function.
    ///
    /// With `y = x - c`, `q = p - c` a stationary point is `y_i = q_i a_i² / (a_i² - t)`. It is the global optimum if
    /// `0 <= t <= a_min²`, for then the Lagrangian `‖y - q‖² - t (Σ y²/a² - 1)` is convex and its minimum bounds every
    /// feasible point. On that interval `Σ y²/a²` grows with `t`: one root, or, if it stays below 1 at the end, the rest
    /// goes into the shortest axis (the hard case, `q = 0` along that axis).
    ///
    /// # Errors
    ///
    /// [`ProjectionError::NotFinite`].
    pub fn project(&self, p: &[f64; N]) -> Result<Projection<N>, ProjectionError> {
        if !p.iter().all(|x| x.is_finite()) {
            return Err(ProjectionError::NotFinite);
        }
        if self.violation(p) <= 0.0 {
            return Ok(Projection { point: *p, distance: 0.0, lower_bound: 0.0, violation: self.violation(p) });
        }
        let q: [f64; N] = std::array::from_fn(|i| p[i] - self.centre[i]);
        let shortest = self.semi_axes.iter().fold(f64::INFINITY, |a, &b| a.min(b));
        let end = shortest * shortest;
        let (mut low, mut high) = (0.0, end);
        // Bisection to the last bit: each round halves the interval.
        while low < 0.5 * (low + high) && 0.5 * (low + high) < high {
            let t = 0.5 * (low + high);
            if self.level(&self.stationary(&q, t)) <= 1.0 { low = t } else { high = t }
        }
        let mut y = self.stationary(&q, low);
        let missing = 1.0 - self.level(&y);
        if let Some(i) = (0..N).find(|&i| self.semi_axes[i] == shortest && q[i] == 0.0)
            && missing > 0.0
        {
            y[i] = shortest * missing.sqrt();
        }
        let point: [f64; N] = std::array::from_fn(|i| y[i] + self.centre[i]);
        let dual = self.dual(&q, low);
        Ok(Projection {
            point,
            distance: distance(p, &point),
            lower_bound: dual.max(0.0).sqrt(),
            violation: self.violation(&point),
        })
    }

    fn stationary(&self, q: &[f64; N], t: f64) -> [f64; N] {
        std::array::from_fn(|i| {
            let square = self.semi_axes[i] * self.semi_axes[i];
            if q[i] == 0.0 { 0.0 } else { q[i] * square / (square - t) }
        })
    }

    fn level(&self, y: &[f64; N]) -> f64 {
        (0..N).map(|i| (y[i] / self.semi_axes[i]).powi(2)).sum()
    }

    /// Minimum over `y` of the Lagrangian at `t`: no feasible point has a smaller squared distance.
    fn dual(&self, q: &[f64; N], t: f64) -> f64 {
        // Σ (y - q)² - t y²/a² at the stationary point is -Σ q² t / (a² - t).
        let bent: f64 = (0..N)
            .map(|i| if q[i] == 0.0 { 0.0 } else { q[i] * q[i] * t / (self.semi_axes[i] * self.semi_axes[i] - t) })
            .sum();
        t - bent
    }
}
