//! Projection onto convex sets as a second-order cone program.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSolver, IPSolver, SolverStatus, SupportedConeT, SupportedConeT::NonnegativeConeT,
    SupportedConeT::SecondOrderConeT,
};

use super::{Projection, ProjectionError, distance};

/// A convex set in `N` dimensions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ConvexSet<const N: usize> {
    /// `nᵀ x <= d`.
    HalfSpace {
        /// Outward normal, of any length.
        normal: [f64; N],
        /// Bound `d`.
        offset: f64,
    },
    /// `‖D⁻¹ (x - c)‖ <= 1`, `D` a diagonal of semi-axes: a ball if they are equal.
    Ellipsoid {
        /// Centre `c`.
        centre: [f64; N],
        /// Semi-axes.
        semi_axes: [f64; N],
    },
    /// `‖(I - a aᵀ)(x - c)‖ <= r`.
    Cylinder {
        /// A point on the axis.
        point: [f64; N],
        /// Unit direction of the axis.
        axis: [f64; N],
        /// Radius.
        radius: f64,
    },
}

/// One block of rows of `A x + s = b`, `s` in a cone.
struct Block<const N: usize> {
    rows: Vec<([f64; N], f64)>,
    cone: SupportedConeT<f64>,
}

impl<const N: usize> ConvexSet<N> {
    fn block(&self) -> Block<N> {
        match *self {
            Self::HalfSpace { normal, offset } => Block { rows: vec![(normal, offset)], cone: NonnegativeConeT(1) },
            Self::Ellipsoid { centre, semi_axes } => {
                let rows = (0..N).map(|i| {
                    let mut row = [0.0; N];
                    row[i] = -1.0 / semi_axes[i];
                    (row, -centre[i] / semi_axes[i])
                });
                Block { rows: [([0.0; N], 1.0)].into_iter().chain(rows).collect(), cone: SecondOrderConeT(N + 1) }
            }
            Self::Cylinder { point, axis, radius } => {
                let rows = (0..N).map(|i| {
                    let row: [f64; N] = std::array::from_fn(|j| axis[i] * axis[j] - f64::from(u8::from(i == j)));
                    let bound = row.iter().zip(&point).map(|(r, c)| r * c).sum();
                    (row, bound)
                });
                Block { rows: [([0.0; N], radius)].into_iter().chain(rows).collect(), cone: SecondOrderConeT(N + 1) }
            }
        }
    }

    /// Amount by which `x` is outside, in the units of the set's own inequality; negative inside.
    #[must_use]
    pub fn violation(&self, x: &[f64; N]) -> f64 {
        let slack: Vec<f64> = self.block().rows.iter().map(|(row, b)| b - dot(row, x)).collect();
        match slack.split_first() {
            Some((first, rest)) => rest.iter().map(|s| s * s).sum::<f64>().sqrt() - first,
            None => 0.0,
        }
    }
}

fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// The point of the intersection of `sets` nearest to `p`.
///
/// Solved to 1e-12: at Clarabel's default of 1e-8 the point is off by up to 4e-5, since the objective is flat there. The
/// lower bound is the dual value at the returned multipliers after they were moved into the dual cone, in closed form:
///
/// ```text
/// ½ d² >= -½ ‖Aᵀ z‖² + zᵀ (A p - b)     for every z in the dual cone
/// ```
///
/// # Errors
///
/// [`ProjectionError::Empty`] if the solver proves the set empty, otherwise what went wrong.
pub fn project<const N: usize>(p: &[f64; N], sets: &[ConvexSet<N>]) -> Result<Projection<N>, ProjectionError> {
    if !p.iter().all(|x| x.is_finite()) {
        return Err(ProjectionError::NotFinite);
    }
    let blocks: Vec<Block<N>> = sets.iter().map(ConvexSet::block).collect();
    let rows: Vec<&([f64; N], f64)> = blocks.iter().flat_map(|block| &block.rows).collect();
    let cones: Vec<SupportedConeT<f64>> = blocks.iter().map(|block| block.cone.clone()).collect();
    let (point, multipliers) = solve(p, &rows, &cones)?;
    Ok(Projection {
        point,
        distance: distance(p, &point),
        lower_bound: lower_bound(p, &blocks, &multipliers),
        violation: sets.iter().map(|set| set.violation(&point)).fold(f64::NEG_INFINITY, f64::max),
    })
}

fn solve<const N: usize>(
    p: &[f64; N],
    rows: &[&([f64; N], f64)],
    cones: &[SupportedConeT<f64>],
) -> Result<([f64; N], Vec<f64>), ProjectionError> {
    let dense: Vec<Vec<f64>> = rows.iter().map(|(row, _)| row.to_vec()).collect();
    let a = CscMatrix::from(&dense);
    let b: Vec<f64> = rows.iter().map(|(_, bound)| *bound).collect();
    let q: Vec<f64> = p.iter().map(|x| -x).collect();
    let settings = DefaultSettings {
        verbose: false,
        tol_gap_abs: 1e-12,
        tol_gap_rel: 1e-12,
        tol_feas: 1e-12,
        // What an answer that gets no farther must keep all the same, relative to `1 + ‖b‖ + ‖x‖ + ‖s‖`.
        reduced_tol_feas: 1e-7,
        direct_solve_method: "qdldl".into(),
        ..DefaultSettings::default()
    };
    let mut solver =
        DefaultSolver::new(&CscMatrix::identity(N), &q, &a, &b, cones, settings).map_err(|_| ProjectionError::Setup)?;
    solver.solve();
    match solver.solution.status {
        // An answer short of the asked tolerance is still judged by its own re-checked bracket.
        SolverStatus::Solved | SolverStatus::AlmostSolved => {
            let point = std::array::from_fn(|i| solver.solution.x.get(i).copied().unwrap_or(f64::NAN));
            Ok((point, solver.solution.z.clone()))
        }
        SolverStatus::PrimalInfeasible | SolverStatus::AlmostPrimalInfeasible => Err(ProjectionError::Empty),
        status => Err(ProjectionError::Solver(status)),
    }
}

/// Distance that weak duality guarantees for these multipliers, in floating point too.
///
/// Rounding. With `K` rows a term of the value is rounded at most `N + K + 2` times and a component of `Aᵀ z` at most `K + 1` times, each
/// by half a unit in the last place: together by less than `(N + K + 4) ε` of the sums of absolute values, which are taken off.
fn lower_bound<const N: usize>(p: &[f64; N], blocks: &[Block<N>], multipliers: &[f64]) -> f64 {
    let roundings = (N + 4 + multipliers.len()) as f64 * f64::EPSILON;
    let (mut pull, mut value) = ([0.0; N], 0.0);
    let (mut pull_size, mut value_size) = ([0.0; N], 0.0);
    let mut rest = multipliers;
    for block in blocks {
        let (z, after) = rest.split_at(block.rows.len().min(rest.len()));
        rest = after;
        let mut z = z.to_vec();
        if let Some((first, tail)) = z.split_first_mut() {
            // The dual cone is the cone itself: raise the first entry until the rest fits under it, also where its length is rounded down.
            *first = first.max(tail.iter().map(|t| t * t).sum::<f64>().sqrt() * (1.0 + roundings));
        }
        for (z, (row, b)) in z.iter().zip(&block.rows) {
            value += z * (dot(row, p) - b);
            value_size += z.abs() * (dot(&row.map(f64::abs), &p.map(f64::abs)) + b.abs());
            for ((s, size), r) in pull.iter_mut().zip(&mut pull_size).zip(row) {
                *s += z * r;
                *size += (z * r).abs();
            }
        }
    }
    let rounded = roundings * (value_size + dot(&pull_size, &pull_size));
    // The root and what is under it are rounded as well.
    (2.0 * (value - 0.5 * dot(&pull, &pull) - rounded)).max(0.0).sqrt() * (1.0 - 2.0 * f64::EPSILON)
}
