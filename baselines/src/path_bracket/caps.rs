//! Bounds of `b` that hold for every feasible motion, so that the lower bound may use them.
//!
//! - Speed: `b <= (v_i / |q_x,i|)²`.
//! - Pair: eliminate `u` from the accelerations `e_i` of two joints. With `f = q_xx,i q_x,j - q_xx,j q_x,i`, `f b = q_x,j e_i - q_x,i e_j`.
//! - Kinematic: a joint that starts at rest has `q_x² b = q̇² <= 2 U ∫ |q_x| dx`; the same backwards from a rest end.
//!
//! Functions called `at` are plain arithmetic, for guides. The others round outwards and hold on a whole interval.

use super::bernstein::{PRODUCT, Polynomial, grown, product};
use super::cells::{Cell, without_zero_at_start};
use super::path::{End, JointLimits, Sense};

/// Greatest acceleration limit of a joint in either sense.
fn either(limits: &JointLimits, joint: usize) -> f64 {
    limits.acceleration(joint, Sense::Upper).max(limits.acceleration(joint, Sense::Lower))
}

/// Speed and pair bound at `t` in a cell, a guide.
pub(crate) fn at(cell: &Cell, limits: &JointLimits, t: f64) -> f64 {
    let joints = limits.joints();
    let first: Vec<f64> = cell.derivative.iter().map(|p| p.at(t)).collect();
    let slowness = (0..joints).map(|j| first[j].abs() / limits.speed(j)).fold(0.0, f64::max);
    let mut cap = 1.0 / (slowness * slowness);
    if !limits.has_acceleration() {
        return cap;
    }
    let bends: Vec<f64> = cell.derivative.iter().map(|p| slope_at(p, t) / cell.length).collect();
    let size = first.iter().fold(0.0, |m: f64, a| m.max(a.abs()));
    let largest = cell.derivative.iter().map(Polynomial::largest).fold(0.0, f64::max);
    let pairs = |sense: Sense, i: usize| limits.acceleration(i, sense);
    for i in 0..joints {
        if size < 1e-9 * largest {
            cap = cap.min(either(limits, i) / bends[i].abs());
            continue;
        }
        for j in 0..i {
            let f = bends[i] * first[j] - bends[j] * first[i];
            // f b = a_j e_i - a_i e_j: the largest value of the right side in the sense of f.
            let sign = f.signum();
            let sense = |x: f64| if x > 0.0 { Sense::Upper } else { Sense::Lower };
            let high =
                first[j].abs() * pairs(sense(sign * first[j]), i) + first[i].abs() * pairs(sense(-sign * first[i]), j);
            if f != 0.0 && high.is_finite() {
                cap = cap.min(high / f.abs());
            }
        }
    }
    cap
}

/// Derivative by `t` of a polynomial, a guide.
pub(crate) fn slope_at(p: &Polynomial, t: f64) -> f64 {
    let (c, n) = (p.coefficients(), p.degree());
    if n == 0 {
        return 0.0;
    }
    let u = 1.0 - t;
    let (mut power, mut sum) = (1.0, c[1] - c[0]);
    for i in 1..n {
        power *= t;
        sum = sum * u + power * super::bernstein::binomial(n - 1, i) * (c[i + 1] - c[i]);
    }
    sum * n as f64
}

/// What speed limits say about an interval.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slowness {
    /// `max_i |q_x,i| / v_i` is nowhere below this and nowhere above `most`.
    pub(crate) least: f64,
    pub(crate) most: f64,
    /// Lower bound of the mean of `max_i |q_x,i| / v_i`.
    pub(crate) mean: f64,
}

/// Slowness of an interval on which the joints' derivatives are these polynomials.
pub(crate) fn slowness(joints: &[Polynomial], limits: &JointLimits) -> Slowness {
    let mut result = Slowness { least: 0.0, most: 0.0, mean: 0.0 };
    for (j, p) in joints.iter().enumerate() {
        let v = limits.speed(j);
        if v.is_finite() {
            let (low, high) = p.absolute_range();
            result.most = result.most.max((high / v).next_up());
            result.least = result.least.max((low / v).next_down());
            // A sum of at most 10 numbers: below 10 epsilon of their largest absolute value each.
            let sum: f64 = p.coefficients().iter().sum();
            let count = (p.degree() + 1) as f64;
            let mean = ((sum.abs() - 10.0 * f64::EPSILON * p.largest() * count) / count).next_down() - p.radius;
            result.mean = result.mean.max((mean.next_down() / v).next_down());
        }
    }
    result
}

/// Bound of `b` on an interval of length `length` from pairs of acceleration limits.
pub(crate) fn pair(joints: &[Polynomial], length: f64, limits: &JointLimits) -> f64 {
    let mut cap = f64::INFINITY;
    for i in 0..joints.len() {
        for j in 0..i {
            if limits.is_accelerated(i) && limits.is_accelerated(j) {
                cap = cap.min(pair_of([&joints[i], &joints[j]], [i, j], length, limits));
            }
        }
    }
    cap
}

/// One pair. `length f` has Bernstein coefficients `n (Dq_i · q_j - Dq_j · q_i)` of degree `2 n - 1`.
fn pair_of(q: [&Polynomial; 2], joints: [usize; 2], length: f64, limits: &JointLimits) -> f64 {
    let n = q[0].degree();
    if n == 0 {
        return f64::INFINITY;
    }
    let (mut bends, mut size) = ([[0.0; super::bernstein::COEFFICIENTS]; 2], [0.0_f64; 2]);
    for (side, q) in q.iter().enumerate() {
        for l in 0..n {
            bends[side][l] = n as f64 * (q.coefficients()[l + 1] - q.coefficients()[l]);
            size[side] = size[side].max(bends[side][l].abs());
        }
    }
    let (mut left, mut right) = ([0.0; PRODUCT], [0.0; PRODUCT]);
    product(&bends[0][..n], q[1].coefficients(), &mut left);
    product(&bends[1][..n], q[0].coefficients(), &mut right);
    let largest = [q[0].largest(), q[1].largest()];
    // Products: below 32 epsilon of the largest ones; a difference more. Radii: of bends 2 n radius.
    let terms = size[0] * largest[1] + size[1] * largest[0];
    let bend_radius = |side: usize| 2.0 * n as f64 * q[side].radius;
    let by_radius = bend_radius(0) * (largest[1] + q[1].radius)
        + bend_radius(1) * (largest[0] + q[0].radius)
        + size[0] * q[1].radius
        + size[1] * q[0].radius;
    let slack = grown(2.0 * by_radius, 64.0 * terms);
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for k in 0..2 * n {
        let f = left[k] - right[k];
        (low, high) = (low.min(f), high.max(f));
    }
    let (low, high) = ((low - slack).next_down(), (high + slack).next_up());
    let sign = if low > 0.0 { 1.0 } else { -1.0 };
    let least = if low > 0.0 { low } else { -high };
    if !(least > 0.0) {
        return f64::INFINITY;
    }
    let most = most_of(q[1], sign, joints[0], limits) + most_of(q[0], -sign, joints[1], limits);
    // Six roundings.
    (most * length / least * (1.0 + 8.0 * f64::EPSILON)).next_up()
}

/// Upper bound of `sign q_x e` for the acceleration `e` of a joint.
fn most_of(q: &Polynomial, sign: f64, joint: usize, limits: &JointLimits) -> f64 {
    let (low, high) = q.range();
    let (plus, minus) = if sign > 0.0 { (high, -low) } else { (-low, high) };
    let by = |x: f64, sense: Sense| if x > 0.0 { (x * limits.acceleration(joint, sense)).next_up() } else { 0.0 };
    by(plus, Sense::Upper).max(by(minus, Sense::Lower))
}

/// Kinematic bound of `b` in every cell of a piece; infinite where no rest end gives one.
pub(crate) fn kinematic(cells: &[&Cell], ends: [End; 2], limits: &JointLimits) -> Vec<f64> {
    let count = cells.len();
    let mut caps = vec![f64::INFINITY; count];
    if limits.has_acceleration() {
        for (end, backwards) in ends.into_iter().zip([false, true]) {
            if end == End::Rest {
                kinematic_from(cells, backwards, limits, &mut caps);
            }
        }
    }
    caps
}

/// From one rest end: way of each joint summed upwards cell by cell.
fn kinematic_from(cells: &[&Cell], backwards: bool, limits: &JointLimits, caps: &mut [f64]) {
    let count = cells.len();
    let mut way = vec![0.0; limits.joints()];
    for step in 0..count {
        let k = if backwards { count - 1 - step } else { step };
        let cell = cells[k];
        for (joint, q) in cell.derivative.iter().enumerate() {
            let limit = either(limits, joint);
            if !limit.is_finite() {
                continue;
            }
            let (low, high) = q.absolute_range();
            way[joint] = (way[joint] + (high * cell.length).next_up()).next_up();
            let cap = if step == 0 {
                beside_rest(q, backwards, cell.length * limit)
            } else {
                2.0 * limit * way[joint] / (low * low)
            };
            if cap >= 0.0 {
                caps[k] = caps[k].min((cap * (1.0 + 8.0 * f64::EPSILON)).next_up());
            }
        }
    }
}

/// In the cell at the rest end `q_x = t q̃(t)`: `q_x² b <= 2 U h ∫_0^t τ |q̃|`, so `b <= U h max|q̃| / (min|q̃|)²`.
fn beside_rest(q: &Polynomial, backwards: bool, length_times_limit: f64) -> f64 {
    if q.degree() == 0 {
        return f64::INFINITY;
    }
    let mut c = q.coefficients().to_vec();
    if backwards {
        c.reverse();
    }
    let mut divided = without_zero_at_start(&c);
    // Coefficient i is n / (i + 1) <= n times one of q, rounded twice.
    divided.radius = grown(q.degree() as f64 * q.radius, 2.0 * divided.largest());
    let (low, high) = divided.absolute_range();
    length_times_limit * high / (low * low)
}
