//! Cartesian segments: checked before they are queued, followed afterwards.

use nalgebra::{Rotation3, Vector3};
use slideway_motion::profile::Ramp;
use slideway_motion::tool::{ToolFault, ToolKinematics, ToolLimits, ToolLine};
use slideway_motion::{AxisLimits, Interpolation, MotionError, MotionLimits, MotionQueue, Progress};
use slideway_robot::{JointVector, Pose, PositionRange, Task, models, rotation_vector};

type Queue = MotionQueue<6, 8>;

const V: f64 = 1.5;
const A: f64 = 8.0;

fn home() -> JointVector<6> {
    JointVector::from([0.0, 0.8, -2.6, 3.1, 1.1, 2.8])
}

fn queue_with(stops: [Option<PositionRange>; 6]) -> Queue {
    let axes = [AxisLimits::new(V, A, 200.0).expect("positive"); 6];
    let limits = MotionLimits::new(axes, stops, 0.05).expect("room");
    let kinematics = ToolKinematics::new(models::puma560(), Task::Pose, 0.02).expect("six joints");
    Queue::new(limits, home()).expect("inside").with_tool(kinematics)
}

fn queue() -> Queue {
    queue_with([None; 6])
}

fn tool(speed: f64, ramp: Ramp) -> ToolLimits {
    let axis = |v: f64| AxisLimits::new(v, 4.0 * v, 40.0 * v).expect("positive");
    ToolLimits { linear: axis(speed), angular: axis(1.0), ramp }
}

/// A shift in the base frame and a turn about its z axis.
fn moved(by: [f64; 3], turn: f64) -> Pose {
    let mut pose = models::puma560().forward(&home());
    pose.translation.vector += Vector3::from(by);
    pose.rotation = Rotation3::from_axis_angle(&Vector3::z_axis(), turn) * pose.rotation;
    pose
}

fn seam() -> Pose {
    moved([0.05, 0.15, -0.05], 0.4)
}

/// Distance of the tool from a line, and how far its turn is off, both by search along the line.
fn off_line(line: &ToolLine, q: &JointVector<6>) -> (f64, f64) {
    let pose = models::puma560().forward(q);
    let direction = line.direction().fixed_rows::<3>(0).into_owned();
    let from_start = pose.translation.vector - line.at(0.0).translation.vector;
    let u = direction.dot(&from_start) / direction.norm_squared();
    let there = line.at(u);
    (
        (there.translation.vector - pose.translation.vector).norm(),
        rotation_vector(&(there.rotation * pose.rotation.inverse())).norm(),
    )
}

#[test]
fn the_tool_stays_on_its_line_and_the_joints_in_their_limits() {
    for ramp in [Ramp::AccelerationLimited, Ramp::JerkLimited] {
        let mut queue = queue();
        queue.move_tool_to(&seam(), &tool(1.0, ramp)).expect("a free line");
        let line = ToolLine::new(&models::puma560().forward(&home()), &seam());
        let mut before = queue.set_point();
        let period = 1e-3;
        while !queue.is_empty() {
            let after = queue.advance(period).expect("a free line");
            let (distance, turn) = off_line(&line, &after.q);
            // The inverse kinematics ends within 1e-10 m and rad.
            assert!(distance < 1e-9 && turn < 1e-9, "{distance} {turn}");
            assert!(after.qd.amax() <= V && after.qdd.amax() <= A);
            // What the speeds say is what the positions do, up to the acceleration over half a period squared.
            let drift = after.q - before.q - before.qd * period;
            assert!(drift.amax() <= 0.5 * A * period * period + 1e-9);
            before = after;
        }
        assert!((models::puma560().forward(&before.q).translation.vector - seam().translation.vector).norm() < 1e-9);
    }
}

#[test]
fn tool_and_joint_motions_mix() {
    let mut queue = queue();
    let aside = home() + JointVector::from_element(0.1);
    queue.go_to(&aside, Interpolation::BoundedJerk).expect("free");
    queue.go_to(&home(), Interpolation::Trapezoid).expect("free");
    queue.move_tool_to(&seam(), &tool(0.5, Ramp::JerkLimited)).expect("a free line");
    queue.go_to(&home(), Interpolation::Cubic).expect("free");
    let mut before = queue.set_point();
    while !queue.is_empty() {
        let after = queue.advance(2e-3).expect("free");
        assert!((after.q - before.q).amax() <= V * 2e-3 + 1e-9);
        assert!((after.qd - before.qd).amax() <= A * 2e-3 + 1e-9);
        before = after;
    }
    assert!((before.q - home()).amax() < 1e-12);
}

#[test]
fn lines_out_of_reach_are_refused_where_the_reach_ends() {
    let mut queue = queue();
    let refused = queue.move_tool_to(&moved([2.0, 0.0, 0.0], 0.0), &tool(0.5, Ramp::JerkLimited));
    let Err(MotionError::Tool { share, place, cause }) = refused else { panic!("{refused:?}") };
    // Upper arm and forearm are 0.4318 m and hypot(0.0203, 0.4318) m long, the shoulder is 0.15005 m aside.
    let reach = 0.4318 + 0.0203_f64.hypot(0.4318);
    let outer = (reach * reach + 0.15005 * 0.15005).sqrt();
    let distance = Vector3::from(place).norm();
    assert!(matches!(*cause, ToolFault::Unreachable(_) | ToolFault::Singular { .. }), "{cause}");
    // One sample of 256 on two metres, and the width of the neighbourhood of the stretched elbow.
    assert!(share > 0.0 && (distance - outer).abs() < 0.03, "{distance} {outer}");
    assert!(queue.is_empty());
}

#[test]
fn lines_through_the_wrist_singularity_are_refused_by_name() {
    let mut queue = queue();
    // q5 from 1.1 through 0 by turning the tool about the axis of joint 5.
    let arm = models::puma560();
    let axis = arm.frames(&home()).axes[4];
    let mut goal = arm.forward(&home());
    goal.rotation = Rotation3::new(axis * -2.0) * goal.rotation;
    let refused = queue.move_tool_to(&goal, &tool(0.5, Ramp::AccelerationLimited));
    let Err(MotionError::Tool { share, cause, .. }) = refused else { panic!("{refused:?}") };
    assert!(matches!(*cause, ToolFault::Singular { .. }), "{cause}");
    // The wrist is singular at 1.1 of 2 rad; the neighbourhood is left out.
    assert!((share - 0.55).abs() < 0.05 && share < 0.55, "{share}");
}

#[test]
fn lines_beyond_a_stop_are_refused_by_joint() {
    let mut stops = [None; 6];
    stops[0] = Some(PositionRange { lower: -0.2, upper: 0.2 });
    let mut queue = queue_with(stops);
    let refused = queue.move_tool_to(&seam(), &tool(0.5, Ramp::JerkLimited));
    let Err(MotionError::Tool { cause, .. }) = refused else { panic!("{refused:?}") };
    assert!(matches!(*cause, ToolFault::JointStop { joint: 0, limit, .. } if (limit.abs() - 0.15).abs() < 1e-12));
}

#[test]
fn braking_on_a_tool_path_stays_on_it() {
    for begin in [0.1, 0.2, 0.3, 0.4] {
        let mut queue = queue();
        queue.move_tool_to(&seam(), &tool(0.4, Ramp::JerkLimited)).expect("a free line");
        let line = ToolLine::new(&models::puma560().forward(&home()), &seam());
        let mut before = queue.set_point();
        let mut time = 0.0;
        while queue.progress() == Progress::Moving {
            if time >= begin {
                queue.brake_on_path();
            }
            let after = queue.advance(1e-3).expect("a free line");
            assert!(off_line(&line, &after.q).0 < 1e-9 && after.qdd.amax() <= A);
            assert!((after.qd - before.qd).amax() <= A * 1e-3 + 1e-9);
            before = after;
            time += 1e-3;
        }
        assert!(before.is_at_rest());
    }
}

#[test]
fn a_queue_without_an_arm_refuses_tool_commands() {
    let limits = MotionLimits::without_stops([AxisLimits::new(V, A, 200.0).expect("positive"); 6]);
    let mut queue = Queue::new(limits, home()).expect("finite");
    assert_eq!(queue.move_tool_to(&seam(), &tool(0.5, Ramp::JerkLimited)), Err(MotionError::NoTool));
}

/// The check before the motion leaves nothing to find out later but what lies between its samples; the check in each sample
/// does not rely on that.
#[test]
fn following_stops_at_singularities_and_out_of_reach() {
    let kinematics = ToolKinematics::new(models::puma560(), Task::Pose, 0.02).expect("six joints");
    let still = nalgebra::Vector6::zeros();
    let mut singular = home();
    singular[4] = 0.0;
    let pose = models::puma560().forward(&singular);
    let fault = kinematics.follow(&pose, &still, &still, &singular).expect_err("the wrist is stretched");
    assert!(matches!(fault, ToolFault::Singular { smallest, .. } if smallest < 1e-9), "{fault}");
    let fault = kinematics.follow(&moved([3.0, 0.0, 0.0], 0.0), &still, &still, &home()).expect_err("too far");
    assert!(matches!(fault, ToolFault::Unreachable(_)), "{fault}");
    let mut nan = moved([0.0; 3], 0.0);
    nan.translation.vector.x = f64::NAN;
    assert!(kinematics.follow(&nan, &still, &still, &home()).is_err());
    assert_eq!(queue().move_tool_to(&nan, &tool(0.5, Ramp::JerkLimited)), Err(MotionError::PoseNotFinite));
}
