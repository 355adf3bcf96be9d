//! Random programs with every kind of row, in units from tiny to huge.

use super::{Numbers, RandomSpline};
use slideway_baselines::time_optimal::reachable_profile;
use slideway_path::{EndRate, LinearLimit, PathSample, SampledPath, SpeedLimit};

/// The limits of a random program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Speeds and symmetric accelerations.
    Accelerations,
    /// Torques with gravity of either sign.
    Torques,
    /// Torques with all but a thousandth of the gravity that a profile just bears.
    NearlyInfeasible,
    /// Accelerations of different size upwards and downwards.
    Asymmetric,
    /// A polygon of the tool's acceleration and its speed.
    Tool,
    /// Speed and acceleration limits that change along the path.
    Varying,
    /// Given rates at both ends.
    MovingEnds,
    /// Free ends.
    FreeEnds,
    /// Accelerations without speed limits that bind.
    AccelerationsAlone,
}

const KINDS: [Kind; 9] = [
    Kind::Accelerations,
    Kind::Torques,
    Kind::NearlyInfeasible,
    Kind::Asymmetric,
    Kind::Tool,
    Kind::Varying,
    Kind::MovingEnds,
    Kind::FreeEnds,
    Kind::AccelerationsAlone,
];

/// The kind and the path of a seed: 1 to 7 joints, units of 1e-6 to 1e6 per rad, a parameter of length 1e-4 to 1e4.
pub(crate) fn every_kind(seed: u64, intervals: usize, between: usize) -> (Kind, SampledPath) {
    let kind = KINDS[(seed / 7 % 9) as usize];
    let joints = 1 + (seed % 7) as usize;
    let mut numbers = Numbers::new(seed ^ 0x00c0_ffee);
    let (unit, length) = (10f64.powf(numbers.between(-6.0, 6.0)), 10f64.powf(numbers.between(-4.0, 4.0)));
    let random = RandomSpline::new(seed, joints);
    let mut path = random.sample(intervals, 0);
    path.pieces[0] = random.spline.piece(intervals, between, length);
    path.speed_lower.iter_mut().chain(&mut path.speed_upper).for_each(|v| *v *= unit);
    path.acceleration.iter_mut().flatten().for_each(|a| *a *= unit);
    each_sample(&mut path, |sample| sample.first.iter_mut().chain(&mut sample.second).for_each(|q| *q *= unit));
    match kind {
        Kind::Accelerations => {}
        Kind::Torques => path = torques(&path, seed, 0.8 * numbers.between(0.0, 1.0)),
        Kind::NearlyInfeasible => path = nearly_infeasible(&path, seed),
        Kind::Asymmetric => asymmetric(&mut path, &mut numbers),
        Kind::Tool => tool(&mut path, &mut numbers, unit),
        Kind::Varying => varying(&mut path, length),
        Kind::MovingEnds => moving_ends(&mut path, &mut numbers, length),
        Kind::FreeEnds => (path.pieces[0].start, path.pieces[0].end) = (EndRate::Free, EndRate::Free),
        Kind::AccelerationsAlone => {
            path.speed_lower.iter_mut().chain(&mut path.speed_upper).for_each(|v| *v *= 1e3);
        }
    }
    (kind, path)
}

fn each_sample(path: &mut SampledPath, mut change: impl FnMut(&mut PathSample)) {
    let piece = &mut path.pieces[0];
    piece.nodes.iter_mut().chain(piece.between.iter_mut().flatten()).for_each(&mut change);
}

/// Torque limits `inertia q̈ + gravity` instead of the acceleration limits, gravity as a share of the bound.
fn torques(path: &SampledPath, seed: u64, share: f64) -> SampledPath {
    let mut path = path.clone();
    let bounds = path.acceleration.take().unwrap_or_default();
    let phase = seed as f64;
    each_sample(&mut path, |sample| {
        for (joint, bound) in bounds.iter().enumerate() {
            let turn = 2.0 * joint as f64 + phase;
            let inertia = 1.0 + 0.3 * (2.0 * sample.lambda + turn).sin();
            let gravity = share * bound * (3.0 * sample.lambda + turn).cos();
            let coefficients = [inertia * sample.first[joint], inertia * sample.second[joint], gravity];
            sample.limits.push(LinearLimit::joint_torque(joint, coefficients, -bound, *bound));
        }
    });
    path
}

/// The gravity that a profile just bears, by bisection, less a thousandth.
fn nearly_infeasible(path: &SampledPath, seed: u64) -> SampledPath {
    let (mut bears, mut fails) = (0.0, 4.0);
    for _ in 0..12 {
        let share = 0.5 * (bears + fails);
        if reachable_profile(&torques(path, seed, share)).is_ok() { bears = share } else { fails = share }
    }
    torques(path, seed, 0.999 * bears)
}

fn asymmetric(path: &mut SampledPath, numbers: &mut Numbers) {
    let bounds = path.acceleration.take().unwrap_or_default();
    let bounds: Vec<[f64; 2]> =
        bounds.iter().map(|a| [-a * numbers.between(0.1, 1.0), a * numbers.between(0.1, 1.0)]).collect();
    each_sample(path, |sample| {
        for (joint, [lower, upper]) in bounds.iter().enumerate() {
            let (first, second) = (sample.first[joint], sample.second[joint]);
            sample.limits.push(LinearLimit::joint_acceleration(joint, first, second, *lower, *upper));
        }
    });
}

/// The first three joints taken for the tool's coordinates.
fn tool(path: &mut SampledPath, numbers: &mut Numbers, unit: f64) {
    let (speed, acceleration) = (unit * numbers.between(0.5, 3.0), unit * numbers.between(0.5, 5.0));
    each_sample(path, |sample| {
        let three = |values: &[f64]| [0, 1, 2].map(|i| values.get(i).copied().unwrap_or(0.0));
        let (first, second) = (three(&sample.first), three(&sample.second));
        sample.limits = LinearLimit::tool_acceleration(first, second, acceleration, 8);
        sample.speeds = vec![SpeedLimit::tool(first, speed)];
    });
}

fn varying(path: &mut SampledPath, length: f64) {
    let bounds = path.acceleration.take().unwrap_or_default();
    let speeds = path.speed_upper.clone();
    each_sample(path, |sample| {
        let wave = |joint: usize| 1.0 + 0.6 * (9.0 * sample.s / length + joint as f64).sin();
        for (joint, bound) in bounds.iter().enumerate() {
            let (first, second, bound) = (sample.first[joint], sample.second[joint], bound * wave(joint));
            sample.limits.push(LinearLimit::joint_acceleration(joint, first, second, -bound, bound));
            let speed = speeds[joint] * wave(joint + 3);
            sample.speeds.push(SpeedLimit::joint(joint, first, -speed, speed));
        }
    });
}

/// Up to half the rate that the speed limits and a tenth of the length at the acceleration limits leave.
fn moving_ends(path: &mut SampledPath, numbers: &mut Numbers, length: f64) {
    let bounds = path.acceleration.clone().unwrap_or_default();
    let rate = |path: &SampledPath, sample: &PathSample, share: f64| {
        let joints = bounds.iter().zip(&sample.first);
        let acceleration = joints.map(|(a, q)| a / q.abs()).fold(f64::INFINITY, f64::min);
        EndRate::Given(share * (1.0 / path.slowness(sample)).min((0.1 * length * acceleration).sqrt()))
    };
    let nodes = &path.pieces[0].nodes;
    let start = rate(path, &nodes[0], numbers.between(0.0, 0.5));
    let end = rate(path, &nodes[nodes.len() - 1], numbers.between(0.0, 0.5));
    (path.pieces[0].start, path.pieces[0].end) = (start, end);
}
