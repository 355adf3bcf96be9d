use super::integrate::State;
use super::path::ParametrisedPath;
use super::problem::{NaturalProblem, PathPlace};
use slideway_path::ProblemError;
use slideway_robot::augmented::{PathTorque, path_torque};

/// Length of a step along the curve in augmented joint space, rad. The fourth-order method's error of a step of this length
/// is of the order of 1e-12 where the curve's radius is 0.1 rad.
const STEP: f64 = 1e-3;

/// Steps after which a survey gives up: a curve of a thousand radians.
const MAX_STEPS: usize = 1_000_000;

/// One place of a survey.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurveyPoint<const N: usize> {
    /// The place.
    pub place: PathPlace<N>,
    /// Time from the start at `b = 1`, s.
    pub time: f64,
    /// `‖n‖∞`: largest joint speed at `b = 1`, rad/s.
    pub speed: f64,
    /// `|φ|`: path speed at `b = 1`, 1/s.
    pub factor: f64,
    /// Torque as a function of `b`, if the masses are known.
    pub torque: Option<PathTorque<N>>,
}

/// A path gone along once at `b = 1`; what any other `b` does there follows from it.
#[derive(Clone, Debug, PartialEq)]
pub struct Survey<const N: usize> {
    /// Places from the start to the end.
    pub points: Vec<SurveyPoint<N>>,
}

impl<const N: usize, P: ParametrisedPath> NaturalProblem<N, P> {
    /// Follows the curve `q̄' = ±n̄ / ‖n̄‖` in augmented joint space, in the sense that starts towards `end`, until the path
    /// parameter gets there.
    ///
    /// # Errors
    ///
    /// [`ProblemError::NoFiniteSpeed`] where `n̄` is zero or not finite, or the curve turns back (at a singularity it passes
    /// through) and never reaches the end.
    pub fn survey(&self, end: f64) -> Result<Survey<N>, ProblemError> {
        let start = self.start();
        let towards = (end - start.parameter).signum();
        let sign = towards * self.flow(start).direction.path.signum();
        let mut state = State { joints: start.q, parameter: start.parameter, clock: 0.0 };
        let mut points = vec![self.point(&state)];
        let rate = |s: &State<N, 1>| Ok(self.unit_rate(s, sign));
        for _ in 0..MAX_STEPS {
            let next = state.step(STEP, rate)?;
            if (next.parameter - end) * towards < 0.0 {
                state = next;
                points.push(self.point(&state));
                continue;
            }
            // The last step is shortened by secants; the parameter is smooth along the curve.
            let mut last = next;
            let mut length = STEP;
            for _ in 0..4 {
                length *= (end - state.parameter) / (last.parameter - state.parameter);
                last = state.step(length, rate)?;
            }
            points.push(self.point(&last));
            return Ok(Survey { points });
        }
        Err(ProblemError::NoFiniteSpeed { at: state.parameter })
    }

    fn unit_rate(&self, state: &State<N, 1>, sign: f64) -> State<N, 1> {
        let direction = self.flow(&PathPlace { q: state.joints, parameter: state.parameter }).direction;
        let norm = direction.norm();
        State { joints: direction.joints * (sign / norm), parameter: direction.path * sign / norm, clock: 1.0 / norm }
    }

    fn point(&self, state: &State<N, 1>) -> SurveyPoint<N> {
        let place = PathPlace { q: state.joints, parameter: state.parameter };
        let flow = self.flow(&place);
        SurveyPoint {
            place,
            time: state.clock,
            speed: flow.direction.joints.amax(),
            factor: flow.direction.path.abs(),
            torque: self.dynamics().map(|d| path_torque(d, &place.q, &flow)),
        }
    }
}

impl<const N: usize> Survey<N> {
    /// Time that natural motion with `b` takes, ramps left out, s.
    #[must_use]
    pub fn duration(&self, b: f64) -> f64 {
        self.points.last().map_or(0.0, |p| p.time) / b
    }

    /// `b` at which the largest joint speed on the way is `peak` (rad/s).
    #[must_use]
    pub fn b_for_speed(&self, peak: f64) -> f64 {
        peak / self.largest(|p| p.speed)
    }

    /// Largest constant `b` at which no joint needs more torque than `peak` (N·m); `None` without masses, or where gravity
    /// alone needs more.
    #[must_use]
    pub fn b_for_torque(&self, peak: f64) -> Option<f64> {
        self.points.iter().try_fold(f64::INFINITY, |b, p| Some(b.min(p.torque?.largest_b(peak)?)))
    }

    /// Constant path speed at which the largest joint speed on the way is `peak` (rad/s), 1/s.
    #[must_use]
    pub fn path_speed_for_speed(&self, peak: f64) -> f64 {
        peak / self.largest(|p| p.speed / p.factor)
    }

    fn largest(&self, value: impl Fn(&SurveyPoint<N>) -> f64) -> f64 {
        self.points.iter().map(value).fold(0.0, f64::max)
    }
}
