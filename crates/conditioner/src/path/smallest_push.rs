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

/// A last change of a `φ_i`, relative to the size of the numbers it is made of, at which the rounds have converged.
///
/// A change `c` of `φ` moves the position by `γ1 c / (K γ2) = c T / 2 K` and the velocity by `c / K`, so what a boundary of
/// curvature `h` leaves of `φ` is about `h c² T / 2 K`: below 1e-15 m for lengths of 1 m, `h` up to 100 /m and `T < K / 10`.
const CONVERGED: f64 = 1e-8;

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
        let limits = Limits { law, regained: state.excess.map(|e| e - fall) };
        if now.excess.iter().zip(&self.limits(&limits, &now.samples)).all(|(e, limit)| e <= limit) {
            return Ok(Push::NONE);
        }
        let push = self.smallest_push(now, constraints, &limits)?;
        let [position, velocity] = self.filter.reach();
        state.push.first = add_scaled(&state.push.first, position, &push.vector);
        state.push.second = add_scaled(&state.push.second, velocity, &push.vector);
        Ok(push)
    }

    /// Zero, or the band of the explicit law; from outside, what the recovery leaves of the last sample's excess.
    fn limits(&self, limits: &Limits<M>, samples: &[ConstraintSample<N>; M]) -> [f64; M] {
        let mut band = limits.law.map_or([0.0; M], |law| self.full_push(law, samples));
        for (b, regained) in band.iter_mut().zip(&limits.regained) {
            *b = b.max(*regained);
        }
        band
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
        for _ in 0..ROUNDS {
            let rows = self.rows(&now.samples);
            let mut bounds = self.limits(limits, &now.samples);
            for ((b, e), row) in bounds.iter_mut().zip(&now.excess).zip(&rows) {
                *b += dot(row, &push) - e;
            }
            let found = smallest_correction(&rows, &bounds).map_err(|reason| match reason {
                NoCorrection::Contradiction(i) => HoldReason::Contradiction(i),
                NoCorrection::Cycling => HoldReason::CorrectionNotFound,
            })?;
            let settled = self.settled(now, &rows, &difference(&found.vector, &push));
            push = found.vector;
            *now = self.evaluate(self.pushed(&free, &push), constraints);
            self.check(now)?;
            if settled {
                return Ok(Push { vector: push, share: shares(&rows, &found.multipliers) });
            }
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

    fn settled(&self, now: &Evaluated<N, M>, rows: &[[f64; N]; M], change: &[f64; N]) -> bool {
        let (place, speed) = (norm(&now.motion.position), norm(&now.motion.velocity));
        rows.iter().zip(&now.samples).zip(&self.settings.approach).all(|((row, s), &k)| {
            let size = libm::fabs(s.value) + norm(&s.gradient) * (place + k * speed);
            libm::fabs(dot(row, change)) <= CONVERGED * size
        })
    }
}

/// What bounds each `φ_i` plus margin at this sample.
struct Limits<const M: usize> {
    /// The explicit law whose band counts; none for the implicit form.
    law: Option<SwitchingLaw>,
    /// What the recovery leaves of the last sample's excess.
    regained: [f64; M],
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
