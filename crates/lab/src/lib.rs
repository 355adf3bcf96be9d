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
mod controller;
mod dynamic_limits;
mod error;
mod experiment;
mod formula;
mod joint_bounds;
mod joint_curve;
mod joint_path;
mod law;
mod limit_reader;
mod limit_use;
mod limits;
mod metrics;
pub mod natural;
mod path;
mod placement;
mod problem;
mod reference;
mod robot;
mod sampled;
mod scenario;
mod simulate;
pub mod sweep;
mod trace;
mod tracing;

pub use controller::Demand;
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
pub use path::{CartesianPath, EulerPoint, PathPoint};
pub use problem::{ControlSettings, FixedSpeed, Integration, Problem};
pub use reference::{Reference, ToolReference};
pub use robot::MAX_JOINTS;
pub use sampled::{PathSample, SampledPath, SampledPiece};
pub use scenario::{BUILT_IN, BuiltIn, CONDITIONING_TEMPLATE, Scenario, ScenarioKind, TEMPLATE, locate, scenario_kind};
pub use trace::{Chatter, Sample, Trace};
