//! Clarabel with data updates: what the active-set method is checked against and measured beside.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, SolverStatus, SupportedConeT::NonnegativeConeT};

use slideway_baselines::safety_filter::SmallestPush;

/// A Clarabel solver that keeps its structure from sample to sample and is given new numbers only.
///
/// Presolve is off, as updates demand, and the pattern is dense. Solved to 1e-12 (at 1e-8 the push is off by up to
/// 4e-5).
pub(crate) struct ConicPush {
    solver: Option<(DefaultSolver<f64>, usize, usize)>,
}

impl Default for ConicPush {
    fn default() -> Self {
        Self::new()
    }
}

impl ConicPush {
    /// A solver that is set up at its first use.
    pub(crate) fn new() -> Self {
        Self { solver: None }
    }

    fn set_up(rows: usize, columns: usize) -> Option<DefaultSolver<f64>> {
        let settings = DefaultSettings {
            verbose: false,
            presolve_enable: false,
            tol_gap_abs: 1e-12,
            tol_gap_rel: 1e-12,
            tol_feas: 1e-12,
            direct_solve_method: "qdldl".into(),
            ..DefaultSettings::default()
        };
        // Ones everywhere: a full pattern that later numbers, zeros among them, fit into.
        let a = CscMatrix::from(&vec![vec![1.0; columns]; rows]);
        let cones = [NonnegativeConeT(rows)];
        let p = CscMatrix::identity(columns);
        DefaultSolver::new(&p, &vec![0.0; columns], &a, &vec![1.0; rows], &cones, settings).ok()
    }
}

impl SmallestPush for ConicPush {
    fn smallest(&mut self, rows: &[Vec<f64>], bounds: &[f64]) -> Option<Vec<f64>> {
        let (m, n) = (rows.len(), rows.first().map_or(0, Vec::len));
        // A pattern of another size is a new solver.
        if self.solver.as_ref().is_none_or(|&(_, rows, columns)| (rows, columns) != (m, n)) {
            self.solver = Some((Self::set_up(m, n)?, m, n));
        }
        let (solver, _, _) = self.solver.as_mut()?;
        // Rows and bounds at unit size: absolute tolerances then mean the same at every sample.
        let lengths: Vec<f64> = rows.iter().map(|r| r.iter().map(|x| x * x).sum::<f64>().sqrt()).collect();
        let size = bounds.iter().zip(&lengths).map(|(b, l)| (b / l).abs()).fold(f64::MIN_POSITIVE, f64::max);
        let columns: Vec<f64> =
            (0..n).flat_map(|j| (0..m).map(move |i| (i, j))).map(|(i, j)| rows[i][j] / lengths[i]).collect();
        let scaled: Vec<f64> = bounds.iter().zip(&lengths).map(|(b, l)| b / (l * size)).collect();
        solver.update_A(&columns).ok()?;
        solver.update_b(&scaled).ok()?;
        solver.solve();
        match solver.solution.status {
            SolverStatus::Solved | SolverStatus::AlmostSolved => {
                Some(solver.solution.x.iter().map(|x| size * x).collect())
            }
            _ => None,
        }
    }
}
