//! One sample by every form of the path conditioner with 1, 2, 4 and 8 constraints, with the trap walks, and by the QP safety
//! filter, in one run:
//!
//! ```text
//! cargo bench -p slideway-baselines --bench path_step
//! .ci/instructions            # the same steps in instructions, under valgrind
//! ```

mod steps;
#[path = "../../crates/conditioner/tests/support/mod.rs"]
mod support;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use slideway_conditioner::PathConditioner;
use slideway_conditioner::path::{Constraint, Motion, PathForm, PathSettings};
use slideway_conditioner::shapes::{Ball, HalfSpace, Side};
use std::hint::black_box;
use steps::{Meter, measure_all};
use support::{PATH_RATE, explicit, first_example, helix_beside_sphere, implicit};

struct Clock<'a>(&'a mut Criterion);

impl Meter for Clock<'_> {
    fn measure<S: FnMut()>(&mut self, name: &str, prepare: impl Fn() -> S) {
        self.0.bench_function(&format!("path-step/{name}"), |b| b.iter(prepare()));
    }
}

fn times(c: &mut Criterion) {
    measure_all(&mut Clock(c));
}

/// Samples of example 9.1 of [G12]: 5 s at 1 ms.
const SAMPLES: u32 = 5000;

/// The whole of example 9.1, two constraints, in contact for a fifth of the time: what a step costs in use. The steps above
/// are all in contact with every constraint, the dearest there is.
fn example(c: &mut Criterion) {
    let reference: Vec<Motion<3>> = (0..SAMPLES)
        .map(|k| {
            let time = f64::from(k) * 1e-3;
            let (position, derivative) = helix_beside_sphere(PATH_RATE * time);
            Motion { time, position, velocity: derivative.map(|d| d * PATH_RATE) }
        })
        .collect();
    let plane = HalfSpace::new(&[0.0, 1.0, 0.0], 0.0).expect("a unit normal");
    let sphere = Ball::new([0.0; 3], 0.05, Side::Outside).expect("a positive radius");
    let mut group = c.benchmark_group("example-9.1");
    group.throughput(Throughput::Elements(u64::from(SAMPLES)));
    let forms: [(&str, PathForm); 2] = [("explicit", explicit(0.1)), ("implicit", implicit())];
    for (name, form) in forms {
        let settings = PathSettings { form, ..first_example(1e-3, explicit(0.1)) };
        let conditioner = PathConditioner::<3, 2>::new(settings).expect("valid settings");
        group.bench_function(name, |b| {
            b.iter(|| {
                let mut state = conditioner.on_reference();
                for motion in &reference {
                    black_box(conditioner.step(&mut state, black_box(motion), |m| [plane.sample(m), sphere.sample(m)]));
                }
            })
        });
    }
    group.finish();
}

criterion_group!(benches, times, example);
criterion_main!(benches);
