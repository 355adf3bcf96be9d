use nalgebra::{Matrix2, Vector2};
use slideway_conditioner::path::{ConstraintSample, Motion};

use super::SmallestPush;

/// Parameters of the filter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FilterSettings<const M: usize> {
    /// Sampling period `T`, s.
    pub period: f64,
    /// Cutoff frequency `α1` of the push filter, rad/s.
    pub cutoff: f64,
    /// Approach time `K_i` of each constraint, s: the barrier's rate is `1 / K`.
    pub approach: [f64; M],
    /// Linearisations per sample; one is the usual filter, four solve the nonlinear program to rounding.
    pub rounds: usize,
}

/// Reason why a sample has no answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum FilterError {
    /// The quadratic program has no solution, or the solver found none.
    #[error("the quadratic program of a sample was not solved")]
    Unsolved,
}

/// The control-barrier safety filter on the same push filter as the conditioner.
///
/// ```text
/// min ‖u‖²   subject to   φ_i(t_k; u) <= 0,   φ_i = σ_i + K_i σ̇_i
/// ```
///
/// `u` is held over the interval that ends at `t_k`. Written apart from the conditioner on purpose: the hold comes from a
/// matrix exponential, the program is solved by whatever `S` is.
pub struct QpFilter<const N: usize, const M: usize, S> {
    settings: FilterSettings<M>,
    transition: Matrix2<f64>,
    input: Vector2<f64>,
    correction: [Vector2<f64>; N],
    solver: S,
}

impl<const N: usize, const M: usize, S: SmallestPush> QpFilter<N, M, S> {
    /// A filter at rest on the reference.
    #[must_use]
    pub fn new(settings: FilterSettings<M>, solver: S) -> Self {
        let a = settings.cutoff;
        let dynamics = Matrix2::new(0.0, 1.0, -a * a, -std::f64::consts::SQRT_2 * a);
        let transition = (dynamics * settings.period).exp();
        // A constant input u has the equilibrium (u, 0): what is not remembered is what comes in.
        let input = (Matrix2::identity() - transition) * Vector2::new(1.0, 0.0);
        Self { settings, transition, input, correction: [Vector2::zeros(); N], solver }
    }

    /// One sample: advances the correction under the smallest admissible push and gives `p*` and `ṗ*`.
    ///
    /// # Errors
    ///
    /// [`FilterError::Unsolved`]; the state is left as it was.
    pub fn step(
        &mut self,
        reference: &Motion<N>,
        constraints: impl Fn(&Motion<N>) -> [ConstraintSample<N>; M],
    ) -> Result<Motion<N>, FilterError> {
        let free = self.correction.map(|x| self.transition * x);
        let mut push = [0.0; N];
        for _ in 0..self.settings.rounds {
            let motion = self.motion(reference, &free, &push);
            let (rows, bounds) = self.linearise(&constraints(&motion), &motion, &push);
            let found = self.solver.smallest(&rows, &bounds).ok_or(FilterError::Unsolved)?;
            for (u, found) in push.iter_mut().zip(found) {
                *u = found;
            }
        }
        for ((x, free), u) in self.correction.iter_mut().zip(&free).zip(&push) {
            *x = free + self.input * *u;
        }
        Ok(self.motion(reference, &free, &push))
    }

    fn motion(&self, reference: &Motion<N>, free: &[Vector2<f64>; N], push: &[f64; N]) -> Motion<N> {
        let now: [Vector2<f64>; N] = std::array::from_fn(|i| free[i] + self.input * push[i]);
        Motion {
            time: reference.time,
            position: std::array::from_fn(|i| reference.position[i] + now[i].x),
            velocity: std::array::from_fn(|i| reference.velocity[i] + now[i].y),
        }
    }

    /// `φ_i(u) ≈ φ_i + ∂φ_i/∂u (u - u_0) <= 0`.
    fn linearise(
        &self,
        samples: &[ConstraintSample<N>; M],
        motion: &Motion<N>,
        push: &[f64; N],
    ) -> (Vec<Vec<f64>>, Vec<f64>) {
        let mut rows = Vec::with_capacity(M);
        let mut bounds = Vec::with_capacity(M);
        for (s, &k) in samples.iter().zip(&self.settings.approach) {
            let row: Vec<f64> = (0..N)
                .map(|i| self.input.x * (s.gradient[i] + k * s.gradient_rate[i]) + self.input.y * k * s.gradient[i])
                .collect();
            bounds.push(row.iter().zip(push).map(|(r, u)| r * u).sum::<f64>() - s.phi(k, &motion.velocity));
            rows.push(row);
        }
        (rows, bounds)
    }
}
