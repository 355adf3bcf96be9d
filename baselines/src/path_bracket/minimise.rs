//! The profile of one round: which rows the solver sees, and where it starts.
//!
//! Few of a cell's rows matter. The first solve leaves out rows that no `b` below the caps can break; later ones keep rows that the profile uses to more
//! than half. Left-out rows are checked afterwards, and if one is broken it joins and the round begins again from its start, never from the profile
//! that broke it.
//!
//! *Warm start by shrinking.* Rows are homogeneous in `b` and the gradient of the time scales with `b^(-3/2)`: with `x ← c x`, `z ← c^(-3/2) z` the dual residual stays
//! what it was, the primal one is 0, and every slack is at least the shrink.

use super::bracket::Solver;
use super::caps;
use super::cell_time::plain_cell_time;
use super::cells::Cell;
use super::conic;
use super::hats::index;
use super::interior_point::{self, Answer, Program, Start, Stop};
use super::path::JointLimits;
use super::rows::{CellRows, LimitName, cell_rows, value};
use super::upper::of_cell;

/// Use of a row, as a share of its limit, from which on the solver sees it.
const KEPT: f64 = 0.5;
/// Share by which a profile is shrunk at a warm start, and after the first, rough solve.
const SHRINK: f64 = 0.01;
const FIRST_SHRINK: f64 = 0.05;
/// Tolerance of the first, rough solve.
const ROUGH: f64 = 0.05;
/// Products of slacks and multipliers at a warm start, as a share of shrink times mean price.
const PRODUCT: f64 = 0.3;
/// Times rows are added in one round.
const REPEATS: usize = 4;
/// Tolerance of the conic solver.
const CONIC_TOLERANCE: f64 = 1e-8;
/// Steps of a solve.
const STEPS: usize = 60;

/// A cell with its rows and the solver's multipliers.
#[derive(Clone, Debug)]
pub(crate) struct WorkCell {
    pub(crate) cell: Cell,
    rows: CellRows,
    /// Multiplier of every row, s; 0 for those left out.
    z: Vec<f64>,
    /// Rows that the solver sees, rising.
    kept: Vec<usize>,
}

/// Profile and multipliers on the cells of a piece.
pub(crate) struct Minimiser<'l> {
    pub(crate) cells: Vec<WorkCell>,
    limits: &'l JointLimits,
    solver: Solver,
    /// Unit of `b`.
    unit: f64,
    /// `b / unit`: node, middle, node, ...
    x: Vec<f64>,
    is_new: bool,
    /// Steps of the last solve.
    #[cfg_attr(not(test), allow(dead_code, reason = "tests watch it: the first to show a bad start"))]
    pub(crate) steps: usize,
}

impl<'l> Minimiser<'l> {
    /// Starts from half of the caps.
    pub(crate) fn new(cells: Vec<Cell>, limits: &'l JointLimits, solver: Solver) -> Self {
        let count = cells.len();
        let mut caps = vec![f64::INFINITY; 2 * count + 1];
        for (k, cell) in cells.iter().enumerate() {
            for (i, t) in [0.0, 0.5, 1.0].into_iter().enumerate() {
                caps[2 * k + i] = caps[2 * k + i].min(caps::at(cell, limits, t));
            }
        }
        let mut finite: Vec<f64> = caps.iter().copied().filter(|c| c.is_finite() && *c > 0.0).collect();
        finite.sort_by(f64::total_cmp);
        let unit = finite.get(finite.len() / 2).copied().unwrap_or(1.0);
        let work = |cell: Cell| {
            let rows = cell_rows(&cell, limits, unit);
            WorkCell { z: vec![0.0; rows.rows.len()], kept: Vec::new(), rows, cell }
        };
        let x = caps.iter().map(|c| 0.5 * (c / unit).min(10.0)).collect();
        let mut result =
            Self { cells: cells.into_iter().map(work).collect(), limits, solver, unit, x, is_new: true, steps: 0 };
        result.keep_within(&caps);
        result
    }

    /// `b`: node, middle, node, ...
    pub(crate) fn profile(&self) -> Vec<f64> {
        self.x.iter().map(|x| x * self.unit).collect()
    }

    /// Multipliers of the acceleration limits in every cell, summed over a limit's rows, s.
    pub(crate) fn masses(&self) -> Vec<f64> {
        let width = 2 * self.limits.joints();
        let mut masses = vec![0.0; width * self.cells.len()];
        for (cell, mass) in self.cells.iter().zip(masses.chunks_mut(width)) {
            for (name, range) in cell.rows.ranges() {
                if let LimitName::Acceleration { joint, sense } = name {
                    mass[index(joint, sense)] += cell.z[range].iter().sum::<f64>();
                }
            }
        }
        masses
    }

    /// Solves on the cells as they are.
    pub(crate) fn minimise(&mut self, tolerance: f64) {
        let mut shrink = SHRINK;
        if self.is_new {
            let program = self.program();
            let answer = self.solve(&program, self.x.clone(), Start::Cold, ROUGH);
            self.take(answer);
            (self.is_new, shrink) = (false, FIRST_SHRINK);
        }
        self.keep_used();
        let start: (Vec<f64>, Vec<Vec<f64>>) = (self.x.clone(), self.cells.iter().map(|c| c.z.clone()).collect());
        for repeat in 1..=REPEATS {
            let answer = self.warm(&start, shrink, tolerance);
            self.take(answer);
            if self.add_broken(tolerance, repeat) == 0 {
                break;
            }
        }
    }

    /// Solves from a shrunk start; if that does not converge, from further inside.
    fn warm(&self, start: &(Vec<f64>, Vec<Vec<f64>>), shrink: f64, tolerance: f64) -> Answer {
        let program = self.program();
        let kept = self.cells.iter().zip(&start.1).flat_map(|(c, z)| c.kept.iter().map(|j| z[*j]));
        let z: Vec<f64> = kept.collect();
        let from = |shrink: f64| {
            let mut most = f64::MIN_POSITIVE;
            for k in 0..self.cells.len() {
                for row in &program.rows[program.first[k]..program.first[k + 1]] {
                    most = most.max(value(row, &start.0[2 * k..2 * k + 3]));
                }
            }
            let factor = (1.0 - shrink) / most;
            let x: Vec<f64> = start.0.iter().map(|x| x * factor).collect();
            let multipliers: Vec<f64> = z.iter().map(|z| z * factor.powf(-1.5)).collect();
            let product = PRODUCT * shrink * program.time(&x) / program.rows.len().max(1) as f64;
            self.solve(&program, x, Start::Warm { multipliers: &multipliers, product }, tolerance)
        };
        let answer = from(shrink);
        if answer.converged {
            return answer;
        }
        // What did not converge is good enough as a rule: the check afterwards tells. Only an answer that is no profile goes to the conic solver.
        let again = from(4.0 * shrink);
        let best = if again.converged || !is_profile(&answer.x) { again } else { answer };
        if is_profile(&best.x) { best } else { conic::solve(&program, CONIC_TOLERANCE).unwrap_or(best) }
    }

    /// The solver's answer; the structured one's where the conic one has none.
    fn solve(&self, program: &Program, x: Vec<f64>, start: Start, tolerance: f64) -> Answer {
        let conic = || conic::solve(program, CONIC_TOLERANCE);
        let own = |x: Vec<f64>| interior_point::solve(program, x, start, Stop { tolerance, steps: STEPS });
        match self.solver {
            Solver::InteriorPoint => own(x),
            Solver::Conic => conic().unwrap_or_else(|| own(x)),
        }
    }

    /// The rows kept, as a program.
    fn program(&self) -> Program {
        let mut program = Program { first: vec![0], ..Program::default() };
        let root = self.unit.sqrt();
        for cell in &self.cells {
            program.lengths.push(cell.cell.length / root);
            program.rows.extend(cell.kept.iter().map(|j| cell.rows.rows[*j]));
            program.first.push(program.rows.len());
        }
        program
    }

    /// Goes on with an answer, unless it is no profile: then with what was there.
    fn take(&mut self, answer: Answer) {
        if !is_profile(&answer.x) {
            return;
        }
        (self.x, self.steps) = (answer.x, answer.steps);
        let mut z = answer.z.into_iter();
        for cell in &mut self.cells {
            cell.z.fill(0.0);
            for j in &cell.kept {
                cell.z[*j] = z.next().unwrap_or(0.0);
            }
        }
    }

    /// Rows that some `b` below the caps breaks.
    fn keep_within(&mut self, caps: &[f64]) {
        for (k, cell) in self.cells.iter_mut().enumerate() {
            let box_of: Vec<f64> = caps[2 * k..2 * k + 3].iter().map(|c| c / self.unit).collect();
            // A cap is met at three points only; within the cell it may be somewhat larger.
            let most = box_of.iter().fold(0.0, |m: f64, c| m.max(*c));
            let breaks = |row: &[f64; 3]| !(most < 1e6) || row.iter().map(|c| c.max(0.0)).sum::<f64>() * most > 1.0;
            cell.kept = (0..cell.rows.rows.len()).filter(|j| breaks(&cell.rows.rows[*j])).collect();
        }
    }

    /// Rows used to more than [`KEPT`], or with a multiplier that counts.
    fn keep_used(&mut self) {
        let root = self.unit.sqrt();
        for (k, cell) in self.cells.iter_mut().enumerate() {
            let x = &self.x[2 * k..2 * k + 3];
            let price = 1e-3 * cell.cell.length / root / x[0].sqrt();
            let used = |j: &usize| value(&cell.rows.rows[*j], x) > KEPT || cell.z[*j] > price;
            cell.kept = (0..cell.rows.rows.len()).filter(used).collect();
        }
    }

    /// Where the profile breaks rows left out, adds all rows of the cells around, more of them at each repeat; their number. A profile that runs away breaks
    /// single rows one after the other otherwise.
    fn add_broken(&mut self, tolerance: f64, repeat: usize) -> usize {
        let count = self.cells.len();
        // The last time nothing is left out.
        let reach = if repeat + 1 >= REPEATS { count } else { 4_usize.pow(repeat as u32 - 1) - 1 };
        let mut near = vec![false; count];
        for (k, cell) in self.cells.iter().enumerate() {
            let x = &self.x[2 * k..2 * k + 3];
            if cell.rows.rows.iter().any(|row| value(row, x) > 1.0 + tolerance) {
                near[k.saturating_sub(reach)..(k + reach + 1).min(count)].fill(true);
            }
        }
        let mut added = 0;
        for (cell, _) in self.cells.iter_mut().zip(near).filter(|(_, near)| *near) {
            added += cell.rows.rows.len() - cell.kept.len();
            cell.kept = (0..cell.rows.rows.len()).collect();
        }
        added
    }

    /// Halves cells. Both halves' rows are means of the parent's, so the profile stays within the limits; a limit's multipliers go to both halves, more of
    /// them to rows that are used more.
    pub(crate) fn cut(&mut self, cut: &[bool]) {
        let mut x = vec![self.x[0]];
        let mut cells = Vec::with_capacity(2 * self.cells.len());
        for (k, parent) in std::mem::take(&mut self.cells).into_iter().enumerate() {
            let [b0, m, b1] = [self.x[2 * k], self.x[2 * k + 1], self.x[2 * k + 2]];
            if !cut[k] {
                x.extend([m, b1]);
                cells.push(parent);
                continue;
            }
            let (left, right) = (0.5 * (b0 + m), 0.5 * (m + b1));
            let middle = 0.5 * (left + right);
            x.extend([left, middle, right, b1]);
            let halves = parent.cell.halves();
            for (cell, b) in halves.into_iter().zip([[b0, left, middle], [middle, right, b1]]) {
                let rows = cell_rows(&cell, self.limits, self.unit);
                let z = shared(&parent, &rows, &b);
                cells.push(WorkCell { cell, rows, z, kept: Vec::new() });
            }
        }
        (self.cells, self.x) = (cells, x);
    }
}

/// Whether `b > 0` in every cell.
fn is_profile(x: &[f64]) -> bool {
    (0..x.len() / 2).all(|k| plain_cell_time(1.0, of_cell(x, k)).is_finite())
}

/// Multipliers of a half: half of the parent's sum for each limit, in proportion to `1 / (1 + shrink - row · b)`.
fn shared(parent: &WorkCell, rows: &CellRows, b: &[f64; 3]) -> Vec<f64> {
    let mut z = vec![0.0; rows.rows.len()];
    let mut parents = parent.rows.ranges().peekable();
    for (name, range) in rows.ranges() {
        // Both lists have the same order; the half may lack limits of the parent, not the other way round except by rounding.
        while parents.next_if(|(other, _)| *other != name && parent.has_before(*other, name)).is_some() {}
        let Some((_, old)) = parents.next_if(|(other, _)| *other == name) else { continue };
        let sum: f64 = parent.z[old].iter().sum();
        let weight = |row: &[f64; 3]| 1.0 / (1.0 + SHRINK - value(row, b)).max(1e-4);
        let all: f64 = rows.rows[range.clone()].iter().map(weight).sum();
        for j in range {
            z[j] = 0.5 * sum * weight(&rows.rows[j]) / all;
        }
    }
    z
}

impl WorkCell {
    /// Whether a limit comes before another in the order of rows.
    fn has_before(&self, a: LimitName, b: LimitName) -> bool {
        order(a) < order(b)
    }
}

fn order(name: LimitName) -> usize {
    match name {
        LimitName::Acceleration { joint, sense } => index(joint, sense),
        LimitName::Speed { joint } => usize::MAX / 2 + joint,
    }
}
