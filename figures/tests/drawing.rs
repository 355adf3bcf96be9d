//! Figures of speed laws keep their promises, on the built-in scenarios and on traces made by hand.

mod files;

use files::{is_well_formed, png_header};
use slideway_conditioner::AffineSpeed;
use slideway_figures::{
    Chart, ChartCurve, ChartPanel, ChartRole, ChartScales, Counterexample, FigureError, Optimum, Rendered, SpeedStudy,
    draw_chart, draw_counterexample, draw_speed_study,
};
use slideway_lab::{JointUnits, MAX_JOINTS, Method, Sample, Trace};
use slideway_scenario::{AnyScenario, BUILT_IN, Scenario};
use std::error::Error;
use std::path::Path;

/// Everything a study borrows.
struct Material {
    traces: Vec<Trace>,
    tool_path: Vec<[f64; 3]>,
    tool_traces: Vec<Vec<[f64; 3]>>,
    speed_lower: Vec<f64>,
    speed_upper: Vec<f64>,
    optimum: Optimum,
}

impl Material {
    fn of(scenario: &str, methods: &[Method]) -> Result<Self, Box<dyn Error>> {
        let experiment = Scenario::built_in(scenario).ok_or("no such scenario")??.experiment()?;
        let traces = methods.iter().map(|&method| experiment.run(method)).collect::<Result<Vec<_>, _>>()?;
        let sampled = experiment.sample(300, 3)?;
        Ok(Self {
            tool_traces: traces.iter().map(|trace| experiment.tool_trace(trace)).collect(),
            traces,
            tool_path: experiment.tool_path(200),
            optimum: Optimum::under_speed_limits(&sampled),
            speed_lower: sampled.speed_lower,
            speed_upper: sampled.speed_upper,
        })
    }

    /// One joint turning, its path rate going up and down.
    fn by_hand() -> Self {
        let samples: Vec<Sample> = (0..200).map(|i| sample(f64::from(i) * 0.01)).collect();
        Self {
            tool_path: vec![[0.0; 3], [1.0, 0.0, 0.0]],
            tool_traces: vec![samples.iter().map(|s| [s.t / 2.0, 0.0, 0.0]).collect()],
            traces: vec![Trace {
                method: Method::SlidingMode,
                joints: 1,
                joint_names: vec!["shoulder".into()],
                units: [JointUnits::TURNING; MAX_JOINTS],
                sampling_period: 0.01,
                finish_s: Some(1.99),
                arrival_s: None,
                samples,
            }],
            speed_lower: vec![-1.0],
            speed_upper: vec![2.0],
            optimum: Optimum::default(),
        }
    }

    fn study(&self) -> SpeedStudy<'_> {
        SpeedStudy {
            title: "a <study> & its title",
            traces: &self.traces,
            tool_path: &self.tool_path,
            tool_traces: &self.tool_traces,
            speed_lower: &self.speed_lower,
            speed_upper: &self.speed_upper,
            optimum: Some(&self.optimum),
            filter_step: 5e-3,
            bound: None,
        }
    }
}

fn sample(t: f64) -> Sample {
    Sample {
        t,
        lambda: t,
        path_rate: 1.0 + t.sin(),
        factor: 0.5,
        switch: 1.0,
        direction_factor: 1.0,
        limit_ratio: 1.0,
        limiting_joint: Some(0),
        error: [0.0; 6],
        q: [0.0; MAX_JOINTS],
        split: AffineSpeed { feedback: [0.0; MAX_JOINTS], feedforward: [t; MAX_JOINTS] },
        desired: [t; MAX_JOINTS],
        commanded: [t; MAX_JOINTS],
        chatter: None,
    }
}

fn draw(study: &SpeedStudy) -> Result<Vec<Rendered>, FigureError> {
    let dir = tempfile::tempdir().map_err(|source| FigureError::Write { path: "temporary".into(), source })?;
    draw_speed_study(study, dir.path())
}

fn axis_labels(name: &str) -> &'static [&'static str] {
    match name {
        "path-rate" => &["path parameter λ", "dλ/dt (1/s)"],
        "path-rate-time" => &["time (s)", "dλ/dt (1/s)"],
        "joint-speeds" => &["time (s)", "rad/s", "joint1", "joint2"],
        "errors" => &["time (s)", "mm", "rad", "error in x", "error in γ"],
        "tool-path" => &["x (m)", "y (m)", "z (m)"],
        "direction-factor" => &["time (s)", "fdir"],
        "chattering" => &["time (s)", "of limit", "bound"],
        _ => &["a figure that this test does not know"],
    }
}

#[test]
fn the_speed_of_a_joint_that_slides_is_drawn_in_metres_per_second() -> Result<(), Box<dyn Error>> {
    let axis = |units: JointUnits| -> Result<bool, Box<dyn Error>> {
        let mut material = Material::by_hand();
        material.traces[0].units[0] = units;
        let figures = draw(&material.study())?;
        let speeds = figures.iter().find(|figure| figure.name == "joint-speeds").ok_or("not drawn")?;
        assert_ne!(speeds.svg.contains("rad/s"), speeds.svg.lines().any(|line| line.trim() == "m/s"));
        Ok(speeds.svg.contains("rad/s"))
    };
    assert!(axis(JointUnits::TURNING)? && !axis(JointUnits::SLIDING)?);
    Ok(())
}

#[test]
fn every_figure_of_every_built_in_scenario_is_drawn() -> Result<(), Box<dyn Error>> {
    for built_in in
        BUILT_IN.into_iter().filter(|b| matches!(AnyScenario::parse(b.name, b.text), Ok(AnyScenario::Speed(_))))
    {
        let material = Material::of(built_in.name, &Method::UNDER_SPEED_LIMITS)?;
        let dir = tempfile::tempdir()?;
        let figures = draw_speed_study(&material.study(), dir.path())?;
        assert_eq!(figures.len(), 7);
        for figure in &figures {
            let name = figure.name;
            assert!(is_well_formed(&figure.svg), "{name}");
            assert_eq!(std::fs::read_to_string(&figure.svg_path)?, figure.svg);
            for label in axis_labels(name) {
                // Where a whole figure is a fraction of a millimetre, axes tell what they leave out: "x − 0.74320 (10⁻⁵ m)".
                let quantity = label.split(" (").next().unwrap_or(label);
                let offset = [" − ", " + "].map(|sign| format!("{quantity}{sign}"));
                let found = figure.svg.contains(label) || offset.iter().any(|o| figure.svg.contains(o));
                assert!(found, "{} {name} lacks {label}", built_in.name);
            }
            assert!(figure.svg.contains("<polyline"), "{name} has no curve");
            assert!(figure.svg.len() < 400_000, "{} {name}: {} bytes", built_in.name, figure.svg.len());
            let (width, height, bytes) = png_header(&figure.png_path)?;
            assert_eq!((width, height), (1000, figure.height), "{name}");
            // White alone compresses to less than a kilobyte.
            assert!(bytes > 10_000, "{name}: {bytes} bytes");
        }
    }
    Ok(())
}

#[test]
fn text_and_background_have_the_colours_that_a_page_restyles() -> Result<(), Box<dyn Error>> {
    for figure in draw(&Material::by_hand().study())? {
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
    for method in Method::UNDER_SPEED_LIMITS {
        let material = Material::of("puma-helix-on-path", &[method])?;
        let drawn: Vec<_> = draw(&material.study())?.iter().map(|figure| figure.name).collect();
        assert_eq!(drawn.contains(&"chattering"), method.is_regulated(), "{method}");
        assert_eq!(
            drawn.contains(&"direction-factor"),
            method.is_regulated() || method == Method::DirectionPreserving,
            "{method}"
        );
        assert!(drawn.len() >= 5, "{method}");
    }
    Ok(())
}

#[test]
fn a_proven_band_is_drawn_and_named() -> Result<(), Box<dyn Error>> {
    let material = Material::of("puma-helix-on-path", &[Method::SlidingMode])?;
    let figures = draw(&SpeedStudy { bound: Some(1.03), ..material.study() })?;
    let chattering = figures.iter().find(|figure| figure.name == "chattering").ok_or("not drawn")?;
    assert!(chattering.svg.contains("band M"));
    assert!(chattering.caption.contains("1.03"));
    Ok(())
}

#[test]
fn the_optimum_takes_the_speed_limited_time_and_rests_in_self_motions() -> Result<(), Box<dyn Error>> {
    let experiment = Scenario::built_in("puma-wrist-singularity").ok_or("no such scenario")??.experiment()?;
    let sampled = experiment.sample(300, 3)?;
    let optimum = Optimum::under_speed_limits(&sampled);
    let duration = optimum.duration().ok_or("empty")?;
    // The same sum in another order: rounding only.
    assert!((duration - sampled.speed_limited_time()).abs() < 1e-9 * duration);
    assert!(optimum.path_rate.contains(&0.0));
    assert!(optimum.time.windows(2).all(|w| w[1] >= w[0]));
    Ok(())
}

#[test]
fn one_joint_and_no_optimum_are_enough() -> Result<(), Box<dyn Error>> {
    let material = Material::by_hand();
    let figures = draw(&SpeedStudy { optimum: None, tool_path: &[], ..material.study() })?;
    assert_eq!(figures.len(), 6);
    Ok(())
}

#[test]
fn huge_speeds_are_cut_off_and_the_caption_says_so() -> Result<(), Box<dyn Error>> {
    let mut material = Material::by_hand();
    material.traces[0].samples[100].commanded[0] = 1e300;
    material.traces[0].samples[100].path_rate = 1e300;
    let figures = draw(&material.study())?;
    let speeds = figures.iter().find(|figure| figure.name == "joint-speeds").ok_or("not drawn")?;
    assert!(speeds.caption.contains("1.0×10³⁰⁰ rad/s"), "{}", speeds.caption);
    Ok(())
}

#[test]
fn a_trace_that_stops_being_finite_is_drawn_up_to_there_and_the_captions_say_so() -> Result<(), Box<dyn Error>> {
    let mut material = Material::by_hand();
    material.traces[0].samples[100].error[2] = f64::NAN;
    for figure in draw(&material.study())? {
        assert!(figure.caption.contains("not finite after 0.990 s"), "{}", figure.caption);
    }
    Ok(())
}

#[test]
fn no_traces_are_refused() {
    let material = Material::by_hand();
    let study = SpeedStudy { traces: &[], tool_traces: &[], ..material.study() };
    assert!(matches!(draw(&study), Err(FigureError::NoTraces)));
}

#[test]
fn an_empty_trace_is_refused() {
    let mut material = Material::by_hand();
    material.traces[0].samples.clear();
    material.tool_traces[0].clear();
    assert!(matches!(draw(&material.study()), Err(FigureError::EmptyTrace { method: Method::SlidingMode })));
}

#[test]
fn a_trace_without_a_finite_start_is_refused() {
    let mut material = Material::by_hand();
    material.traces[0].samples[0].q[0] = f64::NAN;
    assert!(matches!(draw(&material.study()), Err(FigureError::NotFinite { method: Method::SlidingMode })));
}

#[test]
fn lists_of_unequal_length_are_refused() {
    let material = Material::by_hand();
    let short: Vec<Vec<[f64; 3]>> = vec![material.tool_traces[0][1..].to_vec()];
    for study in [
        SpeedStudy { tool_traces: &[], ..material.study() },
        SpeedStudy { tool_traces: &short, ..material.study() },
        SpeedStudy { speed_upper: &[], ..material.study() },
        SpeedStudy { optimum: Some(&Optimum { time: vec![0.0], ..Optimum::default() }), ..material.study() },
    ] {
        assert!(matches!(draw(&study), Err(FigureError::Length { .. })));
    }
}

#[test]
fn limits_that_do_not_enclose_zero_are_refused() {
    let material = Material::by_hand();
    for limit in [f64::NAN, f64::INFINITY, 0.0, -1.0] {
        let study = SpeedStudy { speed_upper: &[limit], ..material.study() };
        assert!(matches!(draw(&study), Err(FigureError::Value { index: 0, .. })), "{limit}");
    }
}

#[test]
fn a_directory_that_cannot_be_made_is_reported() -> Result<(), Box<dyn Error>> {
    let dir = tempfile::tempdir()?;
    let file = dir.path().join("file");
    std::fs::write(&file, "")?;
    let material = Material::by_hand();
    assert!(matches!(draw_speed_study(&material.study(), &file), Err(FigureError::Write { .. })));
    Ok(())
}

#[test]
fn a_counterexample_is_drawn_with_what_is_said_and_what_is_found() -> Result<(), Box<dyn Error>> {
    let dir = tempfile::tempdir()?;
    let (said, found) = ([[0.0, 1.0], [1.0, 1.0]], [[0.0, 0.5], [1.0, 1.5]]);
    let example = Counterexample {
        title: "Refuted: a statement",
        message: "The second sample is outside.",
        quantity: "m",
        saying: "1 at most",
        said: &said,
        found: &found,
    };
    let figure = draw_counterexample(&example, dir.path())?;
    assert!(figure.svg.contains("said: 1 at most") && figure.svg.contains("sample"));
    assert_eq!(figure.svg.matches("<circle").count(), found.len());
    assert!(figure.caption.contains("The second sample is outside."));
    assert!(figure.png_path.is_file() && figure.svg_path.is_file());
    Ok(())
}

#[test]
fn a_counterexample_without_a_run_is_refused() {
    let dir = Path::new("never-made");
    let example = Counterexample { title: "", message: "", quantity: "", saying: "", said: &[], found: &[] };
    assert!(matches!(draw_counterexample(&example, dir), Err(FigureError::Length { found: 0, .. })));
    let gap = [[0.0, 1.0], [1.0, f64::NAN]];
    let example = Counterexample { found: &gap, ..example };
    assert!(matches!(draw_counterexample(&example, dir), Err(FigureError::Value { index: 1, .. })));
    assert!(!dir.exists());
}

#[test]
fn a_chart_is_drawn_with_one_line_style_a_name() {
    let points: Vec<[f64; 2]> = (0..50).map(|k| [0.1 * f64::from(k), (0.1 * f64::from(k)).sin()]).collect();
    let curve = |name, role| ChartCurve { name, role, points: &points };
    let panel = |scales| ChartPanel {
        title: "a panel",
        x: "time (s)",
        y: "rad",
        scales,
        curves: vec![curve("wanted", ChartRole::Reference), curve("found", ChartRole::Result)],
        levels: vec![("limit", 1.5)],
    };
    let panels = vec![panel(ChartScales::Filling), panel(ChartScales::Equal)];
    let folder = tempfile::tempdir().expect("a folder");
    let rendered =
        draw_chart(&Chart { title: "A chart", message: "Two panels.", panels }, folder.path()).expect("drawn");
    assert!(rendered.png_path.exists() && rendered.svg_path.exists());
    // In the legend once, whatever the number of panels.
    for name in ["wanted", "found", "limit"] {
        assert_eq!(rendered.svg.matches(name).count(), 1, "{name}");
    }
}

#[test]
fn a_chart_with_nothing_to_draw_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let empty = Chart { title: "", message: "", panels: Vec::new() };
    assert!(matches!(draw_chart(&empty, folder.path()), Err(FigureError::Length { .. })));
    let curves = vec![ChartCurve { name: "", role: ChartRole::Result, points: &[[f64::NAN, 0.0]] }];
    let panel = ChartPanel { title: "", x: "", y: "", scales: ChartScales::Filling, curves, levels: Vec::new() };
    let blank = Chart { title: "", message: "", panels: vec![panel] };
    assert!(matches!(draw_chart(&blank, folder.path()), Err(FigureError::Value { index: 0, .. })));
}
