//! What the optimum of a whole joint path needs: polynomials, limits of the joints, ends.

use super::fit::{Fit, weights};
use super::polynomials::{Builder, JointPathPoint, JointPolynomials, Likeness, SplineDeviation};
use super::{JointPath, PieceKind};
use crate::limits::rows::EndRate;
use crate::path_problem::PathProblem;
use thiserror::Error;

/// A joint path as polynomials under constant limits of the joints, whatever their number.
#[derive(Clone, Debug, PartialEq)]
pub struct WholePath {
    /// The path.
    pub polynomials: JointPolynomials,
    /// Speed limits of both senses, rad/s (m/s).
    pub speed: Vec<f64>,
    /// Lower and upper acceleration limits, rad/s² (m/s²); `None` under speed limits alone.
    pub acceleration: Option<[Vec<f64>; 2]>,
    /// Whether the path begins and ends with any rate that the limits leave; at rest otherwise.
    pub is_free: [bool; 2],
}

impl WholePath {
    /// The same path under its speed limits alone, its ends free.
    #[must_use]
    pub fn under_speed_limits_alone(&self) -> Self {
        Self { acceleration: None, is_free: [true, true], ..self.clone() }
    }

    /// The largest rate `ds/dt` at a point of the path that the limits leave, 1/s: above it a joint is too fast, or every path acceleration breaks an acceleration
    /// limit. Infinite where nothing moves.
    ///
    /// Of two joints the accelerations `e = q' s̈ + q'' ṡ²` leave, without `s̈`, `(q_i'' q_j' - q_j'' q_i') ṡ² = q_j' e_i - q_i' e_j`.
    #[must_use]
    pub fn rate_limit(&self, point: &JointPathPoint) -> f64 {
        let JointPathPoint { first, second, .. } = point;
        let slowness = first.iter().zip(&self.speed).map(|(v, limit)| v.abs() / limit).fold(0.0, f64::max);
        let mut fastest = 1.0 / (slowness * slowness);
        let Some([lower, upper]) = &self.acceleration else { return fastest.sqrt() };
        let most = |factor: f64, joint: usize| (factor * upper[joint]).max(factor * lower[joint]);
        for i in 0..first.len() {
            if first[i] == 0.0 && second[i] != 0.0 {
                fastest = fastest.min(most(second[i].signum(), i) / second[i].abs());
            }
            for j in 0..i {
                let turn = second[i] * first[j] - second[j] * first[i];
                if turn != 0.0 {
                    let most = most(turn.signum() * first[j], i) + most(-turn.signum() * first[i], j);
                    fastest = fastest.min(most / turn.abs());
                }
            }
        }
        fastest.sqrt()
    }
}

/// Why a joint path under its limits is none that can be taken whole.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum NotWhole {
    /// Torque limits.
    #[error("torque limits are taken at the nodes of a grid only")]
    Torque,
    /// A limit of the tool.
    #[error("limits of the tool are taken at the nodes of a grid only")]
    Tool,
    /// Limits that vary along the path.
    #[error("limits that vary along the path are taken at the nodes of a grid only")]
    Varying,
    /// An end with a rate above 0.
    #[error("a path that begins or ends in motion is taken at the nodes of a grid only")]
    MovingEnd,
    /// Speed limits that differ between the senses.
    #[error("speed limits that differ between both senses of a joint are taken at the nodes of a grid only")]
    UnequalSpeeds,
    /// More joints than the path prescribes, at a singularity.
    #[error("the path of a redundant arm through a singularity is taken at the nodes of a grid only")]
    Redundant,
    /// A place where no direction of travel is found.
    #[error(
        "at path parameter {lambda} the joint path has no direction that could be found, so it is taken at the nodes of a grid only"
    )]
    Direction {
        /// The path parameter.
        lambda: f64,
    },
}

impl<const N: usize> JointPath<N> {
    /// The path and its limits for an optimum of the whole path. A path of the joints comes as it is; one through inverse kinematics as a spline
    /// through points of it, so many that accelerations differ by no more than a share `tolerance` of their limits at samples between. A redundant arm's joints
    /// follow `q' = J⁺ [f'; E rates]` from its start.
    ///
    /// # Errors
    ///
    /// Limits or ends that such an optimum does not take.
    pub fn whole(&self, problem: &PathProblem<N>, tolerance: f64) -> Result<WholePath, NotWhole> {
        let limits = |path: JointPolynomials| limited(problem, path);
        match self.pieces.first().map(|piece| &piece.kind) {
            Some(PieceKind::Prescribed { curve, .. }) => limits(JointPolynomials::of_pieces(&curve.polynomials())),
            _ => self.spline(problem, tolerance),
        }
    }

    /// As [`JointPath::whole`], but paths of the joints come as splines too: their parameter may stand.
    ///
    /// # Errors
    ///
    /// As [`JointPath::whole`].
    pub fn spline(&self, problem: &PathProblem<N>, tolerance: f64) -> Result<WholePath, NotWhole> {
        // Without rows and with ends that are taken: no point of a path that is refused afterwards is computed.
        check(problem)?;
        let mut builder = Builder::from(0.0);
        let mut deviation = SplineDeviation::default();
        let mut start = None;
        for piece in &self.pieces {
            if problem.is_redundant() && matches!(piece.kind, PieceKind::SelfMotion { .. }) {
                return Err(NotWhole::Redundant);
            }
            if let PieceKind::SelfMotion { lambda, from, to } = &piece.kind {
                let length = (to - from).component_mul(&weights(problem)).norm();
                builder.push(length, &[*from, (to - from) / length], vec![*lambda]);
                continue;
            }
            let lost = |lambda| NotWhole::Direction { lambda };
            let fit = Fit::new(problem, piece, tolerance, start).map_err(lost)?;
            start = fit.end_of_track();
            let seen = fit.add_to(&mut builder).map_err(lost)?;
            deviation = deviation.worst(seen);
        }
        limited(problem, builder.finish(Likeness::Spline(deviation)))
    }
}

/// Refuses limits and ends that an optimum of the whole path does not take.
fn check<const N: usize>(problem: &PathProblem<N>) -> Result<(), NotWhole> {
    let (lower, upper) = (problem.speed_limits.lower(), problem.speed_limits.upper());
    let moves = |rate: EndRate| matches!(rate, EndRate::Given(rate) if rate != 0.0);
    let refused = [
        (problem.torque_limits.is_some(), NotWhole::Torque),
        (problem.tool_limits.speed.is_some() || problem.tool_limits.acceleration.is_some(), NotWhole::Tool),
        (problem.speed_along.is_some(), NotWhole::Varying),
        (problem.acceleration_limits.as_ref().is_some_and(|bounds| bounds.vary()), NotWhole::Varying),
        (moves(problem.start_rate) || moves(problem.end_rate), NotWhole::MovingEnd),
        (lower.iter().zip(upper).any(|(lower, upper)| *lower != -upper), NotWhole::UnequalSpeeds),
    ];
    refused.into_iter().find(|(is, _)| *is).map_or(Ok(()), |(_, why)| Err(why))
}

fn limited<const N: usize>(problem: &PathProblem<N>, polynomials: JointPolynomials) -> Result<WholePath, NotWhole> {
    check(problem)?;
    let bounds = problem.acceleration_limits.as_ref().and_then(|bounds| bounds.constant());
    let is_free = |rate: EndRate| rate == EndRate::Free || rate == EndRate::ByLimits && bounds.is_none();
    Ok(WholePath {
        polynomials,
        speed: problem.speed_limits.upper().to_vec(),
        is_free: [is_free(problem.start_rate), is_free(problem.end_rate)],
        acceleration: bounds.map(|range| [range.lower.to_vec(), range.upper.to_vec()]),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::joint_curve::JointCurve;
    use crate::reference::reference::Reference;
    use crate::{Bound, BoundSigns, JointBounds};
    use slideway_conditioner::SpeedLimits;
    use slideway_robot::JointVector;
    use slideway_robot::models::Model;

    fn line() -> PathProblem<2> {
        let (from, to) = (JointVector::from([0.0, 0.0]), JointVector::from([1.0, 2.0]));
        let arm = Model::Planar2R.describe().expect("built in").arm().expect("two joints");
        let speed = SpeedLimits::new([-1.0; 2], [1.0; 2]).expect("valid");
        PathProblem::new(arm, Reference::Joint(JointCurve::line(from, to, 0.0..1.0)), from, speed)
    }

    #[test]
    fn a_path_of_the_joints_comes_as_it_is_and_limits_that_no_whole_path_takes_are_named() {
        let problem = line();
        let path = JointPath::trace(&problem).expect("traced");
        let whole = path.whole(&problem, 1e-6).expect("speeds alone");
        assert_eq!((whole.polynomials.likeness(), whole.is_free), (Likeness::Same, [true, true]));
        assert_eq!(whole.polynomials.coefficients(), [[[0.0, 1.0], [0.0, 2.0]]]);
        let refused = |change: fn(&mut PathProblem<2>)| {
            let mut problem = line();
            change(&mut problem);
            path.whole(&problem, 1e-6).expect_err("refused")
        };
        assert_eq!(refused(|p| p.tool_limits.speed = Some(1.0)), NotWhole::Tool);
        assert_eq!(refused(|p| p.end_rate = EndRate::Given(0.1)), NotWhole::MovingEnd);
        assert_eq!(
            refused(|p| p.speed_limits = SpeedLimits::new([-1.0; 2], [2.0; 2]).expect("valid")),
            NotWhole::UnequalSpeeds
        );
        let varying = |p: &mut PathProblem<2>| {
            let bound = || {
                std::array::from_fn(|_| {
                    Bound::Along(Box::new(crate::formula::Formula::new("1 + lambda").expect("parses")))
                })
            };
            let below = || std::array::from_fn(|_| Bound::Constant(-1.0));
            p.acceleration_limits = JointBounds::new(below(), bound(), BoundSigns::AroundZero, &(0.0..1.0)).ok();
        };
        assert_eq!(refused(varying), NotWhole::Varying);
    }

    #[test]
    fn the_limit_curve_is_the_largest_rate_with_an_acceleration_within_the_limits() {
        let mut problem = line();
        problem.speed_limits = SpeedLimits::new([-9.0; 2], [9.0; 2]).expect("valid");
        problem.acceleration_limits = JointBounds::symmetric([1.0, 1.0]).ok();
        let whole = JointPath::trace(&problem).expect("traced").whole(&problem, 1e-6).expect("constant limits");
        let point = |first: [f64; 2], second: [f64; 2]| JointPathPoint {
            first: first.to_vec(),
            second: second.to_vec(),
            ..JointPathPoint::default()
        };
        // q'' of the second joint against an s̈ of the first: ṡ² + 0.5 s̈ <= 1 with s̈ >= -1.
        assert_eq!(whole.rate_limit(&point([1.0, 0.5], [0.0, 1.0])), 1.5_f64.sqrt());
        // No s̈ moves the second joint: its q'' alone bounds the rate. On a straight line nothing but the speeds does.
        assert_eq!(whole.rate_limit(&point([1.0, 0.0], [0.0, 4.0])), 0.5);
        assert_eq!(whole.rate_limit(&point([1.0, 2.0], [0.0, 0.0])), 4.5);
    }
}
