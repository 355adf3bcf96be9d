//! Sampled paths for the tests of the offline optima.
#![allow(dead_code, reason = "every test file uses a part of it")]

pub(crate) mod every_kind;
mod numbers;

pub(crate) use numbers::Numbers;

use slideway_path::{EndRate, PathSample, SampledPath, SampledPiece};

/// A piece with ends by its limits.
pub(crate) fn one_piece(nodes: Vec<PathSample>, between: Vec<Vec<PathSample>>) -> SampledPiece {
    SampledPiece { nodes, between, is_self_motion: false, start: EndRate::ByLimits, end: EndRate::ByLimits }
}

/// One joint on a straight line of length `distance`: `q' = distance` per unit of `s`, `q'' = 0`.
pub(crate) fn straight(distance: f64, speed: f64, acceleration: f64, intervals: usize) -> SampledPath {
    let node = |k: usize| PathSample {
        s: k as f64 / intervals as f64,
        first: vec![distance],
        second: vec![0.0],
        ..PathSample::default()
    };
    SampledPath {
        joints: 1,
        speed_lower: vec![-speed],
        speed_upper: vec![speed],
        acceleration: Some(vec![acceleration]),
        pieces: vec![one_piece((0..=intervals).map(node).collect(), vec![])],
    }
}

/// A cubic spline through way-points at equal distances of the parameter, one row of values per way-point, with given
/// second derivatives.
#[derive(Clone)]
pub(crate) struct Spline {
    points: Vec<Vec<f64>>,
    /// Second derivatives by the knot number.
    bends: Vec<Vec<f64>>,
}

impl Spline {
    /// Natural: no bend at the ends. Thomas's algorithm on `m_{i-1} + 4 m_i + m_{i+1} = 6 (q_{i-1} - 2 q_i + q_{i+1})`.
    pub(crate) fn natural(points: Vec<Vec<f64>>) -> Self {
        let (count, joints) = (points.len(), points[0].len());
        let mut bends = vec![vec![0.0; joints]; count];
        for j in 0..joints {
            let (mut factor, mut value) = (vec![0.0; count], vec![0.0; count]);
            for i in 1..count - 1 {
                let right = 6.0 * (points[i - 1][j] - 2.0 * points[i][j] + points[i + 1][j]);
                let pivot = 4.0 - factor[i - 1];
                factor[i] = 1.0 / pivot;
                value[i] = (right - value[i - 1]) / pivot;
            }
            for i in (1..count - 1).rev() {
                bends[i][j] = value[i] - factor[i] * bends[i + 1][j];
            }
        }
        Self { points, bends }
    }

    /// Clamped at rest between two points: `q(u) = q0 + (3 u² - 2 u³)(q1 - q0)`.
    pub(crate) fn clamped(from: Vec<f64>, to: Vec<f64>) -> Self {
        let bend = |sign: f64| from.iter().zip(&to).map(|(a, b)| sign * 6.0 * (b - a)).collect();
        Self { bends: vec![bend(1.0), bend(-1.0)], points: vec![from, to] }
    }

    /// The sample at the share `u` of the whole, with `s = u · length`.
    pub(crate) fn at(&self, u: f64, length: f64) -> PathSample {
        let knots = (self.points.len() - 1) as f64;
        let i = ((u * knots) as usize).min(self.points.len() - 2);
        let t = u * knots - i as f64;
        let (q0, q1, m0, m1) = (&self.points[i], &self.points[i + 1], &self.bends[i], &self.bends[i + 1]);
        let rate = knots / length;
        let first = |j: usize| q1[j] - q0[j] - (2.0 * m0[j] + m1[j]) / 6.0 + m0[j] * t + 0.5 * (m1[j] - m0[j]) * t * t;
        PathSample {
            s: u * length,
            lambda: u,
            first: (0..q0.len()).map(|j| first(j) * rate).collect(),
            second: (0..q0.len()).map(|j| (m0[j] + (m1[j] - m0[j]) * t) * rate * rate).collect(),
            ..PathSample::default()
        }
    }

    /// A piece of equal intervals with samples between.
    pub(crate) fn piece(&self, intervals: usize, between: usize, length: f64) -> SampledPiece {
        let node = |k: usize| self.at(k as f64 / intervals as f64, length);
        let inner = |k: usize| {
            let share = |j: usize| (k as f64 + (j + 1) as f64 / (between + 1) as f64) / intervals as f64;
            (0..between).map(|j| self.at(share(j), length)).collect()
        };
        one_piece((0..=intervals).map(node).collect(), (0..intervals).map(inner).collect())
    }
}

/// A random natural spline through five way-points with speed limits of 0.5 to 3 rad/s and acceleration limits of 1 to 10 rad/s².
pub(crate) struct RandomSpline {
    pub(crate) spline: Spline,
    pub(crate) speed: Vec<f64>,
    pub(crate) acceleration: Vec<f64>,
}

impl RandomSpline {
    pub(crate) fn new(seed: u64, joints: usize) -> Self {
        let mut numbers = Numbers::new(seed);
        let mut list = |low: f64, high: f64| (0..joints).map(|_| numbers.between(low, high)).collect::<Vec<f64>>();
        let points = (0..5).map(|_| list(-1.5, 1.5)).collect();
        Self { spline: Spline::natural(points), speed: list(0.5, 3.0), acceleration: list(1.0, 10.0) }
    }

    pub(crate) fn sample(&self, intervals: usize, between: usize) -> SampledPath {
        SampledPath {
            joints: self.speed.len(),
            speed_lower: self.speed.iter().map(|v| -v).collect(),
            speed_upper: self.speed.clone(),
            acceleration: Some(self.acceleration.clone()),
            pieces: vec![self.spline.piece(intervals, between, 1.0)],
        }
    }
}

/// The largest violation of the path's own speed and acceleration limits at the nodes, at both ends of every interval, as a share
/// of the limit, by plain evaluation of `q̇ = q' √b` and `q̈ = q' s̈ + q'' b`.
pub(crate) fn violation_at_nodes(path: &SampledPath, piece: usize, b: &[f64]) -> f64 {
    let nodes = &path.pieces[piece].nodes;
    let mut worst = f64::NEG_INFINITY;
    for (node, b) in nodes.iter().zip(b) {
        worst = worst.max(path.slowness(node) * b.sqrt() - 1.0);
    }
    for (k, pair) in nodes.windows(2).enumerate() {
        let s_acceleration = (b[k + 1] - b[k]) / (2.0 * (pair[1].s - pair[0].s));
        for (node, b) in pair.iter().zip([b[k], b[k + 1]]) {
            for (i, limit) in path.acceleration.iter().flatten().enumerate() {
                let value = node.first[i] * s_acceleration + node.second[i] * b;
                worst = worst.max(value.abs() / limit - 1.0);
            }
            for limit in &node.limits {
                worst = worst.max(limit.excess(s_acceleration, b));
            }
        }
    }
    worst
}
