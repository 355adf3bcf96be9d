//! The scenario file as it is written: plain tables, no meaning checked beyond shape.

pub(crate) mod conditioning;
pub(crate) mod curves;
pub(crate) mod number;
pub(crate) mod path;
mod schema;
pub(crate) mod verify_options;

use number::{Number, PerJointLimit};
use path::PathTable;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use slideway_lab::Method;
use std::collections::BTreeMap;
use verify_options::SpeedVerifyTable;

/// A whole scenario file.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ScenarioFile {
    /// One sentence on what it is for.
    #[serde(default)]
    pub(crate) description: String,
    /// The arm.
    pub(crate) robot: RobotTable,
    /// Where the robot stands at t = 0; by default on the first point of the path.
    #[serde(default)]
    pub(crate) start: StartTable,
    /// The path, of the tool or of the joints.
    pub(crate) path: PathTable,
    /// What must be kept.
    pub(crate) limits: LimitsTable,
    /// The controller and the regulator.
    pub(crate) control: ControlTable,
    /// The methods that run at a fixed speed.
    #[serde(default)]
    pub(crate) fixed_speed: FixedSpeedTable,
    /// Constant speed and natural motion beside the other methods; the table may be empty.
    pub(crate) natural: Option<NaturalTable>,
    /// What happens in a run and the controller does not know of.
    #[serde(default)]
    pub(crate) disturbances: DisturbancesTable,
    /// Random trials around the scenario.
    #[serde(default)]
    pub(crate) verify: SpeedVerifyTable,
    /// The offline optimum.
    #[serde(default)]
    pub(crate) optimum: OptimumTable,
    /// The comparison and its verdict.
    #[serde(default)]
    pub(crate) compare: SpeedCompareTable,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct RobotTable {
    /// A built-in arm.
    pub(crate) model: Option<ModelName>,
    /// A standard Denavit-Hartenberg table, one row per revolute joint, 1 to 7 of them.
    pub(crate) dh: Option<Vec<DhTable>>,
    /// Path of a URDF file, relative to the scenario file.
    pub(crate) urdf: Option<String>,
    /// Base link in the URDF file (default: its root).
    pub(crate) base: Option<String>,
    /// Tip link in the URDF file (default: as far out as a single arm leads).
    pub(crate) tip: Option<String>,
    /// Joints held still, by name, rad (m).
    #[serde(default)]
    pub(crate) locked: BTreeMap<String, Number>,
    /// What a path of the tool prescribes (default: pose).
    #[serde(default)]
    pub(crate) task: TaskName,
    /// From tool speeds to joint speeds.
    pub(crate) inverse: Option<InverseTable>,
}

/// Built-in arms, named as on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
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

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct DhTable {
    /// Length, m.
    pub(crate) a: Number,
    /// Twist, rad.
    pub(crate) alpha: Number,
    /// Offset along the axis, m.
    pub(crate) d: Number,
    /// Added to the joint position, rad.
    #[serde(default)]
    pub(crate) offset: Number,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum TaskName {
    #[default]
    Pose,
    Position,
    PlanarPosition,
    PlanarPose,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub(crate) enum InverseTable {
    Adjugate { epsilon: Number },
    DampedLeastSquares { damping: Number },
    TruncatedSvd { cutoff: Number },
}

#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct StartTable {
    /// Joint positions, rad (m), one per joint.
    #[serde(default, deserialize_with = "number::list")]
    #[schemars(with = "Option<Vec<Number>>")]
    pub(crate) q: Option<Vec<Number>>,
    /// Tool pose: x, y, z in m, alpha, beta, gamma in rad, orientation Rz(alpha) Ry(beta) Rx(gamma).
    pub(crate) pose: Option<[Number; 6]>,
    /// Solution of the inverse kinematics, for arms with a PUMA-like geometry.
    pub(crate) branch: Option<BranchTable>,
    /// Joint positions close to the wanted solution, for any arm.
    #[serde(default, deserialize_with = "number::list")]
    #[schemars(with = "Option<Vec<Number>>")]
    pub(crate) near: Option<Vec<Number>>,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct BranchTable {
    /// Side of the shoulder.
    pub(crate) shoulder: ShoulderName,
    /// Elbow above or below.
    pub(crate) elbow: ElbowName,
    /// Wrist turned over or not.
    pub(crate) wrist: WristName,
}

#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum ShoulderName {
    Right,
    Left,
}

#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum ElbowName {
    Up,
    Down,
}

#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum WristName {
    NoFlip,
    Flip,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct LimitsTable {
    /// Joint-speed limits, rad/s (m/s); may be left out where the robot has its own.
    pub(crate) speed: Option<PerJointLimit>,
    /// Lower joint-speed limits, negative (default: the mirror image of `speed`).
    pub(crate) speed_lower: Option<PerJointLimit>,
    /// Joint-acceleration limits, rad/s² (m/s²).
    pub(crate) acceleration: Option<PerJointLimit>,
    /// Lower joint-acceleration limits, negative (default: the mirror image).
    pub(crate) acceleration_lower: Option<PerJointLimit>,
    /// Torque limits of the drives, N·m (N), or "robot" for those of the robot.
    pub(crate) torque: Option<TorqueTable>,
    /// Lower torque limits, negative (default: the mirror image).
    pub(crate) torque_lower: Option<PerJointLimit>,
    /// Parts of the drives that count in torques.
    #[serde(default)]
    pub(crate) drive_effects: Vec<DriveEffectName>,
    /// Ranges [lower, upper] of the joints, rad (m): a path that leaves them fails.
    pub(crate) position: Option<Vec<[Number; 2]>>,
    /// Greatest speed of the tool's point, m/s.
    pub(crate) tool_speed: Option<Number>,
    /// Greatest acceleration of the tool's point, m/s².
    pub(crate) tool_acceleration: Option<Number>,
    /// Rate of lambda at the start of the path, 1/s.
    pub(crate) start_rate: Option<Number>,
    /// Rate of lambda at its end, 1/s.
    pub(crate) end_rate: Option<Number>,
}

/// Torque limits: the robot's own, or as given.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(
    untagged,
    expecting = "\"robot\", a finite number, a formula of `lambda` in quotes, or a list with one per joint"
)]
pub(crate) enum TorqueTable {
    Own(OwnName),
    Given(PerJointLimit),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum OwnName {
    Robot,
}

/// What a robot's drives add to its rigid body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum DriveEffectName {
    RotorInertia,
    Friction,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ControlTable {
    /// Gain of the position error, 1/s.
    pub(crate) gain: Number,
    /// Sampling period, s.
    pub(crate) sampling_period: Number,
    /// Bandwidth of the regulator's filter, rad/s: bandwidth * sampling_period <= 1.
    pub(crate) bandwidth: Number,
    /// Target rate of lambda, 1/s: faster than the joints can go.
    pub(crate) target_rate: Number,
    /// When to give up, s (default: ten times the shortest possible time, plus 30).
    pub(crate) max_duration: Option<Number>,
    /// What the look-ahead sees, where accelerations are limited.
    #[serde(default)]
    pub(crate) look_ahead: LookAheadTable,
}

#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct LookAheadTable {
    /// Distance in lambda (default: a quarter of the path).
    pub(crate) distance: Option<Number>,
    /// Intervals (default: 64).
    pub(crate) nodes: Option<u32>,
    /// Share of the limits in reserve (default: 0.05).
    pub(crate) margin: Option<Number>,
}

#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct FixedSpeedTable {
    /// Rate of lambda, 1/s (default: the one that takes as long as the optimum).
    pub(crate) rate: Option<Number>,
    /// Sampling period, s (default: that of [control]).
    pub(crate) sampling_period: Option<Number>,
    /// Integration of the joint positions (default: euler).
    #[serde(default)]
    pub(crate) integration: IntegrationName,
}

#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum IntegrationName {
    #[default]
    Euler,
    Rk4,
}

/// What happens in a run and the controller does not know of.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct DisturbancesTable {
    /// Seed of noise and jitter.
    pub(crate) seed: Option<u64>,
    /// Added to the configuration at the start, rad (m), one per joint.
    #[serde(default, deserialize_with = "number::list")]
    #[schemars(with = "Option<Vec<Number>>")]
    pub(crate) initial_error: Option<Vec<Number>>,
    /// Noise of measured joint positions, rad (m), uniform up to this.
    pub(crate) joint_noise: Option<Number>,
    /// Error of the joints' zeros, rad (m), one per joint.
    #[serde(default, deserialize_with = "number::list")]
    #[schemars(with = "Option<Vec<Number>>")]
    pub(crate) joint_offset: Option<Vec<Number>>,
    /// Error of the drives, one per joint: joint i moves at 1 + e_i times the commanded speed.
    #[serde(default, deserialize_with = "number::list")]
    #[schemars(with = "Option<Vec<Number>>")]
    pub(crate) speed_error: Option<Vec<Number>>,
    /// Samples by which measurements are late.
    pub(crate) delay: Option<u32>,
    /// A period lasts sampling_period * (1 +- jitter), uniform.
    pub(crate) jitter: Option<Number>,
}

/// Constant speed and natural motion beside the other methods.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct NaturalTable {
    /// What natural motion's speed is in proportion to (default: determinant).
    #[serde(default)]
    pub(crate) factor: FactorName,
    /// Part of the speed limits that both methods use (default: 1).
    pub(crate) share: Option<Number>,
    /// Length of the fifth-order start and stop, s (default: 0).
    pub(crate) rise: Option<Number>,
}

/// What natural motion's speed is proportional to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum FactorName {
    /// The determinant of the Jacobian.
    #[default]
    Determinant,
    /// The determinant without the part of a spherical wrist.
    Arm,
}

#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct OptimumTable {
    /// Intervals of the grid on which the optimum is solved and certified.
    pub(crate) grid_points: Option<u32>,
    pub(crate) gap: Option<Number>,
    pub(crate) cells: Option<u32>,
    #[serde(default)]
    pub(crate) solver: SolverName,
}

/// A solver of the optimum.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SolverName {
    /// The project's own interior points on the structure of the problem.
    #[default]
    Structured,
    /// The conic solver Clarabel.
    Conic,
}

#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SpeedCompareTable {
    /// The method that the verdict is about.
    #[schemars(with = "Option<schema::MethodName>")]
    pub(crate) method: Option<Method>,
    /// By how much it may miss the optimum for the verdict to hold, as a fraction.
    pub(crate) tolerance: Option<Number>,
    /// The verdict that `slideway compare --all` expects of a built-in scenario.
    #[serde(default)]
    pub(crate) expect: Expectation,
}

#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct CompareTable {
    /// By how much the mean deviation may exceed the projection's for the verdict to hold, as a fraction (default: no limit).
    pub(crate) tolerance: Option<Number>,
    /// The verdict that `slideway compare --all` expects of a built-in scenario.
    #[serde(default)]
    pub(crate) expect: Expectation,
}

/// The verdict that a scenario is expected to get: some are there to show where a law falls short.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Expectation {
    /// The verdict holds.
    #[default]
    Holds,
    /// It does not.
    Fails,
}
