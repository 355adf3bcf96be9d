use serde::{Deserialize, Serialize};
use slideway_lab::Disturbances;
use slideway_lab::conditioning::PathDisturbances;

/// Disturbances of a trial, as the table `[disturbances]` of a scenario has them; what is zero is absent.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct TrialDisturbances {
    /// Delay, samples.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub delay: Option<u32>,
    /// Noise of measured distances, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub distance_noise: Option<f64>,
    /// Error of the start: rad (m) of each joint, or m of each coordinate.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub initial_error: Option<Vec<f64>>,
    /// Jitter, share of the sampling period.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub jitter: Option<f64>,
    /// Noise of measured joint positions, rad (m).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub joint_noise: Option<f64>,
    /// Error of the joints' zeros, rad (m).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub joint_offset: Option<Vec<f64>>,
    /// Seed of noise and jitter, of 53 bits, so that no reader of JSON rounds it; absent without either.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
    /// Error of the drives, share of the commanded speed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub speed_error: Option<Vec<f64>>,
}

impl TrialDisturbances {
    /// For a run of a speed scenario.
    #[must_use]
    pub fn for_speed(&self) -> Disturbances {
        Disturbances {
            seed: self.seed.unwrap_or_default(),
            initial_error: self.initial_error.clone().unwrap_or_default(),
            joint_noise: self.joint_noise.unwrap_or_default(),
            joint_offset: self.joint_offset.clone().unwrap_or_default(),
            speed_error: self.speed_error.clone().unwrap_or_default(),
            delay: self.delay.unwrap_or_default(),
            jitter: self.jitter.unwrap_or_default(),
        }
    }

    /// For a run of a conditioning scenario.
    #[must_use]
    pub fn for_conditioning(&self) -> PathDisturbances {
        let error = self.initial_error.as_deref().unwrap_or_default();
        PathDisturbances {
            seed: self.seed.unwrap_or_default(),
            initial_error: std::array::from_fn(|i| error.get(i).copied().unwrap_or(0.0)),
            distance_noise: self.distance_noise.unwrap_or_default(),
            delay: self.delay.unwrap_or_default(),
            jitter: self.jitter.unwrap_or_default(),
        }
    }
}
