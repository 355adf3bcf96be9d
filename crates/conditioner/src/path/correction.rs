use super::vector::{add_scaled, dot};

/// The smallest vector inside a few half-spaces, with the multipliers that certify it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Correction<const N: usize, const M: usize> {
    /// `u`, the point nearest to the origin.
    pub(crate) vector: [f64; N],
    /// `λ >= 0` with `u = -Σ λ_i g_i`, and `λ_i > 0` only where `g_iᵀ u = b_i`.
    pub(crate) multipliers: [f64; M],
}

/// Why there is no smallest vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NoCorrection {
    /// This half-space cannot be reached while the others hold.
    Contradiction(usize),
    /// The steps are used up: rounding made the method cycle.
    Cycling,
}

/// Worst-case number of active-set steps of the smallest correction into `m` half-spaces, per linearisation (at most 13).
///
/// The dual objective grows strictly from one complete step to the next, so no active set comes back: there are at most
/// `2^m` of them, and each complete step drops at most `m` members on its way. In practice it takes one step for every
/// constraint that acts. The count saturates.
#[must_use]
pub const fn largest_step_count(m: usize) -> u32 {
    let sets = if m < 24 { 1_u32 << m } else { 1 << 24 };
    let each = if m < 64 { m as u32 + 1 } else { 64 };
    sets.saturating_mul(each)
}

/// Minimises `‖u‖²` subject to `g_iᵀ u <= b_i`: the dual active-set method of Goldfarb and Idnani (1983) with a unit
/// Hessian, started from the free optimum `u = 0`.
///
/// First the closed form is tried in which exactly the half-spaces that exclude the origin act, `u = -Gᵀ λ` with
/// `G Gᵀ λ = -b`: if no multiplier is negative and no half-space violated, it is the answer. That is nearly always so
/// from one sample to the next, and with one half-space it is `u = g b / gᵀg`. Allocation-free.
#[inline]
pub(crate) fn smallest_correction<const N: usize, const M: usize>(
    rows: &[[f64; N]; M],
    bounds: &[f64; M],
) -> Result<Correction<N, M>, NoCorrection> {
    // [G12] eq 19: its solution of least length.
    let mut set = ActiveSet::of_violated(rows, bounds);
    if set.is_optimal(rows, bounds) {
        return Ok(Correction { vector: set.u, multipliers: set.multipliers });
    }
    set = ActiveSet { u: [0.0; N], multipliers: [0.0; M], active: [false; M] };
    let mut steps = 0;
    while let Some(entering) = set.most_violated(rows, bounds) {
        set.enter(entering, rows, bounds, &mut steps)?;
    }
    Ok(Correction { vector: set.u, multipliers: set.multipliers })
}

struct ActiveSet<const N: usize, const M: usize> {
    u: [f64; N],
    multipliers: [f64; M],
    active: [bool; M],
}

/// Event that ends a step towards the entering constraint.
enum Block {
    /// A multiplier reaches zero: this constraint leaves.
    Dual(usize),
    /// The entering constraint is met.
    Primal,
}

/// Share of `‖g‖²` below which a normal counts as dependent on the active ones: its square root, 1e-7, is the sine of the
/// angle between them, and is what rounding of 1e-16 leaves certain of a squared length.
const DEPENDENT: f64 = 1e-14;

/// Relative error of an equation that counts as solved: some 10 roundings, times a condition of up to 1e2. Worse
/// conditioned sets are left to the method that drops constraints.
const MET: f64 = 1e-13;

/// Violations below this share of the row's own terms are rounding: a few additions of relative error 1.1e-16.
const ROUNDING: f64 = 1e-15;

impl<const N: usize, const M: usize> ActiveSet<N, M> {
    /// The solution of the equations of all half-spaces that exclude the origin. NaN where they depend on one another.
    #[inline]
    fn of_violated(rows: &[[f64; N]; M], bounds: &[f64; M]) -> Self {
        let active = bounds.map(|b| b < 0.0);
        let multipliers = solve_gram(rows, &active, &bounds.map(|b| -b));
        let mut u = [0.0; N];
        for (row, m) in rows.iter().zip(&multipliers) {
            // [G12] eq 16 where one constraint acts.
            u = add_scaled(&u, -m, row);
        }
        Self { u, multipliers, active }
    }

    /// The optimality conditions, each written so that a NaN fails it.
    #[inline]
    fn is_optimal(&self, rows: &[[f64; N]; M], bounds: &[f64; M]) -> bool {
        let square = dot(&self.u, &self.u);
        let met = rows.iter().zip(bounds).zip(&self.active).all(|((row, &bound), &member)| {
            let miss = dot(row, &self.u) - bound;
            !member || miss * miss <= MET * MET * (dot(row, row) * square + bound * bound)
        });
        met && square.is_finite()
            && self.multipliers.iter().all(|&m| m >= 0.0)
            && self.most_violated(rows, bounds).is_none()
    }

    /// Largest distance, in units of `‖u‖`, among the violated half-spaces.
    fn most_violated(&self, rows: &[[f64; N]; M], bounds: &[f64; M]) -> Option<usize> {
        let mut worst = None;
        let mut depth = 0.0;
        let square = dot(&self.u, &self.u);
        for (i, ((row, &bound), &member)) in rows.iter().zip(bounds).zip(&self.active).enumerate() {
            let excess = dot(row, &self.u) - bound;
            if member || excess <= 0.0 {
                continue;
            }
            // Squares throughout: no roots. An empty row that asks for something is infinitely deep.
            let length = dot(row, row);
            let noise = ROUNDING * ROUNDING * (length * square + bound * bound);
            if excess * excess > noise && excess * excess > depth * length {
                (worst, depth) = (Some(i), excess * excess / length);
            }
        }
        worst
    }

    /// Brings one violated constraint into the active set, dropping those that block the way.
    fn enter(
        &mut self,
        entering: usize,
        rows: &[[f64; N]; M],
        bounds: &[f64; M],
        steps: &mut u32,
    ) -> Result<(), NoCorrection> {
        let (Some(normal), Some(&bound)) = (rows.get(entering), bounds.get(entering)) else {
            return Err(NoCorrection::Cycling);
        };
        let mut gained = 0.0;
        loop {
            *steps += 1;
            if *steps > largest_step_count(M) {
                return Err(NoCorrection::Cycling);
            }
            let (dual, primal) = self.directions(rows, normal);
            let (length, block) = self.step_length(&dual, &primal, normal, bound);
            if !length.is_finite() {
                return Err(NoCorrection::Contradiction(entering));
            }
            self.u = add_scaled(&self.u, -length, &primal);
            gained += length;
            for ((m, r), &active) in self.multipliers.iter_mut().zip(&dual).zip(&self.active) {
                *m = if active { (*m - length * r).max(0.0) } else { 0.0 };
            }
            match block {
                Block::Dual(leaving) => self.set_member(leaving, 0.0, false),
                Block::Primal => {
                    self.set_member(entering, gained, true);
                    return Ok(());
                }
            }
        }
    }

    fn set_member(&mut self, i: usize, multiplier: f64, active: bool) {
        if let (Some(m), Some(a)) = (self.multipliers.get_mut(i), self.active.get_mut(i)) {
            (*m, *a) = (multiplier, active);
        }
    }

    /// Dual direction `r = (G_W G_Wᵀ)⁻¹ G_W g` and primal direction `z = g - G_Wᵀ r`, which is `g` made orthogonal to `W`.
    fn directions(&self, rows: &[[f64; N]; M], normal: &[f64; N]) -> ([f64; M], [f64; N]) {
        if !self.active.contains(&true) {
            return ([0.0; M], *normal);
        }
        let dual =
            solve_gram(rows, &self.active, &core::array::from_fn(|i| rows.get(i).map_or(0.0, |g| dot(g, normal))));
        let mut primal = *normal;
        for (row, r) in rows.iter().zip(&dual) {
            primal = add_scaled(&primal, -r, row);
        }
        (dual, primal)
    }

    fn step_length(&self, dual: &[f64; M], primal: &[f64; N], normal: &[f64; N], bound: f64) -> (f64, Block) {
        let reach = dot(primal, primal);
        let full = (dot(normal, &self.u) - bound) / reach;
        // A NaN compares false and ends as an infinite step: a contradiction, never a wrong answer.
        let independent = reach > DEPENDENT * dot(normal, normal);
        let mut best = (if independent { full } else { f64::INFINITY }, Block::Primal);
        for (i, ((&m, &r), &active)) in self.multipliers.iter().zip(dual).zip(&self.active).enumerate() {
            if active && r > 0.0 && m / r < best.0 {
                best = (m / r, Block::Dual(i));
            }
        }
        best
    }
}

/// Solves the Gram system of the active rows; the others are replaced by rows of the identity.
///
/// The active rows are independent by construction, so the matrix is positive definite.
fn solve_gram<const N: usize, const M: usize>(rows: &[[f64; N]; M], active: &[bool; M], right: &[f64; M]) -> [f64; M] {
    let mut gram = [[0.0; M]; M];
    for (i, line) in gram.iter_mut().enumerate() {
        for (j, entry) in line.iter_mut().enumerate() {
            let inside = active[i] && active[j];
            *entry = if inside { dot(&rows[i], &rows[j]) } else { f64::from(u8::from(i == j)) };
        }
    }
    let mut x = *right;
    for (x, &a) in x.iter_mut().zip(active) {
        *x = if a { *x } else { 0.0 };
    }
    eliminate(&mut gram, &mut x);
    x
}

/// Gauss-Jordan elimination on the diagonal, in place: stable without pivoting for positive definite matrices.
fn eliminate<const M: usize>(matrix: &mut [[f64; M]; M], right: &mut [f64; M]) {
    for k in 0..M {
        let pivot = matrix[k][k];
        let pivot_line = matrix[k].map(|entry| entry / pivot);
        let pivot_right = right[k] / pivot;
        for (line, r) in matrix.iter_mut().zip(right.iter_mut()) {
            let factor = line[k];
            for (entry, p) in line.iter_mut().zip(&pivot_line) {
                *entry -= factor * p;
            }
            *r -= factor * pivot_right;
        }
        matrix[k] = pivot_line;
        right[k] = pivot_right;
    }
}

#[cfg(test)]
mod tests;
