//! From a scenario file to traces and metrics: one problem, one loop, every speed law.
//!
//! ```
//! use slideway_lab::{Experiment, Method, Scenario};
//!
//! let scenario = Scenario::built_in("puma-helix-on-path").expect("built in")?;
//! let experiment = Experiment::new(&scenario)?;
//! let trace = experiment.run(Method::SlidingModeImplicit)?;
//! assert!(trace.finish_s.is_some());
//! # Ok::<(), slideway_lab::LabError>(())
//! ```

pub mod conditioning;
pub mod curve;
mod error;
mod experiment;
mod formula;
mod jet;
mod joint_path;
mod limits;
pub mod natural;
mod parallel;
mod path;
mod powers;
mod problem;
mod published;
mod robot;
mod run;
mod scenario;
pub mod sweep;
mod traced;

pub use error::{Fault, LabError, ListOf};
pub use experiment::Experiment;
pub use formula::{FormulaError, constant};
pub use joint_path::sampled::{PathSample, SampledPath, SampledPiece};
pub use joint_path::{JointPath, JointPoint, Piece, PieceKind};
pub use limits::dynamic_limits::{ToolLimits, TorqueLimits};
pub use limits::joint_bounds::{JointBounds, JointRange};
pub use limits::limit_use::LimitUse;
pub use limits::position_limits::{PositionExcess, PositionLimits, PositionSource};
pub use limits::{EndRate, LimitKind, LinearLimit, SpeedLimit};
pub use parallel::{ThreadsError, in_parallel};
pub use path::joint_curve::JointCurve;
pub use path::reference::{Reference, ToolReference};
pub use path::{CartesianPath, EulerPoint, PathPoint};
pub use problem::{ControlSettings, FixedSpeed, Integration, LookAheadOptions, Problem};
pub use published::{Agreement, Published};
pub use robot::{MAX_JOINTS, robot_in};
pub use run::controller::Demand;
pub use run::course::{Course, CourseSample, Effort, ProfilePoint};
pub use run::disturbances::Disturbances;
pub use run::joint_units::JointUnits;
pub use run::law::Method;
pub use run::metrics::{ARRIVAL_ORIENTATION, ARRIVAL_POSITION, Chattering, MethodSummary};
pub use run::simulate::MAX_SAMPLES;
pub use run::trace::{Chatter, Sample, Trace};
pub use scenario::verify_options::VerifyOptions;
pub use scenario::{
    BUILT_IN, BuiltIn, CONDITIONING_TEMPLATE, Expectation, Scenario, ScenarioKind, TEMPLATE, locate, scenario_kind,
};
