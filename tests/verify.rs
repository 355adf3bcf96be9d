//! Campaigns of `slideway verify`: the same results for any number of jobs, interruptions and shards; violations told with a
//! scenario that shows them again; wrong input pointed out.
//!
//! Most journals here are written by the tests themselves: what the command makes of trials does not depend on who made them.

mod support;

use quick_xml::events::Event;
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::path::Path;
use support::slideway;

/// A scenario whose trials are short.
const SCENARIO: &str = "planar-line";
/// Everything that a campaign leaves and that must not depend on how it was run.
const RESULTS: [&str; 3] = ["verify.json", "junit.xml", "report.html"];

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("folder")
}

/// Runs the command; its status and what it printed on either stream, unwrapped.
fn run(folder: &Path, arguments: &[&str]) -> (i32, String) {
    let output = slideway(folder, arguments);
    let printed = format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(!printed.contains("panicked"), "{printed}");
    let unwrapped = printed.replace("\n  │ ", " ").replace("\n        ", " ");
    (output.status.code().expect("a status"), unwrapped)
}

/// Runs a campaign whose verdict does not matter.
fn verify(folder: &Path, out: &str, more: &[&str]) -> String {
    let all: Vec<&str> = ["verify", SCENARIO, "--trials", "12", "--out", out].iter().chain(more).copied().collect();
    let (status, printed) = run(folder, &all);
    assert!(status == 0 || status == 1, "{all:?}: {printed}");
    printed
}

/// Runs a command that must be refused for what it is given, with a remedy.
fn refused(folder: &Path, arguments: &[&str], says: &str) {
    let (status, printed) = run(folder, arguments);
    assert_eq!(status, 2, "{arguments:?}: {printed}");
    assert!(printed.contains(says), "{arguments:?}: `{says}` not in: {printed}");
    assert!(printed.contains("help:") || printed.contains("--help"), "no remedy in: {printed}");
}

fn read(folder: &Path, file: &str) -> String {
    std::fs::read_to_string(folder.join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

fn same_results(folder: &Path, one: &str, other: &str) {
    for file in RESULTS {
        assert_eq!(read(folder, &format!("{one}/{file}")), read(folder, &format!("{other}/{file}")), "{file}");
    }
    let files = |out: &str| {
        let entries = std::fs::read_dir(folder.join(out)).expect("folder");
        entries.map(|e| e.expect("entry").file_name().into_string().expect("UTF-8")).collect::<BTreeSet<_>>()
    };
    let failing = |out: &str| files(out).into_iter().filter(|f| f.starts_with("failing-")).collect::<Vec<_>>();
    assert_eq!(failing(one), failing(other));
    for file in failing(one) {
        assert_eq!(read(folder, &format!("{one}/{file}")), read(folder, &format!("{other}/{file}")), "{file}");
    }
}

fn parsed(text: &str) -> Value {
    serde_json::from_str(text).expect("valid JSON")
}

/// The first line of a journal of this many trials, whole, with a statement of the test's own.
fn identity(folder: &Path, trials: u64) -> Value {
    let all = ["verify", SCENARIO, "--trials", "1", "--out", "identity"];
    assert!(run(folder, &all).0 != 2);
    let mut identity = parsed(read(folder, "identity/trials.jsonl").lines().next().expect("a line"));
    identity["trials"] = json!(trials);
    identity["statement"]["method"] = json!("sliding-mode");
    identity["statement"]["hypotheses"] = json!([]);
    identity["statement"]["guarantees"] = json!([]);
    identity
}

fn hypothesis(value: Value, remedy: Option<&str>) -> Value {
    json!({
        "name": "filter", "claim": "drifting-band", "text": "the filter outruns the drift", "value": value,
        "relation": "at-least", "needed": 5.0, "unit": "1/s", "remedy": remedy
    })
}

fn guarantee(name: &str, upper: f64, measured: Option<f64>) -> Value {
    json!({
        "name": name, "claim": name, "text": "stays below <a bound>", "lower": null, "upper": upper, "unit": "m",
        "rests_on": ["filter"], "measured": measured
    })
}

fn check(name: &str, measured: Value, margin: Value) -> Value {
    json!({ "guarantee": name, "measured": measured, "bound": 1.0, "margin": margin, "unit": "m" })
}

/// A trial in which `depth` fails if its number leaves 2 when divided by 5, and `lag` is always kept.
fn trial(number: u64) -> Value {
    let fails = number % 5 == 2;
    let share = number as f64 / 100.0;
    let depth = if fails {
        check("depth", json!(1.5 + share), json!(-0.5 - share))
    } else {
        check("depth", json!(0.5), json!(0.5))
    };
    json!({
        "number": number, "size": 0.5, "disturbances": { "seed": number, "joint_noise": 1e-4 },
        "outside": if number % 4 == 3 { vec!["filter"] } else { vec![] },
        "checks": [depth, check("lag", json!(0.25), json!(0.75 - share))]
    })
}

/// The smallest case of `depth` made from one of those trials.
fn smallest(number: u64) -> Value {
    let mut small = trial(number);
    small["size"] = json!(0.125);
    let text = format!("# trial {number}\n{}", built_in());
    json!({ "guarantee": "depth", "trial": small, "scenario": text })
}

fn built_in() -> String {
    let output = slideway(Path::new("."), &["show", SCENARIO]);
    String::from_utf8(output.stdout).expect("UTF-8")
}

fn write_journal(folder: &Path, out: &str, identity: &Value, entries: &[Value]) {
    std::fs::create_dir_all(folder.join(out)).expect("folder");
    let lines: String = [identity].into_iter().chain(entries).map(|line| format!("{line}\n")).collect();
    std::fs::write(folder.join(out).join("trials.jsonl"), lines).expect("written");
}

/// Journals of the shards of those trials; the names of their folders.
fn write_shards(folder: &Path, whole: &Value, of: u64) -> Vec<String> {
    let trials = whole["trials"].as_u64().expect("a number");
    (1..=of)
        .map(|index| {
            let mut identity = whole.clone();
            identity["shard"] = json!(format!("{index}/{of}"));
            let numbers: Vec<u64> = (0..trials).filter(|n| n % of == index - 1).collect();
            // Threads finish in any order.
            let mut entries: Vec<Value> = numbers.iter().rev().map(|&n| trial(n)).collect();
            entries.extend(numbers.iter().find(|&n| n % 5 == 2).map(|&n| smallest(n)));
            let name = format!("shard-{index}-of-{of}");
            write_journal(folder, &name, &identity, &entries);
            name
        })
        .collect()
}

fn merge(folder: &Path, shards: &[String], out: &str) -> (i32, String) {
    let all: Vec<&str> = ["merge"].into_iter().chain(shards.iter().map(String::as_str)).chain(["--out", out]).collect();
    run(folder, &all)
}

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
fn a_violation_exits_with_1_and_leaves_a_scenario_that_compare_runs() {
    let folder = folder();
    verify(folder.path(), "out", &[]);
    let identity = parsed(read(folder.path(), "out/trials.jsonl").lines().next().expect("a line"));
    let entries: Vec<Value> = (0..12).map(trial).chain([smallest(2)]).collect();
    write_journal(folder.path(), "out", &identity, &entries);
    let (status, printed) = run(folder.path(), &["verify", SCENARIO, "--trials", "12", "--out", "out"]);
    assert_eq!(status, 1, "{printed}");
    assert!(printed.contains("depth is violated in 2 of 12 trials (first in trial 2)"), "{printed}");
    let command = printed.lines().map(str::trim).find(|line| line.starts_with("slideway compare")).expect("a command");
    let text = read(folder.path(), command.strip_prefix("slideway compare ").expect("a file"));
    assert_eq!(text, format!("# trial 2\n{}", built_in()));
    let arguments: Vec<&str> = command.split(' ').skip(1).collect();
    assert_eq!(run(folder.path(), &arguments).0, 0);
}

#[test]
fn json_tells_checks_violations_and_the_nearest_trial_of_every_guarantee() {
    let folder = folder();
    let mut whole = identity(folder.path(), 23);
    whole["statement"]["hypotheses"] = json!([hypothesis(json!(6.0), None)]);
    whole["statement"]["guarantees"] = json!([guarantee("never", 1.0, None), guarantee("lag", 1.0, Some(0.2))]);
    let entries: Vec<Value> = (0..23).map(trial).chain([smallest(2)]).collect();
    write_journal(folder.path(), "one", &whole, &entries);
    let output = slideway(folder.path(), &["merge", "one", "--out", "out", "--json"]);
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    assert_eq!(text, read(folder.path(), "out/verify.json"));
    let found = parsed(&text);
    assert_eq!((&found["holds"], &found["trials"]), (&json!(false), &json!(23)));
    assert_eq!(found["trials_outside"], json!({ "filter": 5 }));
    assert_eq!(found["hypotheses"][0]["margin"], 0.2);
    let names: Vec<&str> =
        found["guarantees"].as_array().expect("list").iter().filter_map(|g| g["name"].as_str()).collect();
    // Those stated come first, those that only trials know after them.
    assert_eq!(names, ["never", "lag", "depth"]);
    let (never, lag, depth) = (&found["guarantees"][0], &found["guarantees"][1], &found["guarantees"][2]);
    assert_eq!((&never["trials_checked"], &never["nearest"]), (&json!(0), &json!(null)));
    assert_eq!(
        (&lag["trials_checked"], &lag["violations"], &lag["nearest"]["trial"]),
        (&json!(23), &json!(0), &json!(22))
    );
    assert_eq!(lag["kept_without_disturbances"], true);
    assert_eq!((&depth["violations"], &depth["nearest"]["trial"]), (&json!(5), &json!(22)));
    assert_eq!((&depth["failing"]["trial"], &depth["failing"]["smallest"]["size"]), (&json!(2), &json!(0.125)));
    assert_eq!(depth["failing"]["file"], "failing-depth.toml");
}

#[test]
fn junit_has_a_case_per_hypothesis_and_guarantee_and_its_counts_are_those_of_its_cases() {
    let folder = folder();
    let mut whole = identity(folder.path(), 23);
    whole["statement"]["hypotheses"] = json!([hypothesis(json!(4.0), Some("set control.bandwidth to at least 6"))]);
    whole["statement"]["guarantees"] = json!([guarantee("never", 1.0, None), guarantee("depth", 1.0, Some(0.2))]);
    let entries: Vec<Value> = (0..23).map(trial).chain([smallest(2)]).collect();
    write_journal(folder.path(), "one", &whole, &entries);
    assert_eq!(merge(folder.path(), &["one".to_owned()], "out").0, 1);
    let text = read(folder.path(), "out/junit.xml");
    let mut reader = quick_xml::Reader::from_str(&text);
    let (mut cases, mut failures, mut skipped, mut counts) = (Vec::new(), Vec::new(), 0, Vec::new());
    loop {
        match reader.read_event().expect("well formed") {
            Event::Start(element) | Event::Empty(element) => {
                let attribute = |name: &str| {
                    let found = element.try_get_attribute(name).expect("attributes").expect("there");
                    found.unescape_value().expect("text").into_owned()
                };
                match element.name().as_ref() {
                    b"testsuite" => counts = ["tests", "failures", "errors", "skipped"].map(attribute).to_vec(),
                    b"testcase" => cases.push(attribute("name")),
                    b"failure" => failures.push(attribute("message")),
                    b"skipped" => skipped += 1,
                    _ => {}
                }
            }
            Event::Eof => break,
            _ => {}
        }
    }
    assert_eq!(cases, ["something-was-checked", "filter", "never", "depth", "lag"]);
    assert_eq!(counts, ["5", "2", "0", "1"]);
    assert_eq!((failures.len(), skipped), (2, 1));
    assert!(failures[0].contains("at least 5.0000 1/s is needed"), "{failures:?}");
    assert!(failures[1].contains("first in trial 2 of seed 1"), "{failures:?}");
    for part in ["set control.bandwidth to at least 6", "failing-depth.toml", "stays below &lt;a bound&gt;"] {
        assert!(text.contains(part), "{part}: {text}");
    }
}

#[test]
fn a_hypothesis_that_fails_a_violated_scenario_and_an_empty_campaign_exit_with_1() {
    let folder = folder();
    let kept = |n: u64| json!({ "number": n, "size": 0.5, "disturbances": {}, "outside": [], "checks": [check("lag", json!(0.5), json!(0.5))] });
    let verdict = |hypotheses: Value, guarantees: Value, entries: &[Value]| {
        let trials = entries.iter().filter(|entry| entry["number"].is_u64()).count();
        let mut whole = identity(folder.path(), trials as u64);
        whole["statement"]["hypotheses"] = hypotheses;
        whole["statement"]["guarantees"] = guarantees;
        write_journal(folder.path(), "one", &whole, entries);
        merge(folder.path(), &["one".to_owned()], "out")
    };
    let trials: Vec<Value> = (0..3).map(kept).collect();
    let good = || (json!([hypothesis(json!(6.0), None)]), json!([guarantee("lag", 1.0, Some(0.5))]));
    let (status, printed) = verdict(good().0, good().1, &trials);
    assert_eq!(status, 0, "{printed}");
    assert!(printed.contains("Yes: every hypothesis holds") && printed.contains("3 trials (3 checks)"), "{printed}");
    for (value, says) in [(json!(4.0), "bandwidth"), (json!("NaN"), "the hypothesis filter fails")] {
        let (status, printed) = verdict(json!([hypothesis(value, Some("bandwidth = 6"))]), good().1, &trials);
        assert!(status == 1 && printed.contains(says), "{printed}");
    }
    let (status, printed) = verdict(good().0, json!([guarantee("lag", 1.0, Some(1.5))]), &trials);
    assert!(status == 1 && printed.contains("lag is violated in the scenario as it is"), "{printed}");
    let unchecked = json!({ "number": 0, "size": 0.5, "disturbances": {}, "outside": [], "checks": [] });
    let (status, printed) = verdict(json!([]), json!([]), &[unchecked]);
    assert!(status == 1 && printed.contains("no guarantee was checked"), "{printed}");
    let mut nan = kept(0);
    nan["checks"] = json!([check("depth", json!("NaN"), json!("NaN"))]);
    let (status, printed) = verdict(good().0, good().1, &[nan, smallest(0)]);
    assert!(status == 1 && printed.contains("depth is violated in 1 of 1 trials"), "{printed}");
}

#[test]
fn a_statement_with_a_number_that_is_none_is_the_same_in_all_shards() {
    let folder = folder();
    let mut whole = identity(folder.path(), 4);
    whole["statement"]["hypotheses"] = json!([hypothesis(json!("NaN"), None), hypothesis(json!("inf"), None)]);
    let shards = write_shards(folder.path(), &whole, 2);
    let (status, printed) = merge(folder.path(), &shards, "out");
    assert_eq!(status, 1, "{printed}");
    assert_eq!(parsed(&read(folder.path(), "out/verify.json"))["hypotheses"][0]["value"], "NaN");
}

#[test]
fn the_page_opens_without_a_network_and_shows_every_guarantee() {
    let folder = folder();
    let whole = identity(folder.path(), 23);
    let entries: Vec<Value> = (0..23).map(trial).chain([smallest(2)]).collect();
    write_journal(folder.path(), "one", &whole, &entries);
    assert_eq!(merge(folder.path(), &["one".to_owned()], "out").0, 1);
    let report = read(folder.path(), "out/report.html");
    for link in ["src=\"http", "href=\"http", "url(http", "<script"] {
        assert!(!report.contains(link), "{link}");
    }
    for part in ["<td>depth</td>", "<td>lag</td>", "slideway compare failing-depth.toml", "<svg", "color-scheme"] {
        assert!(report.contains(part), "{part}");
    }
}

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

/// A planar arm on a joint path whose way-points are in a file.
const FROM_FILE: &str = r#"
[robot]
model = "planar-2r"
[path.joints.spline]
csv = "data/points.csv"
[limits]
speed = 1
[control]
gain = 10
sampling_period = 1e-3
bandwidth = 50
target_rate = 2
"#;

#[test]
fn a_failing_case_has_the_files_it_names_beside_it_after_a_merge_too() {
    let folder = folder();
    let points = "q1,q2\n0,0.5\n0.2,0.7\n0.3,1.1\n0.5,1.2\n";
    std::fs::create_dir_all(folder.path().join("mine/data")).expect("folder");
    std::fs::write(folder.path().join("mine/arm.toml"), FROM_FILE).expect("written");
    std::fs::write(folder.path().join("mine/data/points.csv"), points).expect("written");
    let arguments = ["verify", "mine/arm.toml", "--trials", "3", "--out", "out"];
    let (status, printed) = run(folder.path(), &arguments);
    assert!(status == 0 || status == 1, "{printed}");
    let identity = parsed(read(folder.path(), "out/trials.jsonl").lines().next().expect("a line"));
    let mut case = smallest(2);
    case["scenario"] = json!(FROM_FILE);
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
