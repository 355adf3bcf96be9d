use slideway_conditioner::acceleration::Preview;
use slideway_proofs::look_ahead_tail::{CLAIM, look_ahead};

use crate::support::{Outcome, counterexample, holds, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// Two samples of a stop from rate `w` at deceleration `d`, the period as the unit of time.
fn only_the_midpoint_keeps_the_deceleration(w: f64, d: f64) -> Outcome {
    let distance = w * w / (2.0 * d);
    let naive = (2.0 * d * (distance - w)).sqrt();
    assert!(w - naive > 1.01 * d, "{w} {naive}");
    let plan = look_ahead(1.0, d)?;
    let nodes = [[1.0]; 5];
    let rate = |offset| plan.greatest_rate(&Preview { offset, spacing: distance / 4.0, path_speeds: &nodes });
    let first = rate(0.0);
    // Each is found to 2^-40 of the target rate 100.
    assert!(first - rate(first) <= d + 4e-10, "{first} {}", rate(first));
    Ok(())
}

#[test]
fn evaluated_where_the_sample_begins_the_rate_falls_too_fast() -> Outcome {
    only_the_midpoint_keeps_the_deceleration(5.0, 1.0)?;
    let model = counterexample(&CLAIM, "midpoint")?;
    only_the_midpoint_keeps_the_deceleration(model.value("w")?, model.value("d")?)
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
