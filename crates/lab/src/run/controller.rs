use crate::problem::Problem;
use crate::run::metrics::{ARRIVAL_ORIENTATION, ARRIVAL_POSITION};
use nalgebra::{Vector3, Vector6};
use slideway_path::JointCurve;
use slideway_path::PathPoint;
use slideway_path::{Reference, ToolReference};
use slideway_robot::{EulerAngles, JointKind, JointVector, Pose, Task, Twist, euler, rotation_vector, solve_rates};

/// Demand of the kinematic controller at one instant, split at the path rate.
///
/// ```text
/// q̇d = feedback + λ̇ · path_speed
/// feedback   = Inv(J) Kp (p_ref - p)          A in the implicit form
/// path_speed = Inv(J) f'(λ)                   v; B = v λ̇d
/// ```
///
/// `[G11] Fig. 1` with a proportional position controller. `Inv` is linear for a fixed configuration, so the split is
/// exact. Where the path gives Euler triples, `p_ref - p` is a difference of triples and Euler rates pass through `E(α, β)`:
/// the analytic Jacobian, which does not exist at `β = π/2`, is never formed. Elsewhere the orientation error is the rotation vector
/// from the tool to the reference. On a path of the joints, `feedback = Kp (q_ref - q)` and `path_speed = q_ref'(λ)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Demand<const N: usize> {
    /// `p_ref - p` of the tool, m and rad; coordinates outside the task are zero.
    pub error: Vector6<f64>,
    /// Distance from the reference in units of the arrival tolerances: at most 1 counts as there. On a path of the joints it is
    /// the joints that must be there.
    pub distance: f64,
    /// Euler triple of the tool.
    pub euler: EulerAngles,
    /// Joint speed with the reference standing still, rad/s.
    pub feedback: JointVector<N>,
    /// Joint speed per unit of path rate.
    pub path_speed: JointVector<N>,
}

impl<const N: usize> Demand<N> {
    /// The desired joint speed at a path rate.
    #[must_use]
    pub fn at(&self, path_rate: f64) -> JointVector<N> {
        self.feedback + self.path_speed * path_rate
    }
}

impl<const N: usize> Problem<N> {
    /// Evaluates the controller at a configuration and path parameter; `euler` is the triple one sample earlier.
    #[must_use]
    pub fn demand(&self, q: &JointVector<N>, euler: &EulerAngles, lambda: f64) -> Demand<N> {
        match &self.path.reference {
            Reference::Tool(tool) => self.tool_demand(tool, q, euler, lambda),
            Reference::Joint(curve) => self.joint_demand(curve, q, euler, lambda),
        }
    }

    fn tool_demand(&self, tool: &ToolReference, q: &JointVector<N>, euler: &EulerAngles, lambda: f64) -> Demand<N> {
        let frames = self.path.arm.frames(q);
        let jacobian = self.path.arm.jacobian_at(&frames);
        let euler = euler::nearest(&frames.tool.rotation, euler);
        let state = ToolState { pose: &frames.tool, euler };
        let reference = tool.path.at(lambda);
        let error = state.error(&reference);
        let rates = |twist: &Twist| solve_rates(tool.inverse, tool.task, &jacobian, twist);
        let shown = state.select(tool.task, &reference, &error);
        Demand {
            error: shown,
            distance: error_distance(&shown.into()),
            euler,
            feedback: rates(&state.feedback(&reference, &(error * self.control.gain))),
            path_speed: rates(&state.feedforward(&reference)),
        }
    }

    fn joint_demand(&self, curve: &JointCurve<N>, q: &JointVector<N>, euler: &EulerAngles, lambda: f64) -> Demand<N> {
        let [reference, path_speed, _] = curve.at(lambda);
        let tool = self.path.arm.forward(q);
        let to_reference = reference - q;
        Demand {
            error: pose_error(&self.path.arm.forward(&reference), &tool),
            distance: self.joint_distance(&to_reference),
            euler: euler::nearest(&tool.rotation, euler),
            feedback: to_reference * self.control.gain,
            path_speed,
        }
    }

    /// Largest joint error in units of the arrival tolerances.
    fn joint_distance(&self, error: &JointVector<N>) -> f64 {
        let tolerance = |kind: JointKind| match kind {
            JointKind::Revolute => ARRIVAL_ORIENTATION,
            JointKind::Prismatic => ARRIVAL_POSITION,
        };
        let shares = error.iter().zip(self.path.arm.joints()).map(|(e, joint)| e.abs() / tolerance(joint.kind));
        shares.fold(0.0, f64::max)
    }
}

/// The tool as the controller sees it.
struct ToolState<'a> {
    pose: &'a Pose,
    euler: EulerAngles,
}

impl ToolState<'_> {
    /// Reference less tool: position, and Euler triples or the rotation vector.
    fn error(&self, reference: &PathPoint) -> Vector6<f64> {
        match &reference.euler {
            Some(triple) => {
                let position = reference.pose.translation.vector - self.pose.translation.vector;
                join(&position, &(triple.angles - self.euler))
            }
            None => pose_error(&reference.pose, self.pose),
        }
    }

    /// The twist that coordinate rates mean.
    fn feedback(&self, reference: &PathPoint, rates: &Vector6<f64>) -> Twist {
        match &reference.euler {
            Some(_) => twist(rates, &self.euler),
            None => *rates,
        }
    }

    /// The twist of the reference per unit of path rate; Euler rates are mapped at the tool's own triple.
    fn feedforward(&self, reference: &PathPoint) -> Twist {
        // [G11] eq 2
        let Some(triple) = &reference.euler else { return reference.twist };
        let linear: Vector3<f64> = reference.twist.fixed_rows::<3>(0).into();
        twist(&join(&linear, &triple.rates), &self.euler)
    }

    /// The error with coordinates outside the task set to zero. The turn about z is the last of a rotation vector, the first of
    /// an Euler triple.
    fn select(&self, task: Task, reference: &PathPoint, error: &Vector6<f64>) -> Vector6<f64> {
        match (task, &reference.euler) {
            (Task::PlanarPose, Some(_)) => Vector6::new(error[0], error[1], 0.0, error[3], 0.0, 0.0),
            _ => task.select(error),
        }
    }
}

/// Position difference and rotation vector from one pose to another, in the base frame.
fn pose_error(reference: &Pose, tool: &Pose) -> Vector6<f64> {
    let position = reference.translation.vector - tool.translation.vector;
    join(&position, &rotation_vector(&(reference.rotation * tool.rotation.inverse())))
}

fn join(upper: &Vector3<f64>, lower: &Vector3<f64>) -> Vector6<f64> {
    Vector6::new(upper.x, upper.y, upper.z, lower.x, lower.y, lower.z)
}

/// Linear velocity and angular velocity from coordinate rates `[ẋ ẏ ż α̇ β̇ γ̇]`.
fn twist(rates: &Vector6<f64>, euler: &EulerAngles) -> Twist {
    let angular = euler::rate_map(euler) * rates.fixed_rows::<3>(3);
    Twist::new(rates[0], rates[1], rates[2], angular.x, angular.y, angular.z)
}

/// Distance of the tool from the reference in units of the arrival tolerances.
fn error_distance(error: &[f64; 6]) -> f64 {
    let norm = |part: &[f64]| part.iter().map(|e| e * e).sum::<f64>().sqrt();
    (norm(&error[..3]) / ARRIVAL_POSITION).max(norm(&error[3..]) / ARRIVAL_ORIENTATION)
}
