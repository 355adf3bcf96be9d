use super::reachability::reachable_profile;
use slideway_path::SampledPath;

/// Widenings beyond this share of every limit's half range count as hopeless.
const LARGEST: f64 = 1e4;

/// By how much all limits that depend on the path's acceleration must give way for a profile to exist: the least share of their
/// half ranges, to 0.1 % of itself, by which both bounds of each are moved outward. 0 where there is one already; `None` where
/// even ten thousand times is not enough.
///
/// The share is found by bisection with [`reachable_profile`], whose verdict on feasibility is exact but for rounding.
#[must_use]
pub fn needed_widening(path: &SampledPath) -> Option<f64> {
    let feasible = |share: f64| reachable_profile(&widened(path, share)).is_ok();
    if feasible(0.0) {
        return Some(0.0);
    }
    let mut enough = 1e-6;
    while !feasible(enough) {
        enough *= 4.0;
        if enough > LARGEST {
            return None;
        }
    }
    let mut short = 0.25 * enough;
    while enough - short > 1e-3 * enough {
        let middle = 0.5 * (short + enough);
        if feasible(middle) {
            enough = middle;
        } else {
            short = middle;
        }
    }
    Some(enough)
}

/// The same path with both bounds of every such limit moved outward.
fn widened(path: &SampledPath, share: f64) -> SampledPath {
    let mut path = path.clone();
    for acceleration in path.acceleration.iter_mut().flatten() {
        *acceleration *= 1.0 + share;
    }
    for piece in &mut path.pieces {
        for sample in piece.nodes.iter_mut().chain(piece.between.iter_mut().flatten()) {
            for limit in &mut sample.limits {
                let room = share * limit.half_range();
                (limit.lower, limit.upper) = (limit.lower - room, limit.upper + room);
            }
        }
    }
    path
}
