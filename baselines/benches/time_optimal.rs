//! One certified optimum at 100, 1000 and 4000 grid points, with and without acceleration limits.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use slideway_baselines::time_optimal::time_optimum;
use slideway_path::SampledPath;
use slideway_scenario::Scenario;
use std::hint::black_box;

fn sampled(intervals: usize, acceleration: Option<f64>) -> SampledPath {
    let scenario = Scenario::built_in("puma-helix-on-path").expect("built in").expect("valid");
    let mut path = scenario.experiment().expect("valid").sample(intervals, 0).expect("reachable");
    path.acceleration = acceleration.map(|a| vec![a; path.joints]);
    path
}

fn optimum(c: &mut Criterion) {
    let mut group = c.benchmark_group("time-optimum");
    group.sample_size(10);
    for points in [100, 1000, 4000] {
        for (name, acceleration) in [("speed", None), ("speed-and-acceleration", Some(5.0))] {
            let path = sampled(points, acceleration);
            group.bench_with_input(BenchmarkId::new(name, points), &path, |b, path| {
                b.iter(|| time_optimum(black_box(path)))
            });
        }
    }
    group.finish();
}

criterion_group!(benches, optimum);
criterion_main!(benches);
