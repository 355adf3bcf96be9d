//! The same program for the conic solver Clarabel: a reference for the structured solver, and a second try.
//!
//! At every Lobatto point `v = form · x`, `r <= √v` as `(v + 1, v - 1, 2 r) ∈ Q³` and `t >= 1 / r` as `(r + t, r - t, 2) ∈ Q³`; minimise the weighted sum of
//! `t`. Variables are interleaved by cell, so that the factorisation stays banded.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettingsBuilder, DefaultSolver, IPSolver, SupportedConeT};

use super::interior_point::{Answer, FORMS, Program, WEIGHTS};

/// Variables of a cell: two of `b`, and `r, t` at its first three Lobatto points. The last node has three.
const STRIDE: usize = 8;

/// Triplets of the constraints in the solver's form `A z + s = rhs`.
#[derive(Default)]
struct Build {
    rows: Vec<usize>,
    columns: Vec<usize>,
    values: Vec<f64>,
    rhs: Vec<f64>,
}

impl Build {
    fn row(&mut self, entries: impl IntoIterator<Item = (usize, f64)>, rhs: f64) {
        for (column, value) in entries {
            self.rows.push(self.rhs.len());
            self.columns.push(column);
            self.values.push(value);
        }
        self.rhs.push(rhs);
    }
}

/// Columns of the three numbers of `b` in a cell.
fn columns(cell: usize) -> [usize; 3] {
    [STRIDE * cell, STRIDE * cell + 1, STRIDE * (cell + 1)]
}

/// Column of `r` at a Lobatto point, that of `t` follows it. The last point is the next cell's first.
fn root(cell: usize, point: usize) -> usize {
    if point < 3 { STRIDE * cell + 2 + 2 * point } else { STRIDE * (cell + 1) + 2 }
}

/// Solves the program; `None` if the solver refuses its data or ends without numbers. As for the other solver, nothing is believed.
pub(crate) fn solve(program: &Program, tolerance: f64) -> Option<Answer> {
    let cells = program.lengths.len();
    let variables = STRIDE * cells + 4;
    let mut build = Build::default();
    for k in 0..cells {
        for row in &program.rows[program.first[k]..program.first[k + 1]] {
            build.row(columns(k).into_iter().zip(*row), 1.0);
        }
    }
    let mut objective = vec![0.0; variables];
    let mut cones = 0;
    for k in 0..cells {
        for point in 0..4 {
            objective[root(k, point) + 1] += program.lengths[k] * WEIGHTS[point];
            if point < 3 || k + 1 == cells {
                point_cones(&mut build, k, point);
                cones += 2;
            }
        }
    }
    let mut kinds = vec![SupportedConeT::NonnegativeConeT(program.rows.len())];
    kinds.extend(vec![SupportedConeT::SecondOrderConeT(3); cones]);
    let matrix = CscMatrix::new_from_triplets(build.rhs.len(), variables, build.rows, build.columns, build.values);
    let settings = DefaultSettingsBuilder::default()
        .verbose(false)
        .tol_gap_abs(tolerance)
        .tol_gap_rel(tolerance)
        .tol_feas(tolerance)
        .max_iter(200)
        .direct_solve_method("qdldl".to_owned())
        .build()
        .ok()?;
    let quadratic = CscMatrix::zeros((variables, variables));
    let mut solver = DefaultSolver::new(&quadratic, &objective, &matrix, &build.rhs, &kinds, settings).ok()?;
    solver.solve();
    let solution = &solver.solution;
    let x: Vec<f64> = (0..=2 * cells).map(|i| solution.x[STRIDE * (i / 2) + i % 2]).collect();
    let z = solution.z[..program.rows.len()].iter().map(|z| z.max(0.0)).collect();
    let is_finite = x.iter().all(|x| x.is_finite());
    is_finite.then_some(Answer { x, z, steps: solution.iterations as usize, converged: true })
}

fn point_cones(build: &mut Build, cell: usize, point: usize) {
    let (r, form) = (root(cell, point), FORMS[point]);
    let v = || columns(cell).into_iter().zip(form.map(|f| -f)).filter(|(_, f)| *f != 0.0);
    build.row(v(), 1.0);
    build.row(v(), -1.0);
    build.row([(r, -2.0)], 0.0);
    build.row([(r, -1.0), (r + 1, -1.0)], 0.0);
    build.row([(r, -1.0), (r + 1, 1.0)], 0.0);
    build.row([], 2.0);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path_bracket::interior_point::{self, Start, Stop};

    #[test]
    fn both_solvers_find_the_same_time_and_multipliers_of_the_same_price() {
        // Ten cells whose middles and nodes are capped unevenly.
        let mut program = Program { first: vec![0], ..Program::default() };
        for k in 0..10 {
            program.lengths.push(0.1);
            let cap = 1.0 + 0.3 * f64::from(k % 3);
            for row in [
                [1.0 / cap, 0.0, 0.0],
                [0.0, 1.0 / cap, 0.0],
                [0.0, 0.0, 1.0 / cap],
                [-2.0, 2.5, 0.0],
                [0.0, -2.0, 2.5],
            ] {
                program.rows.push(row);
            }
            program.first.push(program.rows.len());
        }
        let own = interior_point::solve(&program, vec![0.3; 21], Start::Cold, Stop { tolerance: 1e-9, steps: 60 });
        let conic = solve(&program, 1e-9).expect("an answer");
        let (a, b) = (program.time(&own.x), program.time(&conic.x));
        // Both are within their tolerances of the optimum.
        assert!(own.converged && (a - b).abs() < 1e-7 * a, "{a} {b}");
        let price = |z: &[f64]| z.iter().sum::<f64>();
        assert!((price(&own.z) - price(&conic.z)).abs() < 1e-5 * price(&own.z));
    }
}
