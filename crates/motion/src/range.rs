/// A closed interval of numbers, for bounds that hold over a span of time. Rounding is to nearest, not outward.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Smallest number.
    pub lower: f64,
    /// Largest number.
    pub upper: f64,
}

impl Range {
    /// The interval of one number.
    #[must_use]
    pub fn point(x: f64) -> Self {
        Self { lower: x, upper: x }
    }

    /// The smallest interval around this one and `x`.
    #[must_use]
    pub fn including(self, x: f64) -> Self {
        Self { lower: self.lower.min(x), upper: self.upper.max(x) }
    }

    /// The smallest interval around both.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        self.including(other.lower).including(other.upper)
    }

    /// All sums.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self { lower: self.lower + other.lower, upper: self.upper + other.upper }
    }

    /// All products.
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        Self::point(self.lower * other.lower)
            .including(self.lower * other.upper)
            .including(self.upper * other.lower)
            .including(self.upper * other.upper)
    }

    /// Largest absolute value.
    #[must_use]
    pub fn magnitude(self) -> f64 {
        self.lower.abs().max(self.upper.abs())
    }
}
