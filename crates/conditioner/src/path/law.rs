use super::constraint::ConstraintSample;
use super::outcome::HoldReason;
use super::settings::SwitchingLaw;
use super::vector::{add_scaled, norm, scaled};

/// Gradients no longer than this are empty, as in the appendix. `[G12] 5.1` asks for `σ` comparable to distances, so a
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
            // [G12] eq 15
            if acts && !(length > EMPTY) {
                return Err(HoldReason::EmptyGradient(i));
            }
            // Selected rather than skipped: which constraints act is what no branch predictor foresees.
            let weight = if acts { self.weight(cutoff, k) } else { 0.0 };
            *part = if acts { weight * length } else { 0.0 };
            total += *part;
            // [G12] eq 20, and [G12] eq 17 where one constraint acts.
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

#[cfg(test)]
mod tests {
    use super::*;

    fn with_gradients<const N: usize, const M: usize>(gradients: [[f64; N]; M]) -> [ConstraintSample<N>; M] {
        gradients.map(|gradient| ConstraintSample {
            value: 0.0,
            gradient,
            time_rate: 0.0,
            gradient_rate: [0.0; N],
            time_rate_rate: 0.0,
        })
    }

    #[test]
    fn both_laws_weigh_the_gradients_of_what_acts_and_share_by_weighted_length() {
        let samples = with_gradients([[3.0, 4.0], [0.0, 2.0], [7.0, 0.0]]);
        let (approach, active) = ([0.5, 0.75, 1.0], [true, true, false]);
        // Weights u⁺ α² K = 1, 3/2 and 2 of gradients of length 5, 2 and 7.
        let law = SwitchingLaw::Sum { gain: 0.5 };
        let push = law.push(2.0, &approach, &samples, &active).expect("a direction");
        assert_eq!((push.vector, push.share), ([-3.0, -7.0], [5.0 / 8.0, 3.0 / 8.0, 0.0]));
        assert_eq!(law.longest(2.0, &approach, &samples), 5.0 + 3.0 + 14.0);
        // Equal weights, at a length of 2: -(3, 6) is √45 long.
        let law = SwitchingLaw::Normalised { amplitude: 2.0 };
        let push = law.push(2.0, &approach, &samples, &active).expect("a direction");
        let scale = -2.0 / libm::sqrt(45.0);
        // Two roundings of numbers of 1 and 2.
        assert!((push.vector[0] - 3.0 * scale).abs() < 1e-15 && (push.vector[1] - 6.0 * scale).abs() < 1e-15);
        assert!((push.share[0] - 5.0 / 7.0).abs() < 1e-15 && (push.share[1] - 2.0 / 7.0).abs() < 1e-15);
        assert_eq!((push.share[2], law.longest(2.0, &approach, &samples)), (0.0, 2.0));
    }

    #[test]
    fn a_gradient_is_empty_up_to_the_stated_length_and_pushes_in_full_from_there() {
        let law = SwitchingLaw::Normalised { amplitude: 2.0 };
        let push = |length: f64| law.push(2.0, &[0.5], &with_gradients([[length]]), &[true]);
        // The root of a square is exact.
        assert_eq!(push(EMPTY), Err(HoldReason::EmptyGradient(0)));
        let full = push(2.0 * EMPTY).expect("a direction");
        // Two roundings each.
        assert!((full.vector[0] + 2.0).abs() < 1e-15 && (full.share[0] - 1.0).abs() < 1e-15, "{full:?}");
    }

    #[test]
    fn gradients_are_opposed_where_they_cancel_up_to_the_stated_share() {
        let push = |law: SwitchingLaw, rest: f64| {
            law.push(2.0, &[0.25; 2], &with_gradients([[1e9 + 0.5 * rest], [0.5 * rest - 1e9]]), &[true; 2])
        };
        // Both weigh 1. What is left of lengths of 2e9 in sum is opposed up to 1e-9 · 2e9 = 2.
        for law in [SwitchingLaw::Sum { gain: 1.0 }, SwitchingLaw::Normalised { amplitude: 4.0 }] {
            assert_eq!([0.0, 2.0, -2.0].map(|rest| push(law, rest)), [Err(HoldReason::OpposedGradients); 3]);
            let found = push(law, 4.0).expect("a direction");
            assert!((found.vector[0] + 4.0).abs() < 1e-15 && found.share.iter().all(|s| (s - 0.5).abs() < 1e-8));
        }
    }
}
