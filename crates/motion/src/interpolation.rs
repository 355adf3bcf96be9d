use crate::profile::{
    Cosine, Hermite, Profile, Ramp, TrapezoidEnds, bounded_jerk, linear, shortest_common, shortest_linear, trapezoid,
};
use crate::{AxisLimits, JointMotion, JointState, MotionError, MotionPlanner};
use slideway_robot::JointVector;

/// Curve that joins two positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpolation {
    /// Constant speed, which jumps at both ends: continuity C⁰. Keeps the speed limit only.
    Linear,
    /// Constant acceleration, cruise, constant deceleration: C¹. Keeps the limits of speed and acceleration.
    Trapezoid,
    /// One cubic: C¹. Keeps the limits of speed and acceleration.
    Cubic,
    /// Half a cosine, from rest to rest only: C¹. Keeps the limits of speed and acceleration.
    Cosine,
    /// Bounded jerk: C². Keeps the limits of speed, acceleration and jerk.
    BoundedJerk,
}

impl Interpolation {
    /// Bound on the change of speed in a stop out of such a motion; `None` where the speed itself may jump.
    #[must_use]
    pub fn ramp(self) -> Option<Ramp> {
        match self {
            Self::Linear => None,
            Self::Trapezoid | Self::Cubic | Self::Cosine => Some(Ramp::AccelerationLimited),
            Self::BoundedJerk => Some(Ramp::JerkLimited),
        }
    }

    /// A motion of all joints from a state, in motion or not, to rest at a target; all arrive at the same time.
    ///
    /// From rest the slowest joint decides the duration and the others are stretched to it; out of motion, trapezoids and
    /// jerk-limited motions come from [`MotionPlanner`].
    ///
    /// # Errors
    ///
    /// A number that is not finite, a cosine from a moving state, a start faster than the limits (cubic), or no motion found.
    pub fn plan<const N: usize>(
        self,
        planner: &mut MotionPlanner<N>,
        start: &JointState<N>,
        target: &JointVector<N>,
        limits: &[AxisLimits; N],
    ) -> Result<JointMotion<N>, MotionError> {
        for joint in 0..N {
            if !(start.axis(joint).is_finite() && target[joint].is_finite()) {
                return Err(MotionError::NotFinite { joint });
            }
        }
        let goal = JointState::at_rest(*target);
        let still = start.qd.iter().all(|&v| v == 0.0);
        match self {
            Self::Linear => Ok(line(start, target, limits)),
            Self::Cosine if still => Ok(cosine(start, target, limits)),
            Self::Cosine => {
                let joint = start.qd.iter().position(|&v| v != 0.0).unwrap_or(0);
                Err(MotionError::NeedsRest { interpolation: self, joint })
            }
            Self::Cubic => cubic(start, target, limits),
            Self::Trapezoid if still => Ok(JointMotion::stretched_to_slowest(std::array::from_fn(|i| {
                let ends =
                    TrapezoidEnds { start: start.q[i], start_velocity: 0.0, goal: target[i], goal_velocity: 0.0 };
                Profile::Cubics(trapezoid(&ends, &limits[i]))
            }))),
            Self::BoundedJerk if start.is_at_rest() => {
                Ok(JointMotion::stretched_to_slowest(std::array::from_fn(|i| {
                    Profile::Cubics(bounded_jerk(start.q[i], target[i], &limits[i]))
                })))
            }
            Self::Trapezoid => Ok(JointMotion::new(planner.plan(start, &goal, limits, Ramp::AccelerationLimited)?)),
            Self::BoundedJerk => Ok(JointMotion::new(planner.plan(start, &goal, limits, Ramp::JerkLimited)?)),
        }
    }
}

fn line<const N: usize>(start: &JointState<N>, target: &JointVector<N>, limits: &[AxisLimits; N]) -> JointMotion<N> {
    let duration = (0..N).map(|i| shortest_linear(start.q[i], target[i], &limits[i])).fold(0.0, f64::max);
    JointMotion::new(std::array::from_fn(|i| Profile::Cubics(linear(start.q[i], target[i], duration))))
}

fn cosine<const N: usize>(start: &JointState<N>, target: &JointVector<N>, limits: &[AxisLimits; N]) -> JointMotion<N> {
    let duration = (0..N).map(|i| Cosine::shortest(start.q[i], target[i], &limits[i])).fold(0.0, f64::max);
    JointMotion::new(std::array::from_fn(|i| Profile::Cosine(Cosine::new(start.q[i], target[i], duration))))
}

fn cubic<const N: usize>(
    start: &JointState<N>,
    target: &JointVector<N>,
    limits: &[AxisLimits; N],
) -> Result<JointMotion<N>, MotionError> {
    let cubics: [Hermite; N] = std::array::from_fn(|i| Hermite {
        start: start.q[i],
        start_velocity: start.qd[i],
        goal: target[i],
        goal_velocity: 0.0,
    });
    let Some(duration) = shortest_common(&cubics, limits) else {
        return Err(too_fast(start, limits));
    };
    Ok(JointMotion::new(cubics.map(|c| Profile::Cubics(c.over(duration)))))
}

/// The first joint above its speed limit, which is the only reason for which no cubic exists.
fn too_fast<const N: usize>(start: &JointState<N>, limits: &[AxisLimits; N]) -> MotionError {
    let faster = (0..N).find(|&i| start.qd[i].abs() > limits[i].velocity());
    faster.map_or(MotionError::NoProfile, |joint| MotionError::EndSpeed {
        joint,
        velocity: start.qd[joint],
        limit: limits[joint].velocity(),
    })
}
