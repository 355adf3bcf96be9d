//! A comparison of path conditioners, shown and written.

use crate::compare::compared::{CompareOptions, Compared, KeyFigures};
use crate::compare::conditioning_views;
use crate::say::diagnostic::CliError;
use crate::say::loaded::{compare_error, scenario_error};
use crate::say::output::{Watched, as_json, begin, create, write_summary, wrote_figures};
use slideway_compare::{ConditioningComparison, ConditioningOptions, Convergence, compare_conditioning};
use slideway_figures::{
    ConditioningStudy, ConvergencePoint, ConvergenceStudy, draw_conditioning_study, draw_convergence,
};
use slideway_lab::conditioning::ConditioningProblem;
use slideway_scenario::ConditioningScenario;
use std::path::Path;

/// Runs every method on a path-conditioning scenario and writes the results.
pub(crate) fn run(
    name: &str,
    options: &CompareOptions,
    scenario: &ConditioningScenario,
    out: &Path,
) -> Result<Compared, CliError> {
    let pointed = |error| scenario_error(error, name, Some(scenario.text().to_owned()));
    let problem = scenario.problem().map_err(pointed)?;
    let options = ConditioningOptions {
        name: scenario.name().to_owned(),
        description: scenario.description().to_owned(),
        tolerance: options.tolerance.or(scenario.tolerance()),
        ..ConditioningOptions::default()
    };
    let mut watched = Watched::new();
    let compared = compare_conditioning(&problem, &options, &mut |progress| watched.show(progress));
    let comparison = compared.map_err(|error| compare_error(error, name, scenario.text()))?;
    watched.writing();
    write(out, scenario, &problem, &comparison)?;
    watched.end();
    let summary = &comparison.summary;
    Ok(Compared {
        holds: summary.verdict.holds,
        sentence: summary.verdict.sentence.clone(),
        key: KeyFigures { ratio: summary.verdict.ratio, ..KeyFigures::default() },
        summary: as_json(summary)?,
        table: conditioning_views::table(summary),
    })
}

fn write(
    out: &Path,
    scenario: &ConditioningScenario,
    problem: &ConditioningProblem,
    comparison: &ConditioningComparison,
) -> Result<(), CliError> {
    let ConditioningComparison { summary, traces } = comparison;
    let figures_dir = begin(out)?;
    for trace in traces {
        create(out.join(format!("trace-{}.csv", trace.method)), |file| trace.write_csv(file))?;
    }
    let title = scenario.name();
    let study = ConditioningStudy { title, problem, traces, bands: &[] };
    let mut figures = draw_conditioning_study(&study, &figures_dir)?;
    let points: Vec<_> = summary.convergence.iter().map(point).collect();
    // On logarithmic axes a distance of zero has no place: nothing ever acted, and there is nothing to show.
    if points.len() >= 2 && points.iter().all(|p| p.mean_distance_m > 0.0) {
        figures.push(draw_convergence(&ConvergenceStudy { title, points: &points }, &figures_dir)?);
    }
    wrote_figures(&figures);
    let page = conditioning_views::render(summary, scenario.text(), &figures);
    create(out.join("report.html"), |file| file.write_all(page.as_bytes()))?;
    write_summary(out, summary)
}

fn point(at: &Convergence) -> ConvergencePoint {
    let Convergence { period_s, mean_distance_m, max_distance_m } = *at;
    ConvergencePoint { period_s, mean_distance_m, max_distance_m }
}
