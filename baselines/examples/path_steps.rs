//! One step of the path conditioner, or of the QP safety filter, a given number of times, for a tool that counts instructions: see
//! `.ci/instructions`.
//!
//! ```text
//! cargo run --release -p slideway-baselines --example path_steps                    # the names of the steps
//! cargo run --release -p slideway-baselines --example path_steps -- implicit/2 500  # one of them, 500 times
//! ```

#[path = "../benches/steps/mod.rs"]
mod steps;

use std::process::ExitCode;
use steps::{Meter, measure_all};

/// Prints the names of the steps.
struct Names;

impl Meter for Names {
    fn measure<S: FnMut()>(&mut self, name: &str, _prepare: impl Fn() -> S) {
        println!("{name}");
    }
}

/// Prepares the step of one name and repeats it.
struct Repeat {
    wanted: String,
    times: u32,
    is_known: bool,
}

impl Meter for Repeat {
    fn measure<S: FnMut()>(&mut self, name: &str, prepare: impl Fn() -> S) {
        if name == self.wanted {
            self.is_known = true;
            let mut step = prepare();
            for _ in 0..self.times {
                step();
            }
        }
    }
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [wanted, times] = arguments.as_slice() else {
        measure_all(&mut Names);
        return ExitCode::SUCCESS;
    };
    let Ok(times) = times.parse() else {
        eprintln!("{times:?} is no number of steps");
        return ExitCode::from(2);
    };
    let mut repeat = Repeat { wanted: wanted.clone(), times, is_known: false };
    measure_all(&mut repeat);
    if repeat.is_known {
        return ExitCode::SUCCESS;
    }
    eprintln!("no step is called {wanted:?}; without arguments their names are printed");
    ExitCode::from(2)
}
