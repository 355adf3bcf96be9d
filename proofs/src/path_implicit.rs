//! Claim `path-implicit`: from any admissible state the implicit form has `φ_i <= 0` at every sample, to rounding, on half-
//! spaces, balls and pairs and triples of them with independent gradients.
//!
//! For one linear constraint with row `g` the push `u = -g φ⁺ / gᵀg` gives `φ + gᵀu = min(φ, 0)`. For several, rows that are
//! independent have a common solution of all equations, so the half-spaces have a common point and the projection exists;
//! repeated linearisation reaches the curved ones. Where it does not, the sample is held, which keeps `σ <= 0`.

#[cfg(test)]
mod tests {
    use crate::smt::assert_proved;
    use proptest::prelude::*;
    use slideway_conditioner::PathConditioner;
    use slideway_conditioner::path::{Constraint, Margin, Motion, PathForm, PathOutcome, PathSettings};
    use slideway_conditioner::shapes::{Ball, HalfSpace, Side};

    #[test]
    fn one_constraint_ends_at_or_below_zero() {
        assert_proved(include_str!("../smt/path_implicit.smt2"), include_str!("../smt/path_implicit_sat.smt2"));
    }

    fn settings<const M: usize>() -> PathSettings<M> {
        PathSettings {
            sampling_period: 1e-3,
            push_cutoff: 20.0,
            approach: [0.1; M],
            margin: Margin::None,
            form: PathForm::Implicit { recovery_rate: 1.0 },
            trap: None,
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn a_wall_a_floor_and_a_ball_are_kept_at_every_sample(
            tilt in prop::array::uniform3(-0.3..0.3_f64),
            radius in 0.05..0.2_f64,
            speeds in prop::array::uniform3(0.5..3.0_f64),
            phases in prop::array::uniform3(0.0..6.0_f64),
        ) {
            let wall = HalfSpace::new(&[1.0, tilt[0], tilt[1]], 0.25).expect("a normal");
            let floor = HalfSpace::new(&[tilt[2], tilt[0], -1.0], 0.25).expect("a normal");
            let ball = Ball::new([0.0, 0.3, 0.0], radius, Side::Outside).expect("a radius");
            let conditioner = PathConditioner::<3, 3>::new(settings()).expect("valid settings");
            let mut state = conditioner.at_rest(&[-0.2, -0.2, 0.2]).expect("finite");
            for k in 0..4000 {
                let t = f64::from(k) * 1e-3;
                let reference = Motion {
                    time: t,
                    position: std::array::from_fn(|i| 0.4 * (speeds[i] * t + phases[i]).sin()),
                    velocity: std::array::from_fn(|i| 0.4 * speeds[i] * (speeds[i] * t + phases[i]).cos()),
                };
                let step = conditioner.step(&mut state, &reference, |m| {
                    [wall.sample(m), floor.sample(m), ball.sample(m)]
                });
                prop_assert!(!matches!(step.outcome, PathOutcome::Held(_)), "{:?} at {t} s", step.outcome);
                for (phi, sigma) in step.phi.iter().zip(&step.sigma) {
                    // Rounding: rows of condition up to 1e3 times the resolution of 1e-16 of numbers of size 1.
                    prop_assert!(*phi <= 1e-12, "φ = {phi} at {t} s");
                    // Between samples: T² / 8 times |φ̈|, at most some 1e3 m/s² when a moving reference is first met.
                    prop_assert!(*sigma <= 1.3e-4, "σ = {sigma} at {t} s");
                }
            }
        }
    }
}
