use crate::profile::{Cubics, TrapezoidEnds, trapezoid};
use crate::{AxisLimits, AxisState, Range};

/// The pace at which path time runs: `ṡ = r`, `r` in [0, 1].
///
/// A change of pace is a law planned to its end: `r` goes from its present value and slope to the target with a bounded slope
/// and a bounded second derivative, so position, velocity and acceleration along the path stay continuous.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rate {
    /// Path time under the law, its derivatives being the pace and its slope; begins at 0.
    law: Cubics,
    /// Time since the law began, s.
    clock: f64,
    /// The pace at the end of the law, and for ever after.
    settled: f64,
    /// The pace wanted; differs from `settled` while no law that keeps the limits has been found.
    pub(super) wanted: f64,
}

/// Ranges of path time, pace and the pace's derivatives over a span of a law.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pace {
    /// Path time covered since now, s.
    pub(super) path_time: Range,
    /// Pace.
    pub(super) rate: Range,
    /// Its slope, 1/s.
    pub(super) slope: Range,
    /// Its second derivative, 1/s².
    pub(super) curvature: Range,
}

/// Gentler and gentler ramps, as shares of the largest slope and curvature that rest-to-full speed would allow.
const GENTLENESS: [f64; 8] = [4.0, 2.0, 1.0, 0.5, 0.25, 0.125, 0.0625, 0.03125];

/// Spans into which a law is cut for its check. Bounds get tighter with more of them; eight are enough at a steady speed.
const SPANS: u32 = 24;

impl Rate {
    /// A constant pace.
    pub(super) fn constant(rate: f64) -> Self {
        let start = AxisState { position: 0.0, velocity: rate, acceleration: 0.0 };
        Self { law: Cubics::from(start), clock: 0.0, settled: rate, wanted: rate }
    }

    /// Pace and slope now.
    pub(super) fn now(&self) -> AxisState {
        if self.is_settled() {
            return AxisState { position: 0.0, velocity: self.settled, acceleration: 0.0 };
        }
        self.law.at(self.clock)
    }

    /// True if the pace is constant from now on, under the law in force.
    pub(super) fn is_settled(&self) -> bool {
        self.clock >= self.law.duration()
    }

    /// True if a new law has to be found.
    pub(super) fn is_pending(&self) -> bool {
        self.wanted != self.settled
    }

    /// Advances by `dt` seconds and returns the path time that passes.
    pub(super) fn advance(&mut self, dt: f64) -> f64 {
        let duration = self.law.duration();
        let (from, to) = (self.clock.min(duration), (self.clock + dt).min(duration));
        let under_law = if from < to { self.law.at(to).position - self.law.at(from).position } else { 0.0 };
        let settled_for = dt - (to - from);
        self.clock += dt;
        (under_law + settled_for * self.settled).max(0.0)
    }

    /// Tries laws from brisk to gentle and takes the first that `keeps` all limits; without one the pace stays as it is.
    ///
    /// `largest` holds slope and curvature that are safe at rest.
    pub(super) fn replan(&mut self, largest: (f64, f64), mut keeps: impl FnMut(&Self) -> bool) {
        let now = self.now();
        for share in GENTLENESS {
            let slope = (share * largest.0).max(now.acceleration.abs());
            let Ok(limits) = AxisLimits::new(slope, share * largest.1, 1.0) else { return };
            let ends = TrapezoidEnds {
                start: now.velocity,
                start_velocity: now.acceleration,
                goal: self.wanted,
                goal_velocity: 0.0,
            };
            let start = AxisState { position: 0.0, ..now };
            let law = trapezoid(&ends, &limits)
                .phases()
                .iter()
                .fold(Cubics::from(start), |law, phase| law.then(phase.duration, phase.start.acceleration));
            let candidate = Self { law, clock: 0.0, settled: self.wanted, wanted: self.wanted };
            let rates = law.bounds(0.0, law.duration()).velocity;
            // Rounding of a pace of 0 or 1; backwards or faster than planned is never allowed.
            if rates.lower >= -1e-12 && rates.upper <= 1.0 + 1e-12 && keeps(&candidate) {
                *self = candidate;
                return;
            }
        }
    }

    /// The rest of the law, cut into spans. Afterwards the pace is constant and at most 1, which keeps every limit that the
    /// motion itself keeps.
    pub(super) fn spans(&self) -> impl Iterator<Item = Pace> + '_ {
        let left = (self.law.duration() - self.clock).max(0.0);
        let origin = self.law.at(self.clock).position;
        let count = if left > 0.0 { SPANS } else { 0 };
        (0..count).map(move |k| {
            let edge = |k: u32| self.clock + left * f64::from(k) / f64::from(SPANS);
            let bounds = self.law.bounds(edge(k), edge(k + 1));
            let since_now = Range { lower: bounds.position.lower - origin, upper: bounds.position.upper - origin };
            Pace { path_time: since_now, rate: bounds.velocity, slope: bounds.acceleration, curvature: bounds.jerk }
        })
    }
}
