use super::number::Number;
use crate::error::ScenarioError;
use serde::Deserialize;
use slideway_verify::VerifyOptions;

/// The table of a speed scenario as it is written.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SpeedVerifyTable {
    trials: Option<u64>,
    seed: Option<u64>,
    initial_error: Option<Number>,
    joint_noise: Option<Number>,
    joint_offset: Option<Number>,
    speed_error: Option<Number>,
    delay: Option<u32>,
    jitter: Option<Number>,
}

/// The table of a conditioning scenario as it is written.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PathVerifyTable {
    trials: Option<u64>,
    seed: Option<u64>,
    initial_error: Option<Number>,
    distance_noise: Option<Number>,
    delay: Option<u32>,
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
