//! Claim `path-band-appendix`: in the appendix's scheme `φ <= D̄ + (D̄ - G/4)⁺ + (D̄ - 3G/4)⁺`, with `D̄ <= G`.
//!
//! Prewarped Tustin filters and finite differences spread a push over three samples, a quarter, a half and a quarter of it:
//!
//! ```text
//! φ⁺ = φ + D - G (s_k / 4 + s_{k-1} / 2 + s_{k-2} / 4),   s_k = [φ_k >= 0]
//! ```
//!
//! Induction on the number `r` of samples since `φ` was last negative: `r = 1` gives `φ <= D̄`, each further sample adds
//! what the drift has over `G/4`, `3G/4` and then `G` (nothing). Older pushes still under way only help. The weights are
//! the limit of a small sampling period; the property test uses them, `tests/path_helix.rs` the filters themselves.

#[cfg(test)]
mod tests {
    use crate::smt::assert_proved;
    use proptest::prelude::*;
    use slideway_conditioner::path::bounds::appendix_upper_band;

    #[test]
    fn the_band_is_inductive() {
        assert_proved(
            include_str!("../smt/path_band_appendix.smt2"),
            include_str!("../smt/path_band_appendix_sat.smt2"),
        );
    }

    proptest! {
        #[test]
        fn no_sequence_of_drifts_exceeds_the_band(
            push in 0.1..2.0_f64,
            drifts in prop::collection::vec(-0.5..1.0_f64, 1..300),
        ) {
            let largest = drifts.iter().map(|s| s * push).fold(0.0, f64::max);
            let upper = appendix_upper_band(push, largest);
            let (mut phi, mut switches) = (-1e-3, [0.0; 3]);
            for share in &drifts {
                switches = [if phi >= 0.0 { 1.0 } else { 0.0 }, switches[0], switches[1]];
                let felt = 0.25 * switches[0] + 0.5 * switches[1] + 0.25 * switches[2];
                phi += share * push - push * felt;
                // Rounding of 300 additions of numbers up to 300.
                prop_assert!(phi <= upper + 1e-11, "{phi} {upper}");
            }
        }
    }
}
