use slideway_lab::{MOST_DELAY, MOST_JITTER, MOST_NOISE, MOST_SPEED_ERROR};
use slideway_path::{Fault, ProblemError};

/// A campaign of random trials as a scenario asks for it: the table `[verify]`. What is not given is left to the campaign.
///
/// The entries but the first two are the greatest of each disturbance; 0 leaves it out.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct VerifyOptions {
    /// Number of trials.
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

impl VerifyOptions {
    /// Checks the greatest disturbances against what the table `[disturbances]` takes; NaN is beyond it.
    ///
    /// # Errors
    ///
    /// A greatest disturbance that no run may have, or no trials.
    pub fn check(&self) -> Result<(), ProblemError> {
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
                return Err(ProblemError::value(format!("verify.{key}"), fault));
            }
        }
        if self.trials == Some(0) {
            return Err(ProblemError::value("verify.trials", Fault::NotPositive(0.0)));
        }
        Ok(())
    }
}
