use crate::effort_table;
use crate::output::new_table;
use crate::summary::{MethodEntry, OptimumEntry, Summary};
use comfy_table::{Cell, CellAlignment};

/// The comparison as a table with what it means, for a terminal.
pub(crate) fn render(summary: &Summary) -> String {
    let mut table = new_table();
    table.set_header([
        "method",
        "reference\nends [s]",
        "motion\nstarts [s]",
        "robot\narrives [s]",
        "T / T*",
        "RMS ‖e‖\n[m, rad]",
        "peak error\n[mm | mrad]",
        "largest\n‖F q̇d‖",
        "chattering: measured\n≤ bound (estimate)",
    ]);
    for method in &summary.methods {
        table.add_row(row(method));
    }
    for column in table.column_iter_mut().skip(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    format!(
        "{}\n{table}\n{}{}\n{}{}\n{}\n",
        heading(summary),
        effort_table::render(summary),
        limit_use(summary),
        optimum(summary),
        windows(summary),
        summary.verdict.sentence
    )
}

fn heading(summary: &Summary) -> String {
    format!("{} - {}", summary.scenario, summary.description)
}

fn row(entry: &MethodEntry) -> Vec<Cell> {
    let s = &entry.summary;
    let number = |value: Option<f64>, digits: usize| value.map_or("-".into(), |v| format!("{v:.digits$}"));
    let chattering = s
        .chattering
        .map_or("-".into(), |c| format!("{} ≤ {} ({})", short(c.measured), short(c.bound), short(c.paper_estimate)));
    [
        s.method.name().to_owned(),
        if s.completed { number(s.duration_s, 4) } else { "never".into() },
        number(s.motion_start_s, 4),
        if s.completed { s.robot_arrival_s.map_or("never".into(), |v| format!("{v:.4}")) } else { "-".into() },
        number(entry.ratio, 4),
        format!("{:.4}", s.rms_error_norm),
        format!("{} | {}", short(1e3 * s.peak_path_error_m), short(1e3 * s.peak_path_error_rad)),
        short(s.limit_ratio_peak),
        chattering,
    ]
    .into_iter()
    .map(Cell::new)
    .collect()
}

/// Four significant digits, without an exponent where it can be avoided.
pub(crate) fn short(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 {
        "0".into()
    } else if size < 1e-4 {
        format!("{value:.1e}")
    } else if size < 10.0 {
        format!("{value:.4}")
    } else if size < 1000.0 {
        format!("{value:.1}")
    } else {
        format!("{value:.3e}")
    }
}

/// What acceleration limits cost and looking ahead buys; empty without such limits.
fn windows(summary: &Summary) -> String {
    let mut text = String::new();
    for entry in &summary.methods {
        if let Some(off) = entry.summary.samples_off_path {
            text += &format!(
                "{}: {off} samples off the path, up to {} mm from the path's end\n",
                entry.summary.method,
                short(1e3 * entry.summary.peak_end_error_m)
            );
        }
    }
    for w in &summary.look_ahead {
        let ratio = w.ratio.map_or("never arrives".into(), |r| format!("T / T* {r:.4}"));
        text += &format!(
            "look-ahead over {:>3} % of the path: {ratio}, path error {} mm, {} samples off the path\n",
            100.0 * w.share,
            short(1e3 * w.peak_path_error_m),
            w.samples_off_path
        );
    }
    text
}

/// What each method used of the limits besides constant joint-speed limits, one line a method.
fn limit_use(summary: &Summary) -> String {
    let line = |entry: &MethodEntry| {
        let uses: Vec<String> = entry.limit_use.iter().map(|u| format!("{} {}", u.kind, short(u.share))).collect();
        (!uses.is_empty()).then(|| format!("  {:26} {}\n", entry.summary.method.name(), uses.join(", ")))
    };
    let lines: String = summary.methods.iter().filter_map(line).collect();
    if lines.is_empty() { lines } else { format!("largest use of the other limits (1 is the limit)\n{lines}") }
}

fn optimum(summary: &Summary) -> String {
    let mut text = optimum_line("optimum T*", &summary.optimum);
    for note in summary.notes() {
        text += &format!("note: {note}\n");
    }
    if let Some(speed_only) = &summary.optimum_speed_only {
        text += &optimum_line("under speed limits alone", speed_only);
    }
    text += "T / T* runs from the start of motion to the robot's arrival; errors and ‖F q̇d‖ count while the reference moves; times are resolved to one sample.\n";
    text
}

fn optimum_line(name: &str, o: &OptimumEntry) -> String {
    format!(
        "{name} in [{:.7}, {:.7}] s, {} (gap {:.1e}, {} grid points, {} solver says {}, {:.1} ms)\n  \
         closed form for speed limits {:.6} s, grid twice as fine {:.6} s, greedy profile {}\n  \
         largest violation between grid points: {}\n",
        o.lower_s,
        o.upper_s,
        if o.certified { "certified" } else { "NOT certified" },
        o.gap,
        o.grid_points,
        o.solver,
        o.status,
        1e3 * o.solve_s,
        o.closed_form_speed_s,
        o.refined_s,
        o.greedy_in_words(),
        o.between_in_words(),
    )
}
