//! Draws the figures of every built-in scenario: `cargo run -p slideway-figures --example built_in -- <directory>`.

use slideway_figures::{ConditioningStudy, Optimum, Rendered, SpeedStudy, draw_conditioning_study, draw_speed_study};
use slideway_lab::Method;
use slideway_lab::conditioning::{PathMethod, run_conditioner};
use slideway_scenario::ConditioningScenario;
use slideway_scenario::{AnyScenario, BUILT_IN, BuiltIn, Scenario};
use std::error::Error;
use std::path::{Path, PathBuf};

fn main() -> Result<(), Box<dyn Error>> {
    let out = PathBuf::from(std::env::args().nth(1).ok_or("give a directory")?);
    for built_in in BUILT_IN {
        let dir = out.join(built_in.name);
        let figures = match AnyScenario::parse(built_in.name, built_in.text)? {
            AnyScenario::Speed(_) => speed(&built_in, &dir)?,
            AnyScenario::Conditioning(_) => conditioning(&built_in, &dir)?,
        };
        for figure in figures {
            println!("{} {} B\n  {}", figure.svg_path.display(), figure.svg.len(), figure.caption);
        }
    }
    Ok(())
}

fn speed(built_in: &BuiltIn, dir: &Path) -> Result<Vec<Rendered>, Box<dyn Error>> {
    let experiment = Scenario::parse(built_in.name, built_in.text)?.experiment()?;
    let traces =
        Method::UNDER_SPEED_LIMITS.iter().map(|&method| experiment.run(method)).collect::<Result<Vec<_>, _>>()?;
    let tool_traces: Vec<_> = traces.iter().map(|trace| experiment.tool_trace(trace)).collect();
    let sampled = experiment.sample(1000, 3)?;
    let study = SpeedStudy {
        title: built_in.name,
        traces: &traces,
        tool_path: &experiment.tool_path(500),
        tool_traces: &tool_traces,
        speed_lower: &sampled.speed_lower,
        speed_upper: &sampled.speed_upper,
        optimum: Some(&Optimum::under_speed_limits(&sampled)),
        filter_step: experiment.control().filter_step(),
        bound: None,
    };
    Ok(draw_speed_study(&study, dir)?)
}

fn conditioning(built_in: &BuiltIn, dir: &Path) -> Result<Vec<Rendered>, Box<dyn Error>> {
    let problem = ConditioningScenario::parse(built_in.name, built_in.text)?.problem()?;
    let forms = PathMethod::ALL.into_iter().filter(|method| method.is_conditioner());
    let traces = forms.map(|method| run_conditioner(&problem, method)).collect::<Result<Vec<_>, _>>()?;
    let study = ConditioningStudy { title: built_in.name, problem: &problem, traces: &traces, bands: &[] };
    Ok(draw_conditioning_study(&study, dir)?)
}
