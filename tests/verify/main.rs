//! Campaigns of `slideway verify`: the same results for any number of jobs, interruptions and shards; violations told with a
//! scenario that shows them again; wrong input pointed out.
//!
//! Most journals here are written by the tests themselves: what the command makes of trials does not depend on who made them.

mod campaigns;
mod command;
mod made;
mod refusals;
mod results;
mod shards;
#[path = "../support/mod.rs"]
mod support;
