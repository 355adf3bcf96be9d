use crate::args::CompareArguments;
use crate::compare_path::compare_conditioning;
use crate::compare_speed::compare_speed;
use crate::compared::{CompareOptions, Compared};
use crate::diagnostic::CliError;
use crate::gallery;
use crate::loaded::{Loaded, load};
use crate::output::{Outcome, show};
use std::path::Path;

pub(crate) fn run(arguments: &CompareArguments) -> Result<Outcome, CliError> {
    if let Some(value) = arguments.tolerance.filter(|t| !(*t >= 0.0 && t.is_finite())) {
        let remedy = "give a fraction of the optimum, for example 0.02";
        return Err(CliError::Option { option: "tolerance", value, remedy });
    }
    if let Some(value) = arguments.inter_sample.filter(|t| !(*t > 0.0 && t.is_finite())) {
        let remedy = "give a share of the limits, for example 1e-6";
        return Err(CliError::Option { option: "inter-sample", value, remedy });
    }
    let options = CompareOptions { tolerance: arguments.tolerance, inter_sample: arguments.inter_sample };
    let Some(name) = arguments.scenario.as_deref() else {
        let out = arguments.out.clone().unwrap_or_else(|| "out".into());
        return gallery::run(&options, &out, arguments.json, compare);
    };
    let loaded = load(name)?;
    let out = arguments.out.clone().unwrap_or_else(|| Path::new("out").join(loaded.name()));
    let compared = compare(&loaded, name, &options, &out)?;
    show(arguments.json, &compared.summary, &compared.table, &out)?;
    Ok(if compared.holds { Outcome::Holds } else { Outcome::Fails })
}

/// Runs every method on a scenario and writes traces, figures, summary and report.
pub(crate) fn compare(loaded: &Loaded, name: &str, options: &CompareOptions, out: &Path) -> Result<Compared, CliError> {
    match loaded {
        Loaded::Speed(scenario) => compare_speed(name, options, scenario, out).map_err(|error| error.in_file(name)),
        Loaded::Conditioning(scenario) => compare_conditioning(name, options, scenario, out),
    }
}
