use super::error::OptimumError;
use crate::outward::Outward;
use slideway_lab::{PathSample, SampledPath, SampledPiece};

/// The discretised problem of one piece, without dimensions.
///
/// Unknown: `x_k = b_k / unit_b` at the nodes. Minimise `Σ 2 h_k / (√x_k + √x_{k+1})` subject to the rows and
/// `0 <= x_k <= cap_k`, where `h_k = Δs_k / S`. A time in these units is multiplied by [`PieceProgram::unit_time`]
/// for seconds. The largest cap is 1, so the answer depends neither on the path's scale nor on the units of the limits.
#[derive(Clone, Debug, PartialEq)]
pub struct PieceProgram {
    /// Interval lengths as shares of the piece.
    pub h: Vec<f64>,
    /// Upper bound of each unknown: speed limits, tightened by what the accelerations can reach from the ends.
    pub cap: Vec<f64>,
    /// Acceleration rows, scaled to a right-hand side of 1.
    pub rows: Vec<Row>,
    /// Whether the piece begins and ends at rest (`x = 0`).
    pub rests: bool,
    unit_b: f64,
    unit_time: Outward,
}

/// One row: `before · x_k + after · x_{k+1} <= 1`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// The interval `k`.
    pub interval: usize,
    /// Coefficient of `x_k`.
    pub before: f64,
    /// Coefficient of `x_{k+1}`.
    pub after: f64,
    /// Where it comes from.
    pub source: RowSource,
}

/// The limit behind a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RowSource {
    /// Joint, counted from 0.
    pub joint: usize,
    /// Node at which the acceleration is taken.
    pub node: usize,
}

impl PieceProgram {
    /// The program of piece `index` of a sampled path.
    ///
    /// # Errors
    ///
    /// The piece does not move, or a derivative is not finite.
    pub fn new(path: &SampledPath, index: usize) -> Result<Self, OptimumError> {
        let piece = &path.pieces[index];
        check_finite(piece, index)?;
        let length = piece.nodes[piece.nodes.len() - 1].s - piece.nodes[0].s;
        let steps: Vec<f64> = piece.nodes.windows(2).map(|w| w[1].s - w[0].s).collect();
        let raw_rows = acceleration_rows(path, piece, &steps);
        let rests = path.acceleration.is_some();
        let raw_caps = tighten(&speed_caps(path, piece), &raw_rows, rests);
        let unit_b = raw_caps.iter().copied().filter(|c| c.is_finite()).fold(0.0, f64::max);
        if raw_caps.iter().any(|c| !c.is_finite()) || !(unit_b > 0.0) || !(length > 0.0) {
            return Err(OptimumError::NoMotion { piece: index });
        }
        let scale = |row: &Row| Row { before: row.before * unit_b, after: row.after * unit_b, ..*row };
        Ok(Self {
            h: steps.iter().map(|s| s / length).collect(),
            cap: raw_caps.iter().map(|c| (c / unit_b).next_up()).collect(),
            rows: raw_rows.iter().map(scale).collect(),
            rests,
            unit_b,
            unit_time: Outward::exact(length) / Outward::exact(unit_b).sqrt(),
        })
    }

    /// Seconds per unit of the program's time.
    #[must_use]
    pub fn unit_time(&self) -> Outward {
        self.unit_time
    }

    /// `b = ṡ²` in the piece's own units.
    #[must_use]
    pub fn in_units(&self, x: &[f64]) -> Vec<f64> {
        x.iter().map(|x| x * self.unit_b).collect()
    }

    /// The nodes whose unknown is free, as a range: all of them, or all but the ends at rest.
    #[must_use]
    pub fn free(&self) -> std::ops::Range<usize> {
        if self.rests { 1..self.cap.len() - 1 } else { 0..self.cap.len() }
    }
}

fn check_finite(piece: &SampledPiece, index: usize) -> Result<(), OptimumError> {
    let finite = |n: &PathSample| n.first.iter().chain(&n.second).all(|x| x.is_finite());
    match piece.nodes.iter().position(|node| !finite(node)) {
        Some(node) => Err(OptimumError::NotFinite { piece: index, node }),
        None => Ok(()),
    }
}

/// Where no joint moves (a cusp of the path) the speed limits leave `b` unbounded. There it is bounded as if the joints moved
/// at this share of the fastest place of the piece: what a grid of a thousand intervals resolves.
const CUSP: f64 = 1e-3;

/// `b <= 1 / max_i (q_i' / limit_i)²`; infinite if no joint moves anywhere along the piece.
fn speed_caps(path: &SampledPath, piece: &SampledPiece) -> Vec<f64> {
    let slowness: Vec<f64> = piece.nodes.iter().map(|node| path.slowness(node)).collect();
    let floor = CUSP * slowness.iter().copied().fold(0.0, f64::max);
    slowness.iter().map(|s| s.max(floor).powi(-2)).collect()
}

/// `|q' s̈ + q'' b| <= a` at both ends of every interval, scaled to a right-hand side of 1.
fn acceleration_rows(path: &SampledPath, piece: &SampledPiece, steps: &[f64]) -> Vec<Row> {
    let Some(limits) = &path.acceleration else { return Vec::new() };
    let mut rows = Vec::with_capacity(4 * limits.len() * steps.len());
    for (interval, (pair, step)) in piece.nodes.windows(2).zip(steps).enumerate() {
        for (end, node) in pair.iter().enumerate() {
            for (joint, limit) in limits.iter().enumerate() {
                let slope = node.first[joint] / (2.0 * step * limit);
                let bend = node.second[joint] / limit;
                let (before, after) = if end == 0 { (bend - slope, slope) } else { (-slope, slope + bend) };
                if before == 0.0 && after == 0.0 {
                    continue;
                }
                let source = RowSource { joint, node: interval + end };
                rows.push(Row { interval, before, after, source });
                rows.push(Row { interval, before: -before, after: -after, source });
            }
        }
    }
    rows
}

/// Lowers the caps to what single rows allow from the ends at rest inwards.
///
/// From `before · x + after · y <= 1` with `0 <= x <= cap` follows `y <= (1 + max(0, -before) cap) / after` for
/// `after > 0`, and the same from the other end. Every feasible profile satisfies the result, which is all that the
/// certificate needs; on tiny paths it is what keeps the box, and so the gap, small.
fn tighten(caps: &[f64], rows: &[Row], rests: bool) -> Vec<f64> {
    let mut caps = caps.to_vec();
    let last = caps.len() - 1;
    if rests {
        (caps[0], caps[last]) = (0.0, 0.0);
    }
    let reach = |slope_here: f64, slope_other: f64, cap_other: f64| {
        let room = Outward::exact(1.0) + Outward::exact((-slope_other).max(0.0)) * Outward::exact(cap_other);
        (room / Outward::exact(slope_here)).hi
    };
    for row in rows {
        if row.after > 0.0 && caps[row.interval].is_finite() {
            caps[row.interval + 1] = caps[row.interval + 1].min(reach(row.after, row.before, caps[row.interval]));
        }
    }
    for row in rows.iter().rev() {
        if row.before > 0.0 && caps[row.interval + 1].is_finite() {
            caps[row.interval] = caps[row.interval].min(reach(row.before, row.after, caps[row.interval + 1]));
        }
    }
    caps
}
