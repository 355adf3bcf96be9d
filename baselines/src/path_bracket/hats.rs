//! Multipliers of the acceleration rows along the path: sums of the grid's hat functions.
//!
//! `mu_r(x) = sum_k m_{r,k} φ_k(x)` with the hat `φ_k` of node `k` and `m_{r,k} >= 0`. Then `p = 1/2 sum_r mu_r a_r` is continuous because the `a_r`
//! are, and the lower bound has no terms for jumps: accelerate-to-brake, changes of the active row and touches of the limit curve need no
//! cases. A multiplier is counted in seconds, `y = m U (h_{k-1} + h_k) / 2`, its price in the bound.

use super::cells::Cell;
use super::path::{End, JointLimits, Sense};

/// Rows with a multiplier at one node.
pub(crate) const ROWS: usize = 3;

/// A multiplier at a node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Hat {
    pub(crate) joint: usize,
    pub(crate) sense: Sense,
    /// Price, s.
    pub(crate) seconds: f64,
    /// `m / y`, 1 / (limit · length).
    pub(crate) scale: f64,
}

impl Hat {
    /// The multiplier itself; what is negative or not a number counts as 0.
    pub(crate) fn multiplier(&self) -> f64 {
        let m = self.seconds * self.scale;
        if m > 0.0 && m.is_finite() { m } else { 0.0 }
    }
}

/// The multipliers of all nodes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Hats {
    pub(crate) nodes: Vec<Vec<Hat>>,
}

/// What is known before a choice, as tables with a row of two entries (upper, lower) a joint.
pub(crate) struct Evidence<'e> {
    /// Solver's multipliers of each cell, summed over the rows of a limit, s.
    pub(crate) mass: &'e [f64],
    /// Time at each node: half of both neighbours' cells, s.
    pub(crate) time: &'e [f64],
    /// Share of the node's time of the multipliers polished before; empty at first.
    pub(crate) before: &'e [f64],
}

/// Index of a limit in such a table.
pub(crate) fn index(joint: usize, sense: Sense) -> usize {
    2 * joint + usize::from(sense == Sense::Lower)
}

/// Share of a node's time below which a row gets no multiplier.
const THRESHOLD: f64 = 1e-4;

/// Chooses up to [`ROWS`] rows at every node by their share of the node's time, looking at both neighbours, and starts them from what was polished
/// before or else from the solver. A free end gets none: `p` must vanish there.
pub(crate) fn choose(cells: &[&Cell], ends: [End; 2], limits: &JointLimits, evidence: &Evidence<'_>) -> Hats {
    let (count, width) = (cells.len(), 2 * limits.joints());
    let mut cost = vec![0.0; (count + 1) * width];
    for k in 0..count {
        for r in 0..width {
            let half = 0.5 * evidence.mass[k * width + r];
            cost[k * width + r] += half;
            cost[(k + 1) * width + r] += half;
        }
    }
    let before = |at: usize| evidence.before.get(at).copied().unwrap_or(0.0);
    let share = |k: usize, r: usize| (cost[k * width + r] / evidence.time[k]).max(before(k * width + r));
    let node = |k: usize| {
        if k == 0 && ends[0] == End::Free || k == count && ends[1] == End::Free {
            return Vec::new();
        }
        let around = if k > 0 { cells[k - 1].length } else { 0.0 } + if k < count { cells[k].length } else { 0.0 };
        let mut best: Vec<(f64, Hat)> = Vec::with_capacity(ROWS + 1);
        for r in 0..width {
            let (joint, sense) = (r / 2, Sense::BOTH[r % 2]);
            let mut strength = share(k, r);
            if k > 0 {
                strength = strength.max(share(k - 1, r));
            }
            if k < count {
                strength = strength.max(share(k + 1, r));
            }
            let limit = limits.acceleration(joint, sense);
            if !(strength > THRESHOLD && limit.is_finite()) {
                continue;
            }
            let (old, least) = (before(k * width + r), 1e-3 * THRESHOLD);
            let start = if old > 1e-2 * THRESHOLD { old } else { cost[k * width + r] / evidence.time[k] };
            let seconds = start.max(least) * evidence.time[k];
            let hat = Hat { joint, sense, seconds, scale: 2.0 / (limit * around) };
            let place = best.iter().position(|(s, _)| *s < strength).unwrap_or(best.len());
            best.insert(place, (strength, hat));
            best.truncate(ROWS);
        }
        best.into_iter().map(|(_, hat)| hat).collect()
    };
    Hats { nodes: (0..=count).map(node).collect() }
}

impl Hats {
    /// Shares of the nodes' times, to carry to a refined grid: a new node in a cut cell gets the mean of both ends.
    pub(crate) fn shares(&self, time: &[f64], joints: usize, cut: &[bool]) -> Vec<f64> {
        let width = 2 * joints;
        let at = |k: usize| {
            let mut shares = vec![0.0; width];
            for hat in &self.nodes[k] {
                shares[index(hat.joint, hat.sense)] = hat.seconds / time[k];
            }
            shares
        };
        let mut last = at(0);
        let mut result = last.clone();
        for (k, cut) in cut.iter().enumerate() {
            let next = at(k + 1);
            if *cut {
                result.extend(last.iter().zip(&next).map(|(a, b)| 0.5 * (a + b)));
            }
            result.extend(&next);
            last = next;
        }
        result
    }
}
