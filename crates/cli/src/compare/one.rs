use crate::compare::compared::{CompareOptions, Compared};
use crate::compare::{conditioning, speed};
use crate::say::diagnostic::CliError;
use crate::say::loaded::Loaded;
use std::path::Path;

/// Compares on one scenario of either kind, and writes traces, figures, summary and report into a folder.
pub(crate) fn compare(loaded: &Loaded, name: &str, options: &CompareOptions, out: &Path) -> Result<Compared, CliError> {
    match loaded {
        Loaded::Speed(scenario) => speed::run(name, options, scenario, out),
        Loaded::Conditioning(scenario) => conditioning::run(name, options, scenario, out),
    }
}
