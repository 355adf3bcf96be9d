//! Path conditioning: a reference that would leave the allowed set is bent along its boundary, `[G12]`.

pub mod bounds;
mod conditioner;
mod constraint;
mod correction;
mod evaluated;
mod filters;
mod law;
mod outcome;
mod quadratic;
mod quantity;
mod random;
mod safe_walk;
mod settings;
mod smallest_push;
mod state;
mod trap;
pub(crate) mod vector;
mod walk_direction;

pub use conditioner::PathConditioner;
pub use constraint::{Constraint, ConstraintSample, Motion, sample_all};
pub use correction::largest_step_count;
pub use outcome::{HoldReason, PathOutcome, PathStep, TrapPhase};
pub use quantity::PathQuantity;
pub use settings::{Margin, PathForm, PathSettings, Reserve, SwitchingLaw, TrapSettings, Walk};
pub use state::PathState;
