use super::integrate::State;
use super::law::{Ramp, SpeedLaw};
use super::path::ParametrisedPath;
use super::problem::{NaturalProblem, PathPlace};
use slideway_path::ProblemError;
use slideway_robot::JointVector;
use slideway_robot::augmented::PathMotion;

/// Settings of a run: a speed law, its start and stop, and the number of steps of the integration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Run {
    /// The speed law.
    pub law: SpeedLaw,
    /// Start, stop and length of the run.
    pub ramp: Ramp,
    /// Number of equal steps.
    pub steps: usize,
}

impl Run {
    /// Length of a step, s.
    #[must_use]
    #[allow(clippy::cast_precision_loss)]
    pub fn step(&self) -> f64 {
        self.ramp.interval() / self.steps.max(1) as f64
    }
}

/// One instant of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NaturalSample<const N: usize> {
    /// Time, s.
    pub time: f64,
    /// Where the arm is.
    pub place: PathPlace<N>,
    /// Speeds and accelerations of the joints and of the path parameter.
    pub motion: PathMotion<N>,
    /// The speed factor `φ`: `det J`, or the part of it that is used.
    pub factor: f64,
    /// Speed of the tool's origin along the path, m/s.
    pub tool_speed: f64,
    /// Torque, N·m, if the masses are known.
    pub torque: Option<JointVector<N>>,
}

/// A run, sampled at the steps of its integration.
#[derive(Clone, Debug, PartialEq)]
pub struct NaturalTrace<const N: usize> {
    /// The samples, at least two.
    pub samples: Vec<NaturalSample<N>>,
}

impl<const N: usize, P: ParametrisedPath> NaturalProblem<N, P> {
    /// Runs a speed law with the arm exactly on the path: `(q, q*)` follows the flow `b n̄` (fourth-order integration), the
    /// torque is that of the motion.
    ///
    /// # Errors
    ///
    /// [`ProblemError::NoFiniteSpeed`]: constant speed at a singularity, or a start that is none.
    pub fn follow(&self, run: &Run) -> Result<NaturalTrace<N>, ProblemError> {
        let mut state = State { joints: self.start().q, parameter: self.start().parameter, clock: 0.0 };
        let mut samples = Vec::with_capacity(run.steps + 1);
        samples.push(self.sample(&state, run));
        for _ in 0..run.steps.max(1) {
            state = state.step(run.step(), |s| Ok(self.rate(s, run)))?;
            samples.push(self.sample(&state, run));
        }
        Ok(NaturalTrace { samples })
    }

    fn rate(&self, state: &State<N, 1>, run: &Run) -> State<N, 1> {
        let motion = self.motion(&PathPlace { q: state.joints, parameter: state.parameter }, state.clock, run);
        State { joints: motion.joint_speed, parameter: motion.path_speed, clock: 1.0 }
    }

    /// The motion that a run asks for at a place and time.
    pub(super) fn motion(&self, place: &PathPlace<N>, time: f64, run: &Run) -> PathMotion<N> {
        let flow = self.flow(place);
        let pace = run.law.pace(&flow, run.ramp.at(time));
        flow.motion(pace.b, pace.b_rate)
    }

    fn sample(&self, state: &State<N, 1>, run: &Run) -> NaturalSample<N> {
        let place = PathPlace { q: state.joints, parameter: state.parameter };
        let motion = self.motion(&place, state.clock, run);
        let tangent = self.path().at(place.parameter).tangent.twist;
        NaturalSample {
            time: state.clock,
            place,
            motion,
            factor: self.flow(&place).direction.path,
            tool_speed: tangent.fixed_rows::<3>(0).norm() * motion.path_speed.abs(),
            torque: self.dynamics().map(|d| d.inverse(&place.q, &motion.joint_speed, &motion.joint_acceleration)),
        }
    }
}
