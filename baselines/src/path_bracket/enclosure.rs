//! The lower bound, evaluated with outward rounding cell by cell.
//!
//! For multipliers `mu_r >= 0` and `p = 1/2 sum_r mu_r a_r`, continuous and 0 at free ends, every feasible `b` has
//!
//! ```text
//! T(b) >= L = ∫ g(w, cap) dx - sum_r ∫ mu_r U_r,   w = sum_r (mu_r c_r - (mu_r a_r)'/2),   g(w, cap) = min b^(-1/2) + w b over 0 <= b <= cap
//! ```
//!
//! for any `cap` that bounds `b`. (Weak duality: `mu_r (a_r b'/2 + c_r b - U_r) <= 0` is added and `p b' ` integrated by parts; at a rest end `a_r = 0`
//! and `b` is bounded, so `p b = 0`.) `g` rises with `w`, falls with `cap`, and is concave in `w`:
//!
//! ```text
//! g = 3/2 (2 w)^(1/3)          where w > 0 and 2 w cap^(3/2) >= 1
//!   = cap^(-1/2) + w cap       elsewhere
//! ```
//!
//! On a part of a cell `w` lies above a straight line, the chord of its Bernstein coefficients lowered until none is below. Valid there, and the
//! largest is taken:
//!
//! - the trapezoid of `g` at the line's ends: `g` is concave;
//! - Simpson's rule for `3/2 (2 w)^(1/3)` on a positive line: the fourth derivative of a cube root is negative;
//! - the shortest time under the speed limits, `max_i |Δq_i| / v_i`, plus `min(0, w) cap`, and plus `w / slowness²` where `w` is so small that the
//!   speed limits are used up everywhere.
//!
//! Parts are halved until little is left of the difference to a guide.

use crate::outward::Outward;

use super::bernstein::{Polynomial, grown};
use super::caps::{self, Slowness};
use super::cells::Cell;
use super::hats::Hat;
use super::path::JointLimits;

/// Parts of a cell.
const PARTS: usize = 64;
/// `w` over a bound's threshold beyond which a smaller part's bound will not matter either.
const NEAR: f64 = 4.0;

/// The multipliers at both nodes of a cell, and what is known about it.
pub(crate) struct CellDual<'c> {
    pub(crate) cell: &'c Cell,
    pub(crate) limits: &'c JointLimits,
    /// Hats of the left and of the right node.
    pub(crate) hats: [&'c [Hat]; 2],
    /// Kinematic bound of `b` in the cell.
    pub(crate) kinematic: f64,
    /// Guide for `∫ g`, and what may be lost against it, s.
    pub(crate) guide: f64,
    pub(crate) allowed: f64,
}

/// A part of a cell.
struct Part {
    /// `h w`, with the cell's length `h`.
    slope: Polynomial,
    joints: Vec<Polynomial>,
    /// Length, a binary fraction of the cell's.
    length: f64,
    bound: f64,
    /// Pair bound of `b`, of the part or of one that contains it.
    pair: f64,
    /// What halving it may gain.
    promise: f64,
}

impl CellDual<'_> {
    /// Lower bound of `∫ g - sum ∫ mu U` over the cell.
    pub(crate) fn lower(&self) -> Outward {
        self.price() + self.integral()
    }

    /// `-sum ∫ mu U`: half of each node's hats.
    pub(crate) fn price(&self) -> Outward {
        let half = Outward::exact(0.5 * self.cell.length);
        let mut sum = Outward::ZERO;
        for hat in self.hats.iter().copied().flatten() {
            let limit = Outward::exact(self.limits.acceleration(hat.joint, hat.sense));
            sum = sum - half * Outward::exact(hat.multiplier()) * limit;
        }
        sum
    }

    fn integral(&self) -> Outward {
        let root = Part {
            slope: self.slope(),
            joints: self.cell.derivative.clone(),
            length: self.cell.length,
            bound: 0.0,
            pair: f64::INFINITY,
            promise: f64::INFINITY,
        };
        let simple = self.speed_bound(&root);
        if self.guide - simple <= self.allowed {
            return Outward { lo: simple, hi: f64::INFINITY };
        }
        let mut root = root;
        self.bound(&mut root);
        root.bound = root.bound.max(simple);
        let mut parts = vec![root];
        loop {
            let total: f64 = parts.iter().map(|p| p.bound).sum();
            let loss = self.guide - total;
            let best = (0..parts.len()).max_by(|a, b| parts[*a].promise.total_cmp(&parts[*b].promise)).unwrap_or(0);
            if loss <= self.allowed || parts.len() >= PARTS || parts[best].promise < 1e-3 * self.allowed {
                break;
            }
            let part = parts.swap_remove(best);
            parts.extend(self.halves(&part, loss));
        }
        let sum = parts.iter().fold(Outward::ZERO, |sum, p| sum + Outward { lo: p.bound, hi: f64::INFINITY });
        Outward { lo: sum.lo, hi: f64::INFINITY }
    }

    /// Both halves of a part. A half promises half of what halving gained, and not much less than its share of the loss: a first halving may gain nothing.
    fn halves(&self, part: &Part, loss: f64) -> [Part; 2] {
        let (left, right): (Vec<_>, Vec<_>) = part.joints.iter().map(Polynomial::halves).unzip();
        let (w_left, w_right) = part.slope.halves();
        let length = 0.5 * part.length;
        let mut halves = [(w_left, left), (w_right, right)].map(|(slope, joints)| Part {
            slope,
            joints,
            length,
            bound: 0.0,
            pair: part.pair,
            promise: 0.0,
        });
        for half in &mut halves {
            self.bound(half);
        }
        let gain = halves[0].bound + halves[1].bound - part.bound;
        let share = 0.05 * loss * length / self.cell.length;
        let promise = if gain.is_finite() { (0.5 * gain).max(share) } else { f64::INFINITY };
        for half in &mut halves {
            half.promise = promise;
        }
        halves
    }

    /// `h w` in Bernstein form. A hat of multiplier `m` of the row with sign `e` adds `e m / 2` times
    ///
    /// ```text
    /// left node:  (1 - t) h c + a:  coefficient l   (n - l) (a_{l+1} - a_l) + a_l
    /// right node:   t h c - a:      coefficient l   l (a_l - a_{l-1}) - a_l
    /// ```
    fn slope(&self) -> Polynomial {
        let n = self.cell.degree();
        let (mut sum, mut size, mut radius) = ([0.0; super::bernstein::COEFFICIENTS], 0.0, 0.0);
        for (right, hats) in self.hats.iter().enumerate() {
            for hat in *hats {
                let factor = 0.5 * hat.sense.sign() * hat.multiplier();
                let q = &self.cell.derivative[hat.joint];
                let a = q.coefficients();
                let mut steepest: f64 = 0.0;
                for l in 0..=n {
                    let term = if right == 0 {
                        let step = if l < n { (n - l) as f64 * (a[l + 1] - a[l]) } else { 0.0 };
                        steepest = steepest.max(step.abs());
                        step + a[l]
                    } else {
                        let step = if l > 0 { l as f64 * (a[l] - a[l - 1]) } else { 0.0 };
                        steepest = steepest.max(step.abs());
                        step - a[l]
                    };
                    sum[l] += factor * term;
                }
                size += factor.abs() * (steepest + q.largest());
                radius += factor.abs() * (2 * n + 1) as f64 * q.radius;
            }
        }
        // A term has 4 roundings and joins a sum of at most 6: below 16 epsilon of the sum of sizes.
        let mut slope = Polynomial::new(&sum[..=n]);
        // Near overflow a sum may not be a number, which minima pass over.
        slope.radius = if size < 1e200 { grown(2.0 * radius, 16.0 * size) } else { f64::INFINITY };
        slope
    }

    /// Lower bound of `∫ g` over a part with the speed limits as the only bounds of `b`.
    fn speed_bound(&self, part: &Part) -> f64 {
        let (line, speeds) = (Line::below(&part.slope, self.cell.length), caps::slowness(&part.joints, self.limits));
        self.bound_below(part.length, &line, speeds, speed_cap(speeds))
    }

    /// Lower bound of `∫ g` over a part with all bounds of `b`. The pair bound of a containing part holds as well; its own is sought
    /// where there was none, or where the bound is near to what matters.
    fn bound(&self, part: &mut Part) {
        let (line, speeds) = (Line::below(&part.slope, self.cell.length), caps::slowness(&part.joints, self.limits));
        let mut cap = speed_cap(speeds).min(self.kinematic).min(part.pair);
        if !(part.pair.is_finite() && line.least() > NEAR * threshold(cap)) {
            part.pair = part.pair.min(caps::pair(&part.joints, part.length, self.limits));
            cap = cap.min(part.pair);
        }
        part.bound = self.bound_below(part.length, &line, speeds, cap);
    }

    fn bound_below(&self, length: f64, line: &Line, speeds: Slowness, cap: f64) -> f64 {
        if !(line.start.is_finite() && line.end.is_finite()) {
            return f64::NEG_INFINITY;
        }
        let least = line.least();
        let length = Outward::exact(length);
        let mut bound = line.integral(cap, length).lo;
        if speeds.mean > 0.0 {
            let shortest = Outward::exact(speeds.mean) * length;
            let lost = Outward::exact(least.min(0.0)) * Outward::exact(cap) * length;
            let by_speed = if least < 0.0 { shortest + lost } else { shortest };
            bound = bound.max(by_speed.lo);
            // 2 w <= slowness³ everywhere: all of the speed limit is used, and w b is at least w over the greatest slowness squared.
            if least > 0.0 && line.highest <= 0.5 * (speeds.least * speeds.least * speeds.least) * (1.0 - 1e-12) {
                let most = Outward::exact(speeds.most);
                bound = bound.max((shortest + Outward::exact(least) * length / (most * most)).lo);
            }
        }
        if bound.is_nan() { f64::NEG_INFINITY } else { bound }
    }
}

/// The speed limits' bound of `b`.
fn speed_cap(speeds: Slowness) -> f64 {
    if speeds.least > 0.0 { (1.0 / (speeds.least * speeds.least).next_down()).next_up() } else { f64::INFINITY }
}

/// The `w` at which a bound of `b` begins to matter.
fn threshold(cap: f64) -> f64 {
    if cap.is_finite() { 0.5 / (cap * cap.sqrt()) } else { 0.0 }
}

/// A straight line below `w` on a part, and a number above it.
struct Line {
    start: f64,
    end: f64,
    highest: f64,
}

impl Line {
    /// From `h w`.
    fn below(slope: &Polynomial, h: f64) -> Self {
        let (c, n) = (slope.coefficients(), slope.degree());
        let (first, last) = (c[0], c[n]);
        let mut dip: f64 = 0.0;
        for (i, c) in c.iter().enumerate().take(n).skip(1) {
            let chord = first + (last - first) * (i as f64 / n as f64);
            dip = dip.max(chord - c);
        }
        // The chord has four roundings, the dip one more: below 6 epsilon of the largest coefficient.
        let margin = grown(dip + slope.radius, 8.0 * slope.largest());
        let down = |x: f64| ((x - margin).next_down() / h).next_down();
        Self { start: down(first), end: down(last), highest: (slope.range().1 / h).next_up() }
    }

    fn least(&self) -> f64 {
        self.start.min(self.end)
    }

    /// `∫ g` of the line over a part, from below.
    fn integral(&self, cap: f64, length: Outward) -> Outward {
        let least = self.least();
        if least > threshold(cap) * (1.0 + 1e-12) && least > 0.0 {
            let (start, end) = (Outward::exact(self.start), Outward::exact(self.end));
            let middle = Outward::exact(0.5) * (start + end);
            let sum = root_bound(start) + Outward::exact(4.0) * root_bound(middle) + root_bound(end);
            return sum * length / Outward::exact(6.0);
        }
        Outward::exact(0.5) * (least_sum(self.start, cap) + least_sum(self.end, cap)) * length
    }
}

/// `3/2 (2 w)^(1/3)`, the minimum of `b^(-1/2) + w b` over all `b`.
fn root_bound(w: Outward) -> Outward {
    Outward::exact(1.5) * (Outward::exact(2.0) * w).cbrt()
}

/// `g(w, cap)` from below. Within rounding of the place where the two forms meet the first is taken: the minimum over all `b` is never above the one below the cap.
fn least_sum(w: f64, cap: f64) -> Outward {
    if w > 0.0 && 2.0 * w * cap * cap.sqrt() >= 1.0 - 1e-12 {
        return root_bound(Outward::exact(w));
    }
    if cap == f64::INFINITY {
        let lo = if w < 0.0 { f64::NEG_INFINITY } else { 0.0 };
        return Outward { lo, hi: f64::INFINITY };
    }
    let cap = Outward::exact(cap);
    Outward::exact(1.0) / cap.sqrt() + Outward::exact(w) * cap
}
