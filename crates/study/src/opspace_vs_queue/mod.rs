//! Control in operational space against a Cartesian queue under joint PID: `[R16]`, exercise 5.
//!
//! *Step*: the tool's target jumps. In operational space each coordinate answers alike, and the tool goes straight; under joint
//! PID each joint does what its gains say, and it does not.
//!
//! *Line*: both follow the set-points of one Cartesian segment of the queue; on the way the tool is pushed sideways with 20 N for
//! 0.3 s.

mod laws;

use crate::bench::{PERIOD, READY, joints_at, plant, puma};
use crate::{NamedNumber, Panel, Report, Role, Scales, Series, Study, StudyError};
use laws::{Controllers, Law};
use nalgebra::Vector3;
use slideway_motion::control::task_space::ToolReference;
use slideway_motion::plant::{Actuation, PlantState};
use slideway_motion::profile::Ramp;
use slideway_motion::tool::{ToolKinematics, ToolLimits};
use slideway_motion::{AxisLimits, JointState, MotionError, MotionLimits, MotionQueue};
use slideway_robot::{Dynamics, JointVector, Pose, Task, Twist};

/// The tool's way, m.
const WAY: [f64; 3] = [0.1, -0.15, 0.15];
/// The push, N, and when, s.
const PUSH: [f64; 3] = [12.0, 16.0, 0.0];
const PUSHED: [f64; 2] = [0.5, 0.8];
const DURATION: f64 = 2.0;

/// Course of the tool in one task under one law.
struct Run {
    law: Law,
    /// Time (s), way gone and distance from the line (mm).
    trace: Vec<[f64; 3]>,
    /// Distance of the tool from its goal at the end, mm.
    left: f64,
}

impl Run {
    /// Largest distance from the line, mm, over a span of time.
    fn farthest(&self, from: f64, to: f64) -> f64 {
        self.trace.iter().filter(|p| p[0] >= from && p[0] < to).fold(0.0, |most, p| most.max(p[2]))
    }
}

pub(crate) fn run_study() -> Result<Report, StudyError> {
    let model = puma()?.model;
    let mut goal = model.arm().forward(&JointVector::from(READY));
    goal.translation.vector += Vector3::from(WAY);
    let step = |law| one(law, &model, &goal, &|_| Vector3::zeros(), &mut || joints_at(&model, &goal));
    let steps = [step(Law::Operational)?, step(Law::JointPid)?];
    let lines = Law::ALL.into_iter().map(|law| line(law, &model, &goal)).collect::<Result<Vec<_>, _>>()?;
    let length = 1e3 * Vector3::from(WAY).norm();
    let [straight, crooked] = steps.each_ref().map(|run| run.farthest(0.0, DURATION) / length);
    let arrived = steps.iter().all(|run| run.left < 0.1 * length);
    Ok(Report {
        study: Study::OpspaceVsQueue.name(),
        title: "Operational space and joint PID",
        holds: straight <= 0.01 && crooked > 0.01 && arrived,
        sentence: sentence([straight, crooked], &lines),
        numbers: numbers([straight, crooked], &lines),
        panels: panels(&steps, &lines),
    })
}

/// Both follow the set-points of the queue.
fn line(law: Law, model: &Dynamics<6>, goal: &Pose) -> Result<Run, StudyError> {
    let axis = AxisLimits::new(3.0, 30.0, 1e3)?;
    let kinematics = ToolKinematics::new(model.arm().clone(), Task::Pose, 0.01)?;
    let limits = MotionLimits::without_stops([axis; 6]);
    let mut queue = MotionQueue::<6, 4>::new(limits, JointVector::from(READY))?.with_tool(kinematics);
    let tool = ToolLimits {
        linear: AxisLimits::new(0.25, 1.0, 10.0)?,
        angular: AxisLimits::new(1.0, 4.0, 40.0)?,
        ramp: Ramp::JerkLimited,
    };
    queue.move_tool_to(goal, &tool)?;
    let push = |t: f64| if (PUSHED[0]..PUSHED[1]).contains(&t) { Vector3::from(PUSH) } else { Vector3::zeros() };
    one(law, model, goal, &push, &mut || queue.advance(PERIOD))
}

fn one(
    law: Law,
    model: &Dynamics<6>,
    goal: &Pose,
    push: &dyn Fn(f64) -> Vector3<f64>,
    next: &mut dyn FnMut() -> Result<JointState<6>, MotionError>,
) -> Result<Run, StudyError> {
    let plant = plant(model)?;
    let mut controllers = Controllers::new(model)?;
    let mut state = PlantState::at_rest(JointVector::from(READY));
    let start = model.arm().forward(&state.q).translation.vector;
    let way = goal.translation.vector - start;
    let mut trace = Vec::new();
    for _ in 0..(DURATION / PERIOD).round() as u32 {
        let torque = controllers.torque(law, &next()?, &state);
        let force = push(state.time);
        let actuation = Actuation { torque, push: Twist::new(force.x, force.y, force.z, 0.0, 0.0, 0.0) };
        plant.advance(&mut state, PERIOD, &mut |_| actuation)?;
        let gone = model.arm().forward(&state.q).translation.vector - start;
        let along = gone.dot(&way) / way.norm();
        trace.push([state.time, 1e3 * along, 1e3 * (gone - way * (along / way.norm())).norm()]);
    }
    let left = 1e3 * (model.arm().forward(&state.q).translation.vector - goal.translation.vector).norm();
    Ok(Run { law, trace, left })
}

fn sentence([straight, crooked]: [f64; 2], lines: &[Run]) -> String {
    let one = |run: &Run| {
        let (free, pushed) = (run.farthest(0.0, PUSHED[0]), run.farthest(PUSHED[0], DURATION));
        format!("{} {free:.2} mm before and {pushed:.1} mm after", run.law.name())
    };
    let list: Vec<String> = lines.iter().map(one).collect();
    format!(
        "The answer to a step leaves the straight line by {:.2} % of its length in operational space and by {:.1} % under joint PID. \
         On the queue's line, off by a push: {}.",
        100.0 * straight,
        100.0 * crooked,
        list.join("; ")
    )
}

fn numbers([straight, crooked]: [f64; 2], lines: &[Run]) -> Vec<NamedNumber> {
    let mut numbers = vec![
        NamedNumber::new("operational-step-off-line", straight, "1"),
        NamedNumber::new("joint-pid-step-off-line", crooked, "1"),
    ];
    for run in lines {
        let name = |what: &str| format!("{}-{what}", run.law.key());
        numbers.push(NamedNumber::new(name("line-error"), 1e-3 * run.farthest(0.0, PUSHED[0]), "m"));
        numbers.push(NamedNumber::new(name("line-error-pushed"), 1e-3 * run.farthest(PUSHED[0], DURATION), "m"));
    }
    numbers
}

fn panels(steps: &[Run], lines: &[Run]) -> Vec<Panel> {
    let panel = |title: &str, x, runs: &[Run], at: fn(&[f64; 3]) -> [f64; 2]| Panel {
        title: title.to_owned(),
        x,
        y: "off the line (mm)",
        scales: Scales::Filling,
        series: runs
            .iter()
            .map(|run| Series { name: run.law.name(), role: Role::Result, points: run.trace.iter().map(at).collect() })
            .collect(),
        levels: Vec::new(),
    };
    vec![
        panel("A step of the target", "along the line (mm)", steps, |p| [p[1], p[2]]),
        panel("The queue's line, pushed from 0.5 to 0.8 s", "time (s)", lines, |p| [p[0], p[2]]),
    ]
}

/// The tool's motion that a joint motion makes.
fn reference(model: &Dynamics<6>, set_point: &JointState<6>) -> ToolReference {
    let arm = model.arm();
    let jacobian = arm.jacobian(&set_point.q);
    ToolReference {
        pose: arm.forward(&set_point.q),
        twist: jacobian * set_point.qd,
        acceleration: jacobian * set_point.qdd + arm.bias_acceleration(&set_point.q, &set_point.qd),
    }
}
