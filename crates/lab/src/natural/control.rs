use super::follow::Run;
use super::integrate::State;
use super::path::{ParametrisedPath, PathState};
use super::problem::{NaturalProblem, PathPlace};
use nalgebra::SMatrix;
use slideway_path::{Fault, ProblemError};
use slideway_robot::augmented::PathMotion;
use slideway_robot::{Dynamics, InverseMethod, JointVector, Twist, rotation_vector, solve_rates};

/// A path-tracking controller.
#[derive(Clone, Debug, PartialEq)]
pub enum Controller<const N: usize> {
    /// Resolved acceleration: `τ = M̂ Inv(J) (ẍ_r + damping ė + stiffness e - J̇ q̇) + ĉ + ĝ` with a model of the arm.
    ResolvedAcceleration {
        /// The controller's model of the arm.
        model: Box<Dynamics<N>>,
        /// Gain of the pose error, 1/s².
        stiffness: f64,
        /// Gain of the twist error, 1/s.
        damping: f64,
    },
    /// Inverse Jacobian: `q̇ = Inv(J) (t* q̇* + gain e)`, carried out as commanded.
    InverseJacobian {
        /// Gain of the pose error, 1/s.
        gain: f64,
    },
}

/// A closed-loop run: what to follow, with which controller and inverse.
#[derive(Clone, Debug, PartialEq)]
pub struct ControlRun<const N: usize> {
    /// Speed law, ramp and steps.
    pub run: Run,
    /// The controller.
    pub controller: Controller<N>,
    /// Its inverse of the Jacobian.
    pub inverse: InverseMethod,
}

/// The loop at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrackingError<const N: usize> {
    /// Time, s.
    pub time: f64,
    /// Distance of the tool from its reference, m.
    pub distance: f64,
    /// Joint position, rad.
    pub q: JointVector<N>,
    /// Joint speed, rad/s.
    pub joint_speed: JointVector<N>,
    /// Torque, N·m; `None` under the inverse-Jacobian controller, which commands speeds.
    pub torque: Option<JointVector<N>>,
}

/// Command of a controller, and the acceleration that comes of it.
struct Command<const N: usize> {
    joint_speed: JointVector<N>,
    joint_acceleration: JointVector<N>,
    torque: Option<JointVector<N>>,
}

// The columns of the loop's state: the arm's position and speed, and the reference's own joint position.
const POSITION: usize = 0;
const SPEED: usize = 1;
const REFERENCE: usize = 2;

impl<const N: usize, P: ParametrisedPath> NaturalProblem<N, P> {
    /// Runs a controller in closed loop, continuous in time (fourth-order integration), from the start at the
    /// reference's speed.
    ///
    /// The reference runs ahead on its own: `(q_r, q*)` follows the flow as in [`NaturalProblem::follow`], whatever the arm
    /// does. The arm is the problem's own, the controller's model may differ from it.
    ///
    /// # Errors
    ///
    /// Resolved acceleration for an arm without masses; [`ProblemError::NoFiniteSpeed`]; a mass matrix that is singular.
    pub fn control(&self, run: &ControlRun<N>) -> Result<Vec<TrackingError<N>>, ProblemError> {
        let start = self.start();
        let speed = self.motion(start, 0.0, &run.run).joint_speed;
        let joints = SMatrix::<f64, N, 3>::from_columns(&[start.q, speed, start.q]);
        let mut state = State { joints, parameter: start.parameter, clock: 0.0 };
        let mut samples = vec![self.tracking(&state, run)?];
        for _ in 0..run.run.steps.max(1) {
            state = state.step(run.run.step(), |s| self.loop_rate(s, run))?;
            samples.push(self.tracking(&state, run)?);
        }
        Ok(samples)
    }

    fn loop_rate(&self, state: &State<N, 3>, run: &ControlRun<N>) -> Result<State<N, 3>, ProblemError> {
        let reference = self.reference(state, run);
        let command = self.command(state, &reference, run)?;
        let columns = [command.joint_speed, command.joint_acceleration, reference.joint_speed];
        Ok(State { joints: SMatrix::from_columns(&columns), parameter: reference.path_speed, clock: 1.0 })
    }

    fn reference(&self, state: &State<N, 3>, run: &ControlRun<N>) -> PathMotion<N> {
        let place = PathPlace { q: state.joints.column(REFERENCE).into_owned(), parameter: state.parameter };
        self.motion(&place, state.clock, &run.run)
    }

    fn command(
        &self,
        state: &State<N, 3>,
        reference: &PathMotion<N>,
        run: &ControlRun<N>,
    ) -> Result<Command<N>, ProblemError> {
        let q = state.joints.column(POSITION).into_owned();
        let PathState { pose, tangent } = self.path().at(state.parameter);
        let tool = self.arm().forward(&q);
        let turn = rotation_vector(&(pose.rotation * tool.rotation.inverse()));
        let shift = pose.translation.vector - tool.translation.vector;
        let error = Twist::new(shift.x, shift.y, shift.z, turn.x, turn.y, turn.z);
        let twist = tangent.twist * reference.path_speed;
        let jacobian = self.arm().jacobian(&q);
        let inverse = |task_rate: &Twist| solve_rates(run.inverse, self.task(), &jacobian, task_rate);
        match &run.controller {
            Controller::InverseJacobian { gain } => Ok(Command {
                joint_speed: inverse(&(twist + error * *gain)),
                joint_acceleration: JointVector::zeros(),
                torque: None,
            }),
            Controller::ResolvedAcceleration { model, stiffness, damping } => {
                let arm = self.dynamics().ok_or_else(|| {
                    ProblemError::value("controller", Fault::Missing("resolved acceleration needs the arm's masses"))
                })?;
                let qd = state.joints.column(SPEED).into_owned();
                let feedforward =
                    tangent.slope * reference.path_speed.powi(2) + tangent.twist * reference.path_acceleration;
                let feedback = (twist - jacobian * qd) * *damping + error * *stiffness;
                let wanted = inverse(&(feedforward + feedback - self.arm().bias_acceleration(&q, &qd)));
                let torque = model.inverse(&q, &qd, &wanted);
                let joint_acceleration = arm
                    .forward(&q, &qd, &torque)
                    .map_err(|error| ProblemError::value("controller", slideway_robot::RobotError::from(error)))?;
                Ok(Command { joint_speed: qd, joint_acceleration, torque: Some(torque) })
            }
        }
    }

    fn tracking(&self, state: &State<N, 3>, run: &ControlRun<N>) -> Result<TrackingError<N>, ProblemError> {
        let command = self.command(state, &self.reference(state, run), run)?;
        let q = state.joints.column(POSITION).into_owned();
        Ok(TrackingError {
            time: state.clock,
            distance: self.distance_from_path(&PathPlace { q, parameter: state.parameter }),
            q,
            joint_speed: command.joint_speed,
            torque: command.torque,
        })
    }
}
