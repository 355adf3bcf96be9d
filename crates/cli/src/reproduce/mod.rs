//! Published values beside what this project computes.

mod conditioning_facts;
mod natural_facts;
mod page;
mod speed_facts;
mod speed_table;

use crate::args::{ReproduceArguments, Source};
use crate::compare::compare;
use crate::compared::CompareOptions;
use crate::diagnostic::CliError;
use crate::loaded::load;
use crate::output::{Outcome, create, new_table, print, progress};
use crate::table::short;
use comfy_table::{CellAlignment, Table};
use serde::Serialize;
use slideway_lab::natural::{table_1, table_2};
use slideway_lab::{Agreement, Published};
use slideway_scenario::ScenarioError;
use std::path::Path;

/// What `--json` prints.
#[derive(Clone, Debug, Serialize)]
struct Reproduction {
    rows: Vec<Row>,
    /// Rows that agree with what is printed.
    agreeing: usize,
    /// Rows that agreed before and no longer do.
    lost: usize,
}

/// A published value with what follows from it.
#[derive(Clone, Debug, Serialize)]
struct Row {
    #[serde(flatten)]
    published: Published,
    /// `(ours - paper) / paper`; null without a value or where the paper's is 0.
    difference: Option<f64>,
    agreement: Agreement,
    /// Whether it agreed before and no longer does.
    lost: bool,
}

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
        let text = serde_json::to_string_pretty(&reproduction)
            .map_err(|error| CliError::Write { path: "standard output".into(), source: error.into() })?;
        print(&(text + "\n"));
    } else {
        let wrote = if all { format!("wrote {}\n", arguments.out.join("index.html").display()) } else { String::new() };
        print(&format!("{}\n{}\n{wrote}", reproduction.table(), reproduction.sentence()));
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

impl Reproduction {
    fn new(published: Vec<Published>) -> Self {
        let row = |published: Published| Row {
            difference: published.difference().filter(|d| d.is_finite()),
            agreement: published.agreement(),
            lost: published.is_lost(),
            published,
        };
        let rows: Vec<Row> = published.into_iter().map(row).collect();
        let agreeing = rows.iter().filter(|r| r.agreement == Agreement::Agrees).count();
        let lost = rows.iter().filter(|r| r.lost).count();
        Self { rows, agreeing, lost }
    }

    fn sentence(&self) -> String {
        let known = self.rows.len() - self.agreeing - self.lost;
        let mut text = format!("{} of {} values agree with what is printed", self.agreeing, self.rows.len());
        text += &format!("; {known} are known not to, each with its reason.");
        if self.lost > 0 {
            text += &format!(" No longer agreeing: {}.", self.lost);
        }
        text
    }

    fn table(&self) -> Table {
        let mut table = new_table();
        table.set_header(["source", "case", "quantity", "paper", "ours", "difference", "agrees", "remark"]);
        for row in &self.rows {
            table.add_row(row.cells());
        }
        for column in table.column_iter_mut().skip(3).take(3) {
            column.set_cell_alignment(CellAlignment::Right);
        }
        table
    }
}

impl Row {
    fn cells(&self) -> [String; 8] {
        let Published { source, case, quantity, unit, paper, ours, remark, .. } = &self.published;
        let agrees = match (self.agreement, self.lost) {
            (_, true) => "no longer",
            (Agreement::Agrees, _) => "yes",
            (Agreement::Differs, _) => "no, known",
            (Agreement::NotComputed, _) => "not computed",
        };
        [
            (*source).to_owned(),
            case.clone(),
            if unit.is_empty() { (*quantity).to_owned() } else { format!("{quantity} [{unit}]") },
            Some(format!("{paper}")).filter(|digits| digits.len() < 9).unwrap_or_else(|| short(*paper)),
            ours.map_or("-".to_owned(), digits),
            self.difference.filter(|_| !unit.is_empty()).map_or("-".to_owned(), |d| format!("{:+.2} %", 100.0 * d)),
            agrees.to_owned(),
            (*remark).to_owned(),
        ]
    }
}

/// Four significant digits and more, so that none of a printed value's is lost.
fn digits(value: f64) -> String {
    if (10.0..10_000.0).contains(&value) { format!("{value:.2}") } else { short(value) }
}

/// Writes the page with the comparisons that the papers' figures show, each in its own folder, and the rows as JSON.
fn write(reproduction: &Reproduction, out: &Path) -> Result<(), CliError> {
    let options = CompareOptions { tolerance: None, inter_sample: None };
    for (name, _) in page::SHOWN {
        compare(&load(name)?, name, &options, &out.join(name))?;
    }
    create(out.join("reproduction.json"), |file| Ok(serde_json::to_writer_pretty(file, reproduction)?))?;
    let text = page::render(reproduction, out)?;
    create(out.join("index.html"), |file| file.write_all(text.as_bytes()))
}
