//! Travel time of a cell on which `b` is a quadratic, in closed form.
//!
//! With `z = (b0 - 2 m + b1) / (√b0 + √b1)²`
//!
//! ```text
//! T = ∫ b^(-1/2) dx = 2 h / (√b0 + √b1) · A(z),   A(z) = artanh(√z)/√z for z > 0,  arctan(√-z)/√-z for z < 0,  = sum z^j/(2 j + 1)
//! ```
//!
//! which needs `b > 0` in the cell: `b0, b1 > 0` and `m > -√(b0 b1)`, that is `z < 1`. `A(z) = 2 A(z') / (1 + r)` with `r = √(1 - z)` and
//! `z' = z / (1 + r)²` (half the argument) brings any `z` to where the series is short. Only sums, products, quotients and square roots occur, so
//! the result is enclosed by outward rounding.

use crate::outward::Outward;

/// Below this the series is summed.
const SMALL: f64 = 0.1;
/// Halvings of the argument: 60 reach every `z` that is not 1 to the last place.
const HALVINGS: usize = 60;

/// Travel time of a cell, enclosed; `[0, ∞]` unless `b > 0` is sure in the cell.
pub(crate) fn cell_time(length: f64, b: [f64; 3]) -> Outward {
    let all = Outward { lo: 0.0, hi: f64::INFINITY };
    if !(b.iter().all(|b| b.is_finite()) && b[0] > 0.0 && b[2] > 0.0) {
        return all;
    }
    let [b0, m, b1] = b.map(Outward::exact);
    let roots = b0.sqrt() + b1.sqrt();
    let z = ((b0 - m) + (b1 - m)) / (roots * roots);
    let two = Outward::exact(2.0);
    match shape(z) {
        Some(shape) => two * Outward::exact(length) / roots * shape,
        None => all,
    }
}

/// `A(z)`.
fn shape(mut z: Outward) -> Option<Outward> {
    let one = Outward::exact(1.0);
    let mut factor = one;
    for _ in 0..HALVINGS {
        if !(z.hi < 1.0) {
            return None;
        }
        if z.lo > -SMALL && z.hi < SMALL {
            return Some(factor * series(z));
        }
        let r = one + (one - z).sqrt();
        factor = factor * Outward::exact(2.0) / r;
        z = z / (r * r);
    }
    None
}

/// `sum z^j / (2 j + 1)` for `|z| < 0.1`, by Horner's scheme, with the rest after `count` terms below `|z|^count / (2 count + 1) / (1 - |z|)`.
fn series(z: Outward) -> Outward {
    let size = z.lo.abs().max(z.hi.abs());
    let (mut count, mut power) = (1, size);
    while power > 1e-17 && count < 20 {
        power *= size;
        count += 1;
    }
    // The power was rounded fewer than 20 times; 1 - |z| is above 0.89.
    let rest = power * (1.0 + 40.0 * f64::EPSILON) * 1.2 / (2 * count + 1) as f64 + f64::MIN_POSITIVE;
    let mut sum = Outward { lo: -rest, hi: rest };
    if count > 1 {
        let mut horner = Outward::ZERO;
        for j in (0..count).rev() {
            horner = horner * z + Outward::exact(1.0) / Outward::exact((2 * j + 1) as f64);
        }
        sum = sum + horner;
    } else {
        sum = sum + Outward::exact(1.0);
    }
    sum
}

/// The same in plain arithmetic, for positions in time; infinity unless `b > 0` in the cell.
pub(crate) fn plain_cell_time(length: f64, b: [f64; 3]) -> f64 {
    let roots = b[0].max(0.0).sqrt() + b[2].max(0.0).sqrt();
    let z = ((b[0] - b[1]) + (b[2] - b[1])) / (roots * roots);
    if !(z < 1.0) {
        return f64::INFINITY;
    }
    let shape = if z.abs() < 1e-3 {
        1.0 + z * (1.0 / 3.0 + z * (0.2 + z * (1.0 / 7.0 + z / 9.0)))
    } else if z > 0.0 {
        z.sqrt().atanh() / z.sqrt()
    } else {
        (-z).sqrt().atan() / (-z).sqrt()
    };
    2.0 * length / roots * shape
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Composite Gauss (two points) on 20000 parts: its error is far below the bound that is asked.
    fn by_quadrature(length: f64, b: [f64; 3]) -> f64 {
        let n = 20_000;
        let mut sum = 0.0;
        for k in 0..n {
            for shift in [0.5 - 0.5 / 3.0_f64.sqrt(), 0.5 + 0.5 / 3.0_f64.sqrt()] {
                let t = (f64::from(k) + shift) / f64::from(n);
                let u = 1.0 - t;
                sum += 0.5 / (b[0] * u * u + 2.0 * b[1] * t * u + b[2] * t * t).sqrt();
            }
        }
        sum * length / f64::from(n)
    }

    #[test]
    fn closed_form_is_the_integral_for_bent_and_straight_quadratics() {
        for b in
            [[1.0, 1.0, 1.0], [1.0, 2.0, 3.0], [0.5, 4.0, 0.2], [2.0, -0.5, 1.0], [3.0, 0.1, 0.2], [1.0, 1.001, 1.0]]
        {
            let (time, reference) = (cell_time(0.7, b), by_quadrature(0.7, b));
            assert!((time.lo - reference).abs() < 1e-9 * reference, "{b:?}: {time:?} {reference}");
            assert!(time.lo < time.hi && time.hi - time.lo < 1e-13 * time.hi, "{b:?}: {time:?}");
            assert!((plain_cell_time(0.7, b) - time.lo).abs() < 1e-13 * time.lo, "{b:?}");
        }
    }

    #[test]
    fn a_quadratic_that_touches_zero_or_is_not_a_number_takes_up_to_for_ever() {
        for b in [[1.0, -1.0, 1.0], [0.0, 1.0, 1.0], [1.0, -2.0, 1.0], [1.0, f64::NAN, 1.0], [1.0, 1.0, f64::INFINITY]]
        {
            assert_eq!(cell_time(1.0, b).hi, f64::INFINITY, "{b:?}");
        }
    }
}
