//! One `step` of each form, six joints.

use criterion::{Criterion, criterion_group, criterion_main};
use slideway_conditioner::acceleration::{
    AccelerationLimits, AccelerationRegulator, AccelerationSettings, AccelerationState, LookAhead, LookAheadSettings,
    Preview, Recovery,
};
use slideway_conditioner::{
    Advance, AffineSpeed, ImplicitSpeedRegulator, Saturation, SpeedLimits, SpeedRegulator, SpeedSettings, SpeedState,
};
use std::hint::black_box;

fn settings(advance: Advance) -> SpeedSettings<6> {
    SpeedSettings {
        limits: SpeedLimits::symmetric([0.5; 6]).expect("positive limits"),
        sampling_period: 1e-3,
        bandwidth: 5.0,
        target_rate: 5.0,
        saturation: Saturation::DirectionPreserving,
        advance,
    }
}

fn explicit(c: &mut Criterion) {
    for (name, advance) in [("paper", Advance::Paper), ("synchronised", Advance::Synchronised)] {
        let regulator = SpeedRegulator::new(settings(advance)).expect("valid settings");
        let mut state = SpeedState::at_rest();
        c.bench_function(&format!("speed-step/{name}"), |b| {
            b.iter(|| {
                let f = state.factor();
                let desired = black_box([0.9 * f, -1.7 * f, 0.2 * f, 1.1 * f, -0.3 * f, 0.6 * f]);
                regulator.step(black_box(&mut state), &desired)
            })
        });
    }
}

fn implicit(c: &mut Criterion) {
    let regulator = ImplicitSpeedRegulator::new(settings(Advance::Paper)).expect("valid settings");
    let mut state = SpeedState::at_rest();
    let desired =
        AffineSpeed { feedback: [0.01, -0.02, 0.0, 0.0, 0.01, 0.0], feedforward: [0.9, -1.7, 0.2, 1.1, -0.3, 0.6] };
    c.bench_function("speed-step/implicit", |b| b.iter(|| regulator.step(black_box(&mut state), black_box(&desired))));
}

fn acceleration(c: &mut Criterion) {
    let (speed_limits, acceleration_limits) = (
        SpeedLimits::symmetric([0.5; 6]).expect("positive limits"),
        AccelerationLimits::symmetric([2.0; 6]).expect("positive limits"),
    );
    let regulator = AccelerationRegulator::new(AccelerationSettings {
        speed_limits,
        acceleration_limits,
        sampling_period: 1e-3,
        bandwidth: 5.0,
        target_rate: 5.0,
        recovery: Recovery::Braking { gain: 10.0 },
    })
    .expect("valid settings");
    let mut state = AccelerationState::at_rest();
    let desired =
        AffineSpeed { feedback: [0.01, -0.02, 0.0, 0.0, 0.01, 0.0], feedforward: [0.9, -1.7, 0.2, 1.1, -0.3, 0.6] };
    c.bench_function("speed-step/acceleration", |b| {
        b.iter(|| regulator.step(black_box(&mut state), black_box(&desired)))
    });
    let look_ahead = LookAhead::new(LookAheadSettings {
        speed_limits,
        acceleration_limits,
        sampling_period: 1e-3,
        target_rate: 5.0,
        margin: 0.05,
    })
    .expect("valid settings");
    for intervals in [16_u32, 64] {
        let nodes: Vec<[f64; 6]> = (0..=intervals)
            .map(|k| [0.3, -0.5, 0.1, 0.4, -0.2, 0.6].map(|v: f64| v * (0.1 * f64::from(k) + v).cos()))
            .collect();
        let preview = Preview { offset: 0.01, spacing: 0.025, path_speeds: &nodes };
        c.bench_function(&format!("look-ahead/{intervals}"), |b| {
            b.iter(|| look_ahead.greatest_rate(black_box(&preview)))
        });
    }
}

criterion_group!(benches, explicit, implicit, acceleration);
criterion_main!(benches);
