use super::limits::AccelerationLimits;

/// One interval of a preview: path speeds at both ends, the distance between them, and what the far end allows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Interval<const N: usize> {
    /// `q'` at the near end.
    pub(super) near: [f64; N],
    /// `q'` at the far end.
    pub(super) far: [f64; N],
    /// Difference of the path parameters, positive.
    pub(super) length: f64,
    /// Largest `b` at the near end under speed limits.
    pub(super) cap: f64,
    /// Largest `b` at the far end from which the window's end can be reached.
    pub(super) allowed: f64,
}

/// A row as two parallel lines: `slope x + low <= y <= slope x + high`.
#[derive(Clone, Copy)]
struct Lines {
    slope: f64,
    low: f64,
    high: f64,
}

/// The highest lower and the lowest upper line at some `x`: value, slope and offset of each.
struct Envelope {
    low: f64,
    high: f64,
    low_line: Lines,
    high_line: Lines,
}

impl<const N: usize> Interval<N> {
    /// The greatest near end `x` from which some far end `y` in [0, `allowed`] can be reached.
    ///
    /// On the interval `q'` is linear in `λ` and `b` too, so `λ̈ = (y - x) / (2 d)`, `q'' = (v1 - v0) / d` and the joint acceleration
    /// `q' λ̈ + q'' b` is linear as well: the limits hold all along if they hold at both ends. Times `2 d`:
    ///
    /// ```text
    /// near end:  v0 y + (2 v1 - 3 v0) x  between  2 d a_lower and 2 d a_upper
    /// far end:   (3 v1 - 2 v0) y - v1 x  between  2 d a_lower and 2 d a_upper
    /// ```
    ///
    /// Rest, `x = y = 0`, is always admissible, so the answer is never negative. The gap between the lower and the upper
    /// envelope is convex in `x`; Newton's method from `cap` downwards ends at its root after finitely many steps. Should
    /// rounding keep it from ending, rest is the answer.
    pub(super) fn greatest(&self, limits: &AccelerationLimits<N>, share: f64) -> f64 {
        if !self.near.iter().chain(&self.far).all(|v| v.is_finite()) {
            return 0.0;
        }
        let mut x = self.cap;
        let range = 2.0 * self.length * share;
        let mut rows = [[Lines { slope: 0.0, low: f64::NEG_INFINITY, high: f64::INFINITY }; 2]; N];
        let joints = self.near.iter().zip(&self.far).zip(limits.lower().iter().zip(limits.upper()));
        for (pair, ((&v0, &v1), (&lo, &up))) in rows.iter_mut().zip(joints) {
            for (lines, [of_y, of_x]) in pair.iter_mut().zip(coefficients(v0, v1)) {
                match row(of_y, of_x, lo, up, range) {
                    Some(found) => *lines = found,
                    // The limit towards which the row moves has the positive quotient; a row without `x` too has no end.
                    None => x = x.min(range * (up / of_x).max(lo / of_x)),
                }
            }
        }
        self.newton(&rows, x)
    }

    /// True if [`Interval::greatest`] is at least `x`, but for rounding: everything from rest to the greatest is reachable.
    ///
    /// `turn` is `q''`, the slope of `q'`. An interval without length is the limit of ever shorter ones: its far end is passed at `x` by
    /// some `λ̈`. With the interval that follows, of another slope, more may be possible.
    ///
    /// ```text
    /// near end:  v0 λ̈ + q'' x             between a_lower and a_upper
    /// far end:   (3 v1 - 2 v0) λ̈ + q'' x  between a_lower and a_upper,   -x <= 2 d λ̈ <= allowed - x
    /// ```
    pub(super) fn reaches(&self, limits: &AccelerationLimits<N>, share: f64, turn: &[f64; N], x: f64) -> bool {
        if !(x <= self.cap) || !self.near.iter().chain(&self.far).all(|v| v.is_finite()) {
            return x <= 0.0;
        }
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        if self.length > 0.0 {
            (low, high) = (-0.5 * x / self.length, 0.5 * (self.allowed - x) / self.length);
        } else if !(x <= self.allowed) {
            return false;
        }
        let speeds = self.near.iter().zip(&self.far).zip(turn);
        for (((&v0, &v1), &turn), (&lo, &up)) in speeds.zip(limits.lower().iter().zip(limits.upper())) {
            let ends = [share * lo - turn * x, share * up - turn * x];
            for of_acceleration in [v0, 3.0 * v1 - 2.0 * v0] {
                let inverse = 1.0 / of_acceleration;
                let [a, b] = ends.map(|end| end * inverse);
                if inverse.is_finite() {
                    (low, high) = (low.max(a.min(b)), high.min(a.max(b)));
                } else if !(ends[0] <= 0.0 && 0.0 <= ends[1]) {
                    return false;
                }
            }
        }
        low <= high
    }

    fn newton(&self, rows: &[[Lines; 2]; N], from: f64) -> f64 {
        let mut x = from;
        for _ in 0..8 * N + 8 {
            let e = self.envelope(rows, x);
            if !(e.low > e.high) {
                return x.max(0.0);
            }
            let slope = e.low_line.slope - e.high_line.slope;
            if !(slope > 0.0) {
                return 0.0;
            }
            let next = (e.high_line.high - e.low_line.low) / slope;
            // Where the root is met to rounding no step leads further down.
            if !(next < x) {
                return x;
            }
            x = next.max(0.0);
        }
        0.0
    }

    fn envelope(&self, rows: &[[Lines; 2]; N], x: f64) -> Envelope {
        let neighbour = Lines { slope: 0.0, low: 0.0, high: self.allowed };
        let mut e = Envelope { low: 0.0, high: self.allowed, low_line: neighbour, high_line: neighbour };
        for lines in rows.iter().flatten() {
            let rise = lines.slope * x;
            if rise + lines.low > e.low {
                (e.low, e.low_line) = (rise + lines.low, *lines);
            }
            if rise + lines.high < e.high {
                (e.high, e.high_line) = (rise + lines.high, *lines);
            }
        }
        e
    }
}

/// Coefficients of `y` and `x` in one joint's rows, near end and far end.
fn coefficients(v0: f64, v1: f64) -> [[f64; 2]; 2] {
    [[v0, 2.0 * v1 - 3.0 * v0], [3.0 * v1 - 2.0 * v0, -v1]]
}

/// A row as lines `y` over `x`; `None` where it does not contain `y`.
fn row(of_y: f64, of_x: f64, lower: f64, upper: f64, range: f64) -> Option<Lines> {
    let inverse = 1.0 / of_y;
    if !inverse.is_finite() {
        return None;
    }
    let (a, b) = (range * lower * inverse, range * upper * inverse);
    Some(Lines { slope: -of_x * inverse, low: a.min(b), high: a.max(b) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// True if some `y` in [0, allowed] keeps every row, straight from the rows.
    fn is_reachable(interval: &Interval<3>, limits: &AccelerationLimits<3>, x: f64) -> bool {
        let (mut low, mut high) = (0.0_f64, interval.allowed);
        for i in 0..3 {
            let bounds = [2.0 * interval.length * limits.lower()[i], 2.0 * interval.length * limits.upper()[i]];
            for [of_y, of_x] in coefficients(interval.near[i], interval.far[i]) {
                let ends = bounds.map(|bound| (bound - of_x * x) / of_y);
                low = low.max(ends[0].min(ends[1]));
                high = high.min(ends[0].max(ends[1]));
            }
        }
        low <= high
    }

    proptest! {
        #[test]
        fn the_greatest_value_is_where_a_bisection_on_the_rows_ends(
            near in proptest::array::uniform3(-2.0..2.0),
            far in proptest::array::uniform3(-2.0..2.0),
            length in 1e-3..0.5,
            allowed in 0.0..4.0,
            lower in proptest::array::uniform3(-5.0..-0.1),
            upper in proptest::array::uniform3(0.1..5.0),
        ) {
            let limits = AccelerationLimits::new(lower, upper)?;
            let interval = Interval { near, far, length, cap: 10.0, allowed };
            let (mut kept, mut refused) = (0.0, 10.0);
            if is_reachable(&interval, &limits, refused) {
                kept = refused;
            }
            for _ in 0..60 {
                let middle = 0.5 * (kept + refused);
                if is_reachable(&interval, &limits, middle) { kept = middle } else { refused = middle }
            }
            // Both divide by coefficients of a line's slope; below 1e-9 of the caps is rounding of those quotients.
            prop_assert!((interval.greatest(&limits, 1.0) - kept).abs() <= 1e-9 * (1.0 + kept));
        }

        #[test]
        fn a_value_is_reached_up_to_the_greatest_and_not_beyond(
            near in proptest::array::uniform3(-2.0..2.0),
            far in proptest::array::uniform3(-2.0..2.0),
            length in 1e-3..0.5,
            allowed in 0.0..4.0,
            share in 0.5..=1.0,
            stands in 0_usize..4,
            of_greatest in 0.0..2.0_f64,
        ) {
            let limits = AccelerationLimits::new([-0.5, -1.0, -3.0], [2.0, 1.0, 0.3])?;
            let mut interval = Interval::<3> { near, far, length, cap: 10.0, allowed };
            // A joint that stands at the near end has a row without `y`.
            if let Some(near) = interval.near.get_mut(stands) {
                *near = 0.0;
            }
            let greatest = interval.greatest(&limits, share);
            let x = of_greatest * greatest;
            // As above: what is nearer than 1e-9 is decided by rounding.
            let is_near = (x - greatest).abs() <= 1e-9 * (1.0 + greatest);
            prop_assert!(is_near || interval.reaches(&limits, share, &turn(&interval), x) == (x < greatest), "{x} {greatest}");
        }
    }

    /// One joint whose limits are -2 and 3, of which the far end allows much.
    fn greatest(near: f64, far: f64, length: f64, share: f64) -> Result<f64, crate::ParameterError> {
        let limits = AccelerationLimits::new([-2.0], [3.0])?;
        Ok(Interval { near: [near], far: [far], length, cap: 1e3, allowed: 50.0 }.greatest(&limits, share))
    }

    #[test]
    fn one_joint_s_greatest_values_are_those_worked_out_by_hand() -> Result<(), crate::ParameterError> {
        // 2 d share = 0.2. Straight: x = y + 0.2 times the limit against the motion, over q'.
        let cases = [
            (4.0, 4.0, 50.0 + 0.2 * 2.0 / 4.0),
            (-4.0, -4.0, 50.0 + 0.2 * 3.0 / 4.0),
            // From a stand the near end's row is `2 v1 x` alone, which only q'' b = v1 x / d bounds.
            (0.0, 4.0, 0.2 * 3.0 / 8.0),
            (0.0, -4.0, 0.2 * 2.0 / 8.0),
            // With 3 v1 = 2 v0 the far end's row is `-v1 x` alone.
            (6.0, 4.0, 0.2 * 2.0 / 4.0),
            (-6.0, -4.0, 0.2 * 3.0 / 4.0),
            // Into a turn of the joint the near end brakes: 2 y - 6 x >= -0.4; the far end's -4 y turns to 4 y <= 0.4.
            (2.0, 0.0, (2.0 * 0.1 + 0.4) / 6.0),
            // A joint that stands leaves what the speed limits leave.
            (0.0, 0.0, 1e3),
        ];
        for (near, far, by_hand) in cases {
            let x = greatest(near, far, 0.25, 0.4)?;
            // Half a dozen roundings.
            assert!((x - by_hand).abs() <= 4.0 * f64::EPSILON * by_hand, "{near} {far}: {x} {by_hand}");
        }
        Ok(())
    }

    /// Near rows `y >= s (x - r)` whose slopes `s` rise eightfold from joint to joint, their roots `r` by half as much each time. From the
    /// right the steepest row is the highest, at its root the next one, and so on to the last.
    #[test]
    fn the_tightest_joint_is_found_even_if_the_way_to_it_leads_over_all_others() -> Result<(), crate::ParameterError> {
        const JOINTS: usize = 12;
        let slopes: [f64; JOINTS] = core::array::from_fn(|joint| 8.0 * 8.0_f64.powf(joint as f64));
        let roots: [f64; JOINTS] = core::array::from_fn(|joint| 2.0 - 0.5_f64.powf(joint as f64));
        // With q' = 1 at the near end and 2 d = 1: y >= (3 - 2 v1) x + a_lower. The far rows are out of the way.
        let far = slopes.map(|slope| 0.5 * (3.0 - slope));
        let lower = core::array::from_fn(|joint| -slopes[joint] * roots[joint]);
        let limits = AccelerationLimits::new(lower, [1e30; JOINTS])?;
        let interval = Interval { near: [1.0; JOINTS], far, length: 0.5, cap: 10.0, allowed: 0.0 };
        assert!((interval.greatest(&limits, 1.0) - roots[0]).abs() <= 4.0 * f64::EPSILON);
        Ok(())
    }

    /// `q''` of an interval.
    fn turn(interval: &Interval<3>) -> [f64; 3] {
        core::array::from_fn(|i| (interval.far[i] - interval.near[i]) / interval.length)
    }

    #[test]
    fn the_end_of_a_turn_is_passed_no_faster_than_the_turn_allows() -> Result<(), crate::ParameterError> {
        // Joint 1 turns round where it stands, at q'' = 8: 8 b <= 2 whatever the acceleration. Joint 2 goes straight on.
        let limits = AccelerationLimits::symmetric([2.0, 100.0])?;
        let (speeds, turn) = ([0.0, 2.0], [8.0, 0.0]);
        let end = |allowed| Interval { near: speeds, far: speeds, length: 0.0, cap: 1.0, allowed };
        assert!(end(0.5).reaches(&limits, 1.0, &turn, 0.25) && !end(0.5).reaches(&limits, 1.0, &turn, 0.2500001));
        assert!(end(0.125).reaches(&limits, 1.0, &turn, 0.125) && !end(0.125).reaches(&limits, 1.0, &turn, 0.1250001));
        // Moving, joint 1 makes up for the turn by braking: 2 λ̈ + 8 b >= -2 and <= 2, as far as joint 2 lets it: |λ̈| <= 50.
        let end = Interval { near: [2.0; 2], far: [2.0; 2], length: 0.0, cap: 100.0, allowed: 100.0 };
        assert!(end.reaches(&limits, 1.0, &turn, 12.75) && !end.reaches(&limits, 1.0, &turn, 12.7500001));
        Ok(())
    }

    #[test]
    fn an_interval_that_is_not_finite_allows_rest_only() -> Result<(), crate::ParameterError> {
        let limits = AccelerationLimits::symmetric([1.0])?;
        let interval = Interval { near: [1.0], far: [f64::NAN], length: 0.1, cap: 1.0, allowed: 1.0 };
        assert_eq!(interval.greatest(&limits, 1.0), 0.0);
        assert!(interval.reaches(&limits, 1.0, &[0.0], 0.0) && !interval.reaches(&limits, 1.0, &[0.0], 1e-300));
        assert!(!interval.reaches(&limits, 1.0, &[0.0], f64::NAN));
        Ok(())
    }
}
