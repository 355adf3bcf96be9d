//! A speed profile along a path: `b` as a quadratic in every cell, or as much speed as the speed limits leave.

use super::bernstein::Polynomial;
use super::caps::slope_at;
use super::cell_time::plain_cell_time;
use super::cells::Place;
use super::polish::{POINTS, WEIGHTS};

/// `b = (dx/dt)²` in a cell.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Law {
    /// Bernstein coefficients of a quadratic.
    Quadratic([f64; 3]),
    /// The inverse square of the greatest slowness, from `dq/dx` and the speed limit of each joint.
    Slowness(Vec<(Polynomial, f64)>),
}

/// One cell of a profile.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ProfileCell {
    pub(crate) place: Place,
    pub(crate) length: f64,
    pub(crate) law: Law,
}

/// Motion along a path by time: the profile whose travel time is the upper bound. Times are summed in plain arithmetic.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Profile {
    cells: Vec<ProfileCell>,
    /// Time at the begin of each cell, and at the end.
    starts: Vec<f64>,
}

/// State of a motion at an instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathState {
    /// Path parameter.
    pub s: f64,
    /// Its rate, 1/s.
    pub s_dot: f64,
    /// Its acceleration, 1/s².
    pub s_ddot: f64,
}

/// Steps of the search for a place in a cell.
const STEPS: usize = 60;

impl Profile {
    pub(crate) fn new(cells: Vec<ProfileCell>) -> Self {
        let mut starts = vec![0.0];
        for cell in &cells {
            starts.push(starts[starts.len() - 1] + cell.time_until(1.0));
        }
        Self { cells, starts }
    }

    /// Number of cells.
    #[must_use]
    pub fn len(&self) -> usize {
        self.cells.len()
    }

    /// Whether there is no cell.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.cells.is_empty()
    }

    /// Travel time, s.
    #[must_use]
    pub fn duration_s(&self) -> f64 {
        self.starts.last().copied().unwrap_or(0.0)
    }

    /// Position, speed and acceleration along the path at a time, which is cut to the travel time; NaN counts as 0. Under speed limits alone the
    /// rate is infinite where the path stands.
    #[must_use]
    pub fn at_time(&self, time_s: f64) -> PathState {
        let time = if time_s > 0.0 { time_s.min(self.duration_s()) } else { 0.0 };
        let k = self.starts.partition_point(|start| *start <= time).clamp(1, self.cells.len().max(1)) - 1;
        let Some(cell) = self.cells.get(k) else { return PathState { s: 0.0, s_dot: 0.0, s_ddot: 0.0 } };
        cell.state(cell.place_at(time - self.starts[k]))
    }

    /// Time at which each cell begins, and the end, s.
    #[must_use]
    pub fn cell_times(&self) -> &[f64] {
        &self.starts
    }
}

impl ProfileCell {
    /// Time from the cell's begin to its share `t`.
    fn time_until(&self, t: f64) -> f64 {
        match &self.law {
            _ if !(t > 0.0) => 0.0,
            Law::Quadratic(b) => plain_cell_time(self.length * t, until(b, t)),
            Law::Slowness(joints) => {
                let point = |(p, w): (&f64, &f64)| w * greatest(joints, p * t).0;
                POINTS.iter().zip(&WEIGHTS).map(point).sum::<f64>() * self.length * t
            }
        }
    }

    /// `b` and `u = b'/2` at a share of the cell.
    fn rate_at(&self, t: f64) -> (f64, f64) {
        match &self.law {
            Law::Quadratic(b) => {
                let [b0, m, b1] = *b;
                (until(b, t)[2], ((m - b0) * (1.0 - t) + (b1 - m) * t) / self.length)
            }
            Law::Slowness(joints) => {
                let (slowness, slope) = greatest(joints, t);
                (1.0 / (slowness * slowness), -slope / self.length / (slowness * slowness * slowness))
            }
        }
    }

    /// The share `t` of the cell that is passed after a time: Newton's method, kept in a shrinking bracket.
    fn place_at(&self, time: f64) -> f64 {
        let (mut low, mut high) = (0.0, 1.0);
        let mut t = (time / self.time_until(1.0)).clamp(0.0, 1.0);
        for _ in 0..STEPS {
            let error = self.time_until(t) - time;
            if error > 0.0 {
                high = t
            } else {
                low = t
            }
            let next = t - error * self.rate_at(t).0.sqrt() / self.length;
            let next = if next >= low && next <= high { next } else { 0.5 * (low + high) };
            if (next - t).abs() <= 1e-16 {
                break;
            }
            t = next;
        }
        t
    }

    /// `ṡ = s_x √b` and `s̈ = s_x u + s_xx b`.
    fn state(&self, t: f64) -> PathState {
        let (b, u) = self.rate_at(t);
        let (s, first, second) = self.place.at(t * self.length);
        PathState { s, s_dot: first * b.max(0.0).sqrt(), s_ddot: first * u + second * b }
    }
}

/// Bernstein coefficients of a quadratic from 0 to `t`, by de Casteljau; the last one is its value at `t`.
fn until(b: &[f64; 3], t: f64) -> [f64; 3] {
    let [b0, m, b1] = *b;
    let (first, second) = (b0 + t * (m - b0), m + t * (b1 - m));
    [b0, first, first + t * (second - first)]
}

/// The greatest slowness at `t` and its derivative by `t`.
fn greatest(joints: &[(Polynomial, f64)], t: f64) -> (f64, f64) {
    let mut best = (0.0, 0.0);
    for (q, limit) in joints {
        let value = q.at(t) / limit;
        if value.abs() > best.0 {
            best = (value.abs(), value.signum() * slope_at(q, t) / limit);
        }
    }
    best
}
