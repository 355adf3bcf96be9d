//! The arrows between crates and between files: which way they run, and which must never be.

mod made_up;
mod mentions;
mod rules;
mod sources;

use sources::{Package, packages};
use std::path::Path;

type Rule = fn(&[Package]) -> Vec<String>;

/// Fails on each violation of a rule. In the folders of `open` it is broken still: they are told when their last violation is mended.
fn holds(rule: Rule, open: &[&str]) {
    let violations = rule(&packages(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")));
    let is_in = |folder: &&str| violations.iter().any(|line| line.starts_with(*folder));
    let mended = open.iter().filter(|folder| !is_in(folder)).map(|folder| format!("{folder} is mended: take it off"));
    let others = violations.iter().filter(|line| !open.iter().any(|folder| line.starts_with(folder))).cloned();
    let broken: Vec<String> = others.chain(mended).collect();
    assert!(broken.is_empty(), "\n{}\n", broken.join("\n"));
}

#[test]
fn libraries_read_no_file_and_know_no_terminal() {
    holds(rules::values_only, &[]);
}

#[test]
fn optima_know_no_loop() {
    holds(rules::optima_know_no_loop, &[]);
}

#[test]
fn comparison_and_verification_do_not_know_the_command() {
    holds(rules::no_command, &[]);
}

#[test]
fn what_shows_results_knows_no_verb() {
    holds(rules::say_knows_no_verb, &[]);
}

#[test]
fn errors_do_not_import_what_raises_them() {
    holds(rules::errors_do_not_import_their_raisers, &["crates/conditioner/", "crates/motion/"]);
}

#[test]
fn the_reader_alone_asks_which_kind_a_scenario_is() {
    holds(rules::kinds_are_the_readers, &[]);
}

#[test]
fn no_files_of_a_crate_go_in_a_circle() {
    let crates = ["crates/conditioner/", "crates/motion/", "crates/study/", "crates/verify/"];
    holds(rules::circles, &[&crates[..], &["baselines/", "figures/"]].concat());
}
