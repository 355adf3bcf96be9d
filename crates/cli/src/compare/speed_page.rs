//! The page of a comparison of speed laws.

use crate::compare::{effort_table, speed_table, speed_text};
use crate::say::page::Page;
use crate::say::table::{Column, Table};
use crate::say::words::{decimals, escape, short};
use slideway_compare::{MethodEntry, OptimumEntry, SpeedSummary, WindowEntry, WorstCell};
use slideway_figures::Rendered;

/// The report of a comparison of speed laws.
pub(crate) fn render(summary: &SpeedSummary, text: &str, figures: &[Rendered]) -> String {
    let page = Page {
        title: &summary.scenario,
        description: &summary.description,
        holds: summary.verdict.holds,
        verdict: &summary.verdict.sentence,
        body: methods(&summary.methods)
            + &effort_table::render_html(summary)
            + &optimum(summary)
            + &windows(&summary.look_ahead),
        figures,
        scenario: Some(text),
    };
    page.render()
}

fn methods(entries: &[MethodEntry]) -> String {
    format!(
        "<h2>Speed laws beside the optimum</h2>\n{}\
         <p class=\"note\">T runs from the start of motion to the <em>robot's</em> arrival (reference at its end, tool within \
         0.1 mm and 1 mrad of it), resolved to one sample. Peak errors and ‖F q̇d‖, the use of a speed limit, count while the reference \
         moves. Chattering is the largest change of a desired joint speed over one sample, as a share of its limit; beside it stand its \
         bound and the paper's estimate.</p>\n",
        speed_table::methods(entries).html()
    )
}

/// The largest use that each method made of the limits besides constant joint-speed limits; nothing where there are none.
fn limit_use(summary: &SpeedSummary) -> String {
    let item = |(method, uses): (&str, String)| format!("<dt>{method}</dt><dd>{}</dd>", escape(&uses));
    let items: String = speed_text::limit_uses(summary).map(item).collect();
    if items.is_empty() {
        items
    } else {
        format!("<h2>Largest use of the other limits</h2>\n<p>As shares: 1 is the limit.</p>\n<dl>{items}</dl>\n")
    }
}

const WINDOWS: [Column<WindowEntry>; 4] = [
    ("window, share of the path", |w| format!("{} %", 100.0 * w.share)),
    ("T / T*", |w| w.ratio.map_or("never arrives".into(), |r| decimals(r, 4))),
    ("peak error [mm]", |w| short(1e3 * w.peak_path_error_m)),
    ("samples off the path", |w| w.samples_off_path.to_string()),
];

const CELLS: [Column<WorstCell>; 3] = [
    ("path parameter", |c| format!("{:.6} to {:.6}", c.lambda[0], c.lambda[1])),
    ("part of the gap [s]", |c| format!("{:.1e}", c.gap_s)),
    ("limit used most", |c| match (c.limit, &c.joint) {
        (Some(limit), Some(joint)) => format!("{limit} of {joint}"),
        _ => "-".into(),
    }),
];

/// The look-ahead with windows of several lengths; nothing without acceleration limits.
fn windows(entries: &[WindowEntry]) -> String {
    if entries.is_empty() {
        return String::new();
    }
    format!("<h2>What looking ahead buys</h2>\n{}", Table::of(&WINDOWS, entries).html())
}

/// The cells that hold most of the gap; nothing on a grid.
fn worst_cells(optimum: &OptimumEntry) -> String {
    if optimum.worst_cells.is_empty() {
        return String::new();
    }
    let table = Table::of(&CELLS, &optimum.worst_cells).html();
    format!("<details><summary>Where the gap is: the cells that hold most of it</summary>\n{table}</details>\n")
}

fn optimum(summary: &SpeedSummary) -> String {
    let block = |name: &str, o: &OptimumEntry| {
        let remarks: String =
            speed_text::optimum_remarks(o).iter().map(|line| format!("<li>{}</li>", escape(line))).collect();
        format!(
            "<h2>{name}</h2>\n<dl><dt>bounds</dt><dd>[{:.7}, {:.7}] s, relative gap {:.1e}: {} {}</dd>\
             <dt>how</dt><dd>{}{} solver, {:.1} ms; the certificate decides, not the solver</dd></dl>\n<ul>{remarks}</ul>\n{}",
            o.lower_s,
            o.upper_s,
            o.gap,
            if o.certified { "certified" } else { "not certified" },
            o.certified_for.words(),
            o.cells.map_or_else(String::new, |cells| format!("{cells} cells, ")),
            escape(&o.solver),
            1e3 * o.solve_s,
            worst_cells(o),
        )
    };
    let main = block("The optimum", &summary.optimum);
    let speed_only = summary
        .optimum_speed_only
        .as_ref()
        .map_or_else(String::new, |o| block("The optimum under speed limits alone", o));
    let notes: String = summary.notes().iter().map(|note| format!("<li>{}</li>", escape(note))).collect();
    let notes = if notes.is_empty() { notes } else { format!("<h2>The joint path</h2>\n<ul>{notes}</ul>\n") };
    limit_use(summary) + &main + &speed_only + &notes
}
