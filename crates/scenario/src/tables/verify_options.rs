use super::number::Number;
use crate::error::ScenarioError;
use schemars::JsonSchema;
use serde::Deserialize;
use slideway_lab::{MOST_DELAY, MOST_JITTER, MOST_NOISE, MOST_SPEED_ERROR};
use slideway_path::Fault;

/// What a campaign of random trials around a scenario is asked to do: the table `[verify]`. What is not given is left to the campaign.
///
/// The entries but the first two are the greatest of each disturbance; 0 leaves it out.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct VerifyOptions {
    /// How many trials.
    pub trials: Option<u64>,
    /// Seed of the campaign.
    pub seed: Option<u64>,
    /// Error of the start: rad (m) of each joint, or m of each coordinate of the conditioned reference.
    pub initial_error: Option<f64>,
    /// Noise of measured joint positions, rad (m); speed scenarios only.
    pub joint_noise: Option<f64>,
    /// Error of the joints' zeros, rad (m): a kinematic model that is wrong; speed scenarios only.
    pub joint_offset: Option<f64>,
    /// Error of the drives, share of the commanded speed; speed scenarios only.
    pub speed_error: Option<f64>,
    /// Noise of measured distances, m; conditioning scenarios only.
    pub distance_noise: Option<f64>,
    /// Delay, samples.
    pub delay: Option<u32>,
    /// Jitter, share of the sampling period.
    pub jitter: Option<f64>,
}

/// The table of a speed scenario as it is written.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SpeedVerifyTable {
    /// How many.
    trials: Option<u64>,
    /// Their seed.
    seed: Option<u64>,
    /// Greatest error of the start, rad (m) of each joint.
    initial_error: Option<Number>,
    /// Greatest noise of measured joint positions, rad (m).
    joint_noise: Option<Number>,
    /// Greatest error of the joints' zeros, rad (m).
    joint_offset: Option<Number>,
    /// Greatest error of the drives, share of the commanded speed.
    speed_error: Option<Number>,
    /// Greatest delay, samples.
    delay: Option<u32>,
    /// Greatest jitter, share of the sampling period.
    jitter: Option<Number>,
}

/// The table of a conditioning scenario as it is written.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct PathVerifyTable {
    /// How many.
    trials: Option<u64>,
    /// Their seed.
    seed: Option<u64>,
    /// Greatest error of the start, m of each coordinate.
    initial_error: Option<Number>,
    /// Greatest noise of measured distances, m.
    distance_noise: Option<Number>,
    /// Greatest delay, samples.
    delay: Option<u32>,
    /// Greatest jitter, share of the sampling period.
    jitter: Option<Number>,
}

impl SpeedVerifyTable {
    pub(crate) fn read(&self) -> Result<VerifyOptions, ScenarioError> {
        let number = |number: Option<Number>| number.map(|n| n.0);
        let options = VerifyOptions {
            trials: self.trials,
            seed: self.seed,
            initial_error: number(self.initial_error),
            joint_noise: number(self.joint_noise),
            joint_offset: number(self.joint_offset),
            speed_error: number(self.speed_error),
            distance_noise: None,
            delay: self.delay,
            jitter: number(self.jitter),
        };
        options.check()
    }
}

impl PathVerifyTable {
    pub(crate) fn read(&self) -> Result<VerifyOptions, ScenarioError> {
        let number = |number: Option<Number>| number.map(|n| n.0);
        let options = VerifyOptions {
            trials: self.trials,
            seed: self.seed,
            initial_error: number(self.initial_error),
            distance_noise: number(self.distance_noise),
            delay: self.delay,
            jitter: number(self.jitter),
            ..VerifyOptions::default()
        };
        options.check()
    }
}

impl VerifyOptions {
    /// The greatest values that the table `[disturbances]` takes; NaN is beyond them.
    fn check(self) -> Result<Self, ScenarioError> {
        let noise = MOST_NOISE;
        for (key, value, most) in [
            ("initial_error", self.initial_error, 10.0),
            ("joint_noise", self.joint_noise, noise),
            ("joint_offset", self.joint_offset, noise),
            ("speed_error", self.speed_error, MOST_SPEED_ERROR),
            ("distance_noise", self.distance_noise, noise),
            ("delay", self.delay.map(f64::from), MOST_DELAY.into()),
            ("jitter", self.jitter, MOST_JITTER),
        ] {
            if let Some(value) = value.filter(|value| !(0.0..=most).contains(value)) {
                let fault = Fault::OutOfRange { value, least: 0.0, most };
                return Err(ScenarioError::value(format!("verify.{key}"), fault));
            }
        }
        if self.trials == Some(0) {
            return Err(ScenarioError::value("verify.trials", Fault::NotPositive(0.0)));
        }
        Ok(self)
    }
}
