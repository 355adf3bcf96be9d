//! Figures of path conditioning and of sweeps keep their promises, on the built-in scenarios and on traces made by hand.

mod files;

use files::{is_well_formed, png_header};
use slideway_figures::{
    ConditioningStudy, ConvergencePoint, ConvergenceStudy, EscapeStudy, EscapeVariant, FigureError, PhiBand, Rendered,
    draw_conditioning_study, draw_convergence, draw_escape_times,
};
use slideway_lab::conditioning::{ConditionedTrace, ConditioningProblem, PathMethod, Phase, run_conditioner};
use slideway_scenario::BUILT_IN;
use slideway_scenario::ConditioningScenario;
use std::error::Error;

struct Material {
    problem: ConditioningProblem,
    traces: Vec<ConditionedTrace>,
}

const FORMS: [PathMethod; 3] = [PathMethod::SlidingMode, PathMethod::SlidingModePaper, PathMethod::SlidingModeImplicit];

impl Material {
    fn of(scenario: &str) -> Result<Self, Box<dyn Error>> {
        let built_in = BUILT_IN.iter().find(|b| b.name == scenario).ok_or("no such scenario")?;
        let problem = ConditioningScenario::parse(built_in.name, built_in.text)?.problem()?;
        let mut traces =
            FORMS.map(|form| run_conditioner(&problem, form)).into_iter().collect::<Result<Vec<_>, _>>()?;
        traces.push(follower(&traces[2], PathMethod::QpFilter));
        traces.push(follower(&traces[2], PathMethod::Projection));
        traces.push(follower(&traces[0], PathMethod::PotentialField));
        Ok(Self { problem, traces })
    }

    /// The shortest: 500 samples.
    fn small() -> Result<Self, Box<dyn Error>> {
        let mut material = Self::of("helix-plane-sphere")?;
        for trace in &mut material.traces {
            trace.samples = trace.samples.iter().step_by(10).copied().collect();
        }
        Ok(material)
    }

    fn study(&self) -> ConditioningStudy<'_> {
        ConditioningStudy { title: "a <study> & its title", problem: &self.problem, traces: &self.traces, bands: &[] }
    }
}

/// A stand-in for a method that is not the conditioner's: the same path without walk; no `φ` for a projection.
fn follower(trace: &ConditionedTrace, method: PathMethod) -> ConditionedTrace {
    let mut trace = ConditionedTrace { method, ..trace.clone() };
    for sample in &mut trace.samples {
        sample.walk = [0.0; 3];
        sample.phase = Phase::Free;
        if method == PathMethod::Projection {
            sample.phi = sample.phi.map(|_| f64::NAN);
        }
    }
    trace
}

fn draw(study: &ConditioningStudy) -> Result<Vec<Rendered>, FigureError> {
    let dir = tempfile::tempdir().map_err(|source| FigureError::Write { path: "temporary".into(), source })?;
    draw_conditioning_study(study, dir.path())
}

fn find<'a>(figures: &'a [Rendered], name: &str) -> Result<&'a Rendered, Box<dyn Error>> {
    Ok(figures.iter().find(|figure| figure.name == name).ok_or("not drawn")?)
}

fn axis_labels(name: &str) -> &'static [&'static str] {
    match name {
        "conditioned-path" => &["x (m)", "y (m)", "z (m)", "boundary", "reference"],
        "sigma" => &["time (s)", "mm", "limit", "σ of"],
        "deviation" => &["time (s)", "mm", "projection of the reference", "implicit: mean"],
        "push" => &["time (s)", "mm", "available", "correction in z"],
        "phi" => &["time (s)", "φ (mm)", "constraint acts"],
        "trap" => &["time (s)", "of full", "mm", "reference stopped"],
        "convergence" => &["sampling period (ms)", "distance (mm)", "slope"],
        "escape-times" => &["share of runs", "(s)", "median"],
        _ => &["a figure that this test does not know"],
    }
}

fn check(figure: &Rendered) -> Result<(), Box<dyn Error>> {
    let name = figure.name;
    assert!(is_well_formed(&figure.svg), "{name}");
    assert_eq!(std::fs::read_to_string(&figure.svg_path)?, figure.svg);
    for label in axis_labels(name) {
        assert!(figure.svg.contains(label), "{name} lacks {label}");
    }
    assert!(figure.svg.contains("<polyline"), "{name} has no curve");
    assert!(figure.svg.len() < 400_000, "{name}: {} bytes", figure.svg.len());
    let (width, height, bytes) = png_header(&figure.png_path)?;
    assert_eq!((width, height), (1000, figure.height), "{name}");
    // White alone compresses to less than a kilobyte.
    assert!(bytes > 10_000, "{name}: {bytes} bytes");
    Ok(())
}

#[test]
fn every_figure_of_every_built_in_scenario_is_drawn() -> Result<(), Box<dyn Error>> {
    for (name, count) in
        [("helix-plane-sphere", 5), ("trap-ellipsoid", 6), ("trap-two-ellipsoids", 6), ("trap-booth-oval", 6)]
    {
        let material = Material::of(name)?;
        let dir = tempfile::tempdir()?;
        let figures = draw_conditioning_study(&material.study(), dir.path())?;
        assert_eq!(figures.len(), count, "{name}");
        figures.iter().try_for_each(check)?;
    }
    Ok(())
}

#[test]
fn text_and_background_have_the_colours_that_a_page_restyles() -> Result<(), Box<dyn Error>> {
    for figure in draw(&Material::small()?.study())? {
        assert!(figure.svg.contains("fill=\"#FFFFFF\""));
        assert!(figure.svg.contains("stroke=\"#D9D9D9\""));
        for text in figure.svg.split("<text").skip(1) {
            assert!(text.contains("fill=\"#1A1A1A\""), "{text}");
        }
    }
    Ok(())
}

#[test]
fn any_one_method_can_be_drawn_alone() -> Result<(), Box<dyn Error>> {
    let material = Material::small()?;
    for trace in &material.traces {
        let study = ConditioningStudy { traces: std::slice::from_ref(trace), ..material.study() };
        let drawn: Vec<_> = draw(&study)?.iter().map(|figure| figure.name).collect();
        assert_eq!(drawn.contains(&"phi"), trace.method != PathMethod::Projection, "{}", trace.method);
        assert!(drawn.len() >= 4, "{}", trace.method);
    }
    Ok(())
}

#[test]
fn a_proven_band_is_drawn_and_said_to_be_kept_or_not() -> Result<(), Box<dyn Error>> {
    let material = Material::small()?;
    for (upper, words) in [(1.0, "stays below its proven band"), (1e-9, "is exceeded in 1 of 1")] {
        let bands = [PhiBand { method: PathMethod::SlidingMode, constraint: 0, lower: -1.0, upper }];
        let figures = draw(&ConditioningStudy { bands: &bands, ..material.study() })?;
        let svg: String = find(&figures, "phi")?.svg.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(svg.contains("proven band"));
        let said: Vec<&str> = svg.split("<text").filter_map(|text| text.split('>').nth(1)).collect();
        let said = said.join(" ").replace("</text", "");
        assert!(said.split_whitespace().collect::<Vec<_>>().join(" ").contains(words), "{said}");
    }
    Ok(())
}

#[test]
fn bands_for_no_constraint_or_without_extent_are_refused() -> Result<(), Box<dyn Error>> {
    let material = Material::small()?;
    let good = PhiBand { method: PathMethod::SlidingMode, constraint: 1, lower: -1.0, upper: 1.0 };
    for bad in [PhiBand { constraint: 2, ..good }, PhiBand { lower: f64::NAN, ..good }, PhiBand { upper: -2.0, ..good }]
    {
        let study = ConditioningStudy { bands: &[good, bad], ..material.study() };
        assert!(matches!(draw(&study), Err(FigureError::Value { index: 1, .. })));
    }
    Ok(())
}

#[test]
fn a_path_that_flies_off_does_not_spoil_the_views() -> Result<(), Box<dyn Error>> {
    let mut material = Material::small()?;
    material.traces[0].samples[200].position = [1e300, -1e9, 0.0];
    let figures = draw(&material.study())?;
    assert!(figures.iter().all(|figure| figure.svg.len() < 400_000));
    Ok(())
}

#[test]
fn a_trace_that_stops_being_finite_is_drawn_up_to_there_and_the_captions_say_so() -> Result<(), Box<dyn Error>> {
    let mut material = Material::small()?;
    material.traces[0].samples[101].sigma[1] = f64::NAN;
    for figure in draw(&material.study())? {
        assert!(figure.caption.contains("not finite after 1.000 s"), "{}", figure.caption);
    }
    Ok(())
}

#[test]
fn no_traces_are_refused() -> Result<(), Box<dyn Error>> {
    let material = Material::small()?;
    assert!(matches!(draw(&ConditioningStudy { traces: &[], ..material.study() }), Err(FigureError::NoTraces)));
    Ok(())
}

#[test]
fn an_empty_trace_is_refused() -> Result<(), Box<dyn Error>> {
    let mut material = Material::small()?;
    material.traces[1].samples.clear();
    let method = PathMethod::SlidingModePaper;
    assert!(matches!(draw(&material.study()), Err(FigureError::EmptyPathTrace { method: m }) if m == method));
    Ok(())
}

#[test]
fn a_trace_without_a_finite_start_is_refused() -> Result<(), Box<dyn Error>> {
    let mut material = Material::small()?;
    material.traces[0].samples[0].position[2] = f64::INFINITY;
    assert!(matches!(draw(&material.study()), Err(FigureError::PathNotFinite { method: PathMethod::SlidingMode })));
    Ok(())
}

#[test]
fn a_trace_of_another_problem_is_refused() -> Result<(), Box<dyn Error>> {
    let mut material = Material::small()?;
    material.traces[0].constraints.pop();
    assert!(matches!(draw(&material.study()), Err(FigureError::Length { expected: 2, found: 1, .. })));
    Ok(())
}

#[test]
fn a_directory_that_cannot_be_made_is_reported() -> Result<(), Box<dyn Error>> {
    let dir = tempfile::tempdir()?;
    let file = dir.path().join("file");
    std::fs::write(&file, "")?;
    let material = Material::small()?;
    assert!(matches!(draw_conditioning_study(&material.study(), &file), Err(FigureError::Write { .. })));
    Ok(())
}

fn point(period_s: f64, distance: f64) -> ConvergencePoint {
    ConvergencePoint { period_s, mean_distance_m: distance, max_distance_m: 5.0 * distance }
}

#[test]
fn the_convergence_is_drawn_with_its_slope() -> Result<(), Box<dyn Error>> {
    let dir = tempfile::tempdir()?;
    let points = [point(1e-3, 4e-4), point(5e-5, 1e-6), point(2e-4, 1.6e-5)];
    let figure = draw_convergence(&ConvergenceStudy { title: "t", points: &points }, dir.path())?;
    check(&figure)?;
    // Distances grow with the square of the period.
    assert!(figure.svg.contains("The mean falls with slope 2.00"));
    Ok(())
}

#[test]
fn a_convergence_without_a_slope_is_refused() -> Result<(), Box<dyn Error>> {
    let dir = tempfile::tempdir()?;
    let draw = |points: &[ConvergencePoint]| draw_convergence(&ConvergenceStudy { title: "t", points }, dir.path());
    assert!(matches!(draw(&[]), Err(FigureError::Length { found: 0, .. })));
    assert!(matches!(draw(&[point(1.0, 1.0), point(1.0, 2.0)]), Err(FigureError::Length { found: 1, .. })));
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(draw(&[point(1.0, 1.0), point(2.0, bad)]), Err(FigureError::Value { index: 1, .. })), "{bad}");
        assert!(matches!(draw(&[point(1.0, 1.0), point(bad, 1.0)]), Err(FigureError::Value { index: 1, .. })), "{bad}");
    }
    Ok(())
}

#[test]
fn escape_times_are_drawn_and_failures_are_told() -> Result<(), Box<dyn Error>> {
    let dir = tempfile::tempdir()?;
    let times: Vec<f64> = (0..90).map(|i| 1.0 + f64::from(i) * 0.01).collect();
    let variants = [
        EscapeVariant { label: "with failures", escape_s: &times, failures: 10 },
        EscapeVariant { label: "none", escape_s: &times, failures: 0 },
        EscapeVariant { label: "only failures", escape_s: &[], failures: 3 },
    ];
    let figure = draw_escape_times(&EscapeStudy { title: "t", variants: &variants }, dir.path())?;
    check(&figure)?;
    // The 50th of 100 times; the 95th does not exist.
    assert!(figure.svg.contains("with failures (1.49 s, never)"));
    assert!(figure.svg.contains("none (1.44 s, 1.85 s)"));
    assert!(figure.svg.contains("13 of 193 runs stay trapped"));
    assert!(figure.caption.contains("with failures: 90 of 100"));
    Ok(())
}

#[test]
fn escape_times_that_are_none_are_refused() -> Result<(), Box<dyn Error>> {
    let dir = tempfile::tempdir()?;
    let draw = |variants: &[EscapeVariant]| draw_escape_times(&EscapeStudy { title: "t", variants }, dir.path());
    assert!(matches!(draw(&[]), Err(FigureError::NoTraces)));
    let empty = EscapeVariant { label: "", escape_s: &[], failures: 0 };
    assert!(matches!(draw(&[empty]), Err(FigureError::Length { .. })));
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        let variant = EscapeVariant { escape_s: &[1.0, bad], ..empty };
        assert!(matches!(draw(&[variant]), Err(FigureError::Value { index: 1, .. })), "{bad}");
    }
    Ok(())
}
