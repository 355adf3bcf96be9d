use crate::compared::{CompareOptions, Compared, KeyFigures};
use crate::diagnostic::CliError;
use crate::laws::{self, ModelErrorEntry};
use crate::loaded::scenario_error;
use crate::output::{as_json, create, progress, write_summary};
use crate::summary::{MethodEntry, OptimumEntry, Solved, Summary, Uses};
use crate::verdict::{Judged, Verdict};
use crate::windows::{WindowEntry, windows};
use crate::{report, table};
use indicatif::ProgressBar;
use slideway_baselines::time_optimal::{OptimumError, TimeOptimum, needed_widening};
use slideway_figures::{
    LookAheadStudy, ModelErrorOfLaw, NamedCourse, Optimum, SpeedStudy, draw_look_ahead, draw_speed_study,
};
use slideway_lab::{Experiment, Method, Trace};
use slideway_path::{ProblemError, SampledPath};
use slideway_scenario::Scenario;
use std::path::Path;

/// Samples between grid points at which violations are looked for.
const BETWEEN: usize = 7;

/// Runs every speed law on a scenario.
pub(crate) fn compare_speed(
    name: &str,
    options: &CompareOptions,
    scenario: &Scenario,
    out: &Path,
) -> Result<Compared, CliError> {
    let tolerance = options.tolerance.unwrap_or_else(|| scenario.tolerance());
    let text = || Some(scenario.text().to_owned());
    let experiment = scenario.experiment().map_err(|error| scenario_error(error, name, text()))?;
    let pointed = |error: ProblemError| scenario_error(error, name, text());
    let judged = experiment.judged_method(scenario.judged_method()).map_err(pointed)?;
    let progress = progress(experiment.methods().len() as u64 + 2);
    let traces = run_methods(&experiment, &progress).map_err(pointed)?;
    progress.set_message("solving for the optimum");
    let path = experiment.sample(scenario.grid_points(), BETWEEN).map_err(pointed)?;
    let finer = experiment.sample(2 * scenario.grid_points(), 0).map_err(pointed)?;
    let solved = Solved::new(&path, &finer, options.inter_sample).map_err(|error| no_optimum(error, &path))?;
    let uses =
        traces.iter().map(|trace| Uses::new(&experiment, trace)).collect::<Result<Vec<_>, _>>().map_err(pointed)?;
    let study = Study { scenario, experiment: &experiment, path: &path, finer: &finer, judged, uses: &uses };
    let mut summary = summarise(&study, &traces, &solved, tolerance)?;
    summary.look_ahead = windows(&experiment, &summary.optimum).map_err(pointed)?;
    let course = laws::optimum_course(&experiment, &solved.optimum).map_err(pointed)?;
    summary.optimum_effort = course.effort();
    summary.scaled_limits = laws::sweep_limits(&experiment, &path).map_err(pointed)?;
    let courses = laws::courses(&experiment, &traces, &course);
    let model_errors = laws::model_errors(&experiment, &courses).map_err(pointed)?;
    summary.model_error = model_errors.iter().map(ModelErrorEntry::from).collect();
    progress.inc(1);

    progress.set_message("writing traces and figures");
    write(out, &study, &traces, &solved.optimum, &Laws { courses: &courses, model_errors: &model_errors }, &summary)?;
    progress.finish_and_clear();
    Ok(Compared {
        holds: summary.verdict.holds,
        sentence: summary.verdict.sentence.clone(),
        key: KeyFigures {
            optimum_s: Some(summary.optimum.duration_s),
            gap: Some(summary.optimum.gap),
            ratio: summary.verdict.ratio,
        },
        summary: as_json(&summary)?,
        table: table::render(&summary),
    })
}

/// Tells by how much limits that no profile keeps would have to give way.
fn no_optimum(error: OptimumError, path: &SampledPath) -> CliError {
    match error {
        OptimumError::Infeasible { .. } => CliError::Infeasible { widening: needed_widening(path), error },
        error => error.into(),
    }
}

fn run_methods(experiment: &Experiment, progress: &ProgressBar) -> Result<Vec<Trace>, ProblemError> {
    experiment
        .methods()
        .iter()
        .map(|&method| {
            progress.set_message(method.name());
            let trace = experiment.run(method);
            progress.inc(1);
            trace
        })
        .collect()
}

/// A scenario with its path on a grid and on one twice as fine.
struct Study<'a> {
    scenario: &'a Scenario,
    experiment: &'a Experiment,
    path: &'a SampledPath,
    finer: &'a SampledPath,
    judged: Method,
    /// What each method used of the limits.
    uses: &'a [Uses],
}

/// What the figures of the laws are drawn from.
struct Laws<'a> {
    courses: &'a [NamedCourse],
    model_errors: &'a [ModelErrorOfLaw],
}

fn summarise(study: &Study<'_>, traces: &[Trace], solved: &Solved, tolerance: f64) -> Result<Summary, CliError> {
    let Study { scenario, experiment, path, finer, judged, uses } = study;
    let closed_form = path.speed_limited_time();
    let optimum = OptimumEntry::new(solved, closed_form);
    let limits_more = path.pieces.iter().any(|piece| path.limits_acceleration(piece));
    let speed_only = if limits_more {
        let (path, finer) = (path.under_speed_limits_alone(), finer.under_speed_limits_alone());
        Some(OptimumEntry::new(&Solved::new(&path, &finer, None)?, closed_form))
    } else {
        None
    };
    let method = |(trace, uses): (&Trace, &Uses)| {
        MethodEntry::new(trace, uses.clone(), experiment.course(trace).effort(), &optimum)
    };
    let methods: Vec<MethodEntry> = traces.iter().zip(*uses).map(method).collect();
    let position_excesses = experiment.position_excesses();
    let judge = |(entry, trace)| Judged {
        entry,
        trace,
        optimum: &optimum,
        speed_only: speed_only.as_ref(),
        disturbances: experiment.disturbances(),
        tolerance,
    };
    let of_judged = methods.iter().zip(traces).find(|(_, trace)| trace.method == *judged).map(judge);
    let verdict = Verdict::new(*judged, tolerance, of_judged.as_ref()).under_position_limits(&position_excesses);
    Ok(Summary {
        scenario: scenario.name().to_owned(),
        description: scenario.description().to_owned(),
        methods,
        optimum,
        optimum_speed_only: speed_only,
        optimum_effort: None,
        scaled_limits: Vec::new(),
        model_error: Vec::new(),
        limit_ratio_bound: experiment.control().limit_ratio_bound(path),
        spare_joints: experiment.spare_joints(),
        position_excesses,
        disturbances: Some(experiment.disturbances().clone()).filter(|d| !d.are_none()),
        look_ahead: Vec::new(),
        verdict,
    })
}

fn write(
    out: &Path,
    study: &Study<'_>,
    traces: &[Trace],
    optimum: &TimeOptimum,
    laws: &Laws<'_>,
    summary: &Summary,
) -> Result<(), CliError> {
    let Study { scenario, experiment, path, .. } = study;
    let figures_dir = write_summary(out, summary)?;
    for trace in traces {
        create(out.join(format!("trace-{}.csv", trace.method)), |file| trace.write_csv(file))?;
    }
    let curve = curve(optimum);
    let study = SpeedStudy {
        title: scenario.name(),
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
    let points: Vec<_> = summary.look_ahead.iter().filter_map(WindowEntry::point).collect();
    if points.len() >= 2 {
        figures.push(draw_look_ahead(&LookAheadStudy { title: scenario.name(), points: &points }, &figures_dir)?);
    }
    let sweep = &summary.scaled_limits;
    figures.extend(laws::figures(scenario.name(), laws.courses, laws.model_errors, path, sweep, &figures_dir)?);
    create(out.join("report.html"), |file| file.write_all(report::render_speed(summary, scenario, &figures).as_bytes()))
}

/// The optimum's profile as the figures want it: path rate over path parameter and over time.
fn curve(optimum: &TimeOptimum) -> Optimum {
    let mut curve = Optimum::default();
    let mut begin = 0.0;
    for piece in &optimum.pieces {
        let times = piece.times();
        curve.time.extend(times.iter().map(|t| begin + t));
        curve.lambda.extend(&piece.lambda);
        curve.path_rate.extend(piece.path_rate());
        begin += times.last().copied().unwrap_or(0.0);
    }
    curve
}
