//! The PUMA-560 against a compliant wall: a stiff position controller, an impedance, a virtual mass, force control.
//!
//! The tool stands 2 cm before the wall and is told to go 3 cm into it; force control is told to push with the force that the
//! impedance ends at. The force sensor is noisy, the arm has no friction (which the impedance without a force sensor would not
//! feel: it would end up to `J⁻ᵀ` times the Coulomb torques away).
//!
//! At rest two springs in series push with `F = K k / (K + k)` times the 3 cm.

use crate::bench::{LARGEST, READY, joints_at, pid, plant, puma, run};
use crate::{Level, NamedNumber, Panel, Report, Role, Scales, Series, Study, StudyError};
use nalgebra::Vector3;
use slideway_motion::MotionError;
use slideway_motion::control::task_space::{
    ForceControl, ForceState, Impedance, OperationalSettings, OperationalSpace, ToolFeedback, ToolGains, ToolReference,
    ToolState, VirtualMass,
};
use slideway_motion::control::{TorqueController, TorqueLaw};
use slideway_motion::plant::{Actuation, Measurement, Noise, Plant, PlantState, Sensors, Wall};
use slideway_robot::{Dynamics, JointVector, Task, Twist};

/// Stiffness (N/m) and damping (N·s/m) of the wall.
const WALL: [f64; 2] = [1e4, 100.0];
/// Stiffness of the tool, N/m.
const STIFFNESS: f64 = 800.0;
/// Way to the wall, and from there to where the tool is told to be, m.
const GAP: f64 = 0.02;
const DEPTH: f64 = 0.03;
/// Duration of a run, and of its end over which forces are averaged, s.
const DURATION: f64 = 3.0;
const END: f64 = 0.2;

#[derive(Clone, Copy, PartialEq)]
enum Law {
    Position,
    Impedance,
    Mass,
    Force,
}

impl Law {
    const ALL: [Self; 4] = [Self::Position, Self::Impedance, Self::Mass, Self::Force];

    fn name(self) -> &'static str {
        match self {
            Self::Position => "joint PID with gravity compensation",
            Self::Impedance => "impedance, the arm's own inertia",
            Self::Mass => "impedance, virtual mass of 5 kg",
            Self::Force => "force control",
        }
    }

    fn key(self) -> &'static str {
        match self {
            Self::Position => "joint-pid",
            Self::Impedance => "impedance",
            Self::Mass => "virtual-mass",
            Self::Force => "force-control",
        }
    }
}

struct Run {
    law: Law,
    force: Vec<[f64; 2]>,
    depth: Vec<[f64; 2]>,
    peak: f64,
    end: f64,
}

/// `K k / (K + k)` times the depth, N.
fn two_springs() -> f64 {
    DEPTH * STIFFNESS * WALL[0] / (STIFFNESS + WALL[0])
}

pub(crate) fn run_study(seed: u64) -> Result<Report, StudyError> {
    let model = puma()?.model;
    let runs = Law::ALL.into_iter().map(|law| one(law, &model, seed)).collect::<Result<Vec<_>, _>>()?;
    let expected = two_springs();
    let holds = runs.iter().filter(|r| r.law != Law::Position).all(|r| (r.end / expected - 1.0).abs() <= 0.02);
    let list: Vec<String> =
        runs.iter().map(|r| format!("{} {:.2} N (peak {:.0} N)", r.law.name(), r.end, r.peak)).collect();
    Ok(Report {
        study: Study::ImpedanceWall.name(),
        title: "Against a compliant wall",
        holds,
        sentence: format!("Two springs in series push with {expected:.2} N. At rest: {}.", list.join("; ")),
        numbers: numbers(&runs, expected),
        panels: panels(&runs, expected),
    })
}

fn numbers(runs: &[Run], expected: f64) -> Vec<NamedNumber> {
    let one = |run: &Run| {
        let name = |what: &str| format!("{}-{what}", run.law.key());
        [
            NamedNumber::new(name("force-at-rest"), run.end, "N"),
            NamedNumber::new(name("peak-force"), run.peak, "N"),
            NamedNumber::new(name("relative-error"), run.end / expected - 1.0, "1"),
        ]
    };
    std::iter::once(NamedNumber::new("closed-form-force", expected, "N")).chain(runs.iter().flat_map(one)).collect()
}

/// The controllers and the wrench they are shown.
struct Controllers {
    position: TorqueController<6>,
    impedance: Impedance<6>,
    space: OperationalSpace<6>,
    mass: VirtualMass,
    force: ForceControl,
    state: ForceState,
    feedback: ToolFeedback,
    desired: ToolReference,
    target: slideway_motion::JointState<6>,
}

impl Controllers {
    fn new(model: &Dynamics<6>, desired: ToolReference) -> Result<Self, MotionError> {
        let largest = JointVector::from(LARGEST);
        let both = ToolGains::uniform;
        let (strong, weak) = (pid(900.0, 0.0, 90.0, 1e3)?, pid(100.0, 0.0, 8.0, 1e3)?);
        let feedback = [strong, pid(1800.0, 0.0, 180.0, 1e3)?, strong, weak, weak, weak];
        let settings = OperationalSettings { length: 0.3, largest_inertia: 200.0, posture_damping: 0.0 };
        let (stiffness, damping) = (both(STIFFNESS, 30.0)?, both(120.0, 8.0)?);
        Ok(Self {
            position: TorqueController::new(model.clone(), TorqueLaw::GravityCompensation, feedback, largest)?,
            impedance: Impedance::new(model.clone(), Task::Pose, stiffness, damping, largest)?,
            space: OperationalSpace::new(model.clone(), Task::Pose, settings, largest)?,
            mass: VirtualMass::new(both(5.0, 0.5)?, stiffness, damping)?,
            // 2 sqrt(k Kp) = 40 is critical against the wall.
            force: ForceControl::new(Vector3::x(), pid(0.04, 0.0, 0.0, 1e3)?, 40.0)?,
            state: ForceState::default(),
            feedback: ToolFeedback { proportional: both(100.0, 100.0)?, derivative: both(20.0, 20.0)? },
            target: joints_at(model, &desired.pose)?,
            desired,
        })
    }

    fn torque(&mut self, law: Law, seen: &Measurement<6>, external: &Twist) -> JointVector<6> {
        let (q, qd) = (&seen.q, &seen.qd);
        match law {
            Law::Position => self.position.step(&self.target, q, qd).torque,
            Law::Impedance => self.impedance.step(&self.desired, q, qd).torque,
            Law::Mass => self.mass.step(&self.space, &self.desired, [q, qd], external).torque,
            Law::Force => {
                let tool = ToolState::of(self.space.dynamics().arm(), q, qd);
                let motion = self.feedback.acceleration(&self.desired, &tool);
                let force = two_springs();
                let wanted = self.force.acceleration(&mut self.state, force, external, &tool.twist, &motion);
                self.space.step(q, qd, &wanted, external).torque
            }
        }
    }
}

fn one(law: Law, model: &Dynamics<6>, seed: u64) -> Result<Run, StudyError> {
    let mut pose = model.arm().forward(&JointVector::from(READY));
    let face = pose.translation.vector + Vector3::x() * GAP;
    let wall = Wall::new(face, -Vector3::x(), WALL[0], WALL[1])?;
    let plant: Plant<6> = plant(model)?.with_wall(wall);
    pose.translation.vector.x += GAP + DEPTH;
    let mut controllers = Controllers::new(model, ToolReference::at_rest(pose))?;
    let noise = Noise { position: 1e-6, speed: 1e-4, force: 0.2, moment: 0.01 };
    let (mut joints, mut wrist) = (Sensors::new(noise, seed)?, Sensors::new(noise, seed.wrapping_add(1))?);
    let mut state = PlantState::at_rest(JointVector::from(READY));
    let (mut force, mut depth) = (Vec::new(), Vec::new());
    run(
        &plant,
        &mut joints,
        &mut state,
        DURATION,
        |x, seen| {
            let external = wrist.wrench(&plant.contact(&x.q, &x.qd));
            Ok(Actuation::torque(controllers.torque(law, seen, &external)))
        },
        |x| {
            force.push([x.time, -plant.contact(&x.q, &x.qd).x]);
            depth.push([x.time, 1e3 * wall.depth(&model.arm().forward(&x.q).translation.vector)]);
        },
    )?;
    let peak = force.iter().fold(0.0_f64, |most, f| most.max(f[1]));
    let last: Vec<f64> = force.iter().filter(|f| f[0] > DURATION - END).map(|f| f[1]).collect();
    Ok(Run { law, force, depth, peak, end: last.iter().sum::<f64>() / last.len() as f64 })
}

fn panels(runs: &[Run], expected: f64) -> Vec<Panel> {
    let panel = |title: &str, y, of: fn(&Run) -> &Vec<[f64; 2]>, levels| Panel {
        title: title.to_owned(),
        x: "time (s)",
        y,
        scales: Scales::Filling,
        series: runs
            .iter()
            .map(|run| Series { name: run.law.name(), role: Role::Result, points: of(run).clone() })
            .collect(),
        levels,
    };
    vec![
        panel("Force on the wall", "N", |r| &r.force, vec![Level { name: "two springs in series", value: expected }]),
        panel("Depth in the wall", "mm", |r| &r.depth, vec![Level { name: "face of the wall", value: 0.0 }]),
    ]
}
