//! Each interruption: where it leads, and how long it takes.

use proptest::prelude::*;
use slideway_motion::profile::Ramp;
use slideway_motion::{
    AxisLimits, Interpolation, JointState, MotionError, MotionLimits, MotionQueue, Progress, Repeat, WayPointRule,
    path_through,
};
use slideway_robot::{JointVector, PositionRange};

type Queue = MotionQueue<2, 8>;

const V: f64 = 1.5;
const A: f64 = 4.0;
const J: f64 = 60.0;

fn limits() -> MotionLimits<2> {
    MotionLimits::without_stops([AxisLimits::new(V, A, J).expect("positive"); 2])
}

fn queue() -> Queue {
    Queue::new(limits(), JointVector::zeros()).expect("finite")
}

fn at(x: f64, y: f64) -> JointVector<2> {
    JointVector::from([x, y])
}

fn run(queue: &mut Queue, seconds: f64) -> JointState<2> {
    let steps = (seconds / 1e-3).ceil() as usize;
    (0..steps).fold(queue.set_point(), |_, _| queue.advance(1e-3).expect("joint motions do not fail"))
}

fn interpolation() -> impl Strategy<Value = Interpolation> {
    prop_oneof![Just(Interpolation::Trapezoid), Just(Interpolation::Cubic), Just(Interpolation::BoundedJerk)]
}

/// Three Go-Tos, or a path through the same points without a stop.
fn filled(interpolation: Interpolation, points: &[[f64; 2]; 3]) -> Queue {
    let mut queue = queue();
    if interpolation == Interpolation::Cubic {
        let points: Vec<_> = [[0.0; 2]].iter().chain(points).map(|&p| JointVector::from(p)).collect();
        let path = path_through(&points, WayPointRule::Spline, queue.limits()).expect("distinct points");
        queue.move_along(&path, Some(Ramp::AccelerationLimited)).expect("a sound path");
    } else {
        for point in points {
            queue.go_to(&JointVector::from(*point), interpolation).expect("room");
        }
    }
    queue
}

fn points() -> impl Strategy<Value = [[f64; 2]; 3]> {
    prop::array::uniform3(prop::array::uniform2(-2.0..2.0_f64)).prop_filter("distinct", |p| {
        let far = |a: &[f64; 2], b: &[f64; 2]| (a[0] - b[0]).abs() + (a[1] - b[1]).abs() > 0.1;
        far(&[0.0; 2], &p[0]) && far(&p[0], &p[1]) && far(&p[1], &p[2])
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    /// The twin runs at full pace to the same path time.
    #[test]
    fn braking_on_the_path_stays_on_it_and_comes_to_rest(
        family in interpolation(), points in points(), begin in 0.0..3.0_f64, pace in 0.1..1.0_f64
    ) {
        let mut queue = filled(family, &points);
        let length = queue.path_time_left();
        run(&mut queue, begin);
        queue.set_rate(pace).expect("in [0, 1]");
        run(&mut queue, 0.3);
        queue.brake_on_path();
        // Either no law ever fits and the queue ends, or the gentlest one has to: 1/α + α/β with α = A/V/32, β = J/V/32,
        // plus what a slope already there takes to turn round, which is no more than the same again.
        let gentlest = 2.0 * (32.0 * V / A + A / J);
        let waiting = length / pace;
        let mut left = waiting + gentlest;
        while queue.progress() == Progress::Moving {
            let state = queue.advance(1e-3).expect("joint motions do not fail");
            left -= 1e-3;
            prop_assert!(left > -1e-3, "no rest in time");
            let mut twin = filled(family, &points);
            let time = length - queue.path_time_left();
            if !queue.is_empty() && time > 0.0 {
                let there = twin.advance(time).expect("joint motions do not fail");
                // Rounding of path time, times the speed.
                prop_assert!((there.q - state.q).norm() <= 1e-11);
            }
        }
        let rest = queue.set_point();
        prop_assert!(rest.is_at_rest() && rest == queue.advance(1e-3).expect("at rest"));
    }

    #[test]
    fn a_paused_path_is_resumed_to_its_end(family in interpolation(), points in points(), begin in 0.0..3.0_f64) {
        let mut queue = filled(family, &points);
        run(&mut queue, begin);
        queue.brake_on_path();
        while queue.progress() == Progress::Moving {
            queue.advance(1e-3).expect("joint motions do not fail");
        }
        queue.set_rate(1.0).expect("in [0, 1]");
        while queue.progress() != Progress::Resting {
            queue.advance(1e-3).expect("joint motions do not fail");
        }
        prop_assert!((queue.set_point().q - JointVector::from(points[2])).norm() <= 1e-12);
    }

    /// `max |v| / A`, and with bounded jerk `2 A / J` more, or what the acceleration there takes to turn round.
    #[test]
    fn full_braking_takes_no_longer_than_stated(family in interpolation(), points in points(), begin in 0.0..3.0_f64) {
        let mut queue = filled(family, &points);
        let state = run(&mut queue, begin);
        queue.brake_fully();
        let ramps = if family == Interpolation::BoundedJerk { 4.0 * A / J } else { 0.0 };
        let bound = state.qd.amax() / A + ramps;
        let rest = run(&mut queue, bound + 2e-3);
        prop_assert!(queue.is_empty() && rest.is_at_rest());
    }

    #[test]
    fn a_new_target_is_reached_from_a_moving_state(
        family in interpolation(), points in points(), begin in 0.0..3.0_f64, x in -2.0..2.0_f64, y in -2.0..2.0_f64
    ) {
        let mut queue = filled(family, &points);
        run(&mut queue, begin);
        queue.interrupt_to(&at(x, y), family).expect("no stops in the way");
        let left = queue.path_time_left();
        let rest = run(&mut queue, left + 2e-3);
        // The planner of moving states ends within 2e-8.
        prop_assert!(queue.is_empty() && (rest.q - at(x, y)).amax() <= 2e-8);
    }
}

#[test]
fn stopping_at_a_way_point_stops_there() {
    let mut queue = filled(Interpolation::BoundedJerk, &[[1.0, 0.0], [1.0, 1.0], [0.0, 0.0]]);
    run(&mut queue, 0.4);
    queue.stop_at_way_point();
    let rest = run(&mut queue, 5.0);
    assert!((rest.q - at(1.0, 0.0)).norm() < 1e-12 && rest.is_at_rest() && queue.is_empty());
}

#[test]
fn a_brake_on_the_path_goes_no_further_than_the_next_way_point() {
    for family in [Interpolation::Trapezoid, Interpolation::BoundedJerk] {
        for thousandths in 1..100_u32 {
            let mut queue = filled(family, &[[1.0, 0.3], [1.0, 1.0], [0.0, 0.0]]);
            let mut first = self::queue();
            first.go_to(&at(1.0, 0.3), family).expect("room");
            run(&mut queue, first.path_time_left() - 1e-3 * f64::from(5 * thousandths).min(900.0));
            queue.brake_on_path();
            while queue.progress() == Progress::Moving {
                queue.advance(1e-3).expect("joint motions do not fail");
            }
            let rest = queue.set_point();
            assert!(rest.is_at_rest() && rest.q[0] <= 1.0 + 1e-12 && rest.q[1] <= 0.3 + 1e-12, "{}", rest.q);
        }
    }
}

#[test]
fn a_cycle_comes_round_until_it_is_ended() {
    let mut queue = filled(Interpolation::BoundedJerk, &[[1.0, 0.0], [1.0, 1.0], [0.0, 0.0]]);
    let round = queue.path_time_left();
    queue.set_repeat(Repeat::Forever).expect("closed");
    let first = run(&mut queue, 0.6);
    let tenth = (0..9).fold(first, |_, _| queue.advance(round).expect("joint motions do not fail"));
    // Nine sums of the path time round to a few ulp of ten seconds; the speed is at most 1.5.
    assert!((first.q - tenth.q).norm() < 1e-12 && queue.len() == 3);
    assert_eq!(queue.go_to(&at(0.5, 0.5), Interpolation::Cubic), Err(MotionError::Cyclic));
    queue.stop_at_way_point();
    assert!((run(&mut queue, 5.0).q - at(1.0, 0.0)).norm() < 1e-12);
}

#[test]
fn an_open_cycle_is_refused() {
    let mut queue = filled(Interpolation::Trapezoid, &[[1.0, 0.0], [1.0, 1.0], [0.2, 0.0]]);
    assert!(matches!(queue.set_repeat(Repeat::Forever), Err(MotionError::NotClosed { joint: 0, .. })));
}

#[test]
fn an_edited_target_moves_both_its_neighbours() {
    let mut queue = filled(Interpolation::Trapezoid, &[[1.0, 0.0], [1.0, 1.0], [0.0, 0.0]]);
    run(&mut queue, 0.3);
    queue.replace_target(1, &at(-1.0, 0.5)).expect("a Go-To ahead");
    assert_eq!(queue.replace_target(0, &at(0.0, 0.0)), Err(MotionError::NotEditable { index: 0 }));
    let mut nearest = f64::INFINITY;
    while !queue.is_empty() {
        let state = queue.advance(1e-3).expect("joint motions do not fail");
        nearest = nearest.min((state.q - at(-1.0, 0.5)).norm());
    }
    // A sample falls within half a period of the way-point, where the speed is at most A T / 2 per joint.
    assert!(nearest <= A * 1e-6 && (queue.end() - at(0.0, 0.0)).norm() < 1e-12);
}

#[test]
fn discontinuous_references_are_refused_by_joint_and_amount() {
    let mut queue = queue();
    let path = path_through(&[at(0.0, 0.1), at(1.0, 1.0)], WayPointRule::Spline, queue.limits()).expect("two points");
    let refused = queue.move_along(&path, None);
    assert!(matches!(refused, Err(MotionError::Discontinuous { joint: 1, jump, .. }) if (jump - 0.1).abs() < 1e-12));
    let points = [at(0.0, 0.0), at(1.0, 1.0), at(2.0, 0.0)];
    let path = path_through(&points, WayPointRule::Spline, queue.limits()).expect("three points");
    let ramp = Some(Ramp::AccelerationLimited);
    assert!(matches!(queue.move_along(&path[..1], ramp), Err(MotionError::Discontinuous { joint: 0, .. })));
    assert!(matches!(queue.move_along(&path, Some(Ramp::JerkLimited)), Err(MotionError::Discontinuous { .. })));
    assert!(queue.is_empty() && queue.move_along(&path, ramp).is_ok());
}

#[test]
fn motions_into_the_margin_of_a_stop_are_refused() {
    let axes = [AxisLimits::new(V, A, J).expect("positive"); 2];
    let stops = [None, Some(PositionRange { lower: -1.0, upper: 1.0 })];
    let limits = MotionLimits::new(axes, stops, 0.1).expect("room");
    let mut queue = Queue::new(limits, JointVector::zeros()).expect("inside");
    let refused = queue.go_to(&at(5.0, 0.95), Interpolation::Trapezoid);
    assert_eq!(refused, Err(MotionError::JointStop { joint: 1, position: 0.95, limit: 0.9 }));
    // Turning round at full speed swings out beyond the stop: the motion under way is the safe one and goes on.
    queue.go_to(&at(0.0, 0.89), Interpolation::Trapezoid).expect("inside");
    run(&mut queue, 0.65);
    let before = queue.path_time_left();
    assert!(queue.interrupt_to(&at(0.0, 0.1), Interpolation::Cubic).is_err());
    assert_eq!(queue.path_time_left(), before);
}

#[test]
fn nan_in_a_command_is_refused() {
    let mut queue = queue();
    let nan = at(0.0, f64::NAN);
    for family in [Interpolation::Linear, Interpolation::BoundedJerk, Interpolation::Cubic, Interpolation::Cosine] {
        assert_eq!(queue.go_to(&nan, family), Err(MotionError::NotFinite { joint: 1 }));
        assert_eq!(queue.interrupt_to(&nan, family), Err(MotionError::NotFinite { joint: 1 }));
    }
    assert!(queue.advance(f64::NAN).is_err() && queue.set_rate(f64::NAN).is_err() && queue.is_empty());
}
