//! Straight and cubic profiles under PID and under gravity compensation: `[R16]`, figure 7.
//!
//! The PUMA-560 without friction holds a position until its integrals have settled, then all joints move for 1.5 s, by a constant
//! speed or by a cubic of the same duration, and hold again. The PID has the same gains with and without compensation.
//!
//! Found, as the figure's caption has it: cubics have the lower largest error, since the speed of a straight profile jumps at both
//! ends, and compensation is sooner at rest. In the mean square over
//! the way the cubic is no better, and under PID alone it is worse (`rms-error`): it is faster in its middle.

use crate::bench::{PERIOD, Puma, READY, pid, plant, puma, run};
use crate::{NamedNumber, Panel, Report, Role, Scales, Series, Study, StudyError};
use slideway_motion::characterise::TrackingError;
use slideway_motion::control::{TorqueController, TorqueLaw};
use slideway_motion::plant::{Actuation, Noise, PlantState, Sensors};
use slideway_motion::{AxisLimits, Interpolation, MotionError, MotionLimits, MotionQueue};
use slideway_robot::JointVector;

/// Duration of the motion, of holding before it (not shown) and after it, s.
const MOTION: f64 = 1.5;
const SETTLING: f64 = 4.0;
const HOLDING: f64 = 3.0;
/// Way of each joint, rad.
const WAY: [f64; 6] = [0.5, 0.9, -0.6, 0.4, 0.4, 0.4];
/// Within this distance of its goal a joint has arrived, rad.
const ARRIVED: f64 = 2e-3;
/// The joint that is shown: the shoulder, which carries most.
const SHOWN: usize = 1;

#[derive(Clone, Copy)]
struct Case {
    name: &'static str,
    key: &'static str,
    interpolation: Interpolation,
    law: TorqueLaw,
}

const CASES: [Case; 4] = [
    Case { name: "linear, PID", key: "linear-pid", interpolation: Interpolation::Linear, law: TorqueLaw::Pid },
    Case { name: "cubic, PID", key: "cubic-pid", interpolation: Interpolation::Cubic, law: TorqueLaw::Pid },
    Case {
        name: "linear, gravity compensated",
        key: "linear-compensated",
        interpolation: Interpolation::Linear,
        law: TorqueLaw::GravityCompensation,
    },
    Case {
        name: "cubic, gravity compensated",
        key: "cubic-compensated",
        interpolation: Interpolation::Cubic,
        law: TorqueLaw::GravityCompensation,
    },
];

/// One run from the beginning of the motion.
struct Run {
    case: Case,
    reference: Vec<[f64; 2]>,
    error: Vec<[f64; 2]>,
    /// Error of the whole run, rad.
    all: TrackingError,
    /// Error on the way, rad.
    moving: TrackingError,
    /// From the motion's end until the error stays small, s.
    settling: f64,
}

pub(crate) fn run_study(seed: u64) -> Result<Report, StudyError> {
    let puma = puma()?;
    let runs = CASES.into_iter().map(|case| one(case, &puma, seed)).collect::<Result<Vec<_>, _>>()?;
    let [a, b, c, d] = [0, 1, 2, 3].map(|k| runs.get(k).map_or((f64::NAN, f64::NAN), |r| (r.all.peak(), r.settling)));
    let cubic_is_closer = b.0 < a.0 && d.0 < c.0;
    let compensation_is_sooner = c.1 < a.1 && d.1 < b.1;
    let sentence = format!(
        "The shoulder errs by up to {:.1} mrad under PID on the straight profile and {:.1} on the cubic, with compensation \
         {:.1} and {:.1}; it settles within 2 mrad after {:.2} and {:.2} s, with compensation after {:.2} and {:.2} s.",
        1e3 * a.0,
        1e3 * b.0,
        1e3 * c.0,
        1e3 * d.0,
        a.1,
        b.1,
        c.1,
        d.1
    );
    Ok(Report {
        study: Study::ProfilesVsGravity.name(),
        title: "Two profiles, PID and gravity compensation",
        holds: cubic_is_closer && compensation_is_sooner,
        sentence,
        numbers: runs.iter().flat_map(Run::numbers).collect(),
        panels: panels(&runs),
    })
}

fn queue(interpolation: Interpolation) -> Result<MotionQueue<6, 4>, MotionError> {
    let longest = WAY.iter().fold(0.0_f64, |most, way| most.max(way.abs()));
    // A cubic from rest to rest is 3/2 times as fast in its middle as on average, its acceleration 6 / T² of the way.
    let speed = match interpolation {
        Interpolation::Cubic => 1.5 * longest / MOTION,
        _ => longest / MOTION,
    };
    let axis = AxisLimits::new(speed, 6.1 * longest / (MOTION * MOTION), 1e3)?;
    let start = JointVector::from(READY);
    let mut queue = MotionQueue::new(MotionLimits::without_stops([axis; 6]), start)?;
    queue.go_to(&(start + JointVector::from(WAY)), interpolation)?;
    Ok(queue)
}

fn one(case: Case, puma: &Puma, seed: u64) -> Result<Run, StudyError> {
    let gains = [(900.0, 1500.0, 90.0), (1800.0, 3000.0, 180.0), (900.0, 1500.0, 70.0)];
    let wrist = (100.0, 200.0, 8.0);
    let mut feedback = [pid(wrist.0, wrist.1, wrist.2, 1e3)?; 6];
    for (axis, (p, i, d)) in feedback.iter_mut().zip(gains) {
        *axis = pid(p, i, d, 1e3)?;
    }
    let largest = JointVector::from_element(f64::INFINITY);
    let mut controller = TorqueController::new(puma.model.clone(), case.law, feedback, largest)?;
    let plant = plant(&puma.model)?;
    let mut sensors = Sensors::new(Noise { position: 1e-6, speed: 1e-4, ..Noise::default() }, seed)?;
    let mut queue = queue(case.interpolation)?;
    let mut state = PlantState::at_rest(JointVector::from(READY));
    let rest = queue.set_point();
    let hold = |_: &PlantState<6>, seen: &slideway_motion::plant::Measurement<6>| {
        Ok(Actuation::torque(controller.step(&rest, &seen.q, &seen.qd).torque))
    };
    run(&plant, &mut sensors, &mut state, SETTLING, hold, |_| ())?;
    let begin = state.time;
    let (mut reference, mut error) = (Vec::new(), Vec::new());
    let (mut all, mut moving) = (TrackingError::default(), TrackingError::default());
    let mut late = 0.0;
    for _ in 0..((MOTION + HOLDING) / PERIOD).round() as u32 {
        let wanted = queue.advance(PERIOD)?;
        let follow = |_: &PlantState<6>, seen: &slideway_motion::plant::Measurement<6>| {
            Ok(Actuation::torque(controller.step(&wanted, &seen.q, &seen.qd).torque))
        };
        run(&plant, &mut sensors, &mut state, PERIOD, follow, |_| ())?;
        let (t, off) = (state.time - begin, wanted.q[SHOWN] - state.q[SHOWN]);
        reference.push([t, wanted.q[SHOWN]]);
        error.push([t, 1e3 * off]);
        all.add(off);
        if t <= MOTION {
            moving.add(off);
        } else if !(off.abs() <= ARRIVED) {
            late = t - MOTION;
        }
    }
    Ok(Run { case, reference, error, all, moving, settling: late })
}

impl Run {
    fn numbers(&self) -> [NamedNumber; 3] {
        let name = |what: &str| format!("{}-{what}", self.case.key);
        [
            NamedNumber::new(name("peak-error"), self.all.peak(), "rad"),
            NamedNumber::new(name("rms-error"), self.moving.rms(), "rad"),
            NamedNumber::new(name("settling-time"), self.settling, "s"),
        ]
    }
}

fn panels(runs: &[Run]) -> Vec<Panel> {
    let straight_and_cubic = [("linear profile", 0), ("cubic profile", 1)];
    let references = straight_and_cubic.into_iter().filter_map(|(name, k)| {
        runs.get(k).map(|run| Series { name, role: Role::Result, points: run.reference.clone() })
    });
    let errors = runs.iter().map(|run| Series { name: run.case.name, role: Role::Result, points: run.error.clone() });
    vec![
        Panel {
            title: "Set-points of the shoulder".to_owned(),
            x: "time (s)",
            y: "rad",
            scales: Scales::Filling,
            series: references.collect(),
            levels: Vec::new(),
        },
        Panel {
            title: "Error of the shoulder".to_owned(),
            x: "time (s)",
            y: "mrad",
            scales: Scales::Filling,
            series: errors.collect(),
            levels: Vec::new(),
        },
    ]
}
