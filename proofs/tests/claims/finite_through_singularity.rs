use nalgebra::SMatrix;
use proptest::prelude::{Just, prop_assert, prop_assume, proptest};
use slideway_proofs::finite_through_singularity::CLAIM;
use slideway_robot::augmented::null_vector;

use crate::natural_support::spoilt;
use crate::support::{Outcome, config, counterexample, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// A system that has lost two ranks' worth of its null vector: the shipped one is zero to a few roundings.
fn null_vector_vanishes(entries: &[f64; 4], tangent: [f64; 2]) -> Outcome {
    let null = null_vector(&SMatrix::<f64, 2, 2>::from_row_slice(entries), &tangent.into());
    // Entries up to 1, the solver's decimals cut at 1e-20.
    assert!(null.norm() <= 1e-15, "{null:?}");
    Ok(())
}

#[test]
fn beyond_codimension_one_the_null_vector_vanishes() -> Outcome {
    null_vector_vanishes(&[1.0, 0.5, 0.5, 0.25], [0.5, 0.25])?;
    let model = counterexample(&CLAIM, "codimension-one")?;
    let value = |name| model.value(name);
    let entries = [value("a")?, value("b")?, value("c")?, value("d")?];
    null_vector_vanishes(&entries, [value("t1")?, value("t2")?])
}

/// Roundings of determinants of six rows, relative to the Hadamard bound; see the claim `null-vector`.
const SLACK: f64 = 1e-13;

proptest! {
    #![proptest_config(config())]

    // A planted singularity: the last column depends on the others. There the path stands and the joints go on. On the way
    // through it, a share of another column running from -1e-3 to 1e-3, the null vector is no longer than the product of
    // the rows' lengths, and the path speed, linear in that column, changes its sign.
    #[test]
    fn joints_go_on_at_bounded_speed_through_a_planted_singularity(
        system in spoilt::<6>(Just(0.0)),
        other in spoilt::<6>(Just(1.0)),
    ) {
        let place = null_vector(&system.jacobian, &system.tangent);
        prop_assert!(place.path.abs() <= SLACK * system.volume());
        // Close to a loss of two ranks the direction is that of rounding errors.
        prop_assume!(place.joints.norm() > 1e-6 * system.volume());
        for share in [1e-6, 1e-3] {
            let sides = [-share, share].map(|share| {
                let mut passing = system;
                passing.jacobian.set_column(5, &(system.jacobian.column(5) + other.jacobian.column(5) * share));
                (null_vector(&passing.jacobian, &passing.tangent), passing.volume())
            });
            let [(before, left), (after, right)] = sides;
            for (null, volume) in sides {
                prop_assert!(null.norm() <= (1.0 + SLACK) * volume, "{null:?} {volume}");
            }
            prop_assert!((before.path + after.path).abs() <= 2.0 * SLACK * (left + right), "{before:?} {after:?}");
        }
    }
}
