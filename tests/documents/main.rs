//! README and book held against the command: what they tell a reader to type runs, what they tell him to write parses, and what they
//! link to is there.
//!
//! Conventions of the pages:
//! - the commands of a page's `sh` blocks run in their order in one empty folder; ` # exit status 1` behind a command says that it ends so;
//! - `<!-- file: NAME -->` before a block puts its text into that folder first;
//! - a `toml` block without a name holds whole tables; they replace those of the template, of the other kind after
//!   `<!-- base: conditioning -->`;
//! - what stands between `<!-- begin generated: NAME -->` and `<!-- end generated -->` is what the command prints;
//!   `SLIDEWAY_WRITE_DOCS=1 cargo test --release -p slideway --test documents` writes it anew.

mod commands;
mod generated;
mod library;
mod links;
mod page;
mod scenarios;
#[path = "../support/mod.rs"]
mod support;

use page::{Page, book, readme};

#[test]
fn the_readme_is_short_and_every_page_is_read_in_ten_minutes() {
    assert!(readme().text.lines().count() <= 200);
    for page in book() {
        // 200 words a minute; blocks are looked at, not read.
        let words = page.prose().split_whitespace().count();
        assert!(words <= 2000, "{} has {words} words", page.name);
    }
}

#[test]
fn every_page_of_the_book_is_in_its_summary_once() {
    let summary = Page::read("docs/SUMMARY.md");
    for page in book().iter().filter(|page| page.name != summary.name) {
        let name = page.name.trim_start_matches("docs/");
        assert_eq!(summary.text.matches(&format!("({name})")).count(), 1, "{name}");
    }
}
