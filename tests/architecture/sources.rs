//! The packages of a workspace as their sources say: dependencies, modules, and which file names what of which other.

use crate::mentions::{Mention, UseLine, mentions};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Names from a crate's root to a module.
pub(crate) type ModulePath = Vec<String>;

/// A package, from its folder.
pub(crate) struct Package {
    pub(crate) name: String,
    /// Dependencies of the code itself, not of its tests.
    pub(crate) dependencies: BTreeSet<String>,
    /// The package's `Cargo.toml`, from the workspace's root.
    pub(crate) manifest: PathBuf,
    /// Files from the workspace's root.
    pub(crate) files: Vec<PathBuf>,
    modules: BTreeMap<ModulePath, Module>,
}

/// A module: a file's, or one written inside a file.
#[derive(Default)]
struct Module {
    file: usize,
    children: BTreeSet<String>,
    uses: Vec<UseLine>,
    mentions: Vec<Mention>,
}

/// A place that a path leads to.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Place {
    File(usize),
    External(String),
}

impl Package {
    /// Reads a package below the workspace's root.
    pub(crate) fn read(root: &Path, folder: &Path) -> Self {
        let manifest = folder.join("Cargo.toml");
        let table: toml::Table = text(&root.join(&manifest)).parse().expect("a manifest");
        let keys = |key: &str| table.get(key).and_then(toml::Value::as_table).into_iter().flat_map(toml::Table::keys);
        let mut package = Self {
            name: table["package"]["name"].as_str().expect("a name").to_owned(),
            dependencies: keys("dependencies").chain(keys("build-dependencies")).cloned().collect(),
            manifest,
            files: Vec::new(),
            modules: BTreeMap::new(),
        };
        let source = folder.join("src");
        for name in ["lib.rs", "main.rs"] {
            if root.join(&source).join(name).exists() {
                package.read_module(root, source.join(name), &source, &[]);
                break;
            }
        }
        package
    }

    /// Reads a module's file and those of its children, which lie in `folder`.
    fn read_module(&mut self, root: &Path, path: PathBuf, folder: &Path, at: &[String]) {
        let file =
            syn::parse_file(&text(&root.join(&path))).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let number = self.files.len();
        self.files.push(path);
        let mut elsewhere = Vec::new();
        self.take_module(number, at, &file.items, &mut elsewhere);
        for child in elsewhere {
            let below = child.iter().skip(at.len()).fold(folder.to_owned(), |folder, name| folder.join(name));
            let beside = below.with_extension("rs");
            let path = if root.join(&beside).exists() { beside } else { below.join("mod.rs") };
            self.read_module(root, path, &below, &child);
        }
    }

    /// Takes in the items of a module; children with files of their own come into `elsewhere`.
    fn take_module(&mut self, file: usize, at: &[String], items: &[syn::Item], elsewhere: &mut Vec<ModulePath>) {
        let found = mentions(items);
        let module = Module {
            file,
            children: found.inline.iter().map(|(name, _)| name).chain(&found.declared).cloned().collect(),
            uses: found.uses,
            mentions: found.mentions,
        };
        self.modules.insert(at.to_owned(), module);
        let child = |name: &String| [at, std::slice::from_ref(name)].concat();
        elsewhere.extend(found.declared.iter().map(child));
        for (name, items) in &found.inline {
            self.take_module(file, &child(name), items, elsewhere);
        }
    }

    /// The arrows between files: from the one that names something to the one where that is defined. A name that is only passed on
    /// by a public `use` makes none.
    pub(crate) fn arrows(&self) -> BTreeSet<(usize, usize)> {
        let places = self.places(|line| !line.public);
        let between = |(from, to)| if let Place::File(to) = to { Some((from, to)) } else { None };
        places.into_iter().filter_map(between).filter(|(from, to)| from != to).collect()
    }

    /// The files that name something of another crate, with the crate's name as in a manifest.
    pub(crate) fn externals(&self) -> BTreeSet<(usize, String)> {
        let outside = |(from, to)| if let Place::External(name) = to { Some((from, name)) } else { None };
        self.places(|_| true).into_iter().filter_map(outside).collect()
    }

    /// Files that contain one of several names.
    pub(crate) fn naming(&self, names: &[&str]) -> BTreeSet<usize> {
        let is_named = |segments: &[String]| segments.iter().any(|segment| names.contains(&segment.as_str()));
        let modules = self.modules.values();
        let naming = modules.filter(|m| {
            m.mentions.iter().any(|mention| is_named(mention)) || m.uses.iter().any(|line| is_named(&line.path))
        });
        naming.map(|m| m.file).collect()
    }

    /// The first name of a file's module, empty for the root's.
    pub(crate) fn top(&self, file: usize) -> &str {
        let of_file = self.modules.iter().find(|(_, module)| module.file == file);
        of_file.and_then(|(path, _)| path.first()).map_or("", String::as_str)
    }

    fn places(&self, counts: fn(&UseLine) -> bool) -> BTreeSet<(usize, Place)> {
        let mut places = BTreeSet::new();
        for (at, module) in &self.modules {
            let lines = module.uses.iter().filter(|line| counts(line)).map(|line| &line.path);
            // A name without `::` is a module's only in a `use` line; elsewhere it may be a variable's.
            let mentioned = module.mentions.iter().filter(|m| m.len() > 1 || module.binds(&m[0]));
            places.extend(lines.chain(mentioned).filter_map(|path| Some((module.file, self.resolve(at, path, 0)?))));
        }
        places
    }

    /// The place that a path leads to from a module, through `use` lines on its way; `None` for names of the language and of items
    /// beside it.
    fn resolve(&self, at: &[String], path: &[String], depth: usize) -> Option<Place> {
        // A chain of `use` lines so long goes round.
        let (first, rest) = path.split_first().filter(|_| depth < 32)?;
        let module = self.modules.get(at)?;
        match first.as_str() {
            "crate" | "$crate" => self.walk(&[], rest, depth),
            "self" => self.walk(at, rest, depth),
            "super" => self.walk(at.split_last()?.1, rest, depth),
            name if module.children.contains(name) => self.walk(&[at, &path[..1]].concat(), rest, depth),
            name => match module.line_of(name).filter(|line| line.path != [name]) {
                Some(line) => self.resolve(at, &[&line.path, rest].concat(), depth + 1),
                None => self.external(name),
            },
        }
    }

    /// The place of `rest` inside a module.
    fn walk(&self, at: &[String], rest: &[String], depth: usize) -> Option<Place> {
        let module = self.modules.get(at)?;
        let Some((first, after)) = rest.split_first() else { return Some(Place::File(module.file)) };
        match first.as_str() {
            "super" => self.walk(at.split_last()?.1, after, depth),
            "self" => self.walk(at, after, depth),
            name if module.children.contains(name) => self.walk(&[at, &rest[..1]].concat(), after, depth),
            name if module.binds(name) => self.resolve(at, rest, depth + 1),
            _ => Some(Place::File(module.file)),
        }
    }

    fn external(&self, name: &str) -> Option<Place> {
        let same = |dependency: &&String| dependency.replace('-', "_") == name;
        self.dependencies.iter().find(same).map(|dependency| Place::External(dependency.clone()))
    }
}

impl Module {
    fn line_of(&self, name: &str) -> Option<&UseLine> {
        self.uses.iter().find(|line| line.name == name)
    }

    fn binds(&self, name: &str) -> bool {
        self.line_of(name).is_some()
    }
}

fn text(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Every package of a workspace.
pub(crate) fn packages(root: &Path) -> Vec<Package> {
    let table: toml::Table = text(&root.join("Cargo.toml")).parse().expect("a manifest");
    let members = table["workspace"]["members"].as_array().expect("members");
    let folders = members.iter().map(|member| PathBuf::from(member.as_str().expect("a folder")));
    folders.map(|folder| Package::read(root, &folder)).collect()
}
