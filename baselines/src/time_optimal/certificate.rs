use super::piece::PieceProgram;
use crate::outward::Outward;

/// A lower bound on the program's optimum, s, valid for *any* profile `x > 0` and *any* multipliers.
///
/// `T` is convex, so it lies above its tangent at `x̂`. With multipliers `μ >= 0` (negative ones are taken as 0) for the
/// rows `A x <= c`, every feasible `x` has
///
/// ```text
/// T(x) >= T(x̂) + ∇T(x̂)·(x - x̂) + μ·(A x - c)
///      >= T(x̂) - ∇T(x̂)·x̂ - μ·c + Σ_k min over 0 <= x_k <= cap_k of (∇T(x̂) + Aᵀμ)_k x_k
/// ```
///
/// The bounds `c` may have any sign. Ends at given values are no unknowns: the gradient leaves them out, and their box is a
/// point. The minimum over the box is in closed form. Evaluated with outward rounding. Good multipliers make the bound tight,
/// bad ones make it useless, none make it wrong (claim `weak-duality`).
#[must_use]
pub fn lower_bound(program: &PieceProgram, profile: &[f64], multipliers: &[f64]) -> Outward {
    let (time, mut slope) = time_and_gradient(program, profile);
    let mut bound = time;
    for k in program.free() {
        bound = bound - slope[k] * Outward::exact(profile[k]);
    }
    // A row without a multiplier adds exactly nothing; NaN fails the comparison and counts as 0 too.
    for (row, &multiplier) in program.rows().zip(multipliers).filter(|(_, multiplier)| **multiplier > 0.0) {
        let mu = Outward::exact(multiplier);
        bound = bound - mu * Outward::exact(row.bound);
        slope[row.interval] = slope[row.interval] + mu * Outward::exact(row.before);
        slope[row.interval + 1] = slope[row.interval + 1] + mu * Outward::exact(row.after);
    }
    for k in program.free() {
        bound = bound + slope[k].min_zero() * Outward::exact(program.cap[k]);
    }
    for (k, given) in [(0, program.given[0]), (program.cap.len() - 1, program.given[1])] {
        bound = bound + given.map_or(Outward::ZERO, |x| slope[k] * Outward::exact(x));
    }
    bound * program.unit_time()
}

/// `T(x)` in the program's units and its gradient.
///
/// With `r = √x`: `∂/∂x_k of 2 h / (r_k + r_{k+1}) = -h / (r_k (r_k + r_{k+1})²)`.
pub(super) fn time_and_gradient(program: &PieceProgram, profile: &[f64]) -> (Outward, Vec<Outward>) {
    let roots: Vec<Outward> = profile.iter().map(|&x| Outward::exact(x).sqrt()).collect();
    let free = program.free();
    let mut time = Outward::ZERO;
    let mut slope = vec![Outward::ZERO; profile.len()];
    for (k, &h) in program.h.iter().enumerate() {
        let sum = roots[k] + roots[k + 1];
        let h = Outward::exact(h);
        time = time + Outward::exact(2.0) * h / sum;
        let shared = h / (sum * sum);
        for node in [k, k + 1] {
            if free.contains(&node) {
                slope[node] = slope[node] - shared / roots[node];
            }
        }
    }
    (time, slope)
}

/// The time of every interval in the program's units, `2 h / (√x_k + √x_{k+1})`.
pub(super) fn interval_times<'a>(
    program: &'a PieceProgram,
    profile: &[f64],
) -> impl Iterator<Item = Outward> + use<'a> {
    let roots: Vec<Outward> = profile.iter().map(|&x| Outward::exact(x).sqrt()).collect();
    program.h.iter().enumerate().map(move |(k, &h)| Outward::exact(2.0 * h) / (roots[k] + roots[k + 1]))
}
