/// A closed range of joint positions; an end may be infinite, which leaves the range open on that side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PositionRange {
    /// Smallest position, rad or m.
    pub lower: f64,
    /// Largest position, rad or m.
    pub upper: f64,
}

impl PositionRange {
    /// True if a position lies in the range; false for NaN.
    #[must_use]
    pub fn contains(&self, q: f64) -> bool {
        q >= self.lower && q <= self.upper
    }
}
