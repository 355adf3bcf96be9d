//! Runs one of the benchmark's steps a given number of times, for a tool that counts instructions: see `.ci/instructions`.
//!
//! Without arguments the names of the steps are printed.

#[path = "../benches/steps/mod.rs"]
mod steps;

use steps::{Meter, measure_all};

/// Prints the names.
struct Names;

impl Meter for Names {
    fn measure<S: FnMut()>(&mut self, name: &str, _prepare: impl Fn() -> S) {
        println!("{name}");
    }
}

/// Prepares the step of this name and repeats it.
struct Repeat {
    wanted: String,
    times: u32,
}

impl Meter for Repeat {
    fn measure<S: FnMut()>(&mut self, name: &str, prepare: impl Fn() -> S) {
        if name == self.wanted {
            let mut step = prepare();
            for _ in 0..self.times {
                step();
            }
        }
    }
}

fn main() {
    let mut arguments = std::env::args().skip(1);
    match (arguments.next(), arguments.next().and_then(|times| times.parse().ok())) {
        (Some(wanted), Some(times)) => measure_all(&mut Repeat { wanted, times }),
        _ => measure_all(&mut Names),
    }
}
