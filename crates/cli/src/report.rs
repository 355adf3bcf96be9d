use crate::effort_table;
use crate::summary::{MethodEntry, Summary};
use crate::table::short;
use crate::windows::WindowEntry;
use slideway_figures::Rendered;
use slideway_lab::Scenario;

/// Styles of the report: readable on a phone, in light and in dark.
const STYLE: &str = include_str!("report.css");

/// What every report has, whatever was compared.
pub(crate) struct Page<'a> {
    pub(crate) title: &'a str,
    pub(crate) description: &'a str,
    pub(crate) holds: bool,
    pub(crate) verdict: &'a str,
    /// Tables, as HTML.
    pub(crate) body: String,
    pub(crate) figures: &'a [Rendered],
    /// Text of the scenario file, if there is one.
    pub(crate) scenario: Option<&'a str>,
}

impl Page<'_> {
    /// The report as one file that opens from disk without a network.
    pub(crate) fn render(&self) -> String {
        let title = escape(self.title);
        let figures: String = self.figures.iter().map(figure).collect();
        let file =
            |text| format!("<details><summary>The scenario file</summary><pre>{}</pre></details>\n", escape(text));
        format!(
            "{}<h1>{title}</h1>\n<p>{}</p>\n\
             <p class=\"verdict {}\">{}</p>\n{}\n{figures}\n{}</main>\n</body>\n</html>\n",
            page_head(self.title),
            escape(self.description),
            if self.holds { "holds" } else { "fails" },
            escape(self.verdict),
            self.body,
            self.scenario.map_or_else(String::new, file),
        )
    }
}

/// A page up to its content.
pub(crate) fn page_head(title: &str) -> String {
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<title>{} - slideway</title>\n\
         <style>\n{STYLE}</style>\n</head>\n<body>\n<main>\n",
        escape(title)
    )
}

/// The report of a comparison of speed laws.
pub(crate) fn render_speed(summary: &Summary, scenario: &Scenario, figures: &[Rendered]) -> String {
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
        scenario: Some(scenario.text()),
    };
    page.render()
}

fn methods(entries: &[MethodEntry]) -> String {
    let rows: String = entries.iter().map(method).collect();
    format!(
        "<h2>Speed laws beside the optimum</h2>\n<div class=\"wide\"><table>\n<thead><tr><th>method</th><th>knows in advance</th>\
         <th>reference ends [s]</th><th>motion starts [s]</th><th>robot arrives [s]</th><th>T / T*</th>\
         <th>RMS error [m, rad]</th><th>peak error [mm]</th><th>peak error [mrad]</th><th>largest use of a speed limit</th>\
         <th>chattering</th><th>its bound</th><th>paper's estimate</th></tr></thead>\n<tbody>\n{rows}</tbody></table></div>\n\
         <p class=\"note\">T runs from the start of motion to the <em>robot's</em> arrival (reference at its end, tool within \
         0.1 mm and 1 mrad of it), resolved to one sample. Peak errors and the use of a limit count while the reference moves. Chattering is the \
         largest change of a desired joint speed over one sample, as a share of its limit.</p>\n"
    )
}

fn method(entry: &MethodEntry) -> String {
    let s = &entry.summary;
    let seconds = |value: Option<f64>| value.map_or("never".into(), |v| format!("{v:.4}"));
    let chattering =
        |value: fn(&slideway_lab::Chattering) -> f64| s.chattering.map_or("-".into(), |c| short(value(&c)));
    let cells = [
        s.method.name().to_owned(),
        entry.knows.to_owned(),
        seconds(s.duration_s),
        seconds(s.motion_start_s),
        seconds(s.robot_arrival_s),
        entry.ratio.map_or("-".into(), |r| format!("{r:.4}")),
        format!("{:.4}", s.rms_error_norm),
        short(1e3 * s.peak_path_error_m),
        short(1e3 * s.peak_path_error_rad),
        short(s.limit_ratio_peak),
        chattering(|c| c.measured),
        chattering(|c| c.bound),
        chattering(|c| c.paper_estimate),
    ];
    let cells: String = cells.iter().map(|c| format!("<td>{}</td>", escape(c))).collect();
    format!("<tr>{cells}</tr>\n")
}

/// What each method used of the limits besides constant joint-speed limits; nothing where the scenario gives none.
fn limit_use(summary: &Summary) -> String {
    let item = |entry: &MethodEntry| {
        let uses: Vec<String> = entry.limit_use.iter().map(|u| format!("{} {}", u.kind, short(u.share))).collect();
        (!uses.is_empty()).then(|| format!("<dt>{}</dt><dd>{}</dd>", entry.summary.method, escape(&uses.join(", "))))
    };
    let items: String = summary.methods.iter().filter_map(item).collect();
    if items.is_empty() {
        items
    } else {
        format!("<h2>Largest use of the other limits</h2>\n<p>As shares: 1 is the limit.</p>\n<dl>{items}</dl>\n")
    }
}

/// The look-ahead with windows of several lengths; nothing without acceleration limits.
fn windows(entries: &[WindowEntry]) -> String {
    if entries.is_empty() {
        return String::new();
    }
    let row = |w: &WindowEntry| {
        format!(
            "<tr><td>{} %</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
            100.0 * w.share,
            w.ratio.map_or("never arrives".into(), |r| format!("{r:.4}")),
            short(1e3 * w.peak_path_error_m),
            w.samples_off_path
        )
    };
    let rows: String = entries.iter().map(row).collect();
    format!(
        "<h2>What looking ahead buys</h2>\n<div class=\"wide\"><table>\n<thead><tr><th>window, share of the path</th>\
         <th>T / T*</th><th>peak error [mm]</th><th>samples off the path</th></tr></thead>\n<tbody>\n{rows}</tbody></table></div>\n"
    )
}

fn optimum(summary: &Summary) -> String {
    let block = |name: &str, o: &crate::summary::OptimumEntry| {
        format!(
            "<h2>{name}</h2>\n<dl><dt>certified bounds</dt><dd>[{:.7}, {:.7}] s, relative gap {:.1e}: {}</dd>\
             <dt>grid</dt><dd>{} points; on a grid twice as fine {:.6} s; closed form for speed limits alone {:.6} s</dd>\
             <dt>between grid points</dt><dd>largest violation: {}</dd>\
             <dt>greedy profile</dt><dd>{} by reachability on the same rows: feasible, not the optimum</dd>\
             <dt>solver</dt><dd>{}, says {}, {} iterations, {:.1} ms; the certificate decides, not the status</dd></dl>\n",
            o.lower_s,
            o.upper_s,
            o.gap,
            if o.certified { "certified" } else { "not certified" },
            o.grid_points,
            o.refined_s,
            o.closed_form_speed_s,
            escape(&o.between_in_words()),
            o.greedy_in_words(),
            escape(&o.solver),
            escape(&o.status),
            o.iterations,
            1e3 * o.solve_s,
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

fn figure(figure: &Rendered) -> String {
    format!("<figure>{}<figcaption>{}</figcaption></figure>\n", inline_svg(&figure.svg), escape(&figure.caption))
}

/// A figure's SVG as part of a page: its own colours of paper, ink and grid become the page's, so that they follow the
/// reader's colour scheme.
pub(crate) fn inline_svg(svg: &str) -> String {
    let svg = svg.replace("#FFFFFF", "var(--paper)").replace("#1A1A1A", "var(--ink)").replace("#D9D9D9", "var(--grid)");
    svg.find("<svg").map_or(svg.clone(), |start| svg[start..].to_owned())
}

pub(crate) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
