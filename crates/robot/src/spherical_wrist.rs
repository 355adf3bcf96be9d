use crate::{DhRow, JointVector, Pose, RobotError, SerialArm};
use nalgebra::{Rotation3, Vector3};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Which way the shoulder reaches for the wrist centre.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shoulder {
    /// The wrist centre lies in front: `r > 0`.
    Right,
    /// The arm reaches back over its base: `r < 0`.
    Left,
}

/// Where the elbow stands relative to the line from shoulder to wrist centre.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Elbow {
    /// Above the line.
    Up,
    /// Below the line.
    Down,
}

/// Sign of the middle wrist joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wrist {
    /// `q5 >= 0`.
    NoFlip,
    /// `q5 <= 0`.
    Flip,
}

/// One of the eight solutions of a spherical-wrist arm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Branch {
    /// Shoulder.
    pub shoulder: Shoulder,
    /// Elbow.
    pub elbow: Elbow,
    /// Wrist.
    pub wrist: Wrist,
}

/// Closed-form inverse kinematics of a PUMA-like arm with a spherical wrist.
///
/// Needs a standard DH table with `alpha = [π/2, 0, -π/2, π/2, -π/2, 0]`, `a4 = a5 = a6 = 0` and `d5 = 0`. The wrist
/// centre is `c = p - d6 R z`; in the arm's plane, with `ψ = atan2(d4, a3)` and `L = hypot(a3, d4)`,
///
/// ```text
/// r = a1 + a2 cos q2 + L cos(q2 + q3 + ψ),   h = d1 + a2 sin q2 + L sin(q2 + q3 + ψ),   lateral offset d2 + d3
/// R36 = Rz(q4) Ry(-q5) Rz(q6)
/// ```
///
/// Angles are returned in (-π, π]. Where the wrist is singular (`sin q5 = 0`) only `q4 ± q6` is determined; `q4 = 0` is
/// chosen.
#[derive(Clone, Debug, PartialEq)]
pub struct SphericalWristIk {
    rows: [DhRow; 6],
}

/// Slack on the geometry conditions, rad and m: tables are typed with a dozen digits at best.
const GEOMETRY_TOLERANCE: f64 = 1e-9;

/// Sine of `q5` below which the wrist counts as singular: the angles would be read from numbers that are all rounding.
const WRIST_SINGULAR: f64 = 1e-12;

impl SphericalWristIk {
    /// Accepts arms made from a DH table with the geometry above.
    ///
    /// # Errors
    ///
    /// [`RobotError::NotSphericalWrist`] with the first condition that fails.
    pub fn new<const N: usize>(arm: &SerialArm<N>) -> Result<Self, RobotError> {
        let fail = |reason| Err(RobotError::NotSphericalWrist { reason });
        let Some(rows) = arm.dh() else { return fail("it was not given as a DH table") };
        let Ok(rows) = <[DhRow; 6]>::try_from(rows.as_slice()) else { return fail("it does not have six joints") };
        let near = |x: f64, y: f64| (x - y).abs() <= GEOMETRY_TOLERANCE;
        let twists = [FRAC_PI_2, 0.0, -FRAC_PI_2, FRAC_PI_2, -FRAC_PI_2, 0.0];
        if !rows.iter().zip(twists).all(|(row, twist)| near(row.alpha, twist)) {
            return fail("its twists are not [π/2, 0, -π/2, π/2, -π/2, 0]");
        }
        if !(rows[3..].iter().all(|row| near(row.a, 0.0)) && near(rows[4].d, 0.0)) {
            return fail("its last three axes do not meet in one point");
        }
        if rows[1].a <= GEOMETRY_TOLERANCE || rows[2].a.hypot(rows[3].d) <= GEOMETRY_TOLERANCE {
            return fail("its upper arm or forearm has no length");
        }
        Ok(Self { rows })
    }

    /// The solution on one branch.
    ///
    /// # Errors
    ///
    /// [`RobotError::OutOfReach`] with the distance missing.
    pub fn solve(&self, pose: &Pose, branch: Branch) -> Result<JointVector<6>, RobotError> {
        let centre = pose.translation.vector - pose.rotation * Vector3::z() * self.rows[5].d;
        let (q1, r) = self.shoulder(&centre, branch.shoulder)?;
        let (q2, q3) = self.elbow(r, centre.z - self.rows[0].d, branch)?;
        let forearm = Rotation3::from_axis_angle(&Vector3::z_axis(), q1)
            * Rotation3::from_axis_angle(&Vector3::x_axis(), FRAC_PI_2)
            * Rotation3::from_axis_angle(&Vector3::z_axis(), q2 + q3)
            * Rotation3::from_axis_angle(&Vector3::x_axis(), -FRAC_PI_2);
        let wrist = wrist_angles(&(forearm.inverse() * pose.rotation), branch.wrist);
        let q = JointVector::<6>::new(q1, q2, q3, wrist.x, wrist.y, wrist.z);
        Ok(JointVector::<6>::from_fn(|i, _| wrap(q[i] - self.rows[i].offset)))
    }

    /// `q1` and the signed reach `r` in the arm's plane.
    fn shoulder(&self, centre: &Vector3<f64>, shoulder: Shoulder) -> Result<(f64, f64), RobotError> {
        let offset = self.rows[1].d + self.rows[2].d;
        let distance = centre.x.hypot(centre.y);
        if distance < offset.abs() {
            let shortfall = offset.abs() - distance;
            return Err(RobotError::OutOfReach {
                reason: "the wrist centre is too close to the first axis",
                shortfall,
            });
        }
        let reach = ((distance - offset) * (distance + offset)).sqrt();
        let r = if shoulder == Shoulder::Right { reach } else { -reach };
        Ok((centre.y.atan2(centre.x) + offset.atan2(r), r))
    }

    /// `q2` and `q3` from the planar two-link problem.
    fn elbow(&self, r: f64, h: f64, branch: Branch) -> Result<(f64, f64), RobotError> {
        let r = r - self.rows[0].a;
        let (upper, fore) = (self.rows[1].a, self.rows[2].a.hypot(self.rows[3].d));
        let reach = r.hypot(h);
        let shortfall = (reach - (upper + fore)).max((upper - fore).abs() - reach);
        if shortfall > GEOMETRY_TOLERANCE {
            return Err(RobotError::OutOfReach {
                reason: "upper arm and forearm do not span to the wrist centre",
                shortfall,
            });
        }
        let cosine = (reach * reach - upper * upper - fore * fore) / (2.0 * upper * fore);
        let bend = cosine.clamp(-1.0, 1.0).acos();
        let up_bends_down = (branch.shoulder == Shoulder::Right) == (branch.elbow == Elbow::Up);
        let bend = if up_bends_down { -bend } else { bend };
        let q2 = h.atan2(r) - (fore * bend.sin()).atan2(upper + fore * bend.cos());
        Ok((q2, bend - self.rows[3].d.atan2(self.rows[2].a)))
    }
}

/// `q4, q5, q6` of `R36 = Rz(q4) Ry(-q5) Rz(q6)`.
fn wrist_angles(r36: &Rotation3<f64>, wrist: Wrist) -> Vector3<f64> {
    let r = r36.matrix();
    let sine = r[(0, 2)].hypot(r[(1, 2)]);
    if sine <= WRIST_SINGULAR {
        let q5 = if r[(2, 2)] > 0.0 { 0.0 } else { std::f64::consts::PI };
        let turn = r[(1, 0)].atan2(r[(1, 1)]);
        return Vector3::new(0.0, q5, turn);
    }
    match wrist {
        Wrist::NoFlip => {
            Vector3::new((-r[(1, 2)]).atan2(-r[(0, 2)]), sine.atan2(r[(2, 2)]), (-r[(2, 1)]).atan2(r[(2, 0)]))
        }
        Wrist::Flip => Vector3::new(r[(1, 2)].atan2(r[(0, 2)]), (-sine).atan2(r[(2, 2)]), r[(2, 1)].atan2(-r[(2, 0)])),
    }
}

/// The angle in (-π, π].
fn wrap(angle: f64) -> f64 {
    angle - TAU * ((angle / TAU) - 0.5).ceil()
}
