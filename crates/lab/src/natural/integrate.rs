use nalgebra::SMatrix;
use slideway_path::ProblemError;

/// State of an integration: `K` joint vectors, the path parameter and a clock.
#[derive(Clone, Copy)]
pub(super) struct State<const N: usize, const K: usize> {
    pub(super) joints: SMatrix<f64, N, K>,
    pub(super) parameter: f64,
    pub(super) clock: f64,
}

impl<const N: usize, const K: usize> State<N, K> {
    fn moved(&self, rate: &Self, h: f64) -> Self {
        Self {
            joints: self.joints + rate.joints * h,
            parameter: self.parameter + rate.parameter * h,
            clock: self.clock + rate.clock * h,
        }
    }

    /// One step of the classical Runge-Kutta method, error of order `h⁵`.
    ///
    /// # Errors
    ///
    /// [`ProblemError::NoFiniteSpeed`] if the step does not end at finite numbers; whatever the rate returns.
    pub(super) fn step(
        &self,
        h: f64,
        rate: impl Fn(&Self) -> Result<Self, ProblemError>,
    ) -> Result<Self, ProblemError> {
        let first = rate(self)?;
        let second = rate(&self.moved(&first, 0.5 * h))?;
        let third = rate(&self.moved(&second, 0.5 * h))?;
        let fourth = rate(&self.moved(&third, h))?;
        let next = self.moved(&first, h / 6.0).moved(&second, h / 3.0).moved(&third, h / 3.0).moved(&fourth, h / 6.0);
        let finite = next.joints.iter().chain([&next.parameter, &next.clock]).all(|x| x.is_finite());
        if finite { Ok(next) } else { Err(ProblemError::NoFiniteSpeed { at: self.parameter }) }
    }
}
