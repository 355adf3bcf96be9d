//! Journals of long commands, the files that scenarios name, and work on all cores.

pub(crate) mod files;
pub(crate) mod journal;
pub(crate) mod parallel;
