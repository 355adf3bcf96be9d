//! Claim `look-ahead-tail`: a stop that exists in the window at one sample exists at the next.
//!
//! Hypotheses: between two nodes `v = dq/dλ` and `b = λ̇²` are linear in `λ`; the joint acceleration `v λ̈ + v' b` keeps its limits
//! `a_lower < 0 < a_upper` at both ends. Rates `w`, `w2` are held for one sample each, and evaluated at `x = λ + Ts w / 2`.
//!
//! ```text
//! x2 - x = Ts (w + w2) / 2,   w2 = w + Ts λ̈   =>   w2² = w² + 2 λ̈ (x2 - x)        the samples lie on the plan
//! Ts a_lower <= v(x2) w2 - v(x) w <= Ts a_upper                                    and keep the acceleration limits
//! c (v λ̈ + v' b) inside as well for 0 <= c <= 1                                   as does any profile scaled towards rest
//! ```
//!
//! Source: this project, after the controllable sets of Pham and Pham 2018.
//!
//! Derivation. The joint acceleration along the piece is linear in `x`, so it keeps its limits between the ends, and the change of the
//! joint speed is its integral over `Ts`. A plan over several intervals is a chain of such pieces. Rest is admissible everywhere, so a
//! window that grows at its far end keeps every old plan, followed by a stand.
//!
//! Not covered: a sample in which the plan's `λ̈` jumps, at a node, where the two halves of the sample belong to two pieces and the
//! place is off the plan by up to `Ts² |Δλ̈| / 8` (random zigzag paths: an excess of some thousandths of the limit). And the joints are
//! commanded `v(λ) w`, not `v(x) w`, and `v` bends between the nodes. The margin is for all three.
//!
//! Dropped hypothesis: the midpoint. Evaluated at `λ` itself the rate falls faster than the plan's deceleration.

use slideway_conditioner::acceleration::{AccelerationLimits, LookAhead, LookAheadSettings, Preview};
use slideway_conditioner::{ParameterError, SpeedLimits};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::draw::TS;
use crate::engine::{About, Choices, Cost, Engine, Stop, worse};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "look-ahead-tail",
    statement: "If a stop inside the window exists at one sample, the plan cut at its front is one at the next: between two nodes of the preview it changes the joint speeds at the midpoints of the samples by no more than the acceleration limits allow, and slower profiles keep them too.",
    source: "this project, after the controllable sets of Pham and Pham 2018",
    verdict: Verdict::Ours,
    negations: &[Script { file: "look-ahead-tail.smt2", text: include_str!("../smt/look-ahead-tail.smt2") }],
    twins: &[Twin {
        without: "midpoint",
        script: Script {
            file: "look-ahead-tail-without-midpoint.smt2",
            text: include_str!("../smt/look-ahead-tail-without-midpoint.smt2"),
        },
    }],
    engines: &[Engine {
        name: "a_stop_in_the_window_leaves_a_stop_for_the_next_sample",
        unit: "rad/s",
        about: About::Other,
        cost: Cost::Run,
        trial: leaves_a_stop,
    }],
};

/// A look-ahead without margin whose speed limits and target rate, both 100, are out of the way of what is tried here.
///
/// # Errors
///
/// A period or an acceleration that is not positive.
pub fn look_ahead<const N: usize>(period: f64, acceleration: f64) -> Result<LookAhead<N>, ParameterError> {
    LookAhead::new(LookAheadSettings {
        speed_limits: SpeedLimits::symmetric([100.0; N])?,
        acceleration_limits: AccelerationLimits::symmetric([acceleration; N])?,
        sampling_period: period,
        target_rate: 100.0,
        margin: 0.0,
    })
}

/// Distance of the nodes.
const SPACING: f64 = 0.02;

/// Nodes of a path.
const NODES: usize = 8;

/// Samples of a run.
const SAMPLES: u32 = 16;

/// A path of two joints whose path speeds are linear between its nodes, and the joint speeds of the sample before.
struct Run {
    plan: LookAhead<2>,
    nodes: [[f64; 2]; NODES],
    limit: f64,
    lambda: f64,
    before: [f64; 2],
}

impl Run {
    fn greatest(&self) -> f64 {
        self.plan.greatest_rate(&Preview { offset: self.lambda, spacing: SPACING, path_speeds: &self.nodes })
    }

    /// The interval of a place.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    fn interval(lambda: f64) -> usize {
        ((lambda / SPACING) as usize).min(NODES - 2)
    }

    fn path_speed(&self, lambda: f64) -> [f64; 2] {
        let node = Self::interval(lambda);
        let share = lambda / SPACING - node as f64;
        let ends = self.nodes.get(node).zip(self.nodes.get(node + 1));
        ends.map_or([f64::NAN; 2], |([a, b], [c, d])| [a + share * (c - a), b + share * (d - b)])
    }

    /// Where a rate is evaluated: the sample's midpoint.
    fn midpoint(&self, rate: f64) -> f64 {
        self.lambda + 0.5 * TS * rate
    }

    /// The joint speed there.
    fn joint_speed(&self, rate: f64) -> [f64; 2] {
        self.path_speed(self.midpoint(rate)).map(|v| v * rate)
    }

    /// By how much a rate exceeds the acceleration limits, rad/s; negative inside.
    fn excess(&self, rate: f64) -> f64 {
        let changes = self.joint_speed(rate).into_iter().zip(self.before).map(|(v, p)| (v - p).abs());
        changes.fold(0.0, f64::max) - TS * self.limit
    }

    /// The rate in an interval that exceeds least, by golden sections: one of the least if there are several. Each leaves 0.618 of the
    /// interval: 70 of them, 2e-15.
    fn lowest(&self, mut low: f64, mut high: f64) -> f64 {
        const SHARE: f64 = 0.618_033_988_749_894_8;
        let (mut a, mut b) = (high - SHARE * (high - low), low + SHARE * (high - low));
        let (mut at_a, mut at_b) = (self.excess(a), self.excess(b));
        for _ in 0..70 {
            if at_a <= at_b {
                (high, b, at_b) = (b, a, at_a);
                a = high - SHARE * (high - low);
                at_a = self.excess(a);
            } else {
                (low, a, at_a) = (a, b, at_b);
                b = low + SHARE * (high - low);
                at_b = self.excess(b);
            }
        }
        0.5 * (low + high)
    }

    /// The rate up to `most` that exceeds least. The excess is convex up to the curvature over a sample; where the search ends at a rate
    /// that exceeds, it begins anew in each of a hundred parts.
    fn best(&self, most: f64) -> f64 {
        let whole = self.lowest(0.0, most);
        if self.excess(whole) <= 0.0 {
            return whole;
        }
        let parts = (0..100).map(f64::from).map(|k| self.lowest(0.01 * k * most, 0.01 * (k + 1.0) * most));
        parts.fold(whole, |best, rate| if self.excess(rate) < self.excess(best) { rate } else { best })
    }

    /// The largest rate between the best and `most` that exceeds no more, found from below.
    fn fastest(&self, best: f64, most: f64) -> f64 {
        let unavoidable = self.excess(best).max(0.0);
        let (mut rate, mut above) = (best, most);
        for _ in 0..40 {
            let middle = 0.5 * (rate + above);
            if self.excess(middle) <= unavoidable { rate = middle } else { above = middle }
        }
        rate
    }

    fn go(&mut self, rate: f64) {
        self.before = self.joint_speed(rate);
        self.lambda += TS * rate;
    }
}

/// A random path entered at a random place with any share of the greatest rate, and left to run between the slowest and the fastest
/// rates that the limits allow.
///
/// Samples count whose evaluated places lie between the same two nodes as those before: elsewhere the path acceleration jumps between
/// them, which is not claimed.
///
/// Slack. Rates are found to 2^-40 of 100 1/s, and the path speed changes by at most 2 rad over [`SPACING`], so that the joint speed
/// `v(λ + Ts w / 2) w` changes with `w <= 100` by no more than `1 + 2 · 100 Ts / (2 SPACING) < 6` times as much: 6e-10 rad/s. Rates are
/// searched to 1e-13 of that, and rounded to less. The limits are 5e-4 rad/s a sample and more.
fn leaves_a_stop(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    const SLACK: f64 = 1e-9;
    let limit = choices.decade(-0.3, 1.3);
    let nodes = std::array::from_fn(|_| choices.numbers(-1.0, 1.0));
    let lambda = choices.between(0.0, SPACING * (NODES - 3) as f64);
    let mut run = Run { plan: look_ahead(TS, limit)?, nodes, limit, lambda, before: [0.0; 2] };
    let entry = choices.share() * run.greatest();
    let haste = choices.share();
    let mut interval = Run::interval(run.midpoint(entry));
    run.go(entry);
    let mut margin = f64::INFINITY;
    for _ in 0..SAMPLES {
        if run.lambda > SPACING * (NODES - 2) as f64 {
            break;
        }
        let most = run.greatest();
        let best = run.best(most);
        let rate = best + haste * (run.fastest(best, most) - best);
        let place = Run::interval(run.midpoint(rate));
        if std::mem::replace(&mut interval, place) == place {
            margin = worse(margin, SLACK - run.excess(best));
        }
        run.go(rate);
    }
    Ok(margin)
}
