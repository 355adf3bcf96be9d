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

/// True if every component is a finite number: 0 times it is then 0, and NaN otherwise. One branch instead of `N`.
#[inline(always)]
pub(crate) fn finite<const N: usize>(a: &[f64; N]) -> bool {
    a.iter().map(|x| 0.0 * x).sum::<f64>() == 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_sums_and_lengths_are_those_of_small_numbers() {
        let (a, b) = ([3.0, -4.0], [2.0, 5.0]);
        assert_eq!(dot(&a, &b), -14.0);
        assert_eq!(norm(&a), 5.0);
        assert_eq!(add_scaled(&a, 0.5, &b), [4.0, -1.5]);
        assert_eq!(scaled(3.0, &a), [9.0, -12.0]);
        assert_eq!(difference(&a, &b), [1.0, -9.0]);
    }

    #[test]
    fn one_component_that_is_not_finite_is_enough() {
        assert!(finite(&[f64::MAX, f64::MIN, -0.0]));
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(!finite(&[1.0, bad, 2.0]) && !finite(&[bad, -bad, 0.0]));
        }
    }
}
