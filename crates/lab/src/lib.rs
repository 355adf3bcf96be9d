//! From a problem to traces and metrics: one problem, one loop, every speed law; path conditioning and natural motion beside it.
//!
//! A problem is a path with its limits and a controller; no file is needed:
//!
//! ```
//! use slideway_conditioner::SpeedLimits;
//! use slideway_lab::{ControlSettings, Experiment, LookAheadOptions, Method, Problem};
//! use slideway_path::{JointCurve, PathProblem, Reference};
//! use slideway_robot::models::Model;
//!
//! let (from, to) = ([0.0, 0.5].into(), [1.0, 0.9].into());
//! let reference = Reference::Joint(JointCurve::line(from, to, 0.0..1.0));
//! let arm = Model::Planar2R.describe()?.arm()?;
//! let path = PathProblem::new(arm, reference, from, SpeedLimits::new([-1.0, -1.0], [1.0, 1.0])?);
//! let control = ControlSettings {
//!     gain: 10.0,
//!     sampling_period: 1e-3,
//!     bandwidth: 20.0,
//!     target_rate: 2.0,
//!     max_duration: None,
//!     look_ahead: LookAheadOptions::default(),
//! };
//! let experiment = Experiment::try_from(Problem::new(path, control))?;
//! let trace = experiment.run(Method::SlidingModeImplicit)?;
//! assert!(trace.finish_s.is_some());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod conditioning;
mod disturbances;
mod experiment;
mod joints;
mod method;
pub mod natural;
mod parallel;
mod problem;
mod published;
mod run;

pub use disturbances::{Disturbances, MOST_DELAY, MOST_JITTER, MOST_NOISE, MOST_SPEED_ERROR};
pub use experiment::Experiment;
pub use joints::{JointUnits, MAX_JOINTS};
pub use method::Method;
pub use parallel::{ThreadsError, in_parallel};
pub use problem::{ControlSettings, FixedSpeed, Integration, LookAheadOptions, NaturalSettings, Problem};
pub use published::{Agreement, Published};
pub use run::controller::Demand;
pub use run::course::{Course, CourseSample, Effort, ProfilePoint};
pub use run::limit_use::{JointMotion, LimitUse, MotionInstant};
pub use run::metrics::{ARRIVAL_ORIENTATION, ARRIVAL_POSITION, Chattering, MethodSummary};
pub use run::simulate::MAX_SAMPLES;
pub use run::trace::{Chatter, Sample, Trace};
