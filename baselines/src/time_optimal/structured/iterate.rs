//! The loop: steps until the certificate closes, the best iterate kept.
//!
//! The measure of an iterate is its own certificate in ordinary arithmetic, `δ = max(|T - L|, Σ s z) / T + excess`: complementarity alone goes on
//! falling where the dual residual already climbs. The loop ends at the target, at 100 times the best `δ` (once it was below
//! 1e-5, and for three steps), or after 12 steps (40 from inside) that gain less than a tenth.

use super::centre::{Centre, Correctors};
use super::state::State;

/// Relative distance of the bounds at which the loop ends, a hundredth of what is accepted.
pub(super) const TARGET: f64 = 1e-8;

/// Distance that is rounding: what is left of the rows' excess there is for the repair.
const ROUNDING: f64 = 1e-12;

/// Distance below which getting worse is a sign of rounding, not of centring.
const CLOSE: f64 = 1e-5;

/// Steps that the loop may get worse by so much and recover: a step cut short by one multiplier lifts the dual residual for a step or two.
const RELAPSE: u32 = 3;

/// Steps at the most.
const MOST: u32 = 100;

/// Reason why the loop ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ending {
    /// The bounds met.
    Solved,
    /// The iterates got worse, or no better.
    Stalled,
    /// Numbers left the range of the arithmetic.
    Broken,
    /// Too many steps.
    Long,
}

/// The best iterate.
#[derive(Clone, Debug)]
pub(super) struct Best {
    pub(super) x: Vec<f64>,
    /// Multipliers of the kept rows.
    pub(super) multipliers: Vec<f64>,
    pub(super) distance: f64,
    pub(super) ending: Ending,
    pub(super) steps: u32,
}

impl Best {
    fn keep(&mut self, state: &State, distance: f64) {
        self.distance = distance;
        self.x.clone_from(&state.x);
        self.multipliers.clear();
        self.multipliers.extend(state.rows.rows.iter().map(|row| row.pair.multiplier));
    }
}

/// Steps from a start to the target, or as near to it as it gets.
pub(super) fn iterate(state: &mut State, correctors: Correctors) -> Best {
    let mut best =
        Best { x: Vec::new(), multipliers: Vec::new(), distance: f64::INFINITY, ending: Ending::Long, steps: 0 };
    let mut centre = Centre::default();
    let (mut mark, mut waited) = (f64::INFINITY, 0);
    loop {
        let measure = state.assess();
        let distance = measure.distance();
        if !distance.is_finite() {
            best.ending = Ending::Broken;
            break;
        }
        if distance < best.distance {
            best.keep(state, distance);
        }
        let is_closed = measure.excess <= 0.0 && measure.time - measure.lower <= TARGET * measure.lower;
        if is_closed || distance <= ROUNDING {
            best.ending = Ending::Solved;
            break;
        }
        (mark, waited) = if distance < 0.9 * mark { (distance, 0) } else { (mark, waited + 1) };
        let is_worse = best.distance < CLOSE && distance > 100.0 * best.distance;
        if waited > correctors.patience() || (is_worse && waited > RELAPSE) {
            best.ending = Ending::Stalled;
            break;
        }
        if best.steps == MOST {
            break;
        }
        best.steps += 1;
        let Some(lengths) = centre.direct(state, &measure, correctors) else {
            best.ending = Ending::Broken;
            break;
        };
        centre.advance(state, lengths);
    }
    best
}
