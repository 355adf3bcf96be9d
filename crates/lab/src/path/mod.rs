pub(crate) mod joint_curve;
pub(crate) mod orientation;
pub(crate) mod poses;
pub(crate) mod position;
pub(crate) mod reference;
pub(crate) mod waypoint_reader;

use crate::error::{Fault, LabError};
use crate::path::orientation::OrientationCurve;
use crate::path::poses::PoseCurves;
use crate::path::position::PositionCurve;
use crate::path::waypoint_reader::Place;
use crate::scenario::number::Number;
use crate::scenario::schema::{PathTable, TaskName};
use nalgebra::{Translation3, Vector3, Vector6};
use slideway_robot::{EulerAngles, Pose, Twist};
use std::ops::Range;
use std::path::Path;

/// A path of the tool: position and orientation as functions of the path parameter `λ`.
///
/// In m and rad, Euler triples meaning `Rz(α) Ry(β) Rx(γ)`, all in the base frame.
#[derive(Clone, Debug)]
pub struct CartesianPath {
    start: f64,
    end: f64,
    position: PositionCurve,
    orientation: OrientationCurve,
}

/// One point of a tool path with its derivatives by the path parameter, in the base frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathPoint {
    /// Position and orientation.
    pub pose: Pose,
    /// `[p'(λ); ω(λ)]`, linear and angular speed per unit of path rate; at a kink, those of the piece that begins there.
    pub twist: Twist,
    /// `[p''(λ); ω'(λ)]`.
    pub acceleration: Twist,
    /// The orientation as an Euler triple, where the path gives it so: the controller then compares Euler triples, as
    /// `[G11]` does; else it takes the rotation vector between tool and reference.
    pub euler: Option<EulerPoint>,
}

/// The orientation of a path point in the convention `Rz(α) Ry(β) Rx(γ)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EulerPoint {
    /// `α, β, γ`, rad.
    pub angles: EulerAngles,
    /// Their derivatives by the path parameter.
    pub rates: EulerAngles,
}

impl CartesianPath {
    pub(crate) fn new(table: &PathTable, task: TaskName, folder: &Path) -> Result<Self, LabError> {
        let range = range(table)?;
        let place = |key: &str| Place { key: key.to_owned(), folder, range: range.clone() };
        let PoseCurves { position, orientation } = match &table.poses {
            Some(poses) => {
                for (key, given) in
                    [("path.position", table.position.is_some()), ("path.orientation", table.orientation.is_some())]
                {
                    if given {
                        return Err(LabError::value(
                            key,
                            Fault::Conflict("`path.poses` gives position and orientation"),
                        ));
                    }
                }
                PoseCurves::new(poses, &place("path.poses"))?
            }
            None => PoseCurves {
                position: position(table, &place("path.position"))?,
                orientation: orientation(table, task, &place("path.orientation"))?,
            },
        };
        let path = Self { start: range.start, end: range.end, position, orientation };
        path.check_finite()?;
        Ok(path)
    }

    /// Path parameter at the start.
    #[must_use]
    pub fn start(&self) -> f64 {
        self.start
    }

    /// Path parameter at the end.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.end
    }

    /// The point at a path parameter, which is not clamped to the path's range.
    #[must_use]
    pub fn at(&self, lambda: f64) -> PathPoint {
        let [position, velocity, acceleration] = self.position.at(lambda);
        let orientation = self.orientation.at(lambda);
        PathPoint {
            pose: Pose::from_parts(Translation3::from(position), orientation.rotation),
            twist: join(&velocity, &orientation.velocity),
            acceleration: join(&acceleration, &orientation.acceleration),
            euler: orientation.euler,
        }
    }

    /// Path parameters strictly inside the path where its derivative jumps, increasing.
    #[must_use]
    pub fn kinks(&self) -> Vec<f64> {
        let mut kinks = self.position.kinks();
        kinks.extend(self.orientation.kinks());
        kinks.retain(|&at| at > self.start && at < self.end);
        kinks.sort_by(f64::total_cmp);
        // Corners of position and orientation that rounding alone keeps apart are one.
        let rounding = 1e-12 * (self.end - self.start);
        kinks.dedup_by(|b, a| *b - *a <= rounding);
        kinks
    }

    /// Formulas can be undefined somewhere: probes them along the path.
    fn check_finite(&self) -> Result<(), LabError> {
        const PROBES: u32 = 1000;
        for i in 0..=PROBES {
            let lambda = self.start + (self.end - self.start) * f64::from(i) / f64::from(PROBES);
            let point = self.at(lambda);
            let finite = |rows: usize| {
                let derivatives = [&point.twist, &point.acceleration];
                derivatives.iter().all(|v| v.fixed_rows::<3>(rows).iter().all(|x| x.is_finite()))
            };
            let position = point.pose.translation.vector.iter().all(|x| x.is_finite()) && finite(0);
            let orientation = point.pose.rotation.matrix().iter().all(|x| x.is_finite()) && finite(3);
            for (key, is_finite) in [("path.position", position), ("path.orientation", orientation)] {
                if !is_finite {
                    return Err(LabError::value(key, Fault::UndefinedAt(lambda)));
                }
            }
        }
        Ok(())
    }
}

fn position(table: &PathTable, place: &Place<'_>) -> Result<PositionCurve, LabError> {
    let missing = Fault::Missing(
        "say where the path leads: `path.position` or `path.poses` for the tool, or `path.joints` for the joints",
    );
    let position = table.position.as_ref().ok_or_else(|| LabError::value("path", missing))?;
    PositionCurve::new(position, place)
}

fn orientation(table: &PathTable, task: TaskName, place: &Place<'_>) -> Result<OrientationCurve, LabError> {
    match &table.orientation {
        Some(table) => OrientationCurve::new(table, place),
        None if matches!(task, TaskName::Pose | TaskName::PlanarPose) => {
            let fault = Fault::Missing("a task that includes the orientation needs one along the path");
            Err(LabError::value(place.key.clone(), fault))
        }
        None => Ok(OrientationCurve::standing()),
    }
}

/// First and last path parameter: as given, else those listed for the way-points, else 0 and 1. Formulas in the path
/// parameter, and the helix, need the last one given.
pub(crate) fn range(table: &PathTable) -> Result<Range<f64>, LabError> {
    let listed = table.listed_parameters().unwrap_or_default();
    let given = |number: Option<Number>, listed: Option<&Number>| number.or(listed.copied()).map(|n| n.0);
    let start = given(table.start, listed.first()).unwrap_or(0.0);
    let default = if table.is_in_the_parameter() { None } else { Some(1.0) };
    let missing = Fault::Missing("this path is a function of the path parameter: say how far it runs");
    let end = given(table.end, listed.last()).or(default).ok_or_else(|| LabError::value("path.end", missing))?;
    if start < end {
        return Ok(start..end);
    }
    let key = match table.listed_key() {
        _ if table.end.is_some() => "path.end".to_owned(),
        Some(key) => key,
        None => "path.start".to_owned(),
    };
    Err(LabError::value(key, Fault::NotIncreasing { before: start, after: end }))
}

fn join(upper: &Vector3<f64>, lower: &Vector3<f64>) -> Vector6<f64> {
    Vector6::new(upper.x, upper.y, upper.z, lower.x, lower.y, lower.z)
}
