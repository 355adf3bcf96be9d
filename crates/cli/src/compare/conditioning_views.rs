//! A comparison of path conditioners, for a terminal and as a page.

use crate::say::page::Page;
use crate::say::table::{Column, Table};
use crate::say::words::{decimals, escape, short};
use slideway_compare::{ConditioningSummary, PathMethodEntry};
use slideway_figures::Rendered;
use slideway_lab::conditioning::PathMethod;

const COLUMNS: [Column<PathMethodEntry>; 13] = [
    ("method", |m| m.summary.method.name().to_owned()),
    ("mean deviation\n[mm]", |m| millimetres(Some(m.summary.mean_deviation_m))),
    ("largest\n[mm]", |m| millimetres(Some(m.summary.max_deviation_m))),
    ("from projection\nmean [mm]", |m| millimetres(m.summary.mean_distance_to_projection_m)),
    ("from QP path\nmean | max [mm]", |m| pair(m.summary.mean_distance_to_qp_m, m.summary.max_distance_to_qp_m)),
    ("largest σ\n[mm]", |m| list(&m.summary.max_sigma_m, 1e3)),
    ("largest φ\n[mm]", |m| m.summary.max_phi_m.iter().map(|p| millimetres(*p)).collect::<Vec<_>>().join(" | ")),
    ("acting\n[s]", |m| list(&m.summary.active_s, 1.0)),
    ("back after\n[s]", |m| seconds(m.summary.return_s)),
    ("ends off\n[mm]", |m| millimetres(m.arrival.end_distance_m)),
    ("arrives after\n[s]", |m| seconds(m.arrival.arrives_after_s)),
    ("trapped for\n[s]", |m| seconds(Some(m.arrival.trapped_s).filter(|t| *t > 0.0))),
    ("chattering of φ: measured\n≤ bound (eq 22) [mm]", |m| {
        m.summary.chattering.map_or("-".into(), |c| {
            format!("{} ≤ {} ({})", short(1e3 * c.measured), short(1e3 * c.bound), short(1e3 * c.paper_estimate))
        })
    }),
];

fn millimetres(value: Option<f64>) -> String {
    value.map_or("-".into(), |v| short(1e3 * v))
}

fn seconds(value: Option<f64>) -> String {
    value.map_or("-".into(), |v| decimals(v, 3))
}

fn pair(a: Option<f64>, b: Option<f64>) -> String {
    a.zip(b).map_or("-".into(), |(a, b)| format!("{} | {}", short(1e3 * a), short(1e3 * b)))
}

fn list(values: &[f64], scale: f64) -> String {
    values.iter().map(|v| short(scale * v)).collect::<Vec<_>>().join(" | ")
}

const NOTE: &str = "Columns with several numbers have one per constraint. Projection: the nearest allowed point to each point of \
                    the reference, the least deviation possible at one instant. Deviations and distances are means over the \
                    whole run. Ends off: from the nearest allowed point to the reference's end, when the reference arrives; arrives \
                    after: how long after the reference the conditioned point is there, the reference at rest.";

/// The comparison as a table with what it means, for a terminal.
pub(crate) fn table(summary: &ConditioningSummary) -> String {
    let table = Table::of(&COLUMNS, &summary.methods).terminal();
    format!(
        "{} - {}\nconstraints: {}\n{table}\n\n{}\n{NOTE}\n{}{}\n{}\n",
        summary.scenario,
        summary.description,
        summary.constraints.join(" | "),
        audit(summary),
        diverged(summary),
        disturbed(summary),
        summary.verdict.sentence
    )
}

/// A line about what disturbed the conditioner's runs, if anything did.
fn disturbed(summary: &ConditioningSummary) -> String {
    let words =
        |d| format!("note: the runs of the conditioner's forms are disturbed: {d}; the other methods' are not\n");
    summary.disturbances.map(words).unwrap_or_default()
}

/// A line about a potential field that could not be followed, if there was such a place.
fn diverged(summary: &ConditioningSummary) -> String {
    let field = summary.methods.iter().map(|m| &m.summary).find(|m| m.method == PathMethod::PotentialField);
    let held = field.map_or(0.0, |field| field.audit.held_share);
    if held > 0.0 {
        let share = decimals(100.0 * held, 2);
        format!(
            "note: the potential field crossed a boundary or could not be followed, and was held for {share} % of the samples\n"
        )
    } else {
        String::new()
    }
}

/// How the projection was found, and the audit of the sliding mode.
fn audit(summary: &ConditioningSummary) -> String {
    let projection = summary.projection.as_ref().map_or_else(
        || "projection: none, the allowed set is empty somewhere along the reference".into(),
        |p| format!("projection: {}, gap at most {:.1e} m", p.kind, p.worst_gap_m),
    );
    let entry = summary.methods.iter().map(|m| &m.summary).find(|m| m.method == summary.verdict.method);
    let audit = entry.map_or_else(String::new, |m| {
        let acting: Vec<String> = summary
            .constraints
            .iter()
            .zip(&m.audit.acting_share)
            .map(|(name, share)| format!("{name} in {} %", decimals(100.0 * share, 2)))
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
pub(crate) fn render(summary: &ConditioningSummary, text: &str, figures: &[Rendered]) -> String {
    let body = format!(
        "<h2>Methods beside the projection</h2>\n<p>Constraints: {}</p>\n{}<p class=\"note\">{NOTE}</p>\n<p class=\"note\">{}</p>\n",
        escape(&summary.constraints.join(" | ")),
        Table::of(&COLUMNS, &summary.methods).html(),
        escape(format!("{}\n{}", audit(summary), diverged(summary)).trim_end()).replace('\n', "<br>"),
    );
    let page = Page {
        title: &summary.scenario,
        description: &summary.description,
        holds: summary.verdict.holds,
        verdict: &summary.verdict.sentence,
        body,
        figures,
        scenario: Some(text),
    };
    page.render()
}
