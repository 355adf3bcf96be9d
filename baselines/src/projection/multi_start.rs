//! Projection onto any allowed set by descents from several starts: locally optimal, the nearest of what was found.

use super::{Projection, ProjectionError, distance};
use crate::safety_filter::SmallestPush;
use crate::safety_filter::dense::DualActiveSet;
use slideway_conditioner::path::{Constraint, Motion};

/// Distances from the point at which the descents start, as shares of a length of 1 m: near and far obstacles alike.
const REACH: [f64; 4] = [0.01, 0.05, 0.2, 0.8];
/// Linearisations of one descent.
const ROUNDS: usize = 100;
/// A constraint counts as kept up to this, in units of `σ`.
const KEPT: f64 = 1e-9;

/// Choice of the descents' starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// From the last projection and from the reference: follows a local optimum along a path.
    Follow,
    /// Also from points around the reference, near and far.
    Many,
}

/// The nearest allowed point to a reference that descents find from `last` and from points around the reference.
///
/// Where a descent comes to rest the point is stationary. `lower_bound` is the distance less the last step it wanted: it says
/// how closely the point is stationary, it is no bound on other local optima.
///
/// # Errors
///
/// [`ProjectionError::Empty`] if no descent ended in the set, [`ProjectionError::NotFinite`].
pub fn nearest<C: Constraint<3>>(
    constraints: &[C],
    reference: &Motion<3>,
    last: Option<[f64; 3]>,
    effort: Effort,
) -> Result<Projection<3>, ProjectionError> {
    if !reference.is_finite() {
        return Err(ProjectionError::NotFinite);
    }
    let p = &reference.position;
    if violation(constraints, reference, p) <= 0.0 {
        return Ok(Projection { point: *p, distance: 0.0, lower_bound: 0.0, violation: 0.0 });
    }
    let mut best: Option<(f64, [f64; 3], f64)> = None;
    let many = effort == Effort::Many || last.is_none();
    for start in starts(p, last).into_iter().take(if many { usize::MAX } else { 2 }) {
        let Some((point, step)) = descend(constraints, reference, start) else { continue };
        let found = distance(p, &point);
        if best.is_none_or(|(nearest, ..)| found < nearest) {
            best = Some((found, point, step));
        }
    }
    let (found, point, step) = best.ok_or(ProjectionError::Empty)?;
    let violation = violation(constraints, reference, &point);
    Ok(Projection { point, distance: found, lower_bound: found - step, violation })
}

fn starts(p: &[f64; 3], last: Option<[f64; 3]>) -> Vec<[f64; 3]> {
    let mut starts: Vec<[f64; 3]> = last.into_iter().chain([*p]).collect();
    for reach in REACH {
        for axis in 0..3 {
            for sign in [-1.0, 1.0] {
                let mut start = *p;
                start[axis] += sign * reach;
                starts.push(start);
            }
        }
    }
    starts
}

fn at(reference: &Motion<3>, x: &[f64; 3]) -> Motion<3> {
    Motion { position: *x, velocity: [0.0; 3], time: reference.time }
}

fn violation<C: Constraint<3>>(constraints: &[C], reference: &Motion<3>, x: &[f64; 3]) -> f64 {
    constraints.iter().map(|c| c.sample(&at(reference, x)).value).fold(f64::NEG_INFINITY, f64::max)
}

/// Where a descent ends, and the last step it wanted; `None` if it never reached the set.
///
/// Each step aims at the nearest point to `p` within the constraints linearised at `x`, is cut to a trust radius, brought
/// back into the set and taken only if it came nearer.
fn descend<C: Constraint<3>>(constraints: &[C], reference: &Motion<3>, start: [f64; 3]) -> Option<([f64; 3], f64)> {
    let p = &reference.position;
    let mut x = restore(constraints, reference, start)?;
    let (mut trust, mut wanted) = (0.2, f64::INFINITY);
    for _ in 0..ROUNDS {
        let push = linearised(constraints, reference, &x, p)?;
        let step: [f64; 3] = std::array::from_fn(|i| p[i] + push[i] - x[i]);
        wanted = distance(&step, &[0.0; 3]);
        if wanted < 1e-13 || trust < 1e-13 {
            break;
        }
        let share = (trust / wanted).min(1.0);
        let trial = restore(constraints, reference, std::array::from_fn(|i| x[i] + share * step[i]));
        match trial.filter(|t| distance(p, t) < distance(p, &x)) {
            Some(nearer) => {
                x = nearer;
                trust *= 2.0;
            }
            None => trust *= 0.25,
        }
    }
    Some((x, wanted))
}

/// The smallest displacement from `from` that keeps the constraints linearised at `x`.
fn linearised<C: Constraint<3>>(
    constraints: &[C],
    reference: &Motion<3>,
    x: &[f64; 3],
    from: &[f64; 3],
) -> Option<Vec<f64>> {
    let (mut rows, mut bounds) = (Vec::new(), Vec::new());
    for constraint in constraints {
        let s = constraint.sample(&at(reference, x));
        bounds.push((0..3).map(|i| s.gradient[i] * (x[i] - from[i])).sum::<f64>() - s.value);
        rows.push(s.gradient.to_vec());
    }
    DualActiveSet.smallest(&rows, &bounds)
}

/// Brings a point into the set by Newton steps of least length.
fn restore<C: Constraint<3>>(constraints: &[C], reference: &Motion<3>, mut x: [f64; 3]) -> Option<[f64; 3]> {
    for _ in 0..ROUNDS {
        if violation(constraints, reference, &x) <= KEPT {
            return Some(x);
        }
        let step = linearised(constraints, reference, &x, &x)?;
        x = std::array::from_fn(|i| x[i] + step[i]);
    }
    None
}
