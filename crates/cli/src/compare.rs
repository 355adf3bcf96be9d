use crate::args::CompareArguments;
use crate::commands::{Loaded, Outcome, load, print, scenario_error};
use crate::compare_path::compare_conditioning;
use crate::diagnostic::CliError;
use crate::summary::{MethodEntry, OptimumEntry, Solved, Summary};
use crate::verdict::Verdict;
use crate::windows::{WindowEntry, windows};
use crate::{gallery, report, table};
use indicatif::{ProgressBar, ProgressStyle};
use slideway_baselines::time_optimal::{OptimumError, TimeOptimum, needed_widening};
use slideway_figures::{LookAheadStudy, Optimum, SpeedStudy, draw_look_ahead, draw_speed_study};
use slideway_lab::{Experiment, LabError, Method, SampledPath, Scenario, Trace};
use std::fs;
use std::path::{Path, PathBuf};

/// Samples between grid points at which violations are looked for.
const BETWEEN: usize = 7;

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
        return gallery::run(&options, &out, arguments.json);
    };
    let loaded = load(name)?;
    let out = arguments.out.clone().unwrap_or_else(|| Path::new("out").join(loaded.name()));
    let compared = compare(&loaded, name, &options, &out)?;
    show(arguments.json, &compared.summary, &compared.table, &out)?;
    Ok(if compared.holds { Outcome::Holds } else { Outcome::Fails })
}

/// What the command line says about a comparison.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CompareOptions {
    /// Instead of the scenario's tolerance.
    pub(crate) tolerance: Option<f64>,
    /// Keep the optimum's limits between grid points too, to this share of each.
    pub(crate) inter_sample: Option<f64>,
}

/// A comparison that was run and written.
pub(crate) struct Compared {
    /// Whether its verdict holds.
    pub(crate) holds: bool,
    /// The verdict in words.
    pub(crate) sentence: String,
    /// What the gallery's table shows.
    pub(crate) key: KeyFigures,
    /// What `summary.json` holds.
    pub(crate) summary: serde_json::Value,
    /// The same for a terminal.
    pub(crate) table: String,
}

/// The few numbers by which comparisons are put side by side.
#[derive(Clone, Copy, Debug, Default, serde::Serialize)]
pub(crate) struct KeyFigures {
    /// Certified optimum, s; null for conditioning.
    pub(crate) optimum_s: Option<f64>,
    /// Gap of its certificate.
    pub(crate) gap: Option<f64>,
    /// Judged method over the optimum: travel time, or mean deviation over the projection's.
    pub(crate) ratio: Option<f64>,
}

/// The summary as JSON.
pub(crate) fn as_json(summary: &impl serde::Serialize) -> Result<serde_json::Value, CliError> {
    serde_json::to_value(summary).map_err(|error| CliError::Write { path: "summary.json".into(), source: error.into() })
}

/// Runs every method on a scenario and writes traces, figures, summary and report.
pub(crate) fn compare(loaded: &Loaded, name: &str, options: &CompareOptions, out: &Path) -> Result<Compared, CliError> {
    match loaded {
        Loaded::Speed(scenario) => compare_speed(name, options, scenario, out),
        Loaded::Conditioning(scenario) => compare_conditioning(name, options, scenario, out),
    }
}

fn compare_speed(name: &str, options: &CompareOptions, scenario: &Scenario, out: &Path) -> Result<Compared, CliError> {
    let tolerance = options.tolerance.unwrap_or_else(|| scenario.tolerance());
    let pointed = |error: LabError| scenario_error(error, name, Some(scenario.text().to_owned()));
    let experiment = Experiment::new(scenario).map_err(pointed)?;
    let judged = experiment.judged_method(scenario).map_err(pointed)?;
    let progress = progress(experiment.methods().len() as u64 + 2);
    let traces = run_methods(&experiment, &progress).map_err(pointed)?;
    progress.set_message("solving for the optimum");
    let path = experiment.sample(scenario.grid_points(), BETWEEN).map_err(pointed)?;
    let finer = experiment.sample(2 * scenario.grid_points(), 0).map_err(pointed)?;
    let solved = Solved::new(&path, &finer, options.inter_sample).map_err(|error| no_optimum(error, &path))?;
    let study = Study { scenario, experiment: &experiment, path: &path, finer: &finer, judged };
    let mut summary = summarise(&study, &traces, &solved, tolerance)?;
    summary.look_ahead = windows(&experiment, &summary.optimum).map_err(pointed)?;
    progress.inc(1);

    progress.set_message("writing traces and figures");
    write(out, scenario, &experiment, &traces, &path, &solved.optimum, &summary)?;
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

pub(crate) fn progress(steps: u64) -> ProgressBar {
    let bar = ProgressBar::new(steps);
    if let Ok(style) = ProgressStyle::with_template("{bar:24} {pos}/{len} {msg}") {
        bar.set_style(style);
    }
    bar
}

fn run_methods(experiment: &Experiment, progress: &ProgressBar) -> Result<Vec<Trace>, LabError> {
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
}

fn summarise(study: &Study<'_>, traces: &[Trace], solved: &Solved, tolerance: f64) -> Result<Summary, CliError> {
    let Study { scenario, experiment, path, finer, judged } = study;
    let closed_form = path.speed_limited_time();
    let entry = OptimumEntry::new(solved, closed_form);
    let limits_more = path.pieces.iter().any(|piece| path.limits_acceleration(piece));
    let speed_only = if limits_more {
        let (path, finer) = (path.under_speed_limits_alone(), finer.under_speed_limits_alone());
        Some(OptimumEntry::new(&Solved::new(&path, &finer, None)?, closed_form))
    } else {
        None
    };
    let method = |trace: &Trace| MethodEntry::new(trace, experiment.limit_use(trace), &entry);
    let methods: Vec<MethodEntry> = traces.iter().map(method).collect();
    let position_excesses = experiment.position_excesses();
    let verdict = Verdict::new(*judged, &methods, traces, &entry, tolerance).under_position_limits(&position_excesses);
    Ok(Summary {
        scenario: scenario.name().to_owned(),
        description: scenario.description().to_owned(),
        methods,
        optimum: entry,
        optimum_speed_only: speed_only,
        limit_ratio_bound: path.limit_ratio_bound(&experiment.control()),
        spare_joints: experiment.spare_joints(),
        position_excesses,
        look_ahead: Vec::new(),
        verdict,
    })
}

/// Makes the folders and writes `summary.json`; the folder of the figures.
pub(crate) fn write_summary(out: &Path, summary: &impl serde::Serialize) -> Result<PathBuf, CliError> {
    let figures_dir = out.join("figures");
    fs::create_dir_all(&figures_dir).map_err(|source| CliError::Write { path: figures_dir.clone(), source })?;
    create(out.join("summary.json"), |file| Ok(serde_json::to_writer_pretty(file, summary)?))?;
    Ok(figures_dir)
}

/// Creates a file with what `fill` writes into it.
pub(crate) fn create(
    path: PathBuf,
    fill: impl FnOnce(&mut dyn std::io::Write) -> std::io::Result<()>,
) -> Result<(), CliError> {
    let result = fs::File::create(&path).and_then(|file| {
        let mut out = std::io::BufWriter::new(file);
        fill(&mut out)?;
        std::io::Write::flush(&mut out)
    });
    result.map_err(|source| CliError::Write { path, source })
}

fn write(
    out: &Path,
    scenario: &Scenario,
    experiment: &Experiment,
    traces: &[Trace],
    path: &SampledPath,
    optimum: &TimeOptimum,
    summary: &Summary,
) -> Result<(), CliError> {
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

/// Prints the summary as JSON or the table, and where the report is.
pub(crate) fn show(json: bool, summary: &impl serde::Serialize, table: &str, out: &Path) -> Result<(), CliError> {
    if json {
        let text = serde_json::to_string_pretty(summary)
            .map_err(|error| CliError::Write { path: out.join("summary.json"), source: error.into() })?;
        print(&(text + "\n"));
    } else {
        print(&format!("{table}\nwrote {}\n", out.join("report.html").display()));
    }
    Ok(())
}
