//! The smallest push by every solver, beside one implicit step of the conditioner, in one run.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use slideway_baselines::safety_filter::{SmallestPush, conic::ConicPush, dense::DualActiveSet};
use std::hint::black_box;

/// `count` half-spaces in three dimensions that share the origin's antipode, so that some of them act.
fn half_spaces(count: usize) -> (Vec<Vec<f64>>, Vec<f64>) {
    let rows = (0..count)
        .map(|i| {
            let angle = 0.7 * i as f64;
            vec![angle.cos(), angle.sin(), 1.0 + 0.1 * i as f64]
        })
        .collect();
    (rows, (0..count).map(|i| -0.5 - 0.05 * i as f64).collect())
}

fn solvers(c: &mut Criterion) {
    let mut group = c.benchmark_group("smallest-push");
    for count in [1, 2, 4, 8] {
        let (rows, bounds) = half_spaces(count);
        let mut conic = ConicPush::new();
        group.bench_function(BenchmarkId::new("clarabel-update", count), |b| {
            b.iter(|| conic.smallest(black_box(&rows), black_box(&bounds)))
        });
        group.bench_function(BenchmarkId::new("clarabel-cold", count), |b| {
            b.iter(|| ConicPush::new().smallest(black_box(&rows), black_box(&bounds)))
        });
        group.bench_function(BenchmarkId::new("dense-active-set", count), |b| {
            b.iter(|| DualActiveSet.smallest(black_box(&rows), black_box(&bounds)))
        });
    }
    group.finish();
}

criterion_group!(benches, solvers);
criterion_main!(benches);
