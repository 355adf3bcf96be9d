use nalgebra::{Matrix3, Rotation3, Vector3};
use slideway_robot::{JointKind, JointVector, Pose, RobotError, SerialArm};
use std::f64::consts::TAU;

/// The closed-form twin of the numeric inverse kinematics, for six-axis arms whose last three axes meet in a point, from any description: all
/// solutions, up to eight.
///
/// Needs six revolute joints; axes 4, 5, 6 through one point, neighbours not parallel; axes 2 and 3 parallel; axis 1 not
/// parallel to them. Signs of twists, offsets and the zero position are free, so DH tables and URDF files both serve. (For
/// arms with PUMA's DH table [`slideway_robot::SphericalWristIk`] names the branches.)
///
/// With the arm as a product of screws, `T(q) = e1 ... e6 T(0)`, the wrist centre `c` does not move with joints 4 to 6:
/// `e1 e2 e3 c = T T(0)⁻¹ c`. Its coordinate along axes 2 and 3 gives `q1`, its distance from axis 2 gives `q3`, its direction
/// `q2`; then `e4 e5 e6` is a known rotation. (Paden 1986; Murray, Li and Sastry 1994, section 3.3.)
///
/// Angles lie in (-π, π]. Where the wrist is singular `q4 = 0` is chosen, where the wrist centre lies on axis 1 `q1 = 0`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct WristPartitionedIk {
    axes: [Vector3<f64>; 6],
    points: [Vector3<f64>; 6],
    centre: Vector3<f64>,
    home: Pose,
}

/// Slack on the geometry conditions, m and rad: descriptions are typed with a dozen digits at best.
const GEOMETRY_TOLERANCE: f64 = 1e-9;

/// Length below which a direction counts as undetermined: it would be read from rounding.
const UNDETERMINED: f64 = 1e-12;

impl WristPartitionedIk {
    /// Accepts arms with the geometry above.
    ///
    /// # Errors
    ///
    /// [`RobotError::NotSphericalWrist`] with the first condition that fails.
    pub(crate) fn new<const N: usize>(arm: &SerialArm<N>) -> Result<Self, RobotError> {
        let fail = |reason| Err(RobotError::NotSphericalWrist { reason });
        if !arm.followers().is_empty() {
            return fail("a joint follows another");
        }
        let frames = arm.frames(&JointVector::zeros());
        let (Ok(axes), Ok(points)) = (
            <[Vector3<f64>; 6]>::try_from(frames.axes.as_slice()),
            <[Vector3<f64>; 6]>::try_from(frames.origins.as_slice()),
        ) else {
            return fail("it does not have six joints");
        };
        if arm.joints().iter().any(|joint| joint.kind != JointKind::Revolute) {
            return fail("a joint slides");
        }
        let parallel = |i: usize, j: usize| axes[i].cross(&axes[j]).norm() <= GEOMETRY_TOLERANCE;
        if !parallel(1, 2) || parallel(0, 1) {
            return fail("axes 2 and 3 must be parallel, and axis 1 not parallel to them");
        }
        if parallel(3, 4) || parallel(4, 5) {
            return fail("neighbouring wrist axes are parallel");
        }
        let centre = meeting_point([axes[3], axes[4]], [points[3], points[4]]);
        let off = |i: usize| axes[i].cross(&(centre - points[i])).norm();
        if !(off(3).max(off(4)).max(off(5)) <= GEOMETRY_TOLERANCE) {
            return fail("its last three axes do not meet in one point");
        }
        let upper = axes[1].cross(&(points[2] - points[1])).norm();
        let fore = axes[2].cross(&(centre - points[2])).norm();
        if !(upper > GEOMETRY_TOLERANCE && fore > GEOMETRY_TOLERANCE) {
            return fail("its upper arm or forearm has no length");
        }
        Ok(Self { axes, points, centre, home: frames.tool })
    }

    /// All configurations that put the tool at a pose; at most eight, in no particular order.
    ///
    /// # Errors
    ///
    /// [`RobotError::OutOfReach`] if there is none.
    pub(crate) fn solutions(&self, pose: &Pose) -> Result<Vec<JointVector<6>>, RobotError> {
        let motion = pose * self.home.inverse();
        let wrist = motion * nalgebra::Point3::from(self.centre);
        let mut solutions = Vec::new();
        let mut nearest_miss = None;
        for q1 in self.first(&wrist.coords)? {
            let seen = self.turn(0, -q1, &wrist.coords);
            match self.third(&seen) {
                Ok(elbows) => {
                    for q3 in elbows {
                        let q2 = self.second(&seen, q3);
                        self.wrist(&motion.rotation, [q1, q2, q3], &mut solutions);
                    }
                }
                Err(miss) => nearest_miss = Some(miss),
            }
        }
        if solutions.is_empty() {
            let twisted = RobotError::OutOfReach { reason: "the wrist cannot turn that way", shortfall: 0.0 };
            return Err(nearest_miss.unwrap_or(twisted));
        }
        Ok(solutions)
    }

    /// The solution nearest to a configuration, each angle up to whole turns.
    ///
    /// # Errors
    ///
    /// As [`WristPartitionedIk::solutions`].
    pub(crate) fn nearest(&self, pose: &Pose, to: &JointVector<6>) -> Result<JointVector<6>, RobotError> {
        let unwound = |q: &JointVector<6>| q.zip_map(to, |angle, near| angle - TAU * ((angle - near) / TAU).round());
        let solutions = self.solutions(pose)?;
        let distance = |q: &JointVector<6>| (q - to).norm_squared();
        let best = solutions.iter().map(unwound).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        best.ok_or(RobotError::OutOfReach { reason: "there is no solution", shortfall: 0.0 })
    }

    /// A point after joint `i` alone has turned by `angle` from the zero position.
    fn turn(&self, i: usize, angle: f64, point: &Vector3<f64>) -> Vector3<f64> {
        self.points[i] + self.rotation(i, angle) * (point - self.points[i])
    }

    fn rotation(&self, i: usize, angle: f64) -> Rotation3<f64> {
        Rotation3::from_axis_angle(&nalgebra::Unit::new_unchecked(self.axes[i]), angle)
    }

    /// `q1` from the coordinate of the wrist centre along axis 2, which joints 2 and 3 do not change.
    fn first(&self, wrist: &Vector3<f64>) -> Result<Vec<f64>, RobotError> {
        let along = self.axes[1];
        let wanted = along.dot(&(self.centre - self.points[0]));
        let (angles, shortfall) = project_turned(&self.axes[0], &(wrist - self.points[0]), &along, wanted);
        if shortfall > GEOMETRY_TOLERANCE {
            let reason = "the wrist centre is too close to the first axis";
            return Err(RobotError::OutOfReach { reason, shortfall });
        }
        Ok(angles.iter().map(|angle| -angle).collect())
    }

    /// `q3` from the distance of the wrist centre from axis 2.
    fn third(&self, wrist: &Vector3<f64>) -> Result<Vec<f64>, RobotError> {
        let axis = self.axes[2];
        let across = |v: Vector3<f64>| v - axis * axis.dot(&v);
        let (fore, upper) = (across(self.centre - self.points[2]), across(self.points[1] - self.points[2]));
        let distance = across(wrist - self.points[1]).norm();
        let (x, y) = (fore.norm(), upper.norm());
        let shortfall = (distance - (x + y)).max((x - y).abs() - distance);
        if shortfall > GEOMETRY_TOLERANCE {
            let reason = "upper arm and forearm do not span to the wrist centre";
            return Err(RobotError::OutOfReach { reason, shortfall });
        }
        let wanted = 0.5 * (x * x + y * y - distance * distance);
        Ok(project_turned(&axis, &fore, &upper, wanted).0)
    }

    /// `q2` turns the wrist centre, moved by `q3`, to where it must be.
    fn second(&self, wrist: &Vector3<f64>, q3: f64) -> f64 {
        let moved = self.turn(2, q3, &self.centre);
        angle_about(&self.axes[1], &(moved - self.points[1]), &(wrist - self.points[1]))
    }

    /// Both ways of the wrist for a rotation of the whole arm, pushed to the solutions.
    fn wrist(&self, motion: &Rotation3<f64>, [q1, q2, q3]: [f64; 3], solutions: &mut Vec<JointVector<6>>) {
        let arm = self.rotation(0, q1) * self.rotation(1, q2) * self.rotation(2, q3);
        let rest = arm.inverse() * motion;
        let last = rest * self.axes[5];
        let (angles, shortfall) = project_turned(&self.axes[4], &self.axes[5], &self.axes[3], self.axes[3].dot(&last));
        if shortfall > GEOMETRY_TOLERANCE {
            return;
        }
        for q5 in angles {
            let fifth = self.rotation(4, q5);
            let q4 = angle_about(&self.axes[3], &(fifth * self.axes[5]), &last);
            let sixth = (self.rotation(3, q4) * fifth).inverse() * rest;
            let q6 = turn_about(&self.axes[5], sixth.matrix());
            solutions.push(JointVector::<6>::new(q1, q2, q3, q4, q5, q6).map(wrap));
        }
    }
}

/// The point nearest to two lines that are not parallel, halfway between them.
fn meeting_point([a, b]: [Vector3<f64>; 2], [p, q]: [Vector3<f64>; 2]) -> Vector3<f64> {
    let normal = a.cross(&b);
    let between = q - p;
    let scale = normal.norm_squared();
    let on_first = p + a * (between.cross(&b).dot(&normal) / scale);
    let on_second = q + b * (between.cross(&a).dot(&normal) / scale);
    (on_first + on_second) * 0.5
}

/// Angles at which `v`, turned about `axis`, has the projection `wanted` on `along`; and by how much it misses if it cannot.
fn project_turned(axis: &Vector3<f64>, v: &Vector3<f64>, along: &Vector3<f64>, wanted: f64) -> (Vec<f64>, f64) {
    let parallel = axis * axis.dot(v);
    let (cosine, sine) = (along.dot(&(v - parallel)), along.dot(&axis.cross(v)));
    let amplitude = cosine.hypot(sine);
    let rest = wanted - along.dot(&parallel);
    let shortfall = rest.abs() - amplitude;
    if !(amplitude > UNDETERMINED) {
        return (vec![0.0], shortfall);
    }
    let (middle, half) = (sine.atan2(cosine), (rest / amplitude).clamp(-1.0, 1.0).acos());
    (vec![middle + half, middle - half], shortfall)
}

/// The angle about `axis` from `from` to `to`; zero where one of them lies on the axis.
fn angle_about(axis: &Vector3<f64>, from: &Vector3<f64>, to: &Vector3<f64>) -> f64 {
    let across = |v: &Vector3<f64>| v - axis * axis.dot(v);
    let (from, to) = (across(from), across(to));
    if from.norm().min(to.norm()) <= UNDETERMINED { 0.0 } else { axis.dot(&from.cross(&to)).atan2(from.dot(&to)) }
}

/// The angle of a rotation about an axis known to be its own: `tr R = 1 + 2 cos θ`, antisymmetric part `sin θ` times the axis.
fn turn_about(axis: &Vector3<f64>, r: &Matrix3<f64>) -> f64 {
    let sine = Vector3::new(r[(2, 1)] - r[(1, 2)], r[(0, 2)] - r[(2, 0)], r[(1, 0)] - r[(0, 1)]);
    axis.dot(&sine).atan2(r.trace() - 1.0)
}

/// The angle in (-π, π].
fn wrap(angle: f64) -> f64 {
    angle - TAU * ((angle / TAU) - 0.5).ceil()
}
