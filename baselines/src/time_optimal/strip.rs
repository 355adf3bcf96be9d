use slideway_path::{LimitKind, LinearLimit};

/// A limit at one point of an interval, as both of its rows:
/// `lower <= before · x_k + after · x_{k+1} <= upper`.
///
/// At the share `θ` of the interval `b = (1 - θ) b_k + θ b_{k+1}` and `s̈ = (b_{k+1} - b_k) / (2 Δs)`, so
/// `a s̈ + c b + d` between bounds has `before = (1 - θ) c - a / (2 Δs)` and `after = θ c + a / (2 Δs)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strip {
    /// Coefficient of `x_k`.
    pub before: f64,
    /// Coefficient of `x_{k+1}`.
    pub after: f64,
    /// Lower bound; may be infinite.
    pub lower: f64,
    /// Upper bound; may be infinite.
    pub upper: f64,
    /// Where it comes from.
    pub source: RowSource,
}

/// The limit behind a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RowSource {
    /// Quantity that is limited.
    pub kind: LimitKind,
    /// Joint, or side of a polygon, counted from 0.
    pub index: u16,
    /// 0: the limit is taken at `node`; `j > 0`: at sample `j - 1` of the interval after `node`.
    pub sample: u16,
    /// Node, counted from 0.
    pub node: u32,
}

/// Bound of a strip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    /// The lower one.
    Lower,
    /// The upper one.
    Upper,
}

/// One row: `before · x_k + after · x_{k+1} <= bound`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// The interval `k`.
    pub interval: usize,
    /// Coefficient of `x_k`.
    pub before: f64,
    /// Coefficient of `x_{k+1}`.
    pub after: f64,
    /// Right-hand side, of any sign.
    pub bound: f64,
    /// Where it comes from.
    pub source: RowSource,
}

/// A place in an interval: the share `θ` of it, and half the inverse of its length.
#[derive(Clone, Copy)]
pub(super) struct Place {
    pub(super) share: f64,
    pub(super) half_inverse: f64,
}

/// The same bound upwards and downwards, everywhere along the path, scaled as [`Strip::new`] scales.
#[derive(Clone, Copy)]
pub(super) struct SymmetricBound {
    scale: f64,
    scaled: f64,
}

impl SymmetricBound {
    pub(super) fn new(bound: f64) -> Self {
        let scale = power_of_two(bound).recip();
        Self { scale, scaled: bound * scale }
    }

    /// The strip of `first s̈ + second b` within the bound, equal to that of the [`LinearLimit`]: scaling by a power of two commutes
    /// with rounding.
    pub(super) fn strip(&self, first: f64, second: f64, place: Place, source: RowSource) -> Strip {
        let (slope, square) = (first * place.half_inverse * self.scale, second * self.scale);
        Strip {
            before: (1.0 - place.share) * square - slope,
            after: place.share * square + slope,
            lower: -self.scaled,
            upper: self.scaled,
            source,
        }
    }
}

impl Strip {
    /// The strip of a limit, scaled by a power of two (hence exactly) so that the distance of its bounds is of order 1.
    pub(super) fn new(limit: &LinearLimit, place: Place, source: RowSource) -> Self {
        let slope = limit.acceleration * place.half_inverse;
        let scale = power_of_two(limit.half_range()).recip();
        Self {
            before: ((1.0 - place.share) * limit.square - slope) * scale,
            after: (place.share * limit.square + slope) * scale,
            lower: (limit.lower - limit.offset) * scale,
            upper: (limit.upper - limit.offset) * scale,
            source,
        }
    }

    /// Half the distance of the bounds, or the size of the only one: what a violation is measured by.
    pub(super) fn half_range(&self) -> f64 {
        let half = 0.5 * (self.upper - self.lower);
        if half > 0.0 && half < f64::INFINITY { half } else { 1.0 }
    }

    /// An upper bound on how far outside the strip a pair of values is, in the row's own units; negative inside.
    ///
    /// Two products, a sum and a difference, each rounded once: the error is at most `2 ε (|α x| + |β y| + |bound|)` with the
    /// unit round-off `ε / 2` to first order; 4 instead of 2 covers the higher orders and the sum's own rounding.
    pub(super) fn overshoot(&self, x: f64, y: f64) -> f64 {
        let (first, second) = (self.before * x, self.after * y);
        let value = first + second;
        let rounding = 4.0 * f64::EPSILON * (first.abs() + second.abs()) + f64::MIN_POSITIVE;
        // An infinite bound is never left: its difference is minus infinity, and stays so with a finite addition.
        let beyond = |difference: f64, bound: f64| difference + 4.0 * f64::EPSILON * bound.abs().min(f64::MAX);
        let (over, under) = (beyond(value - self.upper, self.upper), beyond(self.lower - value, self.lower));
        (if over >= under { over } else { under }) + rounding
    }

    /// [`Strip::overshoot`] as a share of the half range.
    pub(super) fn excess(&self, x: f64, y: f64) -> f64 {
        self.overshoot(x, y) / self.half_range()
    }

    /// The row of one bound, unless that is infinite.
    pub(super) fn row(&self, interval: usize, side: Side) -> Option<Row> {
        let (sign, bound) = match side {
            Side::Upper => (1.0, self.upper),
            Side::Lower => (-1.0, -self.lower),
        };
        let row = Row { interval, before: sign * self.before, after: sign * self.after, bound, source: self.source };
        bound.is_finite().then_some(row)
    }

    /// True if the numbers are usable: finite coefficients, bounds that are numbers in the right order.
    pub(super) fn is_valid(&self) -> bool {
        self.before.is_finite() && self.after.is_finite() && self.lower <= self.upper
    }
}

/// The largest power of two up to a positive normal number; 1 for anything else.
pub(super) fn power_of_two(x: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
    if x.is_normal() && x > 0.0 { f64::from_bits(x.to_bits() & EXPONENT) } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_symmetric_bound_makes_the_strip_of_its_limit_to_the_bit(
            first in -10.0..10.0_f64,
            second in -100.0..100.0_f64,
            bound in prop_oneof![1e-6..1e6_f64, Just(f64::INFINITY), Just(0.0)],
            share in prop_oneof![Just(0.0), Just(1.0), 0.0..1.0_f64],
            half_inverse in 1e-3..1e6_f64,
        ) {
            let source = RowSource { kind: LimitKind::JointAcceleration, index: 0, sample: 0, node: 0 };
            let place = Place { share, half_inverse };
            let limit = LinearLimit::joint_acceleration(0, first, second, -bound, bound);
            let strip = SymmetricBound::new(bound).strip(first, second, place, source);
            prop_assert_eq!(strip, Strip::new(&limit, place, source));
        }
    }
}
