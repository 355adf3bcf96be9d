//! The four ways to interrupt a motion, side by side.
//!
//! Two joints follow a spline through way-points and then a Go-To. In the middle of the spline the motion is broken off:
//!
//! | interruption | stays on the path | comes to rest |
//! |---|---|---|
//! | stop at way-point | yes | at the next way-point at rest, here the spline's end |
//! | braking on the path | yes | where the pace gets to zero |
//! | maximal braking | no | each joint after `abs(v) / A` |
//! | new target | no | at the target |
//!
//! All under the same limits of speed and acceleration. The path that would have been followed is sampled every 0.1 ms; its
//! chords miss it by at most `A √N h² / 8 = 1e-8 rad`, which is what "on the path" is checked to, and rounding.

mod way;

use crate::{Level, NamedNumber, Panel, Report, Role, Scales, Series, Study, StudyError};
use nalgebra::Vector2;
use slideway_motion::profile::Ramp;
use slideway_motion::{
    AxisLimits, Interpolation, JointState, MotionError, MotionLimits, MotionQueue, Progress, WayPointRule, path_through,
};
use way::Way;

/// Speed, acceleration and jerk of both joints, rad.
const LIMITS: [f64; 3] = [1.5, 4.0, 60.0];
/// Way-points of the spline, rad.
const WAY_POINTS: [[f64; 2]; 4] = [[0.0, 0.0], [0.8, 0.2], [1.2, 0.9], [0.5, 1.3]];
/// Where the Go-To after the spline leads, rad.
const AFTER: [f64; 2] = [0.0, 0.0];
/// Where the new target is, rad.
const TARGET: [f64; 2] = [1.6, 0.4];
/// When the motion is interrupted, s.
const WHEN: f64 = 1.0;
/// Sampling period, s.
const PERIOD: f64 = 1e-3;
/// Sampling period of the path that is compared with, s.
const FINE: f64 = 1e-4;
/// After this long every run has to be over, s.
const PATIENCE: f64 = 20.0;

type Queue = MotionQueue<2, 16>;

/// One run, sampled.
struct Run {
    way: Way,
    samples: Vec<(f64, JointState<2>)>,
    /// From the interruption to rest, s.
    time_to_rest: f64,
}

pub(crate) fn run() -> Result<Report, StudyError> {
    let planned = planned_path()?;
    let runs = Way::ALL.into_iter().map(interrupted).collect::<Result<Vec<_>, _>>()?;
    let distances: Vec<f64> = runs.iter().map(|run| run.distance_from(&planned)).collect();
    let holds = runs.iter().zip(&distances).all(|(run, &d)| run.keeps_its_promise(d));
    let numbers = runs.iter().zip(&distances).flat_map(|(run, &d)| run.numbers(d)).collect();
    Ok(Report {
        study: Study::Interrupts.name(),
        title: "Four ways to interrupt a motion",
        holds,
        sentence: sentence(&runs, &distances, holds),
        numbers,
        panels: panels(&runs, &planned),
    })
}

fn queue() -> Result<Queue, MotionError> {
    let axis = AxisLimits::new(LIMITS[0], LIMITS[1], LIMITS[2])?;
    let mut queue = Queue::new(MotionLimits::without_stops([axis; 2]), WAY_POINTS[0].into())?;
    let points: Vec<_> = WAY_POINTS.iter().map(|&p| p.into()).collect();
    let path = path_through(&points, WayPointRule::Spline, queue.limits())?;
    queue.move_along(&path, Some(Ramp::AccelerationLimited))?;
    queue.go_to(&AFTER.into(), Interpolation::Trapezoid)?;
    Ok(queue)
}

/// Positions along the uninterrupted path.
fn planned_path() -> Result<Vec<Vector2<f64>>, StudyError> {
    let mut queue = queue()?;
    let mut path = vec![queue.set_point().q];
    while queue.progress() != Progress::Resting {
        path.push(queue.advance(FINE)?.q);
    }
    Ok(path)
}

fn interrupted(way: Way) -> Result<Run, StudyError> {
    let mut queue = queue()?;
    let mut samples = vec![(0.0, queue.set_point())];
    let interrupt = (WHEN / PERIOD).round() as u32;
    let most = (PATIENCE / PERIOD).round() as u32;
    for sample in 1..=most {
        samples.push((f64::from(sample) * PERIOD, queue.advance(PERIOD)?));
        if sample == interrupt {
            way.interrupt(&mut queue, TARGET)?;
        }
        if sample > interrupt && queue.progress() != Progress::Moving {
            return Ok(Run { way, samples, time_to_rest: f64::from(sample - interrupt) * PERIOD });
        }
    }
    Err(StudyError::Endless { what: "an interrupted motion", seconds: PATIENCE })
}

impl Run {
    /// Largest distance of a set-point from the planned path, rad.
    fn distance_from(&self, planned: &[Vector2<f64>]) -> f64 {
        let nearest =
            |q: &Vector2<f64>| planned.windows(2).map(|w| distance(q, &w[0], &w[1])).fold(f64::INFINITY, f64::min);
        self.samples.iter().map(|(_, state)| nearest(&state.q)).fold(0.0, f64::max)
    }

    /// Largest acceleration as a share of the limit, and largest speed likewise.
    fn limit_use(&self) -> f64 {
        let states = self.samples.iter().map(|(_, s)| (s.qd.amax() / LIMITS[0]).max(s.qdd.amax() / LIMITS[1]));
        states.fold(0.0, f64::max)
    }

    fn end(&self) -> Option<&JointState<2>> {
        self.samples.last().map(|(_, state)| state)
    }

    fn keeps_its_promise(&self, distance: f64) -> bool {
        let chord = LIMITS[1] * 2.0_f64.sqrt() * FINE * FINE / 8.0;
        let is_on_path = !self.way.stays_on_path() || distance <= chord + 1e-12;
        let rests = self.end().is_some_and(JointState::is_at_rest);
        // The planner of moving states ends within 2e-8 rad.
        let arrives =
            self.way != Way::NewTarget || self.end().is_some_and(|s| (s.q - Vector2::from(TARGET)).amax() <= 2e-8);
        is_on_path && rests && arrives && self.limit_use() <= 1.0 + 1e-9
    }

    fn numbers(&self, distance: f64) -> [NamedNumber; 3] {
        let name = |what: &str| format!("{}-{what}", self.way.key());
        [
            NamedNumber::new(name("time-to-rest"), self.time_to_rest, "s"),
            NamedNumber::new(name("distance-from-path"), distance, "rad"),
            NamedNumber::new(name("limit-use"), self.limit_use(), "1"),
        ]
    }
}

/// Distance of a point from a segment.
fn distance(q: &Vector2<f64>, a: &Vector2<f64>, b: &Vector2<f64>) -> f64 {
    let chord = b - a;
    let length = chord.norm_squared();
    let share = if length > 0.0 { ((q - a).dot(&chord) / length).clamp(0.0, 1.0) } else { 0.0 };
    (q - a - chord * share).norm()
}

fn sentence(runs: &[Run], distances: &[f64], holds: bool) -> String {
    let one = |(run, distance): (&Run, &f64)| {
        let place =
            if run.way.stays_on_path() { "on the path".to_owned() } else { format!("{distance:.3} rad off it") };
        format!("{} takes {:.3} s, {place}", run.way.name(), run.time_to_rest)
    };
    let list: Vec<String> = runs.iter().zip(distances).map(one).collect();
    let promise =
        if holds { "Every run keeps its promise and its limits" } else { "A run breaks its promise or a limit" };
    format!("{promise}; to rest: {}.", list.join("; "))
}

fn panels(runs: &[Run], planned: &[Vector2<f64>]) -> Vec<Panel> {
    let over_time = |title: &str, y, of: fn(&JointState<2>) -> f64, levels| Panel {
        title: title.to_owned(),
        x: "time (s)",
        y,
        scales: Scales::Filling,
        series: runs
            .iter()
            .map(|run| Series {
                name: run.way.name(),
                role: Role::Result,
                points: run.samples.iter().map(|(t, s)| [*t, of(s)]).collect(),
            })
            .collect(),
        levels,
    };
    let limit = |value| vec![Level { name: "limit", value }, Level { name: "limit", value: -value }];
    let path =
        Series { name: "planned path", role: Role::Reference, points: planned.iter().map(|q| [q[0], q[1]]).collect() };
    let walked = runs.iter().map(|run| Series {
        name: run.way.name(),
        role: Role::Result,
        points: run.samples.iter().map(|(_, s)| [s.q[0], s.q[1]]).collect(),
    });
    vec![
        Panel {
            title: "Both joints".to_owned(),
            x: "joint 1 (rad)",
            y: "joint 2 (rad)",
            scales: Scales::Equal,
            series: std::iter::once(path).chain(walked).collect(),
            levels: Vec::new(),
        },
        over_time("Position of joint 1", "rad", |s| s.q[0], Vec::new()),
        over_time("Speed of joint 1", "rad/s", |s| s.qd[0], limit(LIMITS[0])),
        over_time("Acceleration of joint 1", "rad/s²", |s| s.qdd[0], limit(LIMITS[1])),
    ]
}
