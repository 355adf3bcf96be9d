use nalgebra::{Rotation3, Translation3, Vector3};
use slideway_path::{CartesianPath, PathPoint};
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
    fn at(&self, parameter: f64) -> PathState {
        let PathPoint { pose, twist, acceleration, .. } = CartesianPath::at(self, parameter);
        PathState { pose, tangent: PathTangent { twist, slope: acceleration } }
    }
}
