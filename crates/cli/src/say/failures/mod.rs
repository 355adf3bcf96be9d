//! Failures of the verbs, with their remedies.

pub(crate) mod difference;
pub(crate) mod journal;
pub(crate) mod sweep;
pub(crate) mod verify;
