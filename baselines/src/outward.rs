//! Arithmetic with outward rounding: an interval that contains the exact result whatever the rounding.
//!
//! IEEE 754 rounds each operation to the nearest number, so one step outwards from the rounded result contains the exact
//! one. Twice as wide as directed rounding would be, and it needs no change of the processor's mode.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// An interval `[lo, hi]` that contains the exact value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outward {
    /// Lower end.
    pub lo: f64,
    /// Upper end.
    pub hi: f64,
}

impl Outward {
    /// The interval of a single number.
    #[must_use]
    pub fn exact(x: f64) -> Self {
        Self { lo: x, hi: x }
    }

    /// Zero.
    pub const ZERO: Self = Self { lo: 0.0, hi: 0.0 };

    /// The interval from rounded ends, one step outwards each. NaN widens to everything.
    fn widened(lo: f64, hi: f64) -> Self {
        if lo.is_nan() || hi.is_nan() {
            return Self { lo: f64::NEG_INFINITY, hi: f64::INFINITY };
        }
        Self { lo: lo.next_down(), hi: hi.next_up() }
    }

    /// Square root of an interval without negative numbers; negative parts are cut off.
    #[must_use]
    pub fn sqrt(self) -> Self {
        let root = Self::widened(self.lo.max(0.0).sqrt(), self.hi.max(0.0).sqrt());
        Self { lo: root.lo.max(0.0), hi: root.hi }
    }

    /// Cube root of an interval without negative numbers; negative parts are cut off. The library's root is not taken on trust: a
    /// candidate counts once its cube, rounded outwards, lies on the right side.
    #[must_use]
    pub fn cbrt(self) -> Self {
        let (mut lo, mut hi) = (self.lo.max(0.0).cbrt().next_down().max(0.0), self.hi.max(0.0).cbrt().next_up());
        let mut step = f64::EPSILON;
        let cube = |x: f64| Self::exact(x) * Self::exact(x) * Self::exact(x);
        while lo > 0.0 && !(cube(lo).hi <= self.lo) {
            lo *= 1.0 - step;
            step *= 2.0;
            if step >= 1.0 {
                lo = 0.0;
            }
        }
        let mut step = f64::EPSILON;
        while hi < f64::INFINITY && !(cube(hi).lo >= self.hi) {
            hi *= 1.0 + step;
            step *= 2.0;
        }
        Self { lo, hi }
    }

    /// The smaller of the value and zero.
    #[must_use]
    pub fn min_zero(self) -> Self {
        Self { lo: self.lo.min(0.0), hi: self.hi.min(0.0) }
    }
}

impl Add for Outward {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::widened(self.lo + other.lo, self.hi + other.hi)
    }
}

impl Sub for Outward {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::widened(self.lo - other.hi, self.hi - other.lo)
    }
}

impl Neg for Outward {
    type Output = Self;
    fn neg(self) -> Self {
        Self { lo: -self.hi, hi: -self.lo }
    }
}

impl Mul for Outward {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if other.lo == other.hi {
            // By a point there are two products instead of four, and its sign says which is which.
            let ends = if other.lo >= 0.0 { [self.lo, self.hi] } else { [self.hi, self.lo] };
            return Self::widened(ends[0] * other.lo, ends[1] * other.lo);
        }
        let products = [self.lo * other.lo, self.lo * other.hi, self.hi * other.lo, self.hi * other.hi];
        if products.iter().any(|p| p.is_nan()) {
            return Self { lo: f64::NEG_INFINITY, hi: f64::INFINITY };
        }
        Self::widened(
            products.iter().copied().fold(f64::INFINITY, f64::min),
            products.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        )
    }
}

impl Div for Outward {
    type Output = Self;
    /// Division by an interval that contains zero gives everything.
    fn div(self, other: Self) -> Self {
        if other.lo <= 0.0 && other.hi >= 0.0 {
            return Self { lo: f64::NEG_INFINITY, hi: f64::INFINITY };
        }
        if self.lo >= 0.0 && other.lo > 0.0 {
            // Of positive numbers the extreme quotients are known: one rounding instead of two.
            return Self::widened(self.lo / other.hi, self.hi / other.lo);
        }
        self * Self::widened(1.0 / other.hi, 1.0 / other.lo)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_third_times_three_contains_one_and_is_narrow() {
        let third = Outward::exact(1.0) / Outward::exact(3.0);
        assert!(third.lo < third.hi);
        let one = third * Outward::exact(3.0);
        assert!(one.lo <= 1.0 && 1.0 <= one.hi && one.hi - one.lo < 4e-15);
    }

    #[test]
    fn square_root_of_two_squared_contains_two() {
        let root = Outward::exact(2.0).sqrt();
        let two = root * root;
        assert!(two.lo <= 2.0 && 2.0 <= two.hi);
    }

    #[test]
    fn cube_roots_are_narrow_and_their_cubes_contain_the_number() {
        for x in [0.0, 1e-300, 0.1, 2.0, 27.0, 1e200] {
            let root = Outward::exact(x).cbrt();
            let cube = root * root * root;
            assert!(cube.lo <= x && x <= cube.hi, "{x}: {root:?}");
            assert!(root.hi - root.lo <= 4e-15 * root.hi + 1e-99, "{x}: {root:?}");
        }
        assert_eq!(Outward::exact(-1.0).cbrt().lo, 0.0);
    }

    #[test]
    fn a_product_by_a_point_is_that_of_all_four_ends() {
        for (lo, hi) in [(1.0, 2.0), (-3.0, 2.0), (-3.0, -1.0)] {
            for factor in [1.7, -1.7] {
                let product = Outward { lo, hi } * Outward::exact(factor);
                let ends = [lo * factor, hi * factor];
                assert_eq!(product.lo, ends[0].min(ends[1]).next_down());
                assert_eq!(product.hi, ends[0].max(ends[1]).next_up());
            }
        }
        let everything = Outward { lo: f64::NEG_INFINITY, hi: f64::INFINITY } * Outward::ZERO;
        assert_eq!((everything.lo, everything.hi), (f64::NEG_INFINITY, f64::INFINITY));
    }

    #[test]
    fn division_by_zero_and_not_a_number_contain_everything() {
        for x in [Outward::exact(1.0) / Outward::exact(0.0), Outward::exact(f64::NAN) + Outward::ZERO] {
            assert_eq!((x.lo, x.hi), (f64::NEG_INFINITY, f64::INFINITY));
        }
    }
}
