use crate::profile::{Cubics, Profile, Ramp};
use crate::{AxisLimits, AxisState, JointState, MotionError};
use rsruckig::prelude::{InputParameter, Profile as OtgProfile, Ruckig, RuckigResult, ThrowErrorHandler, Trajectory};

/// Synchronised time-optimal motions between any two states of motion.
///
/// A thin wall around the `rsruckig` crate. Its answer is not taken on trust: every motion handed out has been put into our own
/// form and checked again for its ends and its limits.
pub struct MotionPlanner<const N: usize> {
    generator: Ruckig<N, ThrowErrorHandler>,
    input: InputParameter<N>,
    trajectory: Trajectory<N>,
}

/// Largest distance of the generator's end from its target: it accepts its own roots to 1e-8 in position and velocity.
const END_TOLERANCE: f64 = 2e-8;

/// Slack on limits: the generator's own is 1e-12, absolute, in acceleration and velocity.
const LIMIT_TOLERANCE: f64 = 1e-9;

impl<const N: usize> Default for MotionPlanner<N> {
    fn default() -> Self {
        // The control cycle only matters for a way of sampling that is not used here.
        Self { generator: Ruckig::new(None, 1e-3), input: InputParameter::new(None), trajectory: Trajectory::new(None) }
    }
}

impl<const N: usize> MotionPlanner<N> {
    /// The fastest motion of all joints that arrives in all of them at the same time.
    ///
    /// # Errors
    ///
    /// [`MotionError::NotFinite`] for NaN and infinities, [`MotionError::NoProfile`] if the generator finds nothing or its
    /// answer fails the check.
    pub fn plan(
        &mut self,
        start: &JointState<N>,
        goal: &JointState<N>,
        limits: &[AxisLimits; N],
        ramp: Ramp,
    ) -> Result<[Profile; N], MotionError> {
        for joint in 0..N {
            if !(start.axis(joint).is_finite() && goal.axis(joint).is_finite()) {
                return Err(MotionError::NotFinite { joint });
            }
        }
        self.set(start, goal, limits, ramp);
        match self.generator.calculate(&self.input, &mut self.trajectory) {
            Ok(RuckigResult::Working | RuckigResult::Finished) => {}
            Ok(_) | Err(_) => return Err(MotionError::NoProfile),
        }
        let sections = self.trajectory.get_profiles();
        let section = sections.first().ok_or(MotionError::NoProfile)?;
        let motions: [Cubics; N] = std::array::from_fn(|i| from_generator(&start.axis(i), &section[i], ramp));
        let sound =
            motions.iter().enumerate().all(|(i, m)| is_sound(m, &start.axis(i), &goal.axis(i), &limits[i], ramp));
        if sound { Ok(motions.map(Profile::Cubics)) } else { Err(MotionError::NoProfile) }
    }

    fn set(&mut self, start: &JointState<N>, goal: &JointState<N>, limits: &[AxisLimits; N], ramp: Ramp) {
        let input = &mut self.input;
        for (i, limits) in limits.iter().enumerate() {
            input.current_position[i] = start.q[i];
            input.current_velocity[i] = start.qd[i];
            // Without a jerk limit the acceleration of the start is forgotten: it may jump.
            input.current_acceleration[i] = if ramp == Ramp::JerkLimited { start.qdd[i] } else { 0.0 };
            input.target_position[i] = goal.q[i];
            input.target_velocity[i] = goal.qd[i];
            input.target_acceleration[i] = if ramp == Ramp::JerkLimited { goal.qdd[i] } else { 0.0 };
            input.max_velocity[i] = limits.velocity();
            input.max_acceleration[i] = limits.acceleration();
            input.max_jerk[i] = if ramp == Ramp::JerkLimited { limits.jerk() } else { f64::INFINITY };
        }
    }
}

/// The generator's phases: two before, seven, two after; integrated anew from the start, so that no joint jumps.
fn from_generator(start: &AxisState, profile: &OtgProfile, ramp: Ramp) -> Cubics {
    let brake = (0..2).map(|k| (profile.brake.t[k], profile.brake.a[k], profile.brake.j[k]));
    let main = (0..7).map(|k| (profile.t[k], profile.a[k], profile.j[k]));
    let tail = (0..2).map(|k| (profile.accel.t[k], profile.accel.a[k], profile.accel.j[k]));
    brake.chain(main).chain(tail).fold(Cubics::from(*start), |motion, (t, a, j)| match ramp {
        Ramp::JerkLimited => motion.then(t, j),
        Ramp::AccelerationLimited => motion.then_with(t, a, 0.0),
    })
}

fn is_sound(motion: &Cubics, start: &AxisState, goal: &AxisState, limits: &AxisLimits, ramp: Ramp) -> bool {
    let end = motion.end();
    let arrives = (end.position - goal.position).abs() <= END_TOLERANCE
        && (end.velocity - goal.velocity).abs() <= END_TOLERANCE
        && (ramp == Ramp::AccelerationLimited || (end.acceleration - goal.acceleration).abs() <= END_TOLERANCE);
    let peaks = motion.bounds(0.0, motion.duration());
    // A start beyond a limit is brought back, and cannot be blamed on the generator.
    let within = |peak: f64, from: f64, limit: f64| peak <= limit.max(from) * (1.0 + LIMIT_TOLERANCE) + LIMIT_TOLERANCE;
    arrives
        && within(peaks.velocity.magnitude(), start.velocity.abs(), limits.velocity())
        && (ramp == Ramp::AccelerationLimited || within(peaks.jerk.magnitude(), 0.0, limits.jerk()))
        && match ramp {
            Ramp::AccelerationLimited => {
                motion.phases().iter().all(|p| within(p.start.acceleration.abs(), 0.0, limits.acceleration()))
            }
            Ramp::JerkLimited => {
                within(peaks.acceleration.magnitude(), start.acceleration.abs(), limits.acceleration())
            }
        }
}
