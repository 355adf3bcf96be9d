#![doc = include_str!("../README.md")]

pub mod outward;
pub mod path_bracket;
pub mod potential_field;
pub mod projection;
pub mod safety_filter;
pub mod time_optimal;
