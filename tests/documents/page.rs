//! A page of Markdown and its fenced blocks.

use std::path::{Path, PathBuf};

/// The root of the repository.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// A Markdown file.
pub(crate) struct Page {
    /// Its path from the root of the repository.
    pub(crate) name: String,
    pub(crate) text: String,
}

/// A fenced block of a page.
#[derive(Debug)]
pub(crate) struct Block {
    /// Page and line, for a message.
    pub(crate) place: String,
    pub(crate) language: String,
    pub(crate) text: String,
    /// The name in a comment `<!-- file: NAME -->` before it.
    pub(crate) file: Option<String>,
    /// The kind in a comment `<!-- base: KIND -->` before it.
    pub(crate) base: Option<String>,
}

/// The README.
pub(crate) fn readme() -> Page {
    Page::read("README.md")
}

/// Every page of the book, in the order of their names.
pub(crate) fn book() -> Vec<Page> {
    let entries = std::fs::read_dir(root().join("docs")).expect("a folder");
    let mut names: Vec<String> = entries
        .map(|entry| entry.expect("an entry").file_name().into_string().expect("UTF-8"))
        .filter(|name| name.ends_with(".md"))
        .collect();
    names.sort();
    names.iter().map(|name| Page::read(&format!("docs/{name}"))).collect()
}

/// README and book.
pub(crate) fn all() -> Vec<Page> {
    std::iter::once(readme()).chain(book()).collect()
}

impl Page {
    /// Reads a file of the repository.
    pub(crate) fn read(name: &str) -> Self {
        let path = root().join(name);
        let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{name}: {error}"));
        Self { name: name.to_owned(), text }
    }

    /// Its fenced blocks. A fence that is not closed is a mistake in the page.
    pub(crate) fn blocks(&self) -> Vec<Block> {
        let lines: Vec<&str> = self.text.lines().collect();
        let mut blocks = Vec::new();
        let mut next = 0;
        while let Some(first) = lines.iter().skip(next).position(|line| line.starts_with("```")).map(|k| k + next) {
            let length = lines.iter().skip(first + 1).position(|line| *line == "```");
            let length = length.unwrap_or_else(|| panic!("{}:{}: an open fence", self.name, first + 1));
            let before = first.checked_sub(1).map_or("", |line| lines[line]);
            blocks.push(Block {
                place: format!("{}:{}", self.name, first + 1),
                language: lines[first].trim_start_matches('`').to_owned(),
                text: lines[first + 1..=first + length].iter().map(|line| format!("{line}\n")).collect(),
                file: comment(before, "file"),
                base: comment(before, "base"),
            });
            next = first + length + 2;
        }
        blocks
    }

    /// The text without fenced blocks and comments.
    pub(crate) fn prose(&self) -> String {
        let mut fenced = false;
        let mut prose = String::new();
        for line in self.text.lines() {
            let fence = line.starts_with("```");
            fenced ^= fence;
            if !(fence || fenced || line.starts_with("<!--")) {
                prose.push_str(line);
                prose.push('\n');
            }
        }
        prose
    }
}

/// The value of a comment `<!-- KEY: VALUE -->`.
fn comment(line: &str, key: &str) -> Option<String> {
    let inside = line.strip_prefix("<!--")?.strip_suffix("-->")?.trim();
    Some(inside.strip_prefix(key)?.strip_prefix(':')?.trim().to_owned())
}
