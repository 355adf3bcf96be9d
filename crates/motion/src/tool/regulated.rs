use super::natural::{Ceiling, NaturalPace};
use super::regulator::{PathState, Regulator};
use super::walk::walk;
use super::{Regulation, ToolCurve, ToolFault, ToolKinematics};
use crate::{AxisState, JointState, MotionError, MotionLimits};
use slideway_robot::JointVector;

/// A checked Cartesian motion from rest to rest whose speed is decided sample by sample, under joint limits.
///
/// The rate `u̇` of the curve is regulated by [`AccelerationRegulator`](slideway_conditioner::AccelerationRegulator), below what
/// [`LookAhead`](slideway_conditioner::LookAhead) sees over the rest of the curve, whose path speeds were found when the motion was
/// planned. Between two samples `u̇` is linear in time: velocities are continuous, the set-points lie on the curve to the
/// accuracy of the inverse kinematics (below 1e-10 m and rad), at any time asked for.
///
/// *Sliding mode*: `u̇` as large as limits and sight allow. *Natural motion*: below `b |det J|` in addition, `b` the largest that keeps
/// the limits everywhere; the limits shape its ends.
///
/// Guaranteed: from sample to sample of the law no joint's speed changes by more than its acceleration limit allows, and none exceeds its
/// limit (claims `acceleration-box` and `acceleration-factor`), with 1 % of the accelerations and 0.1 % of the speeds in reserve for
/// what lies between, where the acceleration differs from its mean by half a period of its jerk; the end is never passed
/// (claim `curve-end`). A sample in which that cannot be had is a [`ToolFault::TooRough`]: at full pace before the motion, as it is
/// rehearsed; after changes of pace, in corners of some millimetres, perhaps on the way. A pace in [0, 1] scales the rate asked for: 0
/// brakes on the curve as hard as the limits allow, and any other takes the motion up again. Not guaranteed: anything about jerk.
/// Where corners are so sharp that a joint's acceleration turns round within some samples the reserve is not always enough: on
/// random seams with corners of 5 to 30 mm a change of speed exceeded its limit by 2 % at most.
#[derive(Clone, Copy, Debug)]
pub struct RegulatedMotion<const N: usize> {
    curve: ToolCurve,
    regulator: Regulator<N>,
    start: JointVector<N>,
    end: JointVector<N>,
    duration: f64,
    state: PathState<N>,
}

/// State of a motion some time later.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Advanced<const N: usize> {
    /// On the way.
    Moving {
        /// Where on the curve, for [`RegulatedMotion::take`].
        state: PathState<N>,
        /// Where the joints are to be.
        set_point: JointState<N>,
    },
    /// At rest at the end.
    Ended {
        /// Time that is left over, s.
        left: f64,
    },
}

/// A rehearsal that takes so many times the estimate, and a second more for the filter, will not end.
const PATIENCE: f64 = 10.0;

/// A margin that is doubled is this at least, and this at most before.
const SMALLEST_MARGIN: f64 = 0.01;
const LARGEST_MARGIN: f64 = 0.4;

/// A sample this near its end has ended, as a share of the period: rounding of the sums of times.
const ENDED: f64 = 1e-9;

fn is_rough(error: &MotionError) -> bool {
    matches!(error, MotionError::Tool { cause, .. } if matches!(**cause, ToolFault::TooRough { .. } | ToolFault::TooFast { .. }))
}

impl<const N: usize> RegulatedMotion<N> {
    /// Plans a motion under sliding-mode regulation along a curve that begins where the joints put the tool, and follows it once
    /// with the inverse kinematics: at 257 places it must have a solution, continuous from the start, away from singularities
    /// and stops. Then the law is rehearsed at full pace, so that what it cannot do is known before the motion: some twenty
    /// microseconds a sample. Where its corners are too sharp for the plan the margin is doubled, up to four times. `None` if the curve has no extent.
    ///
    /// # Errors
    ///
    /// [`MotionError::Tool`] with the place along the curve, and the cause; [`MotionError::Regulation`];
    /// [`MotionError::NoProfile`] if the rehearsal does not end.
    pub fn sliding_mode(
        kinematics: &ToolKinematics<N>,
        limits: &MotionLimits<N>,
        start: &JointVector<N>,
        curve: &ToolCurve,
        regulation: &Regulation,
    ) -> Result<Option<Self>, MotionError> {
        Self::plan(kinematics, limits, start, curve, regulation, |_, _| Ok(Ceiling::Limits))
    }

    /// Plans a natural motion; else as [`RegulatedMotion::sliding_mode`].
    ///
    /// # Errors
    ///
    /// As there; [`MotionError::Kinematics`] unless the arm has as many joints as its task coordinates.
    pub fn natural(
        kinematics: &ToolKinematics<N>,
        limits: &MotionLimits<N>,
        start: &JointVector<N>,
        curve: &ToolCurve,
        regulation: &Regulation,
    ) -> Result<Option<Self>, MotionError> {
        Self::plan(kinematics, limits, start, curve, regulation, |regulator, nodes| {
            NaturalPace::new(kinematics, curve, nodes, regulator.limits()).map(Ceiling::Natural)
        })
    }

    fn plan(
        kinematics: &ToolKinematics<N>,
        limits: &MotionLimits<N>,
        start: &JointVector<N>,
        curve: &ToolCurve,
        regulation: &Regulation,
        ceiling: impl Fn(&Regulator<N>, &super::walk::Nodes<N>) -> Result<Ceiling, MotionError>,
    ) -> Result<Option<Self>, MotionError> {
        if curve.length() == 0.0 && curve.angle() == 0.0 {
            return Ok(None);
        }
        let nodes = walk(kinematics, limits, curve, start)?;
        let end = nodes.last().map_or(*start, |node| node.q);
        let mut regulation = *regulation;
        loop {
            let regulator = Regulator::new(limits, &regulation, &nodes)?;
            let regulator = regulator.under(ceiling(&regulator, &nodes)?);
            let duration = regulator.estimated_duration(kinematics, curve, &nodes);
            let state = PathState::at_rest(*start);
            let mut motion = Self { curve: *curve, regulator, start: *start, end, duration, state };
            match motion.rehearsed(kinematics) {
                Ok(duration) => {
                    motion.duration = duration;
                    return Ok(Some(motion));
                }
                Err(fault) if !is_rough(&fault) || regulation.margin > LARGEST_MARGIN => return Err(fault),
                // The plan was too keen for its corners.
                Err(_) => regulation.margin = 2.0 * regulation.margin.max(SMALLEST_MARGIN),
            }
        }
    }

    /// Runs the law once to the end, at full pace, and returns what it takes.
    fn rehearsed(&self, kinematics: &ToolKinematics<N>) -> Result<f64, MotionError> {
        let period = self.regulator.period();
        let mut state = self.state;
        let mut time = 0.0;
        while !state.has_arrived() {
            self.pass(kinematics, &mut state, period, 1.0).map_err(|cause| self.curve.fault(state.place, cause))?;
            time += period;
            if !(time <= PATIENCE * self.duration + 1.0) {
                return Err(MotionError::NoProfile);
            }
        }
        Ok(time)
    }

    /// State after `dt` seconds at a pace; the motion itself stays where it is until it is told to [take](Self::take) the state.
    ///
    /// # Errors
    ///
    /// The place of a [`ToolFault`].
    pub(crate) fn advanced(
        &self,
        kinematics: &ToolKinematics<N>,
        dt: f64,
        pace: f64,
    ) -> Result<Advanced<N>, MotionError> {
        let mut state = self.state;
        let left = self.pass(kinematics, &mut state, dt, pace).map_err(|cause| self.fault(cause))?;
        if state.has_arrived() {
            return Ok(Advanced::Ended { left });
        }
        let set_point = self.joint_state(kinematics, &state)?;
        state.q = set_point.q;
        Ok(Advanced::Moving { state, set_point })
    }

    /// Goes on to a state.
    pub(crate) fn take(&mut self, state: PathState<N>) {
        self.state = state;
    }

    /// Passes time, sample by sample, and returns what is left of it at the end.
    fn pass(
        &self,
        kinematics: &ToolKinematics<N>,
        state: &mut PathState<N>,
        dt: f64,
        pace: f64,
    ) -> Result<f64, ToolFault> {
        let period = self.regulator.period();
        let tiny = ENDED * period;
        let mut dt = dt;
        while dt > tiny && !state.has_arrived() {
            if state.left == 0.0 {
                self.regulator.decide(kinematics, &self.curve, state, pace)?;
            }
            let part = if state.left - dt > tiny { dt } else { state.left };
            dt -= part;
            state.left -= part;
            if state.left == 0.0 {
                state.place = (state.place + 0.5 * period * (state.rate + state.next)).min(1.0);
                state.rate = state.next;
            }
        }
        Ok(dt.max(0.0))
    }

    /// `u` and its derivatives now.
    #[must_use]
    pub fn parameter(&self) -> AxisState {
        self.parameter_of(&self.state)
    }

    fn parameter_of(&self, state: &PathState<N>) -> AxisState {
        let PathState { place, rate, slope, left, .. } = *state;
        let since = if left > 0.0 { self.regulator.period() - left } else { 0.0 };
        AxisState {
            position: place + since * (rate + 0.5 * slope * since),
            velocity: rate + slope * since,
            acceleration: slope,
        }
    }

    /// The joint state now.
    ///
    /// # Errors
    ///
    /// [`MotionError::Tool`] where the curve cannot be followed.
    pub fn set_point(&self, kinematics: &ToolKinematics<N>) -> Result<JointState<N>, MotionError> {
        self.joint_state(kinematics, &self.state)
    }

    fn joint_state(&self, kinematics: &ToolKinematics<N>, state: &PathState<N>) -> Result<JointState<N>, MotionError> {
        let u = self.parameter_of(state);
        let place = self.curve.at(u.position);
        let (twist, acceleration) = place.motion(u.velocity, u.acceleration);
        kinematics.follow(&place.pose, &twist, &acceleration, &state.q).map_err(|cause| self.fault(cause))
    }

    /// The place of a fault.
    pub(crate) fn fault(&self, cause: ToolFault) -> MotionError {
        self.curve.fault(self.parameter().position, cause)
    }

    /// Goes back to the beginning.
    pub(crate) fn begin_anew(&mut self) {
        self.state = PathState::at_rest(self.start);
    }

    /// True if it stands still, and will unless its pace changes.
    #[must_use]
    pub fn is_resting(&self) -> bool {
        self.state.is_resting()
    }

    /// The curve.
    #[must_use]
    pub fn curve(&self) -> &ToolCurve {
        &self.curve
    }

    /// Joint position at the beginning.
    #[must_use]
    pub fn start(&self) -> &JointVector<N> {
        &self.start
    }

    /// Joint position at the end.
    #[must_use]
    pub fn end(&self) -> &JointVector<N> {
        &self.end
    }

    /// Duration of the whole motion at full pace, s, as rehearsed: whole periods.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.duration
    }
}
