//! Cartesian segments whose speed is decided sample by sample: on the curve, inside the limits, to rest, braked and taken up again.

use nalgebra::Vector3;
use slideway_motion::profile::Ramp;
use slideway_motion::tool::{Regulation, SpeedLaw, ToolCurve, ToolHelix, ToolKinematics, ToolLimits, ToolPolyline};
use slideway_motion::{
    AxisLimits, CurveFault, Interpolation, JointState, MotionError, MotionLimits, MotionQueue, Progress, Repeat,
};
use slideway_robot::{JointVector, Pose, Task, models, rotation_vector};

type Queue = MotionQueue<6, 8>;

const V: f64 = 1.5;
const A: f64 = 8.0;
const PERIOD: f64 = 1e-3;

fn home() -> JointVector<6> {
    JointVector::from([0.0, 0.8, -2.6, 3.1, 1.1, 2.8])
}

fn queue() -> Queue {
    let axes = [AxisLimits::new(V, A, 200.0).expect("positive"); 6];
    let kinematics = ToolKinematics::new(models::puma560(), Task::Pose, 0.02).expect("six joints");
    Queue::new(MotionLimits::without_stops(axes), home()).expect("finite").with_tool(kinematics)
}

/// A seam with two corners.
fn seam() -> ToolCurve {
    let start = models::puma560().forward(&home());
    let from = start.translation.vector;
    let points = [[0.05, 0.1, -0.05], [-0.05, 0.2, -0.05], [-0.05, 0.3, 0.05]].map(|by| from + Vector3::from(by));
    ToolCurve::Polyline(ToolPolyline::new(&start, &points, 0.02, Vector3::new(0.0, 0.0, 0.4)).expect("a polyline"))
}

fn arc() -> ToolCurve {
    let start = models::puma560().forward(&home());
    let centre = start.translation.vector + Vector3::new(0.0, 0.12, 0.0);
    ToolCurve::Helix(ToolHelix::new(&start, centre, Vector3::z(), 3.0, -0.05, Vector3::zeros()).expect("a helix"))
}

fn laws() -> [SpeedLaw; 2] {
    [SpeedLaw::SlidingMode(Regulation::DEFAULT), SpeedLaw::Natural(Regulation::DEFAULT)]
}

/// Distance of the tool from a curve and how far its turn is off, at the nearest place by search.
fn off_curve(curve: &ToolCurve, q: &JointVector<6>) -> (f64, f64) {
    let pose = models::puma560().forward(q);
    let distance = |u: f64| (curve.at(u).pose.translation.vector - pose.translation.vector).norm();
    let coarse = (0..=40).map(|k| f64::from(k) / 40.0).min_by(|a, b| distance(*a).total_cmp(&distance(*b)));
    let mut u = coarse.expect("some");
    // Newton's method for the foot of the perpendicular.
    for _ in 0..20 {
        let place = curve.at(u);
        let (twist, gap) = (place.twist.fixed_rows::<3>(0), place.pose.translation.vector - pose.translation.vector);
        u = (u - gap.dot(&twist) / twist.norm_squared()).clamp(0.0, 1.0);
    }
    let place: Pose = curve.at(u).pose;
    (distance(u), rotation_vector(&(place.rotation * pose.rotation.inverse())).norm())
}

/// Plays a queue to its end or to a pause and checks every set-point; `act` is called before each sample.
fn play(queue: &mut Queue, curve: &ToolCurve, mut act: impl FnMut(&mut Queue, f64)) -> f64 {
    let mut before: JointState<6> = queue.set_point();
    let mut time = 0.0;
    while queue.progress() == Progress::Moving {
        act(queue, time);
        let after = queue.advance(PERIOD).expect("a free curve");
        let (distance, turn) = off_curve(curve, &after.q);
        // The inverse kinematics ends within 1e-10 m and rad. The turn is compared at the nearest place, found to 1e-10 m of half a metre.
        assert!(distance < 1e-9 && turn < 1e-9, "{distance:e} {turn:e} at {time}");
        assert!(after.qd.amax() <= V, "{}", after.qd.amax());
        assert!((after.qd - before.qd).amax() <= A * PERIOD, "{} at {time}", (after.qd - before.qd).amax());
        // What the speeds say is what the positions do, up to the acceleration over half a period squared.
        assert!((after.q - before.q - before.qd * PERIOD).amax() <= 0.51 * A * PERIOD * PERIOD + 1e-9);
        before = after;
        time += PERIOD;
        assert!(time < 30.0);
    }
    assert!(before.is_at_rest(), "{before:?}");
    time
}

fn tool(queue: &Queue) -> Vector3<f64> {
    models::puma560().forward(&queue.set_point().q).translation.vector
}

fn end_of(curve: &ToolCurve) -> Vector3<f64> {
    curve.at(1.0).pose.translation.vector
}

#[test]
fn the_tool_stays_on_its_curve_the_joints_in_their_limits_and_the_end_is_at_rest() {
    for curve in [seam(), arc()] {
        for law in laws() {
            let mut queue = queue();
            queue.move_tool_along(&curve, &law).expect("a free curve");
            let rehearsed = queue.path_time_left();
            let time = play(&mut queue, &curve, |_, _| {});
            assert!((tool(&queue) - end_of(&curve)).norm() < 1e-9 && queue.is_empty());
            // Sums of a thousand periods.
            assert!((time - rehearsed).abs() < 1e-9, "{time} {rehearsed}");
        }
    }
}

#[test]
fn sliding_mode_is_faster_than_natural_motion_and_than_a_profile_stretched_to_the_same_limits() {
    let axis = |v: f64| AxisLimits::new(v, 100.0 * v, 1e4 * v).expect("positive");
    let profile = ToolLimits { linear: axis(10.0), angular: axis(10.0), ramp: Ramp::AccelerationLimited };
    let [sliding, natural] = laws();
    for curve in [seam(), arc()] {
        let times = [sliding, natural, SpeedLaw::Profile(profile)].map(|law| {
            let mut queue = queue();
            queue.move_tool_along(&curve, &law).expect("a free curve");
            let mut samples = 0;
            while !queue.is_empty() {
                queue.advance(PERIOD).expect("a free curve");
                samples += 1;
            }
            samples
        });
        assert!(times[0] < times[1] && times[0] < times[2], "{times:?}");
    }
}

#[test]
fn a_brake_on_the_curve_stays_on_it_and_the_motion_is_taken_up_again() {
    for curve in [seam(), arc()] {
        for law in laws() {
            for begin in [0.0, 0.05, 0.3, 0.7] {
                let mut queue = queue();
                queue.move_tool_along(&curve, &law).expect("a free curve");
                let time = play(&mut queue, &curve, |queue, time| {
                    if time >= begin {
                        queue.brake_on_path();
                    }
                });
                // On a curve that passes no joint's turning point at speed, `max v / A` is what a brake takes; four times that leaves
                // room for curves whose bends hold it up.
                assert!(time <= begin + 4.0 * V / A, "{time}");
                assert_eq!(queue.progress(), Progress::Paused);
                let there = queue.set_point();
                assert_eq!(queue.advance(PERIOD).expect("at rest"), there);
                queue.set_rate(1.0).expect("in [0, 1]");
                play(&mut queue, &curve, |_, _| {});
                assert!((tool(&queue) - end_of(&curve)).norm() < 1e-9 && queue.is_empty());
            }
        }
    }
}

#[test]
fn at_half_the_pace_no_joint_exceeds_half_its_speed() {
    for law in laws() {
        let mut queue = queue();
        queue.move_tool_along(&arc(), &law).expect("a free curve");
        queue.set_rate(0.5).expect("in [0, 1]");
        while queue.progress() == Progress::Moving {
            let state = queue.advance(PERIOD).expect("a free curve");
            // The look-ahead's rate is below what the speed limits allow, by a thousandth.
            assert!(state.qd.amax() <= 0.5 * V);
        }
    }
}

#[test]
fn set_points_do_not_depend_on_how_time_is_cut() {
    for law in laws() {
        let mut fine = queue();
        fine.move_tool_along(&seam(), &law).expect("a free curve");
        let mut coarse = queue();
        coarse.move_tool_along(&seam(), &law).expect("a free curve");
        for step in 1..=100 {
            let parts = [0.3e-3, 1.9e-3, 1e-4, 2.7e-3];
            let many = parts.map(|dt| fine.advance(dt).expect("a free curve")).last().copied().expect("four");
            let one = coarse.advance(parts.iter().sum()).expect("a free curve");
            // Inverse kinematics from different seeds, 1e-10 m over the smallest singular value 0.02 at most.
            assert!((one.q - many.q).amax() <= 5e-9, "{step}: {:e}", (one.q - many.q).amax());
        }
    }
}

#[test]
fn curves_mix_with_joint_motions_and_go_round() {
    for law in laws() {
        let mut queue = queue();
        let aside = home() + JointVector::from_element(0.1);
        queue.go_to(&aside, Interpolation::BoundedJerk).expect("free");
        queue.go_to(&home(), Interpolation::Trapezoid).expect("free");
        queue.move_tool_along(&arc(), &law).expect("a free curve");
        queue.go_to(&home(), Interpolation::Cubic).expect("free");
        queue.set_repeat(Repeat::Forever).expect("closed");
        let round = queue.path_time_left();
        let mut before = queue.set_point();
        let mut time = 0.0;
        while time < 2.5 * round {
            let after = queue.advance(1.7e-3).expect("free");
            assert!((after.qd - before.qd).amax() <= 1.02 * A * 1.7e-3, "at {time}");
            before = after;
            time += 1.7e-3;
        }
        queue.stop_at_way_point();
        while queue.progress() != Progress::Resting {
            queue.advance(PERIOD).expect("free");
        }
        assert!(queue.set_point().is_at_rest());
    }
}

#[test]
fn a_curve_is_left_by_a_full_brake_or_for_a_new_target() {
    for law in laws() {
        let mut braked = queue();
        braked.move_tool_along(&seam(), &law).expect("a free curve");
        braked.advance(0.3).expect("a free curve");
        let speed = braked.set_point().qd.amax();
        assert!(speed > 0.1);
        braked.brake_fully();
        let rest = braked.advance(speed / A + 1e-6).expect("joint motions do not fail");
        assert!(rest.is_at_rest() && braked.is_empty());

        let mut queue = queue();
        queue.move_tool_along(&seam(), &law).expect("a free curve");
        queue.advance(0.3).expect("a free curve");
        queue.interrupt_to(&home(), Interpolation::Trapezoid).expect("no stops in the way");
        let left = queue.path_time_left();
        let rest = queue.advance(left + PERIOD).expect("joint motions do not fail");
        // The planner of moving states ends within 2e-8.
        assert!((rest.q - home()).amax() <= 2e-8);
    }
}

#[test]
fn curves_that_begin_elsewhere_and_settings_out_of_range_are_refused() {
    let mut queue = queue();
    let [law, _] = laws();
    let mut start = models::puma560().forward(&home());
    start.translation.vector.x += 1e-6;
    let goal = start.translation.vector + Vector3::new(0.0, 0.1, 0.0);
    let line = ToolPolyline::new(&start, &[goal], 0.0, Vector3::zeros()).expect("a line");
    let refused = queue.move_tool_along(&ToolCurve::Polyline(line), &law);
    assert!(matches!(refused, Err(MotionError::NotAtStart { distance, .. }) if (distance - 1e-6).abs() < 1e-9));
    let bad = Regulation { sampling_period: f64::NAN, ..Regulation::DEFAULT };
    assert!(matches!(queue.move_tool_along(&seam(), &SpeedLaw::SlidingMode(bad)), Err(MotionError::Regulation(_))));
    assert!(queue.is_empty());
}

#[test]
fn curves_without_room_are_refused_by_line() {
    let start = models::puma560().forward(&home());
    let from = start.translation.vector;
    let made = |points: &[Vector3<f64>], blend| ToolPolyline::new(&start, points, blend, Vector3::zeros());
    let (a, b) = (from + Vector3::x() * 0.1, from + Vector3::new(0.1, 0.05, 0.0));
    assert_eq!(made(&[], 0.01), Err(MotionError::Curve(CurveFault::Points { given: 0 })));
    assert_eq!(made(&[a, a], 0.01), Err(MotionError::Curve(CurveFault::NoLength { line: 1 })));
    assert!(matches!(made(&[a, b], 0.06), Err(MotionError::Curve(CurveFault::Blend { line: 1, .. }))));
    assert!(matches!(made(&[a, b], 0.0), Err(MotionError::Curve(CurveFault::Blend { line: 0, .. }))));
    assert_eq!(made(&[a, b * f64::NAN], 0.01), Err(MotionError::Curve(CurveFault::NotFinite)));
    let arc = |axis, angle| ToolHelix::new(&start, from + Vector3::x() * 0.1, axis, angle, 0.0, Vector3::zeros());
    assert_eq!(arc(Vector3::zeros(), 1.0), Err(MotionError::Curve(CurveFault::NoAxis)));
    assert_eq!(arc(Vector3::x(), 1.0), Err(MotionError::Curve(CurveFault::NoAxis)));
    assert!(arc(Vector3::z(), 1.0).is_ok());
}

/// The derivatives are those of the pose, by central differences: error `h² / 6` of the third derivative plus rounding over `h`.
#[test]
fn the_derivatives_of_a_curve_are_those_of_its_pose() {
    for curve in [seam(), arc()] {
        for k in 1..100 {
            let (u, h) = (f64::from(k) / 100.0, 1e-5);
            let (before, at, after) = (curve.at(u - h), curve.at(u), curve.at(u + h));
            let shift = (after.pose.translation.vector - before.pose.translation.vector) / (2.0 * h);
            let turn = rotation_vector(&(after.pose.rotation * before.pose.rotation.inverse())) / (2.0 * h);
            // Third derivatives of at most 6 · 2 · 0.4 m / (2 · 0.05)² = 500 m: 1e-8 m; rounding 1e-16 / 1e-5.
            assert!((shift - at.twist.fixed_rows::<3>(0)).norm() < 5e-8, "{u}");
            assert!((turn - at.twist.fixed_rows::<3>(3)).norm() < 5e-8, "{u}");
            let slope = (after.twist - before.twist) / (2.0 * h);
            // The second derivative has kinks where a corner begins: there the difference is of first order, 500 m · h.
            assert!((slope - at.slope).norm() < 1e-2, "{u} {}", (slope - at.slope).norm());
        }
    }
}
