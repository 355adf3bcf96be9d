//! Journals that no campaign made.

use serde_json::{Value, json};
use std::path::Path;

use crate::command::{SCENARIO, parsed, read, run};
use crate::support::slideway;

/// The first line of a journal of this many trials, whole, with a statement of the test's own.
pub(crate) fn identity(folder: &Path, trials: u64) -> Value {
    let all = ["verify", SCENARIO, "--trials", "1", "--out", "identity"];
    assert!(run(folder, &all).0 != 2);
    let mut identity = parsed(read(folder, "identity/trials.jsonl").lines().next().expect("a line"));
    identity["trials"] = json!(trials);
    identity["statement"]["method"] = json!("sliding-mode");
    identity["statement"]["hypotheses"] = json!([]);
    identity["statement"]["guarantees"] = json!([]);
    identity
}

pub(crate) fn hypothesis(value: Value, remedy: Option<&str>) -> Value {
    json!({
        "name": "filter", "claim": "drifting-band", "text": "the filter outruns the drift", "value": value,
        "relation": "at-least", "needed": 5.0, "unit": "1/s", "remedy": remedy
    })
}

pub(crate) fn guarantee(name: &str, upper: f64, measured: Option<f64>) -> Value {
    json!({
        "name": name, "claim": name, "text": "stays below <a bound>", "lower": null, "upper": upper, "unit": "m",
        "rests_on": ["filter"], "measured": measured
    })
}

pub(crate) fn check(name: &str, measured: Value, margin: Value) -> Value {
    json!({ "guarantee": name, "measured": measured, "bound": 1.0, "margin": margin, "unit": "m" })
}

/// A trial in which `depth` fails if its number leaves 2 when divided by 5, and `lag` is always kept.
pub(crate) fn trial(number: u64) -> Value {
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
pub(crate) fn smallest(number: u64) -> Value {
    let mut small = trial(number);
    small["size"] = json!(0.125);
    let text = format!("# trial {number}\n{}", built_in());
    json!({ "guarantee": "depth", "trial": small, "scenario": text })
}

pub(crate) fn built_in() -> String {
    let output = slideway(Path::new("."), &["show", SCENARIO]);
    String::from_utf8(output.stdout).expect("UTF-8")
}

pub(crate) fn write_journal(folder: &Path, out: &str, identity: &Value, entries: &[Value]) {
    std::fs::create_dir_all(folder.join(out)).expect("folder");
    let lines: String = [identity].into_iter().chain(entries).map(|line| format!("{line}\n")).collect();
    std::fs::write(folder.join(out).join("trials.jsonl"), lines).expect("written");
}

/// Journals of the shards of those trials; the names of their folders.
pub(crate) fn write_shards(folder: &Path, whole: &Value, of: u64) -> Vec<String> {
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
