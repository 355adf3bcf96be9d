use crate::{JointKind, JointVector, NumericIk, Pose, PositionRange, RobotError};
use std::f64::consts::{PI, TAU};

/// Ranges of the joints, `None` where a joint has none.
pub type PositionRanges<const N: usize> = [Option<PositionRange>; N];

/// Distance from zero within which a joint that slides without limits is sought, m.
const REACH: f64 = 2.0;

impl<const N: usize> NumericIk<'_, N> {
    /// A joint position within the joints' ranges that puts the tool at `pose`: from the seed first, then from up to
    /// `restarts` further seeds that fill the ranges evenly, always the same ones. Turning joints are brought into their
    /// range by whole turns.
    ///
    /// # Errors
    ///
    /// [`RobotError::OutsideLimits`] if only positions outside the ranges were found, else what the first seed ended with.
    /// Neither proves that there is no solution.
    pub fn solve_within(
        &self,
        pose: &Pose,
        seed: &JointVector<N>,
        ranges: &PositionRanges<N>,
        restarts: usize,
    ) -> Result<JointVector<N>, RobotError> {
        let mut failure = None;
        for trial in 0..=restarts {
            let from = if trial == 0 { *seed } else { self.seed(trial, ranges) };
            match self.solve(pose, &from) {
                Ok(q) => {
                    let q = JointVector::from_fn(|i, _| self.within_turns(i, q[i], &ranges[i]));
                    let outside = (0..N).find(|&i| ranges[i].is_some_and(|range| !range.contains(q[i])));
                    let Some(joint) = outside else { return Ok(q) };
                    failure = Some(RobotError::OutsideLimits { joint, value: q[joint], trials: restarts + 1 });
                }
                Err(error) => failure = failure.or(Some(error)),
            }
        }
        Err(failure.unwrap_or(RobotError::NotConverged {
            position_error: f64::NAN,
            orientation_error: f64::NAN,
            iterations: 0,
        }))
    }

    /// The `trial`-th point of an additive recurrence in the ranges: each coordinate steps by an irrational share.
    #[allow(clippy::cast_precision_loss)]
    fn seed(&self, trial: usize, ranges: &PositionRanges<N>) -> JointVector<N> {
        JointVector::from_fn(|i, _| {
            // Square roots of distinct primes are independent over the rationals: the points fill the box evenly.
            let step = PRIMES[i % PRIMES.len()].sqrt();
            let share = (trial as f64 * step).fract();
            let open = if self.slides(i) { REACH } else { PI };
            let (lower, upper) = match ranges[i].map(|range| (range.lower, range.upper)) {
                Some((lower, upper)) if lower.is_finite() && upper.is_finite() => (lower.max(-TAU), upper.min(TAU)),
                Some((lower, _)) if lower.is_finite() => (lower, lower + 2.0 * open),
                Some((_, upper)) if upper.is_finite() => (upper - 2.0 * open, upper),
                _ => (-open, open),
            };
            lower + share * (upper - lower)
        })
    }

    /// The angle shifted by whole turns to lie in its range, nearest to its lower end from above (to its upper end from
    /// below where it is open downwards); slides are left alone.
    fn within_turns(&self, joint: usize, q: f64, range: &Option<PositionRange>) -> f64 {
        match range {
            Some(range) if self.slides(joint) || range.contains(q) => q,
            Some(range) if range.lower.is_finite() => q + TAU * ((range.lower - q) / TAU).ceil(),
            Some(range) if range.upper.is_finite() => q - TAU * ((q - range.upper) / TAU).ceil(),
            _ => q,
        }
    }

    fn slides(&self, joint: usize) -> bool {
        self.arm().joints()[joint].kind == JointKind::Prismatic
    }
}

const PRIMES: [f64; 12] = [2.0, 3.0, 5.0, 7.0, 11.0, 13.0, 17.0, 19.0, 23.0, 29.0, 31.0, 37.0];
