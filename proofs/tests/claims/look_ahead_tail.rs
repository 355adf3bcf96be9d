use proptest::prelude::{ProptestConfig, prop_assert, proptest};
use slideway_conditioner::acceleration::{AccelerationLimits, LookAhead, LookAheadSettings, Preview};
use slideway_conditioner::{ParameterError, SpeedLimits};
use slideway_proofs::look_ahead_tail::CLAIM;

use crate::support::{Outcome, TS, config, counterexample, joints, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

fn look_ahead<const N: usize>(period: f64, acceleration: f64) -> Result<LookAhead<N>, ParameterError> {
    LookAhead::new(LookAheadSettings {
        speed_limits: SpeedLimits::symmetric([100.0; N])?,
        acceleration_limits: AccelerationLimits::symmetric([acceleration; N])?,
        sampling_period: period,
        target_rate: 100.0,
        margin: 0.0,
    })
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

const SPACING: f64 = 0.02;

/// A path of two joints whose path speeds are linear between its nodes, and the joint speeds of the sample before.
struct Run<'a> {
    plan: LookAhead<2>,
    nodes: &'a [[f64; 2]],
    limit: f64,
    lambda: f64,
    before: [f64; 2],
}

impl Run<'_> {
    fn path_speed(&self, lambda: f64) -> [f64; 2] {
        let last = self.nodes.len() - 2;
        let node = ((lambda / SPACING) as usize).min(last);
        let share = lambda / SPACING - node as f64;
        std::array::from_fn(|i| self.nodes[node][i] + share * (self.nodes[node + 1][i] - self.nodes[node][i]))
    }

    /// The joint speed at the sample's midpoint.
    fn joint_speed(&self, rate: f64) -> [f64; 2] {
        self.path_speed(self.lambda + 0.5 * TS * rate).map(|v| v * rate)
    }

    /// By how much a rate exceeds the acceleration limits, rad/s; negative inside.
    fn excess(&self, rate: f64) -> f64 {
        let changes = self.joint_speed(rate).into_iter().zip(self.before).map(|(v, p)| (v - p).abs());
        changes.fold(0.0, f64::max) - TS * self.limit
    }

    /// The rate in [0, `most`] that exceeds least (the excess is convex up to the curvature over a sample), by ternary search.
    fn best(&self, most: f64) -> f64 {
        let (mut low, mut high) = (0.0, most);
        for _ in 0..100 {
            let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
            if self.excess(a) <= self.excess(b) { high = b } else { low = a }
        }
        0.5 * (low + high)
    }

    /// One sample as fast as is allowed; the excess that could not be avoided.
    fn step(&mut self) -> f64 {
        let most = self.plan.greatest_rate(&Preview { offset: self.lambda, spacing: SPACING, path_speeds: self.nodes });
        let mut rate = self.best(most);
        let unavoidable = self.excess(rate);
        let mut above = most;
        for _ in 0..40 {
            let middle = 0.5 * (rate + above);
            if self.excess(middle) <= unavoidable.max(0.0) { rate = middle } else { above = middle }
        }
        self.before = self.joint_speed(rate);
        self.lambda += TS * rate;
        unavoidable
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, ..config() })]

    #[test]
    fn a_stop_in_the_window_leaves_a_stop_for_the_next_sample(
        nodes in proptest::collection::vec(joints::<2>(-1.0..1.0), 12),
        limit in 0.5..20.0,
    ) {
        let plan = look_ahead(TS, limit)?;
        let mut run = Run { plan, nodes: &nodes, limit, lambda: 0.0, before: [0.0; 2] };
        let end = SPACING * (nodes.len() - 1) as f64;
        let mut interval = 0.0;
        for _ in 0..300 {
            if run.lambda > end - SPACING {
                break;
            }
            let begun = run.lambda;
            let unavoidable = run.step();
            // Both samples between the same two nodes: elsewhere the path acceleration jumps between them, which is not claimed.
            let place = (0.5 * (begun + run.lambda) / SPACING).floor();
            if std::mem::replace(&mut interval, place) != place {
                continue;
            }
            // The rate is found to 2^-40 of 100 1/s, and earlier samples to the same: some 1e-9 rad/s against 5e-4 and more.
            prop_assert!(unavoidable <= 1e-8, "{unavoidable:e} at {}", run.lambda);
        }
    }
}
