use crate::{Friction, JointDescription, JointLimits, Note, PositionRange, RobotError};

/// A follower's limits and friction, which are its leader's to bear: at the speed `q̇` of the leader it moves with
/// `ratio q̇`, and a torque `τ` on it is one of `ratio τ` on the leader.
pub(super) struct Share {
    /// Index of the leader.
    pub(super) leader: usize,
    /// Not zero.
    pub(super) ratio: f64,
    /// The follower as if it moved on its own; its joint's offset is its position for a leader at zero.
    pub(super) follower: JointDescription,
}

impl Share {
    /// Adds the friction and narrows range, speed, acceleration and jerk. The follower has no motor of its own: its torque
    /// limit says nothing about the leader's.
    pub(super) fn impose(&self, joints: &mut [JointDescription], notes: &mut Vec<Note>) -> Result<(), RobotError> {
        let Some(leader) = joints.get_mut(self.leader) else { return Ok(()) };
        let narrowed = self.narrowed(&leader.limits);
        narrowed.validate(&leader.name)?;
        if narrowed != leader.limits {
            notes.push(Note::FollowerLimits { joint: self.follower.name.clone(), leader: leader.name.clone() });
        }
        leader.limits = narrowed;
        let own = self.friction();
        let friction = &mut leader.drive.friction;
        friction.viscous += own.viscous;
        friction.forward += own.forward;
        friction.backward += own.backward;
        Ok(())
    }

    fn narrowed(&self, limits: &JointLimits) -> JointLimits {
        let own = &self.follower.limits;
        let least = |a: Option<f64>, b: Option<f64>| {
            let b = b.map(|limit| limit / self.ratio.abs());
            a.into_iter().chain(b).reduce(f64::min)
        };
        JointLimits {
            position: self.range(limits.position),
            velocity: least(limits.velocity, own.velocity),
            effort: limits.effort,
            acceleration: least(limits.acceleration, own.acceleration),
            jerk: least(limits.jerk, own.jerk),
        }
    }

    /// The part of the leader's range in which the follower keeps its own.
    fn range(&self, leader: Option<PositionRange>) -> Option<PositionRange> {
        let Some(own) = self.follower.limits.position else { return leader };
        let [a, b] = [own.lower, own.upper].map(|position| (position - self.follower.joint.offset) / self.ratio);
        let leader = leader.unwrap_or(PositionRange { lower: f64::NEG_INFINITY, upper: f64::INFINITY });
        Some(PositionRange { lower: leader.lower.max(a.min(b)), upper: leader.upper.min(a.max(b)) })
    }

    /// The follower's friction seen from the leader; a negative ratio exchanges the directions.
    fn friction(&self) -> Friction {
        let Friction { viscous, forward, backward } = self.follower.drive.friction;
        let (forward, backward) = if self.ratio > 0.0 { (forward, backward) } else { (backward, forward) };
        let size = self.ratio.abs();
        Friction { viscous: size * size * viscous, forward: size * forward, backward: size * backward }
    }
}
