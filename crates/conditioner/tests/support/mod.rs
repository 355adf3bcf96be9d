//! The examples of [G12] section 9 as small simulations, shared by the integration tests.
#![allow(dead_code, unreachable_pub)]

use std::f64::consts::{PI, TAU};

use slideway_conditioner::PathConditioner;
use slideway_conditioner::path::{
    Constraint, ConstraintSample, Margin, Motion, PathForm, PathSettings, PathStep, Reserve, SwitchingLaw,
    TrapSettings, Walk, sample_all,
};
use slideway_conditioner::shapes::{Ball, BoothOval, Ellipsoid, HalfSpace, Side};

/// Commanded path rate of every example, rad/s.
pub const PATH_RATE: f64 = TAU / 5.0;

/// A path over `λ`: position and derivative.
pub type Path = fn(f64) -> ([f64; 3], [f64; 3]);

/// [G12] eq 28.
pub fn helix_beside_sphere(l: f64) -> ([f64; 3], [f64; 3]) {
    ([0.1 * l.sin(), 0.1 * (-0.75 - l.cos()), 0.1 * (3.44 - l)], [0.1 * l.cos(), 0.1 * l.sin(), -0.1])
}

/// [G12] eq 35.
pub fn helix(l: f64) -> ([f64; 3], [f64; 3]) {
    ([0.1 * l.cos(), 0.1 * l.sin(), 0.1 * (PI - l)], [-0.1 * l.sin(), 0.1 * l.cos(), -0.1])
}

/// [G12] eq 37.
pub fn wave(l: f64) -> ([f64; 3], [f64; 3]) {
    ([0.0, 0.1 * l.sin(), 0.1 * (PI - l)], [0.0, 0.1 * l.cos(), -0.1])
}

/// [G12] eq 29, [G12] eq 30.
pub fn plane_and_sphere(motion: &Motion<3>) -> [ConstraintSample<3>; 2] {
    let plane = HalfSpace::new(&[0.0, 1.0, 0.0], 0.0).expect("a unit normal");
    let sphere = Ball::new([0.0; 3], 0.05, Side::Outside).expect("a positive radius");
    sample_all(&[&plane, &sphere], motion)
}

fn ellipsoid_at(x: f64) -> Ellipsoid<3> {
    Ellipsoid::new([x, 0.0, 0.0], &[0.8, 0.8, 0.1], 0.1, Side::Outside).expect("positive semi-axes")
}

/// [G12] eq 36.
pub fn one_ellipsoid(motion: &Motion<3>) -> [ConstraintSample<3>; 1] {
    [ellipsoid_at(0.0).sample(motion)]
}

/// [G12] eq 38, [G12] eq 39.
pub fn two_ellipsoids(motion: &Motion<3>) -> [ConstraintSample<3>; 2] {
    [ellipsoid_at(-0.55).sample(motion), ellipsoid_at(0.55).sample(motion)]
}

/// [G12] eq 40.
pub fn booth_oval(motion: &Motion<3>) -> [ConstraintSample<3>; 1] {
    [BoothOval::new([1.0, 1.0, 0.3], 0.5, Side::Outside).expect("positive weights").sample(motion)]
}

/// Parameters of example 9.1.
pub fn first_example(period: f64, form: PathForm) -> PathSettings<2> {
    PathSettings {
        sampling_period: period,
        push_cutoff: 20.0,
        approach: [0.1; 2],
        margin: Margin::None,
        form,
        trap: None,
    }
}

/// Parameters of examples 9.2 to 9.4.
pub fn trap_example<const M: usize>(walk: Walk, walk_speed: f64, seed: u64) -> PathSettings<M> {
    PathSettings {
        sampling_period: 2e-4,
        push_cutoff: 20.0,
        approach: [0.05; M],
        margin: Margin::None,
        form: explicit(1.6),
        trap: Some(TrapSettings {
            walk_cutoff: 20.0,
            pace_cutoff: 20.0,
            walk,
            walk_speed,
            walk_growth: walk_speed,
            return_gain: 5.0,
            direction_period: 0.1,
            distance_threshold: 0.05,
            clearance_threshold: 0.05,
            activity_threshold: 0.01,
            seed,
        }),
    }
}

pub fn explicit(amplitude: f64) -> PathForm {
    PathForm::Sliding { law: SwitchingLaw::Normalised { amplitude }, reserve: Reserve::Off }
}

pub fn implicit() -> PathForm {
    PathForm::Implicit { recovery_rate: 1.0 }
}

/// Runs a conditioner along a path until the path is done or `limit` seconds are over; `look` sees every sample.
pub fn run<const M: usize>(
    settings: PathSettings<M>,
    path: Path,
    constraints: impl Fn(&Motion<3>) -> [ConstraintSample<3>; M],
    limit: f64,
    mut look: impl FnMut(&Motion<3>, &PathStep<3, M>),
) {
    let conditioner = PathConditioner::<3, M>::new(settings).expect("valid settings");
    let mut state = conditioner.on_reference();
    let mut clock = 0.0;
    let samples = (limit / settings.sampling_period).round() as u32;
    for k in 0..=samples {
        let (position, derivative) = path(PATH_RATE * clock);
        let rate = PATH_RATE * state.pace();
        let reference =
            Motion { time: f64::from(k) * settings.sampling_period, position, velocity: derivative.map(|d| d * rate) };
        let step = conditioner.step(&mut state, &reference, &constraints);
        look(&reference, &step);
        clock += step.advance;
        if PATH_RATE * clock > TAU {
            break;
        }
    }
}

pub fn distance(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum::<f64>().sqrt()
}
