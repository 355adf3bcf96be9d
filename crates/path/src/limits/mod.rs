//! Limits: bounds a joint, ranges of position, drives and tool, and the rows that they are at one point of a path.

pub(crate) mod drive_and_tool;
pub(crate) mod joint_bounds;
pub(crate) mod position_limits;
pub(crate) mod rows;
