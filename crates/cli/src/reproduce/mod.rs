//! Published values beside what this project computes.

mod conditioning_facts;
mod natural_facts;
mod page;
mod rows;
mod speed_facts;
mod speed_table;

use crate::args::{ReproduceArguments, Source};
use crate::compare::compared::CompareOptions;
use crate::compare::one::compare;
use crate::say::diagnostic::CliError;
use crate::say::loaded::load;
use crate::say::output::{Outcome, create, print_answer, print_json, progress, withdraw};
use rows::Reproduction;
use slideway_lab::Published;
use slideway_lab::natural::{table_1, table_2};
use slideway_scenario::ScenarioError;
use std::path::Path;

/// Runs the command: exit status 1 if something that agreed before no longer does.
pub(crate) fn run(arguments: &ReproduceArguments) -> Result<Outcome, CliError> {
    let sources: &[Source] = match &arguments.source {
        Some(source) => std::slice::from_ref(source),
        None => &Source::ALL,
    };
    let bar = progress(sources.len() as u64);
    let mut published = Vec::new();
    for source in sources {
        bar.set_message(source.name());
        published.extend(source.rows().map_err(built_in)?);
        bar.inc(1);
    }
    bar.finish_and_clear();
    let reproduction = Reproduction::new(published);
    let all = arguments.source.is_none();
    if all {
        write(&reproduction, &arguments.out)?;
    }
    if arguments.json {
        print_json(&reproduction)?;
    } else {
        let wrote = if all { format!("wrote {}\n", arguments.out.join("index.html").display()) } else { String::new() };
        let sentence = reproduction.sentence();
        let whole = format!("{}\n{sentence}\n{wrote}", reproduction.table().terminal());
        print_answer(&whole, &format!("{sentence}\n"))?;
    }
    Ok(if reproduction.lost == 0 { Outcome::Holds } else { Outcome::Fails })
}

/// An error in a built-in scenario has no file to point at.
fn built_in(error: ScenarioError) -> CliError {
    CliError::Scenario { error: Box::new(error), file: "built in".into(), text: None }
}

impl Source {
    const ALL: [Self; 4] = [Self::SpeedTable1, Self::Figures, Self::Table1, Self::Table2];

    fn name(self) -> &'static str {
        match self {
            Self::Table1 => "[N] Table I",
            Self::Table2 => "[N] Table II",
            Self::SpeedTable1 => "[G11] Table 1",
            Self::Figures => "facts of the figures",
        }
    }

    fn rows(self) -> Result<Vec<Published>, ScenarioError> {
        match self {
            Self::Table1 => Ok(table_1()?),
            Self::Table2 => Ok(table_2()?),
            Self::SpeedTable1 => speed_table::rows(),
            Self::Figures => {
                let mut rows = speed_facts::rows()?;
                rows.extend(conditioning_facts::rows()?);
                rows.extend(natural_facts::rows()?);
                Ok(rows)
            }
        }
    }
}

/// Writes the page with the comparisons that the papers' figures show, each in its own folder, and the rows as JSON.
fn write(reproduction: &Reproduction, out: &Path) -> Result<(), CliError> {
    let options = CompareOptions::default();
    withdraw(&out.join("reproduction.json"))?;
    for (name, _) in page::SHOWN {
        compare(&load(name)?, name, &options, &out.join(name))?;
    }
    let text = page::render(reproduction, out)?;
    create(out.join("index.html"), |file| file.write_all(text.as_bytes()))?;
    create(out.join("reproduction.json"), |file| Ok(serde_json::to_writer_pretty(file, reproduction)?))
}
