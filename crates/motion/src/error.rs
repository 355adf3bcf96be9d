use crate::supervisor::Mode;
use crate::tool::ToolFault;
use crate::{Interpolation, LimitKind};
use slideway_conditioner::ParameterError;
use slideway_robot::{DynamicsError, RobotError};
use thiserror::Error;

/// Quantity that is to be continuous.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Continuity {
    /// Position.
    Position,
    /// Velocity.
    Velocity,
    /// Acceleration.
    Acceleration,
}

/// Why a curve of the tool cannot be made.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum CurveFault {
    /// A number is NaN or infinite.
    #[error("a number is not finite")]
    NotFinite,
    /// No point to go to, or more than a polyline holds.
    #[error("{given} points; a polyline takes 1 to {}", crate::tool::MAX_POINTS - 1)]
    Points {
        /// Points given, the start not counted.
        given: usize,
    },
    /// A line whose ends coincide.
    #[error("line {} has no length", line + 1)]
    NoLength {
        /// Line, counted from 0.
        line: usize,
    },
    /// A blend that does not fit on a line.
    #[error("a blend of {blend} m does not fit on line {}, which is {length} m long", line + 1)]
    Blend {
        /// Blend, m.
        blend: f64,
        /// Line, counted from 0.
        line: usize,
        /// Its length, m.
        length: f64,
    },
    /// An axis without length, an arc without an angle, or a start on the axis.
    #[error("the arc has no axis, no angle or no radius")]
    NoAxis,
}

/// Why a motion was refused, or stopped.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum MotionError {
    /// A limit that is not a positive finite number.
    #[error("the {quantity:?} limit is {value}; it must be positive and finite")]
    LimitNotPositive {
        /// Which limit.
        quantity: LimitKind,
        /// Value given.
        value: f64,
    },
    /// A margin that is negative, or that leaves a joint no room between its stops.
    #[error("a margin of {margin} from the stops leaves no room")]
    Margin {
        /// Margin given, rad or m.
        margin: f64,
    },
    /// A number in a command is NaN or infinite.
    #[error("joint {}: the command holds a number that is not finite", joint + 1)]
    NotFinite {
        /// Joint, counted from 0.
        joint: usize,
    },
    /// A pose with a number that is NaN or infinite.
    #[error("the pose holds a number that is not finite")]
    PoseNotFinite,
    /// A motion that would come closer to a stop than the margin allows.
    #[error("joint {}: the motion reaches {position:.6}, beyond {limit:.6}", joint + 1)]
    JointStop {
        /// Joint, counted from 0.
        joint: usize,
        /// The position reached, rad or m.
        position: f64,
        /// The position allowed, rad or m.
        limit: f64,
    },
    /// A speed at an end of a segment that is above the limit.
    #[error("joint {}: the end speed {velocity:.6} exceeds the limit {limit:.6}", joint + 1)]
    EndSpeed {
        /// Joint, counted from 0.
        joint: usize,
        /// Speed asked for, per s.
        velocity: f64,
        /// Largest speed, per s.
        limit: f64,
    },
    /// A profile that can only begin and end at rest was asked to begin in motion.
    #[error("a {interpolation:?} profile begins at rest, but joint {} moves", joint + 1)]
    NeedsRest {
        /// The profile.
        interpolation: Interpolation,
        /// Joint, counted from 0.
        joint: usize,
    },
    /// The planner of jerk-limited motions gave no answer, or one that fails our check.
    #[error("no motion was found from the current state to the target")]
    NoProfile,
    /// Way-points and durations that do not belong together.
    #[error("{points} way-points need {} positive durations", points.saturating_sub(1))]
    WayPoints {
        /// Way-points given.
        points: usize,
    },
    /// A reference that does not begin where the one before it ends.
    #[error("joint {}: the reference jumps by {jump:.3e} in {quantity:?}", joint + 1)]
    Discontinuous {
        /// Joint, counted from 0.
        joint: usize,
        /// Quantity that jumps.
        quantity: Continuity,
        /// By how much.
        jump: f64,
    },
    /// A reference faster or rougher than the limits.
    #[error("joint {}: the reference reaches {value:.6}, above the {quantity:?} limit {limit:.6}", joint + 1)]
    LimitExceeded {
        /// Joint, counted from 0.
        joint: usize,
        /// Which limit.
        quantity: LimitKind,
        /// Value reached.
        value: f64,
        /// The limit.
        limit: f64,
    },
    /// The queue is full.
    #[error("the queue is full: it holds {capacity} segments")]
    QueueFull {
        /// Segments it can hold.
        capacity: usize,
    },
    /// A cycle whose end is not its beginning.
    #[error("joint {}: the queue ends {gap:.3e} away from its beginning and cannot go round", joint + 1)]
    NotClosed {
        /// Joint, counted from 0.
        joint: usize,
        /// Distance from end to beginning, rad or m.
        gap: f64,
    },
    /// A cyclic queue was asked to append or to be edited.
    #[error("the queue goes round; end the cycle first")]
    Cyclic,
    /// A segment that cannot be edited: in motion already, not there, or not from a Go-To.
    #[error("segment {index} cannot be edited")]
    NotEditable {
        /// Its number, 0 being the one in motion.
        index: usize,
    },
    /// A command that would break a change of the path rate that is under way.
    #[error("the path rate is changing and leaves no room for this command yet")]
    RateChanging,
    /// A path rate outside [0, 1].
    #[error("the path rate is {rate}; it must lie in [0, 1]")]
    Rate {
        /// Rate given.
        rate: f64,
    },
    /// A sampling period that is not a positive finite number.
    #[error("the sampling period is {period} s; it must be positive and finite")]
    SamplingPeriod {
        /// Period given, s.
        period: f64,
    },
    /// The tool cannot follow its line.
    #[error(
        "the tool cannot follow its line at {:.1} % of it, ({:.4}, {:.4}, {:.4}) m: {cause}",
        100.0 * share, place[0], place[1], place[2]
    )]
    Tool {
        /// Where along the line, from 0 to 1.
        share: f64,
        /// Position of the tool there, m, base frame.
        place: [f64; 3],
        /// Why.
        #[source]
        cause: Box<ToolFault>,
    },
    /// A curve that cannot be made.
    #[error("the curve of the tool: {0}")]
    Curve(#[from] CurveFault),
    /// A curve that does not begin where the queue ends.
    #[error("the curve begins {distance:.3e} m and {angle:.3e} rad away from the tool")]
    NotAtStart {
        /// Distance, m.
        distance: f64,
        /// Angle, rad.
        angle: f64,
    },
    /// Settings of a speed law that are out of their range.
    #[error("the speed law: {0}")]
    Regulation(#[from] ParameterError),
    /// A command that the mode of the controller does not take.
    #[error("in the mode {mode:?} the queue takes no commands")]
    WrongMode {
        /// The mode.
        mode: Mode,
    },
    /// A pace or a period of the controller that is out of its range.
    #[error("`{name}` is {value}, which is out of its range")]
    Setting {
        /// Name of the setting.
        name: &'static str,
        /// Value given.
        value: f64,
    },
    /// A Cartesian command to a queue that knows no arm.
    #[error("the queue was made without the kinematics of a tool")]
    NoTool,
    /// An arm that does not fit its task.
    #[error(transparent)]
    Kinematics(#[from] RobotError),
    /// A model of an arm that is none, or that cannot tell accelerations.
    #[error(transparent)]
    Dynamics(#[from] DynamicsError),
    /// A simulated sample that no step is fine enough for.
    #[error(
        "at {time:.6} s the simulation is not resolved with {steps} steps: halving them changes it by {change:.3e}"
    )]
    NotResolved {
        /// Simulated time at the beginning of the sample, s.
        time: f64,
        /// Steps tried last.
        steps: u32,
        /// Change of position or speed when they were halved, rad (m) or per s.
        change: f64,
    },
    /// An experiment that found no answer in the range it was given.
    #[error("the gain stays above half the power up to {highest:.3} rad/s")]
    NoBandwidth {
        /// Highest frequency tried, rad/s.
        highest: f64,
    },
}

/// Refuses a setting unless `accepted`; a comparison with NaN is false, so NaN is refused.
pub(crate) fn setting(name: &'static str, value: f64, accepted: bool) -> Result<(), MotionError> {
    if accepted { Ok(()) } else { Err(MotionError::Setting { name, value }) }
}

/// Refuses a setting that is not positive and finite.
pub(crate) fn positive(name: &'static str, value: f64) -> Result<(), MotionError> {
    setting(name, value, value > 0.0 && value.is_finite())
}

/// Refuses a setting that is negative or not finite.
pub(crate) fn not_negative(name: &'static str, value: f64) -> Result<(), MotionError> {
    setting(name, value, value >= 0.0 && value.is_finite())
}

impl MotionError {
    /// Remedy, in one sentence.
    #[must_use]
    pub fn remedy(&self) -> &'static str {
        match self {
            Self::Setting { .. } | Self::LimitNotPositive { .. } | Self::Rate { .. } | Self::SamplingPeriod { .. } => {
                "give a number in the range named"
            }
            Self::Margin { .. } => "lower the margin, or widen the range of the joint",
            Self::NotFinite { .. } | Self::PoseNotFinite => "look for the NaN where the command was computed",
            Self::JointStop { .. } => "move the target inwards, or go there from rest",
            Self::EndSpeed { .. } | Self::LimitExceeded { .. } => "plan the motion more slowly, or raise the limit",
            Self::NeedsRest { .. } => "stop first, or interrupt with a trapezoid, a cubic or bounded jerk",
            Self::NoProfile => "brake, then plan from rest",
            Self::WayPoints { .. } => "give one duration less than way-points, and at least two way-points",
            Self::Discontinuous { .. } => "begin the reference where the queue ends, at rest",
            Self::QueueFull { .. } => "wait for a segment to end, or give the queue a larger capacity",
            Self::NotClosed { .. } => "append a motion back to the beginning",
            Self::Cyclic => "stop at the next way-point, then append",
            Self::NotEditable { .. } => "edit a later Go-To segment, or interrupt the motion",
            Self::RateChanging => "try again when the rate has settled",
            Self::Tool { .. } => "move the line away from the place named, or go round it by joint motions",
            Self::WrongMode { .. } => "bring the arm to rest, or reset its fault",
            Self::Curve(_) => "give distinct points with room for the corners between them",
            Self::NotAtStart { .. } => "begin the curve at the tool's pose at the queue's end",
            Self::Regulation(_) => "give a positive period, a bandwidth below its inverse and a margin below 1",
            Self::NoTool => "make the queue with the kinematics of its tool",
            Self::Kinematics(_) => "use a task that the arm has joints for",
            Self::Dynamics(_) => "give every moving link a mass and an inertia",
            Self::NotResolved { .. } => {
                "shorten the sampling period, soften the wall, or look for a control that diverges"
            }
            Self::NoBandwidth { .. } => "raise the highest frequency",
        }
    }
}
