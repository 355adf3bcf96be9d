//! The few vector operations the path conditioner needs, on fixed arrays.

/// `aᵀ b`.
#[inline(always)]
pub(crate) fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// Euclidean norm.
#[inline(always)]
pub(crate) fn norm<const N: usize>(a: &[f64; N]) -> f64 {
    libm::sqrt(dot(a, a))
}

/// `a + s b`.
#[inline(always)]
pub(crate) fn add_scaled<const N: usize>(a: &[f64; N], s: f64, b: &[f64; N]) -> [f64; N] {
    let mut sum = *a;
    for (x, y) in sum.iter_mut().zip(b) {
        *x += s * y;
    }
    sum
}

/// `s a`.
#[inline(always)]
pub(crate) fn scaled<const N: usize>(s: f64, a: &[f64; N]) -> [f64; N] {
    let mut product = *a;
    for x in &mut product {
        *x *= s;
    }
    product
}

/// `a - b`.
#[inline(always)]
pub(crate) fn difference<const N: usize>(a: &[f64; N], b: &[f64; N]) -> [f64; N] {
    add_scaled(a, -1.0, b)
}

/// Whether every component is a finite number: 0 times it is then 0, and NaN otherwise. One branch instead of `N`.
#[inline(always)]
pub(crate) fn finite<const N: usize>(a: &[f64; N]) -> bool {
    a.iter().map(|x| 0.0 * x).sum::<f64>() == 0.0
}
