use crate::controller::twist;
use crate::error::LabError;
use crate::problem::{Problem, pose};
use nalgebra::Vector3;
use slideway_robot::{
    InverseMethod, JacobiSvd, JointVector, NumericIk, NumericIkSettings, RobotError, Twist, euler, solve_rates,
};

/// The joint path that follows a tool path exactly, in smooth pieces.
///
/// Where the tool path crosses a singularity in a direction that no joint path follows continuously, a self-motion is
/// inserted: the tool stands still, the joints reorient. For a redundant arm the path is the one of least joint motion
/// from its start.
#[derive(Clone, Debug)]
pub struct JointPath<const N: usize> {
    pieces: Vec<Piece<N>>,
}

/// One smooth piece, parameterised by `s` from [`Piece::start`] to [`Piece::end`].
#[derive(Clone, Debug)]
pub struct Piece<const N: usize> {
    kind: PieceKind<N>,
    start: f64,
    end: f64,
}

/// What happens along a piece.
#[derive(Clone, Debug)]
pub enum PieceKind<const N: usize> {
    /// The tool follows the path; `s` is the path parameter. Configurations found while tracing, dense enough to start
    /// Newton's method from.
    Follow {
        /// Path parameters, increasing.
        at: Vec<f64>,
        /// Configurations there.
        q: Vec<JointVector<N>>,
        /// How far from its ends the piece is evaluated: at a singular end the derivatives exist as limits only.
        inset: f64,
    },
    /// The tool stands still and the joints move on a straight line; `s` runs from 0 to 1.
    SelfMotion {
        /// Path parameter at which the tool stands.
        lambda: f64,
        /// Configuration before.
        from: JointVector<N>,
        /// Configuration after.
        to: JointVector<N>,
    },
}

/// A point of a joint path with its derivatives by the piece's parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointPoint<const N: usize> {
    /// Path parameter of the tool path.
    pub lambda: f64,
    /// Configuration, rad.
    pub q: JointVector<N>,
    /// `q'(s)`.
    pub first: JointVector<N>,
    /// `q''(s)`.
    pub second: JointVector<N>,
}

/// Largest joint change between neighbouring configurations while tracing, rad.
const MAX_STEP: f64 = 0.02;
/// Steps per smooth stretch at the least.
const MIN_STEPS: f64 = 400.0;
/// Steps below this share of a stretch mean that the joint path breaks.
const SMALLEST: f64 = 1e-9;
/// How far beyond a break the continuation is looked for, and how far from a singular end derivatives are taken, as a share
/// of the stretch.
const BEYOND: f64 = 1e-6;
/// Ratio of the singular values below which a configuration counts as singular.
const SINGULAR: f64 = 1e-6;

impl<const N: usize> JointPath<N> {
    /// Traces the joint path from the configuration on the path's first point.
    ///
    /// # Errors
    ///
    /// The path leaves the robot's reach, or breaks where no self-motion leads on.
    pub fn trace(problem: &Problem<N>) -> Result<Self, LabError> {
        let mut ends = problem.path.kinks();
        ends.push(problem.path.end());
        let mut path = Self { pieces: Vec::new() };
        let mut q = problem.path_start;
        let mut begin = problem.path.start();
        for end in ends {
            let stretch = end - begin;
            while begin < end {
                let (piece, failure) = follow(problem, begin, end, q);
                if let Some(last) = piece.last() {
                    q = *last;
                }
                let reached = piece.end;
                path.push(problem, piece);
                begin = reached;
                if let Some(failure) = failure {
                    let resume = (begin + BEYOND * stretch).min(end);
                    let next = self_motion(problem, begin, resume, &q, failure)?;
                    path.pieces.push(Piece {
                        kind: PieceKind::SelfMotion { lambda: begin, from: q, to: next },
                        start: 0.0,
                        end: 1.0,
                    });
                    (begin, q) = (resume, next);
                }
            }
            begin = end;
        }
        Ok(path)
    }

    /// The pieces, in the order of the path.
    #[must_use]
    pub fn pieces(&self) -> &[Piece<N>] {
        &self.pieces
    }

    /// Adds a followed stretch unless nothing of it was followed, with the inset its ends call for.
    fn push(&mut self, problem: &Problem<N>, piece: Piece<N>) {
        let PieceKind::Follow { at, q, .. } = piece.kind else { return };
        if at.len() < 2 {
            return;
        }
        let singular = [q.first(), q.last()].into_iter().flatten().any(|q| is_singular(problem, q));
        let inset = (piece.end - piece.start) * if singular { BEYOND } else { SMALLEST };
        self.pieces.push(Piece { kind: PieceKind::Follow { at, q, inset }, start: piece.start, end: piece.end });
    }
}

impl<const N: usize> Piece<N> {
    /// Parameter at the start.
    #[must_use]
    pub fn start(&self) -> f64 {
        self.start
    }

    /// Parameter at the end.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.end
    }

    /// What happens along it.
    #[must_use]
    pub fn kind(&self) -> &PieceKind<N> {
        &self.kind
    }

    fn last(&self) -> Option<&JointVector<N>> {
        match &self.kind {
            PieceKind::Follow { q, .. } => q.last(),
            PieceKind::SelfMotion { to, .. } => Some(to),
        }
    }

    /// The joint path at a parameter, clamped to the piece.
    ///
    /// `q' = J⁺ [f'; E rates]` and `q'' = J⁺ ([f''; E rates' + Ė rates] - J̇ q')`, at the exact configuration.
    ///
    /// # Errors
    ///
    /// The inverse kinematics fails at a place it passed while tracing.
    pub fn at(&self, problem: &Problem<N>, s: f64) -> Result<JointPoint<N>, LabError> {
        match &self.kind {
            PieceKind::SelfMotion { lambda, from, to } => Ok(JointPoint {
                lambda: *lambda,
                q: from + (to - from) * s.clamp(0.0, 1.0),
                first: to - from,
                second: JointVector::zeros(),
            }),
            PieceKind::Follow { at, q, inset } => {
                let lambda = s.max(self.start + inset).min(self.end - inset);
                let seed = interpolate(at, q, lambda);
                let q = configuration(problem, lambda, &seed)
                    .map_err(|source| LabError::LeavesReach { at: lambda, source })?;
                let (first, second) = derivatives(problem, lambda, &q);
                Ok(JointPoint { lambda, q, first, second })
            }
        }
    }

    /// Parameters from start to end, `intervals + 1` of them: half of the density goes with the path parameter, half with
    /// the time that the joint-speed limits need, so that a short stretch of fast joint motion is resolved as well.
    #[must_use]
    #[allow(clippy::cast_precision_loss)]
    pub fn grid(&self, problem: &Problem<N>, intervals: usize) -> Vec<f64> {
        let share = |i: usize| i as f64 / intervals as f64;
        let PieceKind::Follow { at, q, .. } = &self.kind else { return (0..=intervals).map(share).collect() };
        let mut cumulative = vec![0.0];
        for pair in q.windows(2) {
            let ratio = problem.speed_limits.ratio(&(pair[1] - pair[0]).into());
            cumulative.push(cumulative[cumulative.len() - 1] + ratio);
        }
        let total = cumulative[cumulative.len() - 1];
        let length = self.end - self.start;
        for (c, s) in cumulative.iter_mut().zip(at) {
            let time_share = if total > 0.0 { *c / total } else { (s - self.start) / length };
            *c = 0.5 * (time_share + (s - self.start) / length);
        }
        let mut grid: Vec<f64> = (0..=intervals).map(|i| invert(&cumulative, at, share(i))).collect();
        (grid[0], grid[intervals]) = (self.start, self.end);
        grid
    }
}

/// Follows the path from a configuration until `end` or until it breaks; the piece found, and why it broke.
fn follow<const N: usize>(
    problem: &Problem<N>,
    begin: f64,
    end: f64,
    q: JointVector<N>,
) -> (Piece<N>, Option<RobotError>) {
    let stretch = end - begin;
    let (mut at, mut configurations) = (vec![begin], vec![q]);
    let (mut lambda, mut q, mut step) = (begin, q, stretch / MIN_STEPS);
    let mut slope = JointVector::<N>::zeros();
    let mut failure = None;
    while lambda < end {
        // A remainder below the smallest step is taken along.
        let next = if lambda + step > end - SMALLEST * stretch { end } else { lambda + step };
        let seed = q + slope * (next - lambda);
        match configuration(problem, next, &seed) {
            Ok(found) if (found - q).amax() <= MAX_STEP => {
                slope = (found - q) / (next - lambda);
                (lambda, q) = (next, found);
                at.push(lambda);
                configurations.push(q);
                step = (2.0 * step).min(stretch / MIN_STEPS);
            }
            outcome => {
                step = 0.5 * (next - lambda);
                slope *= 0.5;
                if step < SMALLEST * stretch {
                    failure = Some(outcome.err().unwrap_or(RobotError::NotConverged {
                        position_error: 0.0,
                        orientation_error: 0.0,
                        iterations: 0,
                    }));
                    break;
                }
            }
        }
    }
    let kind = PieceKind::Follow { at, q: configurations, inset: 0.0 };
    (Piece { kind, start: begin, end: lambda }, failure)
}

/// The configuration nearest to a seed that puts the tool on the path.
fn configuration<const N: usize>(
    problem: &Problem<N>,
    lambda: f64,
    seed: &JointVector<N>,
) -> Result<JointVector<N>, RobotError> {
    let target = pose(&problem.path.at(lambda).coordinates);
    NumericIk::new(&problem.arm, problem.task, NumericIkSettings::default()).solve(&target, seed)
}

fn derivatives<const N: usize>(
    problem: &Problem<N>,
    lambda: f64,
    q: &JointVector<N>,
) -> (JointVector<N>, JointVector<N>) {
    let point = problem.path.at(lambda);
    let angles: Vector3<f64> = point.coordinates.fixed_rows::<3>(3).into();
    let rates: Vector3<f64> = point.first.fixed_rows::<3>(3).into();
    let jacobian = problem.arm.jacobian(q);
    // A cutoff at rounding level: the exact inverse wherever there is one.
    let method = InverseMethod::TruncatedSvd { cutoff: 1e-13 };
    let first = solve_rates(method, problem.task, &jacobian, &twist(&point.first, &angles));
    let spin = euler::rate_map_bias(&angles, &rates);
    let acceleration = twist(&point.second, &angles) + Twist::new(0.0, 0.0, 0.0, spin.x, spin.y, spin.z);
    let second =
        solve_rates(method, problem.task, &jacobian, &(acceleration - problem.arm.bias_acceleration(q, &first)));
    (first, second)
}

fn is_singular<const N: usize>(problem: &Problem<N>, q: &JointVector<N>) -> bool {
    let (smallest, largest, _) = weakest_direction(problem, q);
    !(smallest > SINGULAR * largest)
}

/// Smallest and largest singular value of the task's Jacobian (of as many as the task has rows), and the joint direction
/// of the smallest.
fn weakest_direction<const N: usize>(problem: &Problem<N>, q: &JointVector<N>) -> (f64, f64, JointVector<N>) {
    let full = problem.arm.jacobian(q);
    let mut rows = slideway_robot::Jacobian::<N>::zeros();
    for &row in problem.task.rows() {
        rows.set_row(row, &full.row(row));
    }
    let Some(svd) = JacobiSvd::new(&rows) else { return (0.0, 1.0, JointVector::zeros()) };
    let mut order: Vec<(f64, usize)> = (0..N).map(|k| (svd.singular_value(k), k)).collect();
    order.sort_by(|a, b| b.0.total_cmp(&a.0));
    let (smallest, index) = order[problem.task.rows().len().min(N) - 1];
    (smallest, order[0].0, svd.v.column(index).into_owned())
}

/// Looks for the configuration from which the path goes on after a break: along the self-motion of the singularity, the
/// one reached soonest under the speed limits.
fn self_motion<const N: usize>(
    problem: &Problem<N>,
    at: f64,
    resume: f64,
    q: &JointVector<N>,
    failure: RobotError,
) -> Result<JointVector<N>, LabError> {
    const TRIALS: i32 = 180;
    let (smallest, largest, direction) = weakest_direction(problem, q);
    // Within the share BEYOND of a singularity the smallest singular value is of that order too; 1e-3 leaves room.
    if smallest > 1e-3 * largest {
        return Err(LabError::LeavesReach { at, source: failure });
    }
    let direction = direction / direction.amax();
    let time = |next: &JointVector<N>| problem.speed_limits.ratio(&(next - q).into());
    let mut best: Option<JointVector<N>> = None;
    let mut jump = f64::INFINITY;
    for i in -TRIALS..=TRIALS {
        let seed = q + direction * (std::f64::consts::PI * f64::from(i) / f64::from(TRIALS));
        let Ok(next) = configuration(problem, resume, &seed) else { continue };
        jump = jump.min((next - q).amax());
        if stands_still(problem, at, q, &next) && best.as_ref().is_none_or(|b| time(&next) < time(b)) {
            best = Some(next);
        }
    }
    // No configuration at all beyond the break: the arm is stretched out, not in the way of itself.
    best.ok_or(if jump.is_finite() {
        LabError::BrokenPath { at, jump }
    } else {
        LabError::LeavesReach { at, source: failure }
    })
}

/// Whether the tool keeps its place while the joints go straight from one configuration to the other: within 10 µm and
/// 10 µrad plus what the path itself moves over the share [`BEYOND`].
fn stands_still<const N: usize>(problem: &Problem<N>, at: f64, from: &JointVector<N>, to: &JointVector<N>) -> bool {
    let ik = NumericIk::new(&problem.arm, problem.task, NumericIkSettings::default());
    let target = pose(&problem.path.at(at).coordinates);
    (0..=20).all(|i| {
        let q = from + (to - from) * (f64::from(i) / 20.0);
        ik.error(&target, &q).norm() < 1e-5 + 10.0 * BEYOND
    })
}

/// Linear interpolation between traced configurations.
fn interpolate<const N: usize>(at: &[f64], q: &[JointVector<N>], s: f64) -> JointVector<N> {
    let after = at.partition_point(|&x| x <= s).clamp(1, at.len() - 1);
    let fraction = (s - at[after - 1]) / (at[after] - at[after - 1]);
    q[after - 1] + (q[after] - q[after - 1]) * fraction
}

/// The abscissa at which a piecewise linear increasing function takes a value.
fn invert(values: &[f64], at: &[f64], value: f64) -> f64 {
    let after = values.partition_point(|&v| v <= value).clamp(1, values.len() - 1);
    let fraction = (value - values[after - 1]) / (values[after] - values[after - 1]);
    at[after - 1] + (at[after] - at[after - 1]) * fraction
}
