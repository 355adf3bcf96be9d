use super::{Chain, Group, Srdf, SrdfError, SrdfFault};
use crate::ChainEnds;
use crate::urdf::{Tree, UrdfError, UrdfFile};
use std::collections::BTreeSet;

impl Srdf {
    /// Base and tip of a group, by the tree of the URDF that it belongs to: those of its chain, or the parent of the first
    /// and the child of the last of its joints; joints of a group's subgroups and the joints that carry its links count.
    ///
    /// # Errors
    ///
    /// There is no such group, it has no joints, names what the URDF does not have, or does not lie on one way outward; the
    /// URDF cannot be read.
    pub fn chain_ends(&self, group: &str, urdf: &str) -> Result<ChainEnds, SrdfError> {
        if let Some(Chain { base, tip }) = self.only_chain(group)? {
            return Ok(ChainEnds { base: Some(base), tip: Some(tip) });
        }
        let refused = |error: UrdfError| SrdfFault::Urdf { message: error.to_string(), remedy: error.remedy() };
        let file = UrdfFile::parse(urdf).map_err(refused)?;
        let tree = Tree::new(&file).map_err(refused)?;
        let mut joints = BTreeSet::new();
        self.collect(group, &tree, &mut Walk::default(), &mut joints)?;
        ends(group, &tree, &joints)
    }

    fn group(&self, name: &str) -> Result<&Group, SrdfError> {
        let known = || self.groups.iter().map(|group| group.name.clone()).collect();
        let unknown = || SrdfFault::NoSuchGroup { name: name.to_owned(), known: known() }.into();
        self.groups.iter().find(|group| group.name == name).ok_or_else(unknown)
    }

    /// The chain of a group that consists of nothing else.
    fn only_chain(&self, name: &str) -> Result<Option<Chain>, SrdfError> {
        let group = self.group(name)?;
        let alone = group.joints.is_empty() && group.links.is_empty() && group.groups.is_empty();
        Ok(match group.chains.as_slice() {
            [chain] if alone => Some(chain.clone()),
            _ => None,
        })
    }

    /// Adds the joints of a group and its subgroups.
    fn collect<'a>(
        &'a self,
        name: &'a str,
        tree: &Tree<'_>,
        walk: &mut Walk<'a>,
        joints: &mut BTreeSet<String>,
    ) -> Result<(), SrdfError> {
        if walk.open.contains(&name) {
            return Err(SrdfFault::GroupLoop { name: name.to_owned() }.into());
        }
        if !walk.seen.insert(name) {
            return Ok(());
        }
        walk.open.push(name);
        let group = self.group(name)?;
        let unknown = |what, part: &str| SrdfFault::UnknownPart { group: name.to_owned(), what, name: part.to_owned() };
        for joint in &group.joints {
            if !tree.joints.contains_key(joint.as_str()) {
                return Err(unknown("joint", joint).into());
            }
            joints.insert(joint.clone());
        }
        for link in &group.links {
            tree.link(link).map_err(|_| unknown("link", link))?;
            joints.extend(tree.carrier(link).map(|joint| joint.name.clone()));
        }
        for Chain { base, tip } in &group.chains {
            let chain = tree.chain(base, tip).map_err(|_| unknown("chain to a link", tip))?;
            joints.extend(chain.iter().map(|joint| joint.name.clone()));
        }
        for inner in &group.groups {
            self.collect(inner, tree, walk, joints)?;
        }
        walk.open.pop();
        Ok(())
    }
}

/// Groups that a walk through subgroups has come by.
#[derive(Default)]
struct Walk<'a> {
    /// Groups that the walk is inside of.
    open: Vec<&'a str>,
    /// All of them: a group that several others contain counts once.
    seen: BTreeSet<&'a str>,
}

/// The ends of the way on which all the joints lie.
fn ends(group: &str, tree: &Tree<'_>, joints: &BTreeSet<String>) -> Result<ChainEnds, SrdfError> {
    let ways = joints.iter().filter_map(|name| tree.joints.get(name.as_str())).map(|joint| tree.way_to(&joint.child));
    let Some(way) = ways.max_by_key(Vec::len) else {
        return Err(SrdfFault::EmptyGroup { name: group.to_owned() }.into());
    };
    let on_way: Vec<&str> = way.iter().map(|joint| joint.name.as_str()).filter(|j| joints.contains(*j)).collect();
    let (Some(first), Some(last)) = (way.iter().find(|j| joints.contains(&j.name)), way.last()) else {
        return Err(SrdfFault::EmptyGroup { name: group.to_owned() }.into());
    };
    if let Some(joint) = joints.iter().find(|joint| !on_way.contains(&joint.as_str())) {
        let (joint, other) = (joint.clone(), last.name.clone());
        return Err(SrdfFault::NotAChain { name: group.to_owned(), joint, other }.into());
    }
    Ok(ChainEnds { base: Some(first.parent.clone()), tip: Some(last.child.clone()) })
}
