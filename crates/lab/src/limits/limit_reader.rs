use crate::error::{Fault, LabError};
use crate::limits::EndRate;
use crate::limits::dynamic_limits::{ToolLimits, TorqueLimits};
use crate::limits::joint_bounds::{BoundSigns, BoundTable, JointBounds};
use crate::scenario::number::positive;
use crate::scenario::number::{LimitNumber, Number, PerJointLimit};
use crate::scenario::schema::{DriveEffectName, LimitsTable, OwnName, TorqueTable};
use slideway_conditioner::SpeedLimits;
use slideway_robot::{DriveEffects, RobotDescription};
use std::ops::Range;

/// Reads a scenario's limits for a robot and a range of the path parameter.
pub(crate) struct LimitReader<'a> {
    pub(crate) table: &'a LimitsTable,
    pub(crate) robot: &'a RobotDescription,
    pub(crate) path: Range<f64>,
}

impl LimitReader<'_> {
    /// The scenario's speed limits, else those of the robot.
    pub(crate) fn speed<const N: usize>(&self) -> Result<JointBounds<N>, LabError> {
        let robots = || self.robot.velocity_limits().map(constants);
        let missing = Fault::Missing("the robot has no speed limits of its own for every joint");
        let upper = self.table.speed.clone().or_else(robots);
        let upper = upper.ok_or_else(|| LabError::value("limits.speed", missing))?;
        let lower = self.table.speed_lower.as_ref();
        self.bounds(&BoundTable { key: "limits.speed", upper: &upper, lower, signs: BoundSigns::AroundZero })
    }

    /// The widest that speed limits get along the path.
    pub(crate) fn widest_speed<const N: usize>(&self, speed: &JointBounds<N>) -> Result<SpeedLimits<N>, LabError> {
        let widest = speed.widest(&self.path);
        SpeedLimits::new(widest.lower, widest.upper).map_err(|error| LabError::value("limits.speed", error))
    }

    pub(crate) fn acceleration<const N: usize>(&self) -> Result<Option<JointBounds<N>>, LabError> {
        let lower = self.table.acceleration_lower.as_ref();
        let Some(upper) = &self.table.acceleration else {
            return needless(lower, "limits.acceleration_lower", "`acceleration_lower` needs `acceleration` beside it");
        };
        self.bounds(&BoundTable { key: "limits.acceleration", upper, lower, signs: BoundSigns::AroundZero }).map(Some)
    }

    /// Torque limits, the robot's own or given, with the dynamics they need.
    pub(crate) fn torque<const N: usize>(&self) -> Result<Option<TorqueLimits<N>>, LabError> {
        const KEY: &str = "limits.torque";
        let lower = self.table.torque_lower.as_ref();
        let upper = match &self.table.torque {
            None => return needless(lower, "limits.torque_lower", "`torque_lower` needs `torque` beside it"),
            Some(TorqueTable::Given(values)) => values.clone(),
            Some(TorqueTable::Own(OwnName::Robot)) => {
                let missing = Fault::Missing("the robot has no torque limits of its own for every joint");
                constants(self.robot.effort_limits().ok_or_else(|| LabError::value(KEY, missing))?)
            }
        };
        if !self.robot.has_masses() {
            let missing =
                Fault::Missing("the robot has no masses, so no torque; use one with dynamics or a URDF with inertias");
            return Err(LabError::value(KEY, missing));
        }
        let dynamics = self.robot.dynamics::<N>().map_err(|error| LabError::value(KEY, error))?;
        let table = BoundTable { key: KEY, upper: &upper, lower, signs: BoundSigns::Ordered };
        Ok(Some(TorqueLimits { dynamics: dynamics.with_effects(self.effects()), bounds: self.bounds(&table)? }))
    }

    pub(crate) fn tool(&self) -> Result<ToolLimits, LabError> {
        let read = |key: &str, value: Option<Number>| value.map(|v| positive(key, v)).transpose();
        Ok(ToolLimits {
            speed: read("limits.tool_speed", self.table.tool_speed)?,
            acceleration: read("limits.tool_acceleration", self.table.tool_acceleration)?,
        })
    }

    pub(crate) fn end_rate(&self, key: &str, value: Option<Number>) -> Result<EndRate, LabError> {
        match value {
            None => Ok(EndRate::ByLimits),
            Some(rate) if rate.0 >= 0.0 => Ok(EndRate::Given(rate.0)),
            Some(rate) => {
                Err(LabError::value(key, Fault::OutOfRange { value: rate.0, least: 0.0, most: f64::INFINITY }))
            }
        }
    }

    fn effects(&self) -> DriveEffects {
        let has = |name| self.table.drive_effects.contains(&name);
        DriveEffects { rotor_inertia: has(DriveEffectName::RotorInertia), friction: has(DriveEffectName::Friction) }
    }

    fn bounds<const N: usize>(&self, table: &BoundTable<'_>) -> Result<JointBounds<N>, LabError> {
        JointBounds::new(table, &self.path)
    }
}

fn constants(values: Vec<f64>) -> PerJointLimit {
    PerJointLimit::Each(values.into_iter().map(LimitNumber::Constant).collect())
}

/// A lower bound without its upper one means nothing.
fn needless<T>(lower: Option<&PerJointLimit>, key: &str, message: &'static str) -> Result<Option<T>, LabError> {
    match lower {
        Some(_) => Err(LabError::value(key, Fault::Conflict(message))),
        None => Ok(None),
    }
}
