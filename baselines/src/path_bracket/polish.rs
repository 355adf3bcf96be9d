//! The best multipliers of the chosen rows: the dual of "maximise the bound over the hats", solved as a primal.
//!
//! With the integral by Gauss's rule (4 points a cell) that dual is the problem in weak form: `b_q` is free at every point, the rows hold on average
//! over a hat,
//!
//! ```text
//! minimise sum_q ω_q b_q^(-1/2)   s.t.  sum_q ω_q J_qi b_q + σ_i = 1,   b_q + κ_q = cap_q,   σ, κ >= 0
//! ω_q = h W_q,   J_qi = scale_i / 2 (φ_i c - φ_i' a)(x_q),   w_q = sum_i J_qi y_i
//! ```
//!
//! and its multipliers `y` are the hats' prices in seconds. Primal-dual steps (predictor, corrector) in `(b, κ, ν; σ, y)` are eliminated to `y`:
//! with `H_q = 3/4 ω b^(-5/2) + ν/κ`
//!
//! ```text
//! S = sum_q ω² J_q J_qᵀ / H_q + diag(σ/y)
//! ```
//!
//! is banded and a sum of positive terms in which the rows that matter add *small* numbers, so nothing cancels.
//! Any `y >= 0` gives a valid bound: nothing here is believed.

use super::banded::Banded;
use super::caps;
use super::cells::Cell;
use super::hats::{Hats, ROWS};
use super::path::JointLimits;

/// Gauss's points on `[0, 1]` and their weights.
pub(crate) const POINTS: [f64; 4] =
    [0.069_431_844_202_973_71, 0.330_009_478_207_571_87, 0.669_990_521_792_428_1, 0.930_568_155_797_026_3];
pub(crate) const WEIGHTS: [f64; 4] =
    [0.173_927_422_568_726_92, 0.326_072_577_431_273_1, 0.326_072_577_431_273_1, 0.173_927_422_568_726_92];
/// Diagonals of `S`: a row meets those of its own node and of the next one.
const BAND: usize = 2 * ROWS;
/// Steps.
const STEPS: usize = 60;
/// Multiple of the profile's `b` that stands for no bound of it. A larger one lets rounding of `w` about 0 cost more than the whole time.
const UNBOUNDED: f64 = 1e8;
/// Greatest step towards the boundary.
const TO_BOUNDARY: f64 = 0.99;

/// What the polish gives beside the hats' prices.
#[derive(Clone, Debug)]
pub(crate) struct Polished {
    /// Steps taken.
    #[cfg_attr(not(test), allow(dead_code, reason = "tests watch it: the first to show a bad start"))]
    pub(crate) steps: usize,
    /// `∫ g` of each cell by Gauss's rule, s.
    pub(crate) integral: Vec<f64>,
}

/// Accuracy, and how far from the boundary to start, both as shares of the time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Aim {
    pub(crate) tolerance: f64,
    pub(crate) start: f64,
}

/// Raises the prices of the hats to about the best. `b` at the Gauss points is where to start.
pub(crate) fn polish(cells: &[&Cell], limits: &JointLimits, hats: &mut Hats, b: Vec<f64>, aim: Aim) -> Polished {
    let weak = Weak::new(cells, limits, hats, &b);
    let y: Vec<f64> = hats.nodes.iter().flatten().map(|h| h.seconds).collect();
    let mut run = Run::new(&weak, y, b, aim.start);
    let mut steps = 0;
    while steps < STEPS && run.error() >= aim.tolerance && run.step() {
        steps += 1;
    }
    for (hat, y) in hats.nodes.iter_mut().flatten().zip(&run.y) {
        hat.seconds = if *y > 0.0 && y.is_finite() { *y } else { 0.0 };
    }
    let kept: Vec<f64> = hats.nodes.iter().flatten().map(|h| h.seconds).collect();
    Polished { steps, integral: weak.integrals(&kept) }
}

/// The weak form's data; index of a point: `4 k + g`.
struct Weak {
    /// Index of a node's first row, and the number of rows.
    first: Vec<usize>,
    /// `J` by point: rows of the left node, then of the right one.
    jacobian: Vec<[f64; BAND]>,
    weight: Vec<f64>,
    cap: Vec<f64>,
}

impl Weak {
    fn new(cells: &[&Cell], limits: &JointLimits, hats: &Hats, b: &[f64]) -> Self {
        let mut first = vec![0];
        for node in &hats.nodes {
            first.push(first[first.len() - 1] + node.len());
        }
        let points = 4 * cells.len();
        let mut weak =
            Self { first, jacobian: vec![[0.0; BAND]; points], weight: vec![0.0; points], cap: vec![0.0; points] };
        for (k, cell) in cells.iter().enumerate() {
            for g in 0..4 {
                let (q, t) = (4 * k + g, POINTS[g]);
                weak.weight[q] = cell.length * WEIGHTS[g];
                weak.cap[q] = caps::at(cell, limits, t).min(UNBOUNDED * b[q]);
                for (side, (value, slope)) in [(1.0 - t, -1.0), (t, 1.0)].into_iter().enumerate() {
                    for (i, hat) in hats.nodes[k + side].iter().enumerate() {
                        let p = &cell.derivative[hat.joint];
                        let term = value * caps::slope_at(p, t) - slope * p.at(t);
                        weak.jacobian[q][side * ROWS + i] = 0.5 * hat.sense.sign() * hat.scale * term / cell.length;
                    }
                }
            }
        }
        weak
    }

    fn cells(&self) -> usize {
        self.first.len() - 2
    }

    /// Row of the system and column of the point's jacobian, for every row that a point of cell `k` meets.
    fn rows(&self, k: usize) -> impl Iterator<Item = (usize, usize)> + '_ {
        let left = (self.first[k]..self.first[k + 1]).enumerate().map(|(i, row)| (row, i));
        let right = (self.first[k + 1]..self.first[k + 2]).enumerate().map(|(i, row)| (row, ROWS + i));
        left.chain(right)
    }

    /// `J y` by point.
    fn slopes(&self, y: &[f64], out: &mut [f64]) {
        for k in 0..self.cells() {
            for q in 4 * k..4 * k + 4 {
                out[q] = self.rows(k).map(|(row, i)| self.jacobian[q][i] * y[row]).sum();
            }
        }
    }

    /// `sum_q ω_q J_q b_q` by row.
    fn averages(&self, b: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        for k in 0..self.cells() {
            for q in 4 * k..4 * k + 4 {
                let value = self.weight[q] * b[q];
                for (row, i) in self.rows(k) {
                    out[row] += self.jacobian[q][i] * value;
                }
            }
        }
    }

    /// `∫ g` of every cell.
    fn integrals(&self, y: &[f64]) -> Vec<f64> {
        let mut w = vec![0.0; self.weight.len()];
        self.slopes(y, &mut w);
        let point = |q: usize| self.weight[q] * least(w[q], self.cap[q]);
        (0..self.cells()).map(|k| (4 * k..4 * k + 4).map(point).sum()).collect()
    }
}

/// `min b^(-1/2) + w b` over `0 <= b <= cap`, a guide.
pub(crate) fn least(w: f64, cap: f64) -> f64 {
    if w > 0.0 && 2.0 * w * cap * cap.sqrt() >= 1.0 {
        1.5 * (2.0 * w).cbrt()
    } else if cap.is_finite() {
        1.0 / cap.sqrt() + w * cap
    } else if w < 0.0 {
        f64::NEG_INFINITY
    } else {
        0.0
    }
}

/// An iterate and its work space. `sigma`, `y` by row; the others by point.
struct Run<'w> {
    weak: &'w Weak,
    y: Vec<f64>,
    sigma: Vec<f64>,
    b: Vec<f64>,
    kappa: Vec<f64>,
    nu: Vec<f64>,
    /// Residuals of rows, of caps and of the gradient by `b`.
    row_residual: Vec<f64>,
    cap_residual: Vec<f64>,
    gradient: Vec<f64>,
    hessian: Vec<f64>,
    time: f64,
    products: f64,
    error: f64,
    step: Direction,
}

#[derive(Default)]
struct Direction {
    y: Vec<f64>,
    sigma: Vec<f64>,
    b: Vec<f64>,
    kappa: Vec<f64>,
    nu: Vec<f64>,
    /// `J dy` by point.
    slope: Vec<f64>,
}

impl<'w> Run<'w> {
    /// Starts with products of at least `start` times the time over their number.
    fn new(weak: &'w Weak, mut y: Vec<f64>, mut b: Vec<f64>, start: f64) -> Self {
        let (rows, points) = (y.len(), b.len());
        let time: f64 = weak.weight.iter().zip(&b).map(|(w, b)| w / b.sqrt()).sum();
        let product = start * time / (rows + points) as f64;
        for (b, cap) in b.iter_mut().zip(&weak.cap) {
            *b = b.min(cap * (1.0 - 1e-6));
        }
        let (mut sigma, mut kappa, mut nu) = (vec![0.0; rows], vec![0.0; points], vec![0.0; points]);
        weak.averages(&b, &mut sigma);
        for (sigma, y) in sigma.iter_mut().zip(&mut y) {
            *sigma = (1.0 - *sigma).max((product / *y).min(0.5)).max(1e-7);
            *y = y.max(product / *sigma);
        }
        let mut slope = vec![0.0; points];
        weak.slopes(&y, &mut slope);
        for q in 0..points {
            let (cap, wanted) = (weak.cap[q], weak.weight[q] * (0.5 * b[q].powf(-1.5) - slope[q]));
            kappa[q] = (cap - b[q]).max(1e-9 * cap);
            nu[q] = wanted.max(product / kappa[q]);
            if wanted > 0.0 {
                kappa[q] = kappa[q].max((product / nu[q]).min(0.3 * cap));
            }
        }
        let step = Direction {
            y: vec![0.0; rows],
            sigma: vec![0.0; rows],
            b: vec![0.0; points],
            kappa: vec![0.0; points],
            nu: vec![0.0; points],
            slope,
        };
        let (by_row, by_point) = (vec![0.0; rows], vec![0.0; points]);
        let (hessian, gradient) = (by_point.clone(), by_point.clone());
        let mut run = Self {
            weak,
            y,
            sigma,
            b,
            kappa,
            nu,
            row_residual: by_row,
            cap_residual: by_point,
            gradient,
            hessian,
            time,
            products: 0.0,
            error: f64::INFINITY,
            step,
        };
        run.measure();
        run
    }

    /// Complementarity and residuals, as a share of the time; NaN counts as done.
    fn error(&self) -> f64 {
        self.error
    }

    fn measure(&mut self) {
        let weak = self.weak;
        weak.averages(&self.b, &mut self.row_residual);
        weak.slopes(&self.y, &mut self.step.slope);
        let (mut products, mut time, mut residual) = (0.0, 0.0, 0.0);
        for i in 0..self.y.len() {
            self.row_residual[i] += self.sigma[i] - 1.0;
            products += self.y[i] * self.sigma[i];
            residual += self.row_residual[i].abs() * self.y[i];
        }
        for q in 0..self.b.len() {
            let (b, weight) = (self.b[q], weak.weight[q]);
            let root = 1.0 / b.sqrt();
            let cube = root / b;
            time += weight * root;
            products += self.nu[q] * self.kappa[q];
            self.cap_residual[q] = b + self.kappa[q] - weak.cap[q];
            self.gradient[q] = weight * (self.step.slope[q] - 0.5 * cube) + self.nu[q];
            self.hessian[q] = 0.75 * weight * cube / b + self.nu[q] / self.kappa[q];
            residual += self.cap_residual[q].abs() * self.nu[q] + (self.gradient[q] * b).abs();
        }
        (self.time, self.products) = (time, products);
        self.error = (products + residual) / time;
    }

    /// One step; false if the matrix has no factor or numbers overflow.
    fn step(&mut self) -> bool {
        let Some(factor) = self.factor() else { return false };
        for i in 0..self.y.len() {
            self.step.sigma[i] = self.y[i] * self.sigma[i];
        }
        for q in 0..self.b.len() {
            self.step.nu[q] = self.nu[q] * self.kappa[q];
        }
        let (ahead_p, ahead_d) = self.direction(&factor, 1.0);
        let (step, mut left) = (&self.step, 0.0);
        for i in 0..self.y.len() {
            left += (self.y[i] + ahead_d * step.y[i]) * (self.sigma[i] + ahead_p * step.sigma[i]);
        }
        for q in 0..self.b.len() {
            left += (self.nu[q] + ahead_d * step.nu[q]) * (self.kappa[q] + ahead_p * step.kappa[q]);
        }
        let count = (self.y.len() + self.b.len()) as f64;
        let centring = (left / self.products).powi(3).min(1.0) * self.products / count;
        for i in 0..self.y.len() {
            self.step.sigma[i] = self.y[i] * self.sigma[i] + self.step.y[i] * self.step.sigma[i] - centring;
        }
        for q in 0..self.b.len() {
            self.step.nu[q] = self.nu[q] * self.kappa[q] + self.step.nu[q] * self.step.kappa[q] - centring;
        }
        let (primal, dual) = self.direction(&factor, TO_BOUNDARY);
        self.advance(primal, dual);
        self.measure();
        self.error.is_finite()
    }

    fn factor(&self) -> Option<Banded<BAND>> {
        let weak = self.weak;
        let mut matrix = Banded::<BAND>::new(self.y.len());
        for k in 0..weak.cells() {
            let mut local = [[0.0; BAND]; BAND];
            for q in 4 * k..4 * k + 4 {
                let (jacobian, weight) = (&weak.jacobian[q], weak.weight[q] * weak.weight[q] / self.hessian[q]);
                for i in 0..BAND {
                    let t = weight * jacobian[i];
                    for j in 0..=i {
                        local[i][j] += t * jacobian[j];
                    }
                }
            }
            for (row, i) in weak.rows(k) {
                for (column, j) in weak.rows(k).take_while(|(column, _)| *column <= row) {
                    matrix.rows[row][row - column] += local[i][j];
                }
            }
        }
        for (i, row) in matrix.rows.iter_mut().enumerate() {
            row[0] = (row[0] + self.sigma[i] / self.y[i]) * (1.0 + 1e-14);
        }
        matrix.factorise().then_some(matrix)
    }

    /// Direction for the products wanted off, which `step.sigma` and `step.nu` hold on entry; step lengths of primal and dual.
    fn direction(&mut self, factor: &Banded<BAND>, boundary: f64) -> (f64, f64) {
        let (weak, step) = (self.weak, &mut self.step);
        for q in 0..self.b.len() {
            let pull = (self.nu[q] * self.cap_residual[q] - step.nu[q]) / self.kappa[q];
            step.b[q] = (-self.gradient[q] - pull) / self.hessian[q];
        }
        weak.averages(&step.b, &mut step.y);
        for i in 0..self.y.len() {
            step.y[i] += self.row_residual[i] - step.sigma[i] / self.y[i];
        }
        factor.solve(&mut step.y);
        weak.slopes(&step.y, &mut step.slope);
        let (mut primal, mut dual): (f64, f64) = (0.0, 0.0);
        for q in 0..self.b.len() {
            let b = step.b[q] - weak.weight[q] * step.slope[q] / self.hessian[q];
            let kappa = -self.cap_residual[q] - b;
            let nu = (-step.nu[q] - self.nu[q] * kappa) / self.kappa[q];
            (step.b[q], step.kappa[q], step.nu[q]) = (b, kappa, nu);
            primal = primal.max(-kappa / self.kappa[q]).max(-1.05 * b / self.b[q]);
            dual = dual.max(-nu / self.nu[q]);
        }
        for i in 0..self.y.len() {
            let sigma = (-step.sigma[i] - self.sigma[i] * step.y[i]) / self.y[i];
            step.sigma[i] = sigma;
            primal = primal.max(-sigma / self.sigma[i]);
            dual = dual.max(-step.y[i] / self.y[i]);
        }
        let length = |fall: f64| if fall > boundary { boundary / fall } else { 1.0 };
        (length(primal), length(dual))
    }

    fn advance(&mut self, primal: f64, dual: f64) {
        let go = |to: &mut [f64], by: &[f64], length: f64| {
            for (to, by) in to.iter_mut().zip(by) {
                *to += length * by;
            }
        };
        go(&mut self.y, &self.step.y, dual);
        go(&mut self.nu, &self.step.nu, dual);
        go(&mut self.sigma, &self.step.sigma, primal);
        go(&mut self.b, &self.step.b, primal);
        go(&mut self.kappa, &self.step.kappa, primal);
    }
}
