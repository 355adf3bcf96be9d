//! Speed beside what it costs the drives, for a terminal and for the report.

use crate::say::table::Table;
use crate::say::words::{decimals, escape, short};
use slideway_compare::SpeedSummary;
use slideway_lab::Method;

const HEADER: [&str; 6] = [
    "method",
    "mean speed /\noptimum's",
    "peak joint\nspeed [rad/s]",
    "rms ‖q̈‖\n[rad/s²]",
    "peak torque\n[N·m]",
    "energy\n[J]",
];

const NOTE: &str = "Effort counts once a regulated method, which starts from rest, has reached a limit; the others start at full speed. Energy is the \
integral of Σ|τ q̇|; torques are those of the rigid bodies; a commanded speed that chatters counts with its change over a sample.";

/// Whether the scenario asks for the comparison with the laws of `[N]`.
fn is_asked_for(summary: &SpeedSummary) -> bool {
    summary.methods.iter().any(|m| m.summary.method == Method::NaturalMotion)
}

/// The table for a terminal; empty unless the scenario asks for it.
pub(crate) fn render(summary: &SpeedSummary) -> String {
    if !is_asked_for(summary) {
        return String::new();
    }
    format!("speed and effort under the same joint-speed limits\n{}\n{NOTE}\n", table(summary).terminal())
}

/// The same as HTML.
pub(crate) fn render_html(summary: &SpeedSummary) -> String {
    if !is_asked_for(summary) {
        return String::new();
    }
    let (table, note) = (table(summary).html(), escape(NOTE));
    format!("<h2>Speed and effort under the same joint-speed limits</h2>\n{table}<p class=\"note\">{note}</p>\n")
}

/// A row for each method and one for the optimum.
fn table(summary: &SpeedSummary) -> Table {
    let methods = summary.methods.iter().map(|m| (m.summary.method.name(), m.relative_speed, m.effort.as_ref()));
    let optimum = ("optimum", Some(1.0), summary.optimum_effort.as_ref());
    let number = |value: Option<f64>| value.map_or("-".to_owned(), short);
    let mut table = Table::new(HEADER).numbers(1..HEADER.len());
    for (name, relative_speed, effort) in methods.chain([optimum]) {
        table.row([
            name.to_owned(),
            relative_speed.map_or("-".to_owned(), |v| decimals(v, 4)),
            number(effort.map(|e| e.peak_joint_speed)),
            number(effort.map(|e| e.rms_acceleration)),
            number(effort.and_then(|e| e.peak_torque)),
            number(effort.and_then(|e| e.energy)),
        ]);
    }
    table
}
