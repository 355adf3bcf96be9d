use super::JointPoint;
use crate::limits::drive_and_tool::TorqueLimits;
use crate::limits::rows::{LinearLimit, SpeedLimit};
use crate::path_problem::PathProblem;
use slideway_robot::JointVector;

/// Sides of the polygon inscribed in the circle of tool accelerations: twice as many as this. 16 give away 0.5 % of the limit.
const POLYGON_PAIRS: usize = 16;

impl<const N: usize> PathProblem<N> {
    /// The limits that are rows in `s̈` and `ṡ²` at a point of the joint path, besides constant symmetric acceleration limits.
    #[must_use]
    pub fn linear_limits(&self, point: &JointPoint<N>) -> Vec<LinearLimit> {
        let mut limits = self.acceleration_rows(point);
        limits.extend(self.torque_rows(point));
        if let Some(limit) = self.tool_limits.acceleration {
            let [first, second] = self.tool_derivatives(point);
            limits.extend(LinearLimit::tool_acceleration(first, second, limit, POLYGON_PAIRS));
        }
        limits
    }

    /// The bounds on the path rate at a point of the joint path, besides constant joint-speed limits.
    #[must_use]
    pub fn rate_limits(&self, point: &JointPoint<N>) -> Vec<SpeedLimit> {
        let mut limits = Vec::new();
        if let Some(bounds) = &self.speed_along {
            let range = bounds.at(point.lambda);
            limits.extend((0..N).map(|i| SpeedLimit::joint(i, point.first[i], range.lower[i], range.upper[i])));
        }
        if let Some(limit) = self.tool_limits.speed {
            limits.push(SpeedLimit::tool(self.tool_derivatives(point)[0], limit));
        }
        limits
    }

    fn acceleration_rows(&self, point: &JointPoint<N>) -> Vec<LinearLimit> {
        let Some(bounds) = &self.acceleration_limits else { return Vec::new() };
        if self.everywhere_acceleration().is_some() {
            return Vec::new();
        }
        let range = bounds.at(point.lambda);
        let row =
            |i| LinearLimit::joint_acceleration(i, point.first[i], point.second[i], range.lower[i], range.upper[i]);
        (0..N).map(row).collect()
    }

    /// `τ = m s̈ + c ṡ² + g`, from three runs of inverse dynamics: `m = M q'`, `c = M q'' + C(q, q') q'`, `g` at rest.
    ///
    /// Coulomb friction goes with the direction of motion, into `g`. Viscous friction goes with `ṡ`, which no row can hold: the
    /// bound that it uses up gives way by its value at the fastest that the speed limits allow here.
    fn torque_rows(&self, point: &JointPoint<N>) -> Vec<LinearLimit> {
        let Some(TorqueLimits { dynamics, bounds }) = &self.torque_limits else { return Vec::new() };
        let rest = JointVector::zeros();
        let gravity = dynamics.gravity_torque(&point.q);
        let m = dynamics.inverse(&point.q, &rest, &point.first) - gravity;
        let c = dynamics.inverse(&point.q, &point.first, &point.second) - dynamics.friction(&point.first) - gravity;
        // At a speed this small only Coulomb friction is left.
        let coulomb = dynamics.friction(&(point.first.map(direction) * f64::MIN_POSITIVE));
        let fastest = dynamics.friction(&self.fastest(point)) - coulomb;
        let range = bounds.at(point.lambda);
        let row = |i: usize| {
            let viscous = fastest[i];
            LinearLimit::joint_torque(
                i,
                [m[i], c[i], gravity[i] + coulomb[i]],
                range.lower[i] - viscous.min(0.0),
                range.upper[i] - viscous.max(0.0),
            )
        };
        (0..N).map(row).collect()
    }

    /// The joint speed at the largest path rate that the speed limits allow at a point.
    fn fastest(&self, point: &JointPoint<N>) -> JointVector<N> {
        let by_joints = 1.0 / self.speed_limits.ratio(&point.first.into());
        let rate = self.rate_limits(point).iter().map(|limit| limit.rate).fold(by_joints, f64::min);
        // Where nothing moves the rate is unbounded and the speed zero.
        point.first.map(|v| if v == 0.0 { 0.0 } else { v * rate })
    }

    /// `p'` and `p''` of the tool's point along the joint path.
    fn tool_derivatives(&self, point: &JointPoint<N>) -> [[f64; 3]; 2] {
        let jacobian = self.arm.jacobian(&point.q);
        let first = jacobian * point.first;
        let second = jacobian * point.second + self.arm.bias_acceleration(&point.q, &point.first);
        [[first[0], first[1], first[2]], [second[0], second[1], second[2]]]
    }
}

/// The sign of a number, 0 for 0.
fn direction(value: f64) -> f64 {
    if value == 0.0 { 0.0 } else { value.signum() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::joint_path::JointPath;
    use crate::limits::joint_bounds::{Bound, BoundSigns, JointBounds};
    use crate::reference::joint_curve::JointCurve;
    use crate::reference::reference::Reference;
    use slideway_conditioner::SpeedLimits;
    use slideway_robot::DriveEffects;
    use slideway_robot::models::Model;

    /// A PUMA-560 on a straight line of the joints, with 2 rad/s and 100 Nm a joint.
    fn problem(effects: DriveEffects) -> PathProblem<6> {
        let from = JointVector::from([0.0, 0.5, -2.0, 0.0, 1.0, 0.0]);
        let to = JointVector::from([1.0, 0.0, -1.5, -1.0, 0.2, 0.7]);
        let robot = Model::Puma560.describe().expect("built in");
        let reference = Reference::Joint(JointCurve::line(from, to, 0.0..1.0));
        let speed = SpeedLimits::new([-2.0; 6], [2.0; 6]).expect("valid");
        let mut problem = PathProblem::new(robot.arm().expect("six joints"), reference, from, speed);
        let bound = |value: f64| std::array::from_fn(|_| Bound::Constant(value));
        let bounds = JointBounds::new(bound(-100.0), bound(100.0), BoundSigns::Ordered, &(0.0..1.0)).expect("valid");
        let dynamics = robot.dynamics().expect("has masses").with_effects(effects);
        problem.torque_limits = Some(TorqueLimits { dynamics, bounds });
        problem
    }

    #[test]
    fn torque_rows_are_inverse_dynamics_along_the_path() {
        let problem = problem(DriveEffects { rotor_inertia: true, friction: false });
        let path = JointPath::trace(&problem).expect("traced");
        let dynamics = &problem.torque_limits.as_ref().expect("given").dynamics;
        for i in 0..20 {
            let point = path.pieces()[0].at(&problem, f64::from(i) / 19.0).expect("there");
            let (rate, acceleration) = (0.1 * f64::from(i), 3.0 - 0.4 * f64::from(i));
            let speed = point.first * rate;
            let torque =
                dynamics.inverse(&point.q, &speed, &(point.first * acceleration + point.second * (rate * rate)));
            for row in problem.linear_limits(&point) {
                // Torques of at most 100 Nm from sums of a hundred products: 1e-11 is 1000 times the rounding of one.
                assert!((row.value(acceleration, rate * rate) - torque[row.index]).abs() < 1e-11);
            }
        }
    }

    #[test]
    fn rows_with_friction_keep_the_whole_torque_inside_at_every_rate_that_the_speed_limits_allow() {
        let problem = problem(DriveEffects { rotor_inertia: false, friction: true });
        let path = JointPath::trace(&problem).expect("traced");
        let dynamics = &problem.torque_limits.as_ref().expect("given").dynamics;
        let point = path.pieces()[0].at(&problem, 0.4).expect("there");
        let rows = problem.linear_limits(&point);
        for i in 1..=10 {
            let rate = problem.fastest(&point)[0] / point.first[0] * f64::from(i) / 10.0;
            let torque = dynamics.inverse(&point.q, &(point.first * rate), &(point.second * (rate * rate)));
            for row in &rows {
                // Distance to each bound is at least what the row says, and equal at the fastest for the bound that friction uses up.
                let (row_room, room) = (row.upper - row.value(0.0, rate * rate), 100.0 - torque[row.index]);
                assert!(row_room <= room + 1e-11, "{row_room} {room}");
                if i == 10 && point.first[row.index] > 0.0 {
                    assert!((row_room - room).abs() < 1e-11);
                }
            }
        }
    }
}
