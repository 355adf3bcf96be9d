//! The commands of the pages.

use crate::page::{Block, Page, all, root};
use crate::support::slideway;
use std::path::{Path, PathBuf};

/// Commands that are held against the command line without being run, and why.
const ONLY_PARSED: [(&str, &str); 5] = [
    ("slideway verify my.toml", "a hundred trials of the reader's own scenario"),
    ("slideway compare out/verify-my/failing-chattering.toml", "a file that a violation leaves"),
    ("slideway verify my.toml --level smoke --shard 1/2 --out shard-1", "half of a thousand trials"),
    ("slideway verify my.toml --level smoke --shard 2/2 --out shard-2", "half of a thousand trials"),
    ("slideway merge shard-1 shard-2 --out verified", "the shards before"),
];

/// Blanks of a workflow that the shell and the CI fill in, by something of their kind.
const FILLED: [(&str, &str); 2] = [("${{ matrix.shard }}", "1"), ("\"$LEVEL\"", "nightly")];

/// A line of a page that calls the command.
struct Call {
    place: String,
    line: String,
    arguments: Vec<String>,
    status: i32,
}

#[test]
fn every_command_of_the_pages_runs_and_ends_as_the_page_says() {
    let pages = all();
    let failures: Vec<String> = std::thread::scope(|scope| {
        let runs: Vec<_> = pages.iter().map(|page| scope.spawn(|| run(page))).collect();
        runs.into_iter().flat_map(|run| run.join().expect("a page that can be read")).collect()
    });
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn every_command_that_is_only_parsed_is_one_that_the_command_line_takes() {
    let folder = tempfile::tempdir().expect("folder");
    let pages = all();
    let calls: Vec<Call> = pages.iter().flat_map(|page| calls(page).into_iter().chain(workflow(page))).collect();
    assert!(calls.len() > 40, "{} commands", calls.len());
    for call in &calls {
        // Whatever stands before it is parsed before help is printed.
        let arguments: Vec<&str> = call.arguments.iter().map(String::as_str).chain(["--help"]).collect();
        let output = slideway(folder.path(), &arguments);
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{}: `{}`\n{said}", call.place, call.line);
    }
    for (line, reason) in ONLY_PARSED {
        assert!(calls.iter().any(|call| call.line == line), "no page has `{line}` ({reason})");
    }
}

#[test]
fn what_else_a_page_tells_a_reader_to_type_is_known_and_its_scripts_exist() {
    for page in all() {
        for (place, line) in shell_lines(&page) {
            let words = split(without_comment(&line));
            let known = match words.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
                ["cargo", "run", "--release", "-p", package, "--example", name, ..] => example(package, name).exists(),
                ["slideway", ..] | ["cargo", "run" | "install" | "doc" | "test", ..] => true,
                // `crates/capi/check` runs these.
                ["cmake", "-S", folder, ..] => root().join(folder).join("CMakeLists.txt").exists(),
                ["cmake", "--build" | "--install", ..] => true,
                ["sh", script, ..] | [script, ..] => script.starts_with(".ci/") && root().join(script).exists(),
                [] => true,
            };
            assert!(known, "{place}: `{line}`");
        }
    }
}

/// The file of an example.
fn example(package: &str, name: &str) -> PathBuf {
    let room = package.trim_start_matches("slideway-");
    let folder = if room == "baselines" { room.to_owned() } else { format!("crates/{room}") };
    root().join(folder).join("examples").join(format!("{name}.rs"))
}

#[test]
fn the_examples_of_the_library_page_are_short_and_run_in_ci() {
    let ci = std::fs::read_to_string(root().join(".ci/run")).expect("reads");
    let page = Page::read("docs/library.md");
    let lines = shell_lines(&page).into_iter().map(|(_, line)| without_comment(&line).to_owned());
    let examples: Vec<String> = lines.filter(|line| line.contains("--example")).collect();
    assert_eq!(examples.len(), 5, "{examples:?}");
    for line in examples {
        let words = split(&line);
        let text = std::fs::read_to_string(example(&words[4], &words[6])).expect("an example");
        assert!(text.lines().count() < 60, "{line}: {} lines", text.lines().count());
        assert!(ci.contains(&format!("example {} {}\n", words[4], words[6])), "{line}: not in .ci/run");
    }
}

/// Runs the commands of a page in one folder; what did not end as it should.
fn run(page: &Page) -> Vec<String> {
    let folder = tempfile::tempdir().expect("folder");
    for block in page.blocks() {
        if let Some(name) = &block.file {
            std::fs::write(folder.path().join(name), &block.text).expect("writes");
        }
    }
    let to_run = calls(page).into_iter().filter(|call| ONLY_PARSED.iter().all(|(line, _)| *line != call.line));
    to_run.filter_map(|call| failure(folder.path(), &call)).collect()
}

fn failure(folder: &Path, call: &Call) -> Option<String> {
    let output = slideway(folder, &call.arguments.iter().map(String::as_str).collect::<Vec<_>>());
    let said = String::from_utf8_lossy(&output.stderr);
    let (place, line, status) = (&call.place, &call.line, call.status);
    (output.status.code() != Some(status))
        .then(|| format!("{place}: `{line}` ended with {:?} in place of {status}\n{said}", output.status.code()))
}

/// The calls in the `sh` blocks of a page.
fn calls(page: &Page) -> Vec<Call> {
    shell_lines(page).into_iter().filter_map(|(place, line)| call(place, &line)).collect()
}

/// The calls in the workflows of a page.
fn workflow(page: &Page) -> Vec<Call> {
    let blocks = page.blocks().into_iter().filter(|block| block.language == "yaml");
    let steps = blocks.flat_map(|block| lines(&block));
    let steps = steps.filter_map(|(place, line)| {
        let line = line.trim().trim_start_matches("- ").strip_prefix("run: ")?.to_owned();
        Some((place, FILLED.iter().fold(line, |line, (blank, filling)| line.replace(blank, filling))))
    });
    steps.filter_map(|(place, line)| call(place, &line)).collect()
}

fn call(place: String, line: &str) -> Option<Call> {
    let status = if line.contains("# exit status 1") { 1 } else { 0 };
    let line = without_comment(line).replacen("cargo run --release --", "slideway", 1);
    let mut words = split(&line);
    if words.first()? != "slideway" {
        return None;
    }
    words.remove(0);
    Some(Call { place, line, arguments: words, status })
}

fn shell_lines(page: &Page) -> Vec<(String, String)> {
    page.blocks().iter().filter(|block| block.language == "sh").flat_map(lines).collect()
}

fn lines(block: &Block) -> Vec<(String, String)> {
    block.text.lines().map(|line| (block.place.clone(), line.to_owned())).collect()
}

fn without_comment(line: &str) -> &str {
    line.split(" #").next().unwrap_or_default().trim()
}

/// Words as a shell splits them, with double quotes.
fn split(line: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    for (k, part) in line.split('"').enumerate() {
        if k % 2 == 1 {
            words.push(part.to_owned());
        } else {
            words.extend(part.split_whitespace().map(str::to_owned));
        }
    }
    words
}
