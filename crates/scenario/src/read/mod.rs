//! From tables to the values that a run needs.

pub(crate) mod bounds;
pub(crate) mod conditioning;
pub(crate) mod curves;
pub(crate) mod limits;
pub(crate) mod number_table;
pub(crate) mod placement;
pub(crate) mod poses;
pub(crate) mod problem;
pub(crate) mod reference;
pub(crate) mod robot;
pub(crate) mod waypoints;
