use crate::Joint;

/// A joint that moves with one of an arm's own: its position is `ratio q_leader + joint.offset`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Follower {
    /// Where it sits in the frame of the link before it, and how it moves; its offset is the position for a leader at zero.
    pub joint: Joint,
    /// Index of the joint that leads it, nearer to the base or to the tool.
    pub leader: usize,
    /// Its motion per motion of the leader.
    pub ratio: f64,
    /// Number of the arm's own joints that lie between the base and it.
    pub after: usize,
}
