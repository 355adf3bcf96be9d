//! After set-up nothing is allocated, by count.

use allocation_counter::measure;
use nalgebra::Vector3;
use slideway_motion::control::task_space::{OperationalSettings, OperationalSpace};
use slideway_motion::plant::{Actuation, Plant, PlantSettings, PlantState};
use slideway_motion::profile::Ramp;
use slideway_motion::tool::{Regulation, SpeedLaw, ToolCurve, ToolKinematics, ToolLimits, ToolPolyline};
use slideway_motion::{AxisLimits, Interpolation, MotionLimits, MotionQueue, Repeat};
use slideway_robot::{JointVector, Task, Twist, models};

fn home() -> JointVector<6> {
    JointVector::from([0.0, 0.8, -2.6, 3.1, 1.1, 2.8])
}

fn queue() -> MotionQueue<6, 16> {
    let limits = MotionLimits::without_stops([AxisLimits::new(1.5, 8.0, 200.0).expect("positive"); 6]);
    let kinematics = ToolKinematics::new(models::puma560(), Task::Pose, 0.02).expect("six joints");
    MotionQueue::new(limits, home()).expect("finite").with_tool(kinematics)
}

fn play(queue: &mut MotionQueue<6, 16>, samples: usize) {
    for _ in 0..samples {
        queue.advance(2e-3).expect("a free path");
    }
}

#[test]
fn commands_and_set_points_of_a_queue_allocate_nothing() {
    let mut queue = queue();
    let aside = home() + JointVector::from_element(0.3);
    let tool = ToolLimits {
        linear: AxisLimits::new(0.3, 1.0, 10.0).expect("positive"),
        angular: AxisLimits::new(1.0, 4.0, 40.0).expect("positive"),
        ramp: Ramp::JerkLimited,
    };
    let mut seam = models::puma560().forward(&home());
    seam.translation.vector += Vector3::new(0.05, 0.1, -0.05);
    let counted = measure(|| {
        for family in [Interpolation::Trapezoid, Interpolation::Cubic, Interpolation::BoundedJerk] {
            queue.go_to(&aside, family).expect("free");
            queue.go_to(&home(), family).expect("free");
            play(&mut queue, 100);
            queue.set_rate(0.5).expect("in [0, 1]");
            play(&mut queue, 50);
            queue.interrupt_to(&home(), family).expect("free");
            play(&mut queue, 1500);
        }
        // A path planned from a moving state ends within 2e-8 of its target; the line begins where it ended.
        queue.move_tool_to(&seam, &tool).expect("a free line");
        play(&mut queue, 50);
        queue.brake_on_path();
        play(&mut queue, 200);
        queue.set_rate(1.0).expect("in [0, 1]");
        queue.set_repeat(Repeat::Once).expect("no cycle");
        play(&mut queue, 50);
        queue.brake_fully();
        play(&mut queue, 500);
        queue.stop_at_way_point();
    });
    assert_eq!(counted.count_total, 0, "{counted:?}");
}

#[test]
fn speed_laws_that_decide_sample_by_sample_allocate_nothing() {
    let mut queue = queue();
    let start = models::puma560().forward(&home());
    let points = [[0.05, 0.1, -0.05], [0.0, 0.2, -0.05]].map(|by| start.translation.vector + Vector3::from(by));
    let counted = measure(|| {
        for law in [SpeedLaw::SlidingMode(Regulation::DEFAULT), SpeedLaw::Natural(Regulation::DEFAULT)] {
            let curve = ToolPolyline::new(&start, &points, 0.03, Vector3::zeros()).expect("a polyline");
            queue.move_tool_along(&ToolCurve::Polyline(curve), &law).expect("a free curve");
            play(&mut queue, 100);
            queue.brake_on_path();
            play(&mut queue, 200);
            queue.set_rate(1.0).expect("in [0, 1]");
            play(&mut queue, 2000);
            queue.go_to(&home(), Interpolation::Trapezoid).expect("free");
            play(&mut queue, 2000);
        }
    });
    assert_eq!(counted.count_total, 0, "{counted:?}");
}

#[test]
fn a_controlled_arm_in_simulation_allocates_nothing() {
    let dynamics = models::puma560_dynamics().expect("the built-in arm");
    let settings = OperationalSettings { length: 0.3, largest_inertia: 100.0, posture_damping: 0.0 };
    let largest = JointVector::from_element(200.0);
    let space = OperationalSpace::new(dynamics.clone(), Task::Pose, settings, largest).expect("sound settings");
    let plant = Plant::new(dynamics, PlantSettings::default()).expect("sound settings");
    let mut state = PlantState::at_rest(home());
    let counted = measure(|| {
        for _ in 0..100 {
            let torque = space.step(&state.q, &state.qd, &Twist::from_element(0.1), &Twist::zeros()).torque;
            plant.advance(&mut state, 1e-3, &mut |_| Actuation::torque(torque)).expect("resolved");
        }
    });
    assert_eq!(counted.count_total, 0, "{counted:?}");
}
