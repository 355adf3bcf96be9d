use super::limits::Reachable;
use crate::implicit::AffineSpeed;

/// The factors in [0, 1] whose demand a sample can reach: an interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Admissible {
    pub(super) least: f64,
    pub(super) greatest: f64,
}

/// A line `value = at_zero + slope f`: by how much one side of the box is exceeded.
#[derive(Clone, Copy)]
struct Line {
    at_zero: f64,
    slope: f64,
}

impl Line {
    fn at(self, factor: f64) -> f64 {
        self.at_zero + factor * self.slope
    }
}

impl Admissible {
    /// `{ f in [0, 1] : lower <= A + f B <= upper }` in closed form, `None` if it is empty.
    ///
    /// Each joint leaves an interval, between `(lower - A) / B` and `(upper - A) / B` in the order that the sign of `B` gives; a
    /// joint with `B = 0` leaves everything or nothing. All numbers are finite.
    #[inline]
    pub(super) fn new<const N: usize>(desired: &AffineSpeed<N>, reachable: &Reachable<N>) -> Option<Self> {
        let (mut least, mut greatest) = (0.0_f64, 1.0_f64);
        for ((&a, &b), (lo, up)) in desired.feedback.iter().zip(&desired.feedforward).zip(reachable.ends()) {
            if b == 0.0 {
                if !(lo <= a && a <= up) {
                    return None;
                }
                continue;
            }
            let (first, last) = if b > 0.0 { (lo, up) } else { (up, lo) };
            least = least.max((first - a) / b);
            greatest = greatest.min((last - a) / b);
        }
        (least <= greatest).then_some(Self { least, greatest })
    }
}

/// The factor in [0, `most`] whose demand exceeds the box least: `min_f max_i violation_i(f) / scale_i`.
///
/// The largest violation is convex and piecewise linear in `f`. Two of its lines, one falling and one rising, enclose the
/// minimum; where they meet lies the minimum or a third line, which replaces one of them. Each of the `2N` lines is taken
/// up at most once.
pub(super) fn least_violation<const N: usize>(
    desired: &AffineSpeed<N>,
    reachable: &Reachable<N>,
    scale: &[f64; N],
    most: f64,
) -> f64 {
    let worst = |factor| worst_line(desired, reachable, scale, factor);
    let (mut falling, mut rising) = (worst(0.0), worst(most));
    if !(falling.slope < 0.0) {
        return 0.0;
    }
    if !(rising.slope > 0.0) {
        return most;
    }
    let mut factor = 0.0;
    for _ in 0..2 * N {
        factor = (falling.at_zero - rising.at_zero) / (rising.slope - falling.slope);
        let line = worst(factor);
        if !(line.at(factor) > falling.at(factor).max(rising.at(factor))) {
            break;
        }
        if line.slope < 0.0 {
            falling = line;
        } else {
            rising = line;
        }
    }
    // NaN, from numbers whose difference overflows, ends as 0: the reference stands.
    factor.max(0.0).min(most)
}

/// The side of the box that is exceeded most at a factor.
fn worst_line<const N: usize>(
    desired: &AffineSpeed<N>,
    reachable: &Reachable<N>,
    scale: &[f64; N],
    factor: f64,
) -> Line {
    let mut worst = Line { at_zero: f64::NEG_INFINITY, slope: 0.0 };
    let joints = desired.feedback.iter().zip(&desired.feedforward);
    for (((&a, &b), (lo, up)), &unit) in joints.zip(reachable.ends()).zip(scale) {
        let over = Line { at_zero: (a - up) / unit, slope: b / unit };
        let under = Line { at_zero: (lo - a) / unit, slope: -b / unit };
        for line in [over, under] {
            if line.at(factor) > worst.at(factor) {
                worst = line;
            }
        }
    }
    worst
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn joints() -> impl Strategy<Value = [f64; 3]> {
        proptest::array::uniform3(-2.0..2.0)
    }

    fn case() -> impl Strategy<Value = (AffineSpeed<3>, Reachable<3>)> {
        (joints(), joints(), joints(), proptest::array::uniform3(0.05..1.0)).prop_map(
            |(feedback, feedforward, at, size)| {
                let lower = core::array::from_fn(|i| at[i] - size[i]);
                let upper = core::array::from_fn(|i| at[i] + 0.5 * size[i]);
                (AffineSpeed { feedback, feedforward }, Reachable { lower, upper })
            },
        )
    }

    fn violation((desired, reachable): &(AffineSpeed<3>, Reachable<3>), factor: f64) -> f64 {
        let speed = desired.at(factor);
        speed.iter().zip(reachable.ends()).map(|(v, (lo, up))| (v - up).max(lo - v)).fold(f64::NEG_INFINITY, f64::max)
    }

    proptest! {
        #[test]
        fn a_factor_is_admissible_exactly_inside_the_closed_form_interval(case in case(), factor in 0.0..=1.0) {
            let admissible = Admissible::new(&case.0, &case.1);
            let is_inside = admissible.is_some_and(|a| a.least <= factor && factor <= a.greatest);
            let violation = violation(&case, factor);
            // Values of order 1: what is nearer to the border than 1e-12 is decided by rounding.
            prop_assert!(is_inside == (violation <= 0.0) || violation.abs() < 1e-12);
        }

        #[test]
        fn no_factor_of_a_fine_grid_violates_less_than_the_chosen_one(case in case(), most in 0.0..=1.0) {
            let chosen = least_violation(&case.0, &case.1, &[1.0; 3], most);
            prop_assert!((0.0..=most).contains(&chosen));
            for step in 0..=500 {
                let other = violation(&case, most * f64::from(step) / 500.0);
                prop_assert!(violation(&case, chosen) <= other + 1e-12);
            }
        }
    }
}
