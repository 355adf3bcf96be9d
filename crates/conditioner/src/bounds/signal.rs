use libm::{exp, fabs, log, log1p};

use crate::implicit::AffineSpeed;
use crate::limits::SpeedLimits;

/// Suprema of what the explicit regulator saw, or of what it may see: all that its band depends on (claim `signal-band`).
///
/// `q̇d = A + f B` is the demand as the regulator sees it at sample `k`, whatever noise, delay or wrong model made it. Lengths are in
/// limits: `ρ(v)` is the largest use of a limit, `|v|` the same by each joint's smaller limit. `b = ρ(B)`, `z = f b`, `D = ln(b' / b)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Signals {
    /// `E = sup |A|`.
    pub feedback: f64,
    /// `g = sup |B|`, at least `sup b`.
    pub overspeed: f64,
    /// `sup D⁺` over released samples (`u = 1`).
    pub rise: f64,
    /// `S`: the largest sum of `D + ln(1 - a)` over the first samples of a run of braked ones; 0 where the filter always falls faster.
    pub surplus: f64,
    /// `sup c` over released samples, `c = |A' - (1 - a) A| + (1 - a) f |B' - B| + (1 - a)(κ - 1)⁺ m`, with `κ` the largest share to
    /// which a limit shrank meanwhile.
    pub released_change: f64,
    /// `sup c` over braked samples.
    pub braked_change: f64,
    /// `X = sup |A' - A| + f |B' - B|`.
    pub demand_change: f64,
    /// `z` and `m` at the first sample, whichever is more; 0 from rest.
    pub start: f64,
}

impl Signals {
    /// Of a loop that was not looked at yet.
    pub const NONE: Self = Self {
        feedback: 0.0,
        overspeed: 0.0,
        rise: 0.0,
        surplus: 0.0,
        released_change: 0.0,
        braked_change: 0.0,
        demand_change: 0.0,
        start: 0.0,
    };

    /// True if every supremum is at most the other's; false with NaN.
    #[must_use]
    pub fn within(&self, other: &Self) -> bool {
        self.as_array().iter().zip(&other.as_array()).all(|(a, b)| a <= b)
    }

    fn as_array(&self) -> [f64; 8] {
        let Self { feedback, overspeed, rise, surplus, released_change, braked_change, demand_change, start } = *self;
        [feedback, overspeed, rise, surplus, released_change, braked_change, demand_change, start]
    }

    /// `Z e^S`, which `z = f b` never exceeds: `Z = max((1 - a)(1 + E) e^sup(D⁺) + a g, start)`.
    #[must_use]
    pub fn feedforward_band(&self, filter_step: f64) -> f64 {
        let risen = (1.0 - filter_step) * (1.0 + self.feedback) * exp(self.rise) + filter_step * self.overspeed;
        // Some ten roundings a sample, of which the sums of D keep all; a part in 1e12 covers runs of a thousand braked samples.
        let band = larger(risen, self.start) * exp(self.surplus) * (1.0 + 1e-12);
        if band.is_nan() { f64::INFINITY } else { band }
    }

    /// Largest `m = ρ(q̇d)` from the first released sample on (claim `signal-band`): the smaller of
    ///
    /// ```text
    /// E + Z e^S                                                by length
    /// max(1 - a + sup c + a g (released), sup c / a (braked), start)     by vector
    /// ```
    ///
    /// and never less than 1. Hypotheses: none but that the suprema are those of the loop, and that up to the first released sample
    /// the factor was 0 or fell. The first form does not mind the direction of `B`, the second not the size of `A`. A last step that is
    /// cut short, `q̇d = A + s f B` with `s < 1`, lies between `A` and the whole one. Infinite for NaN.
    #[must_use]
    pub fn band(&self, filter_step: f64) -> f64 {
        let by_length = self.feedback + self.feedforward_band(filter_step);
        let released = 1.0 - filter_step + self.released_change + filter_step * self.overspeed;
        let braked = larger(self.braked_change / filter_step, self.start);
        let by_vector = larger(released, braked) * (1.0 + 1e-12);
        larger(if by_vector < by_length { by_vector } else { by_length }, 1.0)
    }

    /// Largest change `|q̇d' - q̇d|` of the demand over one sample, in limits: `a g + X` (claim `chattering-band`, whose `|u - f|` is at
    /// most 1).
    #[must_use]
    pub fn chattering(&self, filter_step: f64) -> f64 {
        (filter_step * self.overspeed + self.demand_change) * (1.0 + 1e-12)
    }
}

/// The larger of two numbers; infinite if one is NaN, so that it never passes for a small one.
pub(super) fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::INFINITY } else { a.max(b) }
}

/// Collects [`Signals`] sample by sample. Sixty-four bits a number and no allocation: it can run beside the regulator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SignalBand<const N: usize> {
    filter_step: f64,
    signals: Signals,
    /// Sum of `D + ln(1 - a)` since the last released sample.
    run: f64,
    last: Option<Seen<N>>,
}

/// One sample as it was seen.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Seen<const N: usize> {
    limits: SpeedLimits<N>,
    demand: AffineSpeed<N>,
    factor: f64,
    released: bool,
    length: f64,
    ratio: f64,
}

impl<const N: usize> SignalBand<N> {
    /// For a regulator with the filter step `a = af Ts`.
    #[must_use]
    pub fn new(filter_step: f64) -> Self {
        Self { filter_step, signals: Signals::NONE, run: 0.0, last: None }
    }

    /// Takes a sample in: the limits, the demand as it was seen, the factor it was computed with and the switch decided.
    ///
    /// Samples before the first released one count for the start only.
    pub fn update(&mut self, limits: &SpeedLimits<N>, demand: &AffineSpeed<N>, factor: f64, switch: f64) {
        let released = switch >= 1.0;
        let (length, ratio) = (limits.ratio(&demand.feedforward), limits.ratio(&demand.at(factor)));
        let now = Seen { limits: *limits, demand: *demand, factor, released, length, ratio };
        match self.last {
            None if !released && factor == 0.0 => return,
            None if !released => self.signals.start = larger(factor * length, ratio),
            None => {}
            Some(before) => self.follow(&before, &now),
        }
        self.signals.feedback = larger(self.signals.feedback, narrow(limits, &demand.feedback));
        self.signals.overspeed = larger(self.signals.overspeed, narrow(limits, &demand.feedforward));
        self.last = Some(now);
    }

    /// The suprema over the samples so far.
    #[must_use]
    pub fn signals(&self) -> Signals {
        self.signals
    }

    /// The band that what was seen proves, see [`Signals::band`].
    #[must_use]
    pub fn band(&self) -> f64 {
        self.signals.band(self.filter_step)
    }

    /// From one sample to the next.
    fn follow(&mut self, before: &Seen<N>, now: &Seen<N>) {
        let signals = &mut self.signals;
        // A joint path at a cusp stands: from nothing to nothing nothing drifts.
        let drift = if before.length == now.length { 0.0 } else { log(now.length / before.length) };
        let moved = weighted(&now.demand.feedforward, 1.0, &before.demand.feedforward);
        let moved = before.factor * narrow(&now.limits, &moved);
        let kept = narrow(&now.limits, &weighted(&now.demand.feedback, 1.0, &before.demand.feedback));
        signals.demand_change = larger(signals.demand_change, kept + moved);
        let rest = 1.0 - self.filter_step;
        let unmatched = narrow(&now.limits, &weighted(&now.demand.feedback, rest, &before.demand.feedback));
        let changed = unmatched + rest * (moved + shrunk(&before.limits, &now.limits) * before.ratio);
        if before.released {
            self.run = 0.0;
            signals.rise = larger(signals.rise, drift);
            signals.released_change = larger(signals.released_change, changed);
        } else {
            self.run += drift + log1p(-self.filter_step);
            signals.surplus = larger(signals.surplus, self.run);
            signals.braked_change = larger(signals.braked_change, changed);
        }
    }
}

/// `v - share w`.
fn weighted<const N: usize>(v: &[f64; N], share: f64, w: &[f64; N]) -> [f64; N] {
    let mut difference = *v;
    for (d, w) in difference.iter_mut().zip(w) {
        *d -= share * w;
    }
    difference
}

/// `|v|`: the largest share of a joint's smaller limit. Infinite for NaN.
pub(super) fn narrow<const N: usize>(limits: &SpeedLimits<N>, v: &[f64; N]) -> f64 {
    let ends = limits.lower().iter().zip(limits.upper());
    v.iter().zip(ends).fold(0.0, |most, (v, (lo, up))| larger(most, fabs(*v) / up.min(-lo)))
}

/// `(κ - 1)⁺`, `κ` the largest ratio of a limit before to the same limit now.
fn shrunk<const N: usize>(before: &SpeedLimits<N>, now: &SpeedLimits<N>) -> f64 {
    let lower = before.lower().iter().zip(now.lower());
    let upper = before.upper().iter().zip(now.upper());
    lower.chain(upper).fold(0.0, |most, (before, now)| larger(most, before / now - 1.0))
}

/// Largest change `|q̇d' - q̇d|` of the implicit form's demand over one sample, in limits (claim `implicit-chattering`), infinite unless
/// `E < 1`.
///
/// ```text
/// max(a g + X,  X + κ X (1 + E) / (1 - E))
/// ```
///
/// A rising factor is the filter's; a falling one follows the joint at its limit, whose demand changes by `X` at the most. `asymmetry` is
/// `κ`, the largest ratio of one joint's two limits.
#[must_use]
pub fn implicit_chattering(signals: &Signals, filter_step: f64, asymmetry: f64) -> f64 {
    let (x, e) = (signals.demand_change, signals.feedback);
    if !(e < 1.0) {
        return f64::INFINITY;
    }
    larger(signals.chattering(filter_step), x * (1.0 + asymmetry * (1.0 + e) / (1.0 - e)) * (1.0 + 1e-12))
}
