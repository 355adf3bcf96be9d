//! Projection onto any allowed set in three dimensions, with a certified gap.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use slideway_conditioner::path::{Constraint, Motion};

use super::{Projection, ProjectionError, distance};

/// A constraint and how steep it can be.
pub struct Bounded<'a> {
    /// `σ(x) <= 0`.
    pub constraint: &'a dyn Constraint<3>,
    /// A Lipschitz constant of `σ` over the search box: no gradient there is longer. The certificate rests on it.
    pub lipschitz: f64,
}

/// Where to look and how closely.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Search {
    /// Half edge of the cube about the point to project that is searched.
    pub reach: f64,
    /// The bracket is closed when upper and lower bound are this close.
    pub gap: f64,
    /// Largest number of boxes to look at.
    pub boxes: usize,
}

/// A cube that may contain the nearest point.
#[derive(Clone, Copy)]
struct Cube {
    centre: [f64; 3],
    half: f64,
    bound: f64,
}

impl PartialEq for Cube {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}
impl Eq for Cube {}
impl PartialOrd for Cube {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Cube {
    /// The heap gives out the greatest: here the one with the smallest bound.
    fn cmp(&self, other: &Self) -> Ordering {
        other.bound.total_cmp(&self.bound)
    }
}

/// The nearest allowed point to `p` within the search cube, bracketed to `search.gap`. If it is no farther than the
/// cube reaches, it is the nearest of all.
///
/// Best-first branch and bound. A cube with half diagonal `h` about `c` holds no allowed point if some
/// `σ_i(c) > L_i h`; else it is no nearer than the cube itself. Upper bounds come from a descent that starts at each
/// cube's centre. The bracket certifies the global optimum up to the gap; the point itself is stationary to rounding.
///
/// # Errors
///
/// [`ProjectionError::Empty`], [`ProjectionError::Budget`], [`ProjectionError::NotFinite`].
pub fn project(p: &[f64; 3], constraints: &[Bounded<'_>], search: Search) -> Result<Projection<3>, ProjectionError> {
    if !p.iter().all(|x| x.is_finite()) {
        return Err(ProjectionError::NotFinite);
    }
    let mut heap = BinaryHeap::from([Cube { centre: *p, half: search.reach, bound: 0.0 }]);
    let mut best: Option<([f64; 3], f64)> = None;
    let upper = |best: &Option<([f64; 3], f64)>| best.map_or(f64::INFINITY, |(_, d)| d);
    let mut looked = 0;
    while let Some(cube) = heap.pop() {
        if cube.bound >= upper(&best) - search.gap {
            return close(p, best, cube.bound.min(upper(&best)), constraints);
        }
        looked += 1;
        if looked > search.boxes {
            return Err(ProjectionError::Budget { lower: cube.bound, upper: upper(&best) });
        }
        // A descent is dear: one for the first cubes, then one whenever a cube is a new candidate by itself.
        if (looked <= 64 || looked % 64 == 0)
            && let Some(x) = descend(p, &cube.centre, constraints)
            && distance(p, &x) < upper(&best)
        {
            best = Some((x, distance(p, &x)));
        }
        for child in children(p, &cube) {
            if child.bound < upper(&best) && may_be_allowed(&child, constraints) {
                heap.push(child);
            }
        }
    }
    let reached = upper(&best);
    close(p, best, reached, constraints)
}

fn close(
    p: &[f64; 3],
    best: Option<([f64; 3], f64)>,
    lower_bound: f64,
    constraints: &[Bounded<'_>],
) -> Result<Projection<3>, ProjectionError> {
    let (point, _) = best.ok_or(ProjectionError::Empty)?;
    let violation = constraints.iter().map(|c| value(c, &point)).fold(f64::NEG_INFINITY, f64::max);
    Ok(Projection { point, distance: distance(p, &point), lower_bound, violation })
}

fn value(c: &Bounded<'_>, x: &[f64; 3]) -> f64 {
    c.constraint.sample(&Motion { time: 0.0, position: *x, velocity: [0.0; 3] }).value
}

fn may_be_allowed(cube: &Cube, constraints: &[Bounded<'_>]) -> bool {
    let diagonal = cube.half * 3.0_f64.sqrt();
    // One part in 1e12 more than the constant, for rounding.
    constraints.iter().all(|c| value(c, &cube.centre) <= c.lipschitz * diagonal * (1.0 + 1e-12))
}

fn children(p: &[f64; 3], cube: &Cube) -> [Cube; 8] {
    let half = 0.5 * cube.half;
    std::array::from_fn(|corner| {
        let centre: [f64; 3] =
            std::array::from_fn(|axis| cube.centre[axis] + if corner >> axis & 1 == 0 { -half } else { half });
        let bound = (0..3).map(|i| ((p[i] - centre[i]).abs() - half).max(0.0).powi(2)).sum::<f64>().sqrt();
        Cube { centre, half, bound }
    })
}

/// Sequential projection: from `start`, the nearest point to `p` within the constraints linearised where we are.
fn descend(p: &[f64; 3], start: &[f64; 3], constraints: &[Bounded<'_>]) -> Option<[f64; 3]> {
    let mut x = *start;
    for _ in 0..60 {
        let motion = Motion { time: 0.0, position: x, velocity: [0.0; 3] };
        let mut rows = Vec::new();
        let mut bounds = Vec::new();
        for c in constraints {
            let sample = c.constraint.sample(&motion);
            let room: f64 = (0..3).map(|i| sample.gradient[i] * (x[i] - p[i])).sum::<f64>() - sample.value;
            rows.push(sample.gradient.to_vec());
            bounds.push(room);
        }
        let step = crate::safety_filter::enumeration::smallest(&rows, &bounds)?;
        let next: [f64; 3] = std::array::from_fn(|i| p[i] + step[i]);
        let change = distance(&next, &x);
        x = next;
        if change < 1e-14 {
            break;
        }
    }
    // Linearised outsides of convex bodies are safe; of others, the last step can leave a rounding's worth outside.
    constraints.iter().all(|c| value(c, &x) <= 1e-12).then_some(x)
}
