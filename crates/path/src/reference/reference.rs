use crate::reference::cartesian::CartesianPath;
use crate::reference::joint_curve::JointCurve;
use slideway_robot::{InverseMethod, Task};

/// A path of the tool or of the joints.
#[derive(Clone, Debug)]
pub enum Reference<const N: usize> {
    /// The tool follows a path; inverse kinematics finds the joints.
    Tool(ToolReference),
    /// The joints follow a path of their own.
    Joint(JointCurve<N>),
}

/// A path of the tool and how the controller follows it.
#[derive(Clone, Debug)]
pub struct ToolReference {
    /// The path.
    pub path: CartesianPath,
    /// Tool coordinates that the path prescribes.
    pub task: Task,
    /// Inverse by which the controller turns a tool twist into joint speeds.
    pub inverse: InverseMethod,
}

impl<const N: usize> Reference<N> {
    /// Path parameter at the start.
    #[must_use]
    pub fn start(&self) -> f64 {
        match self {
            Self::Tool(tool) => tool.path.start(),
            Self::Joint(curve) => curve.start(),
        }
    }

    /// Path parameter at the end.
    #[must_use]
    pub fn end(&self) -> f64 {
        match self {
            Self::Tool(tool) => tool.path.end(),
            Self::Joint(curve) => curve.end(),
        }
    }

    /// Path parameters strictly inside the path where its derivative jumps, increasing.
    #[must_use]
    pub fn kinks(&self) -> Vec<f64> {
        match self {
            Self::Tool(tool) => tool.path.kinks().to_vec(),
            Self::Joint(curve) => curve.kinks(),
        }
    }
}
