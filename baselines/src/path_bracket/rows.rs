//! The rows of a cell: linear inequalities in the three numbers of `b` there that make every limit hold on the whole cell.
//!
//! In a cell of length `h`, `t` in `[0, 1]`, `b` is a quadratic with Bernstein coefficients `(b0, m, b1)`, so
//!
//! ```text
//! u = b'/2 = ((m - b0)(1 - t) + (b1 - m) t) / h
//! acceleration of a joint:  q_x u + q_xx b     degree n + 1   (n: degree of q_x)
//! square of its speed:      q_x² b             degree 2 n + 2
//! ```
//!
//! Both are polynomials whose Bernstein coefficients are linear in `(b0, m, b1)`; the limit holds on the cell if it holds for every coefficient.
//! [`cell_rows`] writes the rows for the solver, scaled to the right-hand side 1, in plain arithmetic. [`excess`] bounds, with outward
//! rounding, what a given `b` makes of every limit: this alone is what the upper bound rests on.
//!
//! Rows of other kinds (torques, limits that vary) have the same shape `a u + c b + d <= U` with their own polynomials for `a`, `c`, `d`, `U`; they would be
//! written here beside those of the joints, with the remainder of their interpolation taken off `U`.

use super::bernstein::{BY_QUADRATIC, PRODUCT, Polynomial, grown, square};
use super::cells::Cell;
use super::path::{JointLimits, Sense};

/// The limit that a row belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitName {
    /// Acceleration limit of a joint, counted from 0.
    Acceleration {
        /// The joint.
        joint: usize,
        /// The sense.
        sense: Sense,
    },
    /// Speed limit of a joint, counted from 0.
    Speed {
        /// The joint.
        joint: usize,
    },
}

/// Rows of a cell, `row · (b0, m, b1) <= 1` with `b` in a unit of the caller's, grouped by limit.
#[derive(Clone, Debug, Default)]
pub(crate) struct CellRows {
    pub(crate) rows: Vec<[f64; 3]>,
    /// Limits and the index after their last row.
    pub(crate) groups: Vec<(LimitName, usize)>,
}

impl CellRows {
    /// The groups with the range of their rows.
    pub(crate) fn ranges(&self) -> impl Iterator<Item = (LimitName, std::ops::Range<usize>)> + '_ {
        let starts = std::iter::once(0).chain(self.groups.iter().map(|g| g.1));
        self.groups.iter().zip(starts).map(|((name, end), start)| (*name, start..*end))
    }
}

/// `row · x`.
#[inline]
pub(crate) fn value(row: &[f64; 3], x: &[f64]) -> f64 {
    row[0] * x[0] + row[1] * x[1] + row[2] * x[2]
}

/// All rows of a cell with `b` in units of `unit`. Speed rows of a joint that another one dominates in the whole cell are left out.
pub(crate) fn cell_rows(cell: &Cell, limits: &JointLimits, unit: f64) -> CellRows {
    let mut result = CellRows::default();
    for (joint, q) in cell.derivative.iter().enumerate() {
        if limits.is_accelerated(joint) {
            let rows = acceleration_rows(q.coefficients(), cell.length);
            for sense in Sense::BOTH {
                let scale = sense.sign() * unit / limits.acceleration(joint, sense);
                if scale != 0.0 {
                    result.rows.extend(rows[..=q.degree() + 1].iter().map(|r| r.map(|c| c * scale)));
                    result.groups.push((LimitName::Acceleration { joint, sense }, result.rows.len()));
                }
            }
        }
    }
    let ranges = |j: usize| cell.derivative[j].absolute_range();
    let least = (0..limits.joints()).map(|j| ranges(j).0 / limits.speed(j)).fold(0.0, f64::max);
    for (joint, q) in cell.derivative.iter().enumerate() {
        let limit = limits.speed(joint);
        if limit.is_finite() && ranges(joint).1 / limit >= least && ranges(joint).1 > 0.0 {
            let rows = speed_rows(q);
            let scale = unit / (limit * limit);
            result.rows.extend(rows[..2 * q.degree() + 3].iter().map(|r| r.map(|c| c * scale)));
            result.groups.push((LimitName::Speed { joint }, result.rows.len()));
        }
    }
    result
}

/// Bernstein coefficients `0..=n + 1` of `q_x u + q_xx b` as rows.
fn acceleration_rows(a: &[f64], h: f64) -> [[f64; 3]; PRODUCT] {
    let n = a.len() - 1;
    let d = (n + 1) as f64;
    let mut rows = [[0.0; 3]; PRODUCT];
    for (i, row) in rows[..=n + 1].iter_mut().enumerate() {
        let p = if i <= n { a[i] * (d - i as f64) / (d * h) } else { 0.0 };
        let q = if i > 0 { a[i - 1] * i as f64 / (d * h) } else { 0.0 };
        *row = [-p, p - q, q];
    }
    for l in 0..n {
        let c = n as f64 * (a[l + 1] - a[l]) / h;
        for e in 0..3 {
            rows[l + e][e] += c * BY_QUADRATIC[n - 1][l][e];
        }
    }
    rows
}

/// Bernstein coefficients `0..=2 n + 2` of `q_x² b` as rows.
fn speed_rows(q: &Polynomial) -> [[f64; 3]; PRODUCT] {
    let (mut squared, mut rows) = ([0.0; PRODUCT], [[0.0; 3]; PRODUCT]);
    square(q, &mut squared);
    let n = 2 * q.degree();
    for l in 0..=n {
        for e in 0..3 {
            rows[l + e][e] += squared[l] * BY_QUADRATIC[n][l][e];
        }
    }
    rows
}

/// No limit is used by more than the first number anywhere in the cell: an upper bound, under outward rounding, of the largest quotient of a
/// limited quantity and its limit (of the square of a speed and its limit's square), with the limit that gives it.
pub(crate) fn excess(cell: &Cell, limits: &JointLimits, b: [f64; 3]) -> (f64, Option<LimitName>) {
    // Minima and maxima below pass over what is not a number; sums of numbers below this size do not overflow.
    if !b.iter().all(|b| b.abs() < 1e100) {
        return (f64::INFINITY, None);
    }
    let mut worst = (0.0, None);
    let mut see = |share: f64, name| {
        // Fails safe: a share that is not a number counts as the worst.
        if !(share <= worst.0) {
            worst = (share, Some(name));
        }
    };
    for (joint, q) in cell.derivative.iter().enumerate() {
        if limits.is_accelerated(joint) {
            let (low, high) = acceleration_range(q, cell.length, b);
            let upper = (high / limits.acceleration(joint, Sense::Upper)).next_up();
            see(upper, LimitName::Acceleration { joint, sense: Sense::Upper });
            let lower = (-low / limits.acceleration(joint, Sense::Lower)).next_up();
            see(lower, LimitName::Acceleration { joint, sense: Sense::Lower });
        }
        let limit = limits.speed(joint);
        if limit.is_finite() {
            let square = (limit * limit).next_down();
            see((squared_speed(q, b, square) / square).next_up(), LimitName::Speed { joint });
        }
    }
    worst
}

/// Bounds of `q_x u + q_xx b`. Coefficient `i` of `h` times it is, with differences `D` of neighbours' coefficients,
///
/// ```text
/// (q_i (n + 1 - i) (m - b0) + q_{i-1} i (b1 - m)) / (n + 1)  +  n sum_{l + e = i} share(l, e) Dq_l b_e
/// ```
///
/// Differences are rounded once; every term has fewer than 8 roundings, and no more than 5 terms are added: off by less than `16 epsilon` times the
/// sum of the largest terms, to which the radius of `q` adds its own.
fn acceleration_range(q: &Polynomial, h: f64, b: [f64; 3]) -> (f64, f64) {
    let (a, n) = (q.coefficients(), q.degree());
    let (d0, d1, d) = (b[1] - b[0], b[2] - b[1], (n + 1) as f64);
    let mut out = [0.0; PRODUCT];
    let mut bend: f64 = 0.0;
    for i in 0..=n {
        out[i] += a[i] * (d - i as f64) * d0 / d;
        out[i + 1] += a[i] * (i + 1) as f64 * d1 / d;
    }
    for l in 0..n {
        let c = n as f64 * (a[l + 1] - a[l]);
        bend = bend.max(c.abs());
        for e in 0..3 {
            out[l + e] += c * BY_QUADRATIC[n - 1][l][e] * b[e];
        }
    }
    let largest = |x: f64, y: f64| x.abs().max(y.abs());
    let (step, height) = (largest(d0, d1), largest(b[0], b[2]).max(b[1].abs()));
    let terms = q.largest() * step + bend * height;
    let by_radius = 2.0 * q.radius * (step + 2.0 * d * height);
    let slack = grown(by_radius, 32.0 * terms);
    let (low, high) = out[..=n + 1].iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, u), v| (l.min(*v), u.max(*v)));
    (((low - slack).next_down() / h).next_down(), ((high + slack).next_up() / h).next_up())
}

/// Bound of `q_x² b`: the product of the largest values where that is below `enough`, else the largest Bernstein coefficient.
fn squared_speed(q: &Polynomial, b: [f64; 3], enough: f64) -> f64 {
    let largest = (q.largest() + q.radius).next_up();
    let height = b[0].max(b[1]).max(b[2]).abs();
    // Two products: below an epsilon each.
    let simple = largest * largest * height * (1.0 + 4.0 * f64::EPSILON);
    if simple <= enough {
        return simple;
    }
    let (mut squared, mut out) = ([0.0; PRODUCT], [0.0; PRODUCT]);
    square(q, &mut squared);
    let n = 2 * q.degree();
    for l in 0..=n {
        for e in 0..3 {
            out[l + e] += squared[l] * BY_QUADRATIC[n][l][e] * b[e];
        }
    }
    let height = height.max(b[1].abs());
    // Square: below 32 epsilon; a mean of three products, rounded three times each: below 8 more.
    let slack = grown(4.0 * q.radius * largest * height, 64.0 * largest * largest * height);
    (out[..=n + 2].iter().fold(f64::NEG_INFINITY, |u, v| u.max(*v)) + slack).next_up()
}
