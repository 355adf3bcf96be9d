//! The scenarios of the pages, whole ones and tables for a template.

use crate::page::{Block, Page, all};
use crate::support::slideway;
use std::path::Path;

#[test]
fn every_scenario_and_every_table_of_the_pages_runs() {
    let pages = all();
    let failures: Vec<String> = std::thread::scope(|scope| {
        let runs: Vec<_> = pages.iter().map(|page| scope.spawn(|| run(page))).collect();
        runs.into_iter().flat_map(|run| run.join().expect("a page that can be read")).collect()
    });
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// Runs one method on each scenario of a page, which reads all of it; what was refused or did not end well.
fn run(page: &Page) -> Vec<String> {
    let folder = tempfile::tempdir().expect("folder");
    let blocks = page.blocks();
    for block in &blocks {
        if let Some(name) = &block.file {
            std::fs::write(folder.path().join(name), &block.text).expect("writes");
        }
    }
    let scenarios = blocks.iter().filter(|block| block.language == "toml");
    scenarios.enumerate().filter_map(|(k, block)| failure(folder.path(), k, block)).collect()
}

fn failure(folder: &Path, number: usize, block: &Block) -> Option<String> {
    let text = match &block.file {
        Some(_) => block.text.clone(),
        None => in_template(folder, number, block),
    };
    let (file, out) = (format!("scenario-{number}.toml"), format!("out-{number}"));
    std::fs::write(folder.join(&file), text).expect("writes");
    let output = slideway(folder, &["sweep", &file, "--jobs", "1", "--out", &out]);
    let said = String::from_utf8_lossy(&output.stderr);
    (!output.status.success()).then(|| format!("{}: {:?}\n{said}", block.place, output.status.code()))
}

/// The template with its tables replaced by those of a block.
fn in_template(folder: &Path, number: usize, block: &Block) -> String {
    let kind = block.base.as_deref().unwrap_or("speed");
    let file = format!("template-{number}.toml");
    assert!(slideway(folder, &["init", &file, "--kind", kind]).status.success(), "{}: {kind}", block.place);
    let template = std::fs::read_to_string(folder.join(&file)).expect("reads");
    let table = |text: &str| text.parse::<toml::Table>().unwrap_or_else(|e| panic!("{}: {e}", block.place));
    let mut whole = table(&template);
    whole.extend(table(&block.text));
    toml::to_string(&whole).expect("a table")
}
