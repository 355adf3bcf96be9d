//! The page of all published values, with the figures inline.

use super::{Reproduction, Row};
use crate::diagnostic::CliError;
use crate::report::{escape, inline_svg, page_head};
use std::path::Path;

/// Scenarios whose comparison is run, and which of its figures stand on the page.
pub(super) const SHOWN: [(&str, &[&str]); 5] = [
    ("puma-helix", &["path-rate", "joint-speeds"]),
    ("puma-wrist-singularity", &["path-rate-time"]),
    ("helix-plane-sphere", &["conditioned-path", "push"]),
    (
        "natural-2r",
        &["laws-mean-speed", "laws-path-speed", "laws-joint-speeds", "laws-joint-torques", "laws-model-error"],
    ),
    ("natural-pa10", &["laws-mean-speed", "laws-path-speed", "laws-joint-speeds"]),
];

pub(super) fn render(reproduction: &Reproduction, out: &Path) -> Result<String, CliError> {
    let rows: String = reproduction.rows.iter().map(row).collect();
    let mut figures = String::new();
    for (scenario, names) in SHOWN {
        figures += &format!("<h2><a href=\"{scenario}/report.html\">{scenario}</a></h2>\n");
        for name in names {
            let path = out.join(scenario).join("figures").join(name).with_extension("svg");
            let svg = std::fs::read_to_string(&path).map_err(|source| CliError::Write { path, source })?;
            figures += &format!("<figure>{}</figure>\n", inline_svg(&svg));
        }
    }
    Ok(format!(
        "{}<h1>What the papers print, and what comes out here</h1>\n<p class=\"verdict {}\">{}</p>\n<div class=\"wide\"><table class=\"facts\">\n\
         <thead><tr><th>source</th><th>case</th><th>quantity</th><th>paper</th><th>ours</th><th>difference</th><th>agrees</th></tr></thead>\n<tbody>\n{rows}</tbody></table></div>\n\
         <p class=\"note\">Agreement is to one unit of the last printed digit unless the remark says otherwise.</p>\n\
         {figures}</main>\n</body>\n</html>\n",
        page_head("Reproduction"),
        if reproduction.lost == 0 { "holds" } else { "fails" },
        escape(&reproduction.sentence()),
    ))
}

/// A row, and under it the remark, if there is one.
fn row(row: &Row) -> String {
    let [cells @ .., remark] = row.cells().map(|cell| escape(&cell));
    let cells: String = cells.iter().map(|cell| format!("<td>{cell}</td>")).collect();
    let words = if remark.is_empty() {
        remark
    } else {
        format!("<tr class=\"words\"><td></td><td colspan=\"6\">{remark}</td></tr>\n")
    };
    format!("<tr>{cells}</tr>\n{words}")
}
