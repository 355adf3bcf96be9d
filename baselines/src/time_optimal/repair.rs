use super::certificate::time_and_gradient;
use super::error::OptimumError;
use super::piece::PieceProgram;
use crate::outward::Outward;

/// Makes a solver's profile feasible: cuts it at the caps and scales it down until every row holds in the re-check.
///
/// Rows read `A x <= 1`, so `θ x` keeps them for a small enough `θ`: the largest such `θ` is the inverse of the largest
/// left-hand side. Guaranteed (claim `repair-feasible`): the result satisfies every row and cap, rounding included.
///
/// # Errors
///
/// The answer is not finite, not positive, or so far from feasible that scaling it would make it meaningless.
pub fn repair(program: &PieceProgram, answer: &[f64]) -> Result<Vec<f64>, OptimumError> {
    let free = program.free();
    if !free.clone().all(|k| answer[k] > 0.0 && answer[k].is_finite()) {
        return Err(OptimumError::Unrepairable("the profile is not positive and finite"));
    }
    let cut: Vec<f64> =
        answer.iter().enumerate().map(|(k, &x)| if free.contains(&k) { x.min(program.cap[k]) } else { 0.0 }).collect();
    let mut scale = 1.0;
    // Once would do in exact arithmetic; the loop absorbs the rounding of the products.
    for _ in 0..4 {
        let profile: Vec<f64> = cut.iter().map(|x| x * scale).collect();
        let worst = largest_row(program, &profile);
        if worst <= 1.0 {
            return Ok(profile);
        }
        scale = (scale / worst) * (1.0 - 4.0 * f64::EPSILON);
    }
    Err(OptimumError::Unrepairable("a limit stays exceeded however slow the profile"))
}

/// The largest left-hand side of a row, rounded up; infinite if a number is not finite.
fn largest_row(program: &PieceProgram, profile: &[f64]) -> f64 {
    program
        .rows
        .iter()
        .map(|row| {
            let before = Outward::exact(row.before) * Outward::exact(profile[row.interval]);
            let after = Outward::exact(row.after) * Outward::exact(profile[row.interval + 1]);
            (before + after).hi
        })
        .fold(0.0, |worst: f64, value| if value.is_nan() { f64::INFINITY } else { worst.max(value) })
}

/// Travel time of a profile, s.
#[must_use]
pub fn feasible_time(program: &PieceProgram, profile: &[f64]) -> Outward {
    time_and_gradient(program, profile).0 * program.unit_time()
}
