use crate::error::{Fault, ProblemError};
use crate::reference::orientation::OrientationCurve;
use crate::reference::point::PathPoint;
use crate::reference::position::PositionCurve;
use nalgebra::{Translation3, Vector3, Vector6};
use slideway_robot::Pose;
use std::ops::Range;

/// A path of the tool: position and orientation as functions of the path parameter `λ`.
///
/// In m and rad, Euler triples meaning `Rz(α) Ry(β) Rx(γ)`, all in the base frame.
#[derive(Clone, Debug)]
pub struct CartesianPath {
    start: f64,
    end: f64,
    position: PositionCurve,
    orientation: OrientationCurve,
    kinks: Vec<f64>,
}

impl CartesianPath {
    /// A path of the tool over a range of the path parameter, tried at a thousand points.
    ///
    /// # Errors
    ///
    /// A range that is empty; a curve without a finite value or derivative somewhere.
    pub fn new(
        position: PositionCurve,
        orientation: OrientationCurve,
        range: Range<f64>,
    ) -> Result<Self, ProblemError> {
        let Range { start, end } = range;
        if !(start < end) {
            return Err(ProblemError::value("path.end", Fault::NotIncreasing { before: start, after: end }));
        }
        let mut path = Self { start, end, position, orientation, kinks: Vec::new() };
        path.check_finite()?;
        path.kinks = path.find_kinks();
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
        // [G11] eq 1
        let [position, velocity, acceleration] = self.position.at(lambda);
        let orientation = self.orientation.at(lambda);
        PathPoint {
            pose: Pose::from_parts(Translation3::from(position), orientation.rotation),
            twist: join(&velocity, &orientation.velocity),
            acceleration: join(&acceleration, &orientation.acceleration),
            euler: orientation.euler,
        }
    }

    /// Path parameters strictly inside the path where its derivative jumps, increasing. Those of formulas (`abs`, `min`, `max`) are found from its
    /// change between a thousand points: of two between neighbouring points one may be missed.
    #[must_use]
    pub fn kinks(&self) -> &[f64] {
        &self.kinks
    }

    fn find_kinks(&self) -> Vec<f64> {
        let range = self.start..self.end;
        let mut kinks = self.position.kinks(&range);
        kinks.extend(self.orientation.kinks(&range));
        // Corners of position and orientation that rounding alone keeps apart are one, and one that it keeps from an end is none.
        let rounding = 1e-12 * (self.end - self.start);
        kinks.retain(|&at| at > self.start + rounding && at < self.end - rounding);
        kinks.sort_by(f64::total_cmp);
        kinks.dedup_by(|b, a| *b - *a <= rounding);
        kinks
    }

    /// Formulas can be undefined somewhere: probes them along the path.
    fn check_finite(&self) -> Result<(), ProblemError> {
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
                    return Err(ProblemError::value(key, Fault::UndefinedAt(lambda)));
                }
            }
        }
        Ok(())
    }
}

fn join(upper: &Vector3<f64>, lower: &Vector3<f64>) -> Vector6<f64> {
    Vector6::new(upper.x, upper.y, upper.z, lower.x, lower.y, lower.z)
}
