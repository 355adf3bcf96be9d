//! The generated parts of the pages, held against the output of the command.

use crate::page::{Page, all, root};
use crate::support::{slideway, stdout};
use std::fmt::Write as _;

const BEGIN: &str = "<!-- begin generated: ";
const END: &str = "<!-- end generated -->";

#[test]
fn generated_parts_are_current() {
    let mut count = 0;
    for page in all() {
        let current = regenerated(&page, &mut count);
        if std::env::var_os("SLIDEWAY_WRITE_DOCS").is_some() {
            std::fs::write(root().join(&page.name), current).expect("writes");
        } else {
            assert!(page.text == current, "{} is stale: run the tests with SLIDEWAY_WRITE_DOCS=1", page.name);
        }
    }
    assert_eq!(count, 3, "generated parts");
}

/// The page with its generated parts made anew.
fn regenerated(page: &Page, count: &mut usize) -> String {
    let mut parts = page.text.split(BEGIN);
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (name, rest) = part.split_once(" -->").expect("the comment ends");
        let (_, after) = rest.split_once(END).unwrap_or_else(|| panic!("{}: {name} does not end", page.name));
        write!(text, "{BEGIN}{name} -->\n{}{END}{after}", made(name)).expect("a string");
        *count += 1;
    }
    text
}

fn made(name: &str) -> String {
    match name {
        "template speed" => template("speed"),
        "template conditioning" => template("conditioning"),
        "command" => commands(),
        _ => panic!("no generated part is called {name:?}"),
    }
}

/// The template of a kind, as `init` writes it.
fn template(kind: &str) -> String {
    let folder = tempfile::tempdir().expect("folder");
    assert!(slideway(folder.path(), &["init", "my.toml", "--kind", kind]).status.success());
    let text = std::fs::read_to_string(folder.path().join("my.toml")).expect("reads");
    format!("<!-- base: {kind} -->\n```toml\n{text}```\n")
}

/// The help of every subcommand, in the order in which the command lists them.
fn commands() -> String {
    let help = printed(&["--help"]);
    let (_, list) = help.split_once("Commands:\n").expect("a list of commands");
    let names = list.lines().take_while(|line| !line.is_empty()).filter_map(|line| line.split_whitespace().next());
    let mut text = String::new();
    for name in names.filter(|name| *name != "help") {
        write!(text, "## {name}\n\n```text\n{}```\n\n", printed(&[name, "--help"])).expect("a string");
    }
    text
}

/// The output of the command, without blanks at the ends of lines.
fn printed(arguments: &[&str]) -> String {
    let folder = tempfile::tempdir().expect("folder");
    let output = slideway(folder.path(), arguments);
    assert!(output.status.success(), "{arguments:?}");
    stdout(&output).lines().map(|line| format!("{}\n", line.trim_end())).collect()
}
