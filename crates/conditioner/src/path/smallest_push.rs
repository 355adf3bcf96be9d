use super::conditioner::PathConditioner;
use super::constraint::{ConstraintSample, Motion};
use super::correction::{NoCorrection, smallest_correction};
use super::evaluated::Evaluated;
use super::law::Push;
use super::outcome::HoldReason;
use super::settings::{PathForm, Reserve, SwitchingLaw};
use super::state::PathState;
use super::vector::{add_scaled, difference, dot, norm, scaled};

/// Linearisations of the constraints within one sample. The first leaves an error of the order of `T` relative to the
/// correction, each further one multiplies it by as much again: two or three suffice at any useful sampling period.
const ROUNDS: usize = 8;

/// Steps straight back inside from a push that has settled just outside of a limit, where the boundary is sharp against the
/// sampling period and the linearisations converge slowly. Newton's method: a violation of `1e-8` is gone after one or two.
const RESTORATIONS: usize = 5;

/// A last change of a `φ_i`, relative to the size of the numbers it is made of, at which the push has converged: what is
/// left of the path is a share `T / 2 K` of it.
const CONVERGED: f64 = 1e-8;

/// Largest violation of a limit that may be left, relative to the same size: some ten roundings of 1e-16 for the sums, times a
/// condition of up to 1e3. A change along the boundary does not show in `φ_i`, so this is asked for separately.
const KEPT: f64 = 1e-12;

impl<const N: usize, const M: usize> PathConditioner<N, M> {
    /// Implicit form and reserve: the smallest additional push over the past interval that keeps every limit.
    #[inline]
    pub(super) fn correct<E>(
        &self,
        state: &mut PathState<N, M>,
        now: &mut Evaluated<N, M>,
        constraints: &E,
    ) -> Result<Push<N, M>, HoldReason>
    where
        E: Fn(&Motion<N>) -> [ConstraintSample<N>; M],
    {
        let (rate, law) = match self.settings.form {
            PathForm::Implicit { recovery_rate } => (recovery_rate, None),
            PathForm::Sliding { law, reserve: Reserve::On { recovery_rate } } => (recovery_rate, Some(law)),
            PathForm::Sliding { reserve: Reserve::Off, .. } | PathForm::Appendix { .. } => {
                return Ok(Push::NONE);
            }
        };
        let fall = rate * self.settings.sampling_period;
        let limits = Limits { law, left: state.beyond.map(|e| (e - fall).max(0.0)) };
        let push = if self.beyond(&limits, now).iter().zip(&limits.left).all(|(beyond, left)| beyond <= left) {
            Push::NONE
        } else {
            let push = self.smallest_push(now, constraints, &limits)?;
            let [position, velocity] = self.filter.reach();
            state.push.first = add_scaled(&state.push.first, position, &push.vector);
            state.push.second = add_scaled(&state.push.second, velocity, &push.vector);
            push
        };
        state.beyond = self.beyond(&limits, now);
        Ok(push)
    }

    /// Height of each `φ_i` plus margin above its band.
    #[inline(always)]
    fn beyond(&self, limits: &Limits<M>, now: &Evaluated<N, M>) -> [f64; M] {
        difference(&now.excess, &self.band(limits.law, &now.samples))
    }

    /// Zero, or the band of the explicit law.
    #[inline(always)]
    fn band(&self, law: Option<SwitchingLaw>, samples: &[ConstraintSample<N>; M]) -> [f64; M] {
        law.map_or([0.0; M], |law| self.full_push(law, samples))
    }

    /// Repeated linearisation: each round projects the origin onto the half-spaces of the constraints linearised at the
    /// last push, until the push no longer changes. `now` moves along.
    fn smallest_push<E>(
        &self,
        now: &mut Evaluated<N, M>,
        constraints: &E,
        limits: &Limits<M>,
    ) -> Result<Push<N, M>, HoldReason>
    where
        E: Fn(&Motion<N>) -> [ConstraintSample<N>; M],
    {
        let free = now.motion;
        let mut push = [0.0; N];
        for round in 1..=ROUNDS {
            let rows = self.rows(&now.samples);
            let mut bounds = self.band(limits.law, &now.samples);
            for (((b, left), e), row) in bounds.iter_mut().zip(&limits.left).zip(&now.excess).zip(&rows) {
                *b += left + dot(row, &push) - e;
            }
            let found = smallest_correction(&rows, &bounds).map_err(not_found)?;
            let sizes = self.sizes(now);
            let change = difference(&found.vector, &push);
            let settled = rows.iter().zip(&sizes).all(|(row, size)| libm::fabs(dot(row, &change)) <= CONVERGED * size);
            push = found.vector;
            *now = self.evaluate(self.pushed(&free, &push), constraints);
            self.check(now)?;
            let kept = self.violations(limits, now, &sizes) == [0.0; M];
            if settled && (kept || round == ROUNDS) {
                let share = shares(&rows, &found.multipliers);
                let vector = if kept { push } else { self.restored(&free, push, now, constraints, limits)? };
                return Ok(Push { vector, share });
            }
        }
        Err(HoldReason::CorrectionNotFound)
    }

    /// By how much each limit is violated; zero where it is kept to [`KEPT`].
    #[inline(always)]
    fn violations(&self, limits: &Limits<M>, now: &Evaluated<N, M>, sizes: &[f64; M]) -> [f64; M] {
        let mut violations = difference(&self.beyond(limits, now), &limits.left);
        for (violation, size) in violations.iter_mut().zip(sizes) {
            // Written so that a NaN is a violation.
            if *violation <= KEPT * size {
                *violation = 0.0;
            }
        }
        violations
    }

    /// The smallest changes of a push until it keeps every limit. Each aims as far inside as it starts outside, and farther
    /// the oftener that was not enough: what curves the boundary, or narrows the band, may take most of it away.
    #[cold]
    fn restored<E>(
        &self,
        free: &Motion<N>,
        mut push: [f64; N],
        now: &mut Evaluated<N, M>,
        constraints: &E,
        limits: &Limits<M>,
    ) -> Result<[f64; N], HoldReason>
    where
        E: Fn(&Motion<N>) -> [ConstraintSample<N>; M],
    {
        let mut aim = 1.0;
        for _ in 0..RESTORATIONS {
            let sizes = self.sizes(now);
            let violations = self.violations(limits, now, &sizes);
            let mut bounds = difference(&limits.left, &self.beyond(limits, now));
            for (bound, violation) in bounds.iter_mut().zip(&violations) {
                *bound = if *violation > 0.0 { -(1.0 + aim) * violation } else { bound.max(0.0) };
            }
            let change = smallest_correction(&self.rows(&now.samples), &bounds).map_err(not_found)?;
            push = add_scaled(&push, 1.0, &change.vector);
            *now = self.evaluate(self.pushed(free, &push), constraints);
            self.check(now)?;
            if self.violations(limits, now, &sizes) == [0.0; M] {
                return Ok(push);
            }
            aim *= 2.0;
        }
        Err(HoldReason::CorrectionNotFound)
    }

    fn pushed(&self, motion: &Motion<N>, push: &[f64; N]) -> Motion<N> {
        let [position, velocity] = self.filter.reach();
        Motion {
            time: motion.time,
            position: add_scaled(&motion.position, position, push),
            velocity: add_scaled(&motion.velocity, velocity, push),
        }
    }

    /// `∂φ_i/∂u = (γ1 + K γ2) ∇σ_i + K γ1 d∇σ_i/dt`.
    fn rows(&self, samples: &[ConstraintSample<N>; M]) -> [[f64; N]; M] {
        let [position, _] = self.filter.reach();
        let mut rows = [[0.0; N]; M];
        for ((row, sample), &k) in rows.iter_mut().zip(samples).zip(&self.settings.approach) {
            *row = add_scaled(&scaled(self.per_push(k), &sample.gradient), k * position, &sample.gradient_rate);
        }
        rows
    }

    /// Sizes of the numbers that each `φ_i` is a sum of.
    fn sizes(&self, now: &Evaluated<N, M>) -> [f64; M] {
        let (place, speed) = (norm(&now.motion.position), norm(&now.motion.velocity));
        let mut sizes = self.settings.approach;
        for (size, s) in sizes.iter_mut().zip(&now.samples) {
            *size = libm::fabs(s.value) + norm(&s.gradient) * (place + *size * speed);
        }
        sizes
    }
}

fn not_found(reason: NoCorrection) -> HoldReason {
    match reason {
        NoCorrection::Contradiction(i) => HoldReason::Contradiction(i),
        NoCorrection::Cycling => HoldReason::CorrectionNotFound,
    }
}

/// Upper bounds of each `φ_i` plus margin at this sample.
struct Limits<const M: usize> {
    /// The explicit law whose band counts; none for the implicit form.
    law: Option<SwitchingLaw>,
    /// Excess over its band that each may still have: the last sample's less the recovery; zero from inside.
    left: [f64; M],
}

/// Share of each row in the push: `λ_i ‖g_i‖`, normalised.
fn shares<const N: usize, const M: usize>(rows: &[[f64; N]; M], multipliers: &[f64; M]) -> [f64; M] {
    let mut parts = *multipliers;
    for (part, row) in parts.iter_mut().zip(rows) {
        *part *= norm(row);
    }
    let total: f64 = parts.iter().sum();
    parts.map(|p| if total > 0.0 { p / total } else { 0.0 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::settings::{Margin, PathSettings};

    #[test]
    fn shares_are_those_of_the_parts_of_the_push() {
        // Parts λ ‖g‖ of 5 and 15.
        assert_eq!(shares(&[[3.0, 4.0], [0.0, 2.0]], &[1.0, 7.5]), [0.25, 0.75]);
        assert_eq!(shares(&[[3.0, 4.0], [0.0, 2.0]], &[0.0, 0.0]), [0.0, 0.0]);
    }

    #[test]
    fn sizes_are_those_of_the_terms_of_phi() {
        let settings = PathSettings {
            sampling_period: 0.01,
            push_cutoff: 20.0,
            approach: [0.5, 0.25],
            margin: Margin::None,
            form: PathForm::Implicit { recovery_rate: 1.0 },
            trap: None,
        };
        let conditioner = PathConditioner::<2, 2>::new(settings).expect("valid settings");
        // ‖p‖ = 5, ‖ṗ‖ = 2: |σ| + ‖∇σ‖ (‖p‖ + K ‖ṗ‖).
        let motion = Motion { time: 0.0, position: [3.0, -4.0], velocity: [0.0, -2.0] };
        let sample = |value, gradient| ConstraintSample {
            value,
            gradient,
            time_rate: 0.0,
            gradient_rate: [0.0; 2],
            time_rate_rate: 0.0,
        };
        let now = conditioner.evaluate(motion, &|_: &Motion<2>| [sample(-7.0, [8.0, 6.0]), sample(1.0, [0.0, -3.0])]);
        assert_eq!(conditioner.sizes(&now), [7.0 + 10.0 * 6.0, 1.0 + 3.0 * 5.5]);
    }
}
