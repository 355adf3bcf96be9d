//! Claim `path-lag`: `σ` never exceeds the largest `φ` so far, if it starts below it.
//!
//! `K σ̇ + σ = φ` is a first-order lag of unit gain: over any interval `σ⁺ = e σ + (1 - e) m` with `e = exp(-t/K)` and `m` a
//! mean of `φ` over the interval, hence `σ⁺ <= max(σ, sup φ)`. The supremum is over time, not over samples: between
//! samples `φ` can bulge, see `slideway_conditioner::path::bounds::between_samples`.

#[cfg(test)]
mod tests {
    use crate::smt::assert_proved;
    use proptest::prelude::*;

    #[test]
    fn the_lag_is_inductive() {
        assert_proved(include_str!("../smt/path_lag.smt2"), include_str!("../smt/path_lag_sat.smt2"));
    }

    proptest! {
        #[test]
        fn a_lag_of_held_values_stays_below_the_largest(
            values in prop::collection::vec(-1.0..1.0_f64, 1..200),
            rate in 0.001..2.0_f64,
        ) {
            let memory = (-rate).exp();
            let (mut sigma, mut largest) = (-1.0_f64, f64::NEG_INFINITY);
            for &phi in &values {
                largest = largest.max(phi);
                sigma += (1.0 - memory) * (phi - sigma);
                // One rounding of a number up to 2 per sample, 200 samples.
                prop_assert!(sigma <= largest + 1e-13);
            }
        }
    }
}
