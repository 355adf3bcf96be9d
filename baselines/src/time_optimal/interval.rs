use super::strip::{Side, Strip};
use crate::outward::Outward;

/// A line in the plane of `(x, y)`, by where it comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Line {
    /// The bound on the neighbour's value `y`.
    Neighbour,
    /// A strip, by its place in the program's list.
    Strip(usize),
}

/// Reason why `x` is bounded as it is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) enum Reason {
    /// The node's own box.
    #[default]
    Box,
    /// One row that contains `y` little or not at all, with `y` at the end of its range that leaves most.
    Row(usize, Side),
    /// `low` must not lie above `high`: `(p_low - p_high) x <= q_high - q_low`.
    Pair { low: Line, high: Line },
}

/// A proof that an interval has no point: `low` lies above `high` for every `x` that `bound` leaves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Clash {
    /// A row without unknowns whose bound is negative.
    Row(usize, Side),
    /// The bounds on `x` exclude each other.
    Bounds { low: Reason, high: Reason },
    /// Two lines and the bound on `x` that would have to give way.
    Pair { low: Line, high: Line, bound: Reason },
}

/// The unknown that is projected out, of the two.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Direction {
    /// `x` is the node before, `y` the node after.
    Backward,
    /// `x` is the node after, `y` the node before.
    Forward,
}

impl Direction {
    /// Coefficients of `x` and `y`.
    pub(super) fn coefficients(self, strip: &Strip) -> (f64, f64) {
        match self {
            Self::Backward => (strip.before, strip.after),
            Self::Forward => (strip.after, strip.before),
        }
    }
}

/// End of the feasible range of `x`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Extreme {
    /// The least `x`.
    Least,
    /// The greatest `x`.
    Greatest,
}

/// The rows of one interval as lines `y = p x + q`: a two-variable linear program, ready to be solved for the extremes of
/// `x` or of `y` at a given `x`. Reused from interval to interval.
///
/// Each row gives two parallel lines, `y = slope x + low` and `y = slope x + high`, kept in columns of their own. The first line is the
/// neighbour's range; a row without `y` is no line and stands there as one that bounds nothing, and one with little `y` bounds `x` too.
#[derive(Default)]
pub(super) struct IntervalProgram {
    slope: Vec<f64>,
    low: Vec<f64>,
    high: Vec<f64>,
    first: usize,
    x: [f64; 2],
    reasons: [Reason; 2],
}

/// The highest lower line and the lowest upper line at some `x`, by their place in the columns.
struct Envelope {
    low_line: usize,
    high_line: usize,
}

/// Slope from which a row counts as one of `x` first: it is turned into a bound on `x`, and its line is widened by rounding.
///
/// The envelopes are compared in units of `y`. A line of slope `p` is known there to `ε |p| x` only, so that a row which weighs `y` next
/// to nothing would drown the others in its rounding: the greatest `x` would be left where the others are broken. Below this slope
/// the rounding, `1024 ε = 2e-13` of the other rows' numbers, is far below what a profile may exceed a row by.
const STEEP: f64 = 1024.0;

/// Lines looked at side by side: two registers of two numbers on the smallest x86-64.
const LANES: usize = 4;

impl IntervalProgram {
    /// Takes the strips `first..` of an interval, the box of `x` and the range of `y`.
    pub(super) fn load(
        &mut self,
        strips: &[Strip],
        first: usize,
        direction: Direction,
        x: [f64; 2],
        y: [f64; 2],
    ) -> Result<(), Clash> {
        self.clear(strips.len() + 1);
        self.set(0, 0.0, y);
        (self.x, self.first) = (x, first);
        self.reasons = [Reason::Box; 2];
        for (offset, strip) in strips.iter().enumerate() {
            let (near, far) = direction.coefficients(strip);
            let inverse = far.recip();
            let slope = -near * inverse;
            let (a, b) = (strip.lower * inverse, strip.upper * inverse);
            let range = if a < b { [a, b] } else { [b, a] };
            // Not for numbers that are none: a row without `y` is as steep as can be.
            if slope.abs() <= STEEP && inverse.abs() < f64::INFINITY {
                self.set(offset + 1, slope, range);
                continue;
            }
            self.bound_x(strip, [near, far], y, first + offset)?;
            if slope.abs() < f64::INFINITY && inverse.abs() < f64::INFINITY {
                self.set(offset + 1, slope, Self::widened(range, y));
            }
        }
        if self.x[0] > self.x[1] {
            return Err(Clash::Bounds { low: self.reasons[0], high: self.reasons[1] });
        }
        Ok(())
    }

    /// As many lines that bound nothing, up to a multiple of [`LANES`].
    fn clear(&mut self, lines: usize) {
        let padded = lines.next_multiple_of(LANES);
        for (column, nothing) in
            [(&mut self.slope, 0.0), (&mut self.low, f64::NEG_INFINITY), (&mut self.high, f64::INFINITY)]
        {
            column.clear();
            column.resize(padded, nothing);
        }
    }

    fn set(&mut self, line: usize, slope: f64, range: [f64; 2]) {
        (self.slope[line], self.low[line], self.high[line]) = (slope, range[0], range[1]);
    }

    /// Where a line comes from.
    fn line(&self, line: usize) -> Line {
        if line == 0 { Line::Neighbour } else { Line::Strip(self.first + line - 1) }
    }

    /// A steep line's range, widened by what rounding can move it.
    ///
    /// With the unit round-off `u = ε / 2`, slope and offset are off by `2 u` of themselves, their product with `x` and the sum by `u`
    /// each, and the bound on `x` that the row gives by `3 u`: `7 u (|slope| x + |offset|)` at the most, of which `8 u = 4 ε` also
    /// covers the higher orders. Where the line passes through the range of `y`, which is where it matters, `|slope| x` is at most
    /// `|offset| + y`. The row itself gives way by `8 ε` of its bound.
    fn widened([low, high]: [f64; 2], y: [f64; 2]) -> [f64; 2] {
        let rounding = |offset: f64| 4.0 * f64::EPSILON * (2.0 * offset.abs() + y[1]);
        [low - rounding(low), high + rounding(high)]
    }

    /// A row with little or no `y` bounds `x`, whatever `y` is in its range, or holds everywhere, or nowhere.
    fn bound_x(&mut self, strip: &Strip, [near, far]: [f64; 2], y: [f64; 2], index: usize) -> Result<(), Clash> {
        // Nothing for a weight of zero, whose product with an infinite bound would be no number.
        let [a, b] = if far == 0.0 { [0.0; 2] } else { y.map(|y| far * y) };
        let (lower, upper) = (strip.lower - a.max(b), strip.upper - a.min(b));
        if near == 0.0 {
            if lower > 0.0 {
                return Err(Clash::Row(index, Side::Lower));
            }
            return if upper < 0.0 { Err(Clash::Row(index, Side::Upper)) } else { Ok(()) };
        }
        let (a, b) = (lower / near, upper / near);
        let sides = [(a, Side::Lower), (b, Side::Upper)];
        let [least, greatest] = if near > 0.0 { sides } else { [sides[1], sides[0]] };
        if least.0 > self.x[0] {
            (self.x[0], self.reasons[0]) = (least.0, Reason::Row(index, least.1));
        }
        if greatest.0 < self.x[1] {
            (self.x[1], self.reasons[1]) = (greatest.0, Reason::Row(index, greatest.1));
        }
        Ok(())
    }

    /// The greatest value of a lower line and the least of an upper one.
    fn range_at(&self, x: f64) -> [f64; 2] {
        let (mut low, mut high) = ([f64::NEG_INFINITY; LANES], [f64::INFINITY; LANES]);
        let (slopes, _) = self.slope.as_chunks::<LANES>();
        let (lows, _) = self.low.as_chunks::<LANES>();
        let (highs, _) = self.high.as_chunks::<LANES>();
        for (slopes, (lows, highs)) in slopes.iter().zip(lows.iter().zip(highs)) {
            for lane in 0..LANES {
                let rise = slopes[lane] * x;
                let (below, above) = (rise + lows[lane], rise + highs[lane]);
                low[lane] = if below > low[lane] { below } else { low[lane] };
                high[lane] = if above < high[lane] { above } else { high[lane] };
            }
        }
        [low.into_iter().fold(f64::NEG_INFINITY, f64::max), high.into_iter().fold(f64::INFINITY, f64::min)]
    }

    /// The lines that attain [`IntervalProgram::range_at`].
    fn envelope(&self, x: f64) -> Envelope {
        let [low, high] = self.range_at(x);
        let at = |offsets: &[f64], value: f64| {
            let lines = self.slope.iter().zip(offsets);
            lines.map(|(slope, offset)| slope * x + offset).position(|y| y == value).unwrap_or(0)
        };
        Envelope { low_line: at(&self.low, low), high_line: at(&self.high, high) }
    }

    /// The least or greatest `x` for which some `y` keeps every row.
    ///
    /// The gap `F(x) = max low - min high` is convex and piecewise linear, and `x` is feasible where `F <= 0`. Newton's method
    /// from the end of the box stops at the root after finitely many steps, each of which eliminates `y` from one pair of
    /// rows; a slope of `F` that leads away from the box proves that there is none.
    pub(super) fn extreme(&self, which: Extreme) -> Result<(f64, Reason), Clash> {
        let (start, far, sign) = match which {
            Extreme::Least => (0, 1, -1.0),
            Extreme::Greatest => (1, 0, 1.0),
        };
        let (mut x, mut reason) = (self.x[start], self.reasons[start]);
        // Each step takes another pair of lines; the bound only guards against cycling through rounding.
        for _ in 0..4 * self.slope.len() + 8 {
            let [low, high] = self.range_at(x);
            if !(low > high) {
                break;
            }
            let e = self.envelope(x);
            let pair = (self.line(e.low_line), self.line(e.high_line));
            let slope = self.slope[e.low_line] - self.slope[e.high_line];
            if !(slope * sign > 0.0) {
                return Err(Clash::Pair { low: pair.0, high: pair.1, bound: reason });
            }
            let next = (self.high[e.high_line] - self.low[e.low_line]) / slope;
            if !((x - next) * sign > 0.0) {
                break;
            }
            if (self.x[far] - next) * sign > 0.0 {
                return Err(Clash::Pair { low: pair.0, high: pair.1, bound: self.reasons[far] });
            }
            (x, reason) = (next, Reason::Pair { low: pair.0, high: pair.1 });
        }
        Ok((x, reason))
    }

    /// The greatest value after an interval that its strips allow up to rounding, given the value `x` before it.
    ///
    /// `x` is the root of two lines at the worst, and known to rounding only. Where a row weighs `y` little, that rounding divided
    /// by the weight is a large part of `y`: taken literally, the row would force `y` down by it and so break another row that
    /// weighs `y` more. Every row is therefore given what rounding can take from it. With the unit round-off `u = ε / 2`, slope
    /// and offset of a line are off by `2 u` of themselves each, the root's differences and quotient add `3 u`, and a steep line is
    /// widened by `8 u`: at the root a row's two sides differ by at most `13 u (|before x| + |bound|)`. The product and the
    /// difference here add `2 u`, and `16 u = 8 ε` covers the higher orders. A row is exceeded by no more than that; what is too
    /// much for the caller shows when it checks the profile with outward rounding.
    pub(super) fn greatest_after(strips: &[Strip], x: f64) -> f64 {
        let mut greatest = f64::INFINITY;
        for strip in strips {
            let (bound, outwards) = if strip.after > 0.0 { (strip.upper, 1.0) } else { (strip.lower, -1.0) };
            let used = strip.before * x;
            let rounding = 8.0 * f64::EPSILON * (used.abs() + bound.abs());
            let value = (bound - used + outwards * rounding) / strip.after;
            // A row without the value after bounds nothing here; for it the division gives an infinity or not a number.
            greatest = if strip.after != 0.0 && value < greatest { value } else { greatest };
        }
        greatest
    }

    /// The rows that form the border of the loaded interval's polygon: all others follow from them, the box and the
    /// neighbour's range. Found by walking along the lower and the upper envelope.
    pub(super) fn border(&self, far_of: impl Fn(usize) -> f64) -> Vec<(usize, Side)> {
        let mut rows = Vec::new();
        for (reason, _) in self.reasons.iter().zip(self.x) {
            if let Reason::Row(strip, side) = *reason {
                rows.push((strip, side));
            }
        }
        for which in [Extreme::Least, Extreme::Greatest] {
            for line in self.walk(which) {
                if let Line::Strip(strip) = line {
                    rows.push((strip, bounding_side(far_of(strip), which)));
                }
            }
        }
        rows
    }

    /// The lines of an envelope from the left end of the box to the right: the upper lines' minimum turns downwards, the lower
    /// lines' maximum, its mirror image, upwards.
    fn walk(&self, which: Extreme) -> Vec<Line> {
        let (sign, offsets) = if which == Extreme::Greatest { (1.0, &self.high) } else { (-1.0, &self.low) };
        let of = |line: usize| (sign * self.slope[line], sign * offsets[line]);
        let mut x = self.x[0];
        let e = self.envelope(x);
        let mut at = if which == Extreme::Greatest { e.high_line } else { e.low_line };
        let mut walked = Vec::new();
        loop {
            walked.push(self.line(at));
            let (p, q) = of(at);
            let mut next = (self.x[1], None);
            for line in 0..self.slope.len() {
                let (slope, offset) = of(line);
                let crossing = (offset - q) / (p - slope);
                if slope < p && crossing < next.0 {
                    next = (crossing.max(x), Some(line));
                }
            }
            let (crossing, Some(line)) = next else { return walked };
            (x, at) = (crossing, line);
        }
    }
}

/// The bound on `x` that a reason proves, rounded outwards, given the range of `y`: valid whether or not the pair was well chosen.
pub(super) fn proven_bound(
    reason: Reason,
    which: Extreme,
    strips: &[Strip],
    direction: Direction,
    y: [f64; 2],
) -> Option<f64> {
    let outer = |value: Outward| match which {
        Extreme::Least => value.lo,
        Extreme::Greatest => value.hi,
    };
    match reason {
        Reason::Box => None,
        Reason::Row(index, side) => {
            let (near, far) = direction.coefficients(&strips[index]);
            let bound = if side == Side::Upper { strips[index].upper } else { strips[index].lower };
            let weighed = if far == 0.0 { Outward::ZERO } else { Outward::exact(far) * Outward { lo: y[0], hi: y[1] } };
            Some(outer((Outward::exact(bound) - weighed) / Outward::exact(near)))
        }
        Reason::Pair { low, high } => {
            let (p_low, q_low) = outward_line(low, Extreme::Least, strips, direction, y);
            let (p_high, q_high) = outward_line(high, Extreme::Greatest, strips, direction, y);
            let slope = p_low - p_high;
            let right_sign = match which {
                Extreme::Greatest => slope.lo > 0.0,
                Extreme::Least => slope.hi < 0.0,
            };
            right_sign.then(|| outer((q_high - q_low) / slope))
        }
    }
}

/// `(p, q)` of a lower (`Least`) or upper line.
fn outward_line(line: Line, which: Extreme, strips: &[Strip], direction: Direction, y: [f64; 2]) -> (Outward, Outward) {
    match line {
        Line::Neighbour => (Outward::ZERO, Outward::exact(if which == Extreme::Least { y[0] } else { y[1] })),
        Line::Strip(index) => {
            let (near, far) = direction.coefficients(&strips[index]);
            let bound =
                if bounding_side(far, which) == Side::Upper { strips[index].upper } else { strips[index].lower };
            (-Outward::exact(near) / Outward::exact(far), Outward::exact(bound) / Outward::exact(far))
        }
    }
}

/// The bound of a strip that gives its lower (`Least`) or upper line, by the sign of the coefficient of `y`.
pub(super) fn bounding_side(far: f64, which: Extreme) -> Side {
    if (far > 0.0) == (which == Extreme::Greatest) { Side::Upper } else { Side::Lower }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::time_optimal::strip::RowSource;
    use proptest::prelude::*;
    use slideway_path::LimitKind;

    const SOURCE: RowSource = RowSource { kind: LimitKind::JointTorque, index: 0, sample: 0, node: 0 };

    /// All half-planes `a x + b y <= c` of a program.
    fn half_planes(strips: &[Strip], x: [f64; 2], y: [f64; 2]) -> Vec<[f64; 3]> {
        let mut planes = vec![[1.0, 0.0, x[1]], [-1.0, 0.0, -x[0]], [0.0, 1.0, y[1]], [0.0, -1.0, -y[0]]];
        for s in strips {
            planes.push([s.before, s.after, s.upper]);
            planes.push([-s.before, -s.after, -s.lower]);
        }
        planes
    }

    /// The naive twin: every intersection of two half-planes' borders that lies in all of them, all moved out by `shift`.
    fn vertices(planes: &[[f64; 3]], shift: f64) -> Vec<[f64; 2]> {
        let planes: Vec<[f64; 3]> = planes.iter().map(|p| [p[0], p[1], p[2] + shift]).collect();
        let mut found = Vec::new();
        for (i, a) in planes.iter().enumerate() {
            for b in &planes[..i] {
                let det = a[0] * b[1] - a[1] * b[0];
                if det.abs() < 1e-9 {
                    continue;
                }
                let p = [(a[2] * b[1] - a[1] * b[2]) / det, (a[0] * b[2] - a[2] * b[0]) / det];
                if planes.iter().all(|c| c[0] * p[0] + c[1] * p[1] <= c[2] + 1e-8) {
                    found.push(p);
                }
            }
        }
        found
    }

    fn strip() -> impl Strategy<Value = Strip> {
        // Exact zeros must occur: they are the rows without one of the unknowns.
        let coefficient = || prop_oneof![4 => -3.0..3.0_f64, 1 => Just(0.0)];
        (coefficient(), coefficient(), -1.0..0.6_f64, 0.0..1.0_f64).prop_map(|(before, after, lower, width)| Strip {
            before,
            after,
            lower,
            upper: lower + width,
            source: SOURCE,
        })
    }

    /// Coefficients of which one may weigh next to nothing, down to where its inverse overflows.
    fn lopsided_strip() -> impl Strategy<Value = Strip> {
        let weight = || prop_oneof![2 => Just(0), 3 => -18..0_i32, 1 => -320..0_i32].prop_map(|e| 10.0_f64.powi(e));
        (strip(), weight(), weight()).prop_map(|(strip, before, after)| Strip {
            before: strip.before * before,
            after: strip.after * after,
            ..strip
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 20_000, failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn from_any_value_of_the_range_the_greatest_next_one_keeps_every_row_however_little_a_row_weighs_it(
            strips in prop::collection::vec(lopsided_strip(), 1..8),
            share in prop_oneof![2 => Just(1.0), 1 => Just(0.0), 1 => 0.0..1.0_f64],
        ) {
            let (x, y) = ([0.0, 1.5], [0.1, 1.2]);
            let mut program = IntervalProgram::default();
            let range = program.load(&strips, 0, Direction::Backward, x, y).and_then(|()| {
                Ok([program.extreme(Extreme::Least)?.0, program.extreme(Extreme::Greatest)?.0])
            });
            let Ok([least, greatest]) = range else { return Ok(()) };
            prop_assume!(least <= greatest);
            let from = least + share * (greatest - least);
            let next = IntervalProgram::greatest_after(&strips, from).min(y[1]).max(y[0]);
            for strip in &strips {
                // A row gives way by the 8 ε of `greatest_after` and the check adds 4 ε, of `|before x| + |bound| <= 3 · 1.5 + 1.6`.
                // A line that is not steep is known to 5 u of 1024 times that in units of `y`, which rows weigh up to 3 times.
                let most = f64::EPSILON * 6.1 * (12.0 + 3.0 * 2.5 * 1024.0);
                prop_assert!(strip.overshoot(from, next) <= most, "{strip:?} from {from} to {next}");
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 3000, failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn extremes_are_those_of_the_vertices(strips in prop::collection::vec(strip(), 1..8), forward in any::<bool>()) {
            let direction = if forward { Direction::Forward } else { Direction::Backward };
            let (x, y) = ([0.0, 1.5], [0.1, 1.2]);
            let mut program = IntervalProgram::default();
            let solved = program.load(&strips, 0, direction, x, y).and_then(|()| {
                Ok([program.extreme(Extreme::Least)?, program.extreme(Extreme::Greatest)?])
            });
            let planes = if forward { half_planes(&strips, y, x) } else { half_planes(&strips, x, y) };
            let axis = usize::from(forward);
            // Vertices of nearly parallel borders are off by rounding over the sine of their angle, at most 1e-16 / 1e-9.
            let outer = vertices(&planes, 1e-6);
            match solved {
                Ok([(least, low_reason), (greatest, high_reason)]) => {
                    let inner = vertices(&planes, -1e-6);
                    prop_assert!(!outer.is_empty());
                    prop_assert!(inner.iter().all(|p| least <= p[axis] + 1e-6 && p[axis] <= greatest + 1e-6));
                    let e = [least, greatest].map(|x| { let [low, high] = program.range_at(x); low - high });
                    prop_assert!(e.iter().all(|gap| *gap <= 1e-9), "gaps {e:?}");
                    for (value, reason, which) in [(least, low_reason, Extreme::Least), (greatest, high_reason, Extreme::Greatest)] {
                        if let Some(bound) = proven_bound(reason, which, &strips, direction, y) {
                            let outside = if which == Extreme::Least { value - bound } else { bound - value };
                            prop_assert!((-1e-12..1e-6).contains(&outside), "{outside}");
                        }
                    }
                    // The extremes are attained at vertices wherever the outer set has them.
                    let reach = |better: fn(f64, f64) -> f64| outer.iter().map(|p| p[axis]).reduce(better);
                    prop_assert!(reach(f64::max).is_some_and(|m| greatest <= m + 1e-6));
                    prop_assert!(reach(f64::min).is_some_and(|m| least >= m - 1e-6));
                }
                Err(_) => prop_assert!(vertices(&planes, -1e-6).is_empty()),
            }
        }
    }
}
