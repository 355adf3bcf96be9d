use super::seam::{ACCELERATION, SPEED, beginning, kinematics, seam};
use crate::StudyError;
use slideway_baselines::time_optimal::{TimeOptimum, time_optimum};
use slideway_motion::MotionError;
use slideway_motion::tool::{ToolCurve, ToolKinematics};
use slideway_path::{EndRate, PathSample, SampledPath, SampledPiece};
use slideway_robot::JointVector;

/// Intervals of the grid.
const INTERVALS: u32 = 800;

/// The time optimum of the seam from rest to rest, under the joints' speed and acceleration limits.
pub(super) fn certified() -> Result<TimeOptimum, StudyError> {
    Ok(time_optimum(&sampled()?)?)
}

/// `q'` and `q''` along the seam: the joints' speed and acceleration at `u̇ = 1`, `ü = 0`.
fn sampled() -> Result<SampledPath, MotionError> {
    let (kinematics, seam) = (kinematics()?, seam()?);
    let mut q = beginning();
    let mut nodes = Vec::new();
    for k in 0..=INTERVALS {
        nodes.push(sample(&kinematics, &seam, f64::from(k) / f64::from(INTERVALS), &mut q)?);
    }
    let piece = SampledPiece {
        nodes,
        between: Vec::new(),
        is_self_motion: false,
        start: EndRate::Given(0.0),
        end: EndRate::Given(0.0),
    };
    Ok(SampledPath {
        joints: 6,
        speed_lower: vec![-SPEED; 6],
        speed_upper: vec![SPEED; 6],
        acceleration: Some(vec![ACCELERATION; 6]),
        pieces: vec![piece],
    })
}

fn sample(
    kinematics: &ToolKinematics<6>,
    seam: &ToolCurve,
    u: f64,
    q: &mut JointVector<6>,
) -> Result<PathSample, MotionError> {
    let point = seam.at(u);
    let (twist, acceleration) = point.motion(1.0, 0.0);
    let place = point.pose.translation.vector;
    let fault = |cause| MotionError::Tool { share: u, place: place.into(), cause: Box::new(cause) };
    let state = kinematics.follow(&point.pose, &twist, &acceleration, q).map_err(fault)?;
    *q = state.q;
    let (first, second) = (state.qd.iter().copied().collect(), state.qdd.iter().copied().collect());
    Ok(PathSample { s: u, lambda: u, first, second, ..PathSample::default() })
}
