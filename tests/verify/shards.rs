//! Shards and what they merge to.

use serde_json::{Value, json};

use crate::command::{folder, merge, parsed, read, refused, run, same_results, verify};
use crate::made::{guarantee, hypothesis, identity, smallest, trial, write_journal, write_shards};
use crate::support::{WAY_POINTS, from_files};

#[test]
fn shards_that_really_ran_merge_to_the_bytes_of_one_piece() {
    let folder = folder();
    verify(folder.path(), "whole", &[]);
    let shards: Vec<String> = (1..=5).map(|i| format!("part-{i}")).collect();
    for (i, out) in shards.iter().enumerate() {
        let shard = format!("{}/5", i + 1);
        let printed = verify(folder.path(), out, &["--shard", &shard]);
        assert!(printed.contains("slideway merge"), "{printed}");
        assert!(!folder.path().join(out).join("junit.xml").exists(), "a part is no campaign");
    }
    let (status, printed) = merge(folder.path(), &shards, "merged");
    assert!(status == 0 || status == 1, "{printed}");
    same_results(folder.path(), "whole", "merged");
}

#[test]
fn shards_with_violations_merge_to_the_bytes_of_one_piece_for_any_division() {
    let folder = folder();
    let mut whole = identity(folder.path(), 23);
    whole["statement"]["guarantees"] = json!([guarantee("depth", 1.0, Some(0.5)), guarantee("never", 1.0, None)]);
    let entries: Vec<Value> = (0..23).map(trial).chain([smallest(2)]).collect();
    write_journal(folder.path(), "one", &whole, &entries);
    assert_eq!(merge(folder.path(), &["one".to_owned()], "merged").0, 1);
    for of in [2, 5, 30] {
        let shards = write_shards(folder.path(), &whole, of);
        let out = format!("merged-{of}");
        assert_eq!(merge(folder.path(), &shards, &out).0, 1);
        same_results(folder.path(), "merged", &out);
        for figure in ["trials.svg", "trials.png"] {
            let bytes = |out: &str| std::fs::read(folder.path().join(out).join("figures").join(figure)).expect(figure);
            assert_eq!(bytes("merged"), bytes(&out));
        }
        // A journal may be given as a file too, and the order does not matter.
        let files: Vec<String> = shards.iter().rev().map(|shard| format!("{shard}/trials.jsonl")).collect();
        assert_eq!(merge(folder.path(), &files, "again").0, 1);
        same_results(folder.path(), "merged", "again");
    }
}

#[test]
fn a_statement_with_a_number_that_is_none_is_the_same_in_all_shards() {
    let folder = folder();
    let mut whole = identity(folder.path(), 4);
    whole["statement"]["hypotheses"] = json!([hypothesis(json!("NaN"), None), hypothesis(json!("inf"), None)]);
    let shards = write_shards(folder.path(), &whole, 2);
    let (status, printed) = merge(folder.path(), &shards, "out");
    assert_eq!(status, 1, "{printed}");
    assert!(parsed(&read(folder.path(), "out/verify.json"))["hypotheses"][0]["value"].is_null());
}

#[test]
fn a_failing_case_has_the_files_it_names_beside_it_after_a_merge_too() {
    let folder = folder();
    let (scenario, points) = (from_files("model = \"planar-2r\"", "data/points.csv"), WAY_POINTS);
    std::fs::create_dir_all(folder.path().join("mine/data")).expect("folder");
    std::fs::write(folder.path().join("mine/arm.toml"), &scenario).expect("written");
    std::fs::write(folder.path().join("mine/data/points.csv"), points).expect("written");
    let arguments = ["verify", "mine/arm.toml", "--trials", "3", "--out", "out"];
    let (status, printed) = run(folder.path(), &arguments);
    assert!(status == 0 || status == 1, "{printed}");
    let identity = parsed(read(folder.path(), "out/trials.jsonl").lines().next().expect("a line"));
    let mut case = smallest(2);
    case["scenario"] = json!(scenario);
    write_journal(folder.path(), "out", &identity, &[trial(0), trial(1), trial(2), case]);
    assert_eq!(run(folder.path(), &arguments).0, 1);
    assert_eq!(merge(folder.path(), &["out".to_owned()], "merged").0, 1);
    for out in ["out", "merged"] {
        assert_eq!(read(folder.path(), &format!("{out}/data/points.csv")), points);
        let compared = run(folder.path(), &["compare", &format!("{out}/failing-depth.toml"), "--out", "compared"]);
        assert_ne!(compared.0, 2, "{}", compared.1);
    }
    // The trials depend on the file: a campaign does not go on with another one.
    std::fs::write(folder.path().join("mine/data/points.csv"), points.replace("0.7", "0.8")).expect("written");
    refused(folder.path(), &arguments, "text of its files was `0.2,0.7` in line 3, now it is `0.2,0.8` in line 3");
}
