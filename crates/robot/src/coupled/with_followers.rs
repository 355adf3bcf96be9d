use crate::{Follower, RobotError, SerialArm};

impl<const N: usize> SerialArm<N> {
    /// The same arm with followers between its joints, those with the same place in the order given. The origin of a joint
    /// or follower is in the frame of the joint or follower before it. A DH table is given up.
    ///
    /// # Errors
    ///
    /// A leader or place that is not there, or a ratio that is not finite.
    pub fn with_followers(self, mut followers: Vec<Follower>) -> Result<Self, RobotError> {
        for follower in &followers {
            if follower.leader >= N || follower.after > N {
                return Err(RobotError::JointCount { found: N, expected: follower.after.max(follower.leader + 1) });
            }
            if !follower.ratio.is_finite() {
                let (joint, value) = (follower.leader, follower.ratio);
                return Err(RobotError::NotFinite { joint, field: "follower's ratio", value });
            }
        }
        followers.sort_by_key(|follower| follower.after);
        Ok(Self { followers, dh: None, ..self })
    }

    /// The joints that follow others, from base to tool.
    #[must_use]
    pub fn followers(&self) -> &[Follower] {
        &self.followers
    }
}
