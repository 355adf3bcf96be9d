//! Rounds over one piece: profile, multipliers, and where the gap is.
//!
//! With `p` continuous the difference of the bounds is a sum over cells,
//!
//! ```text
//! gap_k = T_k - L_k - (p b)_{k+1} + (p b)_k >= 0,   sum_k gap_k = U - L
//! ```
//!
//! and the cells that hold most of it are halved. Where a round gains little nearly all cells with a gap are: at a zero-inertia point one coarse cell moves
//! the whole arc after it, so the gap shows along the arc, not at its cause.

use super::bracket::{BracketOptions, StopReason};
use super::caps;
use super::cells::{Cell, Piece};
use super::enclosure::CellDual;
use super::hats::{self, Evidence, Hats};
use super::minimise::Minimiser;
use super::path::{End, JointLimits};
use super::polish::{self, Aim, POINTS};
use super::profile::{Law, ProfileCell};
use super::rows::{LimitName, excess, value};
use super::upper;
use crate::outward::Outward;

/// Share of the gap whose cells are halved, and where a round was slow.
const SHARE: f64 = 0.85;
const SLOW_SHARE: f64 = 0.98;
/// A round is slow if it leaves more than this of the gap before, and gains nothing if it leaves more than that.
const SLOW: f64 = 0.6;
const NO_GAIN: f64 = 0.9;
/// Rounds.
const ROUNDS: usize = 40;

/// A bracket of one piece.
#[derive(Clone, Debug)]
pub(crate) struct PieceBracket {
    pub(crate) lower: Outward,
    pub(crate) upper: Outward,
    pub(crate) profile: Vec<ProfileCell>,
    pub(crate) gaps: Vec<PieceGap>,
    pub(crate) cells: usize,
    pub(crate) rounds: usize,
    pub(crate) stop: StopReason,
}

/// What one cell adds to the gap of the last round.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PieceGap {
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) gap: f64,
    pub(crate) limit: Option<LimitName>,
}

/// The bounds of one round.
struct Round {
    /// The profile within the limits, node, middle, node, ...
    b: Vec<f64>,
    times: Vec<Outward>,
    hats: Hats,
    /// Time at the nodes, s.
    node_time: Vec<f64>,
    /// Guide of each cell's part of the lower bound.
    guides: Vec<f64>,
    /// `∫ g` by Gauss's rule.
    integral: Vec<f64>,
}

/// Brackets one piece.
pub(crate) fn bracket(
    piece: Piece,
    limits: &JointLimits,
    options: &BracketOptions,
    most: usize,
) -> Option<PieceBracket> {
    let ends = piece.ends;
    let mut minimiser = Minimiser::new(piece.cells, limits, options.solver);
    let (mut shares, mut gap, mut before, mut poor) = (Vec::new(), f64::INFINITY, f64::INFINITY, 0);
    let (mut lower, mut upper, mut profile) = (Outward::ZERO, Outward::exact(f64::INFINITY), Vec::new());
    for round in 1..=ROUNDS {
        let target = options.gap;
        minimiser.minimise(if gap.is_finite() { (0.1 * gap).max(0.03 * target).min(1e-4) } else { 1e-5 });
        let now = match one_round(&minimiser, ends, limits, &shares, gap, target) {
            Some(now) => now,
            None if profile.is_empty() => return None,
            None => break,
        };
        let time = now.times.iter().fold(Outward::ZERO, |sum, t| sum + *t);
        if time.hi < upper.hi {
            upper = time;
            profile = profile_of(&minimiser, &now.b);
        }
        let guide: f64 = now.guides.iter().sum();
        let mut new_gap = upper.hi / guide - 1.0;
        poor = if new_gap > NO_GAIN * gap { poor + 1 } else { 0 };
        let count = minimiser.cells.len();
        let last = count >= most || poor >= 2 || round == ROUNDS;
        let mut bounds = now.guides.clone();
        if last || new_gap < 0.9 * target {
            let allowed = 0.1 * target * time.hi / count as f64;
            let cells: Vec<&Cell> = minimiser.cells.iter().map(|c| &c.cell).collect();
            let enclosed = enclosed(&cells, ends, limits, &now, allowed);
            let sum = enclosed.iter().fold(Outward::ZERO, |sum, l| sum + *l);
            if sum.lo > lower.lo {
                lower = Outward { lo: sum.lo, hi: f64::INFINITY };
            }
            bounds = enclosed.iter().map(|l| l.lo).collect();
            new_gap = upper.hi / lower.lo - 1.0;
        }
        let gaps = cell_gaps(&minimiser, &now, &bounds);
        let reached = relative_gap(lower.lo, upper.hi) <= target;
        if reached || last {
            let stop = if reached {
                StopReason::GapReached
            } else if count >= most {
                StopReason::CellsSpent
            } else {
                StopReason::NoProgress
            };
            let gaps = named(&minimiser, limits, &now.b, &gaps);
            return Some(PieceBracket { lower, upper, profile, gaps, cells: count, rounds: round, stop });
        }
        gap = new_gap.abs().max(1e-16);
        let share = if gap > SLOW * before { SLOW_SHARE } else { SHARE };
        before = gap;
        let cut = chosen(&gaps, share, 0.05 * target * time.hi / count as f64, most);
        shares = now.hats.shares(&now.node_time, limits.joints(), &cut);
        minimiser.cut(&cut);
    }
    None
}

fn one_round(
    minimiser: &Minimiser,
    ends: [End; 2],
    limits: &JointLimits,
    shares: &[f64],
    gap: f64,
    target: f64,
) -> Option<Round> {
    let cells = minimiser.cells.iter().map(|c| &c.cell);
    let b = upper::within_limits(cells.clone(), limits, minimiser.profile())?;
    let times = upper::times(cells.clone(), &b);
    let count = times.len();
    let mut node_time = vec![0.0; count + 1];
    for (k, time) in times.iter().enumerate() {
        let half = 0.5 * time.lo;
        node_time[k] += half;
        node_time[k + 1] += half;
    }
    let mass = minimiser.masses();
    let evidence = Evidence { mass: &mass, time: &node_time, before: shares };
    let owned: Vec<&Cell> = cells.collect();
    let mut hats = hats::choose(&owned, ends, limits, &evidence);
    let gap = if gap < 1.0 { gap } else { 1e-2 };
    let aim = Aim { tolerance: (0.03 * gap).clamp(0.02 * target, 1e-4), start: 0.02 * gap };
    let integral = polish::polish(&owned, limits, &mut hats, at_points(&b), aim).integral;
    let prices = (0..count).map(|k| dual(&owned, limits, &hats, k).price().lo);
    let guides = prices.zip(&integral).map(|(price, g)| price + g).collect();
    Some(Round { b, times, hats, node_time, guides, integral })
}

/// `b` at the Gauss points of every cell.
pub(crate) fn at_points(b: &[f64]) -> Vec<f64> {
    let cells = b.len() / 2;
    let form = |t: f64| [(1.0 - t) * (1.0 - t), 2.0 * t * (1.0 - t), t * t];
    (0..cells).flat_map(|k| POINTS.map(|t| value(&form(t), &b[2 * k..2 * k + 3]))).collect()
}

fn dual<'c>(cells: &[&'c Cell], limits: &'c JointLimits, hats: &'c Hats, k: usize) -> CellDual<'c> {
    CellDual {
        cell: cells[k],
        limits,
        hats: [&hats.nodes[k], &hats.nodes[k + 1]],
        kinematic: f64::INFINITY,
        guide: f64::INFINITY,
        allowed: 0.0,
    }
}

/// Lower bounds of all cells.
fn enclosed(cells: &[&Cell], ends: [End; 2], limits: &JointLimits, round: &Round, allowed: f64) -> Vec<Outward> {
    let kinematic = caps::kinematic(cells, ends, limits);
    let count = cells.len();
    let cell = |k: usize| {
        let mut dual = CellDual {
            kinematic: kinematic[k],
            guide: round.integral[k],
            allowed,
            ..dual(cells, limits, &round.hats, k)
        };
        // At a free end p must vanish, whatever the multipliers.
        if k == 0 && ends[0] == End::Free {
            dual.hats[0] = &[];
        }
        if k + 1 == count && ends[1] == End::Free {
            dual.hats[1] = &[];
        }
        dual.lower()
    };
    (0..count).map(cell).collect()
}

/// `gap_k` of every cell, a guide.
fn cell_gaps(minimiser: &Minimiser, round: &Round, bounds: &[f64]) -> Vec<f64> {
    let count = bounds.len();
    let at_node = |k: usize| {
        let p: f64 = round.hats.nodes[k]
            .iter()
            .map(|hat| {
                let a = if k < count {
                    minimiser.cells[k].cell.derivative[hat.joint].coefficients()[0]
                } else {
                    let q = &minimiser.cells[k - 1].cell.derivative[hat.joint];
                    q.coefficients()[q.degree()]
                };
                0.5 * hat.sense.sign() * hat.multiplier() * a
            })
            .sum();
        p * round.b[2 * k]
    };
    let mut before = at_node(0);
    let gap = |k: usize| {
        let after = at_node(k + 1);
        let gap = round.times[k].hi - bounds[k] - after + before;
        before = after;
        gap
    };
    (0..count).map(gap).collect()
}

/// Cells to halve: those with the largest gaps that hold a share of it, none below `least`, at most up to `most` cells in all.
fn chosen(gaps: &[f64], share: f64, least: f64, most: usize) -> Vec<bool> {
    let mut order: Vec<usize> = (0..gaps.len()).collect();
    order.sort_by(|a, b| gaps[*b].total_cmp(&gaps[*a]));
    let wanted = share * gaps.iter().sum::<f64>();
    let (mut cut, mut sum) = (vec![false; gaps.len()], 0.0);
    for (number, k) in order.into_iter().enumerate() {
        let enough = sum >= wanted && number >= 3;
        if enough || number + gaps.len() >= most || number > 0 && gaps[k] <= least {
            break;
        }
        cut[k] = true;
        sum += gaps[k];
    }
    cut
}

fn profile_of(minimiser: &Minimiser, b: &[f64]) -> Vec<ProfileCell> {
    let cell = |(k, c): (usize, &super::minimise::WorkCell)| ProfileCell {
        place: c.cell.place,
        length: c.cell.length,
        law: Law::Quadratic(upper::of_cell(b, k)),
    };
    minimiser.cells.iter().enumerate().map(cell).collect()
}

/// The gaps with their places and the limits used most.
fn named(minimiser: &Minimiser, limits: &JointLimits, b: &[f64], gaps: &[f64]) -> Vec<PieceGap> {
    let cell = |(k, gap): (usize, &f64)| {
        let cell = &minimiser.cells[k].cell;
        PieceGap {
            from: cell.place.at(0.0).0,
            to: cell.place.at(cell.length).0,
            gap: *gap,
            limit: excess(cell, limits, upper::of_cell(b, k)).1,
        }
    };
    gaps.iter().enumerate().map(cell).collect()
}

/// `upper / lower - 1`, rounded up; infinite unless both are positive numbers.
pub(crate) fn relative_gap(lower: f64, upper: f64) -> f64 {
    if lower > 0.0 && upper < f64::INFINITY { ((upper / lower).next_up() - 1.0).next_up() } else { f64::INFINITY }
}

/// Sums of the enclosed bounds and times of one round on a minimiser's cells, and the cells' gaps.
#[cfg(test)]
pub(crate) fn bounds_and_gaps(
    minimiser: &Minimiser<'_>,
    ends: [End; 2],
    limits: &JointLimits,
) -> ((f64, f64), Vec<f64>) {
    let round = one_round(minimiser, ends, limits, &[], f64::INFINITY, 1e-4).expect("a round");
    let cells: Vec<&Cell> = minimiser.cells.iter().map(|c| &c.cell).collect();
    let bounds: Vec<f64> = enclosed(&cells, ends, limits, &round, 0.0).iter().map(|l| l.lo).collect();
    let gaps = cell_gaps(minimiser, &round, &bounds);
    ((bounds.iter().sum(), round.times.iter().map(|t| t.hi).sum()), gaps)
}
