use nalgebra::Vector3;
use slideway_motion::tool::{Regulation, SpeedLaw, ToolCurve, ToolKinematics, ToolPolyline};
use slideway_motion::{AxisLimits, MotionError, MotionLimits};
use slideway_robot::{JointVector, Task, models};

/// Largest joint speed, rad/s.
pub(super) const SPEED: f64 = 1.5;
/// Largest joint acceleration, rad/s².
pub(super) const ACCELERATION: f64 = 8.0;
/// Largest joint jerk, rad/s³, of Go-Tos.
const JERK: f64 = 200.0;
/// Corners of the seam and its end, from its beginning, m.
const POINTS: [[f64; 3]; 4] = [[0.04, 0.16, 0.0], [0.04, 0.22, -0.12], [-0.02, 0.36, -0.12], [-0.02, 0.46, 0.0]];
/// Where the rounding of a corner begins and ends, m.
const BLEND: f64 = 0.05;
/// Turn of the tool along the seam about the vertical, rad.
const TURN: f64 = 0.5;

/// A speed law of the seam.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Law {
    SlidingMode,
    Natural,
}

impl Law {
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::SlidingMode => "sliding mode",
            Self::Natural => "natural motion",
        }
    }

    pub(super) fn key(self) -> &'static str {
        match self {
            Self::SlidingMode => "sliding-mode",
            Self::Natural => "natural",
        }
    }

    pub(super) fn speed_law(self) -> SpeedLaw {
        match self {
            Self::SlidingMode => SpeedLaw::SlidingMode(Regulation::DEFAULT),
            Self::Natural => SpeedLaw::Natural(Regulation::DEFAULT),
        }
    }
}

/// Where the arm waits.
pub(super) fn home() -> JointVector<6> {
    JointVector::from([-0.6, 0.3, -2.2, 3.1, 0.9, 2.8])
}

/// Where the seam begins.
pub(super) fn beginning() -> JointVector<6> {
    JointVector::from([-0.2, 0.8, -2.6, 3.1, 1.1, 2.8])
}

pub(super) fn kinematics() -> Result<ToolKinematics<6>, MotionError> {
    ToolKinematics::new(models::puma560(), Task::Pose, 0.02)
}

pub(super) fn limits() -> Result<MotionLimits<6>, MotionError> {
    Ok(MotionLimits::without_stops([AxisLimits::new(SPEED, ACCELERATION, JERK)?; 6]))
}

/// The seam: lines with rounded corners.
pub(super) fn seam() -> Result<ToolCurve, MotionError> {
    let start = models::puma560().forward(&beginning());
    let points = POINTS.map(|by| start.translation.vector + Vector3::from(by));
    ToolPolyline::new(&start, &points, BLEND, Vector3::z() * TURN).map(ToolCurve::Polyline)
}

/// Places of the seam, y and z; none if it cannot be made, which the runs report.
pub(super) fn outline() -> Vec<[f64; 2]> {
    let Ok(seam) = seam() else { return Vec::new() };
    let place = |k: u32| seam.at(f64::from(k) / 400.0).pose.translation.vector;
    (0..=400).map(place).map(|p| [p.y, p.z]).collect()
}
