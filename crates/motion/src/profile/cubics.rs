use super::phase::Phase;
use super::{Bounds, MAX_PHASES};
use crate::{AxisState, Range};

/// A motion of one axis made of stretches of constant jerk: position and velocity are continuous within a motion that bounds
/// acceleration, the acceleration as well within one that bounds jerk.
///
/// Every profile but the cosine is of this form, so each is sampled and bounded exactly by the same few lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cubics {
    start: AxisState,
    // An array rather than an `ArrayVec`: it has nothing to drop, so that a whole queue is cleared at once.
    slots: [Phase; MAX_PHASES],
    count: usize,
    duration: f64,
}

impl Cubics {
    /// A motion that has not begun.
    pub(crate) fn from(start: AxisState) -> Self {
        Self { start, slots: [Phase::default(); MAX_PHASES], count: 0, duration: 0.0 }
    }

    /// Adds a phase that goes on with the present acceleration. Phases without length are left out.
    pub(crate) fn then(self, duration: f64, jerk: f64) -> Self {
        let acceleration = self.end().acceleration;
        self.then_with(duration, acceleration, jerk)
    }

    /// Adds a phase that begins with an acceleration of its own.
    ///
    /// No profile of this crate has more than [`MAX_PHASES`] phases; one more would be left out.
    pub(crate) fn then_with(mut self, duration: f64, acceleration: f64, jerk: f64) -> Self {
        let start = AxisState { acceleration, ..self.end() };
        if duration > 0.0
            && let Some(slot) = self.slots.get_mut(self.count)
        {
            *slot = Phase { duration, start, jerk };
            self.count += 1;
            self.duration += duration;
        }
        self
    }

    /// The phases, none of them empty.
    #[must_use]
    pub fn phases(&self) -> &[Phase] {
        &self.slots[..self.count]
    }

    /// Duration, s.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.duration
    }

    /// State at the end.
    #[must_use]
    pub fn end(&self) -> AxisState {
        self.phases().last().map_or(self.start, Phase::end)
    }

    /// State at time `t`, that of the nearer end outside of the motion. Where the acceleration jumps, the value after it.
    #[must_use]
    pub fn at(&self, t: f64) -> AxisState {
        let mut t = t.max(0.0);
        for phase in self.phases() {
            if t < phase.duration {
                return phase.at(t);
            }
            t -= phase.duration;
        }
        self.end()
    }

    /// The same path, `factor` times as slow.
    #[must_use]
    pub fn stretched(&self, factor: f64) -> Self {
        let slower = |s: &AxisState| AxisState {
            position: s.position,
            velocity: s.velocity / factor,
            acceleration: s.acceleration / (factor * factor),
        };
        let slots = self.slots.map(|p| Phase {
            duration: p.duration * factor,
            start: slower(&p.start),
            jerk: p.jerk / (factor * factor * factor),
        });
        Self { start: slower(&self.start), slots, count: self.count, duration: self.duration * factor }
    }

    /// Bounds that hold from `from` to `to`, s: exact but for rounding. Both sides of a jump count.
    #[must_use]
    pub fn bounds(&self, from: f64, to: f64) -> Bounds {
        let mut bounds = Bounds::of(&self.at(from), 0.0).with(&self.at(to), 0.0);
        let mut begin = 0.0;
        for phase in self.phases() {
            let (t0, t1) = ((from - begin).max(0.0), (to - begin).min(phase.duration));
            if t0 <= t1 {
                bounds = bounds.with(&phase.at(t0), phase.jerk).with(&phase.at(t1), phase.jerk);
                for t in phase.standstills().into_iter().chain([phase.speed_peak()]).flatten() {
                    if t > t0 && t < t1 {
                        bounds = bounds.with(&phase.at(t), phase.jerk);
                    }
                }
            }
            begin += phase.duration;
        }
        bounds
    }
}

impl Bounds {
    /// Bounds of a single state.
    pub(crate) fn of(state: &AxisState, jerk: f64) -> Self {
        Self {
            position: Range::point(state.position),
            velocity: Range::point(state.velocity),
            acceleration: Range::point(state.acceleration),
            jerk: Range::point(jerk),
        }
    }

    /// Bounds that cover one more state.
    pub(crate) fn with(self, state: &AxisState, jerk: f64) -> Self {
        self.hull(Self::of(state, jerk))
    }

    /// Bounds that cover both.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        Self {
            position: self.position.hull(other.position),
            velocity: self.velocity.hull(other.velocity),
            acceleration: self.acceleration.hull(other.acceleration),
            jerk: self.jerk.hull(other.jerk),
        }
    }
}
