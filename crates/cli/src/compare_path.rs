use crate::compared::{CompareOptions, Compared, KeyFigures};
use crate::convergence::{Convergence, convergence};
use crate::diagnostic::CliError;
use crate::loaded::scenario_error;
use crate::output::{as_json, create, progress, write_summary};
use crate::path_report;
use crate::path_summary::{PathSummary, PathVerdict, ProjectionEntry};
use slideway_baselines::rivals::{ProjectedTrace, potential_field_trace, projection_trace, qp_filter_trace};
use slideway_figures::{ConditioningStudy, ConvergenceStudy, draw_conditioning_study, draw_convergence};
use slideway_lab::conditioning::{
    ConditionedTrace, ConditioningProblem, PathMethod, PathMethodSummary, run_conditioner,
};
use slideway_scenario::ConditioningScenario;
use slideway_scenario::ScenarioError;
use std::path::Path;

/// Runs every method on a path-conditioning scenario.
pub(crate) fn compare_conditioning(
    name: &str,
    options: &CompareOptions,
    scenario: &ConditioningScenario,
    out: &Path,
) -> Result<Compared, CliError> {
    let pointed = |error: ScenarioError| scenario_error(error, name, Some(scenario.text().to_owned()));
    let progress = progress(PathMethod::ALL.len() as u64 + 2);
    let problem = scenario.problem().map_err(pointed)?;
    let mut traces = Vec::new();
    for method in [PathMethod::SlidingMode, PathMethod::SlidingModePaper, PathMethod::SlidingModeImplicit] {
        progress.set_message(method.name());
        traces.push(run_conditioner(&problem, method).map_err(|error| pointed(error.into()))?);
        progress.inc(1);
    }
    progress.set_message(PathMethod::QpFilter.name());
    traces.push(qp_filter_trace(&problem));
    progress.inc(1);
    progress.set_message(PathMethod::Projection.name());
    // A set that is empty somewhere has no projection; the other methods are compared all the same.
    let projected = projection_trace(&problem).ok();
    traces.extend(projected.as_ref().map(|p| p.trace.clone()));
    progress.inc(1);
    progress.set_message(PathMethod::PotentialField.name());
    traces.push(potential_field_trace(&problem));
    progress.inc(1);

    let tolerance = options.tolerance.or(scenario.tolerance());
    progress.set_message("shorter sampling periods");
    let convergence = convergence(&problem).map_err(|error| pointed(error.into()))?;
    progress.inc(1);
    let summary = summarise(scenario, &problem, &traces, projected.as_ref(), convergence, tolerance);
    progress.set_message("writing traces and figures");
    write(out, scenario, &problem, &traces, &summary)?;
    progress.finish_and_clear();
    Ok(Compared {
        holds: summary.verdict.holds,
        sentence: summary.verdict.sentence.clone(),
        key: KeyFigures { ratio: summary.verdict.ratio, ..KeyFigures::default() },
        summary: as_json(&summary)?,
        table: path_report::table(&summary),
    })
}

fn summarise(
    scenario: &ConditioningScenario,
    problem: &ConditioningProblem,
    traces: &[ConditionedTrace],
    projected: Option<&ProjectedTrace>,
    convergence: Vec<Convergence>,
    tolerance: Option<f64>,
) -> PathSummary {
    let qp = traces.iter().find(|t| t.method == PathMethod::QpFilter);
    let projection = projected.map(|p| &p.trace);
    let methods: Vec<PathMethodSummary> =
        traces.iter().map(|trace| PathMethodSummary::new(problem, trace, projection, qp)).collect();
    let constraints: Vec<String> = problem.constraints.iter().map(|c| c.name.clone()).collect();
    PathSummary {
        scenario: scenario.name().to_owned(),
        description: scenario.description().to_owned(),
        verdict: PathVerdict::new(&methods, &constraints, tolerance),
        constraints,
        methods,
        disturbances: Some(problem.disturbances).filter(|d| !d.are_none()),
        projection: projected.map(ProjectionEntry::new),
        convergence,
    }
}

fn write(
    out: &Path,
    scenario: &ConditioningScenario,
    problem: &ConditioningProblem,
    traces: &[ConditionedTrace],
    summary: &PathSummary,
) -> Result<(), CliError> {
    let figures_dir = write_summary(out, summary)?;
    for trace in traces {
        create(out.join(format!("trace-{}.csv", trace.method)), |file| trace.write_csv(file))?;
    }
    let study = ConditioningStudy { title: scenario.name(), problem, traces, bands: &[] };
    let mut figures = draw_conditioning_study(&study, &figures_dir)?;
    let points: Vec<_> = summary.convergence.iter().map(Convergence::point).collect();
    // On logarithmic axes a distance of zero has no place: nothing ever acted, and there is nothing to show.
    if points.len() >= 2 && points.iter().all(|p| p.mean_distance_m > 0.0) {
        figures.push(draw_convergence(&ConvergenceStudy { title: scenario.name(), points: &points }, &figures_dir)?);
    }
    let page = path_report::render(summary, scenario, &figures);
    create(out.join("report.html"), |file| file.write_all(page.as_bytes()))
}
