use super::error::OptimumError;
use super::piece::PieceProgram;
use super::solver::SolverAnswer;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettingsBuilder, DefaultSolver, IPSolver, SupportedConeT};
use std::time::Instant;

/// Solver tolerance: the certificate closes to 1e-7 and better with it, and at 1e-9 the solver ends without meeting it.
const TOLERANCE: f64 = 1e-8;

/// Solves the program as a second-order cone program.
///
/// Variables `x_k, c_k, t_k` per node, interleaved so that the factorisation stays banded:
/// `c_k <= √x_k` as `(x+1, x-1, 2c) ∈ Q³` and `t_k >= 1 / (c_k + c_{k+1})` as `(c+c'+t, c+c'-t, 2) ∈ Q³`; minimise
/// `Σ 2 h_k t_k`. Given ends are eliminated: as equalities they would leave no interior point.
///
/// # Errors
///
/// The solver refuses the data. Any status is returned as it is.
pub fn solve_conic(program: &PieceProgram) -> Result<SolverAnswer, OptimumError> {
    let start = Instant::now();
    let layout = Layout::new(program);
    let mut build = Build::default();
    let border = program.border_rows();
    layout.caps_and_rows(program, &border, &mut build);
    let linear = build.rhs.len();
    layout.cones(program, &mut build);
    let cones = (build.rhs.len() - linear) / 3;
    let matrix =
        CscMatrix::new_from_triplets(build.rhs.len(), layout.variables, build.rows, build.columns, build.values);
    let mut objective = vec![0.0; layout.variables];
    for (k, h) in program.h.iter().enumerate() {
        objective[layout.t[k]] = 2.0 * h;
    }
    let mut kinds = vec![SupportedConeT::NonnegativeConeT(linear)];
    kinds.extend(vec![SupportedConeT::SecondOrderConeT(3); cones]);
    let settings = DefaultSettingsBuilder::default()
        .verbose(false)
        .tol_gap_abs(TOLERANCE)
        .tol_gap_rel(TOLERANCE)
        .tol_feas(TOLERANCE)
        .max_iter(200)
        .direct_solve_method("qdldl".to_owned())
        .presolve_enable(false)
        .build()
        .map_err(|error| OptimumError::Solver(error.to_string()))?;
    let quadratic = CscMatrix::zeros((layout.variables, layout.variables));
    let mut solver = DefaultSolver::new(&quadratic, &objective, &matrix, &build.rhs, &kinds, settings)
        .map_err(|error| OptimumError::Solver(error.to_string()))?;
    solver.solve();
    let solution = &solver.solution;
    let free = program.free();
    let b =
        (0..program.cap.len()).map(|k| layout.column[k].map_or(program.cap[k], |column| solution.x[column])).collect();
    let mut solved = solution.z[free.len()..linear].iter();
    let multipliers =
        border.iter().map(|&used| if used { solved.next().copied() } else { None }.unwrap_or(0.0)).collect();
    Ok(SolverAnswer {
        b,
        multipliers,
        status: format!("{:?}", solution.status),
        iterations: solution.iterations,
        solve_s: start.elapsed().as_secs_f64(),
    })
}

/// Triplets of the constraint matrix and the right-hand side, in the solver's form `A z + s = rhs`.
#[derive(Default)]
struct Build {
    rows: Vec<usize>,
    columns: Vec<usize>,
    values: Vec<f64>,
    rhs: Vec<f64>,
}

impl Build {
    /// One row with a few entries.
    fn row(&mut self, entries: &[(usize, f64)], rhs: f64) {
        for &(column, value) in entries {
            self.rows.push(self.rhs.len());
            self.columns.push(column);
            self.values.push(value);
        }
        self.rhs.push(rhs);
    }
}

/// Where the variables are: per free node `x, c`, per interval `t`, interleaved along the path.
struct Layout {
    /// Column of `x`, followed by that of `c`, where the node is free.
    column: Vec<Option<usize>>,
    /// Column of each interval's `t`.
    t: Vec<usize>,
    variables: usize,
}

impl Layout {
    fn new(program: &PieceProgram) -> Self {
        let mut layout = Self { column: Vec::new(), t: Vec::new(), variables: 0 };
        let free = program.free();
        for node in 0..program.cap.len() {
            layout.column.push(free.contains(&node).then_some(layout.variables));
            layout.variables += if free.contains(&node) { 2 } else { 0 };
            if node < program.h.len() {
                layout.t.push(layout.variables);
                layout.variables += 1;
            }
        }
        layout
    }

    /// `x_k <= cap_k`, then those of the program's rows that are needed.
    fn caps_and_rows(&self, program: &PieceProgram, border: &[bool], build: &mut Build) {
        for k in program.free() {
            build.row(&self.x(k, 1.0), program.cap[k]);
        }
        for (row, _) in program.rows().zip(border).filter(|(_, used)| **used) {
            let mut bound = row.bound;
            let mut entries = Vec::with_capacity(2);
            for (node, value) in [(row.interval, row.before), (row.interval + 1, row.after)] {
                match self.column[node] {
                    Some(column) => entries.push((column, value)),
                    None => bound -= value * program.cap[node],
                }
            }
            build.row(&entries, bound);
        }
    }

    fn x(&self, node: usize, value: f64) -> Vec<(usize, f64)> {
        self.column[node].map(|column| (column, value)).into_iter().collect()
    }

    fn cones(&self, program: &PieceProgram, build: &mut Build) {
        for column in self.column.iter().flatten() {
            build.row(&[(*column, -1.0)], 1.0);
            build.row(&[(*column, -1.0)], -1.0);
            build.row(&[(column + 1, -2.0)], 0.0);
        }
        for (k, &t) in self.t.iter().enumerate() {
            // The root of a given end is a number, not a variable.
            let given = |node: usize| if self.column[node].is_none() { program.cap[node].sqrt() } else { 0.0 };
            let constant = given(k) + given(k + 1);
            let roots = [k, k + 1].into_iter().filter_map(|k| self.column[k]).map(|column| (column + 1, -1.0));
            for sign in [-1.0, 1.0] {
                let entries: Vec<(usize, f64)> = roots.clone().chain([(t, sign)]).collect();
                build.row(&entries, constant);
            }
            build.row(&[], 2.0);
        }
    }
}
