use super::path::{ParametrisedPath, PathState};
use slideway_path::{CartesianPath, Fault, PathProblem, ProblemError, Reference};
use slideway_robot::augmented::{Flow, SingularityConsistent, SpeedFactor};
use slideway_robot::{Dynamics, JointVector, RobotError, SerialArm, Task};

/// Where the arm is on the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathPlace<const N: usize> {
    /// Joint position, rad.
    pub q: JointVector<N>,
    /// Path parameter `q*`.
    pub parameter: f64,
}

/// An arm that follows a path from a start on it.
#[derive(Clone, Debug)]
pub struct NaturalProblem<const N: usize, P> {
    arm: SerialArm<N>,
    dynamics: Option<Dynamics<N>>,
    inversion: SingularityConsistent,
    path: P,
    start: PathPlace<N>,
}

impl<const N: usize, P: ParametrisedPath> NaturalProblem<N, P> {
    /// An arm without masses. The start is taken to lie on the path.
    ///
    /// # Errors
    ///
    /// The task has not as many coordinates as the arm joints, or the factor does not fit.
    pub fn new(
        arm: SerialArm<N>,
        task: Task,
        factor: SpeedFactor,
        path: P,
        start: PathPlace<N>,
    ) -> Result<Self, RobotError> {
        let inversion = SingularityConsistent::new(task, factor, N)?;
        Ok(Self { arm, dynamics: None, inversion, path, start })
    }

    /// The same with the arm's masses: torques become known. The kinematics are those of `dynamics`.
    #[must_use]
    pub fn with_dynamics(self, dynamics: Dynamics<N>) -> Self {
        Self { arm: dynamics.arm().clone(), dynamics: Some(dynamics), ..self }
    }

    /// The arm.
    #[must_use]
    pub fn arm(&self) -> &SerialArm<N> {
        &self.arm
    }

    /// The arm with its masses, if they are known.
    #[must_use]
    pub fn dynamics(&self) -> Option<&Dynamics<N>> {
        self.dynamics.as_ref()
    }

    /// The task.
    #[must_use]
    pub fn task(&self) -> Task {
        self.inversion.task()
    }

    /// The path.
    #[must_use]
    pub fn path(&self) -> &P {
        &self.path
    }

    /// Where it starts.
    #[must_use]
    pub fn start(&self) -> &PathPlace<N> {
        &self.start
    }

    /// Distance of the tool from its place on the path, in the coordinates of position that the task has, m.
    #[must_use]
    pub fn distance_from_path(&self, place: &PathPlace<N>) -> f64 {
        let wanted = self.path.at(place.parameter).pose.translation.vector;
        let gap = wanted - self.arm.forward(&place.q).translation.vector;
        self.task().rows().iter().filter_map(|&row| gap.get(row)).map(|x| x * x).sum::<f64>().sqrt()
    }

    /// The null vector and its derivative at a place.
    #[must_use]
    pub fn flow(&self, place: &PathPlace<N>) -> Flow<N> {
        let PathState { tangent, .. } = self.path.at(place.parameter);
        self.inversion.flow(&self.arm, &place.q, &tangent)
    }
}

impl<const N: usize> NaturalProblem<N, CartesianPath> {
    /// The arm and the tool path of a problem, without masses.
    ///
    /// # Errors
    ///
    /// A path of the joints; a task that has not as many coordinates as the arm joints (lock a joint).
    pub fn of(problem: &PathProblem<N>, factor: SpeedFactor) -> Result<Self, ProblemError> {
        let Reference::Tool(tool) = &problem.reference else {
            return Err(ProblemError::value(
                "path.joints",
                Fault::Conflict("natural motion is about a path of the tool"),
            ));
        };
        let start = PathPlace { q: problem.start, parameter: tool.path.start() };
        Self::new(problem.arm.clone(), tool.task, factor, tool.path.clone(), start).map_err(pointed)
    }
}

/// The factor asks for a wrist, all else is a matter of the task.
fn pointed(error: RobotError) -> ProblemError {
    match error {
        RobotError::NotSphericalWrist { reason } => {
            ProblemError::value("natural.factor", Fault::NoWristFactor { reason })
        }
        error => ProblemError::value("robot.task", error),
    }
}
