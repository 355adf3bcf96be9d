use crate::{RobotDescription, RobotError};

impl RobotDescription {
    /// The same robot with one joint held at a position (rad or m): an arm with one joint less.
    ///
    /// The link behind the joint becomes part of the one before it, or of the base, where its mass does not count. So a
    /// seven-joint arm serves a six-coordinate task without redundancy. A DH table is given up: what is left need not have one.
    ///
    /// # Errors
    ///
    /// There is no joint of that name, it is the only one, the position is not finite or outside the joint's range.
    pub fn locked(&self, joint: &str, position: f64) -> Result<Self, RobotError> {
        let unknown = || RobotError::UnknownJoint {
            name: joint.to_owned(),
            known: self.joints.iter().map(|j| j.name.clone()).collect(),
        };
        let index = self.joints.iter().position(|j| j.name == joint).ok_or_else(unknown)?;
        if self.joints.len() < 2 {
            return Err(RobotError::JointCount { found: 1, expected: 2 });
        }
        if !position.is_finite() {
            return Err(RobotError::NotFinite { joint: index, field: "locked position", value: position });
        }
        if self.joints[index].limits.position.is_some_and(|range| !range.contains(position)) {
            return Err(RobotError::LockedOutsideLimits { joint: joint.to_owned(), position });
        }
        let mut robot = self.clone();
        let held = robot.joints.remove(index);
        let pose = held.joint.origin * held.joint.motion(position);
        match robot.joints.get_mut(index) {
            Some(next) => next.joint.origin = pose * next.joint.origin,
            None => robot.tool = pose * robot.tool,
        }
        if let Some(before) = index.checked_sub(1).and_then(|i| robot.joints.get_mut(i)) {
            before.link = before.link.joined(&held.link.seen_from(&pose));
        }
        robot.dh = None;
        robot.notes.push(format!("joint `{joint}` is locked at {position}"));
        Ok(robot)
    }
}
