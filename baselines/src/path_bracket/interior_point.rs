//! Travel time of quadratic cells, minimised under their rows by a primal-dual interior point.
//!
//! Unknowns `x = b / unit` interleaved: node, middle, node, ... so that cell `k` sees `x[2k..2k + 3]`.
//!
//! ```text
//! minimise  f(x) = sum_k h_k sum_i w_i b_k(t_i)^(-1/2)     4 Lobatto points a cell: both ends and (1 ± 1/√5)/2, weights 1/12, 5/12
//! subject to  row · x_cell <= 1
//! ```
//!
//! The objective is a guide only: what is reported is the closed form of the profile's time. It grows without bound where `b` tends to 0 at a
//! Lobatto point, so nothing else keeps `b > 0`. Predictor and corrector by Mehrotra, SIAM J. Optim. 2 (1992); the matrix is a chain of 3×3 blocks
//! ([`super::chain`]). After long runs rounding spoils the dual residual while the complementarity still falls: the iterate with the least sum of
//! complementarity and residuals is returned, and the run ends when that sum is 100 times its best.

use super::chain::ChainFactor;
use super::rows::value;

/// Weights of the four Lobatto points.
pub(crate) const WEIGHTS: [f64; 4] = [1.0 / 12.0, 5.0 / 12.0, 5.0 / 12.0, 1.0 / 12.0];
const INNER: f64 = 0.276_393_202_250_021;
/// Bernstein quadratics at the four Lobatto points.
pub(crate) const FORMS: [[f64; 3]; 4] = [
    [1.0, 0.0, 0.0],
    [(1.0 - INNER) * (1.0 - INNER), 2.0 * INNER * (1.0 - INNER), INNER * INNER],
    [INNER * INNER, 2.0 * INNER * (1.0 - INNER), (1.0 - INNER) * (1.0 - INNER)],
    [0.0, 0.0, 1.0],
];

/// Cells and rows.
#[derive(Clone, Debug, Default)]
pub(crate) struct Program {
    /// Length of a cell over the root of the unit of `b`, s.
    pub(crate) lengths: Vec<f64>,
    /// Index of the first row of each cell, and the number of rows.
    pub(crate) first: Vec<usize>,
    pub(crate) rows: Vec<[f64; 3]>,
}

impl Program {
    /// The objective without its derivatives.
    pub(crate) fn time(&self, x: &[f64]) -> f64 {
        let cell = |(k, h): (usize, &f64)| {
            let point = |(w, form): (&f64, &[f64; 3])| w / value(form, &x[2 * k..2 * k + 3]).sqrt();
            h * WEIGHTS.iter().zip(&FORMS).map(point).sum::<f64>()
        };
        self.lengths.iter().enumerate().map(cell).sum()
    }
}

/// Where to start.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Start<'s> {
    /// Only `x` is known.
    Cold,
    /// Multipliers are known, and every row has slack.
    Warm {
        /// Multiplier of each row.
        multipliers: &'s [f64],
        /// Least product of slack and multiplier, s.
        product: f64,
    },
}

/// When to stop.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stop {
    /// Complementarity as a share of the objective, and primal residual.
    pub(crate) tolerance: f64,
    /// Steps.
    pub(crate) steps: usize,
}

/// What came of it. Nothing of it is believed without a check.
#[derive(Clone, Debug)]
pub(crate) struct Answer {
    pub(crate) x: Vec<f64>,
    /// Multipliers of the rows, s.
    pub(crate) z: Vec<f64>,
    /// Steps taken.
    pub(crate) steps: usize,
    /// Whether the tolerance was reached.
    pub(crate) converged: bool,
}

/// Size of an iterate's errors.
#[derive(Clone, Copy, Debug)]
struct Errors {
    complementarity: f64,
    primal: f64,
    dual: f64,
}

impl Errors {
    fn sum(self) -> f64 {
        self.complementarity + self.primal + self.dual
    }

    fn within(self, tolerance: f64) -> bool {
        self.complementarity < tolerance && self.primal < tolerance && self.dual < 10.0 * tolerance
    }

    fn merit(self) -> f64 {
        self.complementarity.max(self.primal).max(0.1 * self.dual)
    }
}

/// The best iterate so far.
struct Kept {
    errors: f64,
    x: Vec<f64>,
    z: Vec<f64>,
}

/// Steps without a tenth of progress after which a run ends.
const STALLED: usize = 12;
/// Least slack a cold start gives to a row.
const COLD_SLACK: f64 = 0.03;
/// Share of the way to the boundary that a step goes at least, where it ends there.
const TO_BOUNDARY: f64 = 0.99;
/// Share by which the objective's `b` may fall in a step.
const FALL: f64 = 0.9;

/// Solves the program from `x`.
pub(crate) fn solve(program: &Program, x: Vec<f64>, start: Start, stop: Stop) -> Answer {
    let mut run = Run::new(program, x, start);
    let (mut best, mut kept): (f64, Option<Kept>) = (f64::INFINITY, None);
    let (mut stalled, mut steps, mut converged) = (0, 0, false);
    loop {
        let errors = run.measure();
        let sum = errors.sum();
        if !sum.is_finite() {
            break;
        }
        converged = errors.within(stop.tolerance);
        if converged {
            break;
        }
        let least = kept.as_ref().map_or(f64::INFINITY, |k| k.errors);
        if sum < least && errors.complementarity < 1e-3 {
            kept = Some(Kept { errors: sum, x: run.x.clone(), z: run.z.clone() });
        } else if sum > 100.0 * least {
            break;
        }
        stalled = if errors.merit() < 0.9 * best { 0 } else { stalled + 1 };
        best = best.min(errors.merit());
        if steps >= stop.steps || stalled > STALLED || !run.step() {
            break;
        }
        steps += 1;
    }
    match kept {
        Some(Kept { x, z, .. }) if !converged => Answer { x, z, steps, converged },
        _ => Answer { x: run.x, z: run.z, steps, converged },
    }
}

/// An iterate and its work space.
struct Run<'p> {
    program: &'p Program,
    x: Vec<f64>,
    s: Vec<f64>,
    z: Vec<f64>,
    dx: Vec<f64>,
    ds: Vec<f64>,
    dz: Vec<f64>,
    /// `z / s` and `1 / s`.
    ratio: Vec<f64>,
    inverse: Vec<f64>,
    primal: Vec<f64>,
    dual: Vec<f64>,
    /// Weights of the objective's Hessian, cell by cell.
    curvature: Vec<[f64; 4]>,
    objective: f64,
    /// Sum of the products of slacks and multipliers.
    products: f64,
}

/// Largest relative falls of a direction.
#[derive(Clone, Copy, Default)]
struct Falls {
    slack: f64,
    multiplier: f64,
    objective: f64,
}

impl<'p> Run<'p> {
    fn new(program: &'p Program, x: Vec<f64>, start: Start) -> Self {
        let (rows, cells) = (program.rows.len(), program.lengths.len());
        let zeros = || vec![0.0; rows];
        let share = program.time(&x) / rows.max(1) as f64;
        let mut run = Self {
            program,
            s: zeros(),
            z: zeros(),
            dx: vec![0.0; x.len()],
            ds: zeros(),
            dz: zeros(),
            ratio: zeros(),
            inverse: zeros(),
            primal: zeros(),
            dual: vec![0.0; x.len()],
            curvature: vec![[0.0; 4]; cells],
            objective: 0.0,
            products: 0.0,
            x,
        };
        for k in 0..cells {
            for j in program.first[k]..program.first[k + 1] {
                let slack = 1.0 - value(&program.rows[j], &run.x[2 * k..2 * k + 3]);
                (run.s[j], run.z[j]) = match start {
                    Start::Cold => (slack.max(COLD_SLACK), share / slack.max(COLD_SLACK)),
                    Start::Warm { multipliers, product } => {
                        let slack = slack.max(1e-9);
                        (slack, multipliers[j].max(product / slack))
                    }
                };
            }
        }
        run
    }

    /// Objective, residuals, and what the factor needs.
    fn measure(&mut self) -> Errors {
        self.dual.fill(0.0);
        (self.objective, self.products) = (0.0, 0.0);
        let mut worst: f64 = 0.0;
        for k in 0..self.program.lengths.len() {
            let x = &self.x[2 * k..2 * k + 3];
            let mut gradient = [0.0; 3];
            for i in 0..4 {
                let root = 1.0 / value(&FORMS[i], x).sqrt();
                let weight = self.program.lengths[k] * WEIGHTS[i];
                let cube = root * root * root;
                self.objective += weight * root;
                self.curvature[k][i] = 0.75 * weight * cube * root * root;
                add(&mut gradient, &FORMS[i], -0.5 * weight * cube);
            }
            for j in self.program.first[k]..self.program.first[k + 1] {
                let (row, s, z) = (&self.program.rows[j], self.s[j], self.z[j]);
                let residual = value(row, x) + s - 1.0;
                self.primal[j] = residual;
                worst = worst.max(residual.abs());
                self.products += s * z;
                self.inverse[j] = 1.0 / s;
                self.ratio[j] = z * self.inverse[j];
                add(&mut gradient, row, z);
            }
            scatter(&mut self.dual, k, gradient);
        }
        let dual: f64 = self.dual.iter().zip(&self.x).map(|(r, x)| (r * x).abs()).sum();
        Errors { complementarity: self.products / self.objective, primal: worst, dual: dual / self.objective }
    }

    /// One step; false if the matrix has no factor.
    fn step(&mut self) -> bool {
        let program = self.program;
        let (first, rows) = (&program.first, &program.rows);
        let terms = |k: usize| {
            let range = first[k]..first[k + 1];
            [(&self.curvature[k][..], &FORMS[..]), (&self.ratio[range.clone()], &rows[range])]
        };
        let Some(factor) = ChainFactor::new(program.lengths.len(), terms) else { return false };
        let count = rows.len().max(1) as f64;
        for (product, rows) in self.ds.iter_mut().zip(self.s.iter().zip(&self.z)) {
            *product = rows.0 * rows.1;
        }
        let falls = self.direction(&factor);
        let (ahead_p, ahead_d) = lengths(falls, 1.0);
        let mut left = 0.0;
        for j in 0..rows.len() {
            left += (self.s[j] + ahead_p * self.ds[j]) * (self.z[j] + ahead_d * self.dz[j]);
        }
        let centring = (left / self.products).powi(3).min(1.0) * self.products / count;
        for j in 0..rows.len() {
            self.ds[j] = self.s[j] * self.z[j] + self.ds[j] * self.dz[j] - centring;
        }
        let falls = self.direction(&factor);
        let boundary = (1.0 - self.products / (count * self.objective)).max(TO_BOUNDARY);
        let (primal, dual) = lengths(falls, boundary);
        self.advance(primal, dual);
        true
    }

    /// Newton's direction for the products wanted off, which `ds` holds on entry.
    fn direction(&mut self, factor: &ChainFactor) -> Falls {
        let program = self.program;
        for (to, from) in self.dx.iter_mut().zip(&self.dual) {
            *to = -from;
        }
        for k in 0..program.lengths.len() {
            let mut right = [0.0; 3];
            for j in program.first[k]..program.first[k + 1] {
                add(&mut right, &program.rows[j], -(self.z[j] * self.primal[j] - self.ds[j]) * self.inverse[j]);
            }
            scatter(&mut self.dx, k, right);
        }
        factor.solve(&mut self.dx);
        let mut falls = Falls::default();
        for k in 0..program.lengths.len() {
            let (x, dx) = (&self.x[2 * k..2 * k + 3], &self.dx[2 * k..2 * k + 3]);
            for form in &FORMS {
                falls.objective = falls.objective.max(-value(form, dx) / value(form, x));
            }
            for j in program.first[k]..program.first[k + 1] {
                let ds = -self.primal[j] - value(&program.rows[j], dx);
                let dz = (-self.ds[j] - self.z[j] * ds) * self.inverse[j];
                (self.ds[j], self.dz[j]) = (ds, dz);
                falls.slack = falls.slack.max(-ds * self.inverse[j]);
                falls.multiplier = falls.multiplier.max(-dz / self.z[j]);
            }
        }
        falls
    }

    fn advance(&mut self, primal: f64, dual: f64) {
        for (x, dx) in self.x.iter_mut().zip(&self.dx) {
            *x += primal * dx;
        }
        for j in 0..self.s.len() {
            self.s[j] += primal * self.ds[j];
            self.z[j] += dual * self.dz[j];
        }
    }
}

/// Step lengths of `x, s` and of `z` that go a share of the way to the boundary.
fn lengths(falls: Falls, share: f64) -> (f64, f64) {
    let length = |fall: f64, share: f64| if fall > share { share / fall } else { 1.0 };
    (length(falls.slack, share).min(length(falls.objective, FALL)), length(falls.multiplier, share))
}

#[inline]
fn add(to: &mut [f64; 3], row: &[f64; 3], factor: f64) {
    for i in 0..3 {
        to[i] += factor * row[i];
    }
}

#[inline]
fn scatter(to: &mut [f64], cell: usize, values: [f64; 3]) {
    for (to, value) in to[2 * cell..2 * cell + 3].iter_mut().zip(values) {
        *to += value;
    }
}
