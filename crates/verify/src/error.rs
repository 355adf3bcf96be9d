use slideway_lab::LabError;

/// Why a scenario cannot be verified.
#[derive(Debug, thiserror::Error)]
pub enum VerifyError {
    /// The scenario cannot be used.
    #[error(transparent)]
    Scenario(#[from] LabError),
    /// A trial beyond the campaign's last.
    #[error("there is no trial {number}: the campaign has {trials}")]
    NoTrial {
        /// What was asked for.
        number: u64,
        /// How many there are, counted from 0.
        trials: u64,
    },
}
