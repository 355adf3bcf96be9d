//! Each rule on a small made-up workspace that breaks it, and on its like that does not.

use crate::rules;
use crate::sources::{Package, packages};
use std::fs;

/// A package: its name, lines of its manifest and its files under `src`.
type MadeUp<'a> = (&'a str, &'a str, &'a [(&'a str, &'a str)]);

/// A workspace of packages.
fn workspace(made: &[MadeUp<'_>]) -> Vec<Package> {
    let folder = tempfile::tempdir().expect("a folder");
    let members: Vec<String> = made.iter().map(|(name, _, _)| format!("'{name}'")).collect();
    let root = format!("[workspace]\nmembers = [{}]", members.join(", "));
    fs::write(folder.path().join("Cargo.toml"), root).expect("written");
    for (name, dependencies, files) in made {
        let package = folder.path().join(name);
        fs::create_dir_all(&package).expect("made");
        let manifest = format!("[package]\nname = '{name}'\n[dependencies]\n{dependencies}");
        fs::write(package.join("Cargo.toml"), manifest).expect("written");
        for (file, text) in *files {
            let path = package.join("src").join(file);
            fs::create_dir_all(path.parent().expect("a folder")).expect("made");
            fs::write(path, text).expect("written");
        }
    }
    packages(folder.path())
}

fn one(files: &[(&str, &str)]) -> Vec<Package> {
    workspace(&[("slideway", "", files)])
}

#[test]
fn a_library_that_names_a_reader_is_told_in_its_manifest_and_in_each_file() {
    let broken = workspace(&[
        (
            "slideway-lab",
            "toml = '1'\nslideway-scenario = '1'",
            &[
                ("lib.rs", "mod inner;"),
                ("inner.rs", "use slideway_scenario::{a::{Scenario, self}, b};\nfn f() { g(toml::from_str(1)) }"),
            ],
        ),
        ("slideway-scenario", "slideway-lab = '1'\ntoml = '1'", &[("lib.rs", "use toml::Table; use slideway_lab::x;")]),
    ]);
    let reader = "slideway-scenario/Cargo.toml";
    assert_eq!(
        rules::values_only(&broken),
        [
            format!("slideway-lab/Cargo.toml -> {reader}"),
            "slideway-lab/Cargo.toml -> toml".to_owned(),
            format!("slideway-lab/src/inner.rs -> {reader}"),
            "slideway-lab/src/inner.rs -> toml".to_owned(),
        ]
    );
}

#[test]
fn a_comparison_that_names_the_command_is_told() {
    let broken = workspace(&[
        ("slideway-compare", "slideway = '1'", &[("lib.rs", "pub use slideway::say;")]),
        ("slideway", "slideway-compare = '1'", &[("main.rs", "use slideway_compare::x;")]),
    ]);
    let both =
        ["slideway-compare/Cargo.toml -> slideway/Cargo.toml", "slideway-compare/src/lib.rs -> slideway/Cargo.toml"];
    assert_eq!(rules::no_command(&broken), both);
}

#[test]
fn an_optimum_that_names_a_loop_is_told() {
    let broken = workspace(&[
        ("slideway-baselines", "slideway-lab = '1'", &[("lib.rs", "use slideway_lab::Trace;")]),
        ("slideway-lab", "", &[("lib.rs", "pub struct Trace;")]),
    ]);
    let both = [
        "slideway-baselines/Cargo.toml -> slideway-lab/Cargo.toml",
        "slideway-baselines/src/lib.rs -> slideway-lab/Cargo.toml",
    ];
    assert_eq!(rules::optima_know_no_loop(&broken), both);
}

#[test]
fn what_shows_results_and_names_a_verb_is_told() {
    let broken = one(&[
        ("main.rs", "mod say; mod keep; mod sweep;"),
        ("say/mod.rs", "mod table;"),
        ("say/table.rs", "use crate::keep::Files; fn f() { let text = format!(\"{}\", crate::sweep::row()); }"),
        ("keep.rs", "pub struct Files;"),
        ("sweep/mod.rs", "pub fn row() {}"),
    ]);
    assert_eq!(rules::say_knows_no_verb(&broken), ["slideway/src/say/table.rs -> slideway/src/sweep/mod.rs"]);
}

#[test]
fn a_file_of_errors_that_names_what_raises_them_is_told() {
    let broken = one(&[
        ("main.rs", "mod error; mod run; mod limits;"),
        ("error.rs", "use crate::limits::Limit; pub enum Error { Most([u8; crate::run::MOST]), Limit(Limit) }"),
        ("run.rs", "use super::error::Error; pub const MOST: usize = 1; fn f() -> Result<(), Error> { Ok(()) }"),
        ("limits.rs", "pub struct Limit;"),
    ]);
    assert_eq!(rules::errors_do_not_import_their_raisers(&broken), ["slideway/src/error.rs -> slideway/src/run.rs"]);
}

#[test]
fn a_second_place_that_asks_the_kind_of_a_scenario_is_told() {
    let reader = ("slideway-scenario", "", &[("lib.rs", "pub fn scenario_kind() {}")] as &[_]);
    let broken = workspace(&[
        reader,
        (
            "slideway",
            "slideway-scenario = '1'",
            &[("main.rs", "fn main() { match slideway_scenario::scenario_kind() { _ => {} } }")],
        ),
    ]);
    let asks = ["slideway/src/main.rs asks the kind of slideway-scenario/Cargo.toml"];
    assert_eq!(rules::kinds_are_the_readers(&broken), asks);
}

#[test]
fn every_arrow_of_a_circle_is_told() {
    let broken = one(&[
        ("main.rs", "mod a; mod b; mod c; mod d;"),
        ("a.rs", "use crate::b::{self, inner::B};\nuse crate::d::D;"),
        ("b/mod.rs", "pub mod inner;"),
        ("b/inner.rs", "pub struct B; impl B { fn f(self) -> super::super::c::C { todo!() } }"),
        ("c.rs", "pub struct C; fn g() { vec![crate::a::h()]; }"),
        ("d.rs", "pub struct D;"),
    ]);
    assert_eq!(
        rules::circles(&broken),
        [
            "slideway/src/a.rs -> slideway/src/b/inner.rs",
            "slideway/src/b/inner.rs -> slideway/src/c.rs",
            "slideway/src/c.rs -> slideway/src/a.rs",
        ]
    );
}

#[test]
fn a_parent_that_uses_its_child_and_is_used_by_it_goes_in_a_circle() {
    let files = |line: &'static str| {
        one(&[
            ("main.rs", "mod a;"),
            ("a/mod.rs", line),
            ("a/part.rs", "use super::A; pub struct Part; impl A { pub fn f(&self) {} }"),
        ])
    };
    for line in ["mod part; use part::Part; pub struct A;", "mod part; pub struct A { part: part::Part }"] {
        assert_eq!(rules::circles(&files(line)).len(), 2, "{line}");
    }
}

#[test]
fn an_impl_in_a_child_a_name_passed_on_and_a_test_make_no_circle() {
    for parent in [
        "mod part; pub struct A;",
        "mod part; pub use part::Part; pub struct A;",
        "mod part; pub struct A; #[cfg(test)] mod tests { use super::part::Part; }",
        "mod part; pub struct A; fn f(part: u8) -> u8 { part }",
    ] {
        let fine = one(&[
            ("main.rs", "mod a; mod user;"),
            ("a/mod.rs", parent),
            ("a/part.rs", "use super::A; pub struct Part; impl A { pub fn f(&self) {} }"),
            ("user.rs", "use crate::a::Part;"),
        ]);
        assert!(rules::circles(&fine).is_empty(), "{parent}: {:?}", rules::circles(&fine));
    }
}

#[test]
fn a_name_is_of_the_file_that_defines_it_whichever_passes_it_on() {
    let fine = workspace(&[(
        "slideway-lab",
        "",
        &[
            ("lib.rs", "mod error; mod run; pub use error::LabError; pub use run::Run;"),
            ("error.rs", "pub struct LabError;"),
            ("run.rs", "use crate::LabError; pub struct Run(Result<(), LabError>);"),
        ],
    )]);
    assert!(rules::circles(&fine).is_empty());
}
