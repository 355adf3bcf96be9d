use crate::args::StudyArguments;
use crate::say::diagnostic::{CliError, Named};
use crate::say::output::{Answer, Outcome, begin, create, show, write_summary, wrote_figures};
use crate::say::page::Page;
use crate::say::table::{Column, Table};
use crate::say::words::{nearest, short};
use slideway_figures::{Chart, ChartCurve, ChartPanel, ChartRole, ChartScales, Rendered, draw_chart};
use slideway_study::{NamedNumber, Panel, Report, Role, Scales, Series, Study};
use std::path::{Path, PathBuf};

/// Runs one study, or all of them.
pub(crate) fn run(arguments: &StudyArguments) -> Result<Outcome, CliError> {
    let Some(name) = &arguments.study else {
        let folder = |study: Study| match &arguments.out {
            Some(out) => out.join(study.name()),
            None => default_folder(study),
        };
        let mut outcome = Outcome::Holds;
        for study in Study::ALL {
            if run_one(study, &folder(study), arguments)? == Outcome::Fails {
                outcome = Outcome::Fails;
            }
        }
        return Ok(outcome);
    };
    let study = Study::named(name).ok_or_else(|| unknown(name))?;
    let out = arguments.out.clone().unwrap_or_else(|| default_folder(study));
    run_one(study, &out, arguments)
}

fn default_folder(study: Study) -> PathBuf {
    Path::new("out").join(format!("study-{}", study.name()))
}

fn unknown(name: &str) -> CliError {
    let nearest = nearest(name, Study::ALL.iter().map(|s| s.name()));
    CliError::Unknown { what: Named::Study, name: name.to_owned(), nearest }
}

fn run_one(study: Study, out: &Path, arguments: &StudyArguments) -> Result<Outcome, CliError> {
    let failed = |error| CliError::Study { error: Box::new(error), name: study.name() };
    let report = slideway_study::run(study, arguments.seed).map_err(failed)?;
    let figures_dir = begin(out)?;
    let figures = [draw_chart(&chart(&report), &figures_dir)?];
    wrote_figures(&figures);
    let page = page(&report, study, &figures);
    create(out.join("report.html"), |file| file.write_all(page.as_bytes()))?;
    write_summary(out, &report)?;
    let answer = Answer { table: &text(&report, study), verdict: &report.sentence };
    show(arguments.json, &report, &answer, out)?;
    Ok(if report.holds { Outcome::Holds } else { Outcome::Fails })
}

fn chart(report: &Report) -> Chart<'_> {
    Chart { title: report.title, message: &report.sentence, panels: report.panels.iter().map(panel).collect() }
}

fn panel(panel: &Panel) -> ChartPanel<'_> {
    ChartPanel {
        title: &panel.title,
        x: panel.x,
        y: panel.y,
        scales: match panel.scales {
            Scales::Filling => ChartScales::Filling,
            Scales::Equal => ChartScales::Equal,
        },
        curves: panel.series.iter().map(curve).collect(),
        levels: panel.levels.iter().map(|level| (level.name, level.value)).collect(),
    }
}

fn curve(series: &Series) -> ChartCurve<'_> {
    let role = match series.role {
        Role::Reference => ChartRole::Reference,
        Role::Result => ChartRole::Result,
    };
    ChartCurve { name: series.name, role, points: &series.points }
}

const COLUMNS: [Column<NamedNumber>; 3] =
    [("number", |n| n.name.clone()), ("value", |n| short(n.value)), ("unit", |n| n.unit.to_owned())];

fn table(report: &Report) -> Table {
    Table::of(&COLUMNS, &report.numbers).numbers(1..2)
}

fn text(report: &Report, study: Study) -> String {
    let table = table(report).terminal();
    format!("{} - {}\n{table}\n\n{}\n", report.study, study.summary(), report.sentence)
}

fn page(report: &Report, study: Study, figures: &[Rendered]) -> String {
    let page = Page {
        title: report.title,
        description: study.summary(),
        holds: report.holds,
        verdict: &report.sentence,
        body: table(report).html(),
        figures,
        scenario: None,
    };
    page.render()
}
