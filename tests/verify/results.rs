//! Results of a campaign: status, JSON, JUnit and page.

use quick_xml::events::Event;
use serde_json::{Value, json};

use crate::command::{SCENARIO, folder, merge, parsed, read, run, verify};
use crate::made::{built_in, check, guarantee, hypothesis, identity, smallest, trial, write_journal};
use crate::support::slideway;

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
