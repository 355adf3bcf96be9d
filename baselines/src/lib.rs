//! Offline optima and rival methods, each solution re-checked by a certificate that does not trust the solver.

pub mod outward;
pub mod path_bracket;
pub mod potential_field;
pub mod projection;
pub mod safety_filter;
pub mod time_optimal;
