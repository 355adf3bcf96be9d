//! The page of all published values, with the figures inline.

use crate::reproduce::rows::Reproduction;
use crate::say::diagnostic::CliError;
use crate::say::page::{inline_svg, page_head};
use crate::say::words::escape;
use std::path::Path;

/// Scenarios whose comparison is run, and which of its figures stand on the page.
pub(super) const SHOWN: [(&str, &[&str]); 8] = [
    ("puma-helix", &["path-rate", "joint-speeds"]),
    ("puma-wrist-singularity", &["path-rate-time"]),
    ("helix-plane-sphere", &["conditioned-path", "push"]),
    // [G12] figures 5 to 10, two each.
    ("trap-ellipsoid", &["conditioned-path", "trap"]),
    ("trap-two-ellipsoids", &["conditioned-path", "trap"]),
    ("trap-booth-oval", &["conditioned-path", "trap"]),
    (
        "natural-2r",
        &["laws-mean-speed", "laws-path-speed", "laws-joint-speeds", "laws-joint-torques", "laws-model-error"],
    ),
    ("natural-pa10", &["laws-mean-speed", "laws-path-speed", "laws-joint-speeds"]),
];

pub(super) fn render(reproduction: &Reproduction, out: &Path) -> Result<String, CliError> {
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
        "{}<h1>What the papers print, and what comes out here</h1>\n<p class=\"verdict {}\">{}</p>\n{}\
         <p class=\"note\">Agreement is to one unit of the last printed digit unless the remark says otherwise.</p>\n\
         {figures}</main>\n</body>\n</html>\n",
        page_head("Reproduction"),
        if reproduction.lost == 0 { "holds" } else { "fails" },
        escape(&reproduction.sentence()),
        reproduction.table().last_as_words().html(),
    ))
}
