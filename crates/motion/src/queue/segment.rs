use super::rate::Pace;
use crate::profile::Ramp;
use crate::{AxisLimits, Interpolation, JointMotion, JointState};

/// A stretch of the queue.
#[derive(Clone, Copy, Debug)]
pub(super) struct Segment<const N: usize> {
    /// What it does.
    pub(super) motion: JointMotion<N>,
    /// What may bound changes of its pace: `None` where the speed itself jumps.
    pub(super) ramp: Option<Ramp>,
    /// How it ends.
    pub(super) end: EndOf,
    /// The Go-To it came from, if it did.
    pub(super) go_to: Option<Interpolation>,
}

/// Whether a motion may stop at the end of a segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum EndOf {
    /// A way-point at rest.
    Standstill,
    /// A way-point passed in motion.
    PassThrough,
}

/// Rounding of a handful of products, relative to the limit.
const ROUNDING: f64 = 1e-9;

impl<const N: usize> Segment<N> {
    /// State at path time `s` when path time runs at a pace `r` with slope `w`:
    /// `q̇ = r Q'`, `q̈ = r² Q'' + w Q'`.
    pub(super) fn at(&self, s: f64, rate: f64, slope: f64) -> JointState<N> {
        let JointState { q, qd, qdd } = self.motion.at(s);
        JointState { q, qd: qd * rate, qdd: qdd * (rate * rate) + qd * slope }
    }

    /// Whether the limits hold while the segment's time covers `[from, to]` at the given pace:
    ///
    /// ```text
    /// |r² Q'' + w Q'| <= A,   |r³ Q''' + 3 r w Q'' + x Q'| <= J
    /// ```
    ///
    /// by interval arithmetic, hence for every instant of the span. The speed limit needs no check at a pace of at most 1.
    pub(super) fn keeps(&self, limits: &[AxisLimits; N], from: f64, to: f64, pace: &Pace) -> bool {
        let Some(ramp) = self.ramp else { return true };
        let (r, w, x) = (pace.rate, pace.slope, pace.curvature);
        let square = r.times(r);
        limits.iter().enumerate().all(|(joint, limits)| {
            let q = self.motion.bounds(joint, from, to);
            let acceleration = square.times(q.acceleration).plus(w.times(q.velocity));
            let jerk = || {
                let cross = r.times(w).times(q.acceleration);
                square.times(r).times(q.jerk).plus(cross.plus(cross).plus(cross)).plus(x.times(q.velocity))
            };
            acceleration.magnitude() <= limits.acceleration() * (1.0 + ROUNDING)
                && (ramp == Ramp::AccelerationLimited || jerk().magnitude() <= limits.jerk() * (1.0 + ROUNDING))
        })
    }
}
