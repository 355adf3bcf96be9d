//! The scenario file as it is written: plain tables, no meaning checked beyond shape.

pub(crate) mod conditioning;
pub(crate) mod curves;
pub(crate) mod number;
pub(crate) mod path;
pub(crate) mod verify_options;

use number::{Number, PerJointLimit};
use path::PathTable;
use serde::{Deserialize, Serialize};
use slideway_lab::Method;
use std::collections::BTreeMap;
use verify_options::SpeedVerifyTable;

/// A whole scenario file.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ScenarioFile {
    #[serde(default)]
    pub(crate) description: String,
    pub(crate) robot: RobotTable,
    #[serde(default)]
    pub(crate) start: StartTable,
    pub(crate) path: PathTable,
    pub(crate) limits: LimitsTable,
    pub(crate) control: ControlTable,
    #[serde(default)]
    pub(crate) fixed_speed: FixedSpeedTable,
    pub(crate) natural: Option<NaturalTable>,
    #[serde(default)]
    pub(crate) disturbances: DisturbancesTable,
    #[serde(default)]
    pub(crate) verify: SpeedVerifyTable,
    #[serde(default)]
    pub(crate) optimum: OptimumTable,
    #[serde(default)]
    pub(crate) compare: SpeedCompareTable,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct RobotTable {
    pub(crate) model: Option<ModelName>,
    pub(crate) dh: Option<Vec<DhTable>>,
    pub(crate) urdf: Option<String>,
    pub(crate) base: Option<String>,
    pub(crate) tip: Option<String>,
    #[serde(default)]
    pub(crate) locked: BTreeMap<String, Number>,
    #[serde(default)]
    pub(crate) task: TaskName,
    pub(crate) inverse: Option<InverseTable>,
}

/// Built-in arms, named as on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum ModelName {
    Puma560,
    #[serde(rename = "planar-2r")]
    Planar2R,
    Pa10,
    Ur5e,
    Ur20,
    Panda,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct DhTable {
    pub(crate) a: Number,
    pub(crate) alpha: Number,
    pub(crate) d: Number,
    #[serde(default)]
    pub(crate) offset: Number,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum TaskName {
    #[default]
    Pose,
    Position,
    PlanarPosition,
    PlanarPose,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub(crate) enum InverseTable {
    Adjugate { epsilon: Number },
    DampedLeastSquares { damping: Number },
    TruncatedSvd { cutoff: Number },
}

#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct StartTable {
    #[serde(default, deserialize_with = "number::list")]
    pub(crate) q: Option<Vec<Number>>,
    pub(crate) pose: Option<[Number; 6]>,
    pub(crate) branch: Option<BranchTable>,
    #[serde(default, deserialize_with = "number::list")]
    pub(crate) near: Option<Vec<Number>>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct BranchTable {
    pub(crate) shoulder: ShoulderName,
    pub(crate) elbow: ElbowName,
    pub(crate) wrist: WristName,
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum ShoulderName {
    Right,
    Left,
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum ElbowName {
    Up,
    Down,
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum WristName {
    NoFlip,
    Flip,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct LimitsTable {
    pub(crate) speed: Option<PerJointLimit>,
    pub(crate) speed_lower: Option<PerJointLimit>,
    pub(crate) acceleration: Option<PerJointLimit>,
    pub(crate) acceleration_lower: Option<PerJointLimit>,
    pub(crate) torque: Option<TorqueTable>,
    pub(crate) torque_lower: Option<PerJointLimit>,
    #[serde(default)]
    pub(crate) drive_effects: Vec<DriveEffectName>,
    pub(crate) position: Option<Vec<[Number; 2]>>,
    pub(crate) tool_speed: Option<Number>,
    pub(crate) tool_acceleration: Option<Number>,
    pub(crate) start_rate: Option<Number>,
    pub(crate) end_rate: Option<Number>,
}

/// Torque limits: the robot's own, or as given.
#[derive(Clone, Debug, Deserialize)]
#[serde(
    untagged,
    expecting = "\"robot\", a finite number, a formula of `lambda` in quotes, or a list with one per joint"
)]
pub(crate) enum TorqueTable {
    Own(OwnName),
    Given(PerJointLimit),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum OwnName {
    Robot,
}

/// What a robot's drives add to its rigid body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum DriveEffectName {
    RotorInertia,
    Friction,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ControlTable {
    pub(crate) gain: Number,
    pub(crate) sampling_period: Number,
    pub(crate) bandwidth: Number,
    pub(crate) target_rate: Number,
    pub(crate) max_duration: Option<Number>,
    #[serde(default)]
    pub(crate) look_ahead: LookAheadTable,
}

#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct LookAheadTable {
    pub(crate) distance: Option<Number>,
    pub(crate) nodes: Option<u32>,
    pub(crate) margin: Option<Number>,
}

#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct FixedSpeedTable {
    pub(crate) rate: Option<Number>,
    pub(crate) sampling_period: Option<Number>,
    #[serde(default)]
    pub(crate) integration: IntegrationName,
}

#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum IntegrationName {
    #[default]
    Euler,
    Rk4,
}

/// What happens in a run and the controller does not know of.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct DisturbancesTable {
    pub(crate) seed: Option<u64>,
    #[serde(default, deserialize_with = "number::list")]
    pub(crate) initial_error: Option<Vec<Number>>,
    pub(crate) joint_noise: Option<Number>,
    #[serde(default, deserialize_with = "number::list")]
    pub(crate) joint_offset: Option<Vec<Number>>,
    #[serde(default, deserialize_with = "number::list")]
    pub(crate) speed_error: Option<Vec<Number>>,
    pub(crate) delay: Option<u32>,
    pub(crate) jitter: Option<Number>,
}

/// Constant speed and natural motion beside the other methods.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct NaturalTable {
    #[serde(default)]
    pub(crate) factor: FactorName,
    pub(crate) share: Option<Number>,
    pub(crate) rise: Option<Number>,
}

/// What natural motion's speed is proportional to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum FactorName {
    /// The determinant of the Jacobian.
    #[default]
    Determinant,
    /// The determinant without the part of a spherical wrist.
    Arm,
}

#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct OptimumTable {
    pub(crate) grid_points: Option<u32>,
    pub(crate) gap: Option<Number>,
    pub(crate) cells: Option<u32>,
    #[serde(default)]
    pub(crate) solver: SolverName,
}

/// A solver of the optimum.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SolverName {
    /// The project's own interior points on the structure of the problem.
    #[default]
    Structured,
    /// The conic solver Clarabel.
    Conic,
}

#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SpeedCompareTable {
    pub(crate) method: Option<Method>,
    pub(crate) tolerance: Option<Number>,
    #[serde(default)]
    pub(crate) expect: Expectation,
}

#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct CompareTable {
    pub(crate) tolerance: Option<Number>,
    #[serde(default)]
    pub(crate) expect: Expectation,
}

/// The verdict that a scenario is expected to get: some are there to show where a law falls short.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Expectation {
    /// The verdict holds.
    #[default]
    Holds,
    /// It does not.
    Fails,
}
