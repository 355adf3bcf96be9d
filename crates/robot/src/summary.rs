use crate::{JointKind, JointLimits, PositionRange, RobotDescription};
use serde::Serialize;

/// A robot in names and numbers, as `slideway robot --json` and `summary.json` show it: how its file or table was read.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RobotSummary {
    /// Name of the robot.
    pub name: String,
    /// Frame that poses are expressed in.
    pub base: String,
    /// Frame that counts as the tool.
    pub tip: String,
    /// Other links that could have been meant as the tip; none where the tip was given.
    pub tip_alternatives: Vec<String>,
    /// The joints that move on their own, from base to tip: the order of every list with a number for each joint.
    pub joints: Vec<JointSummary>,
    /// The joints between base and tip that follow one of those.
    pub followers: Vec<FollowerSummary>,
    /// Gravitational acceleration in the base frame, m/s².
    pub gravity: [f64; 3],
    /// Whether any link has a mass: without one there is no dynamics.
    pub has_masses: bool,
    /// What was guessed, held or left aside, in sentences.
    pub notes: Vec<String>,
}

/// A joint: its name, its kind and its limits, `None` where there is none or none is known.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct JointSummary {
    /// Its name.
    pub name: String,
    /// How it moves.
    pub kind: JointKind,
    /// Smallest and largest position, rad (m); `None` also for a side that is open.
    pub position: [Option<f64>; 2],
    /// Largest speed, rad/s (m/s).
    pub speed: Option<f64>,
    /// Largest acceleration, rad/s² (m/s²).
    pub acceleration: Option<f64>,
    /// Largest torque, N·m (force, N).
    pub torque: Option<f64>,
}

/// A joint that follows another one: its position is `ratio` times that of its leader, plus `offset`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FollowerSummary {
    /// Its name.
    pub name: String,
    /// Name of the joint that leads it; `None` if the description has no such joint.
    pub leader: Option<String>,
    /// Its motion per motion of the leader.
    pub ratio: f64,
    /// Its position where the leader is at zero, rad (m).
    pub offset: f64,
}

impl From<&RobotDescription> for RobotSummary {
    fn from(robot: &RobotDescription) -> Self {
        let joint = |j: &crate::JointDescription| JointSummary::new(&j.name, j.joint.kind, &j.limits);
        let follower = |f: &crate::FollowerDescription| FollowerSummary {
            name: f.name.clone(),
            leader: robot.joints.get(f.follower.leader).map(|leader| leader.name.clone()),
            ratio: f.follower.ratio,
            offset: f.follower.joint.offset,
        };
        Self {
            name: robot.name.clone(),
            base: robot.base.clone(),
            tip: robot.tip.clone(),
            tip_alternatives: robot.tip_alternatives.clone(),
            joints: robot.joints.iter().map(joint).collect(),
            followers: robot.followers.iter().map(follower).collect(),
            gravity: robot.gravity.into(),
            has_masses: robot.has_masses(),
            notes: robot.notes.iter().map(ToString::to_string).collect(),
        }
    }
}

impl JointSummary {
    fn new(name: &str, kind: JointKind, limits: &JointLimits) -> Self {
        let range = limits.position.map_or([None; 2], |PositionRange { lower, upper }| [Some(lower), Some(upper)]);
        Self {
            name: name.to_owned(),
            kind,
            position: range.map(|end| end.filter(|end| end.is_finite())),
            speed: limits.velocity,
            acceleration: limits.acceleration,
            torque: limits.effort,
        }
    }
}
