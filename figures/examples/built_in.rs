//! Draws the figures of every built-in scenario: `cargo run -p slideway-figures --example built_in -- <directory>`.

use slideway_figures::{Optimum, SpeedStudy, draw_speed_study};
use slideway_lab::{BUILT_IN, Experiment, Method, Scenario};
use std::error::Error;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn Error>> {
    let out = PathBuf::from(std::env::args().nth(1).ok_or("give a directory")?);
    for built_in in BUILT_IN {
        let experiment = Experiment::new(&Scenario::parse(built_in.name, built_in.text)?)?;
        let traces = Method::ALL.iter().map(|&method| experiment.run(method)).collect::<Result<Vec<_>, _>>()?;
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
        for figure in draw_speed_study(&study, &out.join(built_in.name))? {
            println!("{} {} B\n  {}", figure.svg_path.display(), figure.svg.len(), figure.caption);
        }
    }
    Ok(())
}
