//! A queue of Cartesian velocities on a planar arm with two joints: `[R16]`, exercise 6.
//!
//! Commands are velocities and durations. Before a singularity and before a joint's stop the tool brakes on its line and waits for
//! a command that leads away. The set-points drive the arm's masses under computed torque. Besides the commands shown, 100
//! random sequences are run without masses, and none may leave the joints' ranges.

mod queue;

use crate::bench::{PERIOD, pid, plant};
use crate::{Level, NamedNumber, Panel, Report, Role, Scales, Series, Study, StudyError};
use nalgebra::{Matrix3, Vector2, Vector3};
use queue::{Command, ELBOW, LINKS, SHOULDER, VelocityQueue, joints_at};
use rand::{RngExt, SeedableRng};
use rand_xorshift::XorShiftRng;
use slideway_motion::control::{TorqueController, TorqueLaw};
use slideway_motion::plant::{Actuation, PlantState};
use slideway_motion::{JointState, MotionError};
use slideway_robot::{DhRow, Dynamics, JointVector, LinkInertia, SerialArm};

/// Where the tool begins, m.
const START: [f64; 2] = [0.45, 0.2];
/// Commands that lead to every limit: stretched arm, shoulder's stop, folded elbow.
const COMMANDS: [Command; 8] = [
    Command { velocity: [0.3, 0.1], duration: 1.6 },
    Command { velocity: [-0.2, 0.3], duration: 1.2 },
    Command { velocity: [-0.4, -0.1], duration: 1.5 },
    Command { velocity: [0.0, -0.3], duration: 1.0 },
    Command { velocity: [-0.3, 0.3], duration: 1.6 },
    Command { velocity: [-0.2, -0.3], duration: 1.4 },
    Command { velocity: [0.2, 0.2], duration: 1.0 },
    Command { velocity: [0.4, -0.4], duration: 1.2 },
];
/// Number of random sequences and of commands in each.
const RANDOM: [usize; 2] = [100, 8];
/// Most that a set-point may be out of a joint's range, rad: the excess that two looks 1 mm apart can miss. A range's border is a circle
/// of 0.2 m or more about the base or a curve no sharper; its sagitta is `LOOK² / (8 · 0.2) = 6.3e-7 m`, and the elbow turns by at most
/// `1 / (0.4 sin 0.3) = 8.5 rad` a metre there.
const HIDDEN: f64 = 6e-6;

struct Run {
    asked: Vec<[f64; 2]>,
    wanted: Vec<[f64; 2]>,
    walked: Vec<[f64; 2]>,
    joints: [Vec<[f64; 2]>; 2],
    /// Largest distance of the tool from its set-point, m.
    error: f64,
    /// Time for which the tool was held up, s.
    stopped: f64,
    beyond: f64,
}

pub(crate) fn run_study(seed: u64) -> Result<Report, StudyError> {
    let run = simulate()?;
    let beyond = random_sequences(seed).max(run.beyond);
    let holds = beyond <= HIDDEN && run.stopped > 0.0;
    let sentence = format!(
        "The tool is held up for {:.2} s in all before singularities and stops; in {} random sequences and in this one no set-point is \
         more than {:.1e} rad beyond a range. The arm's tool stays within {:.1} mm of its set-points, whose speed jumps.",
        run.stopped,
        RANDOM[0],
        beyond.max(0.0),
        1e3 * run.error
    );
    Ok(Report {
        study: Study::Cartesian2r.name(),
        title: "Cartesian velocities for two joints",
        holds,
        sentence,
        numbers: vec![
            NamedNumber::new("held-up", run.stopped, "s"),
            NamedNumber::new("beyond-range", beyond.max(0.0), "rad"),
            NamedNumber::new("tool-error", run.error, "m"),
            NamedNumber::new("random-sequences", RANDOM[0] as f64, "1"),
        ],
        panels: panels(run),
    })
}

/// Two rods in a horizontal plane.
fn arm() -> Result<Dynamics<2>, MotionError> {
    let row = |a| DhRow { a, alpha: 0.0, d: 0.0, offset: 0.0 };
    let rod = |mass: f64, length: f64| LinkInertia {
        mass,
        com: Vector3::x() * (0.5 * length),
        inertia: Matrix3::from_diagonal(&Vector3::new(1e-3, 1.0, 1.0)) * (mass * length * length / 12.0),
    };
    let arm = SerialArm::from_dh(LINKS.map(row))?;
    Ok(Dynamics::new(arm, [rod(4.0, LINKS[0]), rod(2.0, LINKS[1])])?)
}

/// Largest excess of a joint over its range, rad; negative inside, infinite where there are no joints.
fn outside(place: &Vector2<f64>) -> f64 {
    let Some(q) = joints_at(place) else { return f64::INFINITY };
    let beyond = |q: f64, [lower, upper]: [f64; 2]| (lower - q).max(q - upper);
    beyond(q[0], SHOULDER).max(beyond(q[1], ELBOW))
}

fn simulate() -> Result<Run, StudyError> {
    let dynamics = arm()?;
    let plant = plant(&dynamics)?;
    let feedback = [pid(900.0, 0.0, 60.0, 1e6)?; 2];
    let largest = JointVector::from([60.0, 30.0]);
    let mut controller = TorqueController::new(dynamics.clone(), TorqueLaw::ComputedTorque, feedback, largest)?;
    let start = Vector2::from(START);
    let mut queue = VelocityQueue::new(start, &COMMANDS);
    let mut q = joints_at(&start).unwrap_or_default();
    let mut state = PlantState::at_rest(q);
    let mut run = Run {
        asked: asked_path(),
        wanted: vec![START],
        walked: vec![START],
        joints: [Vec::new(), Vec::new()],
        error: 0.0,
        stopped: 0.0,
        beyond: f64::NEG_INFINITY,
    };
    while let Some([place, velocity]) = queue.advance(PERIOD) {
        let next = joints_at(&place).unwrap_or(q);
        let desired = JointState { q: next, qd: (next - q) / PERIOD, qdd: JointVector::zeros() };
        q = next;
        let torque = controller.step(&desired, &state.q, &state.qd).torque;
        plant.advance(&mut state, PERIOD, &mut |_| Actuation::torque(torque))?;
        let tip = dynamics.arm().forward(&state.q).translation.vector.xy();
        run.error = run.error.max((tip - place).norm());
        run.stopped += if velocity.norm() < 1e-3 { PERIOD } else { 0.0 };
        run.beyond = run.beyond.max(outside(&place));
        run.wanted.push([place.x, place.y]);
        run.walked.push([tip.x, tip.y]);
        for (points, q) in run.joints.iter_mut().zip(state.q.iter()) {
            points.push([state.time, *q]);
        }
    }
    Ok(run)
}

/// The path that the commands would make if nothing were in the way.
fn asked_path() -> Vec<[f64; 2]> {
    let mut place = Vector2::from(START);
    let mut path = vec![START];
    for Command { velocity, duration } in COMMANDS {
        place += Vector2::from(velocity) * duration;
        path.push([place.x, place.y]);
    }
    path
}

/// Largest excess over a joint's range that set-points of random commands reach, rad.
fn random_sequences(seed: u64) -> f64 {
    let mut random = XorShiftRng::seed_from_u64(seed);
    let mut farthest = f64::NEG_INFINITY;
    for _ in 0..RANDOM[0] {
        let commands: Vec<Command> = (0..RANDOM[1])
            .map(|_| Command {
                velocity: [random.random_range(-0.6..0.6), random.random_range(-0.6..0.6)],
                duration: random.random_range(0.1..1.5),
            })
            .collect();
        let mut queue = VelocityQueue::new(Vector2::from(START), &commands);
        while let Some([place, _]) = queue.advance(4.0 * PERIOD) {
            farthest = farthest.max(outside(&place));
        }
    }
    farthest
}

fn panels(run: Run) -> Vec<Panel> {
    let reference = |name, points| Series { name, role: Role::Reference, points };
    let result = |name, points| Series { name, role: Role::Result, points };
    let [shoulder, elbow] = run.joints;
    let joint = |title: &str, name, points, [lower, upper]: [f64; 2]| Panel {
        title: title.to_owned(),
        x: "time (s)",
        y: "rad",
        scales: Scales::Filling,
        series: vec![result(name, points)],
        levels: vec![Level { name: "range", value: lower }, Level { name: "range", value: upper }],
    };
    vec![
        Panel {
            title: "The tool".to_owned(),
            x: "x (m)",
            y: "y (m)",
            scales: Scales::Equal,
            series: vec![
                reference("asked for", run.asked),
                result("set-points", run.wanted),
                result("arm", run.walked),
            ],
            levels: Vec::new(),
        },
        joint("Shoulder", "arm", shoulder, SHOULDER),
        joint("Elbow", "arm", elbow, ELBOW),
    ]
}
