use super::certificate::interval_times;
use super::error::OptimumError;
use super::piece::PieceProgram;
use super::reachability::positive_greedy;
use crate::outward::Outward;

/// Shares of the limits' ranges by which a profile inside all rows is looked for, the most generous first.
const INSETS: [f64; 5] = [3e-2, 3e-3, 1e-4, 1e-6, 1e-9];

/// Makes a solver's profile feasible: cuts it at the caps and blends it with a profile that keeps all rows with room to spare.
///
/// With `A w < c` for the inner profile `w`, `(1 - θ) x + θ w` keeps `A x <= c` as soon as
/// `θ >= v / (v + r)` in every row that `x` exceeds by `v` and `w` keeps by `r`. The right-hand sides may have any sign, so
/// scaling towards rest would not do. The inner profile is the greedy one under limits that are narrower by a share; the widest
/// share that leaves one is used. Guaranteed: the result satisfies every row and cap, rounding included; as a last resort it is the
/// inner profile itself (claim `repair-feasible`).
///
/// # Errors
///
/// No profile keeps the limits with any room to spare, or the program's limits are kept by no positive profile.
pub fn repair(program: &PieceProgram, answer: &[f64]) -> Result<Vec<f64>, OptimumError> {
    let free = program.free();
    let usable = free.clone().all(|k| is_alone(program, k) || (answer[k] > 0.0 && answer[k].is_finite()));
    let cut: Vec<f64> = (0..program.cap.len())
        .map(|k| {
            // Where no row touches a node its cap is the optimum, whatever the solver says.
            let capped = !free.contains(&k) || is_alone(program, k);
            if capped { program.cap[k] } else { answer[k].min(program.cap[k]) }
        })
        .collect();
    if usable && program.largest_excess(&cut) <= 0.0 {
        return Ok(cut);
    }
    let inner = inner_profile(program)?;
    if !usable {
        return Ok(inner);
    }
    let mut theta = blend_share(program, &cut, &inner);
    // Once would do in exact arithmetic; doubling absorbs the rounding of the blend.
    while theta < 1.0 {
        let blend: Vec<f64> = cut
            .iter()
            .zip(&inner)
            .enumerate()
            .map(|(k, (x, w))| if free.contains(&k) { (x + theta * (w - x)).min(program.cap[k]) } else { *x })
            .collect();
        if program.largest_excess(&blend) <= 0.0 {
            return Ok(blend);
        }
        theta = 2.0 * theta + f64::EPSILON;
    }
    Ok(inner)
}

/// True if no row couples a node with its neighbours or bounds it beyond its cap.
fn is_alone(program: &PieceProgram, node: usize) -> bool {
    let empty = |interval: usize| interval >= program.h.len() || program.interval(interval).is_empty();
    empty(node) && (node == 0 || empty(node - 1))
}

/// A positive profile inside all rows, rounding included.
pub(super) fn inner_profile(program: &PieceProgram) -> Result<Vec<f64>, OptimumError> {
    INSETS
        .iter()
        .filter_map(|&inset| positive_greedy(&program.narrowed(inset)))
        .find(|w| program.largest_excess(w) <= 0.0)
        .ok_or(OptimumError::Unrepairable("no profile keeps the limits with room to spare"))
}

/// A profile well inside all rows: the mean of the inner profile and of the one that is found from the other end.
///
/// A greedy profile takes the most at each node, and where a thin corner of the rows allows that, nearly nothing is left for
/// the next one. Seen from the other end the corner is another one; both keep the rows, which are convex.
pub(super) fn central_profile(program: &PieceProgram) -> Result<Vec<f64>, OptimumError> {
    let onward = inner_profile(program)?;
    let mut back = inner_profile(&program.reversed())?;
    back.reverse();
    let mean: Vec<f64> = onward.iter().zip(&back).map(|(a, b)| 0.5 * (a + b)).collect();
    Ok(if program.largest_excess(&mean) < 0.0 { mean } else { onward })
}

/// The least `θ` that mends every row, up to rounding; 1 if a row cannot be mended.
fn blend_share(program: &PieceProgram, profile: &[f64], inner: &[f64]) -> f64 {
    let mut theta: f64 = 0.0;
    for interval in 0..program.h.len() {
        for strip in program.interval(interval) {
            let excess = strip.excess(profile[interval], profile[interval + 1]);
            if excess > 0.0 {
                let room = -strip.excess(inner[interval], inner[interval + 1]);
                theta = theta.max(if room > 0.0 { excess / (excess + room) } else { 1.0 });
            } else if excess.is_nan() {
                theta = 1.0;
            }
        }
    }
    theta * (1.0 + 1e-9)
}

/// Travel time of a profile, s.
#[must_use]
pub fn feasible_time(program: &PieceProgram, profile: &[f64]) -> Outward {
    interval_times(program, profile).fold(Outward::ZERO, |sum, time| sum + time) * program.unit_time()
}
