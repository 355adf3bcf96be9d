use super::conditioner::PathConditioner;
use super::constraint::{ConstraintSample, Motion};
use super::filters::Discretisation;
use super::outcome::HoldReason;
use super::settings::{Margin, PathForm, Reserve, SwitchingLaw};
use super::vector::{finite, norm};

/// Constraints at one motion, and what follows from them.
#[derive(Clone, Copy)]
pub(crate) struct Evaluated<const N: usize, const M: usize> {
    pub(crate) motion: Motion<N>,
    pub(crate) samples: [ConstraintSample<N>; M],
    pub(crate) phi: [f64; M],
    /// `φ_i` plus margin: what the law keeps at or below zero.
    pub(crate) excess: [f64; M],
}

impl<const N: usize, const M: usize> Evaluated<N, M> {
    /// `σ_i`. A loop, because mapping the array would copy every sample first.
    #[inline(always)]
    pub(crate) fn sigma(&self) -> [f64; M] {
        let mut sigma = [0.0; M];
        for (sigma, sample) in sigma.iter_mut().zip(&self.samples) {
            *sigma = sample.value;
        }
        sigma
    }
}

impl<const N: usize, const M: usize> PathConditioner<N, M> {
    #[inline(always)]
    pub(super) fn evaluate<E>(&self, motion: Motion<N>, constraints: &E) -> Evaluated<N, M>
    where
        E: Fn(&Motion<N>) -> [ConstraintSample<N>; M],
    {
        let samples = constraints(&motion);
        let phi = self.phi(&samples, &motion.velocity);
        let mut excess = self.margin(&samples);
        for (e, p) in excess.iter_mut().zip(&phi) {
            *e += p;
        }
        Evaluated { motion, samples, phi, excess }
    }

    /// Names the first constraint that is not finite.
    #[inline(always)]
    pub(super) fn check(&self, now: &Evaluated<N, M>) -> Result<(), HoldReason> {
        // The smallest push is found along the motion, whether it is the whole push or the reserve.
        let turns = match self.settings.form {
            PathForm::Implicit { .. } | PathForm::Sliding { reserve: Reserve::On { .. }, .. } => true,
            PathForm::Sliding { .. } | PathForm::Appendix { .. } => false,
        };
        for (i, (s, phi)) in now.samples.iter().zip(&now.phi).enumerate() {
            let rates = !turns || finite(&s.gradient_rate);
            // φ is a sum over value, gradient and time rate: finite if all of them are.
            if !(rates && phi.is_finite() && finite(&s.gradient)) {
                return Err(HoldReason::ConstraintNotFinite(i));
            }
        }
        Ok(())
    }

    pub(super) fn phi(&self, samples: &[ConstraintSample<N>; M], velocity: &[f64; N]) -> [f64; M] {
        let mut phi = self.settings.approach;
        for (phi, sample) in phi.iter_mut().zip(samples) {
            *phi = sample.phi(*phi, velocity);
        }
        phi
    }

    /// One full push of a sample in terms of each `φ_i`: `G_i = per_push ‖u_SM‖ ‖∇σ_i‖`, `[G12] eq 22`.
    pub(super) fn full_push(&self, law: SwitchingLaw, samples: &[ConstraintSample<N>; M]) -> [f64; M] {
        let longest = law.longest(self.settings.push_cutoff, &self.settings.approach, samples);
        let mut full = self.settings.approach;
        for (g, sample) in full.iter_mut().zip(samples) {
            *g = self.per_push(*g) * longest * norm(&sample.gradient);
        }
        full
    }

    /// Fall of `φ_i` over one sample per unit of push along a unit gradient: `γ1 + K γ2`, and the paper's
    /// `T α1² K` for the appendix's scheme.
    #[inline(always)]
    pub(super) fn per_push(&self, approach: f64) -> f64 {
        match self.discretisation {
            Discretisation::ZeroOrderHold => {
                let [position, velocity] = self.filter.reach();
                // [G12] eq 9, the part of `u_1`, over one period.
                position + approach * velocity
            }
            Discretisation::PrewarpedTustin => {
                let a = self.settings.push_cutoff;
                self.settings.sampling_period * a * a * approach
            }
        }
    }

    #[inline(always)]
    fn margin(&self, samples: &[ConstraintSample<N>; M]) -> [f64; M] {
        match (&self.settings.margin, self.settings.form.law()) {
            (Margin::Fixed(margin), _) => *margin,
            (Margin::None, _) | (Margin::Band, None) => [0.0; M],
            (Margin::Band, Some(law)) => {
                // Claims `path-band` and `path-band-appendix` with a drift of at most one full push.
                let pushes = match self.discretisation {
                    Discretisation::ZeroOrderHold => 1.0,
                    Discretisation::PrewarpedTustin => 2.0,
                };
                self.full_push(law, samples).map(|g| pushes * g)
            }
        }
    }
}
