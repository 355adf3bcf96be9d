use crate::CartesianPath;
use nalgebra::{Rotation3, Translation3, Vector3};
use slideway_robot::augmented::PathTangent;
use slideway_robot::{Pose, Twist};

/// A path at one value of its parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathState {
    /// Pose of the tool.
    pub pose: Pose,
    /// Its twist at unit path speed, and how that changes.
    pub tangent: PathTangent,
}

/// A path of the tool, twice differentiable in its parameter `q*`.
pub trait ParametrisedPath {
    /// The path at a parameter, which may be any number.
    fn at(&self, parameter: f64) -> PathState;
}

/// A horizontal circle, anticlockwise with growing parameter, at constant orientation.
///
/// ```text
/// x(q*) = centre + radius · (cos(q* + phase), sin(q* + phase), 0)
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// Centre, m.
    pub centre: Vector3<f64>,
    /// Radius, m.
    pub radius: f64,
    /// Angle of the point at parameter 0, rad.
    pub phase: f64,
    /// Orientation of the tool.
    pub orientation: Rotation3<f64>,
}

impl ParametrisedPath for Circle {
    fn at(&self, parameter: f64) -> PathState {
        let (s, c) = (parameter + self.phase).sin_cos();
        let out = Vector3::new(c, s, 0.0) * self.radius;
        PathState {
            pose: Pose::from_parts(Translation3::from(self.centre + out), self.orientation),
            tangent: PathTangent {
                twist: Twist::new(-out.y, out.x, 0.0, 0.0, 0.0, 0.0),
                slope: Twist::new(-out.x, -out.y, 0.0, 0.0, 0.0, 0.0),
            },
        }
    }
}

impl ParametrisedPath for CartesianPath {
    /// Euler rates become an angular velocity `ω = α' z + β' y' + γ' x''` with the axes they turn about,
    /// `y' = Rz(α) y` and `x'' = Rz(α) Ry(β) x`; its derivative has their turning in it, `z × y' α'` and
    /// `(α' z + β' y') × x''`.
    fn at(&self, parameter: f64) -> PathState {
        let point = CartesianPath::at(self, parameter);
        let [x, y, z, alpha, beta, gamma] = point.coordinates.into();
        let rotation = Rotation3::from_euler_angles(gamma, beta, alpha);
        let first = Vector3::z();
        let second = Rotation3::from_axis_angle(&Vector3::z_axis(), alpha) * Vector3::y();
        let third = rotation * Vector3::x();
        let (rate, rate2) = (point.first.fixed_rows::<3>(3), point.second.fixed_rows::<3>(3));
        let angular = first * rate[0] + second * rate[1] + third * rate[2];
        let carried = first * rate[0] + second * rate[1];
        let slope = first * rate2[0]
            + second * rate2[1]
            + third * rate2[2]
            + first.cross(&second) * (rate[0] * rate[1])
            + carried.cross(&third) * rate[2];
        PathState {
            pose: Pose::from_parts(Translation3::new(x, y, z), rotation),
            tangent: PathTangent {
                twist: Twist::new(point.first[0], point.first[1], point.first[2], angular.x, angular.y, angular.z),
                slope: Twist::new(point.second[0], point.second[1], point.second[2], slope.x, slope.y, slope.z),
            },
        }
    }
}
