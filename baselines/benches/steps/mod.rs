//! The steps that are measured, for the benchmark and for the instruction counts alike.
//!
//! Constraints are balls in three dimensions, and the reference presses against all of them, so every method does its work:
//! the conditioner in each form, and the QP safety filter on the same push filter, constraints and reference, with a dense
//! active-set method and with Clarabel. Trap walks are measured before one ellipsoid.

#[path = "../../tests/oracles/conic_push.rs"]
mod conic_push;

use conic_push::ConicPush;
use slideway_baselines::safety_filter::{FilterSettings, QpFilter, SmallestPush, dense::DualActiveSet};
use slideway_conditioner::PathConditioner;
use slideway_conditioner::path::{
    Constraint, ConstraintSample, Margin, Motion, PathForm, PathSettings, Reserve, SwitchingLaw, TrapSettings, Walk,
};
use slideway_conditioner::shapes::{Ball, Ellipsoid, Side};
use std::hint::black_box;

const LAW: SwitchingLaw = SwitchingLaw::Normalised { amplitude: 1.6 };
const PERIOD: f64 = 2e-4;
const CUTOFF: f64 = 20.0;
const APPROACH: f64 = 0.05;

/// Where all steps start from, after the samples that bring them into contact: 0.4 s.
const SETTLING: u32 = 2000;

/// Outside of every ball.
const START: [f64; 3] = [0.0, 0.0, 0.02];

/// Deep inside the balls.
const PRESSING: Motion<3> = Motion { time: 0.0, position: [0.0, 0.0, -0.1], velocity: [0.0; 3] };

/// Measurement of one step: a bench's or an example's.
pub(crate) trait Meter {
    /// `prepare` brings the method into contact and gives its step.
    fn measure<S: FnMut()>(&mut self, name: &str, prepare: impl Fn() -> S);
}

/// Every step, method by method. The constraints are written out, as a caller would.
pub(crate) fn measure_all(meter: &mut impl Meter) {
    with_constraints(meter, |[a], m| [a.sample(m)]);
    with_constraints(meter, |[a, b], m| [a.sample(m), b.sample(m)]);
    with_constraints(meter, |[a, b, c, d], m| [a.sample(m), b.sample(m), c.sample(m), d.sample(m)]);
    with_constraints(meter, |[a, b, c, d, e, f, g, h], m| {
        [a.sample(m), b.sample(m), c.sample(m), d.sample(m), e.sample(m), f.sample(m), g.sample(m), h.sample(m)]
    });
    walk(meter, |[a], m| [a.sample(m)]);
    walk(meter, |[a, b], m| [a.sample(m), b.sample(m)]);
    walk(meter, |[a, b, c, d], m| [a.sample(m), b.sample(m), c.sample(m), d.sample(m)]);
    walk(meter, |[a, b, c, d, e, f, g, h], m| {
        [a.sample(m), b.sample(m), c.sample(m), d.sample(m), e.sample(m), f.sample(m), g.sample(m), h.sample(m)]
    });
}

fn settings<const M: usize>(form: PathForm, trap: Option<TrapSettings>) -> PathSettings<M> {
    PathSettings {
        sampling_period: PERIOD,
        push_cutoff: CUTOFF,
        approach: [APPROACH; M],
        margin: Margin::None,
        form,
        trap,
    }
}

/// Large balls from below, their centres on a ring: near the top of their union all of them are felt.
fn balls<const M: usize>() -> [Ball<3>; M] {
    std::array::from_fn(|i| {
        let angle = std::f64::consts::TAU * i as f64 / M as f64;
        Ball::new([0.05 * angle.cos(), 0.05 * angle.sin(), -1.0], 1.0, Side::Outside).expect("a radius")
    })
}

fn with_constraints<const M: usize>(
    meter: &mut impl Meter,
    sample: impl Fn(&[Ball<3>; M], &Motion<3>) -> [ConstraintSample<3>; M] + Copy,
) {
    let reserve = Reserve::On { recovery_rate: 1.0 };
    for (name, form) in [
        ("explicit", PathForm::Sliding { law: LAW, reserve: Reserve::Off }),
        ("explicit-reserve", PathForm::Sliding { law: LAW, reserve }),
        ("appendix", PathForm::Appendix { law: LAW }),
        ("implicit", PathForm::Implicit { recovery_rate: 1.0 }),
    ] {
        meter.measure(&format!("{name}/{M}"), || {
            let balls = balls::<M>();
            let conditioner = PathConditioner::<3, M>::new(settings(form, None)).expect("valid settings");
            let mut state = conditioner.at_rest(&START).expect("finite");
            for _ in 0..SETTLING {
                conditioner.step(&mut state, &PRESSING, |m| sample(&balls, m));
            }
            move || {
                // By reference: a caller uses the step where it was written, and does not copy it.
                black_box(
                    &conditioner.step(black_box(&mut state), black_box(&PRESSING), |m| sample(black_box(&balls), m)),
                );
            }
        });
    }
    meter.measure(&format!("qp-active-set/{M}"), || filter(DualActiveSet, sample));
    meter.measure(&format!("qp-clarabel/{M}"), || filter(ConicPush::new(), sample));
}

/// The filter has no start of its own: its reference comes in from outside the balls.
fn filter<const M: usize, S: SmallestPush>(
    solver: S,
    sample: impl Fn(&[Ball<3>; M], &Motion<3>) -> [ConstraintSample<3>; M] + Copy,
) -> impl FnMut() {
    let balls = balls::<M>();
    let settings = FilterSettings { period: PERIOD, cutoff: CUTOFF, approach: [APPROACH; M], rounds: 1 };
    let mut filter = QpFilter::<3, M, S>::new(settings, solver);
    let constraints = move |m: &Motion<3>| sample(black_box(&balls), m);
    for k in 0..SETTLING {
        let share = (f64::from(k) / 1000.0).min(1.0);
        let position = std::array::from_fn(|i| START[i] + share * (PRESSING.position[i] - START[i]));
        filter.step(&Motion { position, ..PRESSING }, constraints).expect("the balls have a common outside");
    }
    move || {
        black_box(&filter.step(black_box(&PRESSING), constraints)).as_ref().expect("solved");
    }
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

fn walk<const M: usize>(
    meter: &mut impl Meter,
    sample: impl Fn(&[Ellipsoid<3>; M], &Motion<3>) -> [ConstraintSample<3>; M] + Copy,
) {
    for (name, walk, reserve) in [
        ("walk-paper", Walk::Paper, Reserve::Off),
        ("walk-safe", Walk::Safe { push_share: 0.4 }, Reserve::On { recovery_rate: 1.0 }),
    ] {
        meter.measure(&format!("{name}/{M}"), || {
            // The first is felt; the others, farther down, make up the number.
            let shapes: [Ellipsoid<3>; M] = std::array::from_fn(|i| {
                Ellipsoid::new([0.0, 0.0, -0.01 * i as f64], &[8.0, 8.0, 0.1], 0.1, Side::Outside).expect("valid")
            });
            let form = PathForm::Sliding { law: LAW, reserve };
            let conditioner = PathConditioner::<3, M>::new(settings(form, Some(trap(walk)))).expect("valid settings");
            let reference = Motion { time: 0.0, position: [0.0, 0.0, -0.5], velocity: [0.0; 3] };
            let start = conditioner.at_rest(&[0.0, 0.0, 0.11]).expect("finite");
            let (mut state, mut count) = (start, 0_u32);
            move || {
                // Back to the start every second, so that every measured sample is one inside the trap.
                count = if count == 5000 { 0 } else { count + 1 };
                if count == 0 {
                    state = start;
                }
                black_box(
                    &conditioner.step(black_box(&mut state), black_box(&reference), |m| sample(black_box(&shapes), m)),
                );
            }
        });
    }
}
