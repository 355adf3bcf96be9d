use slideway_baselines::projection::outside_ellipsoid::OutsideEllipsoid;
use slideway_proofs::projection::CLAIM;

use crate::support::{Outcome, counterexample, holds, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// Two points beside the centre of a ball are projected to opposite sides of it.
fn outside_of_a_ball_is_expansive(s: f64) -> Outcome {
    let outside = OutsideEllipsoid::<2> { centre: [0.0; 2], semi_axes: [1.0; 2] };
    let (p, q) = (outside.project(&[s, 0.0])?.point, outside.project(&[-s, 0.0])?.point);
    assert!((p[0] - q[0]).powi(2) >= 0.45 + 4.0 * s * s, "{p:?} {q:?}");
    Ok(())
}

#[test]
fn beside_the_centre_of_a_forbidden_ball_points_are_driven_apart() -> Outcome {
    outside_of_a_ball_is_expansive(0.5)?;
    outside_of_a_ball_is_expansive(counterexample(&CLAIM, "convexity")?.value("s")?)
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
