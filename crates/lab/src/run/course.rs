use crate::joints::JointUnits;
use crate::joints::MAX_JOINTS;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Motion of the joints along a path: one entry between every two samples of a run or nodes of an optimum's profile.
#[derive(Clone, Debug, PartialEq)]
pub struct Course {
    /// Number of joints; entries of the joint arrays beyond it are zero.
    pub joints: usize,
    /// Units of the joints.
    pub units: [JointUnits; MAX_JOINTS],
    /// Path parameter from the path's start to its end.
    pub path: Range<f64>,
    /// When a regulated method, which starts from rest, first reaches a limit, s; 0 for what starts at full speed.
    pub settled_s: f64,
    /// Joint position where the first interval begins, rad (m).
    pub start: [f64; MAX_JOINTS],
    /// The intervals, in order.
    pub samples: Vec<CourseSample>,
}

/// The middle of one interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CourseSample {
    /// Time, s.
    pub t: f64,
    /// Length of the interval, s.
    pub dt: f64,
    /// Path parameter.
    pub lambda: f64,
    /// Its rate, 1/s.
    pub path_rate: f64,
    /// Mean of the joint speeds at both ends, rad/s.
    pub speed: [f64; MAX_JOINTS],
    /// Change of the joint speed over the interval's length, rad/s².
    pub acceleration: [f64; MAX_JOINTS],
    /// Rigid-body torque that this takes, N·m, where the robot's masses are known.
    pub torque: Option<[f64; MAX_JOINTS]>,
}

/// A place of an optimum's profile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfilePoint {
    /// Piece of the joint path, from 0.
    pub piece: usize,
    /// The piece's parameter.
    pub s: f64,
    /// `ds/dt`, 1/s.
    pub rate: f64,
    /// Time, s.
    pub t: f64,
}

/// Cost of a run to the drives once it is under way: a regulated method counts from the moment when it first reaches a limit, so
/// that its start from rest is not held against it beside those that start at full speed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Effort {
    /// Largest joint speed, rad/s.
    pub peak_joint_speed: f64,
    /// Smoothness: root of the mean over time of `‖q̈‖²`, rad/s². A commanded speed that chatters counts with its change over
    /// a sample.
    pub rms_acceleration: f64,
    /// Largest joint torque, N·m (rigid bodies, without friction and rotor inertia); `None` without masses.
    pub peak_torque: Option<f64>,
    /// Energy `∫ Σ_i |τ_i q̇_i| dt`, J: what the drives give and what they take back both count; `None` without masses.
    pub energy: Option<f64>,
}

impl Course {
    /// The samples from the moment when the run has reached a limit.
    pub fn under_way(&self) -> impl Iterator<Item = &CourseSample> {
        self.samples.iter().filter(|s| s.t >= self.settled_s)
    }

    /// Duration, s.
    #[must_use]
    pub fn seconds(&self) -> f64 {
        self.samples.iter().map(|s| s.dt).sum()
    }

    /// The same motion in another time, s: speeds go with its inverse, accelerations with the inverse's square. Torques are
    /// left out: gravity's part does not scale.
    #[must_use]
    pub fn in_time(&self, seconds: f64) -> Self {
        let by = self.seconds() / seconds;
        let scaled = |s: &CourseSample| CourseSample {
            t: s.t / by,
            dt: s.dt / by,
            lambda: s.lambda,
            path_rate: s.path_rate * by,
            speed: s.speed.map(|v| v * by),
            acceleration: s.acceleration.map(|a| a * by * by),
            torque: None,
        };
        Self { settled_s: self.settled_s / by, samples: self.samples.iter().map(scaled).collect(), ..self.clone() }
    }

    /// The effort; `None` where the run never gets under way.
    #[must_use]
    pub fn effort(&self) -> Option<Effort> {
        let samples: Vec<&CourseSample> = self.under_way().collect();
        let seconds: f64 = samples.iter().map(|s| s.dt).sum();
        if !(seconds > 0.0) {
            return None;
        }
        let integral = |value: &dyn Fn(&CourseSample) -> f64| samples.iter().map(|s| value(s) * s.dt).sum::<f64>();
        let largest = |value: &dyn Fn(&CourseSample) -> f64| samples.iter().map(|s| value(s)).fold(0.0, f64::max);
        let has_torque = samples.iter().all(|s| s.torque.is_some());
        Some(Effort {
            peak_joint_speed: largest(&|s| amax(&s.speed)),
            rms_acceleration: (integral(&|s| s.acceleration.iter().map(|a| a * a).sum()) / seconds).sqrt(),
            peak_torque: has_torque.then(|| largest(&|s| s.torque.as_ref().map_or(0.0, amax))),
            energy: has_torque.then(|| integral(&CourseSample::power)),
        })
    }
}

impl CourseSample {
    /// `Σ_i |τ_i q̇_i|`, W; 0 without masses.
    fn power(&self) -> f64 {
        self.torque.map_or(0.0, |torque| torque.iter().zip(&self.speed).map(|(t, v)| (t * v).abs()).sum())
    }
}

fn amax(values: &[f64; MAX_JOINTS]) -> f64 {
    values.iter().fold(0.0, |most: f64, v| most.max(v.abs()))
}
