#![doc = include_str!("../README.md")]

pub mod conditioning;
pub mod csv;
mod disturbances;
mod experiment;
mod joints;
mod method;
pub mod natural;
mod parallel;
mod problem;
mod published;
mod run;
mod subject;

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
pub use subject::Subject;
