use crate::args::StudyArguments;
use crate::diagnostic::CliError;
use crate::loaded::edit_distance;
use crate::output::{Outcome, create, new_table, show, write_summary};
use crate::report::{Page, escape};
use crate::table::short;
use comfy_table::{Cell, CellAlignment};
use slideway_figures::{Chart, ChartCurve, ChartPanel, ChartRole, ChartScales, Rendered, draw_chart};
use slideway_study::{Panel, Report, Role, Scales, Series, Study};
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
    let names = Study::ALL.iter().map(|study| study.name());
    let nearest = names.map(|known| (edit_distance(name, known), known)).min();
    let near = nearest.filter(|(distance, known)| 3 * distance <= known.len()).map(|(_, known)| known);
    CliError::UnknownStudy { name: name.to_owned(), nearest: near }
}

fn run_one(study: Study, out: &Path, arguments: &StudyArguments) -> Result<Outcome, CliError> {
    let failed = |error| CliError::Study { error: Box::new(error), name: study.name() };
    let report = slideway_study::run(study, arguments.seed).map_err(failed)?;
    let figures_dir = write_summary(out, &report)?;
    let figure = draw_chart(&chart(&report), &figures_dir)?;
    let page = page(&report, study, &[figure]);
    create(out.join("report.html"), |file| file.write_all(page.as_bytes()))?;
    show(arguments.json, &report, &table(&report, study), out)?;
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

fn table(report: &Report, study: Study) -> String {
    let mut table = new_table();
    table.set_header(["number", "value", "unit"]);
    for number in &report.numbers {
        let value = Cell::new(short(number.value)).set_alignment(CellAlignment::Right);
        table.add_row([Cell::new(&number.name), value, Cell::new(number.unit)]);
    }
    format!("{} - {}\n{table}\n\n{}\n", report.study, study.summary(), report.sentence)
}

fn page(report: &Report, study: Study, figures: &[Rendered]) -> String {
    let row = |n: &slideway_study::NamedNumber| {
        format!("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", escape(&n.name), short(n.value), escape(n.unit))
    };
    let rows: String = report.numbers.iter().map(row).collect();
    let body = format!(
        "<div class=\"wide\"><table>\n<thead><tr><th>number</th><th>value</th><th>unit</th></tr></thead>\n\
         <tbody>\n{rows}</tbody></table></div>\n"
    );
    let page = Page {
        title: report.title,
        description: study.summary(),
        holds: report.holds,
        verdict: &report.sentence,
        body,
        figures,
        scenario: None,
    };
    page.render()
}
