//! Arrows that must never be, each violation in words that name both ends.

use crate::sources::Package;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Crates that take values and return values.
const LIBRARIES: [&str; 7] = [
    "slideway-path",
    "slideway-lab",
    "slideway-baselines",
    "slideway-compare",
    "slideway-verify",
    "slideway-motion",
    "slideway-study",
];

/// Readers of files, and what belongs to a terminal.
const READERS_AND_TERMINALS: [&str; 5] = ["slideway-scenario", "toml", "clap", "miette", "indicatif"];

/// The command.
const COMMAND: &str = "slideway";

/// The crate that reads scenarios, and the question that it alone asks of their texts.
const READER: &str = "slideway-scenario";
const KINDS: [&str; 2] = ["ScenarioKind", "scenario_kind"];

/// Libraries neither read files nor know a terminal.
pub(crate) fn values_only(packages: &[Package]) -> Vec<String> {
    depends(packages, &LIBRARIES, &READERS_AND_TERMINALS)
}

/// Optima take paths and limits: no loop, no controller, no trace.
pub(crate) fn optima_know_no_loop(packages: &[Package]) -> Vec<String> {
    depends(packages, &["slideway-baselines"], &["slideway-lab", "slideway-compare", "slideway-verify"])
}

/// Comparison and verification do not know the command.
pub(crate) fn no_command(packages: &[Package]) -> Vec<String> {
    depends(packages, &["slideway-compare", "slideway-verify"], &[COMMAND])
}

/// Arrows from some crates to others, by their manifests and their sources.
fn depends(packages: &[Package], from: &[&str], to: &[&str]) -> Vec<String> {
    let mut violations = Vec::new();
    for package in packages.iter().filter(|p| from.contains(&p.name.as_str())) {
        let end = |name: &str| {
            packages.iter().find(|p| p.name == name).map_or_else(|| name.to_owned(), |p| shown(&p.manifest))
        };
        let listed = package.dependencies.iter().filter(|name| to.contains(&name.as_str()));
        violations.extend(listed.map(|name| format!("{} -> {}", shown(&package.manifest), end(name))));
        let named = package.externals().into_iter().filter(|(_, name)| to.contains(&name.as_str()));
        violations.extend(named.map(|(file, name)| format!("{} -> {}", shown(&package.files[file]), end(&name))));
    }
    violations
}

/// `say/` knows no verb: in the command, nothing but itself and `keep/`.
pub(crate) fn say_knows_no_verb(packages: &[Package]) -> Vec<String> {
    let Some(package) = packages.iter().find(|p| p.name == COMMAND) else { return Vec::new() };
    let is_bad =
        |(from, to): &(usize, usize)| package.top(*from) == "say" && !["say", "keep"].contains(&package.top(*to));
    package.arrows().into_iter().filter(is_bad).map(|(from, to)| arrow(package, from, to)).collect()
}

/// A file of errors does not import what raises them.
pub(crate) fn errors_do_not_import_their_raisers(packages: &[Package]) -> Vec<String> {
    let mut violations = Vec::new();
    for package in packages {
        let arrows = package.arrows();
        let raised =
            |(from, to): &&(usize, usize)| is_of_errors(&package.files[*from]) && arrows.contains(&(*to, *from));
        violations.extend(arrows.iter().filter(raised).map(|(from, to)| arrow(package, *from, *to)));
    }
    violations
}

fn is_of_errors(file: &Path) -> bool {
    let stem = file.file_stem().map_or("".into(), |stem| stem.to_string_lossy());
    let in_failures = file.parent().and_then(Path::file_name).is_some_and(|folder| folder == "failures");
    in_failures || ["error", "errors", "diagnostic"].contains(&&*stem) || stem.ends_with("_error")
}

/// Nothing but the reader of scenarios asks which kind one is.
pub(crate) fn kinds_are_the_readers(packages: &[Package]) -> Vec<String> {
    let Some(reader) = packages.iter().find(|p| p.name == READER) else { return Vec::new() };
    let others = packages.iter().filter(|p| p.name != READER);
    let asks = |p: &Package| {
        let files = p.naming(&KINDS).into_iter();
        files.map(|file| format!("{} asks the kind of {}", shown(&p.files[file]), shown(&reader.manifest))).collect()
    };
    others.flat_map(|package| -> Vec<String> { asks(package) }).collect()
}

fn arrow(package: &Package, from: usize, to: usize) -> String {
    format!("{} -> {}", shown(&package.files[from]), shown(&package.files[to]))
}

/// The files of a crate go in no circle: of each circle, every arrow that lies in it.
pub(crate) fn circles(packages: &[Package]) -> Vec<String> {
    let mut violations = Vec::new();
    for package in packages {
        let arrows = package.arrows();
        let reach = reach(&arrows);
        let comes_back = |from: &usize, to: &usize| reach.get(to).is_some_and(|ends| ends.contains(from));
        let inside = arrows.iter().filter(|(from, to)| comes_back(from, to));
        violations.extend(inside.map(|(from, to)| arrow(package, *from, *to)));
    }
    violations
}

/// The files that each file leads to.
fn reach(arrows: &BTreeSet<(usize, usize)>) -> BTreeMap<usize, BTreeSet<usize>> {
    let starts: BTreeSet<usize> = arrows.iter().map(|(from, _)| *from).collect();
    let from_one = |start: usize| {
        let (mut seen, mut open) = (BTreeSet::new(), vec![start]);
        while let Some(at) = open.pop() {
            let next = arrows.range((at, 0)..=(at, usize::MAX)).map(|(_, to)| *to);
            open.extend(next.filter(|to| seen.insert(*to)));
        }
        (start, seen)
    };
    starts.into_iter().map(from_one).collect()
}

fn shown(path: &Path) -> String {
    path.display().to_string()
}
