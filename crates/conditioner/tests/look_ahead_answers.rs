//! The look-ahead against answers known in closed form.

use proptest::prelude::*;
use slideway_conditioner::acceleration::{AccelerationLimits, LookAhead, LookAheadSettings, Preview};
use slideway_conditioner::{ParameterError, SpeedLimits};

/// A joint path of constant path speed, `intervals` nodes apart, of which the robot has gone `offset`.
#[derive(Clone, Debug)]
struct Line {
    path_speed: f64,
    spacing: f64,
    intervals: usize,
    offset: f64,
    braking: f64,
    speeding: f64,
    margin: f64,
    period: f64,
}

/// Steps of a rate: the bisection's `2^-40` of the target rate.
const TARGET: f64 = 100.0;
const RESOLUTION: f64 = 1e-10;

impl Line {
    /// One joint moves and brakes with the limit against its motion; the other one stands and may hardly accelerate at all.
    fn look_ahead(&self) -> Result<LookAhead<2>, ParameterError> {
        let (lower, upper) =
            if self.path_speed > 0.0 { (-self.braking, self.speeding) } else { (-self.speeding, self.braking) };
        LookAhead::new(LookAheadSettings {
            speed_limits: SpeedLimits::symmetric([1e4; 2])?,
            acceleration_limits: AccelerationLimits::new([lower, -1e-3], [upper, 1e-3])?,
            sampling_period: self.period,
            target_rate: TARGET,
            margin: self.margin,
        })
    }

    /// The deceleration of the path parameter at the limit.
    fn deceleration(&self) -> f64 {
        (1.0 - self.margin) * self.braking / self.path_speed.abs()
    }

    /// The root `w` of `w² / (2 a) + Ts w / 2 = distance`: half a sample at the rate, then the stop.
    fn rate(&self) -> f64 {
        let distance = self.intervals as f64 * self.spacing - self.offset;
        let half = 0.5 * self.period;
        2.0 * distance / (half + (half * half + 2.0 * distance / self.deceleration()).sqrt())
    }
}

fn line() -> impl Strategy<Value = Line> {
    let path_speed = prop_oneof![-2.0..-0.2, 0.2..2.0];
    let path = (path_speed, 0.01..0.3, 1..12_usize, 0.0..0.9);
    (path, 0.5..5.0, 0.5..5.0, 0.0..0.9, prop_oneof![Just(1e-3), 0.01..0.5]).prop_map(
        |((path_speed, spacing, intervals, gone), braking, speeding, margin, period)| {
            let offset = gone * intervals as f64 * spacing;
            Line { path_speed, spacing, intervals, offset, braking, speeding, margin, period }
        },
    )
}

proptest! {
    // Rounding: places of at most 4, so 1e-15, change the rate by that over half a period of 5e-4 at most. The bisection is coarser.
    #[test]
    fn on_a_straight_line_the_rate_is_that_of_the_longest_stop(line in line()) {
        let plan = line.look_ahead()?;
        let nodes = vec![[line.path_speed, 0.0]; line.intervals + 1];
        let preview = Preview { offset: line.offset, spacing: line.spacing, path_speeds: &nodes };
        let rate = plan.greatest_rate(&preview);
        prop_assert!((rate - line.rate()).abs() <= RESOLUTION, "{rate} {}", line.rate());

        let mut ranges = vec![f64::NAN; nodes.len()];
        plan.ranges(line.spacing, &nodes, &mut ranges);
        for (node, range) in ranges.iter().enumerate() {
            let stop = 2.0 * line.deceleration() * line.spacing * (line.intervals - node) as f64;
            // A sum of eleven terms at most, each to a few roundings.
            prop_assert!((range - stop).abs() <= 1e-13 * stop, "{range} {stop}");
        }
        let rate = plan.greatest_rate_within(&preview, &ranges);
        prop_assert!((rate - line.rate()).abs() <= RESOLUTION, "{rate} {}", line.rate());
    }

    /// The twin is told of the path from the robot on only.
    #[test]
    fn what_lies_behind_the_robot_does_not_change_its_rate(
        near in proptest::array::uniform2(-2.0..2.0),
        far in proptest::array::uniform2(-2.0..2.0),
        spacing in 0.1..0.5,
        gone in 0.0..0.9,
    ) {
        let plan = LookAhead::new(LookAheadSettings {
            speed_limits: SpeedLimits::new([-1.0, -2.0], [1.5, 0.5])?,
            acceleration_limits: AccelerationLimits::new([-1.0, -2.0], [3.0, 1.5])?,
            sampling_period: 0.05,
            target_rate: 10.0,
            margin: 0.1,
        })?;
        let here = [0, 1].map(|joint: usize| near[joint] + gone * (far[joint] - near[joint]));
        let offset = gone * spacing;
        let whole = Preview { offset, spacing, path_speeds: &[near, far] };
        let ahead = Preview { offset: 0.0, spacing: spacing - offset, path_speeds: &[here, far] };
        let rate = plan.greatest_rate(&ahead);
        // Path speeds that differ by a rounding of 1e-15 change `b <= 100` where it is `2 d a / v` by `b² / (2 d a)` times that, with
        // `2 d a >= 0.01` by 1e-9, and the rate by at most a tenth of it; bisections end within 1e-11 of each other.
        prop_assert!((plan.greatest_rate(&whole) - rate).abs() <= 1e-9);
        prop_assert!((plan.greatest_rate_within(&whole, &[0.0; 2]) - rate).abs() <= 1e-9);
    }
}

fn plan(sampling_period: f64, target_rate: f64) -> Result<LookAhead<2>, ParameterError> {
    LookAhead::new(LookAheadSettings {
        speed_limits: SpeedLimits::new([-7.0, -1.0], [3.0, 9.0])?,
        acceleration_limits: AccelerationLimits::symmetric([2.0; 2])?,
        sampling_period,
        target_rate,
        margin: 0.0,
    })
}

#[test]
fn far_from_the_end_the_rate_is_that_of_the_joint_first_at_its_speed_limit() -> Result<(), ParameterError> {
    let plan = plan(1e-3, 5.0)?;
    for (path_speed, greatest) in [
        ([2.0, -0.1], 1.5),  // the upper limit 3 of joint 1
        ([2.0, -4.0], 0.25), // the lower limit -1 of joint 2
        ([-2.0, 3.0], 3.0),  // the upper limit 9 of joint 2
        ([-2.0, 0.0], 3.5),  // the lower limit -7 of joint 1
        ([0.1, 0.0], 5.0),   // none before the target rate
        ([0.0, -0.0], 5.0),
    ] {
        let nodes = [path_speed; 4];
        let preview = Preview { offset: 0.0, spacing: 100.0, path_speeds: &nodes };
        let mut ranges = [0.0; 4];
        plan.ranges(100.0, &nodes, &mut ranges);
        for rate in [plan.greatest_rate(&preview), plan.greatest_rate_within(&preview, &ranges)] {
            // The bisection ends within 2^-40 of the target rate.
            assert!((rate - greatest).abs() <= 5e-12, "{rate} for {path_speed:?}");
        }
    }
    Ok(())
}

#[test]
fn the_target_rate_itself_is_allowed_from_the_distance_at_which_it_can_be_stopped() -> Result<(), ParameterError> {
    // Joint 1 brakes with 2: 0.3² / (2 · 2) and half a sample of 0.1 s.
    let plan = plan(0.1, 0.3)?;
    let distance = 0.0225 + 0.015;
    let rate = |spacing| plan.greatest_rate(&Preview { offset: 0.0, spacing, path_speeds: &[[1.0, 0.5]; 2] });
    assert_eq!(rate(distance + 1e-6), 0.3);
    assert_eq!(rate(10.0 * distance), 0.3);
    // There the rate rises by 1 / (0.3 / 2 + 0.05) = 5 per distance.
    assert!((rate(distance - 1e-6) - (0.3 - 5e-6)).abs() < 1e-9);
    Ok(())
}

#[test]
fn where_a_joint_turns_round_the_curvature_alone_bounds_the_rate() -> Result<(), ParameterError> {
    let plan = LookAhead::new(LookAheadSettings {
        speed_limits: SpeedLimits::symmetric([100.0])?,
        acceleration_limits: AccelerationLimits::new([-4.0], [1.0])?,
        sampling_period: 1e-3,
        target_rate: 100.0,
        margin: 0.2,
    })?;
    let first = |near: f64, far: f64| {
        let mut ranges = [f64::NAN; 2];
        plan.ranges(0.5, &[[near], [far]], &mut ranges);
        ranges[0]
    };
    // q' = 0 and q'' = 2 / 0.5 = 4: 4 b = 0.8 · 1 at the near end. Backwards, at -4, the braking from q' = -2 comes before 0.8 · 4:
    // 2 b = 2 · 0.5 · 0.8 · 1 at the far end.
    assert!((first(0.0, 2.0) - 0.2).abs() < 1e-15);
    assert!((first(0.0, -2.0) - 0.4).abs() < 1e-15);
    // A joint that stands all along bounds nothing.
    assert_eq!(first(0.0, 0.0), 1e4);
    Ok(())
}

#[test]
fn a_preview_that_begins_ahead_of_the_robot_or_does_not_advance_allows_no_speed() -> Result<(), ParameterError> {
    let plan = plan(1e-3, 5.0)?;
    let (nodes, mut ranges) = ([[1.0; 2]; 4], [1.0; 4]);
    for (offset, spacing) in
        [(-1e-4, 0.1), (0.0, 0.0), (0.0, -0.1), (0.0, f64::INFINITY), (f64::INFINITY, 0.1), (0.75, 0.25)]
    {
        let preview = Preview { offset, spacing, path_speeds: &nodes };
        assert_eq!(plan.greatest_rate(&preview), 0.0, "{preview:?}");
        assert_eq!(plan.greatest_rate_within(&preview, &ranges), 0.0, "{preview:?}");
    }
    for spacing in [0.0, -0.1] {
        plan.ranges(spacing, &nodes, &mut ranges);
        assert_eq!(ranges, [0.0; 4]);
    }
    Ok(())
}

#[test]
fn ranges_shorter_than_the_path_end_at_rest() -> Result<(), ParameterError> {
    let plan = plan(1e-3, 5.0)?;
    let nodes = [[1.0, 0.5]; 6];
    let (mut short, mut cut) = ([f64::NAN; 4], [f64::NAN; 4]);
    plan.ranges(0.1, &nodes, &mut short);
    plan.ranges(0.1, &nodes[..4], &mut cut);
    assert_eq!(short, cut);
    // Longer ones: what is beyond the path is 0.
    let mut long = [f64::NAN; 8];
    plan.ranges(0.1, &nodes, &mut long);
    assert_eq!(long[5..], [0.0; 3]);
    assert!(long[..5].iter().all(|b| *b > 0.0));
    Ok(())
}

#[test]
fn settings_out_of_range_are_refused_with_their_value() -> Result<(), ParameterError> {
    let good = LookAheadSettings {
        speed_limits: SpeedLimits::symmetric([1.0])?,
        acceleration_limits: AccelerationLimits::symmetric([1.0])?,
        sampling_period: 1e-3,
        target_rate: 5.0,
        margin: 0.0,
    };
    let refused = |settings| LookAhead::new(settings).err();
    assert_eq!(refused(good), None);
    for margin in [-0.1, 1.0, f64::INFINITY] {
        assert_eq!(refused(LookAheadSettings { margin, ..good }), Some(ParameterError::AccelerationMargin(margin)));
    }
    assert!(refused(LookAheadSettings { margin: f64::NAN, ..good }).is_some());
    for bad in [0.0, -1.0, f64::INFINITY] {
        let settings = LookAheadSettings { sampling_period: bad, ..good };
        assert_eq!(refused(settings), Some(ParameterError::SamplingPeriod(bad)));
        let settings = LookAheadSettings { target_rate: bad, ..good };
        assert_eq!(refused(settings), Some(ParameterError::TargetRate(bad)));
    }
    Ok(())
}

/// Joint 1 turns round at `q'' = 100` up to the second node and stands from there on: within the turn `100 b <= 1` at any acceleration, for
/// twice the near row plus the far row of `[(v0, 3 v1 - 2 v0) = (-100 d, 200 d)]` is `300 b <= 3`. A rate that is evaluated beyond the
/// turn has nothing to keep but the stop; the rates between would have.
#[test]
fn a_turn_ahead_is_not_jumped_over() -> Result<(), ParameterError> {
    let plan = LookAhead::new(LookAheadSettings {
        speed_limits: SpeedLimits::symmetric([1e4; 2])?,
        acceleration_limits: AccelerationLimits::symmetric([1.0; 2])?,
        sampling_period: 1e-3,
        target_rate: 10.0,
        margin: 0.0,
    })?;
    let nodes = [[-1.0, 1.0], [0.0, 1.0], [0.0, 1.0], [0.0, 1.0], [0.0, 1.0]];
    let mut ranges = [0.0; 5];
    plan.ranges(0.01, &nodes, &mut ranges);
    // Of 0.0001 left of the turn; a sample at 0.2 and more would be evaluated beyond it.
    for offset in [0.0, 0.005, 0.0099] {
        let preview = Preview { offset, spacing: 0.01, path_speeds: &nodes };
        // The bisection's resolution: 2^-40 of the target rate.
        assert!((plan.greatest_rate(&preview) - 0.1).abs() < 1e-10, "{}", plan.greatest_rate(&preview));
        assert_eq!(plan.greatest_rate(&preview), plan.greatest_rate_within(&preview, &ranges));
    }
    Ok(())
}
