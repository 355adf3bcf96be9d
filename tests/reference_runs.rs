//! Agreement with runs of an independent simulation, sample by sample. `tests/data/README.md` says where they come from.

use slideway_lab::{Method, Trace};
use slideway_scenario::Scenario;

/// Columns of a reference file that are compared.
struct Row {
    t: f64,
    lambda: f64,
    q: [f64; 6],
    error: [f64; 6],
}

fn rows(text: &str) -> Vec<Row> {
    let row = |line: &str| {
        let x: Vec<f64> = line.split(',').map(|c| c.parse().expect("number")).collect();
        Row { t: x[0], lambda: x[1], q: std::array::from_fn(|i| x[5 + i]), error: std::array::from_fn(|i| x[17 + i]) }
    };
    text.lines().skip(1).map(row).collect()
}

fn run(scenario: &str, method: Method) -> Trace {
    let scenario = Scenario::built_in(scenario).expect("built in").expect("valid");
    scenario.experiment().expect("valid").run(method).expect("runs")
}

/// Largest differences in path parameter, joint position (up to whole turns) and error over the common samples.
fn differences(trace: &Trace, rows: &[Row], until: f64) -> [f64; 3] {
    let mut worst = [0.0_f64; 3];
    let mut compared = 0;
    for row in rows.iter().filter(|r| r.t <= until) {
        let index = (row.t / trace.sampling_period).round() as usize;
        let Some(sample) = trace.samples.get(index) else { continue };
        compared += 1;
        worst[0] = worst[0].max((sample.lambda - row.lambda).abs());
        for i in 0..6 {
            let turn = std::f64::consts::TAU;
            let apart = sample.q[i] - row.q[i];
            worst[1] = worst[1].max((apart - turn * (apart / turn).round()).abs());
            worst[2] = worst[2].max((sample.error[i] - row.error[i]).abs());
        }
    }
    assert!(compared > 100, "only {compared} samples in common");
    worst
}

#[test]
fn sliding_mode_on_the_helix_agrees_with_the_reference() {
    let rows = rows(include_str!("data/puma_helix_sliding_mode.csv"));
    let worst = differences(&run("puma-helix", Method::SlidingMode), &rows, 5.2);
    assert!(worst.iter().all(|w| *w < 1e-8), "{worst:?}");
}

#[test]
fn direct_saturation_on_the_helix_agrees_with_the_reference() {
    let rows = rows(include_str!("data/puma_helix_saturated.csv"));
    let worst = differences(&run("puma-helix", Method::Saturated), &rows, 5.0);
    assert!(worst.iter().all(|w| *w < 1e-8), "{worst:?}");
}

#[test]
fn sliding_mode_through_the_singularity_agrees_with_the_reference() {
    let rows = rows(include_str!("data/puma_wrist_singularity_sliding_mode.csv"));
    let worst = differences(&run("puma-wrist-singularity", Method::SlidingMode), &rows, 2.02);
    assert!(worst.iter().all(|w| *w < 1e-8), "{worst:?}");
}
