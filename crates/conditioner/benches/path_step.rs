//! One `step` of the path conditioner in each form, with 1, 2, 4 and 8 constraints, and with the trap walk.
//!
//! Constraints are balls in three dimensions. The reference presses against all of them, so the forms do their work.

use criterion::{Criterion, criterion_group, criterion_main};
use slideway_conditioner::PathConditioner;
use slideway_conditioner::path::{
    Constraint, ConstraintSample, Margin, Motion, PathForm, PathSettings, Reserve, SwitchingLaw, TrapSettings, Walk,
};
use slideway_conditioner::shapes::{Ball, Ellipsoid, Side};
use std::hint::black_box;

const LAW: SwitchingLaw = SwitchingLaw::Normalised { amplitude: 1.6 };

fn settings<const M: usize>(form: PathForm, trap: Option<TrapSettings>) -> PathSettings<M> {
    PathSettings { sampling_period: 2e-4, push_cutoff: 20.0, approach: [0.05; M], margin: Margin::None, form, trap }
}

fn trap(walk: Walk) -> TrapSettings {
    TrapSettings {
        walk_cutoff: 20.0,
        pace_cutoff: 20.0,
        walk,
        walk_speed: 2.0,
        walk_growth: 0.0,
        return_gain: 5.0,
        direction_period: 0.1,
        distance_threshold: 0.05,
        clearance_threshold: 0.05,
        activity_threshold: 0.01,
        seed: 1,
    }
}

/// Large balls from below, their centres on a ring: near the top of their union all of them are felt.
fn balls<const M: usize>() -> [Ball<3>; M] {
    std::array::from_fn(|i| {
        let angle = std::f64::consts::TAU * i as f64 / M as f64;
        Ball::new([0.05 * angle.cos(), 0.05 * angle.sin(), -1.0], 1.0, Side::Outside).expect("a radius")
    })
}

fn forms<const M: usize>(c: &mut Criterion, sample: impl Fn(&[Ball<3>; M], &Motion<3>) -> [ConstraintSample<3>; M]) {
    let balls = balls::<M>();
    let reserve = Reserve::On { recovery_rate: 1.0 };
    for (name, form) in [
        ("explicit", PathForm::Sliding { law: LAW, reserve: Reserve::Off }),
        ("explicit-reserve", PathForm::Sliding { law: LAW, reserve }),
        ("appendix", PathForm::Appendix { law: LAW }),
        ("implicit", PathForm::Implicit { recovery_rate: 1.0 }),
    ] {
        let conditioner = PathConditioner::<3, M>::new(settings(form, None)).expect("valid settings");
        let mut state = conditioner.at_rest(&[0.0, 0.0, 0.02]).expect("finite");
        let reference = Motion { time: 0.0, position: [0.0, 0.0, -0.1], velocity: [0.0; 3] };
        // Into contact first: 1 s.
        for _ in 0..5000 {
            conditioner.step(&mut state, &reference, |m| sample(black_box(&balls), m));
        }
        c.bench_function(&format!("path-step/{name}/{M}"), |b| {
            b.iter(|| {
                // By reference: a caller uses the step where it was written, and does not copy it.
                let step =
                    conditioner.step(black_box(&mut state), black_box(&reference), |m| sample(black_box(&balls), m));
                black_box(&step);
            })
        });
    }
}

fn walks(c: &mut Criterion) {
    let shape = Ellipsoid::new([0.0; 3], &[8.0, 8.0, 0.1], 0.1, Side::Outside).expect("valid");
    for (name, walk, reserve) in [
        ("paper", Walk::Paper, Reserve::Off),
        ("safe", Walk::Safe { push_share: 0.4 }, Reserve::On { recovery_rate: 1.0 }),
    ] {
        let form = PathForm::Sliding { law: LAW, reserve };
        let conditioner = PathConditioner::<3, 1>::new(settings(form, Some(trap(walk)))).expect("valid settings");
        let reference = Motion { time: 0.0, position: [0.0, 0.0, -0.3], velocity: [0.0; 3] };
        let start = conditioner.at_rest(&[0.0, 0.0, 0.11]).expect("finite");
        let mut state = start;
        let mut count = 0_u32;
        c.bench_function(&format!("path-step/walk-{name}"), |b| {
            b.iter(|| {
                // Back to the start every second, so that every measured sample is one inside the trap.
                count = if count == 5000 { 0 } else { count + 1 };
                if count == 0 {
                    state = start;
                }
                let step = conditioner.step(black_box(&mut state), black_box(&reference), |m| [shape.sample(m)]);
                black_box(&step);
            })
        });
    }
}

fn counts(c: &mut Criterion) {
    forms::<1>(c, |[a], m| [a.sample(m)]);
    forms::<2>(c, |[a, b], m| [a.sample(m), b.sample(m)]);
    forms::<4>(c, |balls, m| balls.each_ref().map(|ball| ball.sample(m)));
    forms::<8>(c, |balls, m| balls.each_ref().map(|ball| ball.sample(m)));
}

criterion_group!(benches, counts, walks);
criterion_main!(benches);
