//! A path as cells, in a parameter `x` in which nothing is singular.
//!
//! From a rest end `b = ds/dt²` grows like `s`, and its best multipliers like `s^(-1/2)`: polynomials in `s` follow neither. Near such an end
//!
//! ```text
//! s = x² / (2 l),   q_x = q'(s) x / l,   b_x = (dx/dt)² = b / (ds/dx)²
//! ```
//!
//! with `l` twice the stretch's length, so that `ds/dx = 1` where it meets the rest of the path. There `q_x = 0` at the end and `b_x` is an
//! ordinary positive number. A path of degree `d` has degree `2 d` in `x`. Where `q'` is 0 at a rest end already, `s` itself is such a parameter.
//!
//! **The cells define the path that is bracketed.** The Bernstein coefficients of `q_x` in the first cells are the numbers stored,
//! exactly, and neighbours share the one at their node: `q_x` is continuous without a rounding error to charge for. They differ from the input by
//! a few units in the last place of the largest `q_x` of a cell; jumps of `q'` at knots below 1e-9 of it count as rounding and are closed, and a `q'` of less
//! than that at a rest end counts as 0. Halves of cells are enclosed with a radius.

use super::bernstein::Polynomial;
use super::error::BracketError;
use super::path::{End, JointLimits, JointPath, JointPathProblem};

/// How `x` and the path parameter `s` belong together.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Map {
    /// `s = base + x`.
    Natural,
    /// `s = base + x² / (2 l)`.
    FromRest { l: f64 },
    /// `s = base - y² / (2 l)`, `y` falling.
    ToRest { l: f64 },
}

/// Where a cell lies: `x` (or `y`) at its first point, and the map to `s`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place {
    map: Map,
    base: f64,
    offset: f64,
}

impl Place {
    /// `s`, `ds/dx` and `d²s/dx²` after `x` has grown by `step` since the cell's first point.
    pub(crate) fn at(&self, step: f64) -> (f64, f64, f64) {
        match self.map {
            Map::Natural => (self.base + self.offset + step, 1.0, 0.0),
            Map::FromRest { l } => {
                let x = self.offset + step;
                (self.base + 0.5 * x * x / l, x / l, 1.0 / l)
            }
            Map::ToRest { l } => {
                let y = (self.offset - step).max(0.0);
                (self.base - 0.5 * y * y / l, y / l, -1.0 / l)
            }
        }
    }

    fn moved(mut self, step: f64) -> Self {
        self.offset += if matches!(self.map, Map::ToRest { .. }) { -step } else { step };
        self
    }
}

/// A cell: an interval of `x` with `q_x` of every joint in Bernstein form.
#[derive(Clone, Debug)]
pub(crate) struct Cell {
    /// Length in `x`. Halving it is exact.
    pub(crate) length: f64,
    pub(crate) place: Place,
    /// `dq/dx` by joint, all of the same degree.
    pub(crate) derivative: Vec<Polynomial>,
}

impl Cell {
    pub(crate) fn degree(&self) -> usize {
        self.derivative[0].degree()
    }

    /// Both halves.
    pub(crate) fn halves(&self) -> [Self; 2] {
        let (left, right) = self.derivative.iter().map(Polynomial::halves).unzip();
        let length = 0.5 * self.length;
        [
            Self { length, place: self.place, derivative: left },
            Self { length, place: self.place.moved(length), derivative: right },
        ]
    }
}

/// A stretch between corners, as cells, with rest or free ends.
#[derive(Clone, Debug)]
pub(crate) struct Piece {
    pub(crate) cells: Vec<Cell>,
    pub(crate) ends: [End; 2],
}

/// A stretch of one segment in one parameter: powers of `q_x` by joint in the stretch's own variable, which runs from 0 to `length`.
struct Stretch {
    map: Map,
    base: f64,
    length: f64,
    powers: Vec<Vec<f64>>,
}

/// The pieces of a problem, with about `count` cells in all.
pub(crate) fn pieces(problem: &JointPathProblem, count: usize) -> Result<Vec<Piece>, BracketError> {
    let path = problem.path();
    let rests = problem.limits().has_acceleration();
    let (mut stretches, mut first) = (Vec::new(), 0);
    for i in 0..path.segment_count() {
        if i + 1 == path.segment_count() || path.is_corner(i, |j| problem.limits().is_accelerated(j)) {
            let inner = if rests { End::Rest } else { End::Free };
            let start = if first == 0 && rests { problem.ends()[0] } else { inner };
            let end = if i + 1 == path.segment_count() && rests { problem.ends()[1] } else { inner };
            stretches.push((stretches_of(path, first, i, [start, end])?, [start, end]));
            first = i + 1;
        }
    }
    let total: f64 = stretches.iter().flat_map(|(s, _)| s).map(|s| s.length).sum();
    let build = |(stretches, ends): (Vec<Stretch>, [End; 2])| {
        let cells =
            joined(stretches.iter().map(|s| cells_of(s, count as f64 / total)).collect(), ends, problem.limits());
        if rests {
            check_stalls(&cells, ends, problem.limits())?
        };
        Ok(Piece { cells, ends })
    };
    stretches.into_iter().map(build).collect()
}

/// The stretches of the segments `first..=last`.
fn stretches_of(path: &JointPath, first: usize, last: usize, ends: [End; 2]) -> Result<Vec<Stretch>, BracketError> {
    let mut result = Vec::new();
    let singular = |place: EndPlace, end: End| Ok(end == End::Rest && !place.is_regular()?);
    let start = singular(EndPlace::new(path, first, false), ends[0])?;
    let end = singular(EndPlace::new(path, last, true), ends[1])?;
    for i in first..=last {
        let (base, length, powers) = (path.knots()[i], path.length(i), path.derivative(i));
        let from = start && i == first;
        let to = end && i == last;
        // A segment that both begins and ends at rest is cut in the middle.
        let share = if from && to { 0.5 * length } else { length };
        if from {
            result.push(Stretch {
                map: Map::FromRest { l: 2.0 * share },
                base,
                length: 2.0 * share,
                powers: powers.clone(),
            });
        }
        if to {
            let powers = powers.iter().map(|p| shifted(p, length)).collect();
            let base = path.knots()[i + 1];
            result.push(Stretch { map: Map::ToRest { l: 2.0 * share }, base, length: 2.0 * share, powers });
        }
        if !(from || to) {
            result.push(Stretch { map: Map::Natural, base, length, powers });
        }
    }
    for stretch in &mut result {
        stretch.substitute();
    }
    Ok(result)
}

/// One end of a piece: does `q'` vanish there?
struct EndPlace {
    s: f64,
    /// Largest `|q'|` at the end, and `|q''|` times the segment's length, each as a share of the largest `|q'|` of the segment.
    first: f64,
    second: f64,
}

/// Share of the largest derivative below which one at an end counts as 0.
const ZERO: f64 = 1e-9;

impl EndPlace {
    fn new(path: &JointPath, segment: usize, at_end: bool) -> Self {
        let (length, powers) = (path.length(segment), path.derivative(segment));
        let s = path.knots()[segment + usize::from(at_end)];
        let (mut first, mut second, mut size): (f64, f64, f64) = (0.0, 0.0, f64::MIN_POSITIVE);
        for p in &powers {
            let here = if at_end { shifted(p, length) } else { p.clone() };
            first = first.max(here[0].abs());
            second = second.max(here.get(1).map_or(0.0, |c| (c * length).abs()));
            size = size.max(p.iter().rev().fold(0.0, |sum, c| sum * length + c.abs()));
        }
        Self { s, first: first / size, second: second / size }
    }

    /// Whether the path parameter itself is of the kind `q ~ s²`.
    fn is_regular(&self) -> Result<bool, BracketError> {
        match (self.first > ZERO, self.second > ZERO) {
            (true, _) => Ok(false),
            (false, true) => Ok(true),
            (false, false) => Err(BracketError::Stall { s: self.s }),
        }
    }
}

impl Stretch {
    /// Powers of `q'` by `s` become powers of `q_x` by the stretch's variable.
    fn substitute(&mut self) {
        let (l, sign) = match self.map {
            Map::Natural => return,
            Map::FromRest { l } => (l, 1.0),
            Map::ToRest { l } => (l, -1.0),
        };
        for powers in &mut self.powers {
            let mut result = vec![0.0; 2 * powers.len()];
            let mut factor = 1.0 / l;
            for (m, c) in powers.iter().enumerate() {
                result[2 * m + 1] = c * factor;
                factor *= sign / (2.0 * l);
            }
            *powers = result;
        }
    }
}

/// Powers about a point further on: Horner's scheme, again and again.
fn shifted(powers: &[f64], by: f64) -> Vec<f64> {
    let mut p = powers.to_vec();
    for i in 0..p.len().saturating_sub(1) {
        for m in (i..p.len() - 1).rev() {
            p[m] += by * p[m + 1];
        }
    }
    p
}

/// Equal cells of one stretch in the order of travel, at least two.
fn cells_of(stretch: &Stretch, density: f64) -> Vec<Cell> {
    let count = ((density * stretch.length).round() as usize).max(2);
    let length = stretch.length / count as f64;
    let falling = matches!(stretch.map, Map::ToRest { .. });
    let cell = |k: usize| {
        let near = if falling { count - 1 - k } else { k } as f64 * length;
        let local = |powers: &Vec<f64>| {
            let mut p = shifted(powers, near);
            let mut factor = 1.0;
            for c in &mut p {
                *c *= factor;
                factor *= length;
            }
            let mut polynomial = Polynomial::of_powers(&p);
            if falling {
                polynomial.coefficients_mut().reverse();
            }
            polynomial
        };
        let offset = if falling { near + length } else { near };
        let place = Place { map: stretch.map, base: stretch.base, offset };
        Cell { length, place, derivative: stretch.powers.iter().map(local).collect() }
    };
    (0..count).map(cell).collect()
}

/// The cells of all stretches of a piece, with one number at each node for every joint with acceleration limits, and exact zeros at rest ends. The `q'` of other
/// joints may jump.
fn joined(parts: Vec<Vec<Cell>>, ends: [End; 2], limits: &JointLimits) -> Vec<Cell> {
    let mut cells: Vec<Cell> = parts.into_iter().flatten().collect();
    for k in 1..cells.len() {
        let (before, after) = cells.split_at_mut(k);
        let pairs = before[k - 1].derivative.iter_mut().zip(&after[0].derivative).enumerate();
        for (_, (b, a)) in pairs.filter(|(joint, _)| limits.is_accelerated(*joint)) {
            let n = b.degree();
            b.coefficients_mut()[n] = a.coefficients()[0];
        }
    }
    let last = cells.len() - 1;
    for joint in 0..cells[0].derivative.len() {
        if ends[0] == End::Rest {
            cells[0].derivative[joint].coefficients_mut()[0] = 0.0;
        }
        if ends[1] == End::Rest {
            let n = cells[last].degree();
            cells[last].derivative[joint].coefficients_mut()[n] = 0.0;
        }
    }
    cells
}

/// Halvings until a place where no limited joint is seen to move counts as standing.
const DEPTH: usize = 30;
/// Share of the largest `q_x` of a cell below which a joint may stand: the least value of a square is rounded too.
const STILL: f64 = 1e-13;
/// Change of `q_x` over a cell, as a share of its largest value, below which a standing path does not turn back.
const TURNING: f64 = 1e-6;

/// Refuses places where all limited joints stand without turning back; at rest ends the standing itself is divided out.
fn check_stalls(cells: &[Cell], ends: [End; 2], limits: &JointLimits) -> Result<(), BracketError> {
    let last = cells.len() - 1;
    for (k, cell) in cells.iter().enumerate() {
        let limited = cell.derivative.iter().enumerate().filter(|(j, _)| limits.is_limited(*j));
        let mut joints: Vec<Polynomial> = limited.map(|(_, p)| *p).collect();
        let (from, to) = (k == 0 && ends[0] == End::Rest, k == last && ends[1] == End::Rest);
        for p in &mut joints {
            if from && p.degree() > 0 {
                *p = without_zero_at_start(p.coefficients());
            }
            if to && p.degree() > 0 {
                let mirrored: Vec<f64> = p.coefficients().iter().rev().copied().collect();
                *p = without_zero_at_start(&mirrored);
                p.coefficients_mut().reverse();
            }
        }
        let size = joints.iter().map(Polynomial::largest).fold(0.0, f64::max);
        if let Some(t) = standing(&joints, 0.0, 1.0, 0, size) {
            return Err(BracketError::Stall { s: cell.place.at(t * cell.length).0 });
        }
    }
    Ok(())
}

/// `p(t) / t` for a polynomial with `p(0) = 0`, at least of degree 1: coefficient `i` is `n / (i + 1)` times coefficient `i + 1`.
pub(crate) fn without_zero_at_start(coefficients: &[f64]) -> Polynomial {
    let n = (coefficients.len() - 1) as f64;
    let divided: Vec<f64> = coefficients[1..].iter().enumerate().map(|(i, c)| c * n / (i + 1) as f64).collect();
    Polynomial::new(&divided)
}

/// A place where all joints stand and do not turn back.
fn standing(joints: &[Polynomial], from: f64, width: f64, depth: usize, size: f64) -> Option<f64> {
    let near = STILL * size;
    let stands = |p: &Polynomial| p.range().0 <= near && p.range().1 >= -near;
    if !joints.iter().all(stands) {
        return None;
    }
    if depth == DEPTH {
        // Over this small interval a joint changes by its derivative times the width.
        let change = |p: &Polynomial| (p.coefficients()[p.degree()] - p.coefficients()[0]).abs() / width;
        let turns = joints.iter().map(change).fold(0.0, f64::max) > TURNING * size;
        return (!turns).then_some(from);
    }
    let (left, right): (Vec<_>, Vec<_>) = joints.iter().map(Polynomial::halves).unzip();
    standing(&left, from, 0.5 * width, depth + 1, size)
        .or_else(|| standing(&right, from + 0.5 * width, 0.5 * width, depth + 1, size))
}
