//! Speed beside what it costs the drives, for a terminal and for the report.

use crate::output::new_table;
use crate::report::escape;
use crate::summary::Summary;
use crate::table::short;
use comfy_table::CellAlignment;
use slideway_lab::{Effort, Method};

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
fn is_asked_for(summary: &Summary) -> bool {
    summary.methods.iter().any(|m| m.summary.method == Method::NaturalMotion)
}

/// The table for a terminal; empty unless the scenario asks for it.
pub(crate) fn render(summary: &Summary) -> String {
    if !is_asked_for(summary) {
        return String::new();
    }
    let mut table = new_table();
    table.set_header(HEADER);
    rows(summary).into_iter().for_each(|row| {
        table.add_row(row);
    });
    for column in table.column_iter_mut().skip(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    format!("speed and effort under the same joint-speed limits\n{table}\n{NOTE}\n")
}

/// The same as HTML.
pub(crate) fn render_html(summary: &Summary) -> String {
    if !is_asked_for(summary) {
        return String::new();
    }
    let head: String = HEADER.iter().map(|h| format!("<th>{}</th>", escape(&h.replace('\n', " ")))).collect();
    let cells = |row: Vec<String>| -> String { row.iter().map(|c| format!("<td>{}</td>", escape(c))).collect() };
    let rows: String = rows(summary).into_iter().map(|row| format!("<tr>{}</tr>\n", cells(row))).collect();
    format!(
        "<h2>Speed and effort under the same joint-speed limits</h2>\n<div class=\"wide\"><table>\n<thead><tr>{head}</tr></thead>\n\
         <tbody>\n{rows}</tbody></table></div>\n<p class=\"note\">{}</p>\n",
        escape(NOTE)
    )
}

fn rows(summary: &Summary) -> Vec<Vec<String>> {
    let methods = summary.methods.iter().map(|m| row(m.summary.method.name(), m.relative_speed, m.effort.as_ref()));
    methods.chain([row("optimum", Some(1.0), summary.optimum_effort.as_ref())]).collect()
}

fn row(name: &str, relative_speed: Option<f64>, effort: Option<&Effort>) -> Vec<String> {
    let number = |value: Option<f64>| value.map_or("-".to_owned(), short);
    vec![
        name.to_owned(),
        relative_speed.map_or("-".to_owned(), |v| format!("{v:.4}")),
        number(effort.map(|e| e.peak_joint_speed)),
        number(effort.map(|e| e.rms_acceleration)),
        number(effort.and_then(|e| e.peak_torque)),
        number(effort.and_then(|e| e.energy)),
    ]
}
