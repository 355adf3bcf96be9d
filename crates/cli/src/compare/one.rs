use crate::compare::compared::{CompareOptions, Compared};
use crate::compare::{conditioning, speed};
use crate::say::diagnostic::CliError;
use slideway_scenario::AnyScenario;
use std::path::Path;

/// Compares on one scenario of either kind, and writes traces, figures, summary and report into a folder.
pub(crate) fn compare(
    loaded: &AnyScenario,
    name: &str,
    options: &CompareOptions,
    out: &Path,
) -> Result<Compared, CliError> {
    match loaded {
        AnyScenario::Speed(scenario) => speed::run(name, options, scenario, out),
        AnyScenario::Conditioning(scenario) => conditioning::run(name, options, scenario, out),
    }
}
