//! Random parameters and small robots that meet the hypotheses of the claims.

use slideway_conditioner::{Advance, Saturation, SpeedLimits, SpeedSettings};

use crate::engine::{Choices, Stop};
use crate::subject;

/// Sampling period, s. A power of two, so that `(a / TS) * TS` gives back `a` to the last bit.
pub const TS: f64 = 1.0 / 1024.0;

/// Unit roundoff of round-to-nearest doubles, 2^-53.
pub const ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// Direction-preserving saturation, the paper's advance, period [`TS`].
#[must_use]
pub fn settings<const N: usize>(limits: SpeedLimits<N>, step: f64, target_rate: f64) -> SpeedSettings<N> {
    subject::settings(limits, TS, step, target_rate)
}

/// Filter steps over six decades, the largest one included.
pub fn filter_step(choices: &mut Choices) -> f64 {
    let kind = choices.below(9);
    let size = choices.unit();
    match kind {
        0 => 1.0,
        1..=4 => 1e-3 + 0.999 * size,
        _ => 10f64.powf(-6.0 * size),
    }
}

/// Either kind.
pub fn saturation(choices: &mut Choices) -> Saturation {
    choices.pick([Saturation::Direct, Saturation::DirectionPreserving])
}

/// Either kind.
pub fn advance(choices: &mut Choices) -> Advance {
    choices.pick([Advance::Paper, Advance::Synchronised])
}

/// Asymmetric limits, `10^exponent` in size.
///
/// # Errors
///
/// None in fact: limits are positive and finite for every exponent within ±300.
pub fn limits<const N: usize>(choices: &mut Choices, low: f64, high: f64) -> Result<SpeedLimits<N>, Stop> {
    let lower = std::array::from_fn(|_| -choices.decade(low, high));
    let upper = std::array::from_fn(|_| choices.decade(low, high));
    Ok(SpeedLimits::new(lower, upper)?)
}

/// Numbers of every bit pattern, or of ordinary size.
pub fn wild<const N: usize>(choices: &mut Choices, size: f64) -> [f64; N] {
    let any = choices.flag();
    std::array::from_fn(|_| if any { choices.bits() } else { choices.between(-size, size) })
}

/// Joints that all turn in proportion to one number: at 1 one joint reaches its limit and none exceeds its own.
#[derive(Clone, Copy, Debug)]
pub struct Proportional<const N: usize> {
    /// The joints' limits, rad/s.
    pub limits: SpeedLimits<N>,
    at_one: [f64; N],
}

impl<const N: usize> Proportional<N> {
    /// Desired joint speed for `‖F_N q̇d‖∞ = use_of_limit`. Two roundings from `at_one`, which has one, to the ratio.
    #[must_use]
    pub fn at(&self, use_of_limit: f64) -> [f64; N] {
        self.at_one.map(|speed| speed * use_of_limit)
    }

    /// A random one.
    ///
    /// # Errors
    ///
    /// See [`limits`].
    pub fn draw(choices: &mut Choices) -> Result<Self, Stop> {
        let limits = limits::<N>(choices, -3.0, 3.0)?;
        let mut shares: [f64; N] = choices.numbers(-1.0, 1.0);
        let (first, sign) = (choices.below(N), choices.sign());
        if let Some(share) = shares.get_mut(first) {
            *share = sign;
        }
        let mut at_one = shares;
        for ((share, lower), upper) in at_one.iter_mut().zip(limits.lower()).zip(limits.upper()) {
            *share *= if *share < 0.0 { lower.abs() } else { *upper };
        }
        Ok(Self { limits, at_one })
    }
}
