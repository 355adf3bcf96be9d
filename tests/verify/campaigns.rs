//! Campaigns: jobs, interruptions, and how many trials.

use serde_json::{Value, json};
use std::collections::BTreeSet;

use crate::command::{folder, parsed, read, refused, run, same_results, verify};
use crate::made::{built_in, write_journal};

#[test]
fn results_are_the_same_bytes_for_any_number_of_jobs() {
    let folder = folder();
    for (out, jobs) in [("one", "1"), ("two", "2"), ("five", "5")] {
        verify(folder.path(), out, &["--jobs", jobs]);
    }
    let rows = |out: &str| -> BTreeSet<String> {
        read(folder.path(), &format!("{out}/trials.jsonl")).lines().map(str::to_owned).collect()
    };
    assert!(rows("one").len() >= 13, "an identity and twelve trials");
    for other in ["two", "five"] {
        assert_eq!(rows("one"), rows(other));
        same_results(folder.path(), "one", other);
    }
}

#[test]
fn a_campaign_cut_short_anywhere_continues_to_the_same_results() {
    let folder = folder();
    verify(folder.path(), "whole", &[]);
    let journal = read(folder.path(), "whole/trials.jsonl");
    let header = journal.find('\n').expect("a header") + 1;
    let last = journal[..journal.len() - 1].rfind('\n').expect("rows") + 1;
    for length in [0, header / 2, header, header + 20, last, journal.len() - 1] {
        std::fs::create_dir_all(folder.path().join("cut")).expect("folder");
        std::fs::write(folder.path().join("cut/trials.jsonl"), &journal.as_bytes()[..length]).expect("cut");
        verify(folder.path(), "cut", &[]);
        same_results(folder.path(), "whole", "cut");
        let lines: BTreeSet<String> = read(folder.path(), "cut/trials.jsonl").lines().map(str::to_owned).collect();
        assert_eq!(lines, journal.lines().map(str::to_owned).collect(), "cut to {length} bytes");
    }
}

#[test]
fn finished_trials_are_never_made_again() {
    let folder = folder();
    verify(folder.path(), "out", &[]);
    let journal = read(folder.path(), "out/trials.jsonl");
    // A mark that no trial gives: if it is still there afterwards, the trial was taken from the journal.
    let marked: Vec<Value> = journal
        .lines()
        .map(parsed)
        .filter(|line| line["number"] != 4)
        .map(|mut line| {
            if line["number"] == 2 {
                line["outside"] = json!(["a-mark"]);
            }
            line
        })
        .collect();
    write_journal(folder.path(), "out", &marked[0], &marked[1..]);
    verify(folder.path(), "out", &[]);
    assert_eq!(parsed(&read(folder.path(), "out/verify.json"))["trials_outside"]["a-mark"], 1);
    let again: Vec<Value> = read(folder.path(), "out/trials.jsonl").lines().map(parsed).collect();
    assert_eq!(again.iter().filter(|line| line["number"] == 4).count(), 1);
}

#[test]
fn trials_and_seed_are_the_commands_else_the_scenarios_else_the_quick_levels() {
    let folder = folder();
    let own = format!("{}\n[verify]\ntrials = 7\nseed = 3\n", built_in());
    std::fs::write(folder.path().join("own.toml"), own).expect("written");
    std::fs::write(folder.path().join("plain.toml"), built_in()).expect("written");
    for (i, (arguments, trials, seed)) in [
        (vec!["own.toml"], 7, 3),
        (vec!["own.toml", "--trials", "2", "--seed", "9"], 2, 9),
        (vec!["own.toml", "--level", "smoke"], 1000, 3),
        (vec!["plain.toml"], 100, 1),
    ]
    .into_iter()
    .enumerate()
    {
        let out = format!("out-{i}");
        // One trial of however many there are.
        let shard = ["--shard", "1/1000", "--out", &out];
        let all: Vec<&str> = ["verify"].into_iter().chain(arguments).chain(shard).collect();
        let (status, printed) = run(folder.path(), &all);
        assert!(status == 0 || status == 1, "{printed}");
        let identity = parsed(read(folder.path(), &format!("{out}/trials.jsonl")).lines().next().expect("a line"));
        assert_eq!((&identity["trials"], &identity["seed"]), (&json!(trials), &json!(seed)), "{all:?}");
    }
    refused(folder.path(), &["verify", "own.toml", "--level", "quick", "--trials", "3"], "--level");
}
