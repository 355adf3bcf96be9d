use libm::{exp, log, log1p};

/// Travel time of the synchronised form beside the optimum `T*` of the path under its speed limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeBracket {
    /// `T >= lower T*`.
    pub lower: f64,
    /// `T <= upper T* + (approach_samples + 1) Ts`.
    pub upper: f64,
    /// Samples after which the filter has certainly risen.
    pub approach_samples: f64,
}

/// Bracket of the travel time in terms of the optimum (claim `time-bracket`), or `None` where its hypotheses fail.
///
/// ```text
/// r = (1 - a) exp(-d)
/// (1 - d / 2) T*  <=  T  <=  T* / (r (1 - d / 2)) + (K + 1) Ts,     (1 - f0)(1 - a)^K <= 1 - r / g_min
/// ```
///
/// Hypotheses: zero tracking error, [`super::super::Advance::Synchronised`], `g >= g_min >= 1`, `0 < a < 1`, `0 <= d < 2` and
/// `r (1 - r) <= a g_min`, where `drift` is `d = L Ts λ̇*max` with `L = sup |d ln g / dλ|`. NaN gives `None`.
#[must_use]
pub fn time_bracket(filter_step: f64, overspeed_min: f64, drift: f64, initial_factor: f64) -> Option<TimeBracket> {
    let lowest_ratio = (1.0 - filter_step) * exp(-drift);
    let in_range = 0.0 < filter_step && filter_step < 1.0 && overspeed_min >= 1.0 && (0.0..2.0).contains(&drift);
    let recovers = lowest_ratio * (1.0 - lowest_ratio) <= filter_step * overspeed_min * (1.0 - 1e-15);
    if !(in_range && recovers && (0.0..=1.0).contains(&initial_factor)) {
        return None;
    }
    let curve = 1.0 - 0.5 * drift;
    // Samples until (1 - f0)(1 - a)^K <= 1 - r / g_min; one more for rounding.
    let left = (1.0 - lowest_ratio / overspeed_min) / (1.0 - initial_factor);
    let approach_samples = if left >= 1.0 { 0.0 } else { libm::ceil(log(left) / log1p(-filter_step)) + 1.0 };
    Some(TimeBracket { lower: curve, upper: 1.0 / (lowest_ratio * curve), approach_samples })
}
