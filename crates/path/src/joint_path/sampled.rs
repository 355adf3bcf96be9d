use super::{JointPath, JointPoint, Piece, PieceKind};
use crate::error::ProblemError;
use crate::limits::rows::{EndRate, LimitKind, LinearLimit, SpeedLimit};
use crate::path_problem::PathProblem;

/// A joint path sampled on a grid, with its limits: what an offline optimum needs, whatever the number of joints.
///
/// Limits that hold everywhere are here; those that vary along the path, torque and tool limits are in each
/// [`PathSample`]. All of them apply.
#[derive(Clone, Debug)]
pub struct SampledPath {
    /// Number of joints.
    pub joints: usize,
    /// Lower speed limits, rad/s, negative.
    pub speed_lower: Vec<f64>,
    /// Upper speed limits, rad/s, positive.
    pub speed_upper: Vec<f64>,
    /// Acceleration limits, rad/s², symmetric.
    pub acceleration: Option<Vec<f64>>,
    /// The smooth pieces.
    pub pieces: Vec<SampledPiece>,
}

/// A smooth piece on a grid.
#[derive(Clone, Debug)]
pub struct SampledPiece {
    /// The grid's nodes.
    pub nodes: Vec<PathSample>,
    /// Samples strictly between the nodes, `between[k]` in the interval after node `k`.
    pub between: Vec<Vec<PathSample>>,
    /// True if the tool stands still along the piece.
    pub is_self_motion: bool,
    /// Path rate at the first node.
    pub start: EndRate,
    /// Path rate at the last node.
    pub end: EndRate,
}

/// One point of a sampled joint path.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PathSample {
    /// The piece's parameter.
    pub s: f64,
    /// Path parameter of the tool path.
    pub lambda: f64,
    /// `q'(s)`, rad.
    pub first: Vec<f64>,
    /// `q''(s)`, rad.
    pub second: Vec<f64>,
    /// Limits linear in `s̈` and `ṡ²` at this point, besides the path's own.
    pub limits: Vec<LinearLimit>,
    /// Bounds on `ṡ` at this point, besides the path's own.
    pub speeds: Vec<SpeedLimit>,
}

impl SampledPath {
    /// Samples a joint path of a problem with about `intervals` intervals in all and `between` samples inside each.
    ///
    /// # Errors
    ///
    /// The inverse kinematics fails at a place it passed while tracing.
    pub fn new<const N: usize>(
        problem: &PathProblem<N>,
        path: &JointPath<N>,
        intervals: usize,
        between: usize,
    ) -> Result<Self, ProblemError> {
        let mut sampled = Self {
            joints: N,
            speed_lower: problem.speed_limits.lower().to_vec(),
            speed_upper: problem.speed_limits.upper().to_vec(),
            acceleration: problem.everywhere_acceleration().map(|a| a.to_vec()),
            pieces: Vec::new(),
        };
        for (piece, intervals) in path.pieces().iter().zip(shares(problem, path, intervals)) {
            sampled.pieces.push(sample_piece(problem, piece, intervals, between)?);
        }
        if let Some(first) = sampled.pieces.first_mut() {
            first.start = problem.start_rate;
        }
        if let Some(last) = sampled.pieces.last_mut() {
            last.end = problem.end_rate;
        }
        Ok(sampled)
    }

    /// The shortest time under speed limits alone, by the trapezoidal rule on all samples:
    /// `T* = ∫ max_i (q_i'(s) / limit_i) ds`, s.
    #[must_use]
    pub fn speed_limited_time(&self) -> f64 {
        self.pieces.iter().map(|piece| self.piece_time(piece)).sum()
    }

    /// The largest use of a speed limit per unit of path speed: `1 / ṡ_max`. NaN if a limit has the wrong sign.
    #[must_use]
    pub fn slowness(&self, sample: &PathSample) -> f64 {
        let joints = sample.first.iter().zip(self.speed_lower.iter().zip(&self.speed_upper));
        let mut worst = joints
            .map(|(&v, (&lo, &up))| if v < 0.0 { v / lower_or_nan(lo) } else { v / upper_or_nan(up) })
            .fold(0.0, max_or_nan);
        for limit in &sample.speeds {
            worst = max_or_nan(worst, 1.0 / upper_or_nan(limit.rate));
        }
        worst
    }

    /// The speed limit that bounds the path rate at a sample: what it is on and which joint's.
    #[must_use]
    pub fn tightest_speed(&self, sample: &PathSample) -> (LimitKind, usize) {
        let mut tightest = (0.0, LimitKind::JointSpeed, 0);
        for (i, (&v, (&lo, &up))) in sample.first.iter().zip(self.speed_lower.iter().zip(&self.speed_upper)).enumerate()
        {
            let use_of = if v < 0.0 { v / lo } else { v / up };
            if use_of > tightest.0 {
                tightest = (use_of, LimitKind::JointSpeed, i);
            }
        }
        for limit in &sample.speeds {
            if 1.0 / limit.rate > tightest.0 {
                tightest = (1.0 / limit.rate, limit.kind, limit.index);
            }
        }
        (tightest.1, tightest.2)
    }

    /// The same path under its speed limits alone, its ends free.
    #[must_use]
    pub fn under_speed_limits_alone(&self) -> Self {
        let mut path = Self { acceleration: None, ..self.clone() };
        for piece in &mut path.pieces {
            (piece.start, piece.end) = (EndRate::Free, EndRate::Free);
            for sample in piece.nodes.iter_mut().chain(piece.between.iter_mut().flatten()) {
                sample.limits.clear();
            }
        }
        path
    }

    /// True if a limit depends on the acceleration along a piece.
    #[must_use]
    pub fn limits_acceleration(&self, piece: &SampledPiece) -> bool {
        self.acceleration.is_some() || piece.nodes.iter().any(|node| !node.limits.is_empty())
    }

    fn piece_time(&self, piece: &SampledPiece) -> f64 {
        let samples = piece.in_order();
        samples.windows(2).map(|w| 0.5 * (w[1].s - w[0].s) * (self.slowness(w[0]) + self.slowness(w[1]))).sum()
    }
}

/// The larger of two numbers, NaN if one of them is: a ratio that is no number must not pass as a small one.
fn max_or_nan(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}

/// A lower limit is negative by construction; anything else must not pass as a small ratio.
fn lower_or_nan(lower: f64) -> f64 {
    if lower < 0.0 { lower } else { f64::NAN }
}

/// An upper limit is positive by construction.
fn upper_or_nan(upper: f64) -> f64 {
    if upper > 0.0 { upper } else { f64::NAN }
}

impl SampledPiece {
    /// Nodes and the samples between them, in the order of the path.
    #[must_use]
    pub fn in_order(&self) -> Vec<&PathSample> {
        let mut samples = Vec::new();
        for (k, node) in self.nodes.iter().enumerate() {
            samples.push(node);
            samples.extend(self.between.get(k).into_iter().flatten());
        }
        samples
    }
}

/// Intervals per piece, in proportion to the time each needs, at least 20.
#[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn shares<const N: usize>(problem: &PathProblem<N>, path: &JointPath<N>, intervals: usize) -> Vec<usize> {
    let time = |piece: &Piece<N>| match piece.kind() {
        PieceKind::Follow { q, .. } | PieceKind::Prescribed { q, .. } => {
            q.windows(2).map(|w| problem.speed_limits.ratio(&(w[1] - w[0]).into())).sum::<f64>()
        }
        PieceKind::SelfMotion { from, to, .. } => problem.speed_limits.ratio(&(to - from).into()),
    };
    let times: Vec<f64> = path.pieces().iter().map(time).collect();
    let total: f64 = times.iter().sum();
    times
        .iter()
        .map(|t| if total > 0.0 { (t / total * intervals as f64).round() as usize } else { intervals })
        .map(|n| if path.pieces().len() == 1 { intervals } else { n.max(20) })
        .collect()
}

#[allow(clippy::cast_precision_loss)]
fn sample_piece<const N: usize>(
    problem: &PathProblem<N>,
    piece: &Piece<N>,
    intervals: usize,
    between: usize,
) -> Result<SampledPiece, ProblemError> {
    let grid = piece.grid(problem, intervals);
    let sample = |s: f64| piece.at(problem, s).map(|point| path_sample(problem, s, &point));
    let nodes = grid.iter().map(|&s| sample(s)).collect::<Result<_, _>>()?;
    let inner = |w: &[f64]| {
        (1..=between)
            .map(|j| sample(w[0] + (w[1] - w[0]) * j as f64 / (between + 1) as f64))
            .collect::<Result<Vec<_>, _>>()
    };
    let between = grid.windows(2).map(inner).collect::<Result<_, _>>()?;
    Ok(SampledPiece {
        nodes,
        between,
        is_self_motion: matches!(piece.kind(), PieceKind::SelfMotion { .. }),
        start: EndRate::ByLimits,
        end: EndRate::ByLimits,
    })
}

fn path_sample<const N: usize>(problem: &PathProblem<N>, s: f64, point: &JointPoint<N>) -> PathSample {
    PathSample {
        s,
        lambda: point.lambda,
        first: point.first.iter().copied().collect(),
        second: point.second.iter().copied().collect(),
        limits: problem.linear_limits(point),
        speeds: problem.rate_limits(point),
    }
}
