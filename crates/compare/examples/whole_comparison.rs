//! A whole comparison as a value, with its progress on the error stream:
//! `cargo run --release -p slideway-compare --example whole_comparison`.

use slideway_compare::{Progress, SpeedOptions, compare_speed};
use slideway_scenario::Scenario;
use std::ops::ControlFlow;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scenario = Scenario::built_in("puma-helix").ok_or("not built in")??;
    let experiment = scenario.experiment()?;
    let options = SpeedOptions { grid_points: scenario.grid_points(), ..SpeedOptions::named(scenario.name()) };

    // Called before each run; `ControlFlow::Break(())` would end the comparison there.
    let mut watch = |Progress { done, total, stage }: Progress| {
        eprintln!("{done} of {total}: {stage}");
        ControlFlow::Continue(())
    };
    let comparison = compare_speed(&experiment, &options, &mut watch)?;

    let optimum = &comparison.summary.optimum;
    println!("the optimum is certified to lie in [{:.6}, {:.6}] s", optimum.lower_s, optimum.upper_s);
    for entry in &comparison.summary.methods {
        let ratio = entry.ratio.map_or("-".to_owned(), |ratio| format!("{ratio:.4}"));
        println!("{:28} T / T* {ratio}", entry.summary.method.name());
    }
    println!("{}", comparison.summary.verdict.sentence);
    Ok(())
}
