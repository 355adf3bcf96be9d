use crate::assembly::Assembly;
use crate::{FollowerDescription, LinkInertia, Note, Pose, RobotDescription, RobotError};

impl RobotDescription {
    /// The same robot with one joint held at a position (rad or m): an arm with one joint less.
    ///
    /// The link behind the joint becomes part of the one before it, or of the base, where its mass does not count; joints
    /// that follow it are held too. So a seven-joint arm serves a six-coordinate task without redundancy. A DH table is given
    /// up: what is left need not have one.
    ///
    /// # Errors
    ///
    /// There is no joint of that name, it is the only one, the position is not finite or outside the joint's range.
    pub fn locked(&self, joint: &str, position: f64) -> Result<Self, RobotError> {
        let index = self.index_of(joint)?;
        if self.joints.len() < 2 {
            return Err(RobotError::JointCount { found: 1, expected: 2 });
        }
        if !position.is_finite() {
            return Err(RobotError::NotFinite { joint: index, field: "locked position", value: position });
        }
        if let Some(range) = self.joints[index].limits.position.filter(|range| !range.contains(position)) {
            return Err(RobotError::LockedOutsideLimits { joint: joint.to_owned(), position, range });
        }
        let mut chain = Assembly::new();
        for (i, own) in self.joints.iter().enumerate() {
            self.followers_at(i, &mut chain, index, position);
            if i == index {
                hold(&mut chain, &(own.joint.origin * own.joint.motion(position)), &own.link);
            } else {
                chain.joint(own.clone());
                chain.load(&own.link);
            }
        }
        self.followers_at(self.joints.len(), &mut chain, index, position);
        chain.fixed(&self.tool);
        let mut robot =
            Self { joints: chain.joints, followers: chain.followers, tool: chain.pose, dh: None, ..self.clone() };
        robot.notes.push(Note::Locked { joint: joint.to_owned(), position });
        Ok(robot)
    }

    /// Adds the followers between two joints, those of the locked one held.
    fn followers_at(&self, after: usize, chain: &mut Assembly, locked: usize, position: f64) {
        for described in self.followers.iter().filter(|described| described.follower.after == after) {
            let follower = described.follower;
            if follower.leader == locked {
                let motion = follower.joint.motion(follower.ratio * position);
                hold(chain, &(follower.joint.origin * motion), &described.link);
                continue;
            }
            let mut kept: FollowerDescription = described.clone();
            kept.follower.leader -= usize::from(follower.leader > locked);
            chain.follower(kept);
            chain.load(&described.link);
        }
    }
}

fn hold(chain: &mut Assembly, pose: &Pose, link: &LinkInertia) {
    chain.fixed(pose);
    chain.load(link);
}
