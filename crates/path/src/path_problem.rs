use crate::error::ProblemError;
use crate::limits::drive_and_tool::{ToolLimits, TorqueLimits};
use crate::limits::joint_bounds::JointBounds;
use crate::limits::position_limits::PositionLimits;
use crate::limits::rows::{EndRate, SpeedLimit};
use crate::reference::reference::Reference;
use slideway_conditioner::SpeedLimits;
use slideway_robot::{JointVector, Pose, SerialArm};

/// An arm, the path it is to follow and its limits: everything that an optimum needs.
///
/// [`PathProblem::new`] has joint-speed limits alone; the other limits are fields to be set.
#[derive(Clone, Debug)]
pub struct PathProblem<const N: usize> {
    /// The arm.
    pub arm: SerialArm<N>,
    /// The path.
    pub reference: Reference<N>,
    /// The configuration on the path's first point, rad (m).
    pub start: JointVector<N>,
    /// Joint-speed limits, rad/s (m/s for joints that slide); where they vary along the path, the widest they get.
    pub speed_limits: SpeedLimits<N>,
    /// Joint-speed limits along the path, where they vary.
    pub speed_along: Option<JointBounds<N>>,
    /// Joint-acceleration limits, rad/s² (m/s²).
    pub acceleration_limits: Option<JointBounds<N>>,
    /// Torque limits of the drives, with the robot's dynamics.
    pub torque_limits: Option<TorqueLimits<N>>,
    /// Limits of the tool.
    pub tool_limits: ToolLimits,
    /// Ranges of the joints: reported, not enforced.
    pub position_limits: PositionLimits<N>,
    /// Path rate at the path's first point.
    pub start_rate: EndRate,
    /// Path rate at its last point.
    pub end_rate: EndRate,
}

impl<const N: usize> PathProblem<N> {
    /// A problem under joint-speed limits alone, rad/s (m/s), from a configuration on the path's first point: of a path of the
    /// joints its own first point, of one of the tool a solution of the inverse kinematics.
    #[must_use]
    pub fn new(
        arm: SerialArm<N>,
        reference: Reference<N>,
        start: JointVector<N>,
        speed_limits: SpeedLimits<N>,
    ) -> Self {
        Self {
            arm,
            reference,
            start,
            speed_limits,
            speed_along: None,
            acceleration_limits: None,
            torque_limits: None,
            tool_limits: ToolLimits::default(),
            position_limits: PositionLimits::NONE,
            start_rate: EndRate::ByLimits,
            end_rate: EndRate::ByLimits,
        }
    }

    /// Path parameter at the path's start.
    #[must_use]
    pub fn begin(&self) -> f64 {
        self.reference.start()
    }

    /// Path parameter at the path's end.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.reference.end()
    }

    /// Path parameter from the path's start to its end.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.end() - self.begin()
    }

    /// Whether the arm has more joints than the path prescribes coordinates.
    #[must_use]
    pub fn is_redundant(&self) -> bool {
        matches!(&self.reference, Reference::Tool(tool) if tool.task.rows().len() < N)
    }

    /// Pose of the tool that the path asks for at a path parameter, base frame.
    #[must_use]
    pub fn reference_pose(&self, lambda: f64) -> Pose {
        match &self.reference {
            Reference::Tool(tool) => tool.path.at(lambda).pose,
            Reference::Joint(curve) => self.arm.forward(&curve.at(lambda)[0]),
        }
    }

    /// Acceleration limits that are symmetric and the same everywhere.
    #[must_use]
    pub fn everywhere_acceleration(&self) -> Option<[f64; N]> {
        self.acceleration_limits.as_ref()?.constant()?.symmetric()
    }

    /// Joint-speed limits at a path parameter.
    ///
    /// # Errors
    ///
    /// A formula whose value there is no limit; it was tried at a thousand points before.
    pub fn speed_limits_at(&self, lambda: f64) -> Result<SpeedLimits<N>, ProblemError> {
        let Some(bounds) = &self.speed_along else { return Ok(self.speed_limits) };
        let range = bounds.at(lambda);
        SpeedLimits::new(range.lower, range.upper).map_err(|error| ProblemError::value("limits.speed", error))
    }

    /// The path rate at which the reference's tool speed reaches its limit, at a path parameter.
    ///
    /// Of a path of the joints the tool's speed is `J(q) q'`.
    #[must_use]
    pub fn tool_rate_limit(&self, lambda: f64) -> f64 {
        let Some(limit) = self.tool_limits.speed else { return f64::INFINITY };
        let first: [f64; 3] = match &self.reference {
            Reference::Tool(tool) => tool.path.at(lambda).twist.fixed_rows::<3>(0).into_owned().into(),
            Reference::Joint(curve) => {
                let [q, first, _] = curve.at(lambda);
                (self.arm.jacobian(&q) * first).fixed_rows::<3>(0).into_owned().into()
            }
        };
        SpeedLimit::tool(first, limit).rate
    }
}
