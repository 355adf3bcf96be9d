//! The chain's factor by square-root-free Givens rotations: pivots are sums of positive numbers and cannot lose their sign.
//!
//! Source: Gentleman, "Least squares computations by Givens transformations without square roots", J. Inst. Maths Applics 12 (1973).

use super::chain::{ChainFactor, Terms};

/// Fills a factor from the terms of each cell; twice as slow as elimination.
pub(crate) fn rotate<'t>(factor: &mut ChainFactor, terms: &impl Fn(usize) -> [Terms<'t>; 2]) {
    let mut carried = 0.0;
    for k in 0..factor.upper.len() {
        let (mut d, mut b) = ([carried, 0.0, 0.0], [0.0; 3]);
        for (weights, forms) in terms(k) {
            for (q, a) in weights.iter().zip(forms) {
                add(&mut d, &mut b, *q, *a);
            }
        }
        (factor.upper[k], factor.pivots[k], carried) = (b, [d[0], d[1]], d[2]);
    }
    factor.last = carried;
}

/// Adds `q a aᵀ` to `Bᵀ D B`.
fn add(d: &mut [f64; 3], b: &mut [f64; 3], mut q: f64, mut a: [f64; 3]) {
    if a[0] != 0.0 {
        let pivot = d[0] + q * a[0] * a[0];
        let gain = q * a[0] / pivot;
        for (j, entry) in [(1, 0), (2, 1)] {
            a[j] -= a[0] * b[entry];
            b[entry] += gain * a[j];
        }
        q *= d[0] / pivot;
        d[0] = pivot;
    }
    if a[1] != 0.0 {
        let pivot = d[1] + q * a[1] * a[1];
        if pivot > 0.0 {
            a[2] -= a[1] * b[2];
            b[2] += q * a[1] / pivot * a[2];
            q *= d[1] / pivot;
        }
        d[1] = pivot;
    }
    d[2] += q * a[2] * a[2];
}
