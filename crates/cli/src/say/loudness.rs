//! How much the command says, chosen once for the whole process.

use std::sync::OnceLock;

/// How much the command says.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Loudness {
    /// Only what failed and the verdict.
    Quiet,
    /// Progress, tables, the verdict and where the report is.
    #[default]
    Normal,
    /// The same, and on the error stream stages with their times and files written, in place of progress bars.
    Verbose,
}

static CHOSEN: OnceLock<Loudness> = OnceLock::new();

impl Loudness {
    /// Chooses for the whole process; the first choice stays.
    pub(crate) fn choose(self) {
        let _ = CHOSEN.set(self);
    }

    /// What was chosen.
    pub(crate) fn chosen() -> Self {
        CHOSEN.get().copied().unwrap_or_default()
    }
}
