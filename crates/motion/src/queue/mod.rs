//! The motion queue.

mod check;
mod commands;
mod interrupt;
mod rate;
mod regulated;
mod segment;
mod tool_commands;

use crate::supervisor::{QueueState, SegmentKind};
use crate::tool::ToolKinematics;
use crate::{JointState, MotionError, MotionLimits, MotionPlanner};
use rate::Rate;
use segment::{EndOf, Motion, Segment};
use slideway_robot::JointVector;
use std::collections::VecDeque;

/// Behaviour at the end of a queue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Repeat {
    /// The joints rest there; segments in the past are discarded.
    Once,
    /// It begins again.
    Forever,
}

/// State of a queue's playback.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Progress {
    /// Nothing is queued: the joints rest.
    Resting,
    /// On the way.
    Moving,
    /// In the middle of the path, at a pace of zero.
    Paused,
}

/// A bounded queue of motions, played back one set-point at a time.
///
/// Memory is allocated once, in [`MotionQueue::new`], for `CAPACITY` segments. A set-point costs the same whatever the queue
/// holds (amortised: each segment is left once); appending and clearing do too.
///
/// # What is guaranteed
///
/// Under any sequence of commands the set-points are continuous in position; in velocity too while no
/// [`Interpolation::Linear`](crate::Interpolation::Linear) is used, and in acceleration while only
/// [`Interpolation::BoundedJerk`](crate::Interpolation::BoundedJerk) is. Limits of the interpolations in use are kept: by plan,
/// and for changes of the pace by interval arithmetic over every instant. To rounding, and to 2e-8 where a motion begins in
/// motion (the accuracy of its planner). A refused command changes nothing.
pub struct MotionQueue<const N: usize, const CAPACITY: usize> {
    limits: MotionLimits<N>,
    planner: MotionPlanner<N>,
    tool: Option<ToolKinematics<N>>,
    segments: VecDeque<Segment<N>>,
    /// Path time into the first segment, s.
    clock: f64,
    /// The set-point given out last; where the joints rest when nothing is queued.
    present: JointState<N>,
    repeat: Repeat,
    rate: Rate,
}

impl<const N: usize, const CAPACITY: usize> MotionQueue<N, CAPACITY> {
    /// An empty queue of joints at rest at `q`.
    ///
    /// # Errors
    ///
    /// A position that is not finite, or closer to a stop than the margin.
    pub fn new(limits: MotionLimits<N>, q: JointVector<N>) -> Result<Self, MotionError> {
        if let Some(joint) = q.iter().position(|q| !q.is_finite()) {
            return Err(MotionError::NotFinite { joint });
        }
        limits.check_position(&q)?;
        Ok(Self {
            limits,
            planner: MotionPlanner::default(),
            tool: None,
            segments: VecDeque::with_capacity(CAPACITY),
            clock: 0.0,
            present: JointState::at_rest(q),
            repeat: Repeat::Once,
            rate: Rate::constant(1.0),
        })
    }

    /// The same queue with an arm, so that it takes Cartesian commands as well.
    #[must_use]
    pub fn with_tool(self, kinematics: ToolKinematics<N>) -> Self {
        Self { tool: Some(kinematics), ..self }
    }

    /// Advances by `dt` seconds and returns the set-point.
    ///
    /// # Errors
    ///
    /// [`MotionError::SamplingPeriod`] if `dt` is not positive and finite. On a Cartesian segment [`MotionError::Tool`] at a
    /// singularity, a stop, or where a joint would be too fast. The queue then stays where it is, its last set-point in
    /// motion: brake with [`MotionQueue::brake_fully`].
    pub fn advance(&mut self, dt: f64) -> Result<JointState<N>, MotionError> {
        if !(dt > 0.0 && dt.is_finite()) {
            return Err(MotionError::SamplingPeriod { period: dt });
        }
        if self.is_regulated() {
            return self.advance_regulated(dt);
        }
        self.follow_wanted_rate();
        let (clock, rate) = (self.clock, self.rate);
        self.clock += self.rate.advance(dt);
        let left = self.leave_finished_segments();
        if self.is_regulated() {
            // What is left of the sample belongs to the next segment; one that begins at rest may begin a fraction of a sample later.
            let rest = std::mem::take(&mut self.clock);
            return if rest > 0.0 { self.advance_regulated(rest) } else { Ok(self.present) };
        }
        match self.state_at_clock() {
            Ok(state) => {
                self.present = state;
                Ok(state)
            }
            Err(error) => {
                // A segment of the tool is entered at rest, so the way-point before it is within reach of the last set-point.
                (self.clock, self.rate) = if left == 0 { (clock, rate) } else { (0.0, self.rate) };
                Err(error)
            }
        }
    }

    /// The present set-point.
    #[must_use]
    pub fn set_point(&self) -> JointState<N> {
        self.present
    }

    fn state_at_clock(&self) -> Result<JointState<N>, MotionError> {
        let Some(segment) = self.segments.front() else { return Ok(JointState::at_rest(self.present.q)) };
        let pace = self.rate.now();
        let seed = &self.present.q;
        let state = segment.at(self.clock, (pace.velocity, pace.acceleration), self.tool.as_ref(), seed)?;
        if let Motion::Tool(motion) = &segment.motion {
            self.check_tool_state(&state).map_err(|fault| motion.fault(self.clock, fault))?;
        }
        Ok(state)
    }

    /// State of the playback.
    #[must_use]
    pub fn progress(&self) -> Progress {
        if self.segments.is_empty() {
            Progress::Resting
        } else if let Some(motion) = self.regulated() {
            if self.rate.wanted == 0.0 && motion.is_resting() { Progress::Paused } else { Progress::Moving }
        } else if self.rate.is_settled() && self.rate.now().velocity == 0.0 {
            Progress::Paused
        } else {
            Progress::Moving
        }
    }

    /// The queue as the supervisor sees it.
    #[must_use]
    pub fn state(&self) -> QueueState {
        let Some(segment) = self.segments.front() else { return QueueState::Resting };
        let kind = match segment.motion {
            Motion::Joint(_) => SegmentKind::Joint,
            Motion::Tool(_) | Motion::Regulated(_) => SegmentKind::Tool,
        };
        if self.progress() == Progress::Paused { QueueState::Paused(kind) } else { QueueState::Ready(kind) }
    }

    /// The pace of path time, in [0, 1].
    #[must_use]
    pub fn rate(&self) -> f64 {
        self.rate.now().velocity
    }

    /// Segments ahead, the present one included.
    #[must_use]
    pub fn len(&self) -> usize {
        self.segments.len()
    }

    /// True if nothing is queued.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.segments.is_empty()
    }

    /// Path time left until the queue's end (once round, if it goes round), s. A curve whose speed is decided sample by sample counts
    /// whole until it is done.
    #[must_use]
    pub fn path_time_left(&self) -> f64 {
        self.segments.iter().map(|s| s.motion.duration()).sum::<f64>() - self.clock
    }

    /// The limits.
    #[must_use]
    pub fn limits(&self) -> &MotionLimits<N> {
        &self.limits
    }

    /// Where the queue ends, at rest.
    #[must_use]
    pub fn end(&self) -> JointVector<N> {
        self.segments.back().map_or(self.present.q, |s| s.motion.end())
    }

    /// Leaves the segments in the past and returns how many they were.
    fn leave_finished_segments(&mut self) -> usize {
        let mut left = 0;
        while let Some(duration) =
            self.segments.front().filter(|s| s.motion.runs_on_path_time()).map(|s| s.motion.duration())
            && self.clock >= duration
        {
            self.clock -= duration;
            left += 1;
            if let Some(past) = self.segments.pop_front() {
                match self.repeat {
                    Repeat::Once => self.present = JointState::at_rest(past.motion.end()),
                    Repeat::Forever => self.segments.push_back(past),
                }
                if past.end == EndOf::Standstill && self.rate.wanted == 0.0 {
                    // The way-point is a place to rest at any pace: a brake on the path goes no further.
                    (self.clock, self.rate) = (0.0, Rate::constant(0.0));
                    break;
                }
            }
        }
        if self.segments.is_empty() {
            self.clock = 0.0;
        }
        left
    }

    fn follow_wanted_rate(&mut self) {
        let not_begun = self.clock == 0.0 && self.present.is_at_rest();
        if self.segments.is_empty() || not_begun {
            // Nothing moves, and what comes begins at rest whatever the pace: it may jump.
            self.rate = Rate::constant(self.rate.wanted);
        } else if self.rate.is_pending() {
            let axes = self.limits.axes();
            let share = |of: fn(&crate::AxisLimits) -> f64| {
                axes.iter().map(|a| of(a) / a.velocity()).fold(f64::INFINITY, f64::min)
            };
            let largest = (share(crate::AxisLimits::acceleration), share(crate::AxisLimits::jerk));
            let mut rate = self.rate;
            rate.replan(largest, |candidate| self.keeps_limits(candidate));
            self.rate = rate;
        }
    }
}
