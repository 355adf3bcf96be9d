//! One loop for every speed law: demand, decision, motion, trace, and what a run comes to.

pub(crate) mod acceleration;
pub(crate) mod controller;
pub(crate) mod course;
pub(crate) mod decision;
pub(crate) mod law;
pub(crate) mod limit_use;
pub(crate) mod metrics;
pub(crate) mod motion;
pub(crate) mod path_window;
pub(crate) mod simulate;
pub(crate) mod trace;
pub(crate) mod world;
