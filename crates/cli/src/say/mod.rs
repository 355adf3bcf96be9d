//! Words, tables, pages and failures as the command shows them; knows no verb.

pub(crate) mod diagnostic;
pub(crate) mod failures;
pub(crate) mod loaded;
pub(crate) mod loudness;
pub(crate) mod output;
pub(crate) mod page;
pub(crate) mod snippet;
pub(crate) mod table;
pub(crate) mod words;
