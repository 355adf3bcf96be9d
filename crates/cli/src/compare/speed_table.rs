//! The table of speed laws beside the optimum.

use crate::say::table::{Column, Table};
use crate::say::words::{decimals, short};
use slideway_compare::MethodEntry;

const COLUMNS: [Column<MethodEntry>; 9] = [
    ("method", |m| m.summary.method.name().to_owned()),
    ("reference\nends [s]", |m| if m.summary.completed { seconds(m.summary.duration_s) } else { "never".into() }),
    ("motion\nstarts [s]", |m| seconds(m.summary.motion_start_s)),
    ("robot\narrives [s]", arrival),
    ("T / T*", |m| seconds(m.ratio)),
    ("RMS ‖e‖\n[m, rad]", |m| decimals(m.summary.rms_error_norm, 4)),
    ("peak error\n[mm | mrad]", |m| {
        let s = &m.summary;
        format!("{} | {}", short(1e3 * s.peak_path_error_m), short(1e3 * s.peak_path_error_rad))
    }),
    ("largest\n‖F q̇d‖", |m| short(m.summary.limit_ratio_peak)),
    ("chattering: measured\n≤ bound (estimate)", |m| {
        let words = |c| {
            let slideway_lab::Chattering { measured, bound, paper_estimate } = c;
            format!("{} ≤ {} ({})", short(measured), short(bound), short(paper_estimate))
        };
        m.summary.chattering.map_or("-".into(), words)
    }),
];

fn seconds(value: Option<f64>) -> String {
    value.map_or("-".into(), |v| decimals(v, 4))
}

fn arrival(entry: &MethodEntry) -> String {
    match entry.summary.robot_arrival_s {
        None if entry.summary.completed => "never".into(),
        arrival => seconds(arrival.filter(|_| entry.summary.completed)),
    }
}

/// A row a method; what each knows in advance stands below it on a page.
pub(crate) fn methods(entries: &[MethodEntry]) -> Table {
    let mut table = Table::of(&COLUMNS, []);
    for entry in entries {
        table.row(COLUMNS.map(|(_, cell)| cell(entry))).words(format!("knows in advance: {}", entry.knows));
    }
    table
}
