use super::rate::Rate;
use super::segment::{EndOf, Motion, Segment};
use super::{MotionQueue, Repeat};
use crate::{Interpolation, JointMotion, JointState, MotionError};
use slideway_robot::JointVector;

/// Ways to interrupt a motion, from the gentlest to the fastest stop.
impl<const N: usize, const CAPACITY: usize> MotionQueue<N, CAPACITY> {
    /// Forgets everything after the next way-point at rest.
    ///
    /// Stays on the path, as planned. Time to rest: what is left of the path up to that way-point, at the present pace.
    pub fn stop_at_way_point(&mut self) {
        self.repeat = Repeat::Once;
        let keep = self.segments.iter().position(|s| s.end == EndOf::Standstill).map_or(self.segments.len(), |i| i + 1);
        self.segments.truncate(keep);
    }

    /// Sets the pace at which the path is followed, in [0, 1]: 0 brakes on the path, 1 resumes it.
    ///
    /// Stays on the path, to rounding, and within the limits: a pace changes by a law that was checked at every instant before
    /// it began. Out of a steady speed a brake takes `1/α + α/β` seconds with `α` between a 32nd and four times
    /// `min A/V` over the joints and `β` in the same proportion to `min J/V`. Where no law fits, as on a stretch that is
    /// braked at its limits already, the pace waits until one does. A brake never goes beyond the next way-point at rest.
    ///
    /// # Errors
    ///
    /// [`MotionError::Rate`] if the pace is outside [0, 1] or NaN.
    pub fn set_rate(&mut self, rate: f64) -> Result<(), MotionError> {
        if !(0.0..=1.0).contains(&rate) {
            return Err(MotionError::Rate { rate });
        }
        self.rate.wanted = rate;
        Ok(())
    }

    /// Brakes on the path: [`MotionQueue::set_rate`] of 0. The pace stays 0 until it is set again, for motions appended later
    /// as well.
    pub fn brake_on_path(&mut self) {
        self.rate.wanted = 0.0;
    }

    /// Brakes every joint as fast as its limits allow, and forgets the queue.
    ///
    /// Leaves the path. Time to rest under an acceleration limit: `max |v_i| / A_i`; under a jerk limit at most
    /// `max (|v_i| / A_i + A_i / J_i)` out of a steady speed. Under an acceleration limit no joint gets further than its
    /// planned motion would have got; under a jerk limit it may get into the margin of a stop if the plan turned round there.
    /// A brake is never refused.
    pub fn brake_fully(&mut self) {
        let state = self.set_point();
        let ramp = self.segments.front().and_then(|s| s.ramp);
        self.forget();
        self.present = JointState::at_rest(state.q);
        if let Some(ramp) = ramp {
            let motion = JointMotion::braking(&state, self.limits.axes(), ramp);
            if motion.duration() > 0.0 {
                self.present = state;
                let motion = Motion::Joint(motion);
                self.segments.push_back(Segment { motion, ramp: Some(ramp), end: EndOf::Standstill, go_to: None });
            }
        }
    }

    /// Forgets the queue and goes to a new target from the present state, in motion or not. The pace starts anew at 1.
    ///
    /// Leaves the path. Arrives at rest after the duration of the new motion. From a moving state a cubic may swing out
    /// further than it has to; a trapezoid or bounded jerk is the fastest.
    ///
    /// # Errors
    ///
    /// As [`MotionQueue::go_to`]; [`MotionError::NeedsRest`] for a cosine; a motion that would swing out beyond a stop. The
    /// motion under way goes on.
    pub fn interrupt_to(&mut self, target: &JointVector<N>, interpolation: Interpolation) -> Result<(), MotionError> {
        let state = self.set_point();
        let segment = self.planned(&state, target, interpolation)?;
        self.forget();
        self.present = JointState::at_rest(state.q);
        if segment.motion.duration() > 0.0 {
            self.present = state;
            self.segments.push_back(segment);
        }
        Ok(())
    }

    /// Drops all segments.
    fn forget(&mut self) {
        self.segments.clear();
        self.clock = 0.0;
        self.repeat = Repeat::Once;
        self.rate = Rate::constant(1.0);
    }
}
