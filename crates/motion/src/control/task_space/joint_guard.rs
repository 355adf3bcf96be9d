use crate::MotionError;
use crate::error::{positive, setting};
use slideway_robot::{JointVector, PositionRange};

/// Stops of a joint and the deceleration it can always muster.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GuardedJoint {
    /// Where the joint may be, rad (m).
    pub range: PositionRange,
    /// Deceleration used to stop, per s².
    pub deceleration: f64,
}

/// Keeps joints off their stops by bounding their accelerations, sample by sample.
///
/// A state is *safe* if braking at the deceleration `a` stops in the range: `q + v²/(2 a) <= q_max` for `v > 0`, and likewise below.
/// The bound is the largest acceleration after which the state is safe again: with `T` the sampling period and `x` the room to the
/// stop,
///
/// ```text
/// v' = -a T / 2 + sqrt((a T / 2)² + 2 a (x - T v / 2)),   (v' - v) / T           if v' >= 0
/// -v² / (2 x)                                                                  else: it stops at the stop within the sample
/// ```
///
/// Guaranteed for accelerations held over each sample and inside the bounds: from a safe state every state is safe, between
/// samples too, and `-a` (`+a` at the lower stop) is never outside the bounds. From an unsafe one the bound is `-a`.
/// Not covered: an arm that does not follow its accelerations exactly; give the range a margin for that.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointGuard<const N: usize> {
    joints: [Option<GuardedJoint>; N],
    period: f64,
}

impl<const N: usize> JointGuard<N> {
    /// Guards the joints that have stops.
    ///
    /// # Errors
    ///
    /// [`MotionError::Setting`]: an empty range, a deceleration or a sampling period that is not positive.
    pub fn new(joints: [Option<GuardedJoint>; N], sampling_period: f64) -> Result<Self, MotionError> {
        positive("sampling_period", sampling_period)?;
        for GuardedJoint { range, deceleration } in joints.iter().flatten() {
            setting("range", range.upper - range.lower, range.upper > range.lower)?;
            positive("deceleration", *deceleration)?;
        }
        Ok(Self { joints, period: sampling_period })
    }

    /// The accelerations nearest to those wanted inside the bounds, and which joints were held back.
    #[must_use]
    pub fn hold_back(
        &self,
        q: &JointVector<N>,
        qd: &JointVector<N>,
        wanted: &JointVector<N>,
    ) -> (JointVector<N>, [bool; N]) {
        let held = JointVector::from_fn(|i, _| match &self.joints[i] {
            Some(joint) => self.within(joint, q[i], qd[i], wanted[i]),
            None => wanted[i],
        });
        (held, std::array::from_fn(|i| held[i] != wanted[i]))
    }

    fn within(&self, joint: &GuardedJoint, q: f64, v: f64, wanted: f64) -> f64 {
        let most = self.most(joint.deceleration, joint.range.upper - q, v);
        let least = -self.most(joint.deceleration, q - joint.range.lower, -v);
        // In a range so narrow that the bounds cross, brake.
        if least <= most {
            wanted.clamp(least, most)
        } else {
            (-v / self.period).clamp(-joint.deceleration, joint.deceleration)
        }
    }

    /// Largest acceleration towards a stop at distance `room`.
    fn most(&self, a: f64, room: f64, v: f64) -> f64 {
        let (t, half) = (self.period, 0.5 * a * self.period);
        let square = half * half + 2.0 * a * (room - 0.5 * t * v);
        let next = square.max(0.0).sqrt() - half;
        if next >= 0.0 && square >= 0.0 {
            return ((next - v) / t).max(-a);
        }
        // Within the sample: the peak q + v²/(2 b) lies at the stop for b = v²/(2 x).
        let stopping = if v > 0.0 { -v * v / (2.0 * room) } else { (next - v) / t };
        if stopping >= -a && room > 0.0 { stopping } else { -a }
    }
}
