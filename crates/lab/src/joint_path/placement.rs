use crate::error::{Fault, LabError};
use crate::path::reference::{Reference, ToolReference};
use crate::problem::Problem;
use crate::scenario::Scenario;
use crate::scenario::number::joints;
use crate::scenario::schema::{BranchTable, ElbowName, ShoulderName, StartTable, WristName};
use nalgebra::Translation3;
use nalgebra::Vector3;
use slideway_robot::{
    Branch, Elbow, EulerAngles, JointVector, NumericIk, NumericIkSettings, Pose, Shoulder, SphericalWristIk, Wrist,
    euler,
};

/// Finds where the robot stands at first, and the configuration on the path's first point.
pub(crate) struct Placement<'a, const N: usize> {
    pub(crate) problem: &'a mut Problem<N>,
    pub(crate) scenario: &'a Scenario,
}

impl<const N: usize> Placement<'_, N> {
    pub(crate) fn place(&mut self) -> Result<(), LabError> {
        match self.problem.path.clone() {
            Reference::Joint(curve) => self.place_joints(curve.at(curve.start())[0]),
            Reference::Tool(tool) => self.place_tool(&tool),
        }
    }

    fn table(&self) -> &StartTable {
        &self.scenario.file.start
    }

    /// A path of the joints begins where it says; the robot may stand elsewhere.
    fn place_joints(&mut self, first: JointVector<N>) -> Result<(), LabError> {
        let table = self.table();
        let others =
            [("pose", table.pose.is_some()), ("branch", table.branch.is_some()), ("near", table.near.is_some())];
        if let Some((key, _)) = others.into_iter().find(|(_, given)| *given) {
            let fault = Fault::Conflict(
                "with a path of the joints the robot's place is given by `start.q`, or is the path's start",
            );
            return Err(LabError::value(format!("start.{key}"), fault));
        }
        let start = table.q.as_ref().map(|q| joints::<N>("start.q", q)).transpose()?;
        self.problem.path_start = first;
        self.problem.start = start.unwrap_or(first);
        self.problem.start_euler = self.euler_near(&Vector3::zeros());
        Ok(())
    }

    fn place_tool(&mut self, tool: &ToolReference) -> Result<(), LabError> {
        let table = self.table().clone();
        let branch = table.branch.as_ref().map(branch);
        let near = table.near.as_ref().map(|q| joints::<N>("start.near", q)).transpose()?;
        let first = tool.path.at(tool.path.start());
        let key = self.scenario.path_start_key();
        if let Some(q) = &table.q {
            if table.pose.is_some() || branch.is_some() || near.is_some() {
                let fault = Fault::Conflict("`start.q` says it all; remove the other keys");
                return Err(LabError::value("start.q", fault));
            }
            self.problem.start = joints::<N>("start.q", q)?;
            self.problem.path_start = self.solve_pose(tool, &first.pose, None, Some(self.problem.start), &key)?;
        } else {
            self.problem.path_start = self.solve_pose(tool, &first.pose, branch, near, &key)?;
            self.problem.start = match &table.pose {
                Some(numbers) => {
                    let near = near.or(Some(self.problem.path_start));
                    self.solve_pose(tool, &pose(&numbers.map(|n| n.0)), branch, near, "start.pose")?
                }
                None => self.problem.path_start,
            };
        }
        let given = table.pose.map(|p| Vector3::new(p[3].0, p[4].0, p[5].0));
        let path = first.euler.map_or_else(Vector3::zeros, |e| e.angles);
        self.problem.start_euler = self.euler_near(&given.unwrap_or(path));
        Ok(())
    }

    fn euler_near(&self, wanted: &Vector3<f64>) -> Vector3<f64> {
        euler::nearest(&self.problem.arm.forward(&self.problem.start).rotation, wanted)
    }

    /// A configuration for a tool pose: closed form on a branch, else numeric from a seed.
    fn solve_pose(
        &self,
        tool: &ToolReference,
        pose: &Pose,
        branch: Option<Branch>,
        near: Option<JointVector<N>>,
        key: &str,
    ) -> Result<JointVector<N>, LabError> {
        let arm = &self.problem.arm;
        if let Some(branch) = branch {
            let ik = SphericalWristIk::new(arm).map_err(|error| LabError::value("start.branch", error))?;
            let q = ik.solve(pose, branch).map_err(|error| LabError::value(key, error))?;
            return Ok(JointVector::from_fn(|i, _| q[i]));
        }
        let Some(seed) = near else {
            return Err(LabError::value(
                "start",
                Fault::Missing("say where the robot stands: `q`, or `branch`, or `near` (joint positions close to it)"),
            ));
        };
        NumericIk::new(arm, tool.task, NumericIkSettings::default())
            .solve(pose, &seed)
            .map_err(|error| LabError::value(key, error))
    }
}

fn branch(table: &BranchTable) -> Branch {
    Branch {
        shoulder: match table.shoulder {
            ShoulderName::Right => Shoulder::Right,
            ShoulderName::Left => Shoulder::Left,
        },
        elbow: match table.elbow {
            ElbowName::Up => Elbow::Up,
            ElbowName::Down => Elbow::Down,
        },
        wrist: match table.wrist {
            WristName::NoFlip => Wrist::NoFlip,
            WristName::Flip => Wrist::Flip,
        },
    }
}

/// The pose of tool coordinates `[x y z α β γ]`.
pub(crate) fn pose(coordinates: &[f64; 6]) -> Pose {
    let [x, y, z, alpha, beta, gamma] = *coordinates;
    Pose::from_parts(Translation3::new(x, y, z), euler::rotation(&EulerAngles::new(alpha, beta, gamma)))
}
