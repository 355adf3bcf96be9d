//! The motion that a profile on a grid is, by time.

use super::{ProfilePiece, TimeOptimum};

/// A profile on a grid by time.
#[derive(Clone, Debug)]
pub struct GridMotion<'a> {
    pieces: &'a [ProfilePiece],
    /// Time at the nodes of each piece since the start of motion, s.
    times: Vec<Vec<f64>>,
}

/// State of a motion along a sampled path at an instant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GridState {
    /// The piece, counted from 0.
    pub piece: usize,
    /// The piece's own parameter.
    pub s: f64,
    /// Its rate, 1/s.
    pub s_dot: f64,
    /// Its acceleration, 1/s²; constant between nodes.
    pub s_ddot: f64,
    /// Path parameter of the tool path.
    pub lambda: f64,
}

impl TimeOptimum {
    /// Its profile by time.
    #[must_use]
    pub fn motion(&self) -> GridMotion<'_> {
        let mut begin = 0.0;
        let mut times = Vec::new();
        for piece in &self.pieces {
            let piece_times: Vec<f64> = piece.times().iter().map(|t| begin + t).collect();
            begin = piece_times.last().copied().unwrap_or(begin);
            times.push(piece_times);
        }
        GridMotion { pieces: &self.pieces, times }
    }
}

impl GridMotion<'_> {
    /// Position, speed and acceleration along the path at a time since the start of motion, which is cut to the travel time; NaN counts as 0. Between nodes
    /// `s̈` is constant and limits may be exceeded ([`TimeOptimum::between`]).
    #[must_use]
    pub fn at_time(&self, time_s: f64) -> GridState {
        let time = if time_s > 0.0 { time_s } else { 0.0 };
        let begun = |times: &Vec<f64>| times.first().is_some_and(|first| *first <= time);
        let piece = self.times.partition_point(begun).saturating_sub(1);
        let (Some(profile), Some(times)) = (self.pieces.get(piece), self.times.get(piece)) else {
            return GridState::default();
        };
        let k = times.partition_point(|t| *t <= time).clamp(1, times.len() - 1) - 1;
        let (from, to, since) = (profile.s[k], profile.s[k + 1], (time - times[k]).min(times[k + 1] - times[k]));
        let rate = profile.b[k].sqrt();
        let s_ddot = (profile.b[k + 1] - profile.b[k]) / (2.0 * (to - from));
        let s = (from + (rate + 0.5 * s_ddot * since) * since).clamp(from, to);
        let share = (s - from) / (to - from);
        let lambda = profile.lambda[k] + share * (profile.lambda[k + 1] - profile.lambda[k]);
        GridState { piece, s, s_dot: (rate + s_ddot * since).max(0.0), s_ddot, lambda }
    }
}
