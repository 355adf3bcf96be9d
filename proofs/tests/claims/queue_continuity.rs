use slideway_motion::Range;
use slideway_proofs::queue_continuity::CLAIM;

use crate::support::{Outcome, counterexample, holds, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// The interval check as the queue does it: `r² Q''` for a pace and a planned acceleration.
fn product(pace: Range, acceleration: Range) -> Range {
    pace.times(pace).times(acceleration)
}

#[test]
fn checked_at_the_ends_alone_a_span_hides_what_the_whole_span_shows() -> Outcome {
    let model = counterexample(&CLAIM, "whole-span")?;
    let (a, limit, t) = (model.value("a")?, model.value("A")?, model.value("t")?);
    let at = |t: f64| product(Range::point(1.0 - t), Range::point(t * a)).magnitude();
    assert!(at(0.0) <= limit && at(1.0) <= limit && at(t) >= 1.05 * limit);
    let whole = product(Range { lower: 0.0, upper: 1.0 }, Range { lower: 0.0, upper: a });
    assert!(whole.magnitude() >= at(t));
    Ok(())
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
