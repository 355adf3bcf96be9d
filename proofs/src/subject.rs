//! Subjects of the engines: the shipped speed regulator, or one broken on purpose.
//!
//! The broken ones live here and nowhere else. Each makes one mistake that a careless edit of the regulator could make; that every one
//! is caught by a claim shows that the claims would notice the mistake.

use std::collections::VecDeque;

use slideway_conditioner::{
    Advance, ParameterError, Saturation, SpeedCommand, SpeedLimits, SpeedRegulator, SpeedSettings, SpeedState,
};

/// The regulator under test.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// As it is shipped.
    Shipped,
    /// With one mistake.
    Broken(Fault),
}

/// A mistake.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// `f - a (u - f)` instead of `f + a (u - f)`.
    FilterSign,
    /// `u = 1` outside the limits, 0 inside.
    ComparisonFlipped,
    /// `!(v < lower || v > upper)`: NaN counts as inside.
    NanPassing,
    /// The path advances with the factor of the next sample.
    OffByOneSample,
    /// The first joint's limit is not looked at.
    LimitIgnored,
    /// `u` reaches the filter one sample late.
    SwitchDelayed,
}

impl Fault {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::FilterSign,
        Self::ComparisonFlipped,
        Self::NanPassing,
        Self::OffByOneSample,
        Self::LimitIgnored,
        Self::SwitchDelayed,
    ];

    /// Description of the fault, in a few words.
    #[must_use]
    pub fn description(self) -> &'static str {
        match self {
            Self::FilterSign => "sign of the filter turned",
            Self::ComparisonFlipped => "comparison with the limits flipped",
            Self::NanPassing => "NaN taken for a speed inside the limits",
            Self::OffByOneSample => "path advanced with the factor of the next sample",
            Self::LimitIgnored => "limit of one joint ignored",
            Self::SwitchDelayed => "u delayed by one sample",
        }
    }
}

/// A speed regulator with its state.
#[derive(Clone, Debug)]
pub struct Regulator<const N: usize> {
    shipped: SpeedRegulator<N>,
    settings: SpeedSettings<N>,
    fault: Option<Fault>,
    state: SpeedState,
    late: VecDeque<f64>,
}

impl Subject {
    /// A regulator whose reference moves with the factor `start`.
    ///
    /// # Errors
    ///
    /// Errors of the shipped regulator: settings that it refuses.
    pub fn regulator<const N: usize>(
        self,
        settings: SpeedSettings<N>,
        start: f64,
    ) -> Result<Regulator<N>, ParameterError> {
        let fault = match self {
            Self::Shipped => None,
            Self::Broken(fault) => Some(fault),
        };
        let (shipped, state) = (SpeedRegulator::new(settings)?, SpeedState::moving(start)?);
        Ok(Regulator { shipped, settings, fault, state, late: VecDeque::from([1.0]) })
    }

    /// One step of the filter.
    ///
    /// # Errors
    ///
    /// Errors of the shipped filter: a bandwidth or period that it refuses.
    pub fn filter(self, bandwidth: f64, period: f64, output: f64, input: f64) -> Result<f64, ParameterError> {
        let shipped = slideway_conditioner::FirstOrderFilter::new(bandwidth, period)?;
        Ok(match self {
            Self::Broken(Fault::FilterSign) => output - shipped.step() * (input - output),
            _ => shipped.next(output, input),
        })
    }
}

impl<const N: usize> Regulator<N> {
    /// The factor of the coming sample.
    #[must_use]
    pub fn factor(&self) -> f64 {
        self.state.factor()
    }

    /// `f λ̇d`, 1/s.
    #[must_use]
    pub fn requested_rate(&self) -> f64 {
        self.shipped.requested_rate(&self.state)
    }

    /// One sample under other limits than those it was made with.
    pub fn step_under(&mut self, limits: SpeedLimits<N>, desired: &[f64; N]) -> SpeedCommand<N> {
        self.shipped = self.shipped.with_limits(limits);
        self.settings.limits = limits;
        self.step(desired)
    }

    /// One sample.
    pub fn step(&mut self, desired: &[f64; N]) -> SpeedCommand<N> {
        let before = self.state;
        let command = self.shipped.step(&mut self.state, desired);
        match self.fault {
            None => command,
            Some(fault) => self.spoil(fault, before.factor(), desired, command),
        }
    }

    fn spoil(
        &mut self,
        fault: Fault,
        before: f64,
        desired: &[f64; N],
        mut command: SpeedCommand<N>,
    ) -> SpeedCommand<N> {
        let a = self.settings.bandwidth * self.settings.sampling_period;
        match fault {
            Fault::FilterSign => self.put(before - a * (command.switch - before)),
            Fault::ComparisonFlipped => {
                command.switch = 1.0 - command.switch;
                self.put(before + a * (command.switch - before));
            }
            Fault::NanPassing if desired.iter().any(|v| v.is_nan()) => {
                command.joint_speed = *desired;
                command.switch = 1.0;
                command.path_rate = before * self.settings.target_rate;
                self.put(before + a * (1.0 - before));
            }
            Fault::NanPassing => {}
            Fault::OffByOneSample => {
                if before > 0.0 {
                    command.path_rate *= self.state.factor() / before;
                }
            }
            Fault::LimitIgnored => return self.blind(before, desired, command),
            Fault::SwitchDelayed => {
                self.late.push_back(command.switch);
                let arrived = self.late.pop_front().unwrap_or(1.0);
                self.put(before + a * (arrived - before));
            }
        }
        command
    }

    /// As the regulator, had the first joint no limit; the ratio that is reported stays the true one.
    fn blind(&mut self, before: f64, desired: &[f64; N], command: SpeedCommand<N>) -> SpeedCommand<N> {
        let (mut lower, mut upper) = (*self.settings.limits.lower(), *self.settings.limits.upper());
        if let (Some(lower), Some(upper)) = (lower.first_mut(), upper.first_mut()) {
            (*lower, *upper) = (-f64::MAX, f64::MAX);
        }
        let Ok(limits) = SpeedLimits::new(lower, upper) else { return command };
        self.put(before);
        let blind = self.shipped.with_limits(limits).step(&mut self.state, desired);
        SpeedCommand { limit_ratio: command.limit_ratio, ..blind }
    }

    // `max` first: it turns NaN into 0, where `clamp` would keep it.
    #[allow(clippy::manual_clamp)]
    fn put(&mut self, factor: f64) {
        if let Ok(state) = SpeedState::moving(factor.max(0.0).min(1.0)) {
            self.state = state;
        }
    }
}

/// Settings in which only what a claim is about varies.
#[must_use]
pub fn settings<const N: usize>(limits: SpeedLimits<N>, period: f64, step: f64, target_rate: f64) -> SpeedSettings<N> {
    SpeedSettings {
        limits,
        sampling_period: period,
        bandwidth: step / period,
        target_rate,
        saturation: Saturation::DirectionPreserving,
        advance: Advance::Paper,
    }
}
