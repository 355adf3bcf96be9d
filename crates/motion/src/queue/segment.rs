use super::rate::Pace;
use crate::profile::Ramp;
use crate::tool::{RegulatedMotion, ToolKinematics, ToolMotion};
use crate::{AxisLimits, Interpolation, JointMotion, JointState, MotionError, Range};
use slideway_robot::JointVector;

/// Motion of the joints or of the tool.
#[derive(Clone, Copy, Debug)]
// Boxing the larger variant would allocate in the control loop.
#[allow(clippy::large_enum_variant)]
pub(super) enum Motion<const N: usize> {
    /// The joints, each by its profile.
    Joint(JointMotion<N>),
    /// The tool along a curve, by a profile.
    Tool(ToolMotion<N>),
    /// The tool along a curve, its speed decided sample by sample.
    Regulated(RegulatedMotion<N>),
}

impl<const N: usize> Motion<N> {
    /// True if the motion runs on path time; else it runs by itself.
    pub(super) fn runs_on_path_time(&self) -> bool {
        match self {
            Self::Joint(_) | Self::Tool(_) => true,
            Self::Regulated(_) => false,
        }
    }

    /// Duration in path time, s; of a regulated motion at full pace.
    pub(super) fn duration(&self) -> f64 {
        match self {
            Self::Joint(m) => m.duration(),
            Self::Tool(m) => m.law().duration(),
            Self::Regulated(m) => m.duration(),
        }
    }

    pub(super) fn start(&self) -> JointVector<N> {
        match self {
            Self::Joint(m) => m.at(0.0).q,
            Self::Tool(m) => *m.start(),
            Self::Regulated(m) => *m.start(),
        }
    }

    pub(super) fn end(&self) -> JointVector<N> {
        match self {
            Self::Joint(m) => m.end().q,
            Self::Tool(m) => *m.end(),
            Self::Regulated(m) => *m.end(),
        }
    }
}

/// A stretch of the queue.
#[derive(Clone, Copy, Debug)]
pub(super) struct Segment<const N: usize> {
    /// Motion of the joints or of the tool.
    pub(super) motion: Motion<N>,
    /// Bound on changes of its pace: `None` where the speed itself jumps.
    pub(super) ramp: Option<Ramp>,
    /// Kind of its end.
    pub(super) end: EndOf,
    /// The Go-To it came from, if it did.
    pub(super) go_to: Option<Interpolation>,
}

/// Kind of a segment's end: a motion may stop there, or not.
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
    /// `q̇ = r Q'`, `q̈ = r² Q'' + w Q'`. The tool's segments need its kinematics and a joint position close by; a regulated one is
    /// where it is.
    pub(super) fn at(
        &self,
        s: f64,
        (rate, slope): (f64, f64),
        tool: Option<&ToolKinematics<N>>,
        seed: &JointVector<N>,
    ) -> Result<JointState<N>, MotionError> {
        let JointState { q, qd, qdd } = match &self.motion {
            Motion::Joint(motion) => motion.at(s),
            Motion::Tool(motion) => {
                let kinematics = tool.ok_or(MotionError::NoTool)?;
                motion.follow(kinematics, s, seed).map_err(|fault| motion.fault(s, fault))?
            }
            Motion::Regulated(motion) => return motion.set_point(tool.ok_or(MotionError::NoTool)?),
        };
        Ok(JointState { q, qd: qd * rate, qdd: qdd * (rate * rate) + qd * slope })
    }

    /// True if the limits hold while the segment's time covers `[from, to]` at the given pace:
    ///
    /// ```text
    /// |r² Q'' + w Q'| <= A,   |r³ Q''' + 3 r w Q'' + x Q'| <= J
    /// ```
    ///
    /// by interval arithmetic, hence for every instant of the span. The speed limit needs no check at a pace of at most 1.
    /// Segments of the tool have bounds by samples, and none of their jerk.
    pub(super) fn keeps(&self, limits: &[AxisLimits; N], from: f64, to: f64, pace: &Pace) -> bool {
        let Some(ramp) = self.ramp else { return true };
        let (r, w, x) = (pace.rate, pace.slope, pace.curvature);
        let square = r.times(r);
        limits.iter().enumerate().all(|(joint, limits)| {
            let (velocity, acceleration, jerk) = match &self.motion {
                Motion::Joint(motion) => {
                    let q = motion.bounds(joint, from, to);
                    (q.velocity, q.acceleration, Some(q.jerk).filter(|_| ramp == Ramp::JerkLimited))
                }
                Motion::Tool(motion) => {
                    let (v, a) = motion.bounds(joint, from, to);
                    (Range { lower: -v, upper: v }, Range { lower: -a, upper: a }, None)
                }
                // It keeps its limits by itself, at every pace.
                Motion::Regulated(_) => return true,
            };
            let total = square.times(acceleration).plus(w.times(velocity));
            let keeps_jerk = jerk.is_none_or(|jerk| {
                let cross = r.times(w).times(acceleration);
                let total = square.times(r).times(jerk).plus(cross.plus(cross).plus(cross)).plus(x.times(velocity));
                total.magnitude() <= limits.jerk() * (1.0 + ROUNDING)
            });
            total.magnitude() <= limits.acceleration() * (1.0 + ROUNDING) && keeps_jerk
        })
    }
}
