use super::{FrequencyResponse, SineTest};
use crate::MotionError;
use crate::error::{positive, setting};

/// Where the bandwidth is looked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BandwidthSearch {
    /// Lowest frequency, rad/s, at which the system is expected to follow.
    pub lowest: f64,
    /// Highest frequency, rad/s.
    pub highest: f64,
    /// Relative width of the bracket, before a line is drawn through its ends.
    pub accuracy: f64,
}

/// Half of the power.
const HALF_POWER: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// Bandwidth of a system, rad/s: the lowest frequency found at which its gain is `1/√2`. `fresh` makes a system at rest for each
/// experiment.
///
/// Frequencies rise by a quarter of an octave until the gain falls below, then the bracket is halved. A dip narrower than a
/// quarter of an octave may be missed.
///
/// # Errors
///
/// [`MotionError::NoBandwidth`] if the gain stays above up to the highest frequency; what the experiment reports; settings out of
/// range, or a gain below `1/√2` at the lowest frequency already ([`MotionError::Setting`] with that frequency).
pub fn bandwidth<S: FnMut(f64) -> Result<f64, MotionError>>(
    test: &SineTest,
    search: &BandwidthSearch,
    mut fresh: impl FnMut() -> S,
) -> Result<f64, MotionError> {
    positive("lowest", search.lowest)?;
    setting("highest", search.highest, search.highest > search.lowest)?;
    setting("accuracy", search.accuracy, search.accuracy > 0.0 && search.accuracy < 1.0)?;
    let mut answer = |frequency: f64| test.run(frequency, &mut fresh());
    let mut below = answer(search.lowest)?;
    setting("lowest", search.lowest, below.gain > HALF_POWER)?;
    let mut asked = search.lowest;
    let mut above = loop {
        if asked >= search.highest {
            return Err(MotionError::NoBandwidth { highest: search.highest });
        }
        asked = (asked * 2.0_f64.powf(0.25)).min(search.highest);
        let next = answer(asked)?;
        if !(next.gain > HALF_POWER) {
            break next;
        }
        below = next;
    };
    while above.frequency > below.frequency * (1.0 + search.accuracy) {
        let middle = answer((below.frequency * above.frequency).sqrt())?;
        if middle.frequency <= below.frequency || middle.frequency >= above.frequency {
            // Periods are whole numbers of samples: there is none in between.
            break;
        }
        *(if middle.gain > HALF_POWER { &mut below } else { &mut above }) = middle;
    }
    Ok(crossing(&below, &above))
}

/// Where the straight line through two answers, power over frequency, crosses half the power.
fn crossing(below: &FrequencyResponse, above: &FrequencyResponse) -> f64 {
    let [high, low] = [below, above].map(|answer| answer.gain * answer.gain);
    below.frequency + (above.frequency - below.frequency) * (high - 0.5) / (high - low)
}
