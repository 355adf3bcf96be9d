//! Sweeps: the same rows for any number of jobs and interruptions, failures counted, wrong input pointed out.

mod support;

use slideway_compare::sweep::quantile;
use std::collections::BTreeSet;
use std::path::Path;
use support::{WAY_POINTS, from_files, json, slideway};

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("folder")
}

/// Runs a sweep that must end with this status; returns what it printed on either stream.
fn sweep(folder: &Path, arguments: &[&str], status: i32) -> String {
    let all: Vec<&str> = ["sweep"].iter().chain(arguments).copied().collect();
    let output = slideway(folder, &all);
    let printed = format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert_eq!(output.status.code(), Some(status), "{arguments:?}: {printed}");
    assert!(!printed.contains("panicked"), "{printed}");
    // Long messages are wrapped for the terminal.
    printed.replace("\n  │ ", " ").replace("\n        ", " ")
}

fn read(folder: &Path, file: &str) -> String {
    std::fs::read_to_string(folder.join(file)).expect("written by the sweep")
}

/// A cheap study: samples five times as far apart as the built-in scenario's.
const SEEDS: [&str; 5] = ["trap-booth-oval", "--seeds", "6", "--set", "conditioner.sampling_period=1e-3"];

fn seeds_into<'a>(out: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    SEEDS.iter().chain(&["--out", out]).chain(more).copied().collect()
}

#[test]
fn rows_are_the_same_bytes_for_any_number_of_jobs() {
    let folder = folder();
    let grid = ["--grid", "trap.walk_speed=4,5"];
    for (out, jobs) in [("one", "1"), ("two", "2"), ("five", "5")] {
        sweep(folder.path(), &seeds_into(out, &[grid[0], grid[1], "--jobs", jobs]), 0);
    }
    let rows = read(folder.path(), "one/rows.csv");
    assert_eq!(rows.lines().count(), 1 + 2 * 6);
    for other in ["two", "five"] {
        assert_eq!(rows, read(folder.path(), &format!("{other}/rows.csv")));
        assert_eq!(read(folder.path(), "one/summary.json"), read(folder.path(), &format!("{other}/summary.json")));
    }
    let durations: BTreeSet<&str> = rows.lines().skip(1).filter_map(|line| line.split(',').nth(5)).collect();
    assert!(durations.len() > 6, "the seeds make a difference: {durations:?}");
}

#[test]
fn a_sweep_cut_short_anywhere_continues_to_the_same_rows() {
    let folder = folder();
    sweep(folder.path(), &seeds_into("out", &[]), 0);
    let (journal, rows) = (read(folder.path(), "out/rows.jsonl"), read(folder.path(), "out/rows.csv"));
    let header = journal.find('\n').expect("a header") + 1;
    // Within the header, after it, within a row, after a row, and before the last line break.
    for length in [
        0,
        header / 2,
        header,
        header + 20,
        journal[..journal.len() - 1].rfind('\n').expect("rows") + 1,
        journal.len() - 1,
    ] {
        std::fs::write(folder.path().join("out/rows.jsonl"), &journal[..length]).expect("cut");
        std::fs::remove_file(folder.path().join("out/rows.csv")).expect("there");
        sweep(folder.path(), &seeds_into("out", &[]), 0);
        assert_eq!(read(folder.path(), "out/rows.csv"), rows, "cut to {length} bytes");
        let lines: BTreeSet<String> = read(folder.path(), "out/rows.jsonl").lines().map(str::to_owned).collect();
        assert_eq!(lines, journal.lines().map(str::to_owned).collect(), "cut to {length} bytes");
    }
}

#[test]
fn finished_rows_are_never_computed_again() {
    let folder = folder();
    sweep(folder.path(), &seeds_into("out", &[]), 0);
    let journal = read(folder.path(), "out/rows.jsonl");
    // A mark that no run gives: if it is still there afterwards, the row was taken from the journal.
    let marked = |line: &str| {
        let mut row = json(line);
        row["values"][0] = 1234.5.into();
        format!("{row}\n")
    };
    let marked: String = journal
        .lines()
        .filter(|line| !line.starts_with("{\"run\":4,"))
        .map(|line| if line.starts_with("{\"run\":2,") { marked(line) } else { format!("{line}\n") })
        .collect();
    std::fs::write(folder.path().join("out/rows.jsonl"), marked).expect("written");
    sweep(folder.path(), &seeds_into("out", &[]), 0);
    let rows = read(folder.path(), "out/rows.csv");
    let row = |run: usize| rows.lines().nth(run + 1).expect("row").to_owned();
    assert!(row(2).starts_with("2,3,true,0,1234.5,"), "{}", row(2));
    assert!(row(4).starts_with("4,5,true,0,") && !row(4).contains("1234.5"), "{}", row(4));
}

#[test]
fn another_scenario_or_other_arguments_in_the_same_folder_are_refused_with_what_differs() {
    let folder = folder();
    let text = String::from_utf8(slideway(folder.path(), &["show", "trap-booth-oval"]).stdout).expect("UTF-8");
    let text = text.replace("sampling_period = 2e-4", "sampling_period = 1e-3");
    let file = folder.path().join("own.toml");
    std::fs::write(&file, &text).expect("written");
    let run = |more: &[&str], status| {
        let all: Vec<&str> = ["own.toml", "--out", "here"].iter().chain(more).copied().collect();
        sweep(folder.path(), &all, status)
    };
    run(&["--seeds", "2"], 0);
    for (more, says) in [
        (vec!["--seeds", "3"], "number of seeds was --seeds 2, now it is --seeds 3"),
        (vec![], "now it is not given"),
        (vec!["--seeds", "2", "--set", "trap.walk_speed=4"], "--set was not given, now it is trap.walk_speed=4"),
        (vec!["--seeds", "2", "--grid", "trap.walk_speed=4,6"], "--grid was not given"),
        (
            vec!["--seeds", "2", "--method", "sliding-mode-implicit"],
            "method was sliding-mode, now it is sliding-mode-implicit",
        ),
    ] {
        let printed = run(&more, 2);
        assert!(printed.contains(says) && printed.contains("--out"), "{says}: {printed}");
    }
    std::fs::write(&file, text.replace("walk_speed = 5", "walk_speed = 4")).expect("written");
    let printed = run(&["--seeds", "2"], 2);
    let line = 1 + text.lines().position(|l| l == "walk_speed = 5").expect("in the scenario");
    let says = format!("was `walk_speed = 5` in line {line}, now it is `walk_speed = 4` in line {line}");
    assert!(printed.contains(&says), "{printed}");
}

#[test]
fn rows_are_never_continued_with_another_file_that_the_scenario_or_a_setting_names() {
    let folder = folder();
    let write = |file: &str, text: &str| std::fs::write(folder.path().join(file), text).expect("written");
    let arm = Path::new(env!("CARGO_MANIFEST_DIR")).join("../robot/tests/urdf/planar.urdf");
    let arm = std::fs::read_to_string(arm).expect("fixture");
    let (scenario, points) = (from_files("urdf = \"planar.urdf\"", "points.csv"), WAY_POINTS);
    for (file, text) in
        [("own.toml", scenario.as_str()), ("planar.urdf", &arm), ("points.csv", points), ("b.csv", points)]
    {
        write(file, text);
    }
    let arguments = ["own.toml", "--grid", "path.joints.spline.csv=points.csv,b.csv", "--out", "out"];
    sweep(folder.path(), &arguments, 0);
    sweep(folder.path(), &arguments, 0);
    let rows = read(folder.path(), "out/rows.csv");
    let faster = arm.replace("velocity=\"2\"", "velocity=\"2.5\"");
    let further = points.replace("0.7", "0.8");
    for (file, was, now) in
        [("points.csv", points, further.as_str()), ("b.csv", points, &further), ("planar.urdf", &arm, &faster)]
    {
        assert_ne!(was, now);
        write(file, now);
        let printed = sweep(folder.path(), &arguments, 2);
        assert!(printed.contains("text of its files was") && printed.contains("--out"), "{file}: {printed}");
        write(file, was);
    }
    assert_eq!(rows, read(folder.path(), "out/rows.csv"));
    std::fs::remove_file(folder.path().join("b.csv")).expect("removed");
    let printed = sweep(folder.path(), &arguments, 2);
    assert!(printed.contains("list of files was"), "{printed}");
}

#[test]
fn a_file_that_no_sweep_wrote_is_neither_used_nor_changed() {
    let folder = folder();
    sweep(folder.path(), &seeds_into("out", &[]), 0);
    let journal = read(folder.path(), "out/rows.jsonl");
    for foreign in [
        "my notes".to_owned(),
        "{\"run\":0}\n".to_owned(),
        format!("{journal}what is this\n"),
        format!("{journal}{{\"run\":0,\"completed\":true,\"broken\":0,\"values\":[1]}}\n"),
        journal.replace("\"run\":5,", "\"run\":6,"),
    ] {
        let file = folder.path().join("out/rows.jsonl");
        std::fs::write(&file, &foreign).expect("written");
        let printed = sweep(folder.path(), &seeds_into("out", &[]), 2);
        assert!(printed.contains("not written by a sweep") && printed.contains("line"), "{printed}");
        assert_eq!(read(folder.path(), "out/rows.jsonl"), foreign);
    }
}

#[test]
fn wrong_input_is_pointed_out_before_anything_runs() {
    let folder = folder();
    for (arguments, says) in [
        (vec!["--set", "trap.wlk=3"], "unknown field `wlk`"),
        (vec!["--set", "trap.walk=slow"], "unknown variant `slow`"),
        (vec!["--set", "trap.walk_speed=quick"], "quick"),
        (vec!["--set", "trap.walk_speed=[1"], "no TOML value"),
        (vec!["--set", "trap.walk.safe.push_share.x=1"], "not a table"),
        (vec!["--set", "constraint.1.approach=1"], "list of 1"),
        (vec!["--set", "conditioner.push_cutoff=0"], "not positive"),
        (vec!["--set", "conditioner.push_cutoff"], "equals sign"),
        (vec!["--set", "trap.walk_cutoff=-1"], "out of its range"),
        (vec!["--grid", "conditioner.push_cutoff=20,0"], "not positive"),
        (vec!["--grid", "trap.walk_speed=1,,2"], "two commas"),
        (vec!["--grid", "trap.walk_speed=1,2", "--set", "trap.walk_speed=3"], "set the same thing"),
        (vec!["--seeds", "2", "--grid", "trap.seed=1,2"], "set the same thing"),
        (vec!["--seeds", "2", "--set", "trap.seed=1"], "set the same thing"),
        (vec!["--seeds", "99999999999999"], "runs"),
        (vec!["--seeds", "0"], "--seeds"),
        (vec!["--jobs", "0"], "--jobs"),
        (vec!["--method", "projection"], "no method"),
        (vec!["--out", "/dev/null/x"], "cannot write"),
    ] {
        let all: Vec<&str> = ["trap-booth-oval"].iter().chain(&arguments).copied().collect();
        let printed = sweep(folder.path(), &all, 2);
        assert!(printed.contains(says), "{arguments:?}: `{says}` not in: {printed}");
        assert!(printed.contains("help:") || printed.contains("--help"), "no remedy in: {printed}");
    }
    for (arguments, says) in [
        (vec!["helix-plane-sphere", "--seeds", "2"], "draws no random numbers"),
        (vec!["puma-helix", "--seeds", "2"], "draws no random numbers"),
        (vec!["puma-helix", "--method", "sliding-mode-paper"], "no method"),
        (vec!["puma-helx"], "puma-helix"),
        (vec!["nowhere.toml"], "slideway list"),
    ] {
        let printed = sweep(folder.path(), &arguments, 2);
        assert!(printed.contains(says), "{arguments:?}: {printed}");
    }
    assert_eq!(std::fs::read_dir(folder.path()).expect("folder").count(), 0, "nothing was written");
}

#[test]
fn a_wrong_setting_is_shown_with_the_text_it_makes() {
    let printed = sweep(folder().path(), &["puma-helix", "--grid", "control.bandwidth=5,5000", "--out", "x"], 2);
    assert!(printed.contains("puma-helix with control.bandwidth=5000:"), "{printed}");
    assert!(printed.contains("bandwidth = 5000") && printed.contains("must not exceed 1"), "{printed}");
}

#[test]
fn a_grid_on_a_speed_scenario_has_a_row_per_combination_the_last_key_fastest() {
    let folder = folder();
    let grid = ["--grid", "control.bandwidth=5,10", "--grid", "control.target_rate=4,5"];
    let all: Vec<&str> = ["puma-helix", "--json", "--out", "out"].iter().chain(&grid).copied().collect();
    let summary = json(&sweep(folder.path(), &all, 0));
    assert_eq!(summary, json(&read(folder.path(), "out/summary.json")));
    let rows = read(folder.path(), "out/rows.csv");
    let begins: Vec<String> = rows.lines().map(|l| l.split(',').take(5).collect::<Vec<_>>().join(",")).collect();
    let expected = [
        "run,seed,control.bandwidth,control.target_rate,completed",
        "0,,5,4,true",
        "1,,5,5,true",
        "2,,10,4,true",
        "3,,10,5,true",
    ];
    assert_eq!(begins, expected);
    let cells = summary["cells"].as_array().expect("cells");
    assert_eq!(cells.len(), 4);
    assert_eq!(cells[2]["grid"], serde_json::json!({ "control.bandwidth": 10, "control.target_rate": 4 }));
    // The limit ratio's excess over 1 is one step of the filter: twice the bandwidth, twice the excess, to first order.
    let excess = |i: usize| cells[i]["columns"]["limit_ratio_peak"]["max"].as_f64().expect("number") - 1.0;
    let ratio = excess(3) / excess(1);
    assert!((1.5..2.5).contains(&ratio), "{ratio}");
}

#[test]
fn runs_that_do_not_complete_or_break_a_constraint_are_failures_and_exit_with_1() {
    let folder = folder();
    // 5 s of motion do not fit into 4 s.
    let short = ["helix-plane-sphere", "--grid", "reference.max_duration=4,40", "--json", "--out", "short"];
    let summary = json(&sweep(folder.path(), &short, 1));
    let failures = &summary["all"]["failures"];
    assert_eq!(failures, &serde_json::json!({ "total": 1, "not_completed": 1, "broken": 0, "runs": [0] }));
    assert_eq!(summary["cells"][1]["failures"]["total"], 0);
    assert_eq!(summary["all"]["columns"]["duration_s"]["count"], 1);
    // A push too weak to keep the reference out of the sphere.
    let weak = ["helix-plane-sphere", "--set", "conditioner.law.normalised.amplitude=1e-3", "--out", "weak"];
    let printed = sweep(folder.path(), &weak, 1);
    assert!(printed.contains("1 of 1 runs failed: 0 did not complete, 1 broke a constraint (run 0)"), "{printed}");
    let rows = read(folder.path(), "weak/rows.csv");
    let mut csv = csv::Reader::from_reader(rows.as_bytes());
    let column = |csv: &mut csv::Reader<&[u8]>, name: &str| {
        csv.headers().expect("header").iter().position(|h| h == name).expect("column")
    };
    let (broken, sphere) = (column(&mut csv, "broken"), column(&mut csv, "max_sigma_sphere_m"));
    let row = csv.records().next().expect("a row").expect("CSV");
    assert_eq!(&row[broken], "2");
    assert!(row[sphere].parse::<f64>().expect("number") > 0.0);
}

#[test]
fn every_seed_escapes_the_trap_and_the_summary_is_that_of_the_rows() {
    let folder = folder();
    let summary = json(&sweep(folder.path(), &seeds_into("out", &["--json"]), 0));
    let rows = read(folder.path(), "out/rows.csv");
    let mut csv = csv::Reader::from_reader(rows.as_bytes());
    let header = csv.headers().expect("header").clone();
    let records: Vec<csv::StringRecord> = csv.records().map(|r| r.expect("CSV")).collect();
    let column = |name: &str| {
        let index = header.iter().position(|h| h == name).expect("column");
        let mut values: Vec<f64> = records.iter().filter_map(|r| r[index].parse().ok()).collect();
        values.sort_by(f64::total_cmp);
        values
    };
    for name in ["escape_s", "max_sigma_oval_m", "trapped_share"] {
        let (values, found) = (column(name), &summary["all"]["columns"][name]);
        assert_eq!(values.len(), 6, "{name}");
        assert_eq!(found["median"].as_f64(), quantile(&values, 0.5), "{name}");
        assert_eq!(found["p95"].as_f64(), quantile(&values, 0.95), "{name}");
        assert_eq!(found["max"].as_f64(), values.last().copied(), "{name}");
    }
    assert!(column("max_sigma_oval_m").iter().all(|&s| s <= 0.0));
    assert!(column("escape_s").iter().all(|&s| s > 0.0));
}

#[test]
fn one_run_of_a_seed_is_the_run_of_the_scenario_with_that_seed() {
    let folder = folder();
    sweep(folder.path(), &seeds_into("many", &[]), 0);
    let one = ["trap-booth-oval", "--set", "conditioner.sampling_period=1e-3", "--set", "trap.seed=4", "--out", "one"];
    sweep(folder.path(), &one, 0);
    let (many, one) = (read(folder.path(), "many/rows.csv"), read(folder.path(), "one/rows.csv"));
    assert_eq!(
        many.lines().nth(4).expect("seed 4").strip_prefix("3,4,"),
        one.lines().nth(1).expect("row").strip_prefix("0,,")
    );
}
