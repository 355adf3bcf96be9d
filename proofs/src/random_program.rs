//! Small random time-optimal problems, and numbers that are none.

use slideway_path::{EndRate, PathSample, SampledPath, SampledPiece};

use crate::engine::Choices;

/// Any number a solver that has gone astray could print.
pub fn nonsense(choices: &mut Choices, size: f64) -> f64 {
    let ordinary = choices.between(-1.0, 1.0) * size;
    let wild = choices.bits();
    choices.pick([ordinary, ordinary, ordinary, 0.0, 1e300, -1e300, f64::INFINITY, f64::NEG_INFINITY, f64::NAN, wild])
}

/// Two joints, 4 to 9 nodes, speed limits and (in two cases of three) acceleration limits. The derivatives at the nodes are arbitrary: the
/// program does not ask whether a curve has them.
pub fn random_path(choices: &mut Choices) -> SampledPath {
    let nodes = 4 + choices.below(6);
    let mut s = 0.0;
    let samples: Vec<PathSample> = (0..nodes)
        .map(|_| {
            s += choices.between(0.05, 0.5);
            PathSample {
                s,
                lambda: s,
                first: vec![choices.between(0.1, 1.0), choices.between(-1.0, 1.0)],
                second: choices.numbers::<2>(-1.0, 1.0).to_vec(),
                ..PathSample::default()
            }
        })
        .collect();
    let size = choices.decade(-1.0, 2.0);
    let acceleration = (choices.below(3) > 0).then(|| vec![size, size * choices.between(0.3, 3.0)]);
    let speed = choices.numbers::<2>(0.2, 3.0).to_vec();
    path_of(samples, speed, acceleration, EndRate::ByLimits)
}

/// One piece with the same rate asked for at both ends.
#[must_use]
pub fn path_of(nodes: Vec<PathSample>, speed: Vec<f64>, acceleration: Option<Vec<f64>>, ends: EndRate) -> SampledPath {
    let between = vec![Vec::new(); nodes.len() - 1];
    SampledPath {
        joints: speed.len(),
        speed_lower: speed.iter().map(|v| -v).collect(),
        speed_upper: speed,
        acceleration,
        pieces: vec![SampledPiece { nodes, between, is_self_motion: false, start: ends, end: ends }],
    }
}
