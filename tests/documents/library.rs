//! The Rust of the pages.

use crate::page::{Page, readme, root};
use slideway_conditioner::ParameterError;

/// Documentation that has the examples of the page about the library; the compiler runs them there.
const DOCUMENTATION: [&str; 3] = ["crates/conditioner/README.md", "crates/robot/README.md", "crates/motion/src/lib.rs"];

#[test]
fn every_example_of_the_library_page_is_one_of_a_crate_and_compiled_there() {
    let examples: String = DOCUMENTATION.map(documentation).concat();
    let page = Page::read("docs/library.md");
    let blocks: Vec<_> = page.blocks().into_iter().filter(|block| block.language == "rust").collect();
    assert!(blocks.len() >= 4);
    for block in blocks {
        assert!(examples.contains(&block.text), "{}: not in {DOCUMENTATION:?}", block.place);
    }
}

/// A page, or the module documentation of a file.
fn documentation(name: &str) -> String {
    let text = std::fs::read_to_string(root().join(name)).expect("reads");
    if name.ends_with(".md") {
        return text;
    }
    let lines = text.lines().filter_map(|line| line.strip_prefix("//!"));
    lines.map(|line| format!("{}\n", line.strip_prefix(' ').unwrap_or(line))).collect()
}

#[test]
fn the_control_loop_of_the_readme_is_the_one_below() {
    let block = readme().blocks().into_iter().find(|block| block.language == "rust").expect("a loop");
    let this = squeezed(include_str!("library.rs"));
    for line in block.text.lines().filter(|line| !line.trim().is_empty()) {
        assert!(this.contains(&squeezed(line)), "{}: {line}", block.place);
    }
}

fn squeezed(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
#[rustfmt::skip]
fn the_control_loop_of_the_readme_runs() -> Result<(), ParameterError> {
    use slideway_conditioner::{Advance, Saturation, SpeedLimits, SpeedRegulator, SpeedSettings, SpeedState};

    let regulator = SpeedRegulator::new(SpeedSettings {
        limits: SpeedLimits::symmetric([0.5; 6])?,      // rad/s
        sampling_period: 1e-3,                          // s
        bandwidth: 5.0,                                 // rad/s
        target_rate: 5.0,                               // 1/s, faster than the joints can go
        saturation: Saturation::DirectionPreserving,
        advance: Advance::Synchronised,
    })?;
    let mut state = SpeedState::at_rest();
    let mut path_parameter = 0.0;
    for _ in 0..2000 {
        // every sample:
        let rate = regulator.requested_rate(&state);        // path rate for your controller
        let desired = [0.5 * rate, 0.1, 0.0, 0.0, 0.0, 0.0];
        let command = regulator.step(&mut state, &desired); // its desired joint speeds
        // send command.joint_speed; advance the path parameter by 1e-3 * command.path_rate
        assert!(command.joint_speed.iter().all(|speed| speed.abs() <= 0.5));
        path_parameter += 1e-3 * command.path_rate;
    }
    // The first joint allows a rate of 1, and the filter needs 1/5 ln(5/4) = 0.05 s to come near it.
    assert!((1.9..2.0).contains(&path_parameter), "{path_parameter}");
    Ok(())
}
