use super::number::Number;
use crate::error::ScenarioError;
use schemars::JsonSchema;
use serde::Deserialize;
use slideway_verify::VerifyOptions;

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
        options.check()?;
        Ok(options)
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
        options.check()?;
        Ok(options)
    }
}
