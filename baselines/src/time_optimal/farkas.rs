use super::controllable::Ranges;
use super::error::OptimumError;
use super::interval::{Clash, Direction, Extreme, Line, Reason, bounding_side};
use super::piece::PieceProgram;
use super::strip::{RowSource, Side};
use crate::outward::Outward;
use slideway_path::SampledPath;

/// A proof that no profile keeps the rows: multipliers `μ >= 0` whose combination `μ·A x <= μ·c` fails everywhere in the box.
///
/// Collected by going back through the eliminations that led to an empty range: each bound of a range is a combination of two
/// rows and of the neighbour's bounds.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Infeasibility {
    interval: usize,
    rows: Vec<Multiplier>,
}

/// A row with its multiplier.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Multiplier {
    strip: usize,
    side: Side,
    interval: usize,
    weight: f64,
}

/// Goes through the intervals from the empty one towards the end that the sweep came from.
struct Unrolling<'a> {
    program: &'a PieceProgram,
    direction: Direction,
    interval: usize,
    rows: Vec<Multiplier>,
    /// Weights of the neighbour's bounds, low and high, still to be accounted for.
    neighbour: [f64; 2],
}

impl Infeasibility {
    pub(super) fn new(
        program: &PieceProgram,
        ranges: &Ranges,
        interval: usize,
        direction: Direction,
        clash: Clash,
    ) -> Self {
        let mut unrolling = Unrolling { program, direction, interval, rows: Vec::new(), neighbour: [0.0; 2] };
        match clash {
            Clash::Row(strip, side) => unrolling.row(strip, side, 1.0),
            Clash::Bounds { low, high } => {
                unrolling.reason(low, 1.0);
                unrolling.reason(high, 1.0);
            }
            Clash::Pair { low, high, bound } => {
                let slope = unrolling.pair(low, high, 1.0);
                unrolling.reason(bound, slope.abs());
            }
        }
        unrolling.follow(ranges);
        Self { interval, rows: unrolling.rows }
    }

    /// By how much the combination fails, in the least: `min over the box of (Aᵀμ)·x - μ·c`, rounded down. Positive: proven.
    fn margin(&self, program: &PieceProgram) -> f64 {
        let mut coefficients = std::collections::BTreeMap::new();
        let mut margin = Outward::ZERO;
        for multiplier in &self.rows {
            let Some(row) = program.strips[multiplier.strip].row(multiplier.interval, multiplier.side) else {
                return f64::NEG_INFINITY;
            };
            let mu = Outward::exact(multiplier.weight.max(0.0));
            margin = margin - mu * Outward::exact(row.bound);
            for (node, value) in [(row.interval, row.before), (row.interval + 1, row.after)] {
                let sum = coefficients.entry(node).or_insert(Outward::ZERO);
                *sum = *sum + mu * Outward::exact(value);
            }
        }
        for (node, c) in coefficients {
            let (at_floor, at_cap) = (c * Outward::exact(program.floor(node)), c * Outward::exact(program.cap[node]));
            margin = margin + Outward { lo: at_floor.lo.min(at_cap.lo), hi: at_floor.hi.min(at_cap.hi) };
        }
        margin.lo
    }

    /// In the terms of the path: the row that matters most, and by which share of their range all rows of the proof would have to
    /// give way at the least.
    pub(super) fn describe(&self, program: &PieceProgram, path: &SampledPath) -> OptimumError {
        let margin = self.margin(program);
        let half_range = |m: &Multiplier| m.weight * program.strips[m.strip].half_range();
        let give_way: f64 = self.rows.iter().map(half_range).sum();
        // A limit that rest itself breaks is to blame before one that is only too tight for the rest of the path.
        let short_at_rest = |m: &Multiplier| {
            let strip = &program.strips[m.strip];
            let bound = if m.side == Side::Upper { strip.upper } else { -strip.lower };
            m.weight * (-bound).max(0.0)
        };
        let by = |f: &dyn Fn(&Multiplier) -> f64| {
            self.rows.iter().max_by(|a, b| f(a).total_cmp(&f(b))).filter(|m| f(m) > 0.0)
        };
        let blamed = by(&short_at_rest).or_else(|| by(&half_range));
        let source = blamed.map_or_else(|| self.place(program), |m| program.strips[m.strip].source);
        let piece = &path.pieces[program.index];
        let node = source.node as usize;
        let s = match source.sample {
            0 => piece.nodes[node].s,
            j => piece.between[node][usize::from(j) - 1].s,
        };
        OptimumError::Infeasible {
            piece: program.index,
            node,
            s,
            kind: source.kind,
            index: usize::from(source.index),
            share: (margin / give_way).max(0.0),
            proven: margin > 0.0,
        }
    }

    fn place(&self, program: &PieceProgram) -> RowSource {
        program.interval(self.interval)[0].source
    }
}

impl Unrolling<'_> {
    fn row(&mut self, strip: usize, side: Side, weight: f64) {
        if weight > 0.0 {
            self.rows.push(Multiplier { strip, side, interval: self.interval, weight });
        }
    }

    fn slope(&self, line: Line) -> f64 {
        match line {
            Line::Neighbour => 0.0,
            Line::Strip(index) => {
                let (near, far) = self.direction.coefficients(&self.program.strips[index]);
                -near / far
            }
        }
    }

    fn line(&mut self, line: Line, which: Extreme, weight: f64) {
        match line {
            Line::Neighbour => self.neighbour[usize::from(which == Extreme::Greatest)] += weight,
            Line::Strip(index) => {
                let (_, far) = self.direction.coefficients(&self.program.strips[index]);
                self.row(index, bounding_side(far, which), weight / far.abs());
            }
        }
    }

    /// Adds `weight · ((p_low - p_high) x <= q_high - q_low)`; returns the slope `p_low - p_high`.
    fn pair(&mut self, low: Line, high: Line, weight: f64) -> f64 {
        self.line(low, Extreme::Least, weight);
        self.line(high, Extreme::Greatest, weight);
        self.slope(low) - self.slope(high)
    }

    /// Adds `weight` times a bound on `x`.
    fn reason(&mut self, reason: Reason, weight: f64) {
        if !(weight > 0.0) {
            return;
        }
        match reason {
            Reason::Box => {}
            Reason::Row(index, side) => {
                let (near, far) = self.direction.coefficients(&self.program.strips[index]);
                self.row(index, side, weight / near.abs());
                // What the row has of `y` was taken at the end of its range that leaves most.
                let grows = (far > 0.0) == (side == Side::Upper);
                self.neighbour[usize::from(!grows)] += weight * (far / near).abs();
            }
            Reason::Pair { low, high } => {
                let slope = (self.slope(low) - self.slope(high)).abs();
                let _ = self.pair(low, high, weight / slope);
            }
        }
    }

    /// Replaces the neighbour's bounds by what they were derived from, interval by interval.
    fn follow(&mut self, ranges: &Ranges) {
        let last = self.program.h.len() - 1;
        while self.neighbour != [0.0; 2] {
            let node = match self.direction {
                Direction::Backward => self.interval + 1,
                Direction::Forward => self.interval,
            };
            let weights = std::mem::take(&mut self.neighbour);
            match self.direction {
                Direction::Backward if self.interval < last => self.interval += 1,
                Direction::Forward if self.interval > 0 => self.interval -= 1,
                // The bounds of the last node are its box.
                _ => return,
            }
            let [low, high] = ranges.reasons[node];
            self.reason(low, weights[0]);
            self.reason(high, weights[1]);
        }
    }
}
