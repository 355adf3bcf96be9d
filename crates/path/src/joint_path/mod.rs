mod excesses;
mod fit;
mod hermite;
pub(crate) mod polynomials;
mod rows;
pub(crate) mod sampled;
mod tracing;
mod track;
pub(crate) mod whole;

use crate::error::ProblemError;
use crate::path_problem::PathProblem;
use crate::reference::joint_curve::JointCurve;
use crate::reference::reference::{Reference, ToolReference};
use slideway_robot::JointVector;
use tracing::{BEYOND, SMALLEST, configuration, derivatives, follow, is_singular, self_motion};

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

/// Motion along a piece, with the data to evaluate it.
#[derive(Clone, Debug)]
pub enum PieceKind<const N: usize> {
    /// The tool follows the path; `s` is the path parameter. Configurations found while tracing, dense enough to start
    /// Newton's method from.
    Follow {
        /// The path.
        tool: ToolReference,
        /// Path parameters, increasing.
        at: Vec<f64>,
        /// Configurations there.
        q: Vec<JointVector<N>>,
        /// Least distance in `s` from the piece's ends at which it is evaluated: at a singular end the derivatives exist as limits only.
        inset: f64,
    },
    /// The joints follow a path of their own; `s` is the path parameter. Configurations along it, for the grid's density.
    Prescribed {
        /// The path.
        curve: JointCurve<N>,
        /// Path parameters, increasing.
        at: Vec<f64>,
        /// Configurations there.
        q: Vec<JointVector<N>>,
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

/// Steps at which a path of the joints is looked at for the grid's density.
const PRESCRIBED_STEPS: usize = 400;

impl<const N: usize> JointPath<N> {
    /// Traces the joint path from the configuration on the path's first point.
    ///
    /// # Errors
    ///
    /// The path leaves the robot's reach, or breaks where no self-motion leads on.
    pub fn trace(problem: &PathProblem<N>) -> Result<Self, ProblemError> {
        let mut ends = problem.reference.kinks();
        ends.push(problem.end());
        let tool = match &problem.reference {
            Reference::Tool(tool) => tool,
            Reference::Joint(curve) => return Ok(Self::prescribed(curve, &ends)),
        };
        let mut path = Self { pieces: Vec::new() };
        let mut q = problem.start;
        let mut begin = problem.begin();
        for end in ends {
            let stretch = end - begin;
            while begin < end {
                let followed = follow(problem, tool, begin, end, q);
                if let (Some(&last_at), Some(&last)) = (followed.at.last(), followed.q.last()) {
                    path.push(problem, tool, followed.at, followed.q);
                    (begin, q) = (last_at, last);
                }
                if let Some(failure) = followed.failure {
                    let resume = (begin + BEYOND * stretch).min(end);
                    let next = self_motion(problem, tool, begin, resume, &q, failure)?;
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

    /// A path of the joints, cut at its corners.
    #[allow(clippy::cast_precision_loss)]
    fn prescribed(curve: &JointCurve<N>, ends: &[f64]) -> Self {
        let mut begin = curve.start();
        let mut pieces = Vec::new();
        for &end in ends {
            let share = |i: usize| i as f64 / PRESCRIBED_STEPS as f64;
            let at: Vec<f64> = (0..=PRESCRIBED_STEPS).map(|i| begin + (end - begin) * share(i)).collect();
            let q = at.iter().map(|&s| curve.at(s)[0]).collect();
            pieces.push(Piece { kind: PieceKind::Prescribed { curve: curve.clone(), at, q }, start: begin, end });
            begin = end;
        }
        Self { pieces }
    }

    /// The pieces, in the order of the path.
    #[must_use]
    pub fn pieces(&self) -> &[Piece<N>] {
        &self.pieces
    }

    /// Adds a followed stretch unless nothing of it was followed, with the inset its ends call for.
    fn push(&mut self, problem: &PathProblem<N>, tool: &ToolReference, at: Vec<f64>, q: Vec<JointVector<N>>) {
        let ([start, .., end], [first, .., last]) = (at.as_slice(), q.as_slice()) else { return };
        let (start, end) = (*start, *end);
        let singular = [first, last].into_iter().any(|q| is_singular(problem, tool.task, q));
        let inset = (end - start) * if singular { BEYOND } else { SMALLEST };
        self.pieces.push(Piece { kind: PieceKind::Follow { tool: tool.clone(), at, q, inset }, start, end });
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

    /// Kind of motion along it.
    #[must_use]
    pub fn kind(&self) -> &PieceKind<N> {
        &self.kind
    }

    /// The joint path at a parameter, clamped to the piece.
    ///
    /// `q' = J⁺ [f'; E rates]` and `q'' = J⁺ ([f''; E rates' + Ė rates] - J̇ q')`, at the exact configuration.
    ///
    /// # Errors
    ///
    /// The inverse kinematics fails at a place it passed while tracing.
    pub fn at(&self, problem: &PathProblem<N>, s: f64) -> Result<JointPoint<N>, ProblemError> {
        match &self.kind {
            PieceKind::SelfMotion { lambda, from, to } => Ok(JointPoint {
                lambda: *lambda,
                q: from + (to - from) * s.clamp(0.0, 1.0),
                first: to - from,
                second: JointVector::zeros(),
            }),
            PieceKind::Prescribed { curve, .. } => {
                // At a corner the curve's derivatives are those of the piece that begins there.
                let inset = SMALLEST * (self.end - self.start);
                let lambda = s.max(self.start).min(self.end - inset);
                let [q, first, second] = curve.at(lambda);
                Ok(JointPoint { lambda, q, first, second })
            }
            PieceKind::Follow { tool, at, q, inset } => {
                let lambda = s.max(self.start + inset).min(self.end - inset);
                let seed = interpolate(at, q, lambda);
                let q = configuration(problem, tool, lambda, &seed)
                    .map_err(|source| ProblemError::LeavesReach { at: lambda, source })?;
                let (first, second) = derivatives(problem, tool, lambda, &q);
                Ok(JointPoint { lambda, q, first, second })
            }
        }
    }

    /// Parameters from start to end, `intervals + 1` of them: half of the density goes with the path parameter, half with
    /// the time that the joint-speed limits need, so that a short stretch of fast joint motion is resolved as well.
    #[must_use]
    #[allow(clippy::cast_precision_loss)]
    pub fn grid(&self, problem: &PathProblem<N>, intervals: usize) -> Vec<f64> {
        let share = |i: usize| i as f64 / intervals as f64;
        let (at, q) = match &self.kind {
            PieceKind::SelfMotion { .. } => return (0..=intervals).map(share).collect(),
            PieceKind::Follow { at, q, .. } | PieceKind::Prescribed { at, q, .. } => (at, q),
        };
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
