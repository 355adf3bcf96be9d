use super::file::{Joint, Link, UrdfFile};
use super::{UrdfError, UrdfFault};
use std::collections::{HashMap, HashSet};

/// The links of a robot as a tree, checked: names unique, every joint between existing links, at most one parent each.
pub(crate) struct Tree<'a> {
    links: HashMap<&'a str, &'a Link>,
    /// Every joint by its name.
    pub(crate) joints: HashMap<&'a str, &'a Joint>,
    parent: HashMap<&'a str, &'a Joint>,
    children: HashMap<&'a str, Vec<&'a Joint>>,
    roots: Vec<&'a str>,
}

impl<'a> Tree<'a> {
    pub(crate) fn new(file: &'a UrdfFile) -> Result<Self, UrdfError> {
        let mut tree = Self {
            links: HashMap::new(),
            joints: HashMap::new(),
            parent: HashMap::new(),
            children: HashMap::new(),
            roots: Vec::new(),
        };
        for link in &file.links {
            if tree.links.insert(&link.name, link).is_some() {
                return Err(UrdfFault::NamedTwice { what: "link", name: link.name.clone() }.at(link.owner().place));
            }
        }
        for joint in &file.joints {
            if tree.joints.insert(&joint.name, joint).is_some() {
                return Err(UrdfFault::NamedTwice { what: "joint", name: joint.name.clone() }.at(joint.owner().place));
            }
            tree.connect(joint)?;
        }
        tree.roots = file.links.iter().map(|l| l.name.as_str()).filter(|l| !tree.parent.contains_key(l)).collect();
        tree.check_no_loop(file)?;
        Ok(tree)
    }

    /// With one parent each, the links that no root leads to are those of loops and what hangs on them.
    fn check_no_loop(&self, file: &UrdfFile) -> Result<(), UrdfError> {
        let mut reached: HashSet<&str> = HashSet::new();
        let mut waiting = self.roots.clone();
        while let Some(link) = waiting.pop() {
            reached.insert(link);
            waiting.extend(self.children(link).iter().map(|j| j.child.as_str()));
        }
        match file.links.iter().find(|link| !reached.contains(link.name.as_str())) {
            Some(link) => Err(UrdfFault::Loop { link: link.name.clone() }.at(link.owner().place)),
            None => Ok(()),
        }
    }

    fn connect(&mut self, joint: &'a Joint) -> Result<(), UrdfError> {
        let (parent, child) = (joint.parent.as_str(), joint.child.as_str());
        for (end, link) in [("parent", parent), ("child", child)] {
            if !self.links.contains_key(link) {
                let fault = UrdfFault::UnknownLink { joint: joint.name.clone(), end, link: link.to_owned() };
                return Err(fault.at(joint.owner().place));
            }
        }
        if let Some(other) = self.parent.insert(child, joint) {
            let (link, first, second) = (child.to_owned(), other.name.clone(), joint.name.clone());
            return Err(UrdfFault::TwoParents { link, first, second }.at(joint.owner().place));
        }
        self.children.entry(parent).or_default().push(joint);
        Ok(())
    }

    pub(crate) fn link(&self, name: &str) -> Result<&'a Link, UrdfError> {
        self.links.get(name).copied().ok_or_else(|| {
            let mut known: Vec<String> = self.links.keys().map(|&l| l.to_owned()).collect();
            // The nearest to what was asked for first: a list may be cut.
            known.sort_by_cached_key(|link| (strsim::levenshtein(link, name), link.clone()));
            UrdfFault::NoSuchLink { name: name.to_owned(), known }.into()
        })
    }

    pub(crate) fn children(&self, link: &str) -> &[&'a Joint] {
        self.children.get(link).map_or(&[], Vec::as_slice)
    }

    /// The joint that carries a link.
    pub(crate) fn carrier(&self, link: &str) -> Option<&'a Joint> {
        self.parent.get(link).copied()
    }

    /// The only link without a parent.
    pub(crate) fn root(&self) -> Result<&'a str, UrdfError> {
        match self.roots.as_slice() {
            [root] => Ok(root),
            several => Err(UrdfFault::SeveralRoots { links: several.iter().map(|&l| l.to_owned()).collect() }.into()),
        }
    }

    /// The joints from the root that a link hangs on to the link.
    pub(crate) fn way_to(&self, link: &str) -> Vec<&'a Joint> {
        let mut way = Vec::new();
        let mut link = link;
        while let Some(joint) = self.carrier(link) {
            way.push(joint);
            link = &joint.parent;
        }
        way.reverse();
        way
    }

    /// The joints from base to tip.
    pub(crate) fn chain(&self, base: &str, tip: &str) -> Result<Vec<&'a Joint>, UrdfError> {
        let (base, mut link) = (self.link(base)?.name.as_str(), self.link(tip)?.name.as_str());
        let mut chain = Vec::new();
        while link != base {
            let Some(joint) = self.carrier(link) else {
                let (base, tip, root) = (base.to_owned(), tip.to_owned(), link.to_owned());
                return Err(UrdfFault::NotReachable { base, tip, root }.into());
            };
            chain.push(joint);
            link = &joint.parent;
        }
        chain.reverse();
        Ok(chain)
    }

    /// For each link, true if anything beyond it moves.
    pub(crate) fn moving(&self) -> HashMap<&'a str, bool> {
        let mut moving: HashMap<&str, bool> = self.links.keys().map(|&l| (l, false)).collect();
        for &link in self.links.keys() {
            let mut link = link;
            // Upward until the root or a link that is known already.
            while let Some(joint) = self.carrier(link) {
                let marks = joint.moves() || moving[link];
                link = &joint.parent;
                if !marks || moving.insert(link, true) == Some(true) {
                    break;
                }
            }
        }
        moving
    }
}
