//! PID with low gains and with high ones on six joints: `[R16]`, exercise 4.
//!
//! The PUMA-560 with friction, motors with a delay of one sample, amplifiers that end, encoders that count. Gains are a table times
//! `g`, those of the derivative times `√g`, which keeps the damping of a free joint. "High" is half of the largest `g` at
//! which the arm does not shake at rest, found by bisection. In one run of 7 s:
//!
//! | from | what happens |
//! |---|---|
//! | 0 s | the controller is switched on, its integral empty: the arm sags |
//! | 2 s | half a second of 40 N on the tool, downwards |
//! | 4 s | the target jumps by 1 rad in the first three joints |

mod motors;

use crate::bench::{LARGEST, PERIOD, READY, pid, plant, puma};
use crate::{Level, NamedNumber, Panel, Report, Role, Scales, Series, Study, StudyError};
use motors::Motors;
use slideway_motion::control::{TorqueController, TorqueLaw};
use slideway_motion::plant::{Actuation, Plant, PlantState};
use slideway_motion::{JointState, MotionError};
use slideway_robot::{Dynamics, JointVector, Twist};

/// Proportional gains at `g = 1`, N·m/rad.
const TABLE: [f64; 6] = [600.0, 1200.0, 500.0, 40.0, 40.0, 40.0];
/// Derivative gain over proportional gain at `g = 1`, s, and integral over proportional, 1/s.
const RATIOS: [f64; 2] = [0.1, 1.0];
const PUSH: [f64; 2] = [2.0, 2.5];
const JUMP: f64 = 4.0;
const END: f64 = 7.0;
/// The joint that is shown.
const SHOWN: usize = 1;
/// An arm at rest whose torques vary by more than this share of their limits shakes.
const SHAKING: f64 = 0.1;

struct Run {
    name: &'static str,
    key: &'static str,
    gain: f64,
    error: Vec<[f64; 2]>,
    step: Vec<[f64; 2]>,
    torque: Vec<[f64; 2]>,
    sag: f64,
    pushed: f64,
    overshoot: f64,
    /// Share of the samples after the jump in which some torque is at its limit.
    cut: f64,
}

pub(crate) fn run_study() -> Result<Report, StudyError> {
    let puma = puma()?;
    let largest = largest_gain(&puma.real)?;
    let low = one("low gains", "low", 1.0, &puma.real)?;
    let high = one("high gains", "high", 0.5 * largest, &puma.real)?;
    let sentence = format!(
        "Gains up to {largest:.0} times the table do not shake; at half of that the arm sags by {:.1} mrad when it is switched on \
         instead of {:.0}, gives way to a push by {:.2} mrad instead of {:.1}, and passes a far target by {:.0} mrad instead of {:.0}, \
         with a torque at its limit for {:.0} % of the time instead of {:.0} %.",
        1e3 * high.sag,
        1e3 * low.sag,
        1e3 * high.pushed,
        1e3 * low.pushed,
        1e3 * high.overshoot,
        1e3 * low.overshoot,
        100.0 * high.cut,
        100.0 * low.cut
    );
    let holds = high.sag < low.sag && high.pushed < low.pushed && high.cut > low.cut;
    let mut numbers = vec![NamedNumber::new("largest-gain", largest, "1")];
    numbers.extend(low.numbers().into_iter().chain(high.numbers()));
    Ok(Report {
        study: Study::HighGainPid.name(),
        title: "PID with low and with high gains",
        holds,
        sentence,
        numbers,
        panels: panels(&[low, high]),
    })
}

fn controller(model: &Dynamics<6>, gain: f64) -> Result<TorqueController<6>, MotionError> {
    let mut feedback = [pid(1.0, 0.0, 0.0, 1.0)?; 6];
    for ((axis, table), largest) in feedback.iter_mut().zip(TABLE).zip(LARGEST) {
        let p = gain * table;
        *axis = pid(p, RATIOS[1] * p, RATIOS[0] * table * gain.sqrt(), largest)?;
    }
    TorqueController::new(model.clone(), TorqueLaw::Pid, feedback, JointVector::from(LARGEST))
}

/// Everything between the target and the next state.
struct Loop {
    plant: Plant<6>,
    controller: TorqueController<6>,
    motors: Motors,
    state: PlantState<6>,
}

impl Loop {
    fn new(arm: &Dynamics<6>, gain: f64) -> Result<Self, MotionError> {
        Ok(Self {
            plant: plant(arm)?,
            controller: controller(arm, gain)?,
            motors: Motors::new()?,
            state: PlantState::at_rest(JointVector::from(READY)),
        })
    }

    /// One sample; the motors' torques, and whether the controller is at a limit.
    fn step(&mut self, target: &JointVector<6>, push: &Twist) -> Result<(JointVector<6>, bool), MotionError> {
        let seen = self.motors.measure(&self.state);
        let wanted = self.controller.step(&JointState::at_rest(*target), &seen.q, &seen.qd);
        let torque = self.motors.torque(&wanted.torque, &seen.qd);
        let actuation = Actuation { torque, push: *push };
        self.plant.advance(&mut self.state, PERIOD, &mut |_| actuation)?;
        Ok((torque, wanted.torque.iter().zip(LARGEST).any(|(torque, largest)| torque.abs() >= largest)))
    }
}

/// True if the arm, held where it is for 0.7 s, is given steady torques at the end.
fn is_steady(arm: &Dynamics<6>, gain: f64) -> Result<bool, MotionError> {
    let mut control = Loop::new(arm, gain)?;
    let (mut lowest, mut highest) = (JointVector::from(LARGEST), -JointVector::from(LARGEST));
    for sample in 0..700 {
        let (torque, _) = control.step(&JointVector::from(READY), &Twist::zeros())?;
        if sample >= 600 {
            (lowest, highest) = (lowest.inf(&torque), highest.sup(&torque));
        }
    }
    Ok((highest - lowest).component_div(&JointVector::from(LARGEST)).max() < SHAKING)
}

/// Largest gain without shaking, to a tenth.
fn largest_gain(arm: &Dynamics<6>) -> Result<f64, MotionError> {
    let (mut steady, mut shaking) = (1.0, 2.0);
    while is_steady(arm, shaking)? && shaking < 1e3 {
        (steady, shaking) = (shaking, 2.0 * shaking);
    }
    while shaking > 1.1 * steady {
        let middle = (steady * shaking).sqrt();
        *(if is_steady(arm, middle)? { &mut steady } else { &mut shaking }) = middle;
    }
    Ok(steady)
}

fn one(name: &'static str, key: &'static str, gain: f64, arm: &Dynamics<6>) -> Result<Run, StudyError> {
    let mut control = Loop::new(arm, gain)?;
    let start = JointVector::from(READY);
    let mut goal = start;
    goal.fixed_rows_mut::<3>(0).add_scalar_mut(1.0);
    let down = Twist::new(0.0, 0.0, -40.0, 0.0, 0.0, 0.0);
    let mut run = Run {
        name,
        key,
        gain,
        error: Vec::new(),
        step: Vec::new(),
        torque: Vec::new(),
        sag: 0.0,
        pushed: 0.0,
        overshoot: 0.0,
        cut: 0.0,
    };
    let mut before_push = 0.0;
    for sample in 0..(END / PERIOD).round() as u32 {
        let t = f64::from(sample) * PERIOD;
        let target = if t < JUMP { start } else { goal };
        let push = if (PUSH[0]..PUSH[1]).contains(&t) { down } else { Twist::zeros() };
        let (torque, cut) = control.step(&target, &push)?;
        let off = control.state.q[SHOWN] - target[SHOWN];
        run.torque.push([t, torque[SHOWN]]);
        run.step.push([t, control.state.q[SHOWN]]);
        if t < PUSH[0] {
            run.sag = run.sag.max(off.abs());
            before_push = off;
        } else if t < JUMP {
            run.pushed = run.pushed.max((off - before_push).abs());
        } else {
            run.overshoot = run.overshoot.max(off);
            run.cut += f64::from(u8::from(cut)) * PERIOD / (END - JUMP);
        }
        if t < JUMP {
            run.error.push([t, 1e3 * off]);
        }
    }
    Ok(run)
}

impl Run {
    fn numbers(&self) -> [NamedNumber; 5] {
        let name = |what: &str| format!("{}-{what}", self.key);
        [
            NamedNumber::new(name("gain"), self.gain, "1"),
            NamedNumber::new(name("sag"), self.sag, "rad"),
            NamedNumber::new(name("pushed"), self.pushed, "rad"),
            NamedNumber::new(name("overshoot"), self.overshoot, "rad"),
            NamedNumber::new(name("cut-share"), self.cut, "1"),
        ]
    }
}

fn panels(runs: &[Run]) -> Vec<Panel> {
    let panel = |title: &str, y, of: fn(&Run) -> &Vec<[f64; 2]>, levels| Panel {
        title: title.to_owned(),
        x: "time (s)",
        y,
        scales: Scales::Filling,
        series: runs.iter().map(|run| Series { name: run.name, role: Role::Result, points: of(run).clone() }).collect(),
        levels,
    };
    let target = READY[SHOWN] + 1.0;
    let largest = LARGEST[SHOWN];
    let limits = vec![Level { name: "limit", value: largest }, Level { name: "limit", value: -largest }];
    vec![
        panel("Shoulder: switched on, and pushed at 2 s", "mrad", |r| &r.error, Vec::new()),
        panel("Shoulder: a far target at 4 s", "rad", |r| &r.step, vec![Level { name: "target", value: target }]),
        panel("Torque of the shoulder", "N m", |r| &r.torque, limits),
    ]
}
