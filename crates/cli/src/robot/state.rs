use crate::say::diagnostic::CliError;
use serde::Serialize;
use slideway_robot::{
    DriveEffects, Dynamics, JointVector, RobotDescription, RobotError, RobotSummary, Task, manipulability,
};

/// What is asked of a robot: positions, speeds, accelerations, and torques if there are any.
pub(crate) struct Inputs {
    pub(crate) q: Vec<f64>,
    pub(crate) qd: Vec<f64>,
    pub(crate) qdd: Vec<f64>,
    pub(crate) tau: Option<Vec<f64>>,
    pub(crate) effects: DriveEffects,
}

/// A robot at one state: what `slideway robot --json` prints. Matrices by rows; what needs masses is `null` without them.
#[derive(Debug, Serialize)]
pub(crate) struct RobotState {
    /// The robot, as in `summary.json`.
    pub(crate) robot: RobotSummary,
    /// Pose of the tool in the base frame, 4×4.
    pub(crate) pose: Vec<Vec<f64>>,
    /// Geometric Jacobian at the tool's origin in the base frame, 6×n, linear rows first.
    pub(crate) jacobian: Vec<Vec<f64>>,
    /// `sqrt(det(J Jᵀ))` of the full pose.
    pub(crate) manipulability: f64,
    /// Mass matrix, n×n, with rotor inertia if it takes part.
    pub(crate) mass_matrix: Option<Vec<Vec<f64>>>,
    /// Torque that holds the arm against gravity.
    pub(crate) gravity: Option<Vec<f64>>,
    /// Coriolis and centrifugal torque.
    pub(crate) coriolis: Option<Vec<f64>>,
    /// Inverse dynamics for `q`, `qd`, `qdd`.
    pub(crate) torque: Option<Vec<f64>>,
    /// Forward dynamics for `q`, `qd`, `tau`; `null` unless torques were given.
    pub(crate) acceleration: Option<Vec<f64>>,
}

/// Evaluates a robot of any supported number of joints; the caller has checked the lengths.
pub(crate) fn evaluate(robot: &RobotDescription, inputs: &Inputs) -> Result<RobotState, CliError> {
    let state = match robot.joint_count() {
        1 => state::<1>(robot, inputs),
        2 => state::<2>(robot, inputs),
        3 => state::<3>(robot, inputs),
        4 => state::<4>(robot, inputs),
        5 => state::<5>(robot, inputs),
        6 => state::<6>(robot, inputs),
        _ => state::<7>(robot, inputs),
    };
    state.map_err(|error| CliError::Robot { error: Box::new(error), name: robot.name.clone() })
}

fn state<const N: usize>(robot: &RobotDescription, inputs: &Inputs) -> Result<RobotState, RobotError> {
    let arm = robot.arm::<N>()?;
    let q = vector::<N>(&inputs.q)?;
    let jacobian = arm.jacobian(&q);
    let mut state = RobotState {
        robot: robot.into(),
        pose: rows(&arm.forward(&q).to_homogeneous()),
        jacobian: rows(&jacobian),
        manipulability: manipulability(Task::Pose, &jacobian),
        mass_matrix: None,
        gravity: None,
        coriolis: None,
        torque: None,
        acceleration: None,
    };
    if robot.has_masses() {
        let dynamics = robot.dynamics::<N>()?.with_effects(inputs.effects);
        fill(&mut state, &dynamics, &q, inputs)?;
    }
    Ok(state)
}

fn fill<const N: usize>(
    state: &mut RobotState,
    dynamics: &Dynamics<N>,
    q: &JointVector<N>,
    inputs: &Inputs,
) -> Result<(), RobotError> {
    let (qd, qdd) = (vector::<N>(&inputs.qd)?, vector::<N>(&inputs.qdd)?);
    let list = |v: JointVector<N>| Some(v.iter().copied().collect());
    state.mass_matrix = Some(rows(&dynamics.mass_matrix(q)));
    state.gravity = list(dynamics.gravity_torque(q));
    state.coriolis = list(dynamics.coriolis_torque(q, &qd));
    state.torque = list(dynamics.inverse(q, &qd, &qdd));
    if let Some(tau) = &inputs.tau {
        state.acceleration = list(dynamics.forward(q, &qd, &vector(tau)?)?);
    }
    Ok(())
}

fn vector<const N: usize>(numbers: &[f64]) -> Result<JointVector<N>, RobotError> {
    let numbers: [f64; N] =
        numbers.try_into().map_err(|_| RobotError::JointCount { found: numbers.len(), expected: N })?;
    Ok(numbers.into())
}

/// A matrix of any size by rows.
fn rows<const R: usize, const C: usize>(matrix: &nalgebra::SMatrix<f64, R, C>) -> Vec<Vec<f64>> {
    matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
}
