use crate::tables::number::joints;
use crate::tables::{BranchTable, ElbowName, ShoulderName, StartTable, WristName};
use nalgebra::{Translation3, Vector3};
use slideway_path::{Fault, ProblemError, Reference, ToolReference};
use slideway_robot::{
    Branch, Elbow, EulerAngles, JointVector, NumericIk, NumericIkSettings, Pose, SerialArm, Shoulder, SphericalWristIk,
    Wrist, euler,
};

/// A robot at the start: where it stands, and the configuration on the path's first point.
pub(crate) struct Start<const N: usize> {
    pub(crate) q: JointVector<N>,
    /// Euler triple of the tool there, nearest to the path's.
    pub(crate) euler: EulerAngles,
    pub(crate) on_path: JointVector<N>,
}

/// Finds the start from its table.
pub(crate) struct Placement<'a, const N: usize> {
    pub(crate) arm: &'a SerialArm<N>,
    pub(crate) reference: &'a Reference<N>,
    pub(crate) table: &'a StartTable,
    /// Key of the path's first point, for errors about it.
    pub(crate) path_key: String,
}

impl<const N: usize> Placement<'_, N> {
    pub(crate) fn place(&self) -> Result<Start<N>, ProblemError> {
        match self.reference {
            Reference::Joint(curve) => self.place_joints(curve.at(curve.start())[0]),
            Reference::Tool(tool) => self.place_tool(tool),
        }
    }

    /// A path of the joints begins where it says; the robot may stand elsewhere.
    fn place_joints(&self, first: JointVector<N>) -> Result<Start<N>, ProblemError> {
        let table = self.table;
        let others =
            [("pose", table.pose.is_some()), ("branch", table.branch.is_some()), ("near", table.near.is_some())];
        if let Some((key, _)) = others.into_iter().find(|(_, given)| *given) {
            let fault = Fault::Conflict(
                "with a path of the joints the robot's place is given by `start.q`, or is the path's start",
            );
            return Err(ProblemError::value(format!("start.{key}"), fault));
        }
        let q = table.q.as_ref().map(|q| joints::<N>("start.q", q)).transpose()?.unwrap_or(first);
        Ok(Start { q, euler: self.euler_near(&q, &Vector3::zeros()), on_path: first })
    }

    fn place_tool(&self, tool: &ToolReference) -> Result<Start<N>, ProblemError> {
        let table = self.table;
        let branch = table.branch.as_ref().map(branch);
        let near = table.near.as_ref().map(|q| joints::<N>("start.near", q)).transpose()?;
        let first = tool.path.at(tool.path.start());
        let key = &self.path_key;
        let (q, on_path) = if let Some(q) = &table.q {
            if table.pose.is_some() || branch.is_some() || near.is_some() {
                let fault = Fault::Conflict("`start.q` says it all; remove the other keys");
                return Err(ProblemError::value("start.q", fault));
            }
            let q = joints::<N>("start.q", q)?;
            (q, self.solve_pose(tool, &first.pose, None, Some(q), key)?)
        } else {
            let on_path = self.solve_pose(tool, &first.pose, branch, near, key)?;
            let q = match &table.pose {
                Some(numbers) => {
                    let near = near.or(Some(on_path));
                    self.solve_pose(tool, &pose(&numbers.map(|n| n.0)), branch, near, "start.pose")?
                }
                None => on_path,
            };
            (q, on_path)
        };
        let given = table.pose.map(|p| Vector3::new(p[3].0, p[4].0, p[5].0));
        let path = first.euler.map_or_else(Vector3::zeros, |e| e.angles);
        Ok(Start { q, euler: self.euler_near(&q, &given.unwrap_or(path)), on_path })
    }

    fn euler_near(&self, q: &JointVector<N>, wanted: &Vector3<f64>) -> Vector3<f64> {
        euler::nearest(&self.arm.forward(q).rotation, wanted)
    }

    /// A configuration for a tool pose: closed form on a branch, else numeric from a seed.
    fn solve_pose(
        &self,
        tool: &ToolReference,
        pose: &Pose,
        branch: Option<Branch>,
        near: Option<JointVector<N>>,
        key: &str,
    ) -> Result<JointVector<N>, ProblemError> {
        let arm = self.arm;
        if let Some(branch) = branch {
            let ik = SphericalWristIk::new(arm).map_err(|error| ProblemError::value("start.branch", error))?;
            let q = ik.solve(pose, branch).map_err(|error| ProblemError::value(key, error))?;
            return Ok(JointVector::from_fn(|i, _| q[i]));
        }
        let Some(seed) = near else {
            return Err(ProblemError::value(
                "start",
                Fault::Missing("say where the robot stands: `q`, or `branch`, or `near` (joint positions close to it)"),
            ));
        };
        NumericIk::new(arm, tool.task, NumericIkSettings::default())
            .solve(pose, &seed)
            .map_err(|error| ProblemError::value(key, error))
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
fn pose(coordinates: &[f64; 6]) -> Pose {
    let [x, y, z, alpha, beta, gamma] = *coordinates;
    Pose::from_parts(Translation3::new(x, y, z), euler::rotation(&EulerAngles::new(alpha, beta, gamma)))
}
