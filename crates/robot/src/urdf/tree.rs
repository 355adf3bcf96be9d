use super::UrdfError;
use std::collections::{HashMap, HashSet};
use urdf_rs::{Joint, JointType, Link, Robot};

/// The links of a robot as a tree, checked: names unique, every joint between existing links, at most one parent each.
pub(super) struct Tree<'a> {
    links: HashMap<&'a str, &'a Link>,
    parent: HashMap<&'a str, &'a Joint>,
    children: HashMap<&'a str, Vec<&'a Joint>>,
    root: Vec<&'a str>,
}

impl<'a> Tree<'a> {
    pub(super) fn new(robot: &'a Robot) -> Result<Self, UrdfError> {
        let mut tree =
            Self { links: HashMap::new(), parent: HashMap::new(), children: HashMap::new(), root: Vec::new() };
        for link in &robot.links {
            if tree.links.insert(&link.name, link).is_some() {
                return Err(UrdfError::NamedTwice { what: "link", name: link.name.clone() });
            }
        }
        let mut names = HashSet::new();
        for joint in &robot.joints {
            if !names.insert(joint.name.as_str()) {
                return Err(UrdfError::NamedTwice { what: "joint", name: joint.name.clone() });
            }
            tree.connect(joint)?;
        }
        tree.root = robot.links.iter().map(|l| l.name.as_str()).filter(|l| !tree.parent.contains_key(l)).collect();
        if robot.links.is_empty() {
            return Err(UrdfError::NoLinks);
        }
        tree.check_no_loop(robot)?;
        Ok(tree)
    }

    /// With one parent each, the links that no root leads to are those of loops and what hangs on them.
    fn check_no_loop(&self, robot: &Robot) -> Result<(), UrdfError> {
        let mut reached: HashSet<&str> = HashSet::new();
        let mut waiting = self.root.clone();
        while let Some(link) = waiting.pop() {
            reached.insert(link);
            waiting.extend(self.children(link).iter().map(|j| j.child.link.as_str()));
        }
        match robot.links.iter().find(|link| !reached.contains(link.name.as_str())) {
            Some(link) => Err(UrdfError::Loop { link: link.name.clone() }),
            None => Ok(()),
        }
    }

    fn connect(&mut self, joint: &'a Joint) -> Result<(), UrdfError> {
        let (parent, child) = (joint.parent.link.as_str(), joint.child.link.as_str());
        for (end, link) in [("parent", parent), ("child", child)] {
            if !self.links.contains_key(link) {
                return Err(UrdfError::UnknownLink { joint: joint.name.clone(), end, link: link.to_owned() });
            }
        }
        if let Some(other) = self.parent.insert(child, joint) {
            return Err(UrdfError::TwoParents {
                link: child.to_owned(),
                first: other.name.clone(),
                second: joint.name.clone(),
            });
        }
        self.children.entry(parent).or_default().push(joint);
        Ok(())
    }

    pub(super) fn link(&self, name: &str) -> Result<&'a Link, UrdfError> {
        self.links.get(name).copied().ok_or_else(|| {
            let mut known: Vec<String> = self.links.keys().map(|&l| l.to_owned()).collect();
            known.sort();
            UrdfError::NoSuchLink { name: name.to_owned(), known }
        })
    }

    pub(super) fn children(&self, link: &str) -> &[&'a Joint] {
        self.children.get(link).map_or(&[], Vec::as_slice)
    }

    /// The only link without a parent.
    pub(super) fn root(&self) -> Result<&'a str, UrdfError> {
        match self.root.as_slice() {
            [root] => Ok(root),
            several => Err(UrdfError::SeveralRoots { links: several.iter().map(|&l| l.to_owned()).collect() }),
        }
    }

    /// The joints from base to tip.
    pub(super) fn chain(&self, base: &str, tip: &str) -> Result<Vec<&'a Joint>, UrdfError> {
        let (base, mut link) = (self.link(base)?.name.as_str(), self.link(tip)?.name.as_str());
        let mut chain = Vec::new();
        while link != base {
            let Some(joint) = self.parent.get(link) else {
                let (base, tip, root) = (base.to_owned(), tip.to_owned(), link.to_owned());
                return Err(UrdfError::NotReachable { base, tip, root });
            };
            chain.push(*joint);
            link = &joint.parent.link;
        }
        chain.reverse();
        Ok(chain)
    }

    /// The tip one means when one names none: from the base outward as long as a single branch moves on its own (a gripper's
    /// fingers are several), then through fixed joints as far as they lead.
    pub(super) fn default_tip(&self, base: &str) -> Result<&'a str, UrdfError> {
        let moving = self.moving();
        let mut link = self.link(base)?.name.as_str();
        let mut joints = 0;
        for _ in 0..self.links.len() {
            let branches: Vec<_> =
                self.children(link).iter().filter(|j| moves(j) || moving[j.child.link.as_str()]).collect();
            match branches.as_slice() {
                [only] => {
                    joints += usize::from(moves(only));
                    link = &only.child.link;
                }
                [] => break,
                several if joints == 0 => {
                    let branches = several.iter().map(|j| j.child.link.clone()).collect();
                    return Err(UrdfError::SeveralArms { link: link.to_owned(), branches });
                }
                _ => break,
            }
        }
        Ok(self.last_fixed(link))
    }

    /// Whether anything beyond each link moves.
    fn moving(&self) -> HashMap<&'a str, bool> {
        let mut moving: HashMap<&str, bool> = self.links.keys().map(|&l| (l, false)).collect();
        for &link in self.links.keys() {
            let mut link = link;
            // Upward until the root or a link that is known already.
            while let Some(joint) = self.parent.get(link) {
                let marks = moves(joint) || moving[link];
                link = &joint.parent.link;
                if !marks || moving.insert(link, true) == Some(true) {
                    break;
                }
            }
        }
        moving
    }

    /// The link farthest out through fixed joints, the first of equals.
    fn last_fixed(&self, link: &'a str) -> &'a str {
        let mut farthest = (0, link);
        let mut waiting = vec![(0, link)];
        while let Some((depth, link)) = waiting.pop() {
            if depth > farthest.0 {
                farthest = (depth, link);
            }
            let fixed = self.children(link).iter().rev().filter(|j| j.joint_type == JointType::Fixed);
            waiting.extend(fixed.map(|j| (depth + 1, j.child.link.as_str())));
        }
        farthest.1
    }
}

/// Whether a joint moves.
pub(super) fn moves(joint: &Joint) -> bool {
    joint.joint_type != JointType::Fixed
}
