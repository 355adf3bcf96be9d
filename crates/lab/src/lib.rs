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

mod acceleration;
pub mod conditioning;
mod controller;
mod course;
pub mod curve;
mod disturbances;
mod dynamic_limits;
mod error;
mod experiment;
mod formula;
mod jet;
mod joint_bounds;
mod joint_curve;
mod joint_path;
mod law;
mod limit_reader;
mod limit_use;
mod limits;
mod metrics;
mod motion;
pub mod natural;
mod orientation;
mod parallel;
mod path;
mod path_window;
mod placement;
mod poses;
mod position;
mod position_limits;
mod problem;
mod published;
mod reference;
mod robot;
mod sampled;
mod scenario;
mod simulate;
pub mod sweep;
mod trace;
mod tracing;
mod verify_options;
mod waypoint_reader;

pub use controller::Demand;
pub use course::{Course, CourseSample, Effort, ProfilePoint};
pub use disturbances::Disturbances;
pub use dynamic_limits::{ToolLimits, TorqueLimits};
pub use error::{Fault, LabError};
pub use experiment::Experiment;
pub use formula::{FormulaError, constant};
pub use joint_bounds::{JointBounds, JointRange};
pub use joint_curve::JointCurve;
pub use joint_path::{JointPath, JointPoint, Piece, PieceKind};
pub use law::Method;
pub use limit_use::LimitUse;
pub use limits::{EndRate, LimitKind, LinearLimit, SpeedLimit};
pub use metrics::{ARRIVAL_ORIENTATION, ARRIVAL_POSITION, Chattering, MethodSummary};
pub use parallel::{ThreadsError, in_parallel};
pub use path::{CartesianPath, EulerPoint, PathPoint};
pub use position_limits::{PositionExcess, PositionLimits, PositionSource};
pub use problem::{ControlSettings, FixedSpeed, Integration, LookAheadOptions, Problem};
pub use published::{Agreement, Published};
pub use reference::{Reference, ToolReference};
pub use robot::{MAX_JOINTS, robot_in};
pub use sampled::{PathSample, SampledPath, SampledPiece};
pub use scenario::{
    BUILT_IN, BuiltIn, CONDITIONING_TEMPLATE, Expectation, Scenario, ScenarioKind, TEMPLATE, locate, scenario_kind,
};
pub use trace::{Chatter, Sample, Trace};
pub use verify_options::VerifyOptions;
