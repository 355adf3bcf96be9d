//! The index of equations in NOTATION.md held against the files.

use std::path::{Path, PathBuf};

/// The sources and their numbers of numbered equations.
const SOURCES: [(&str, u32); 4] = [("[G11]", 26), ("[G12]", 40), ("[N]", 11), ("[R16]", 4)];

/// A line of the index.
struct Entry {
    equation: String,
    /// File and function; none where a reason is given.
    place: Option<(String, String)>,
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn index() -> Vec<Entry> {
    let text = std::fs::read_to_string(root().join("NOTATION.md")).expect("reads");
    let lines = text.lines().filter(|line| line.starts_with('[') && line.contains("] eq "));
    lines.map(entry).collect()
}

fn entry(line: &str) -> Entry {
    let parts: Vec<&str> = line.split('|').map(str::trim).collect();
    let place = match parts.as_slice() {
        [_, file, function] => Some(((*file).to_owned(), (*function).to_owned())),
        [_, reason] => {
            assert!(reason.strip_prefix("not implemented: ").is_some_and(|why| why.len() > 10), "{line}");
            None
        }
        _ => panic!("neither a place nor a reason: {line}"),
    };
    Entry { equation: parts[0].to_owned(), place }
}

#[test]
fn every_numbered_equation_of_the_sources_is_listed_once_and_in_order() {
    let listed: Vec<String> = index().into_iter().map(|entry| entry.equation).collect();
    let all = SOURCES.iter().flat_map(|(source, count)| (1..=*count).map(move |n| format!("{source} eq {n}")));
    assert_eq!(listed, all.collect::<Vec<_>>());
}

#[test]
fn every_equation_listed_with_a_place_is_named_in_a_comment_of_that_file_and_the_function_is_there() {
    for Entry { equation, place } in index() {
        let Some((file, function)) = place else { continue };
        let text = std::fs::read_to_string(root().join(&file)).unwrap_or_else(|error| panic!("{file}: {error}"));
        let is_there = ["fn", "struct"].iter().any(|kind| defines(&text, kind, &function));
        assert!(is_there, "{equation}: {file} has no {function}");
        let marked = text.lines().any(|line| line.split_once("//").is_some_and(|(_, said)| names(said, &equation)));
        assert!(marked, "{equation}: {file} is to name it in a comment");
    }
}

/// A definition of exactly this name.
fn defines(text: &str, kind: &str, name: &str) -> bool {
    let definition = format!("{kind} {name}");
    text.split(&definition).skip(1).any(|rest| rest.starts_with(['(', '<', ' ']))
}

/// The equation, and not the beginning of a higher number.
fn names(comment: &str, equation: &str) -> bool {
    comment.split(equation).skip(1).any(|rest| !rest.starts_with(|c: char| c.is_ascii_digit()))
}
