//! Laws that every profile obeys, on random limits and ends.

use proptest::prelude::*;
use slideway_motion::profile::{
    Cosine, Cubics, Hermite, Profile, Ramp, TrapezoidEnds, bounded_jerk, shortest_common, stop, trapezoid,
};
use slideway_motion::{
    AxisLimits, AxisState, Interpolation, JointState, MotionError, MotionLimits, MotionPlanner, WayPointRule,
    path_through,
};
use slideway_robot::JointVector;

/// Rounding of a few dozen operations on numbers below 1000.
const ROUNDING: f64 = 1e-10;

fn limits() -> impl Strategy<Value = AxisLimits> {
    (0.3..3.0_f64, 1.0..20.0_f64, 5.0..500.0_f64).prop_map(|(v, a, j)| AxisLimits::new(v, a, j).expect("positive"))
}

fn position() -> impl Strategy<Value = f64> {
    -3.0..3.0_f64
}

/// Shares of the speed limit.
fn share() -> impl Strategy<Value = f64> {
    -1.0..=1.0_f64
}

/// Bounds of speed and acceleration by sampling: the naive twin of the exact ones.
fn sampled(profile: &Profile) -> (f64, f64) {
    let duration = profile.duration();
    (0..=2000)
        .map(|k| profile.at(duration * f64::from(k) / 2000.0))
        .fold((0.0, 0.0), |(v, a), s| (f64::max(v, s.velocity.abs()), f64::max(a, s.acceleration.abs())))
}

fn assert_within(profile: &Profile, limits: &AxisLimits) {
    let peaks = profile.peaks();
    let (v, a) = (peaks.velocity.magnitude(), peaks.acceleration.magnitude());
    assert!(v <= limits.velocity() * (1.0 + ROUNDING) && a <= limits.acceleration() * (1.0 + ROUNDING), "{v} {a}");
    let (v_sampled, a_sampled) = sampled(profile);
    assert!(v_sampled <= v + ROUNDING && a_sampled <= a + ROUNDING, "a sample lies outside of the bounds");
    // The acceleration between two samples changes the speed by at most this.
    assert!(v - v_sampled <= a * profile.duration() / 2000.0 + ROUNDING, "the bounds are not tight");
}

fn assert_ends(profile: &Profile, start: (f64, f64), goal: (f64, f64)) {
    let (first, last) = (profile.at(0.0), profile.end());
    assert!((first.position - start.0).abs() <= ROUNDING && (first.velocity - start.1).abs() <= ROUNDING);
    assert!((last.position - goal.0).abs() <= ROUNDING && (last.velocity - goal.1).abs() <= ROUNDING, "{last:?}");
}

proptest! {
    #[test]
    fn trapezoids_join_any_two_speeds(limits in limits(), from in position(), to in position(), v0 in share(), vf in share()) {
        let (v0, vf) = (v0 * limits.velocity(), vf * limits.velocity());
        let ends = TrapezoidEnds { start: from, start_velocity: v0, goal: to, goal_velocity: vf };
        let profile = Profile::Cubics(trapezoid(&ends, &limits));
        assert_ends(&profile, (from, v0), (to, vf));
        assert_within(&profile, &limits);
    }

    /// No cubic of a shorter duration keeps the limits, on a grid of shorter ones.
    #[test]
    fn the_shortest_common_cubic_is_the_shortest(
        limits in prop::array::uniform2(limits()), from in position(), to in position(), v0 in share(), vf in share()
    ) {
        let cubics = limits.map(|l| Hermite {
            start: from, start_velocity: v0 * l.velocity(), goal: to, goal_velocity: vf * l.velocity(),
        });
        let duration = shortest_common(&cubics, &limits).expect("end speeds are allowed");
        for (cubic, limits) in cubics.iter().zip(&limits) {
            let profile = Profile::Cubics(cubic.over(duration));
            assert_ends(&profile, (from, cubic.start_velocity), (to, cubic.goal_velocity));
            assert_within(&profile, limits);
        }
        for k in 1..200 {
            let shorter = duration * f64::from(k) / 200.0;
            let keeps = cubics.iter().zip(&limits).all(|(cubic, limits)| {
                let peaks = Profile::Cubics(cubic.over(shorter)).peaks();
                peaks.velocity.magnitude() <= limits.velocity() && peaks.acceleration.magnitude() <= limits.acceleration()
            });
            prop_assert!(!keeps, "{shorter} is shorter than {duration}");
        }
    }

    #[test]
    fn cosines_keep_their_limits_and_reach_one(limits in limits(), from in position(), to in position()) {
        let profile = Profile::Cosine(Cosine::new(from, to, Cosine::shortest(from, to, &limits)));
        assert_ends(&profile, (from, 0.0), (to, 0.0));
        assert_within(&profile, &limits);
        let peaks = profile.peaks();
        let use_of_limits = (peaks.velocity.magnitude() / limits.velocity())
            .max(peaks.acceleration.magnitude() / limits.acceleration());
        prop_assert!((use_of_limits - 1.0).abs() < ROUNDING);
    }

    #[test]
    fn jerk_limited_motions_are_as_fast_as_the_planner(limits in limits(), from in position(), to in position()) {
        let ours = bounded_jerk(from, to, &limits);
        assert_ends(&Profile::Cubics(ours), (from, 0.0), (to, 0.0));
        assert_within(&Profile::Cubics(ours), &limits);
        prop_assert!(ours.bounds(0.0, ours.duration()).jerk.magnitude() <= limits.jerk() * (1.0 + ROUNDING));
        let rest = |q: f64| JointState::at_rest(JointVector::from([q]));
        let planned = MotionPlanner::default().plan(&rest(from), &rest(to), &[limits], Ramp::JerkLimited).expect("a motion");
        // The planner accepts roots to 1e-8 in position; at the end of a motion the jerk alone covers that in
        // cbrt(6e-8 / J) s, so two fastest motions can differ by no more.
        prop_assert!((ours.duration() - planned[0].duration()).abs() <= 2.0 * (6e-8 / limits.jerk()).cbrt());
    }

    #[test]
    fn stops_come_to_rest_within_their_limits(limits in limits(), v in share(), a in share()) {
        let acceleration = a * limits.acceleration();
        // A state from which a motion within the limits can go on: the speed that the acceleration still brings fits in.
        let room = limits.velocity() - acceleration * acceleration / (2.0 * limits.jerk());
        prop_assume!(room > 0.0);
        let state = AxisState { position: 0.0, velocity: v * room, acceleration };
        for ramp in [Ramp::AccelerationLimited, Ramp::JerkLimited] {
            let motion = stop(&state, &limits, ramp);
            assert_within(&Profile::Cubics(motion), &limits);
            let end = motion.end();
            prop_assert!(end.velocity.abs() <= ROUNDING, "{end:?}");
            if ramp == Ramp::JerkLimited {
                prop_assert!(end.acceleration.abs() <= ROUNDING);
                prop_assert!(motion.bounds(0.0, motion.duration()).jerk.magnitude() <= limits.jerk() * (1.0 + ROUNDING));
            } else {
                prop_assert!((motion.duration() - state.velocity.abs() / limits.acceleration()).abs() <= ROUNDING);
            }
        }
    }

    #[test]
    fn joints_arrive_together_and_the_slowest_is_not_slowed_down(
        limits in prop::array::uniform3(limits()), to in prop::array::uniform3(position())
    ) {
        let start = JointState::at_rest(JointVector::zeros());
        for family in [Interpolation::Linear, Interpolation::Trapezoid, Interpolation::Cosine, Interpolation::BoundedJerk] {
            let plan = |to: [f64; 3]| {
                family.plan(&mut MotionPlanner::default(), &start, &to.into(), &limits).expect("from rest to rest")
            };
            let motion = plan(to);
            let alone = (0..3).map(|i| plan(std::array::from_fn(|k| if k == i { to[k] } else { 0.0 })).duration());
            prop_assert!((motion.duration() - alone.fold(0.0, f64::max)).abs() <= ROUNDING);
            for (i, profile) in motion.profiles().iter().enumerate() {
                let peaks = profile.peaks();
                prop_assert!(peaks.velocity.magnitude() <= limits[i].velocity() * (1.0 + ROUNDING));
                prop_assert!((profile.duration() - motion.duration()).abs() <= ROUNDING || to[i] == 0.0);
                prop_assert!((profile.end().position - to[i]).abs() <= ROUNDING);
            }
        }
    }

    #[test]
    fn paths_through_way_points_are_as_smooth_as_their_rule_says(
        points in prop::collection::vec(prop::array::uniform2(position()), 2..8), limits in prop::array::uniform2(limits())
    ) {
        let points: Vec<JointVector<2>> = points.into_iter().map(JointVector::from).collect();
        for rule in [WayPointRule::MeanSlope, WayPointRule::Spline] {
            let path = path_through(&points, rule, &MotionLimits::without_stops(limits)).expect("distinct points");
            for (piece, ends) in path.iter().zip(points.windows(2)) {
                prop_assert!((piece.at(0.0).q - ends[0]).amax() <= ROUNDING && (piece.end().q - ends[1]).amax() <= ROUNDING);
                piece.profiles().iter().zip(&limits).for_each(|(profile, limits)| assert_within(profile, limits));
            }
            for pieces in path.windows(2) {
                let (before, after) = (pieces[0].end(), pieces[1].at(0.0));
                prop_assert!((before.qd - after.qd).amax() <= ROUNDING);
                // The pivots of the spline are sums of 1/h; the accelerations at most 20.
                let jump = (before.qdd - after.qdd).amax();
                prop_assert!(rule == WayPointRule::MeanSlope || jump <= 1e-8, "{jump}");
            }
            prop_assert!(path[0].at(0.0).qd.amax() == 0.0 && path[path.len() - 1].end().qd.amax() <= ROUNDING);
        }
    }
}

#[test]
fn mean_slopes_do_not_overshoot_where_the_direction_changes() {
    // Slopes 1, -1/2, 1/2, 1: all exact in binary, and so are their means.
    let velocities = WayPointRule::MeanSlope.velocities(&[0.0, 1.0, 0.5, 0.75, 1.75], &[1.0, 1.0, 0.5, 1.0]);
    assert_eq!(velocities, Ok(vec![0.0, 0.0, 0.0, 0.75, 0.0]));
    assert_eq!(WayPointRule::Spline.velocities(&[0.0, 1.0], &[0.0]), Err(MotionError::WayPoints { points: 2 }));
}

#[test]
fn limits_that_are_not_positive_numbers_are_refused() {
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(AxisLimits::new(bad, 1.0, 1.0).is_err() && AxisLimits::new(1.0, bad, 1.0).is_err());
        assert!(AxisLimits::new(1.0, 1.0, bad).is_err());
    }
    let axis = AxisLimits::new(1.0, 1.0, 1.0).expect("positive");
    assert!(MotionLimits::new([axis], [None], f64::NAN).is_err());
}

#[test]
fn a_motion_without_distance_takes_no_time() {
    let axis = AxisLimits::new(1.0, 1.0, 1.0).expect("positive");
    let rest: Cubics = bounded_jerk(0.3, 0.3, &axis);
    assert!(rest.duration() == 0.0 && rest.at(5.0) == AxisState::at_rest(0.3));
}
