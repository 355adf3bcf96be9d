//! Refusals, before anything runs or is overwritten.

use serde_json::{Value, json};

use crate::command::{SCENARIO, folder, parsed, read, refused, run, verify};
use crate::made::{built_in, identity, trial, write_journal, write_shards};

#[test]
fn merging_what_does_not_belong_together_is_refused() {
    let folder = folder();
    let path = folder.path();
    let whole = identity(path, 23);
    let shards = write_shards(path, &whole, 3);
    for (key, value, says) in [
        ("seed", json!(7), "the seed is 1 there and 7 here"),
        ("trials", json!(20), "the number of trials is 23 there and 20 here"),
        ("method", json!("ideal"), "the --method is not given there and ideal here"),
        ("version", json!("0.0.1"), "the version of the program"),
        ("text", json!("another"), "the scenario's text"),
        ("statement", json!({ "method": "ideal", "hypotheses": [], "guarantees": [] }), "the statement"),
    ] {
        let mut other = whole.clone();
        other[key] = value;
        other["shard"] = json!("3/3");
        write_journal(path, "other", &other, &[]);
        refused(path, &["merge", &shards[0], &shards[1], "other", "--out", "out"], says);
    }
    refused(path, &["merge", &shards[0], &shards[2], "--out", "out"], "missing: 2/3");
    refused(path, &["merge", &shards[0], &shards[1], &shards[2], &shards[1], "--out", "out"], "both hold trial 1");
    let halves = write_shards(path, &whole, 2);
    refused(path, &["merge", &shards[0], &halves[1], "--out", "out"], "both hold trial 3");
    // Shards that did not run to their ends: without the last trial, and without the smallest case.
    let lines: Vec<Value> = read(path, &format!("{}/trials.jsonl", shards[2])).lines().map(parsed).collect();
    write_journal(path, &shards[2], &lines[0], &lines[1..lines.len() - 1]);
    refused(path, &["merge", &shards[0], &shards[1], &shards[2], "--out", "out"], "holds no smallest case of `depth`");
    write_journal(path, &shards[2], &lines[0], &lines[2..]);
    refused(path, &["merge", &shards[0], &shards[1], &shards[2], "--out", "out"], "1 of 23 trials are missing");
    assert!(!path.join("out").exists(), "nothing was written");
}

#[test]
fn merging_files_that_no_campaign_wrote_is_refused() {
    let folder = folder();
    let path = folder.path();
    let whole = identity(path, 3);
    std::fs::write(path.join("notes.txt"), "my notes\n").expect("written");
    std::fs::write(path.join("empty.jsonl"), "").expect("written");
    std::fs::create_dir(path.join("empty")).expect("folder");
    write_journal(path, "rows", &whole, &[json!({ "run": 0 })]);
    write_journal(path, "beyond", &whole, &[trial(3)]);
    let mut second = whole.clone();
    second["shard"] = json!("2/2");
    write_journal(path, "astray", &second, &[trial(0)]);
    let mut huge = whole.clone();
    huge["trials"] = json!(u64::MAX);
    write_journal(path, "huge", &huge, &[]);
    let mut broken = whole;
    broken["shard"] = json!("3/2");
    write_journal(path, "broken", &broken, &[]);
    for (given, says) in [
        ("notes.txt", "not written by a campaign"),
        ("empty.jsonl", "not written by a campaign"),
        ("empty", "cannot read"),
        ("nowhere", "cannot read"),
        ("rows", "line 2: not written by a campaign"),
        ("beyond", "there is no trial 3"),
        ("astray", "there is no trial 0 in shard 2/2"),
        ("huge", "are possible"),
        ("broken", "I/N"),
    ] {
        refused(path, &["merge", given, "--out", "out"], says);
    }
    refused(path, &["merge", "--out", "out"], "SHARD");
    refused(path, &["merge", "rows"], "--out");
}

#[test]
fn wrong_input_is_pointed_out_before_anything_runs() {
    let folder = folder();
    for (arguments, says) in [
        (vec!["--shard", "0/5"], "I from 1 to N"),
        (vec!["--shard", "6/5"], "I from 1 to N"),
        (vec!["--shard", "a/b"], "I from 1 to N"),
        (vec!["--shard", "3"], "I from 1 to N"),
        (vec!["--trials", "0"], "--trials"),
        (vec!["--trials", "99999999999"], "--trials"),
        (vec!["--jobs", "0"], "--jobs"),
        (vec!["--level", "thorough"], "nightly"),
        (vec!["--seed", "x"], "--seed"),
        (vec!["--method", "fastest"], "there is no method `fastest`"),
        (vec!["--out", "/dev/null/x"], "cannot write"),
    ] {
        let all: Vec<&str> = ["verify", SCENARIO].iter().chain(&arguments).copied().collect();
        refused(folder.path(), &all, says);
    }
    refused(folder.path(), &["verify", "planar-lin"], "planar-line");
    refused(folder.path(), &["verify", "nowhere.toml"], "slideway list");
    assert_eq!(std::fs::read_dir(folder.path()).expect("folder").count(), 0, "nothing was written");
}

#[test]
fn another_campaign_in_the_same_folder_is_refused_with_what_differs() {
    let folder = folder();
    let text = built_in();
    let file = folder.path().join("own.toml");
    std::fs::write(&file, &text).expect("written");
    let given = |more: &[&'static str]| -> Vec<&'static str> {
        ["verify", "own.toml", "--out", "here"].iter().chain(more).copied().collect()
    };
    assert!(run(folder.path(), &given(&["--trials", "2"])).0 != 2);
    for (more, says) in [
        (["--trials", "3", "--seed", "1"], "number of trials was 2, now it is 3"),
        (["--trials", "2", "--seed", "5"], "seed was 1, now it is 5"),
        (["--trials", "2", "--shard", "1/2"], "shard was 1/1, now it is 1/2"),
    ] {
        refused(folder.path(), &given(&more), says);
    }
    std::fs::write(&file, format!("# changed\n{text}")).expect("written");
    refused(folder.path(), &given(&["--trials", "2"]), "scenario's text was `");
}

#[test]
fn a_file_that_no_campaign_wrote_is_neither_used_nor_changed() {
    let folder = folder();
    verify(folder.path(), "out", &[]);
    let journal = read(folder.path(), "out/trials.jsonl");
    for foreign in ["my notes".to_owned(), "{\"run\":0}\n".to_owned(), format!("{journal}what is this\n")] {
        std::fs::write(folder.path().join("out/trials.jsonl"), &foreign).expect("written");
        refused(folder.path(), &["verify", SCENARIO, "--trials", "12", "--out", "out"], "not written by a campaign");
        assert_eq!(read(folder.path(), "out/trials.jsonl"), foreign);
    }
}
