//! Claim `path-equivalence`: where `μ = (L_g L_gᵀ)⁻¹ L_f >= 0`, the equivalent control `u_eq = -L_gᵀ μ` of the sliding mode
//! is the optimum of the safety filter `min ‖u‖²` subject to `L_f + L_g u <= 0`, and `μ` are its multipliers.
//!
//! The optimality conditions of that convex program are `u = -L_gᵀ μ`, `μ >= 0`, `L_f + L_g u <= 0` and
//! `μᵀ (L_f + L_g u) = 0`. With every constraint at equality, `L_f - L_g L_gᵀ μ = 0`, they hold, and they are sufficient.

#[cfg(test)]
mod tests {
    use crate::smt::assert_proved;
    use proptest::prelude::*;
    use slideway_baselines::safety_filter::enumeration::smallest;

    #[test]
    fn the_equivalent_control_is_no_longer_than_any_admissible_one() {
        assert_proved(include_str!("../smt/path_equivalence.smt2"), include_str!("../smt/path_equivalence_sat.smt2"));
    }

    proptest! {
        #[test]
        fn the_equivalent_control_is_the_optimum_of_the_program(
            rows in prop::collection::vec(prop::collection::vec(-1.0..1.0_f64, 3), 1..4),
            multipliers in prop::array::uniform3(0.0..2.0_f64),
        ) {
            let mut control = [0.0; 3];
            for (row, m) in rows.iter().zip(&multipliers) {
                for (u, g) in control.iter_mut().zip(row) {
                    *u -= m * g;
                }
            }
            // L_f = L_g L_gᵀ μ = -L_g u_eq makes μ the multipliers; the program asks for L_g u <= -L_f.
            let bounds: Vec<f64> = rows.iter().map(|row| row.iter().zip(&control).map(|(g, u)| g * u).sum()).collect();
            let lengths: Vec<f64> = rows.iter().map(|row| row.iter().map(|g| g * g).sum::<f64>()).collect();
            prop_assume!(lengths.iter().all(|l| *l > 1e-2));
            let found = smallest(&rows, &bounds).expect("the equivalent control is admissible");
            // Both are admissible to 1e-12 and the program is strictly convex: lengths differ by 1e-11, vectors by its
            // root where the rows are nearly dependent.
            for (f, u) in found.iter().zip(&control) {
                prop_assert!((f - u).abs() <= 1e-5, "{found:?} {control:?}");
            }
        }
    }
}
