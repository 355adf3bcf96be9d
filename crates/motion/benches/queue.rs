//! Cost of a set-point, an append and a clear against the length of the queue, six joints.

use criterion::{BatchSize, BenchmarkId, Criterion, criterion_group, criterion_main};
use slideway_motion::{AxisLimits, Interpolation, MotionLimits, MotionQueue};
use slideway_robot::JointVector;
use std::hint::black_box;

type Queue = MotionQueue<6, 1024>;

fn queue(length: usize) -> Queue {
    let axis = AxisLimits::new(2.0, 10.0, 100.0).expect("positive");
    let mut queue = Queue::new(MotionLimits::without_stops([axis; 6]), JointVector::zeros()).expect("finite");
    for k in 0..length {
        let target = JointVector::from_fn(|i, _| if (i + k) % 2 == 0 { 1.0 } else { -1.0 });
        queue.go_to(&target, Interpolation::BoundedJerk).expect("room");
    }
    queue
}

fn benches(c: &mut Criterion) {
    for length in [1, 10, 100, 1000] {
        c.bench_with_input(BenchmarkId::new("set-point", length), &length, |b, &length| {
            let mut queue = queue(length);
            // A thousandth of a microsecond a sample: the queue is never played to its end.
            b.iter(|| black_box(queue.advance(1e-9)));
        });
        c.bench_with_input(BenchmarkId::new("append", length), &length, |b, &length| {
            let make = || queue(length);
            let target = JointVector::from_element(0.5);
            b.iter_batched_ref(make, |q| q.go_to(&target, Interpolation::BoundedJerk), BatchSize::LargeInput);
        });
        c.bench_with_input(BenchmarkId::new("clear", length), &length, |b, &length| {
            b.iter_batched_ref(|| queue(length), |q| q.stop_at_way_point(), BatchSize::LargeInput);
        });
        c.bench_with_input(BenchmarkId::new("interrupt", length), &length, |b, &length| {
            let make = || {
                let mut queue = queue(length);
                queue.advance(0.3).expect("joint motions do not fail");
                queue
            };
            let target = JointVector::from_element(0.5);
            b.iter_batched_ref(make, |q| q.interrupt_to(&target, Interpolation::BoundedJerk), BatchSize::LargeInput);
        });
    }
}

criterion_group!(queue_benches, benches);
criterion_main!(queue_benches);
