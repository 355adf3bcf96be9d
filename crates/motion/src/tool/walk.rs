use super::{CurvePoint, ToolCurve, ToolFault, ToolKinematics};
use crate::{JointState, MotionError, MotionLimits, Range};
use slideway_robot::JointVector;

/// Intervals between the nodes of a curve.
pub(super) const INTERVALS: usize = 256;

/// Joint states at the nodes of a curve: joint position `q`, and as velocity and acceleration `q'(u)` and `q''(u)`.
pub(super) type Nodes<const N: usize> = [JointState<N>; INTERVALS + 1];

/// `u` at a node.
pub(super) fn place(node: usize) -> f64 {
    node as f64 / INTERVALS as f64
}

/// Follows a curve with the inverse kinematics, node by node.
///
/// # Errors
///
/// [`MotionError::Tool`] with the place along the curve, and the cause.
pub(super) fn walk<const N: usize>(
    kinematics: &ToolKinematics<N>,
    limits: &MotionLimits<N>,
    curve: &ToolCurve,
    start: &JointVector<N>,
) -> Result<Nodes<N>, MotionError> {
    let mut before = JointState::at_rest(*start);
    let mut nodes = [before; INTERVALS + 1];
    for (index, node) in nodes.iter_mut().enumerate() {
        let u = place(index);
        let at_fault = |cause| curve.fault(u, cause);
        // Off by the third derivative: one step of the inverse kinematics is enough.
        let seed = before.q + before.qd * place(1) + before.qdd * (0.5 * place(1) * place(1));
        *node = along(kinematics, &curve.at(u), &seed).map_err(at_fault)?;
        check(limits, &before, node, place(1)).map_err(at_fault)?;
        before = *node;
    }
    Ok(nodes)
}

/// Joint position at a place, `q'(u)` and `q''(u)`: the joint state at `u̇ = 1`, `ü = 0`.
pub(super) fn along<const N: usize>(
    kinematics: &ToolKinematics<N>,
    place: &CurvePoint,
    seed: &JointVector<N>,
) -> Result<JointState<N>, ToolFault> {
    let (twist, acceleration) = place.motion(1.0, 0.0);
    kinematics.follow(&place.pose, &twist, &acceleration, seed)
}

/// Checks a step of a walk: stops, and that the joints do not jump to another solution.
pub(super) fn check<const N: usize>(
    limits: &MotionLimits<N>,
    before: &JointState<N>,
    state: &JointState<N>,
    step: f64,
) -> Result<(), ToolFault> {
    for (joint, axis) in limits.axes().iter().enumerate() {
        let (was, is) = (before.axis(joint), state.axis(joint));
        if let Err(MotionError::JointStop { joint, position, limit }) =
            limits.check_stops(joint, Range::point(is.position))
        {
            return Err(ToolFault::JointStop { joint, position, limit });
        }
        let jump = is.position - was.position;
        // Speed changes little from sample to sample; another solution is far away.
        let expected = 2.0 * step * was.velocity.abs().max(is.velocity.abs()) + step * axis.velocity();
        if !(jump.abs() <= expected) {
            return Err(ToolFault::BranchChange { joint, jump });
        }
    }
    Ok(())
}
