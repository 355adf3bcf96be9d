use crate::joints::JointUnits;
use crate::joints::MAX_JOINTS;
use crate::joints::pad;
use crate::problem::Problem;
use crate::run::course::{Course, CourseSample, ProfilePoint};
use crate::run::trace::{Sample, Trace};
use slideway_path::JointPath;
use slideway_path::ProblemError;
use slideway_robot::{Dynamics, JointVector};

/// Use of a speed limit from which a joint counts as at it.
const AT_LIMIT: f64 = 0.99;

/// A state of the joints at one time.
#[derive(Clone, Copy)]
struct Moment<const N: usize> {
    t: f64,
    lambda: f64,
    q: JointVector<N>,
    speed: JointVector<N>,
}

impl<const N: usize> Moment<N> {
    fn of(sample: &Sample) -> Self {
        let vector = |values: &[f64]| JointVector::from_fn(|i, _| values[i]);
        Self { t: sample.t, lambda: sample.lambda, q: vector(&sample.q), speed: vector(&sample.commanded) }
    }

    fn on_to(&self, next: &Self, dynamics: Option<&Dynamics<N>>) -> CourseSample {
        let dt = next.t - self.t;
        let (speed, acceleration) = ((self.speed + next.speed) * 0.5, (next.speed - self.speed) / dt);
        let torque = dynamics.map(|d| d.inverse(&((self.q + next.q) * 0.5), &speed, &acceleration));
        CourseSample {
            t: self.t + 0.5 * dt,
            dt,
            lambda: 0.5 * (self.lambda + next.lambda),
            path_rate: (next.lambda - self.lambda) / dt,
            speed: pad(&speed),
            acceleration: pad(&acceleration),
            torque: torque.map(|t| pad(&t)),
        }
    }
}

/// The course of a run, from the first motion of its reference to the reference's end.
pub(crate) fn course_of<const N: usize>(problem: &Problem<N>, trace: &Trace) -> Course {
    let following = trace.following();
    let start = following.iter().position(|s| s.path_rate > 0.0).unwrap_or(following.len());
    // The last sample of a regulated run is cut short at the path's end: its command is not one of the law's.
    let end = if trace.method.is_regulated() { following.len().saturating_sub(1).max(start) } else { following.len() };
    let moving = &following[start..end];
    let settled = moving.iter().find(|s| trace.method.is_regulated() && s.limit_ratio >= AT_LIMIT);
    let moments: Vec<Moment<N>> = moving.iter().map(Moment::of).collect();
    Course {
        joints: N,
        units: JointUnits::of(&problem.path.arm),
        path: problem.path.begin()..problem.path.end(),
        settled_s: settled.map_or(0.0, |s| s.t),
        start: moments.first().map_or([0.0; MAX_JOINTS], |m| pad(&m.q)),
        samples: moments.windows(2).map(|w| w[0].on_to(&w[1], problem.dynamics.as_ref())).collect(),
    }
}

/// The course of an optimum's profile. Intervals at whose ends the rate has no bound are left out.
pub(crate) fn course_along<const N: usize>(
    problem: &Problem<N>,
    path: &JointPath<N>,
    profile: &[ProfilePoint],
) -> Result<Course, ProblemError> {
    let mut samples = Vec::new();
    let mut start = None;
    for pair in profile.windows(2).filter(|w| w[0].piece == w[1].piece && w[0].t < w[1].t) {
        let Some(piece) = path.pieces().get(pair[0].piece) else { continue };
        let moment = |point: &ProfilePoint| -> Result<Moment<N>, ProblemError> {
            let at = piece.at(&problem.path, point.s)?;
            Ok(Moment { t: point.t, lambda: at.lambda, q: at.q, speed: at.first * point.rate })
        };
        if pair.iter().all(|p| p.rate.is_finite()) {
            let from = moment(&pair[0])?;
            start = start.or(Some(pad(&from.q)));
            samples.push(from.on_to(&moment(&pair[1])?, problem.dynamics.as_ref()));
        }
    }
    Ok(Course {
        joints: N,
        units: JointUnits::of(&problem.path.arm),
        path: problem.path.begin()..problem.path.end(),
        settled_s: 0.0,
        start: start.unwrap_or([0.0; MAX_JOINTS]),
        samples,
    })
}
