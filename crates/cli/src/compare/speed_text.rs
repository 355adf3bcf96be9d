//! A comparison of speed laws, for a terminal.

use crate::compare::{effort_table, speed_table};
use crate::say::words::short;
use slideway_compare::{OptimumEntry, SpeedSummary};
use slideway_lab::LimitUse;

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
