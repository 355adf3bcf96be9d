//! Natural motion `[N]`: a path followed at a speed in proportion to the determinant of the Jacobian, beside constant speed.
//!
//! [`NaturalProblem`] is an arm, an inversion, a path and a start, with or without masses. From there
//!
//! - [`NaturalProblem::survey`] goes along the path once and says what any `b` costs: time, joint speed, torque; so `b` is
//!   found from a peak;
//! - [`NaturalProblem::follow`] runs a [`SpeedLaw`] with the arm exactly on the path;
//! - [`NaturalProblem::control`] runs it in closed loop, under resolved acceleration or an inverse-Jacobian controller.
//!
//! [`NaturalProblem::of`] takes arm and path of a problem. [`table_1`] and [`table_2`] repeat the paper's tables.

mod comparison;
mod control;
mod follow;
mod integrate;
mod law;
mod metrics;
mod model_error;
mod path;
mod problem;
mod survey;
mod table_1;
mod table_2;

pub(crate) use comparison::NaturalLaws;
pub use control::{ControlRun, Controller, TrackingError};
pub use follow::{NaturalSample, NaturalTrace, Run};
pub use law::{Ramp, RampValue, SpeedLaw};
pub use metrics::NaturalMetrics;
pub(crate) use model_error::WrongModel;
pub use model_error::{ModelErrorRun, ModelErrorSample};
pub use path::{Circle, ParametrisedPath, PathState};
pub use problem::{NaturalProblem, PathPlace};
pub use survey::{Survey, SurveyPoint};
pub use table_1::{TABLE_1_INTERVAL, limb_case, limb_problem, table_1};
pub use table_2::{pa10_problem, table_2};
