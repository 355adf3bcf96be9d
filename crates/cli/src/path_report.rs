use crate::output::new_table;
use crate::path_summary::PathSummary;
use crate::report::{Page, escape};
use crate::table::short;
use comfy_table::{Cell, CellAlignment};
use slideway_figures::Rendered;
use slideway_lab::conditioning::PathMethodSummary;
use slideway_scenario::ConditioningScenario;

/// Column titles with their cells: one definition for the terminal and the report.
type Column = (&'static str, fn(&PathMethodSummary) -> String);

const COLUMNS: [Column; 11] = [
    ("method", |m| m.method.name().to_owned()),
    ("mean deviation\n[mm]", |m| millimetres(Some(m.mean_deviation_m))),
    ("largest\n[mm]", |m| millimetres(Some(m.max_deviation_m))),
    ("from projection\nmean [mm]", |m| millimetres(m.mean_distance_to_projection_m)),
    ("from QP path\nmean | max [mm]", |m| pair(m.mean_distance_to_qp_m, m.max_distance_to_qp_m)),
    ("largest σ\n[mm]", |m| list(&m.max_sigma_m, 1e3)),
    ("largest φ\n[mm]", |m| m.max_phi_m.iter().map(|p| millimetres(*p)).collect::<Vec<_>>().join(" | ")),
    ("acting\n[s]", |m| list(&m.active_s, 1.0)),
    ("back after\n[s]", |m| seconds(m.return_s)),
    ("trapped for\n[s]", |m| seconds(m.escape_s)),
    ("chattering of φ: measured\n≤ bound (eq 22) [mm]", |m| {
        m.chattering.map_or("-".into(), |c| {
            format!("{} ≤ {} ({})", short(1e3 * c.measured), short(1e3 * c.bound), short(1e3 * c.paper_estimate))
        })
    }),
];

fn millimetres(value: Option<f64>) -> String {
    value.map_or("-".into(), |v| short(1e3 * v))
}

fn seconds(value: Option<f64>) -> String {
    value.map_or("-".into(), |v| format!("{v:.3}"))
}

fn pair(a: Option<f64>, b: Option<f64>) -> String {
    a.zip(b).map_or("-".into(), |(a, b)| format!("{} | {}", short(1e3 * a), short(1e3 * b)))
}

fn list(values: &[f64], scale: f64) -> String {
    values.iter().map(|v| short(scale * v)).collect::<Vec<_>>().join(" | ")
}

const NOTE: &str = "Columns with several numbers have one per constraint. Projection: the nearest allowed point to each point of \
                    the reference, the least deviation possible at one instant. Deviations and distances are means over the \
                    whole run.";

/// The comparison as a table with what it means, for a terminal.
pub(crate) fn table(summary: &PathSummary) -> String {
    let mut table = new_table();
    table.set_header(COLUMNS.map(|(title, _)| title));
    for method in &summary.methods {
        table.add_row(COLUMNS.map(|(_, cell)| Cell::new(cell(method))));
    }
    for column in table.column_iter_mut().skip(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    format!(
        "{} - {}\nconstraints: {}\n{table}\n\n{}\n{NOTE}\n{}\n{}\n",
        summary.scenario,
        summary.description,
        summary.constraints.join(" | "),
        audit(summary),
        disturbed(summary),
        summary.verdict.sentence
    )
}

/// A line about what disturbed the conditioner's runs, if anything did.
fn disturbed(summary: &PathSummary) -> String {
    let words =
        |d| format!("note: the runs of the conditioner's forms are disturbed: {d}; the other methods' are not\n");
    summary.disturbances.map(words).unwrap_or_default()
}

/// How the projection was found, and the audit of the sliding mode.
fn audit(summary: &PathSummary) -> String {
    let projection = summary.projection.as_ref().map_or_else(
        || "projection: none, the allowed set is empty somewhere along the reference".into(),
        |p| format!("projection: {}, gap at most {:.1e} m", p.kind, p.worst_gap_m),
    );
    let entry = summary.methods.iter().find(|m| m.method == summary.verdict.method);
    let audit = entry.map_or_else(String::new, |m| {
        let acting: Vec<String> = summary
            .constraints
            .iter()
            .zip(&m.audit.acting_share)
            .map(|(name, share)| format!("{name} in {:.2} %", 100.0 * share))
            .collect();
        format!(
            "audit of the sliding mode, {} samples: {}, reserve in {:.2} %, held in {:.2} %, stopped by a trap in {:.2} %",
            m.audit.samples,
            acting.join(", "),
            100.0 * m.audit.reserve_share,
            100.0 * m.audit.held_share,
            100.0 * m.audit.trapped_share
        )
    });
    format!("{projection}\n{audit}")
}

/// The report of a comparison of path conditioning.
pub(crate) fn render(summary: &PathSummary, scenario: &ConditioningScenario, figures: &[Rendered]) -> String {
    let head: String = COLUMNS.iter().map(|(title, _)| format!("<th>{}</th>", escape(title))).collect();
    let row = |m: &PathMethodSummary| {
        let cells: String = COLUMNS.iter().map(|(_, cell)| format!("<td>{}</td>", escape(&cell(m)))).collect();
        format!("<tr>{cells}</tr>\n")
    };
    let rows: String = summary.methods.iter().map(row).collect();
    let body = format!(
        "<h2>Methods beside the projection</h2>\n<p>Constraints: {}</p>\n<div class=\"wide\"><table>\n<thead><tr>{head}</tr></thead>\n\
         <tbody>\n{rows}</tbody></table></div>\n<p class=\"note\">{NOTE}</p>\n<p class=\"note\">{}</p>\n",
        escape(&summary.constraints.join(" | ")),
        escape(&audit(summary)).replace('\n', "<br>"),
    );
    let page = Page {
        title: &summary.scenario,
        description: &summary.description,
        holds: summary.verdict.holds,
        verdict: &summary.verdict.sentence,
        body,
        figures,
        scenario: Some(scenario.text()),
    };
    page.render()
}
