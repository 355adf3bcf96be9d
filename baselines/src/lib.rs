//! Offline optima and rival methods, each solution re-checked by a certificate that does not trust the solver.

pub mod outward;
pub mod potential_field;
pub mod projection;
pub mod rivals;
pub mod safety_filter;
pub mod time_optimal;
