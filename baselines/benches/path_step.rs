//! One sample by every form of the path conditioner with 1, 2, 4 and 8 constraints, with the trap walks, and by the QP safety
//! filter, in one run:
//!
//! ```text
//! cargo bench -p slideway-baselines --bench path_step
//! .ci/instructions            # the same steps in instructions, under valgrind
//! ```

mod steps;

use criterion::{Criterion, criterion_group, criterion_main};
use steps::{Meter, measure_all};

struct Clock<'a>(&'a mut Criterion);

impl Meter for Clock<'_> {
    fn measure<S: FnMut()>(&mut self, name: &str, prepare: impl Fn() -> S) {
        self.0.bench_function(&format!("path-step/{name}"), |b| b.iter(prepare()));
    }
}

fn times(c: &mut Criterion) {
    measure_all(&mut Clock(c));
}

criterion_group!(benches, times);
criterion_main!(benches);
