use super::file::{Joint, UrdfFile, Version};
use super::gravity;
use super::inertia::inertia;
use super::limits::{drive, limits};
use super::mimic::{Mimicry, held, mimicry, motion};
use super::share::Share;
use super::tree::Tree;
use super::{UrdfError, UrdfFault};
use crate::assembly::Assembly;
use crate::{Follower, FollowerDescription, JointDescription, LinkInertia, Note, Pose, RobotDescription, RobotError};

/// The arm between two links of a checked tree.
pub(super) fn describe(file: &UrdfFile, tree: &Tree<'_>, base: &str, tip: &str) -> Result<RobotDescription, UrdfError> {
    let chain = tree.chain(base, tip)?;
    let mut reader = ChainReader::new(tree, file, &chain)?;
    for (i, joint) in chain.iter().enumerate() {
        reader.pass(joint, chain.get(i + 1).map(|next| next.name.as_str()))?;
    }
    let gravity = gravity::in_base(tree, base, reader.quaternions(), &mut reader.notes)?;
    let ChainReader { mut chain, mut notes, shares, .. } = reader;
    for share in &shares {
        share.impose(&mut chain.joints, &mut notes).map_err(|fault| at_joint(tree, &share.follower.name, fault))?;
    }
    if chain.joints.is_empty() {
        return Err(UrdfFault::NoJoints { base: base.to_owned(), tip: tip.to_owned() }.into());
    }
    Ok(RobotDescription {
        name: file.name.clone(),
        base: base.to_owned(),
        tip: tip.to_owned(),
        tip_alternatives: Vec::new(),
        joints: chain.joints,
        followers: chain.followers,
        tool: chain.pose,
        gravity,
        notes,
        dh: None,
    })
}

fn at_joint(tree: &Tree<'_>, joint: &str, fault: RobotError) -> UrdfError {
    let fault = UrdfFault::Limits(fault);
    match tree.joints.get(joint) {
        Some(joint) => fault.at(joint.owner().place),
        None => fault.into(),
    }
}

/// A chain on the way from base to tip.
struct ChainReader<'a> {
    tree: &'a Tree<'a>,
    version: Version,
    /// Names of the joints that move on their own, in the order of the chain.
    own: Vec<&'a str>,
    chain: Assembly,
    shares: Vec<Share>,
    notes: Vec<Note>,
}

impl<'a> ChainReader<'a> {
    fn new(tree: &'a Tree<'a>, file: &UrdfFile, chain: &[&'a Joint]) -> Result<Self, UrdfError> {
        let mut own = Vec::new();
        for joint in chain.iter().filter(|joint| joint.moves()) {
            if mimicry(tree, joint)?.is_none() {
                own.push(joint.name.as_str());
            }
        }
        let (version, notes) = (file.version, file.notes.clone());
        Ok(Self { tree, version, own, chain: Assembly::new(), shares: Vec::new(), notes })
    }

    fn quaternions(&self) -> bool {
        self.version == Version::V1_2
    }

    fn origin(&self, joint: &Joint) -> Result<Pose, UrdfError> {
        joint.owner().origin(&joint.element, self.quaternions())
    }

    /// Goes on through a joint of the chain and takes up what its child link carries; `next` is the joint through which the
    /// arm goes on.
    fn pass(&mut self, joint: &'a Joint, next: Option<&str>) -> Result<(), UrdfError> {
        let origin = self.origin(joint)?;
        match (joint.moves(), mimicry(self.tree, joint)?) {
            (false, _) => self.chain.fixed(&origin),
            (true, None) => {
                let moving = self.moving_joint(joint, origin, 0.0)?;
                self.chain.joint(moving);
            }
            (true, Some(mimicry)) => self.mimic(joint, origin, &mimicry)?,
        }
        if self.chain.moves() {
            let carried = self.carried(&joint.child, next)?;
            self.chain.load(&carried);
        }
        Ok(())
    }

    fn moving_joint(&mut self, joint: &Joint, origin: Pose, offset: f64) -> Result<JointDescription, UrdfError> {
        let (kind, axis) = motion(joint)?;
        Ok(JointDescription {
            name: joint.name.clone(),
            joint: crate::Joint { origin, axis, kind, offset },
            limits: limits(joint, self.version, &mut self.notes)?,
            link: LinkInertia::default(),
            drive: drive(joint)?,
        })
    }

    /// A joint of the chain that mimics another: it follows a leader in the chain, or is held.
    fn mimic(&mut self, joint: &Joint, origin: Pose, mimicry: &Mimicry<'_>) -> Result<(), UrdfError> {
        let Mimicry { leader, ratio, offset } = *mimicry;
        let (name, leading) = (joint.name.clone(), leader.name.clone());
        let index = self.own.iter().position(|own| *own == leading).filter(|_| ratio != 0.0);
        let Some(index) = index else {
            self.chain.fixed(&(origin * held(joint, offset)?));
            self.notes.push(Note::HeldMimic { joint: name, leader: leading, position: offset });
            return Ok(());
        };
        let described = self.moving_joint(joint, origin, offset)?;
        let follower = Follower { joint: described.joint, leader: index, ratio, after: 0 };
        self.notes.push(Note::Follows { joint: name.clone(), leader: leading, ratio, offset });
        self.chain.follower(FollowerDescription { name, follower, link: LinkInertia::default() });
        self.shares.push(Share { leader: index, ratio, follower: described });
        Ok(())
    }

    /// A link with everything that hangs on it outside the arm, in its own frame.
    fn carried(&mut self, link: &'a str, next: Option<&str>) -> Result<LinkInertia, UrdfError> {
        let mut body = inertia(self.tree.link(link)?, self.quaternions(), &mut self.notes)?;
        let mut waiting = vec![(link, Pose::identity())];
        while let Some((at, pose)) = waiting.pop() {
            for joint in self.tree.children(at).iter().filter(|j| Some(j.name.as_str()) != next) {
                let pose = pose * self.origin(joint)? * self.aside(joint)?;
                let inertia = inertia(self.tree.link(&joint.child)?, self.quaternions(), &mut self.notes)?;
                body = body.joined(&inertia.seen_from(&pose));
                waiting.push((joint.child.as_str(), pose));
            }
        }
        Ok(body)
    }

    /// The motion of a joint outside the arm where it is held, with a note.
    fn aside(&mut self, joint: &Joint) -> Result<Pose, UrdfError> {
        if !joint.moves() {
            return Ok(Pose::identity());
        }
        let mimicry = mimicry(self.tree, joint)?;
        let position = mimicry.as_ref().map_or(0.0, |mimicry| mimicry.offset);
        let (name, leader) = (joint.name.clone(), mimicry.map(|mimicry| mimicry.leader.name.clone()));
        self.notes.push(match leader {
            Some(leader) if self.own.contains(&leader.as_str()) => {
                Note::FollowsOutside { joint: name, leader, position }
            }
            leader => Note::Aside { joint: name, leader, position },
        });
        held(joint, position)
    }
}
