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
///
/// Where a joint with `B = 0` exceeds most over a range of factors: 0 or `most` if they belong to it, 0 first; else the least of them.
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

    fn violation((desired, reachable): &(AffineSpeed<3>, Reachable<3>), scale: &[f64; 3], factor: f64) -> f64 {
        let speed = desired.at(factor);
        let joints = speed.iter().zip(reachable.ends()).zip(scale);
        joints.map(|((v, (lo, up)), unit)| (v - up).max(lo - v) / unit).fold(f64::NEG_INFINITY, f64::max)
    }

    proptest! {
        #[test]
        fn a_factor_is_admissible_exactly_inside_the_closed_form_interval(case in case(), factor in 0.0..=1.0) {
            let admissible = Admissible::new(&case.0, &case.1);
            let is_inside = admissible.is_some_and(|a| a.least <= factor && factor <= a.greatest);
            let violation = violation(&case, &[1.0; 3], factor);
            // Values of order 1: what is nearer to the border than 1e-12 is decided by rounding.
            prop_assert!(is_inside == (violation <= 0.0) || violation.abs() < 1e-12);
        }

        #[test]
        fn no_factor_of_a_fine_grid_violates_less_than_the_chosen_one(
            case in case(),
            scale in proptest::array::uniform3(0.1..2.0),
            most in 0.0..=1.0,
        ) {
            let chosen = least_violation(&case.0, &case.1, &scale, most);
            prop_assert!((0.0..=most).contains(&chosen));
            for step in 0..=500 {
                let other = violation(&case, &scale, most * f64::from(step) / 500.0);
                prop_assert!(violation(&case, &scale, chosen) <= other + 1e-12);
            }
        }
    }

    #[test]
    fn a_joint_without_feedforward_leaves_every_factor_if_its_box_holds_the_feedback_and_none_if_not() {
        let reachable = Reachable { lower: [-0.25, 0.125], upper: [0.5, 0.75] };
        for (feedback, is_held) in [(-0.3125, false), (-0.25, true), (0.0, true), (0.5, true), (0.5625, false)] {
            for none in [0.0, -0.0] {
                let desired = AffineSpeed { feedback: [feedback, 0.0], feedforward: [none, 1.0] };
                let left = is_held.then_some(Admissible { least: 0.125, greatest: 0.75 });
                assert_eq!(Admissible::new(&desired, &reachable), left, "{feedback}");
            }
        }
    }

    /// Joint `k` asks for `f - c` and exceeds its box by `(|f - c| - w / 2) / 8^k`: between its roots `c - w / 2` and `c + w / 2` not at all.
    /// The roots of each lie inside those of the one before, beyond their middle, so that the two lines of one joint meet
    /// where the left line of the next is the highest, and that one meets the right line where its own right one is.
    #[test]
    fn the_least_violation_is_found_even_if_each_line_is_the_highest_once_on_the_way() {
        const JOINTS: usize = 6;
        let (mut left, mut right) = (0.1, 0.9);
        let (mut centre, mut width, mut scale) = ([0.0; JOINTS], [0.0; JOINTS], [0.0; JOINTS]);
        for (joint, unit) in scale.iter_mut().enumerate() {
            *unit = 8.0_f64.powf(joint as f64);
            (centre[joint], width[joint]) = (0.5 * (left + right), right - left);
            (left, right) = (left + 0.6 * width[joint], left + 0.9 * width[joint]);
        }
        let desired = AffineSpeed { feedback: centre.map(|c| -c), feedforward: [1.0; JOINTS] };
        let reachable = Reachable { lower: width.map(|w| -0.5 * w), upper: width.map(|w| 0.5 * w) };
        // The lines of the last joint are the shallowest: at its centre all others are further inside. Some roundings of numbers up to 1.
        let factor = least_violation(&desired, &reachable, &scale, 1.0);
        assert!((factor - centre[JOINTS - 1]).abs() <= 4.0 * f64::EPSILON, "{factor}");
    }

    #[test]
    fn a_joint_out_of_reach_whatever_the_factor_leaves_the_reference_its_rate_or_the_slowest_that_is_no_worse() {
        // Joint 1 exceeds its box by `flat`, joint 2 by |f - 0.5| - 0.25.
        let factor = |flat: f64, most: f64| {
            let desired = AffineSpeed { feedback: [0.25 + flat, -0.5], feedforward: [0.0, 1.0] };
            let reachable = Reachable { lower: [-0.25; 2], upper: [0.25; 2] };
            least_violation(&desired, &reachable, &[1.0; 2], most)
        };
        // No worse at a stand than anywhere: the reference stands.
        assert_eq!(factor(0.5, 1.0), 0.0);
        // Joint 2 would exceed more at a stand, and no more at the rate it has.
        assert_eq!(factor(0.125, 0.75), 0.75);
        // From 0.125 to 0.875 it exceeds no more.
        assert_eq!(factor(0.125, 1.0), 0.125);
    }
}
