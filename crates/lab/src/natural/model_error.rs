use super::integrate::State;
use crate::run::course::{Course, CourseSample};
use nalgebra::SMatrix;
use slideway_path::ProblemError;
use slideway_robot::{Dynamics, JointVector, RobotError};

/// Run under a controller with a wrong model: distances of the tool from where a law has it.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelErrorRun {
    /// The instants, from the course's start.
    pub samples: Vec<ModelErrorSample>,
}

/// One instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModelErrorSample {
    /// Time since the course's start, s.
    pub t: f64,
    /// Path parameter.
    pub lambda: f64,
    /// Distance of the tool's origin from where the course has it at this time, m.
    pub distance: f64,
}

impl ModelErrorRun {
    /// Largest distance, m.
    #[must_use]
    pub fn peak(&self) -> f64 {
        self.samples.iter().map(|s| s.distance).fold(0.0, f64::max)
    }
}

/// Both poles of the error, 1/s: `ë + 20 ė + 100 e` is what the model misses.
const POLE: f64 = 10.0;

/// Longest step of the integration, s: that of the study of `[N] Fig. 3` under resolved acceleration.
const LONGEST_STEP: f64 = 2e-3;

/// A joint speed may differ by this share of the largest between the end of an interval and the start of the next: the sum of
/// a mean and half a change, in rounding.
const JOINING: f64 = 1e-9;

// The columns of the loop's state: the arm's position and speed, and the course's own position.
const POSITION: usize = 0;
const SPEED: usize = 1;
const REFERENCE: usize = 2;

/// An arm and what its controller takes it for.
pub(crate) struct WrongModel<'a, const N: usize> {
    arm: &'a Dynamics<N>,
    model: Dynamics<N>,
}

impl<'a, const N: usize> WrongModel<'a, N> {
    /// A model in which the links' masses and moments of inertia are wrong by `share` and `-share`, by turns from the base.
    pub(crate) fn new(arm: &'a Dynamics<N>, share: f64) -> Result<Self, ProblemError> {
        let shares = std::array::from_fn(|i| if i % 2 == 0 { share } else { -share });
        let model = arm.with_mass_errors(&shares).map_err(|error| unusable(error.into()))?;
        Ok(Self { arm, model })
    }

    /// Follows a course by computed torque in joint space, `τ = M̂ (q̈_r + 20 ė + 100 e) + ĉ + ĝ`, from the course's own start.
    ///
    /// `q̈_r` is constant over each interval, `q̇_r` its integral. `None` where `q̇_r` jumps between two intervals.
    pub(crate) fn follow(&self, course: &Course) -> Result<Option<ModelErrorRun>, ProblemError> {
        let Some(first) = course.samples.first().filter(|_| joins(course)) else { return Ok(None) };
        let start = vector(&course.start);
        let joints = SMatrix::from_columns(&[start, speed_at(first, 0.0), start]);
        let parameter = first.lambda - 0.5 * first.path_rate * first.dt;
        let mut state = State { joints, parameter, clock: 0.0 };
        let mut samples = vec![self.sample(&state)];
        for interval in &course.samples {
            let begin = state.clock;
            let steps = (interval.dt / LONGEST_STEP).ceil().max(1.0);
            let mut done = 0.0;
            while done < steps {
                state = state.step(interval.dt / steps, |s| self.rate(s, interval, s.clock - begin))?;
                samples.push(self.sample(&state));
                done += 1.0;
            }
        }
        Ok(Some(ModelErrorRun { samples }))
    }

    /// The loop's rate `since` seconds after the start of an interval.
    fn rate(&self, state: &State<N, 3>, interval: &CourseSample, since: f64) -> Result<State<N, 3>, ProblemError> {
        let column = |i: usize| state.joints.column(i).into_owned();
        let (q, qd) = (column(POSITION), column(SPEED));
        let reference = speed_at(interval, since);
        let feedback = (reference - qd) * (2.0 * POLE) + (column(REFERENCE) - q) * (POLE * POLE);
        let torque = self.model.inverse(&q, &qd, &(vector(&interval.acceleration) + feedback));
        let acceleration = self.arm.forward(&q, &qd, &torque).map_err(|error| unusable(error.into()))?;
        let joints = SMatrix::from_columns(&[qd, acceleration, reference]);
        Ok(State { joints, parameter: interval.path_rate, clock: 1.0 })
    }

    fn sample(&self, state: &State<N, 3>) -> ModelErrorSample {
        let tool = |i: usize| self.arm.arm().forward(&state.joints.column(i).into_owned()).translation.vector;
        let distance = (tool(POSITION) - tool(REFERENCE)).norm();
        ModelErrorSample { t: state.clock, lambda: state.parameter, distance }
    }
}

fn unusable(error: RobotError) -> ProblemError {
    ProblemError::value("robot", error)
}

fn vector<const N: usize>(values: &[f64]) -> JointVector<N> {
    JointVector::from_fn(|i, _| values.get(i).copied().unwrap_or(0.0))
}

/// The joint speed `since` seconds after the start of an interval.
fn speed_at<const N: usize>(interval: &CourseSample, since: f64) -> JointVector<N> {
    vector::<N>(&interval.speed) + vector::<N>(&interval.acceleration) * (since - 0.5 * interval.dt)
}

/// True if every interval begins with the joint speed at which the one before ended.
fn joins(course: &Course) -> bool {
    let end = |s: &CourseSample, joint: usize, sign: f64| s.speed[joint] + sign * 0.5 * s.dt * s.acceleration[joint];
    let speeds = course.samples.iter().flat_map(|s| (0..course.joints).map(|i| end(s, i, 1.0).abs()));
    let room = JOINING * speeds.fold(0.0, f64::max);
    let same =
        |w: &[CourseSample]| (0..course.joints).all(|i| (end(&w[0], i, 1.0) - end(&w[1], i, -1.0)).abs() <= room);
    course.samples.windows(2).all(same)
}
