use super::check::{EQUAL, check_joint, end_of};
use super::segment::{EndOf, Motion, Segment};
use super::{MotionQueue, Repeat};
use crate::profile::Ramp;
use crate::{Interpolation, JointMotion, JointState, MotionError};
use slideway_robot::JointVector;

impl<const N: usize, const CAPACITY: usize> MotionQueue<N, CAPACITY> {
    /// Appends a motion from the queue's end to a target, from rest to rest. A target where the queue ends already adds
    /// nothing.
    ///
    /// # Errors
    ///
    /// A full or a cyclic queue, a number that is not finite, a motion beyond a stop's margin.
    pub fn go_to(&mut self, target: &JointVector<N>, interpolation: Interpolation) -> Result<(), MotionError> {
        let start = JointState::at_rest(self.end());
        let segment = self.planned(&start, target, interpolation)?;
        if segment.motion.duration() > 0.0 { self.append(&[segment]) } else { Ok(()) }
    }

    /// Appends a path computed elsewhere, such as one of [`path_through`](crate::path_through), that comes to rest.
    ///
    /// `ramp` says what it claims to keep: `None` for speeds that jump.
    ///
    /// # Errors
    ///
    /// As [`MotionQueue::go_to`]; a path that does not begin where the queue ends, that jumps, that does not end at rest, or
    /// that exceeds a limit. All of the path is appended, or none.
    pub fn move_along(&mut self, path: &[JointMotion<N>], ramp: Option<Ramp>) -> Result<(), MotionError> {
        let mut before = JointState::at_rest(self.end());
        for motion in path {
            check_joint(&before, &motion.at(0.0), ramp)?;
            self.check_motion_stops(motion)?;
            self.check_motion_limits(motion, ramp)?;
            before = motion.end();
        }
        check_joint(&before, &JointState::at_rest(before.q), ramp)?;
        self.check_room(path.len())?;
        let count = self.segments.len();
        for motion in path.iter().filter(|m| m.duration() > 0.0) {
            self.segments.push_back(Segment {
                motion: Motion::Joint(*motion),
                ramp,
                end: end_of(motion, ramp),
                go_to: None,
            });
        }
        self.unless_rate_objects(count)
    }

    /// Sets what happens at the queue's end.
    ///
    /// # Errors
    ///
    /// [`MotionError::NotClosed`] if the queue's end is not its beginning: the beginning of the present segment.
    pub fn set_repeat(&mut self, repeat: Repeat) -> Result<(), MotionError> {
        if repeat == Repeat::Forever
            && let Some(first) = self.segments.front()
        {
            let gap = first.motion.start() - self.end();
            if let Some(joint) = gap.iter().position(|gap| !(gap.abs() <= EQUAL)) {
                return Err(MotionError::NotClosed { joint, gap: gap[joint] });
            }
        }
        let before = std::mem::replace(&mut self.repeat, repeat);
        if self.keeps_limits(&self.rate) {
            return Ok(());
        }
        self.repeat = before;
        Err(MotionError::RateChanging)
    }

    /// Gives a Go-To ahead another target; the one after it begins there. Both must begin and end at rest.
    ///
    /// # Errors
    ///
    /// [`MotionError::NotEditable`] for the present segment, segments that are not there and paths; else as
    /// [`MotionQueue::go_to`].
    pub fn replace_target(&mut self, index: usize, target: &JointVector<N>) -> Result<(), MotionError> {
        if self.repeat == Repeat::Forever {
            return Err(MotionError::Cyclic);
        }
        let refused = MotionError::NotEditable { index };
        let Some((segment, interpolation)) = self.go_to_at(index).filter(|_| index > 0) else { return Err(refused) };
        let edited = self.planned(&JointState::at_rest(segment.motion.start()), target, interpolation)?;
        let next = match self.segments.get(index + 1) {
            None => None,
            Some(_) => {
                let Some((next, interpolation)) = self.go_to_at(index + 1) else { return Err(refused) };
                Some(self.planned(&JointState::at_rest(*target), &next.motion.end(), interpolation)?)
            }
        };
        let before = [self.segments.get(index).copied(), self.segments.get(index + 1).copied()];
        self.put(index, [Some(edited), next]);
        if self.keeps_limits(&self.rate) {
            return Ok(());
        }
        self.put(index, before);
        Err(MotionError::RateChanging)
    }

    fn put(&mut self, index: usize, new: [Option<Segment<N>>; 2]) {
        for (slot, segment) in self.segments.iter_mut().skip(index).zip(new) {
            if let Some(segment) = segment {
                *slot = segment;
            }
        }
    }

    fn go_to_at(&self, index: usize) -> Option<(Segment<N>, Interpolation)> {
        self.segments.get(index).and_then(|s| s.go_to.map(|interpolation| (*s, interpolation)))
    }

    /// A checked Go-To.
    pub(super) fn planned(
        &mut self,
        start: &JointState<N>,
        target: &JointVector<N>,
        interpolation: Interpolation,
    ) -> Result<Segment<N>, MotionError> {
        let motion = interpolation.plan(&mut self.planner, start, target, self.limits.axes())?;
        self.check_motion_stops(&motion)?;
        Ok(Segment {
            motion: Motion::Joint(motion),
            ramp: interpolation.ramp(),
            end: EndOf::Standstill,
            go_to: Some(interpolation),
        })
    }

    pub(super) fn append(&mut self, segments: &[Segment<N>]) -> Result<(), MotionError> {
        self.check_room(segments.len())?;
        let count = self.segments.len();
        self.segments.extend(segments);
        self.unless_rate_objects(count)
    }

    fn check_room(&self, wanted: usize) -> Result<(), MotionError> {
        if self.repeat == Repeat::Forever && !self.segments.is_empty() {
            return Err(MotionError::Cyclic);
        }
        if self.segments.len() + wanted > CAPACITY {
            return Err(MotionError::QueueFull { capacity: CAPACITY });
        }
        Ok(())
    }

    /// Takes back what was appended after the first `count` segments if the law of the pace in force would break a limit on
    /// it: the law was checked against what was queued then.
    fn unless_rate_objects(&mut self, count: usize) -> Result<(), MotionError> {
        if self.keeps_limits(&self.rate) {
            return Ok(());
        }
        self.segments.truncate(count);
        Err(MotionError::RateChanging)
    }
}
