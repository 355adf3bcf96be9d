use crate::profile::{Hermite, Profile};
use crate::{JointMotion, MotionError, MotionLimits};
use slideway_robot::JointVector;

/// Rule for the velocities at inner way-points. The first and the last are zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WayPointRule {
    /// Zero where the direction changes, else the mean of the slopes on both sides: no overshoot at turns; C¹.
    MeanSlope,
    /// As in the clamped cubic spline: the acceleration is continuous at the way-points (C² inside the path).
    Spline,
}

impl WayPointRule {
    /// Velocities of one joint at its way-points, per s. Plans outside the control loop: it allocates.
    ///
    /// # Errors
    ///
    /// [`MotionError::WayPoints`] unless there are two points or more and one positive duration between each two.
    pub fn velocities(self, points: &[f64], durations: &[f64]) -> Result<Vec<f64>, MotionError> {
        let positive = durations.iter().all(|&d| d > 0.0 && d.is_finite());
        if points.len() < 2 || durations.len() != points.len() - 1 || !positive {
            return Err(MotionError::WayPoints { points: points.len() });
        }
        let slopes: Vec<f64> = points.windows(2).zip(durations).map(|(p, d)| (p[1] - p[0]) / d).collect();
        let inner = match self {
            Self::MeanSlope => {
                slopes.windows(2).map(|s| if s[0] * s[1] > 0.0 { 0.5 * (s[0] + s[1]) } else { 0.0 }).collect()
            }
            Self::Spline => spline(&slopes, durations),
        };
        let mut velocities = vec![0.0];
        velocities.extend(inner);
        velocities.push(0.0);
        Ok(velocities)
    }
}

/// Inner velocities of the clamped spline. Equal accelerations on both sides of way-point `k` read
///
/// ```text
/// m[k-1]/h[k-1] + 2 (1/h[k-1] + 1/h[k]) m[k] + m[k+1]/h[k] = 3 (s[k-1]/h[k-1] + s[k]/h[k])
/// ```
///
/// with durations `h` and slopes `s`: tridiagonal and diagonally dominant, so elimination needs no pivots.
fn spline(slopes: &[f64], durations: &[f64]) -> Vec<f64> {
    let mut eliminated: Vec<(f64, f64)> = Vec::with_capacity(slopes.len());
    for (s, h) in slopes.windows(2).zip(durations.windows(2)) {
        let (before, after) = (1.0 / h[0], 1.0 / h[1]);
        let right = 3.0 * (s[0] * before + s[1] * after);
        let &(coupling, value) = eliminated.last().unwrap_or(&(0.0, 0.0));
        let pivot = 2.0 * (before + after) - before * coupling;
        eliminated.push((after / pivot, (right - before * value) / pivot));
    }
    let mut next = 0.0;
    let mut inner: Vec<f64> = eliminated
        .iter()
        .rev()
        .map(|(coupling, value)| {
            next = value - coupling * next;
            next
        })
        .collect();
    inner.reverse();
    inner
}

/// A path of cubics through way-points, at rest at both ends, as fast as one common stretch of the given pace allows.
///
/// Each piece first gets the time it needs at full speed; then all durations are stretched by
/// `max(v/V, sqrt(a/A))` over all joints and pieces, which scales speeds and accelerations by its first and second power.
/// A heuristic: not the fastest path through the points.
///
/// # Errors
///
/// Fewer than two points, two equal neighbours, a number that is not finite, a path beyond a joint's stop.
pub fn path_through<const N: usize>(
    points: &[JointVector<N>],
    rule: WayPointRule,
    limits: &MotionLimits<N>,
) -> Result<Vec<JointMotion<N>>, MotionError> {
    let axes = limits.axes();
    let needed =
        |p: &[JointVector<N>]| (0..N).map(|i| (p[1][i] - p[0][i]).abs() / axes[i].velocity()).fold(0.0, f64::max);
    let durations: Vec<f64> = points.windows(2).map(needed).collect();
    let path = cubics_through(points, &durations, rule)?;
    let mut stretch = 1.0_f64;
    for motion in &path {
        for (limits, profile) in axes.iter().zip(motion.profiles()) {
            let peaks = profile.peaks();
            let by_velocity = peaks.velocity.magnitude() / limits.velocity();
            let by_acceleration = (peaks.acceleration.magnitude() / limits.acceleration()).sqrt();
            stretch = stretch.max(by_velocity).max(by_acceleration);
        }
    }
    let durations: Vec<f64> = durations.iter().map(|d| d * stretch).collect();
    let path = cubics_through(points, &durations, rule)?;
    for motion in &path {
        for (joint, profile) in motion.profiles().iter().enumerate() {
            limits.check_stops(joint, profile.peaks().position)?;
        }
    }
    Ok(path)
}

fn cubics_through<const N: usize>(
    points: &[JointVector<N>],
    durations: &[f64],
    rule: WayPointRule,
) -> Result<Vec<JointMotion<N>>, MotionError> {
    let mut velocities: Vec<JointVector<N>> = vec![JointVector::zeros(); points.len()];
    for joint in 0..N {
        let column: Vec<f64> = points.iter().map(|p| p[joint]).collect();
        if column.iter().any(|q| !q.is_finite()) {
            return Err(MotionError::NotFinite { joint });
        }
        for (all, one) in velocities.iter_mut().zip(rule.velocities(&column, durations)?) {
            all[joint] = one;
        }
    }
    let pieces = points.windows(2).zip(velocities.windows(2)).zip(durations);
    Ok(pieces
        .map(|((p, v), &duration)| {
            JointMotion::new(std::array::from_fn(|i| {
                let piece = Hermite { start: p[0][i], start_velocity: v[0][i], goal: p[1][i], goal_velocity: v[1][i] };
                Profile::Cubics(piece.over(duration))
            }))
        })
        .collect())
}
