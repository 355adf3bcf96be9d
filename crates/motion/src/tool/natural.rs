use super::walk::{Nodes, place};
use super::{CurvePoint, ToolCurve, ToolKinematics};
use crate::MotionError;
use slideway_robot::JointVector;
use slideway_robot::augmented::{PathTangent, SingularityConsistent, SpeedFactor};

/// Bound on the rate of a curve besides the joints' limits.
#[derive(Clone, Copy, Debug)]
pub(super) enum Ceiling {
    /// None: the limits alone.
    Limits,
    /// Natural motion.
    Natural(NaturalPace),
}

/// Natural motion along a curve: `u̇ = b |det J|` with one `b` for the whole curve.
#[derive(Clone, Copy, Debug)]
pub(super) struct NaturalPace {
    inversion: SingularityConsistent,
    b: f64,
}

impl NaturalPace {
    /// The largest `b` that keeps the limits at every node: `b |n_i| <= V_i` and `b² |((∂n̄/∂q̄) n̄)_i| <= A_i`.
    ///
    /// # Errors
    ///
    /// A task that has not as many coordinates as the arm has joints.
    pub(super) fn new<const N: usize>(
        kinematics: &ToolKinematics<N>,
        curve: &ToolCurve,
        nodes: &Nodes<N>,
        (speeds, accelerations): (&[f64; N], &[f64; N]),
    ) -> Result<Self, MotionError> {
        let inversion = SingularityConsistent::new(kinematics.task(), SpeedFactor::Determinant, N)?;
        let mut b = f64::INFINITY;
        for (index, node) in nodes.iter().enumerate() {
            let flow = inversion.flow(kinematics.arm(), &node.q, &tangent(&curve.at(place(index))));
            for joint in 0..N {
                b = b.min(speeds[joint] / flow.direction.joints[joint].abs());
                b = b.min((accelerations[joint] / flow.slope.joints[joint].abs()).sqrt());
            }
        }
        Ok(Self { inversion, b })
    }

    /// `u̇` at a place.
    fn rate<const N: usize>(&self, kinematics: &ToolKinematics<N>, point: &CurvePoint, q: &JointVector<N>) -> f64 {
        self.b * self.inversion.direction(kinematics.arm(), q, &point.twist).path.abs()
    }
}

impl Ceiling {
    /// Largest `u̇` at a place.
    pub(super) fn rate<const N: usize>(
        &self,
        kinematics: &ToolKinematics<N>,
        point: &CurvePoint,
        q: &JointVector<N>,
    ) -> f64 {
        match self {
            Self::Limits => f64::INFINITY,
            Self::Natural(pace) => pace.rate(kinematics, point, q),
        }
    }
}

fn tangent(point: &CurvePoint) -> PathTangent {
    PathTangent { twist: point.twist, slope: point.slope }
}
