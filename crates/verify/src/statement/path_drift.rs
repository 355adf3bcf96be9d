//! Rate at which the limit drifts along a path, beside the rate at which the filter falls.

use slideway_path::SampledPath;

/// `ln slowness` over the path parameter, from a sampled path; `slowness = 1 / λ̇*`.
#[derive(Clone, Debug)]
pub(crate) struct PathDrift {
    lambda: Vec<f64>,
    log: Vec<f64>,
    /// True if the joints turn somewhere while the tool stands: no finite drift describes that.
    breaks: bool,
}

/// Demands of a path on the filter at a pace.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Asked {
    /// `sup d ln b / dt`, 1/s: the rate at which the filter has to fall.
    pub(crate) fall_rate: f64,
    /// `S`: the most that the drift gains on the filter over any stretch.
    pub(crate) surplus: f64,
}

impl PathDrift {
    pub(crate) fn new(path: &SampledPath) -> Self {
        let samples = path.pieces.iter().flat_map(|piece| piece.in_order());
        let (lambda, log) = samples.map(|s| (s.lambda, path.slowness(s).ln())).unzip();
        Self { lambda, log, breaks: path.pieces.iter().any(|piece| piece.is_self_motion) }
    }

    /// Every second sample of it.
    pub(crate) fn halved(&self) -> Self {
        let half = |values: &[f64]| values.iter().copied().step_by(2).collect();
        Self { lambda: half(&self.lambda), log: half(&self.log), breaks: self.breaks }
    }

    /// Number of samples it is known at.
    pub(crate) fn samples(&self) -> usize {
        self.lambda.len()
    }

    /// True if a stretch of the path cannot be followed at any pace.
    pub(crate) fn breaks(&self) -> bool {
        self.breaks
    }

    /// Largest and smallest slowness, s.
    pub(crate) fn slowness_range(&self) -> (f64, f64) {
        let fold = |f: fn(f64, f64) -> f64, start| self.log.iter().copied().fold(start, f).exp();
        (fold(f64::min, f64::INFINITY), fold(f64::max, f64::NEG_INFINITY))
    }

    /// `ln slowness` between samples, linear; the ends outside.
    pub(crate) fn at(&self, lambda: f64) -> f64 {
        let after = self.lambda.partition_point(|&x| x <= lambda);
        match (after.checked_sub(1), self.lambda.get(after)) {
            (None, _) => self.log.first().copied().unwrap_or(f64::NAN),
            (Some(last), None) => self.log[last],
            (Some(before), Some(&next)) => {
                let share = (lambda - self.lambda[before]) / (next - self.lambda[before]);
                self.log[before] + share * (self.log[after] - self.log[before])
            }
        }
    }

    /// `∫ |d ln slowness|`: the total variation over the samples.
    pub(crate) fn variation(&self) -> f64 {
        self.log.windows(2).map(|w| (w[1] - w[0]).abs()).sum()
    }

    /// Demands of the path at the rate `pace λ̇*` on a filter that falls by `fall_rate` (1/s).
    ///
    /// Between two samples the reference needs at least `Δλ · slowness / pace`; the smaller slowness of the two counts. The surplus is
    /// the largest sum over neighbouring intervals of drift less fall, by one pass (Kadane).
    pub(crate) fn asked(&self, pace: f64, fall_rate: f64, period: f64) -> Asked {
        if self.breaks {
            return Asked { fall_rate: f64::INFINITY, surplus: f64::INFINITY };
        }
        let (mut steepest, mut run, mut surplus) = (0.0_f64, 0.0_f64, 0.0_f64);
        for (at, log) in self.lambda.windows(2).zip(self.log.windows(2)) {
            let (rise, time) = (log[1] - log[0], (at[1] - at[0]) * log[0].min(log[1]).exp() / pace);
            // A corner takes no time; the regulator meets it within one sample.
            steepest = steepest.max(rise / if at[1] > at[0] { time } else { period });
            run = (run + rise - fall_rate * time).max(0.0);
            surplus = surplus.max(run);
        }
        Asked { fall_rate: steepest, surplus }
    }

    /// Bound on the change of `ln slowness` within one sampling period at the rate `pace λ̇*`: the steepest interval's rate for the whole
    /// period, corners in addition, and never more than the path's whole variation.
    pub(crate) fn sample_drift(&self, pace: f64, period: f64) -> f64 {
        let (mut steepest, mut corners) = (0.0_f64, 0.0);
        for (at, log) in self.lambda.windows(2).zip(self.log.windows(2)) {
            let (change, time) = ((log[1] - log[0]).abs(), (at[1] - at[0]) * log[0].min(log[1]).exp() / pace);
            if at[1] > at[0] { steepest = steepest.max(change / time) } else { corners += change }
        }
        (steepest * period + corners).min(self.variation())
    }
}
