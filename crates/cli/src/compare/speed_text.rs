//! A comparison of speed laws, for a terminal.

use crate::compare::{effort_table, speed_table};
use crate::say::words::{decimals, short};
use slideway_compare::{OptimumEntry, SpeedSummary};
use slideway_lab::LimitUse;
use slideway_path::SplineDeviation;

/// The comparison as tables with what they mean.
pub(crate) fn render(summary: &SpeedSummary) -> String {
    format!(
        "{} - {}\n{}\n{}{}\n{}{}\n{}\n",
        summary.scenario,
        summary.description,
        speed_table::methods(&summary.methods).terminal(),
        effort_table::render(summary),
        limit_use(summary),
        optimum(summary),
        windows(summary),
        summary.verdict.sentence
    )
}

/// What acceleration limits cost and looking ahead buys; empty without such limits.
fn windows(summary: &SpeedSummary) -> String {
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
        let ratio = w.ratio.map_or("never arrives".into(), |r| format!("T / T* {}", decimals(r, 4)));
        text += &format!(
            "look-ahead over {:>3} % of the path: {ratio}, path error {} mm, {} samples off the path\n",
            100.0 * w.share,
            short(1e3 * w.peak_path_error_m),
            w.samples_off_path
        );
    }
    text
}

/// Each method's name with its largest use of the limits besides constant joint-speed limits; those that have such uses.
pub(crate) fn limit_uses(summary: &SpeedSummary) -> impl Iterator<Item = (&'static str, String)> {
    summary.methods.iter().filter(|m| !m.limit_use.is_empty()).map(|m| {
        let joint = |u: &LimitUse| u.joint.as_ref().map(|joint| format!(" ({joint})")).unwrap_or_default();
        let uses: Vec<String> =
            m.limit_use.iter().map(|u| format!("{} {}{}", u.kind, short(u.share), joint(u))).collect();
        (m.summary.method.name(), uses.join(", "))
    })
}

fn limit_use(summary: &SpeedSummary) -> String {
    let lines: String = limit_uses(summary).map(|(method, uses)| format!("  {method:26} {uses}\n")).collect();
    if lines.is_empty() { lines } else { format!("largest use of the other limits (1 is the limit)\n{lines}") }
}

fn optimum(summary: &SpeedSummary) -> String {
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
    let mut text = format!(
        "{name} in [{:.7}, {:.7}] s, {} {} (gap {:.1e}{}, {} solver, {:.1} ms)\n",
        o.lower_s,
        o.upper_s,
        if o.certified { "certified" } else { "NOT certified" },
        o.certified_for.words(),
        o.gap,
        o.cells.map_or_else(String::new, |cells| format!(", {cells} cells")),
        o.solver,
        1e3 * o.solve_s,
    );
    for line in optimum_remarks(o) {
        text += &format!("  {line}\n");
    }
    text
}

/// What is to be said of an optimum besides its bounds, a line each.
pub(crate) fn optimum_remarks(o: &OptimumEntry) -> Vec<String> {
    let grid = &o.on_grid;
    let mut lines: Vec<String> =
        o.nodes_because.iter().map(|why| format!("at {} nodes only: {why}", grid.grid_points)).collect();
    if let Some(stop) = o.stop.filter(|_| !o.certified) {
        lines.push(format!("the bounds are as near as they came: {stop}"));
    }
    lines.extend(o.spline.map(|spline| {
        let SplineDeviation { joint, tool_m, tool_rad, points } = spline;
        format!(
            "of the spline through {points} points of the path, which is what a robot is sent; between them at most {} rad (m) of a joint, {} mm and {} mrad of the tool \
             away, as sampled",
            short(joint),
            short(1e3 * tool_m),
            short(1e3 * tool_rad)
        )
    }));
    if o.nodes_because.is_none() {
        lines.push(format!(
            "on a grid of {} points in [{:.7}, {:.7}] s: what holds at its nodes alone",
            grid.grid_points, grid.lower_s, grid.upper_s
        ));
    }
    lines.push(format!(
        "on the grid: {} solver says {}, {} iterations, {:.1} ms; on one twice as fine {:.6} s; greedy profile {}",
        grid.solver,
        grid.status,
        grid.iterations,
        1e3 * grid.solve_s,
        grid.refined_s,
        grid.greedy_in_words()
    ));
    lines.push(format!("on the grid: largest violation between its points: {}", grid.between_in_words()));
    lines.push(format!("closed form for speed limits alone {:.6} s", o.closed_form_speed_s));
    lines
}
