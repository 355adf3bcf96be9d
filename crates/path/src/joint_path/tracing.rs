//! Steps of tracing a joint path: following the tool path by inverse kinematics, and turning where it breaks.

use crate::error::ProblemError;
use crate::path_problem::PathProblem;
use crate::reference::reference::ToolReference;
use slideway_robot::{JacobiSvd, JointVector, NumericIk, NumericIkSettings, RobotError, Task, Twist};

/// Largest joint change between neighbouring configurations while tracing, rad.
const MAX_STEP: f64 = 0.02;
/// Steps per smooth stretch at the least.
const MIN_STEPS: f64 = 400.0;
/// Steps below this share of a stretch mean that the joint path breaks.
pub(crate) const SMALLEST: f64 = 1e-9;
/// Distance beyond a break at which the continuation is looked for, and from a singular end at which derivatives are taken, as a share
/// of the stretch.
pub(crate) const BEYOND: f64 = 1e-6;
/// Ratio of the singular values below which a configuration counts as singular.
const SINGULAR: f64 = 1e-6;

/// A stretch of the path that was followed.
pub(crate) struct Followed<const N: usize> {
    /// Path parameters, increasing.
    pub(crate) at: Vec<f64>,
    /// Configurations there.
    pub(crate) q: Vec<JointVector<N>>,
    /// Error that ended it early.
    pub(crate) failure: Option<RobotError>,
}

/// Follows the path from a configuration until `end` or until it breaks.
pub(crate) fn follow<const N: usize>(
    problem: &PathProblem<N>,
    tool: &ToolReference,
    begin: f64,
    end: f64,
    q: JointVector<N>,
) -> Followed<N> {
    let stretch = end - begin;
    let (mut at, mut configurations) = (vec![begin], vec![q]);
    let (mut lambda, mut q, mut step) = (begin, q, stretch / MIN_STEPS);
    let mut slope = JointVector::<N>::zeros();
    let mut failure = None;
    while lambda < end {
        // A remainder below the smallest step is taken along.
        let next = if lambda + step > end - SMALLEST * stretch { end } else { lambda + step };
        let seed = q + slope * (next - lambda);
        match configuration(problem, tool, next, &seed) {
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
    Followed { at, q: configurations, failure }
}

/// The configuration nearest to a seed that puts the tool on the path.
pub(crate) fn configuration<const N: usize>(
    problem: &PathProblem<N>,
    tool: &ToolReference,
    lambda: f64,
    seed: &JointVector<N>,
) -> Result<JointVector<N>, RobotError> {
    NumericIk::new(&problem.arm, tool.task, NumericIkSettings::default()).solve(&tool.path.at(lambda).pose, seed)
}

/// `q'` and `q''` at the exact configuration of a path point.
pub(crate) fn derivatives<const N: usize>(
    problem: &PathProblem<N>,
    tool: &ToolReference,
    lambda: f64,
    q: &JointVector<N>,
) -> (JointVector<N>, JointVector<N>) {
    let point = tool.path.at(lambda);
    let frames = problem.arm.frames(q);
    let Some(svd) = JacobiSvd::new(&tool.task.select_rows(&problem.arm.jacobian_at(&frames))) else {
        return (JointVector::from_element(f64::NAN), JointVector::from_element(f64::NAN));
    };
    // A cutoff at rounding level: the exact inverse wherever there is one.
    let rates = |twist: &Twist| svd.solve(&tool.task.select(twist), 1e-13);
    let first = rates(&point.twist);
    let second = rates(&(point.acceleration - problem.arm.bias_acceleration_at(&frames, &first)));
    (first, second)
}

pub(crate) fn is_singular<const N: usize>(problem: &PathProblem<N>, task: Task, q: &JointVector<N>) -> bool {
    let (smallest, largest, _) = weakest_direction(problem, task, q);
    !(smallest > SINGULAR * largest)
}

/// Smallest and largest singular value of the task's Jacobian (of as many as the task has rows), and the joint direction
/// of the smallest.
fn weakest_direction<const N: usize>(
    problem: &PathProblem<N>,
    task: Task,
    q: &JointVector<N>,
) -> (f64, f64, JointVector<N>) {
    let Some(svd) = JacobiSvd::new(&task.select_rows(&problem.arm.jacobian(q))) else {
        return (0.0, 1.0, JointVector::zeros());
    };
    let mut order: Vec<(f64, usize)> = (0..N).map(|k| (svd.singular_value(k), k)).collect();
    order.sort_by(|a, b| b.0.total_cmp(&a.0));
    let (smallest, index) = order[task.rows().len().min(N) - 1];
    (smallest, order[0].0, svd.v.column(index).into_owned())
}

/// Looks for the configuration from which the path goes on after a break: along the self-motion of the singularity, the
/// one reached soonest under the speed limits.
pub(crate) fn self_motion<const N: usize>(
    problem: &PathProblem<N>,
    tool: &ToolReference,
    at: f64,
    resume: f64,
    q: &JointVector<N>,
    failure: RobotError,
) -> Result<JointVector<N>, ProblemError> {
    const TRIALS: i32 = 180;
    let (smallest, largest, direction) = weakest_direction(problem, tool.task, q);
    // Within the share BEYOND of a singularity the smallest singular value is of that order too; 1e-3 leaves room.
    if smallest > 1e-3 * largest {
        return Err(ProblemError::LeavesReach { at, source: failure });
    }
    let direction = direction / direction.amax();
    let time = |next: &JointVector<N>| problem.speed_limits.ratio(&(next - q).into());
    let mut best: Option<JointVector<N>> = None;
    let mut jump = f64::INFINITY;
    for i in -TRIALS..=TRIALS {
        let seed = q + direction * (std::f64::consts::PI * f64::from(i) / f64::from(TRIALS));
        let Ok(next) = configuration(problem, tool, resume, &seed) else { continue };
        jump = jump.min((next - q).amax());
        if stands_still(problem, tool, at, q, &next) && best.as_ref().is_none_or(|b| time(&next) < time(b)) {
            best = Some(next);
        }
    }
    // No configuration at all beyond the break: the arm is stretched out, not in the way of itself.
    best.ok_or(if jump.is_finite() {
        ProblemError::BrokenPath { at, jump }
    } else {
        ProblemError::LeavesReach { at, source: failure }
    })
}

/// True if the tool keeps its place while the joints go straight from one configuration to the other: within 10 µm and 10 µrad plus what
/// the path itself moves over the share [`BEYOND`].
fn stands_still<const N: usize>(
    problem: &PathProblem<N>,
    tool: &ToolReference,
    at: f64,
    from: &JointVector<N>,
    to: &JointVector<N>,
) -> bool {
    let ik = NumericIk::new(&problem.arm, tool.task, NumericIkSettings::default());
    let target = tool.path.at(at).pose;
    (0..=20).all(|i| {
        let q = from + (to - from) * (f64::from(i) / 20.0);
        ik.error(&target, &q).norm() < 1e-5 + 10.0 * BEYOND
    })
}
