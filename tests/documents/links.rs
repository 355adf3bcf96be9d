//! The links of the pages and of the other documents.

use crate::page::{Page, all, root};
use std::path::{Component, Path, PathBuf};

/// Documents beside README and book.
const OTHERS: [&str; 5] = ["DESIGN.md", "NOTATION.md", "REFERENCES.md", "CONTRIBUTING.md", "SECURITY.md"];

#[test]
fn every_link_leads_to_a_file_and_a_heading_that_exist() {
    let mut count = 0;
    for page in all().into_iter().chain(OTHERS.map(Page::read)) {
        let folder = Path::new(&page.name).parent().unwrap_or(Path::new("")).to_owned();
        for target in links(&page.prose()) {
            count += 1;
            check(&page.name, &folder, &target);
        }
    }
    assert!(count > 60, "{count} links");
}

fn check(page: &str, folder: &Path, target: &str) {
    if target.contains("://") {
        return;
    }
    let (file, heading) = target.split_once('#').unwrap_or((target, ""));
    let path = if file.is_empty() { PathBuf::from(page) } else { folder.join(file) };
    assert!(root().join(&path).exists(), "{page}: no {target}");
    // A page of the book is read without the repository, too.
    let leaves = path.components().any(|part| part == Component::ParentDir);
    assert!(!(page.starts_with("docs/") && leaves), "{page}: {target} leads out of the book");
    if !heading.is_empty() {
        let text = Page::read(path.to_str().expect("UTF-8")).prose();
        let headings = text.lines().filter(|line| line.starts_with('#')).map(anchor);
        assert!(headings.into_iter().any(|known| known == heading), "{page}: no heading for {target}");
    }
}

/// The anchor that a heading gets: lower case, blanks as hyphens, no punctuation.
fn anchor(heading: &str) -> String {
    let text = heading.trim_start_matches('#').trim().to_lowercase();
    let kept = text.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.map(|c| if c == ' ' { '-' } else { c }).collect()
}

/// The targets of `[text](target)` and `![text](target)`, outside of code.
fn links(prose: &str) -> Vec<String> {
    let text: String = prose.split('`').step_by(2).collect();
    let targets = text.split("](").skip(1);
    targets.filter_map(|rest| rest.split(')').next()).map(str::to_owned).collect()
}
