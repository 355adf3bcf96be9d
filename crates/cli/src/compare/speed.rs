//! A comparison of speed laws, shown and written.

use crate::compare::compared::{CompareOptions, Compared, KeyFigures};
use crate::compare::{law_figures, speed_page, speed_text};
use crate::say::diagnostic::CliError;
use crate::say::loaded::{compare_error, scenario_error};
use crate::say::output::{Watched, as_json, begin, create, write_summary, wrote_figures};
use slideway_baselines::time_optimal::Solver;
use slideway_compare::{SpeedComparison, SpeedOptions, compare_speed};
use slideway_figures::{LookAheadPoint, LookAheadStudy, Optimum, SpeedStudy, draw_look_ahead, draw_speed_study};
use slideway_lab::Experiment;
use slideway_robot::RobotSummary;
use slideway_scenario::{Scenario, SolverName};
use std::path::Path;

/// Runs every speed law on a scenario and writes the results.
pub(crate) fn run(name: &str, options: &CompareOptions, scenario: &Scenario, out: &Path) -> Result<Compared, CliError> {
    let pointed = |error| scenario_error(error, name, Some(scenario.text().to_owned()));
    let experiment = scenario.experiment().map_err(pointed)?;
    let options = SpeedOptions {
        name: scenario.name().to_owned(),
        description: scenario.description().to_owned(),
        robot: Some(RobotSummary::from(&scenario.robot().map_err(pointed)?)),
        judged: scenario.judged_method(),
        tolerance: options.tolerance.unwrap_or_else(|| scenario.tolerance()),
        inter_sample: options.inter_sample,
        grid_points: scenario.grid_points(),
        gap: options.gap.unwrap_or_else(|| scenario.optimum_gap()),
        cells: options.cells.unwrap_or_else(|| scenario.optimum_cells()),
        solver: options.solver.unwrap_or(match scenario.optimum_solver() {
            SolverName::Structured => Solver::Structured,
            SolverName::Conic => Solver::Conic,
        }),
    };
    let mut watched = Watched::new();
    let compared = compare_speed(&experiment, &options, &mut |progress| watched.show(progress));
    let comparison = compared.map_err(|error| compare_error(error, name, scenario.text()))?;
    watched.writing();
    write(out, scenario, &experiment, &comparison)?;
    watched.end();
    let summary = &comparison.summary;
    Ok(Compared {
        holds: summary.verdict.holds,
        sentence: summary.verdict.sentence.clone(),
        key: KeyFigures {
            optimum_s: Some(summary.optimum.duration_s),
            gap: Some(summary.optimum.gap),
            certified_for: Some(summary.optimum.certified_for),
            ratio: summary.verdict.ratio,
        },
        summary: as_json(summary)?,
        table: speed_text::render(summary),
    })
}

fn write(
    out: &Path,
    scenario: &Scenario,
    experiment: &Experiment,
    comparison: &SpeedComparison,
) -> Result<(), CliError> {
    let SpeedComparison { summary, traces, path, .. } = comparison;
    let figures_dir = begin(out)?;
    for trace in traces {
        create(out.join(format!("trace-{}.csv", trace.method)), |file| trace.write_csv(file))?;
    }
    let motion = comparison.optimum_motion(experiment)?;
    create(out.join("optimum.csv"), |file| motion.write_csv(file))?;
    let curve = curve(comparison);
    let title = scenario.name();
    let study = SpeedStudy {
        title,
        traces,
        tool_path: &experiment.tool_path(400),
        tool_traces: &traces.iter().map(|t| experiment.tool_trace(t)).collect::<Vec<_>>(),
        speed_lower: &path.speed_lower,
        speed_upper: &path.speed_upper,
        optimum: Some(&curve),
        filter_step: experiment.control().filter_step(),
        bound: summary.limit_ratio_bound,
    };
    let mut figures = draw_speed_study(&study, &figures_dir)?;
    let arrived = summary.look_ahead.iter().filter_map(|w| Some(LookAheadPoint { share: w.share, ratio: w.ratio? }));
    let points: Vec<_> = arrived.collect();
    if points.len() >= 2 {
        figures.push(draw_look_ahead(&LookAheadStudy { title, points: &points }, &figures_dir)?);
    }
    figures.extend(law_figures::draw(title, experiment.joint_names(), comparison, &figures_dir)?);
    wrote_figures(&figures);
    let page = speed_page::render(summary, scenario.text(), &figures);
    create(out.join("report.html"), |file| file.write_all(page.as_bytes()))?;
    write_summary(out, summary)
}

/// The optimum's profile as the figures want it: path rate over path parameter and over time.
fn curve(comparison: &SpeedComparison) -> Optimum {
    let mut curve = Optimum::default();
    if let Some(whole) = &comparison.whole {
        for sample in whole.profile() {
            curve.time.push(sample.time);
            curve.lambda.push(sample.lambda);
            curve.path_rate.push(sample.path_rate);
            curve.rate_limit.push(sample.rate_limit);
        }
        curve.gap_cells = comparison.summary.optimum.worst_cells.iter().map(|cell| cell.lambda).collect();
        return curve;
    }
    let mut begin = 0.0;
    for piece in &comparison.optimum.pieces {
        let times = piece.times();
        curve.time.extend(times.iter().map(|t| begin + t));
        curve.lambda.extend(&piece.lambda);
        curve.path_rate.extend(piece.path_rate());
        begin += times.last().copied().unwrap_or(0.0);
    }
    curve
}
