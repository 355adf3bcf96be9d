use super::constraint::ConstraintSample;
use super::outcome::HoldReason;
use super::settings::SwitchingLaw;
use super::vector::{add_scaled, norm, scaled};

/// Gradients shorter than this are empty, as in the appendix. `[G12] 5.1` asks for `σ` comparable to distances, so a
/// useful gradient has a length around 1.
pub(crate) const EMPTY: f64 = 1e-9;

/// A push and who asked for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Push<const N: usize, const M: usize> {
    pub(crate) vector: [f64; N],
    pub(crate) share: [f64; M],
}

impl<const N: usize, const M: usize> Push<N, M> {
    pub(crate) const NONE: Self = Self { vector: [0.0; N], share: [0.0; M] };
}

impl SwitchingLaw {
    /// Weight of constraint `i` in the sum of gradients.
    fn weight(&self, cutoff: f64, approach: f64) -> f64 {
        match *self {
            Self::Sum { gain } => gain * cutoff * cutoff * approach,
            Self::Normalised { .. } => 1.0,
        }
    }

    /// The longest push the law can give with these constraints, whichever of them are active.
    pub(crate) fn longest<const N: usize, const M: usize>(
        &self,
        cutoff: f64,
        approach: &[f64; M],
        samples: &[ConstraintSample<N>; M],
    ) -> f64 {
        match *self {
            Self::Normalised { amplitude } => amplitude,
            Self::Sum { .. } => {
                samples.iter().zip(approach).map(|(s, &k)| self.weight(cutoff, k) * norm(&s.gradient)).sum()
            }
        }
    }

    /// `u_SM` for the constraints that `active` marks, `[G12] eq 13, 17, 20`.
    #[inline(always)]
    pub(crate) fn push<const N: usize, const M: usize>(
        &self,
        cutoff: f64,
        approach: &[f64; M],
        samples: &[ConstraintSample<N>; M],
        active: &[bool; M],
    ) -> Result<Push<N, M>, HoldReason> {
        if !active.contains(&true) {
            return Ok(Push::NONE);
        }
        let mut sum = [0.0; N];
        let mut share = [0.0; M];
        let mut total = 0.0;
        for (i, ((sample, &k), (part, &acts))) in
            samples.iter().zip(approach).zip(share.iter_mut().zip(active)).enumerate()
        {
            let length = norm(&sample.gradient);
            if acts && !(length > EMPTY) {
                return Err(HoldReason::EmptyGradient(i));
            }
            // Selected rather than skipped: which constraints act is what no branch predictor foresees.
            let weight = if acts { self.weight(cutoff, k) } else { 0.0 };
            *part = if acts { weight * length } else { 0.0 };
            total += *part;
            sum = add_scaled(&sum, -weight, &sample.gradient);
        }
        let length = norm(&sum);
        let stretch = match *self {
            Self::Sum { .. } => 1.0,
            Self::Normalised { amplitude } => amplitude / length,
        };
        // Written so that a NaN, from gradients that overflow, holds as well.
        if length > EMPTY * total {
            let per_total = 1.0 / total;
            Ok(Push { vector: scaled(stretch, &sum), share: share.map(|s| s * per_total) })
        } else {
            Err(HoldReason::OpposedGradients)
        }
    }
}
