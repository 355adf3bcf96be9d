use super::problem::{NaturalProblem, PathPlace};
use crate::error::{Fault, LabError};
use crate::path::CartesianPath;
use crate::path::reference::Reference;
use crate::problem::Problem;
use crate::robot::{describe, robot_key};
use crate::scenario::Scenario;
use slideway_robot::RobotError;
use slideway_robot::augmented::SpeedFactor;

impl<const N: usize> NaturalProblem<N, CartesianPath> {
    /// The robot and the tool path of a scenario, from the path's first point on, with the robot's masses if it has any.
    ///
    /// # Errors
    ///
    /// The scenario is about another number of joints or about a path of the joints; it cannot be used at all; the task has
    /// not as many coordinates as the arm joints (lock a joint: `robot.locked`).
    pub fn from_scenario(scenario: &Scenario, factor: SpeedFactor) -> Result<Self, LabError> {
        let robot = describe(scenario)?;
        let key = robot_key(&scenario.file.robot);
        let natural = Self::of(&Problem::<N>::new(scenario, &robot)?, factor)?;
        if !robot.has_masses() {
            return Ok(natural);
        }
        Ok(natural.with_dynamics(robot.dynamics().map_err(|error| LabError::value(key, error))?))
    }

    /// The arm and the tool path of a problem, without masses.
    pub(crate) fn of(problem: &Problem<N>, factor: SpeedFactor) -> Result<Self, LabError> {
        let Reference::Tool(tool) = &problem.path else {
            return Err(LabError::value("path.joints", Fault::Conflict("natural motion is about a path of the tool")));
        };
        let start = PathPlace { q: problem.path_start, parameter: tool.path.start() };
        Self::new(problem.arm.clone(), tool.task, factor, tool.path.clone(), start).map_err(pointed)
    }
}

/// The factor asks for a wrist, all else is a matter of the task.
fn pointed(error: RobotError) -> LabError {
    match error {
        RobotError::NotSphericalWrist { reason } => LabError::value("natural.factor", Fault::NoWristFactor { reason }),
        error => LabError::value("robot.task", error),
    }
}
