//! What the figures and the text of `[G11]` sections 4.2 and 4.3 say in numbers.

use super::speed_table::experiment;
use slideway_lab::{Agreement, Method, Published, Trace};
use slideway_scenario::ScenarioError;
use std::f64::consts::PI;

const APPROACH: &str = "read as about 0.9 s: to 0.1 s";
const SAME_TIME: &str = "the paper says that both take the same time, 2π/1.26 s; that leaves less for the path than its certified \
optimum, 4.241 s, after an approach of 0.913 s";
const STANDS: &str = "stands at the singularity: below 1 % of the target rate";

pub(super) fn rows() -> Result<Vec<Published>, ScenarioError> {
    let helix = experiment("puma-helix")?.run(Method::SlidingMode)?;
    let wrist = experiment("puma-wrist-singularity")?.run(Method::SlidingMode)?;
    let row = |source, quantity, unit, paper, ours, tolerance, expected, remark| Published {
        source,
        case: "case 4, sliding-mode".into(),
        quantity,
        unit,
        paper,
        ours,
        tolerance,
        expected,
        remark,
    };
    let (fig_5, text, fig_9) = ("[G11] Fig. 5", "[G11] section 4.2", "[G11] section 4.3, Fig. 9");
    let constant_rate_s = 2.0 * PI / 1.26;
    // The constant rate 3.1 of the other cases reaches λ = π after so long.
    let earlier = reaches(&wrist, PI).map(|t| if t < PI / 3.1 { 1.0 } else { 0.0 });
    Ok(vec![
        row(fig_5, "reference starts", "s", 0.9, helix.motion_start(), 0.1, Agreement::Agrees, APPROACH),
        row(text, "reference ends", "s", constant_rate_s, helix.finish_s, 0.01, Agreement::Differs, SAME_TIME),
        row(fig_9, "path rate at λ = π", "1/s", 0.0, slowest_at(&wrist, PI), 0.12, Agreement::Agrees, STANDS),
        row(fig_9, "λ = π reached before the constant rate (1 yes)", "", 1.0, earlier, 0.0, Agreement::Agrees, ""),
    ])
}

/// When the path parameter first is there, s.
fn reaches(trace: &Trace, lambda: f64) -> Option<f64> {
    trace.samples.iter().find(|s| s.lambda >= lambda).map(|s| s.t)
}

/// Smallest path rate within a tenth of a radian of a place.
fn slowest_at(trace: &Trace, lambda: f64) -> Option<f64> {
    let near = trace.following().iter().filter(|s| (s.lambda - lambda).abs() < 0.1);
    near.map(|s| s.path_rate).min_by(f64::total_cmp)
}
