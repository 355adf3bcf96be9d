use crate::{FollowerDescription, JointDescription, LinkInertia, Pose};

/// A chain put together from base to tool: joints, what is fixed between them, and the loads on them.
pub(crate) struct Assembly {
    pub(crate) joints: Vec<JointDescription>,
    pub(crate) followers: Vec<FollowerDescription>,
    /// Pose of the present link in the frame of the last joint or follower, of the base where there is none yet.
    pub(crate) pose: Pose,
    last: Last,
}

/// Element that the present link is fixed to.
#[derive(Clone, Copy)]
enum Last {
    Base,
    Joint,
    Follower,
}

impl Assembly {
    pub(crate) fn new() -> Self {
        Self { joints: Vec::new(), followers: Vec::new(), pose: Pose::identity(), last: Last::Base }
    }

    /// Goes on to a link fixed to the present one, at a pose in its frame.
    pub(crate) fn fixed(&mut self, pose: &Pose) {
        self.pose *= pose;
    }

    /// Goes on through a joint, its origin in the frame of the present link and its own link replaced by later loads.
    pub(crate) fn joint(&mut self, mut joint: JointDescription) {
        joint.joint.origin = self.pose * joint.joint.origin;
        joint.link = LinkInertia::default();
        self.joints.push(joint);
        (self.pose, self.last) = (Pose::identity(), Last::Joint);
    }

    /// Goes on through a follower, as through a joint; its place is where it is added.
    pub(crate) fn follower(&mut self, mut follower: FollowerDescription) {
        follower.follower.joint.origin = self.pose * follower.follower.joint.origin;
        follower.follower.after = self.joints.len();
        follower.link = LinkInertia::default();
        self.followers.push(follower);
        (self.pose, self.last) = (Pose::identity(), Last::Follower);
    }

    /// True if a joint or a follower moves the present link, and so a load on it.
    pub(crate) fn moves(&self) -> bool {
        !matches!(self.last, Last::Base)
    }

    /// Fixes a body to the present link, given in its frame. On the base it does not count.
    pub(crate) fn load(&mut self, body: &LinkInertia) {
        let body = body.seen_from(&self.pose);
        let link = match self.last {
            Last::Base => None,
            Last::Joint => self.joints.last_mut().map(|joint| &mut joint.link),
            Last::Follower => self.followers.last_mut().map(|follower| &mut follower.link),
        };
        if let Some(link) = link {
            *link = link.joined(&body);
        }
    }
}
