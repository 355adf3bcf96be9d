use super::controllable::controllable;
use super::error::OptimumError;
use super::interval::{Direction, IntervalProgram};
use super::strip::{Place, Row, RowSource, Side, Strip, SymmetricBound, power_of_two};
use crate::outward::Outward;
use slideway_path::{EndRate, LimitKind, PathSample, SampledPath, SampledPiece};

/// The discretised problem of one piece.
///
/// Unknown: `x_k = b_k / unit_b` at the nodes. Minimise `Σ 2 h_k / (√x_k + √x_{k+1})` subject to the strips and
/// `0 <= x_k <= cap_k`, where `h_k = Δs_k / unit_s`. A time in these units is multiplied by [`PieceProgram::unit_time`] for
/// seconds. All units are powers of two, so nothing is rounded by the scaling; the largest cap is between 1/2 and 1 in a
/// program made by [`PieceProgram::new`], so the answer depends neither on the path's scale nor on the units of the limits.
#[derive(Clone, Debug, PartialEq)]
pub struct PieceProgram {
    /// Interval lengths.
    pub h: Vec<f64>,
    /// Upper bound of each unknown.
    pub cap: Vec<f64>,
    /// Both ends' values where they are given, `[start, end]`.
    pub given: [Option<f64>; 2],
    pub(super) strips: Vec<Strip>,
    /// Strips of interval `k` are `first[k]..first[k + 1]`.
    pub(super) first: Vec<usize>,
    pub(super) index: usize,
    /// Least value of the free nodes as a share of their caps: 0, unless a profile that stands still is to be avoided.
    floor_share: f64,
    unit_b: f64,
    unit_time: Outward,
}

/// A sample between nodes at which the limits are to hold as well: `between[interval][sample]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct ExtraSample {
    /// The interval, counted from 0.
    pub interval: usize,
    /// The sample in it, counted from 0.
    pub sample: usize,
}

impl PieceProgram {
    /// The program of piece `index` of a sampled path, without dimensions and with caps as low as the limits prove them.
    ///
    /// # Errors
    ///
    /// The piece does not move, a number is not usable, or no profile keeps the limits.
    pub fn new(path: &SampledPath, index: usize) -> Result<Self, OptimumError> {
        Self::sampled(path, index, &[])?.bounded(path)
    }

    /// The program in the path's own units, its caps those of the speed limits alone. `extra` samples, in order, are added
    /// to the rows.
    ///
    /// # Errors
    ///
    /// The piece does not move or a number is not usable.
    pub fn sampled(path: &SampledPath, index: usize, extra: &[ExtraSample]) -> Result<Self, OptimumError> {
        let piece = &path.pieces[index];
        check_finite(piece, index)?;
        if piece.nodes.len() < 2 || piece.nodes.windows(2).any(|w| !(w[1].s > w[0].s)) {
            return Err(OptimumError::NoMotion { piece: index });
        }
        let cap = speed_caps(path, piece);
        if !cap.iter().all(|c| c.is_finite() && *c > 0.0) {
            return Err(OptimumError::NoMotion { piece: index });
        }
        let mut program = Self {
            h: piece.nodes.windows(2).map(|w| w[1].s - w[0].s).collect(),
            cap,
            given: given_ends(path, piece, index)?,
            strips: Vec::new(),
            first: vec![0],
            index,
            floor_share: 0.0,
            unit_b: 1.0,
            unit_time: Outward::exact(1.0),
        };
        program.add_strips(path, piece, extra)?;
        program.give_ends(path, piece)?;
        Ok(program)
    }

    /// Lowers the caps to what is controllable and reachable, and scales everything to the largest of them.
    pub(super) fn bounded(mut self, path: &SampledPath) -> Result<Self, OptimumError> {
        let backward = controllable(&self, Direction::Backward).map_err(|e| e.describe(&self, path))?;
        self.cap = backward.proven_upper(&self, Direction::Backward);
        let forward = controllable(&self, Direction::Forward).map_err(|e| e.describe(&self, path))?;
        self.cap = forward.proven_upper(&self, Direction::Forward);
        let largest = self.cap.iter().copied().fold(0.0, f64::max);
        let length: f64 = self.h.iter().sum();
        self.rescale(2.0 * power_of_two(largest), power_of_two(length));
        Ok(self)
    }

    /// Strips of every interval: the nodes at both ends, then the extra samples.
    fn add_strips(
        &mut self,
        path: &SampledPath,
        piece: &SampledPiece,
        extra: &[ExtraSample],
    ) -> Result<(), OptimumError> {
        let everywhere: Vec<SymmetricBound> =
            path.acceleration.iter().flatten().map(|&bound| SymmetricBound::new(bound)).collect();
        self.strips.reserve(2 * (everywhere.len() + piece.nodes[0].limits.len()) * self.h.len());
        let mut extra = extra.iter().peekable();
        for interval in 0..self.h.len() {
            let half_inverse = 0.5 / self.h[interval];
            for (end, share) in [(0, 0.0), (1, 1.0)] {
                let source = Origin { node: interval + end, sample: 0 };
                self.add_sample(&everywhere, &piece.nodes[interval + end], Place { share, half_inverse }, source);
            }
            while let Some(point) = extra.next_if(|p| p.interval == interval) {
                let sample = &piece.between[interval][point.sample];
                let share = (sample.s - piece.nodes[interval].s) / self.h[interval];
                let source = Origin { node: interval, sample: point.sample + 1 };
                self.add_sample(&everywhere, sample, Place { share, half_inverse }, source);
                self.add_speed(path, sample, share, source);
            }
            self.first.push(self.strips.len());
        }
        match self.strips.iter().find(|strip| !strip.is_valid()) {
            Some(strip) => Err(OptimumError::NotFinite { piece: self.index, node: strip.source.node as usize }),
            None => Ok(()),
        }
    }

    fn add_sample(&mut self, everywhere: &[SymmetricBound], sample: &PathSample, place: Place, origin: Origin) {
        let joints = everywhere.iter().zip(sample.first.iter().zip(&sample.second)).enumerate();
        let moving = joints.filter(|(_, (_, (first, second)))| **first != 0.0 || **second != 0.0);
        self.strips.extend(moving.map(|(joint, (bound, (first, second)))| {
            bound.strip(*first, *second, place, origin.of(LimitKind::JointAcceleration, joint))
        }));
        let limits = sample.limits.iter();
        self.strips.extend(limits.map(|limit| Strip::new(limit, place, origin.of(limit.kind, limit.index))));
    }

    /// `b <= cap` at an extra sample, as a row.
    fn add_speed(&mut self, path: &SampledPath, sample: &PathSample, share: f64, origin: Origin) {
        let squared = path.slowness(sample).powi(2);
        let (kind, index) = path.tightest_speed(sample);
        if squared > 0.0 {
            // The row is scaled by the power of two next to the bound on b, so that its bound is of order 1.
            let scale = power_of_two(squared);
            let source = origin.of(kind, index);
            let upper = (scale / squared).next_down();
            self.strips.push(Strip {
                before: (1.0 - share) * scale,
                after: share * scale,
                lower: f64::NEG_INFINITY,
                upper,
                source,
            });
        }
    }

    /// Given values at the ends become the box there.
    fn give_ends(&mut self, path: &SampledPath, piece: &SampledPiece) -> Result<(), OptimumError> {
        for (given, node) in [(self.given[0], 0), (self.given[1], self.cap.len() - 1)] {
            let Some(b) = given else { continue };
            if !(b <= self.cap[node]) {
                let (kind, index) = path.tightest_speed(&piece.nodes[node]);
                let share = (b / self.cap[node]).sqrt() - 1.0;
                return Err(OptimumError::Infeasible {
                    piece: self.index,
                    node,
                    s: piece.nodes[node].s,
                    kind,
                    index,
                    share,
                    proven: true,
                });
            }
            self.cap[node] = b;
        }
        Ok(())
    }

    /// Changes units by powers of two.
    fn rescale(&mut self, unit_b: f64, unit_s: f64) {
        self.h.iter_mut().for_each(|h| *h /= unit_s);
        self.cap.iter_mut().for_each(|c| *c /= unit_b);
        self.given.iter_mut().flatten().for_each(|g| *g /= unit_b);
        for strip in &mut self.strips {
            strip.before *= unit_b;
            strip.after *= unit_b;
        }
        self.unit_time = Outward::exact(unit_s) / Outward::exact(unit_b).sqrt();
        self.unit_b = unit_b;
    }

    /// The same program with every free node's value at least a share of its cap.
    pub(super) fn above(&self, share: f64) -> Self {
        Self { floor_share: share, ..self.clone() }
    }

    /// The same program with every limit narrowed by a share of its half range and every cap by the same share.
    pub(super) fn narrowed(&self, share: f64) -> Self {
        let mut program = self.clone();
        for strip in &mut program.strips {
            let inset = share * strip.half_range();
            (strip.lower, strip.upper) = (strip.lower + inset, strip.upper - inset);
        }
        for k in self.free() {
            program.cap[k] *= 1.0 - share;
        }
        program
    }

    /// The same program from its end to its start: the same rows on the same intervals, in the opposite order.
    pub(super) fn reversed(&self) -> Self {
        let mut program = self.clone();
        program.h.reverse();
        program.cap.reverse();
        program.given.reverse();
        (program.strips, program.first) = (Vec::with_capacity(self.strips.len()), vec![0]);
        for interval in (0..self.h.len()).rev() {
            let swapped = |strip: &Strip| Strip { before: strip.after, after: strip.before, ..*strip };
            program.strips.extend(self.interval(interval).iter().map(swapped));
            program.first.push(program.strips.len());
        }
        program
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

    /// The nodes whose unknown is free, as a range: all of them but the ends with given values.
    #[must_use]
    pub fn free(&self) -> std::ops::Range<usize> {
        usize::from(self.given[0].is_some())..self.cap.len() - usize::from(self.given[1].is_some())
    }

    /// Least value of a node: what is given there, or 0, or the share of the cap asked for.
    #[must_use]
    pub fn floor(&self, node: usize) -> f64 {
        if self.free().contains(&node) { self.floor_share * self.cap[node] } else { self.cap[node] }
    }

    /// Number of rows.
    #[must_use]
    pub fn row_count(&self) -> usize {
        self.strips.iter().map(|s| usize::from(s.upper.is_finite()) + usize::from(s.lower.is_finite())).sum()
    }

    /// The rows, interval by interval: multipliers are in this order.
    pub fn rows(&self) -> impl Iterator<Item = Row> + '_ {
        (0..self.h.len()).flat_map(move |interval| {
            self.interval(interval)
                .iter()
                .flat_map(move |s| [s.row(interval, Side::Upper), s.row(interval, Side::Lower)])
                .flatten()
        })
    }

    /// True for the rows, by their number in [`PieceProgram::rows`], that form the borders of the intervals' polygons: with the caps they
    /// imply all others, so a solver needs no more. Rounding may leave out a row that touches the border; whoever uses the answer
    /// checks it against all rows.
    pub(super) fn border_rows(&self) -> Vec<bool> {
        let mut is_border = vec![false; self.strips.len() * 2];
        let mut interval_program = IntervalProgram::default();
        for k in 0..self.h.len() {
            let boxes = [[self.floor(k), self.cap[k]], [self.floor(k + 1), self.cap[k + 1]]];
            let strips = self.interval(k);
            if interval_program.load(strips, self.first[k], Direction::Backward, boxes[0], boxes[1]).is_err() {
                (self.first[k]..self.first[k + 1]).for_each(|i| is_border[2 * i..2 * i + 2].fill(true));
                continue;
            }
            for (strip, side) in interval_program.border(|i| self.strips[i].after) {
                is_border[2 * strip + usize::from(side == Side::Lower)] = true;
            }
        }
        let sides = |s: &Strip| [s.upper.is_finite(), s.lower.is_finite()];
        self.strips
            .iter()
            .flat_map(sides)
            .zip(is_border)
            .filter_map(|(is_row, border)| is_row.then_some(border))
            .collect()
    }

    /// The strips of one interval.
    pub(super) fn interval(&self, interval: usize) -> &[Strip] {
        &self.strips[self.first[interval]..self.first[interval + 1]]
    }

    /// The largest violation of a row by a profile, rounded up, as a share of the limit's half range; negative if none.
    #[must_use]
    pub fn largest_excess(&self, profile: &[f64]) -> f64 {
        let mut worst = f64::NEG_INFINITY;
        for (interval, ends) in profile.windows(2).enumerate() {
            for strip in self.interval(interval) {
                let overshoot = strip.overshoot(ends[0], ends[1]);
                // Division only where it changes the result; not a number counts as infinite.
                if !(overshoot <= worst * strip.half_range()) {
                    if overshoot.is_nan() {
                        return f64::INFINITY;
                    }
                    worst = overshoot / strip.half_range();
                }
            }
        }
        worst
    }
}

/// Where a row is taken.
#[derive(Clone, Copy)]
struct Origin {
    node: usize,
    sample: usize,
}

impl Origin {
    #[allow(clippy::cast_possible_truncation)]
    fn of(self, kind: LimitKind, index: usize) -> RowSource {
        RowSource { kind, index: index as u16, sample: self.sample as u16, node: self.node as u32 }
    }
}

fn check_finite(piece: &SampledPiece, index: usize) -> Result<(), OptimumError> {
    let finite = |n: &PathSample| n.s.is_finite() && n.first.iter().chain(&n.second).all(|x| x.is_finite());
    match piece.nodes.iter().position(|node| !finite(node)) {
        Some(node) => Err(OptimumError::NotFinite { piece: index, node }),
        None => Ok(()),
    }
}

/// `b` at the ends, where it is given.
fn given_ends(path: &SampledPath, piece: &SampledPiece, index: usize) -> Result<[Option<f64>; 2], OptimumError> {
    let given = |rate: EndRate, node: usize| match rate {
        EndRate::ByLimits => Ok(path.limits_acceleration(piece).then_some(0.0)),
        EndRate::Free => Ok(None),
        EndRate::Given(rate) if rate >= 0.0 && rate.is_finite() => Ok(Some(rate * rate)),
        EndRate::Given(_) => Err(OptimumError::NotFinite { piece: index, node }),
    };
    Ok([given(piece.start, 0)?, given(piece.end, piece.nodes.len() - 1)?])
}

/// A node at which the joints move at less than this share of both its neighbours' pace is a cusp.
///
/// At a cusp of the path (the joint path turns back) no joint moves and the speed limits leave `b` unbounded. Bounded as if the
/// joints moved at half the neighbours' pace, the intervals around it take two thirds of `c h²` where the exact time is half of it:
/// a difference of second order in the grid, in favour of nobody, and speed limits between the nodes are exceeded by up to
/// a fifth there instead of without bound.
const CUSP: f64 = 0.5;

/// Where whole intervals do not move the joints, as if they moved at this share of the fastest place of the piece.
const STANDSTILL: f64 = 1e-6;

/// `b <= 1 / max_i (q_i' / limit_i)²`; infinite if no joint moves anywhere along the piece. NaN stays NaN.
fn speed_caps(path: &SampledPath, piece: &SampledPiece) -> Vec<f64> {
    let slowness: Vec<f64> = piece.nodes.iter().map(|node| path.slowness(node)).collect();
    let floor = STANDSTILL * slowness.iter().copied().fold(0.0, f64::max);
    let neighbours = |k: usize| {
        let before = k.checked_sub(1).map_or(f64::INFINITY, |i| slowness[i]);
        before.min(slowness.get(k + 1).copied().unwrap_or(f64::INFINITY))
    };
    slowness
        .iter()
        .enumerate()
        .map(|(k, &s)| {
            let least = floor.max(CUSP * neighbours(k));
            if s < least { least.powi(-2) } else { s.powi(-2) }
        })
        .collect()
}
