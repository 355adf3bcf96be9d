use crate::{Report, StudyError, interrupts, welding_cell};

/// A study.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Study {
    /// The four ways to interrupt a motion.
    Interrupts,
    /// A seam between two Go-Tos, under two speed laws, braked half-way.
    WeldingCell,
}

impl Study {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Interrupts, Self::WeldingCell];

    /// The name by which it is called.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Interrupts => "interrupts",
            Self::WeldingCell => "welding-cell",
        }
    }

    /// What it is about, in one line.
    #[must_use]
    pub fn summary(self) -> &'static str {
        match self {
            Self::Interrupts => {
                "a path broken off in four ways: at a way-point, on the path, at full brake, for a new target"
            }
            Self::WeldingCell => {
                "Go-To, seam under sliding mode and under natural motion beside the certified optimum, brake on it, recover"
            }
        }
    }

    /// The study of a name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|study| study.name() == name)
    }
}

/// Runs a study. `seed` is that of its noise, in studies that have any.
///
/// # Errors
///
/// A motion that was refused or that does not end.
pub fn run(study: Study, _seed: u64) -> Result<Report, StudyError> {
    match study {
        Study::Interrupts => interrupts::run(),
        Study::WeldingCell => welding_cell::run(),
    }
}
