use super::follow::{NaturalSample, NaturalTrace};

/// Summary of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NaturalMetrics {
    /// Length of the path the tool has run, m.
    pub distance: f64,
    /// Largest joint speed, rad/s.
    pub peak_joint_speed: f64,
    /// Largest joint torque, N·m, if the masses are known.
    pub peak_torque: Option<f64>,
    /// Mean mechanical power `(1/T) ∫ Σ_i |τ_i q̇_i| dt`, W, if the masses are known: what the motors give and what they
    /// take back both count. This project's definition; the papers' is not stated.
    pub mean_power: Option<f64>,
}

impl<const N: usize> NaturalTrace<N> {
    /// The metrics of the run; integrals by the trapezoidal rule over the samples.
    #[must_use]
    pub fn metrics(&self) -> NaturalMetrics {
        let seconds = self.samples.last().map_or(0.0, |s| s.time);
        let power = |s: &NaturalSample<N>| s.torque.map_or(0.0, |t| t.component_mul(&s.motion.joint_speed).abs().sum());
        let has_torque = self.samples.iter().all(|s| s.torque.is_some());
        let torque = |s: &NaturalSample<N>| s.torque.map_or(0.0, |t| t.amax());
        NaturalMetrics {
            distance: self.integral(|s| s.tool_speed),
            peak_joint_speed: self.largest(|s| s.motion.joint_speed.amax()),
            peak_torque: has_torque.then(|| self.largest(torque)),
            mean_power: has_torque.then(|| self.integral(power) / seconds),
        }
    }

    fn largest(&self, value: impl Fn(&NaturalSample<N>) -> f64) -> f64 {
        self.samples.iter().map(value).fold(0.0, f64::max)
    }

    fn integral(&self, value: impl Fn(&NaturalSample<N>) -> f64) -> f64 {
        self.samples.windows(2).map(|w| 0.5 * (value(&w[0]) + value(&w[1])) * (w[1].time - w[0].time)).sum()
    }
}
