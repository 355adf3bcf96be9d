use super::file::Joint;
use super::tree::Tree;
use super::{UrdfError, UrdfFault};
use std::collections::HashMap;

/// Names by which makers mark the link to mount tools on or to work with, the more usual ones first.
const CONVENTIONS: [&str; 4] = ["tool0", "flange", "ee_link", "tcp"];

/// A tip that was guessed.
pub(super) struct Guess<'a> {
    pub(super) tip: &'a str,
    /// The other links that could have been meant, in the order of the file's joints: they end the tree beyond the arm's
    /// first joint, or have a conventional name.
    pub(super) alternatives: Vec<&'a str>,
}

/// The tip one means when one names none.
///
/// From the base outward as long as a single branch moves on its own (a gripper's fingers are several), or a single one of
/// several leads to a conventional name; from there through fixed joints to a conventional name, one that ends the tree
/// before others, or else as far as the fixed joints lead.
pub(super) fn guess<'a>(tree: &Tree<'a>, base: &str) -> Result<Guess<'a>, UrdfError> {
    let Arm { first, last } = arm(tree, base)?;
    let candidates = beyond(tree, last, |joint| !joint.moves());
    let ends = |link: &str| tree.children(link).iter().all(|joint| joint.moves());
    let named = |&&(_, link): &&(usize, &'a str)| convention(link).is_some();
    // Of equals the first: an end before a way station, the more usual name before others, the farther before the nearer.
    let best =
        candidates.iter().filter(named).min_by_key(|(depth, link)| (!ends(link), convention(link), usize::MAX - depth));
    let farthest = || candidates.iter().rev().max_by_key(|(depth, _)| *depth);
    let tip = best.or_else(farthest).map_or(last, |(_, link)| *link);
    let other = |link: &&str| *link != tip && (tree.children(link).is_empty() || convention(link).is_some());
    let alternatives = beyond(tree, first, |_| true).into_iter().map(|(_, link)| link).filter(other).collect();
    Ok(Guess { tip, alternatives })
}

/// Rank of a link's name among the conventions, `left_tool0` counting as `tool0`.
fn convention(link: &str) -> Option<usize> {
    let link = link.to_ascii_lowercase();
    let is = |name: &&str| {
        link.strip_suffix(name).is_some_and(|rest| rest.is_empty() || rest.ends_with(['_', '-', '/', '.']))
    };
    CONVENTIONS.iter().position(is)
}

/// The links behind the first and the last joint that are sure to be of the arm, the base if there is no joint.
struct Arm<'a> {
    first: &'a str,
    last: &'a str,
}

fn arm<'a>(tree: &Tree<'a>, base: &str) -> Result<Arm<'a>, UrdfError> {
    let moving = tree.moving();
    let mut link = tree.link(base)?.name.as_str();
    let (mut joints, mut arm) = (0, Arm { first: link, last: link });
    loop {
        // A tool frame beside the only joint that moves on: the joint is that of a gripper.
        let ends_here =
            joints > 0 && beyond(tree, link, |joint| !joint.moves()).iter().any(|(_, l)| convention(l).is_some());
        let branches = moving_branches(tree, link, &moving);
        let conventional: Vec<_> = branches.iter().filter(|j| leads_to_convention(tree, &j.child)).collect();
        let next = match (branches.as_slice(), conventional.as_slice()) {
            ([_], []) if ends_here => return Ok(arm),
            ([only], _) => only,
            (_, [only]) => **only,
            ([], _) => return Ok(arm),
            (several, _) if joints == 0 => return Err(several_arms(tree, link, several)),
            _ => return Ok(arm),
        };
        link = &next.child;
        if next.moves() {
            arm = Arm { first: if joints == 0 { link } else { arm.first }, last: link };
            joints += 1;
        }
    }
}

fn moving_branches<'a>(tree: &Tree<'a>, link: &str, moving: &HashMap<&str, bool>) -> Vec<&'a Joint> {
    let moves = |joint: &&&Joint| joint.moves() || moving.get(joint.child.as_str()) == Some(&true);
    tree.children(link).iter().filter(moves).copied().collect()
}

fn leads_to_convention(tree: &Tree<'_>, link: &str) -> bool {
    beyond(tree, link, |_| true).iter().any(|(_, link)| convention(link).is_some())
}

fn several_arms(tree: &Tree<'_>, link: &str, branches: &[&Joint]) -> UrdfError {
    let ends = branches.iter().flat_map(|branch| beyond(tree, &branch.child, |_| true));
    let tips = ends.map(|(_, link)| link).filter(|link| tree.children(link).is_empty()).map(str::to_owned).collect();
    let branches = branches.iter().map(|joint| joint.child.clone()).collect();
    let fault = UrdfFault::SeveralArms { link: link.to_owned(), branches, tips };
    match tree.link(link) {
        Ok(at) => fault.at(at.owner().place),
        Err(error) => error,
    }
}

/// A link and those beyond it through joints that count, each with its distance, in the order of the file's joints.
fn beyond<'a>(tree: &Tree<'a>, link: &str, counts: fn(&Joint) -> bool) -> Vec<(usize, &'a str)> {
    let mut found = Vec::new();
    let mut waiting = Vec::from_iter(tree.link(link).ok().map(|link| (0, link.name.as_str())));
    while let Some((depth, link)) = waiting.pop() {
        found.push((depth, link));
        let next = tree.children(link).iter().rev().filter(|joint| counts(joint));
        waiting.extend(next.map(|joint| (depth + 1, joint.child.as_str())));
    }
    found
}
