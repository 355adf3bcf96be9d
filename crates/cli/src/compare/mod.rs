//! Every method on a scenario, beside the offline optimum.

pub(crate) mod compared;
mod conditioning;
mod conditioning_views;
mod effort_table;
mod gallery;
mod law_figures;
pub(crate) mod one;
mod speed;
mod speed_page;
mod speed_table;
mod speed_text;

use crate::args::{CompareArguments, SolverArgument};
use crate::say::diagnostic::CliError;
use crate::say::loaded::load;
use crate::say::output::{Answer, Outcome, show};
use compared::CompareOptions;
use one::compare;
use slideway_baselines::time_optimal::Solver;
use slideway_compare::{check_refinement, check_shares};
use std::path::Path;

pub(crate) fn run(arguments: &CompareArguments) -> Result<Outcome, CliError> {
    let CompareArguments { tolerance, inter_sample, gap, cells, .. } = *arguments;
    check_shares(tolerance, inter_sample)?;
    check_refinement(gap, cells)?;
    let solver = arguments.solver.map(|solver| match solver {
        SolverArgument::Structured => Solver::Structured,
        SolverArgument::Conic => Solver::Conic,
    });
    let options = CompareOptions { tolerance, inter_sample, gap, cells, solver };
    let Some(name) = arguments.scenario.as_deref() else {
        let out = arguments.out.clone().unwrap_or_else(|| "out".into());
        return gallery::run(&options, &out, arguments.json);
    };
    let loaded = load(name)?;
    let out = arguments.out.clone().unwrap_or_else(|| Path::new("out").join(loaded.name()));
    let compared = compare(&loaded, name, &options, &out)?;
    let answer = Answer { table: &compared.table, verdict: &compared.sentence };
    show(arguments.json, &compared.summary, &answer, &out)?;
    Ok(if compared.holds { Outcome::Holds } else { Outcome::Fails })
}
