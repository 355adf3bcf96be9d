//! Speed limits alone: the optimum is the integral of the greatest slowness.
//!
//! ```text
//! T* = ∫ σ dx,   σ = max_i |q_x,i| / v_i,   b = 1 / σ²
//! ```
//!
//! No row couples one place to the next, so there is nothing to solve. On a part of a cell with joints' ways `Δq_i`
//!
//! ```text
//! max_i |Δq_i| / v_i  <=  ∫ σ  <=  length · max_j of the Bernstein coefficients of the joints' |q_x,i| / v_i
//! ```
//!
//! and where one joint turns nowhere and leaves the others behind everywhere its way over its limit is the integral exactly. The other parts, beside a change of
//! the slowest joint or of its sense, are halved; they shrink geometrically. Stalls and turning points cost nothing here: `b` has no bound there.

use std::collections::BinaryHeap;

use crate::outward::Outward;

use super::bernstein::Polynomial;
use super::bracket::{BracketOptions, StopReason};
use super::caps;
use super::cells::{Cell, Piece};
use super::path::JointLimits;
use super::profile::{Law, ProfileCell};
use super::refine::{PieceBracket, PieceGap, relative_gap};
use super::rows::LimitName;

/// A part of a cell with bounds of `∫ σ`.
struct Part {
    cell: Cell,
    lower: f64,
    upper: f64,
}

impl Part {
    fn new(cell: Cell, limits: &JointLimits) -> Self {
        let slowness = caps::slowness(&cell.derivative, limits);
        let length = Outward::exact(cell.length);
        let lower = (Outward::exact(slowness.mean.max(0.0)) * length).lo;
        let upper = match leader(&cell.derivative, limits) {
            Some(joint) => way(&cell.derivative[joint], limits.speed(joint), length),
            None => (Outward::exact(slowness.most) * length).hi,
        };
        Self { cell, lower, upper }
    }

    fn gap(&self) -> f64 {
        self.upper - self.lower
    }
}

impl PartialEq for Part {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}
impl Eq for Part {}
impl PartialOrd for Part {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Part {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.gap().total_cmp(&other.gap())
    }
}

/// The joint whose slowness is greatest everywhere on an interval and that does not turn there.
fn leader(joints: &[Polynomial], limits: &JointLimits) -> Option<usize> {
    let range = |j: usize| joints[j].absolute_range();
    let least = |j: usize| (range(j).0 / limits.speed(j)).next_down();
    let limited = || (0..joints.len()).filter(|j| limits.speed(*j).is_finite());
    let joint = limited().max_by(|a, b| least(*a).total_cmp(&least(*b)))?;
    // Another joint may be faster than the leader's least slowness and still nowhere faster than the leader: compare their difference.
    let behind = |j: usize| {
        let sign = joints[joint].coefficients()[0].signum();
        let lead = |e: f64| {
            let share = |(a, b): (&f64, &f64)| sign * a / limits.speed(joint) - e * b / limits.speed(j);
            let both = joints[joint].coefficients().iter().zip(joints[j].coefficients());
            let size = joints[joint].largest() / limits.speed(joint) + joints[j].largest() / limits.speed(j);
            let radius = joints[joint].radius / limits.speed(joint) + joints[j].radius / limits.speed(j);
            // Three roundings of terms no larger than the sum of sizes; radii twice, for their own.
            both.map(share).fold(f64::INFINITY, f64::min) - 4.0 * f64::EPSILON * size - 2.0 * radius > 0.0
        };
        j == joint || lead(1.0) && lead(-1.0)
    };
    (least(joint) > 0.0 && limited().all(behind)).then_some(joint)
}

/// Upper bound of a joint's way over its limit. A mean of at most 10 numbers: below 10 epsilon of the largest.
fn way(q: &Polynomial, limit: f64, length: Outward) -> f64 {
    let count = (q.degree() + 1) as f64;
    let sum: f64 = q.coefficients().iter().sum();
    let mean = (sum.abs() / count + 12.0 * f64::EPSILON * q.largest() + q.radius).next_up().next_up();
    (Outward::exact(mean) * length / Outward::exact(limit)).hi
}

/// Brackets one piece under speed limits alone.
pub(crate) fn bracket(piece: Piece, limits: &JointLimits, options: &BracketOptions, most: usize) -> PieceBracket {
    let mut heap: BinaryHeap<Part> = piece.cells.into_iter().map(|cell| Part::new(cell, limits)).collect();
    let sums =
        |heap: &BinaryHeap<Part>| heap.iter().fold((0.0, 0.0), |(lower, gap), p| (lower + p.lower, gap + p.gap()));
    let (mut lower, mut gap) = sums(&heap);
    // A tenth of what is asked for, since it is nearly free; the sums here only steer.
    while gap > 0.1 * options.gap * lower && heap.len() < most {
        let Some(part) = heap.pop() else { break };
        (lower, gap) = (lower - part.lower, gap - part.gap());
        for cell in part.cell.halves() {
            let half = Part::new(cell, limits);
            (lower, gap) = (lower + half.lower, gap + half.gap());
            heap.push(half);
        }
        if part.gap() <= 1e-15 * lower {
            break;
        }
    }
    finished(heap.into_vec(), limits, options, most)
}

fn finished(mut parts: Vec<Part>, limits: &JointLimits, options: &BracketOptions, most: usize) -> PieceBracket {
    parts.sort_by(|a, b| a.cell.place.at(0.0).0.total_cmp(&b.cell.place.at(0.0).0));
    let sum = |of: fn(&Part) -> f64| parts.iter().fold(Outward::ZERO, |sum, p| sum + Outward::exact(of(p)));
    let (lower, upper) = (sum(|p| p.lower), sum(|p| p.upper));
    let reached = relative_gap(lower.lo, upper.hi) <= options.gap;
    let stop = if reached {
        StopReason::GapReached
    } else if parts.len() >= most {
        StopReason::CellsSpent
    } else {
        StopReason::NoProgress
    };
    let speed = |p: &Part| leader(&p.cell.derivative, limits).map(|joint| LimitName::Speed { joint });
    let gaps = parts
        .iter()
        .map(|p| PieceGap {
            from: p.cell.place.at(0.0).0,
            to: p.cell.place.at(p.cell.length).0,
            gap: p.gap(),
            limit: speed(p),
        })
        .collect();
    let cells = parts.len();
    let profile = parts.into_iter().map(|p| profile_cell(p.cell, limits)).collect();
    PieceBracket { lower, upper, profile, gaps, cells, rounds: 1, stop }
}

fn profile_cell(cell: Cell, limits: &JointLimits) -> ProfileCell {
    let joints = cell.derivative.into_iter().enumerate().map(|(j, q)| (q, limits.speed(j))).collect();
    ProfileCell { place: cell.place, length: cell.length, law: Law::Slowness(joints) }
}
