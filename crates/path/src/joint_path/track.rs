//! The joint path of a redundant arm: the motion along `q'(λ) = J⁺ [f'; E rates]` from its start.
//!
//! Its joints are not a function of the place on the tool path: they depend on the way there. It is integrated by the classical Runge-Kutta method of fourth order over
//! the steps in which the path was traced, and every point is moved onto the tool path by Newton's method.

use super::hermite::Derivatives;
use super::tracing::{configuration, derivatives};
use crate::path_problem::PathProblem;
use crate::reference::reference::ToolReference;
use slideway_robot::JointVector;

/// A stretch of that motion.
pub(super) struct Track<'a, const N: usize> {
    problem: &'a PathProblem<N>,
    tool: &'a ToolReference,
    /// Path parameters, increasing.
    at: &'a [f64],
    /// Configurations there.
    q: Vec<JointVector<N>>,
}

/// Share of a step over which the second derivative is a difference of first ones. Steps are a hundredth of where anything changes or less: the error is
/// 1e-10 of it, and 1e-5 at the ends, where the difference is taken to one side.
const DIFFERENCE: f64 = 1e-3;

impl<'a, const N: usize> Track<'a, N> {
    /// The motion from a configuration at the first of some path parameters; the place where it breaks.
    pub(super) fn new(
        problem: &'a PathProblem<N>,
        tool: &'a ToolReference,
        at: &'a [f64],
        start: JointVector<N>,
    ) -> Result<Self, f64> {
        let mut track = Self { problem, tool, at, q: vec![start] };
        for (i, &next) in at.iter().enumerate().skip(1) {
            let q = track.onto(next, &track.step(at[i - 1], next, &track.q[i - 1])).ok_or(next)?;
            track.q.push(q);
        }
        Ok(track)
    }

    /// Its last configuration.
    pub(super) fn end(&self) -> Option<JointVector<N>> {
        self.q.last().copied()
    }

    /// The motion's point at a path parameter.
    pub(super) fn at(&self, lambda: f64) -> Option<Derivatives<N>> {
        let i = self.at.partition_point(|at| *at <= lambda).clamp(1, self.at.len() - 1) - 1;
        let q = self.onto(lambda, &self.step(self.at[i], lambda, &self.q[i]))?;
        let by = DIFFERENCE * (self.at[i + 1] - self.at[i]);
        let rate = |to: f64| self.rate(to, &self.step(lambda, to, &q));
        let middle = lambda.max(self.at[0] + by).min(self.at[self.at.len() - 1] - by);
        let second = (rate(middle + by) - rate(middle - by)) / (2.0 * by);
        Some(Derivatives { q, first: self.rate(lambda, &q), second })
    }

    fn onto(&self, lambda: f64, q: &JointVector<N>) -> Option<JointVector<N>> {
        configuration(self.problem, self.tool, lambda, q).ok()
    }

    fn rate(&self, lambda: f64, q: &JointVector<N>) -> JointVector<N> {
        derivatives(self.problem, self.tool, lambda, q).0
    }

    /// One step of Runge and Kutta.
    fn step(&self, from: f64, to: f64, q: &JointVector<N>) -> JointVector<N> {
        let h = to - from;
        let middle = from + 0.5 * h;
        let k1 = self.rate(from, q);
        let k2 = self.rate(middle, &(q + k1 * (0.5 * h)));
        let k3 = self.rate(middle, &(q + k2 * (0.5 * h)));
        let k4 = self.rate(to, &(q + k3 * h));
        q + (k1 + (k2 + k3) * 2.0 + k4) * (h / 6.0)
    }
}
