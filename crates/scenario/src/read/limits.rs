use crate::read::bounds::BoundTable;
use crate::tables::number::{LimitNumber, Number, PerJointLimit, positive};
use crate::tables::{DriveEffectName, LimitsTable, OwnName, TorqueTable};
use slideway_conditioner::SpeedLimits;
use slideway_path::{
    BoundSigns, EndRate, Fault, JointBounds, ListOf, PositionLimits, PositionSource, ProblemError, ToolLimits,
    TorqueLimits,
};
use slideway_robot::{DriveEffects, PositionRange, RobotDescription};
use std::ops::Range;

/// Reads a scenario's limits for a robot and a range of the path parameter.
pub(crate) struct LimitReader<'a> {
    pub(crate) table: &'a LimitsTable,
    pub(crate) robot: &'a RobotDescription,
    pub(crate) path: Range<f64>,
}

impl LimitReader<'_> {
    /// The scenario's speed limits, else those of the robot.
    pub(crate) fn speed<const N: usize>(&self) -> Result<JointBounds<N>, ProblemError> {
        let robots = || self.robot.velocity_limits().map(constants);
        let missing = Fault::Missing("the robot has no speed limits of its own for every joint");
        let upper = self.table.speed.clone().or_else(robots);
        let upper = upper.ok_or_else(|| ProblemError::value("limits.speed", missing))?;
        let lower = self.table.speed_lower.as_ref();
        self.bounds(&BoundTable { key: "limits.speed", upper: &upper, lower, signs: BoundSigns::AroundZero })
    }

    /// The widest that speed limits get along the path.
    pub(crate) fn widest_speed<const N: usize>(&self, speed: &JointBounds<N>) -> Result<SpeedLimits<N>, ProblemError> {
        let widest = speed.widest(&self.path);
        SpeedLimits::new(widest.lower, widest.upper).map_err(|error| ProblemError::value("limits.speed", error))
    }

    pub(crate) fn acceleration<const N: usize>(&self) -> Result<Option<JointBounds<N>>, ProblemError> {
        let lower = self.table.acceleration_lower.as_ref();
        let Some(upper) = &self.table.acceleration else {
            return needless(lower, "limits.acceleration_lower", "`acceleration_lower` needs `acceleration` beside it");
        };
        self.bounds(&BoundTable { key: "limits.acceleration", upper, lower, signs: BoundSigns::AroundZero }).map(Some)
    }

    /// Torque limits, the robot's own or given, with the dynamics they need.
    pub(crate) fn torque<const N: usize>(&self) -> Result<Option<TorqueLimits<N>>, ProblemError> {
        const KEY: &str = "limits.torque";
        let lower = self.table.torque_lower.as_ref();
        let upper = match &self.table.torque {
            None => return needless(lower, "limits.torque_lower", "`torque_lower` needs `torque` beside it"),
            Some(TorqueTable::Given(values)) => values.clone(),
            Some(TorqueTable::Own(OwnName::Robot)) => {
                let missing = Fault::Missing("the robot has no torque limits of its own for every joint");
                constants(self.robot.effort_limits().ok_or_else(|| ProblemError::value(KEY, missing))?)
            }
        };
        if !self.robot.has_masses() {
            let missing =
                Fault::Missing("the robot has no masses, so no torque; use one with dynamics or a URDF with inertias");
            return Err(ProblemError::value(KEY, missing));
        }
        let dynamics = self.robot.dynamics::<N>().map_err(|error| ProblemError::value(KEY, error))?;
        let table = BoundTable { key: KEY, upper: &upper, lower, signs: BoundSigns::Ordered };
        Ok(Some(TorqueLimits { dynamics: dynamics.with_effects(self.effects()), bounds: self.bounds(&table)? }))
    }

    pub(crate) fn tool(&self) -> Result<ToolLimits, ProblemError> {
        let read = |key: &str, value: Option<Number>| value.map(|v| positive(key, v)).transpose();
        Ok(ToolLimits {
            speed: read("limits.tool_speed", self.table.tool_speed)?,
            acceleration: read("limits.tool_acceleration", self.table.tool_acceleration)?,
        })
    }

    pub(crate) fn end_rate(&self, key: &str, value: Option<Number>) -> Result<EndRate, ProblemError> {
        match value {
            None => Ok(EndRate::ByLimits),
            Some(rate) if rate.0 >= 0.0 => Ok(EndRate::Given(rate.0)),
            Some(rate) => {
                Err(ProblemError::value(key, Fault::OutOfRange { value: rate.0, least: 0.0, most: f64::INFINITY }))
            }
        }
    }

    /// The scenario's ranges of the joints, else the robot's own.
    pub(crate) fn position<const N: usize>(&self) -> Result<PositionLimits<N>, ProblemError> {
        const KEY: &str = "limits.position";
        let Some(given) = &self.table.position else {
            let ranges = std::array::from_fn(|i| self.robot.joints.get(i).and_then(|j| j.limits.position));
            return Ok(PositionLimits { ranges, source: PositionSource::Robot });
        };
        if given.len() != N {
            let fault = Fault::WrongLength { found: given.len(), expected: N, list: ListOf::JointRanges };
            return Err(ProblemError::value(KEY, fault));
        }
        for (joint, [lower, upper]) in given.iter().enumerate() {
            if !(lower.0 < upper.0) {
                let fault = Fault::NotIncreasing { before: lower.0, after: upper.0 };
                return Err(ProblemError::value(format!("{KEY}.{joint}"), fault));
            }
        }
        let range = |i: usize| Some(PositionRange { lower: given[i][0].0, upper: given[i][1].0 });
        Ok(PositionLimits { ranges: std::array::from_fn(range), source: PositionSource::Scenario })
    }

    fn effects(&self) -> DriveEffects {
        let has = |name| self.table.drive_effects.contains(&name);
        DriveEffects { rotor_inertia: has(DriveEffectName::RotorInertia), friction: has(DriveEffectName::Friction) }
    }

    fn bounds<const N: usize>(&self, table: &BoundTable<'_>) -> Result<JointBounds<N>, ProblemError> {
        table.read(&self.path)
    }
}

fn constants(values: Vec<f64>) -> PerJointLimit {
    PerJointLimit::Each(values.into_iter().map(LimitNumber::Constant).collect())
}

/// A lower bound without its upper one means nothing.
fn needless<T>(lower: Option<&PerJointLimit>, key: &str, message: &'static str) -> Result<Option<T>, ProblemError> {
    match lower {
        Some(_) => Err(ProblemError::value(key, Fault::Conflict(message))),
        None => Ok(None),
    }
}
