//! Claim `path-band`: on one constraint under zero-order hold or Euler's rule, with push `G` and drift
//! `D_min <= D <= D̄ <= G` per sample, `φ <= D̄` and, once there, `φ >= -(G - D_min)⁺`.
//!
//! ```text
//! φ⁺ = φ + D - G [φ >= 0]
//! ```
//!
//! Induction: from `φ < 0` one drift leads to at most `D̄`; from `0 <= φ <= D̄` the push takes back at least the drift.
//! From `φ >= 0` the fall is at most `G - D_min`; from below zero `φ` does not fall if `D >= 0`. With drifts of either sign
//! the upper end stands, the lower one needs `D_min >= 0`. The paper's eq 22 gives the width `G` as an estimate for both.

#[cfg(test)]
mod tests {
    use crate::smt::assert_proved;
    use proptest::prelude::*;
    use slideway_conditioner::path::bounds::band;

    #[test]
    fn the_upper_end_is_inductive() {
        assert_proved(include_str!("../smt/path_band_upper.smt2"), include_str!("../smt/path_band_upper_sat.smt2"));
    }

    #[test]
    fn the_lower_end_is_inductive() {
        assert_proved(include_str!("../smt/path_band_lower.smt2"), include_str!("../smt/path_band_lower_sat.smt2"));
    }

    proptest! {
        #[test]
        fn no_sequence_of_drifts_leaves_the_band(
            push in 0.1..2.0_f64,
            drifts in prop::collection::vec(0.0..1.0_f64, 1..300),
        ) {
            let drift = |share: f64| share * push;
            let largest = drifts.iter().map(|&s| drift(s)).fold(0.0, f64::max);
            let band = band(push, 0.0, largest);
            let mut phi = 0.0_f64;
            for &share in &drifts {
                phi += drift(share) - if phi >= 0.0 { push } else { 0.0 };
                // 300 additions of numbers up to 2, each rounded to 2.2e-16.
                prop_assert!(phi <= band.upper + 1e-13 && phi >= band.lower - 1e-13, "{phi} {band:?}");
            }
        }
    }
}
