//! Motions of one axis, a family a file.

mod cosine;
mod cubics;
mod hermite;
mod jerk;
mod linear;
mod phase;
mod stop;
mod trapezoid;

pub use cosine::Cosine;
pub use cubics::Cubics;
pub use hermite::{Hermite, shortest_common};
pub use jerk::bounded_jerk;
pub use linear::{linear, shortest_linear};
pub use phase::Phase;
pub use stop::stop;
pub use trapezoid::{TrapezoidEnds, trapezoid};

use crate::{AxisState, Range};

/// Phases that a profile can have: seven of a jerk-limited motion, two before it and two after it.
pub const MAX_PHASES: usize = 11;

/// Bound on a change of speed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ramp {
    /// The acceleration alone, which may jump: continuity C¹.
    AccelerationLimited,
    /// Acceleration and jerk: continuity C².
    JerkLimited,
}

/// Ranges of position, velocity, acceleration and jerk over a span of a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Positions covered, rad or m.
    pub position: Range,
    /// Velocities, per s.
    pub velocity: Range,
    /// Accelerations, per s².
    pub acceleration: Range,
    /// Jerks, per s³; jumps of the acceleration are not counted.
    pub jerk: Range,
}

/// A motion of one axis.
#[derive(Clone, Copy, Debug, PartialEq)]
// Boxing the larger variant would allocate in the control loop.
#[allow(clippy::large_enum_variant)]
pub enum Profile {
    /// Stretches of constant jerk.
    Cubics(Cubics),
    /// Half a cosine.
    Cosine(Cosine),
}

impl Profile {
    /// Duration, s.
    #[must_use]
    pub fn duration(&self) -> f64 {
        match self {
            Self::Cubics(p) => p.duration(),
            Self::Cosine(p) => p.duration(),
        }
    }

    /// State at time `t`, s; that of the nearer end outside of the motion.
    #[must_use]
    pub fn at(&self, t: f64) -> AxisState {
        match self {
            Self::Cubics(p) => p.at(t),
            Self::Cosine(p) => p.at(t),
        }
    }

    /// State at the end.
    #[must_use]
    pub fn end(&self) -> AxisState {
        match self {
            Self::Cubics(p) => p.end(),
            Self::Cosine(p) => p.end(),
        }
    }

    /// The same path, `factor` times as slow (`factor >= 1` keeps every limit): velocity, acceleration and jerk fall by the
    /// first, second and third power.
    #[must_use]
    pub fn stretched(&self, factor: f64) -> Self {
        match self {
            Self::Cubics(p) => Self::Cubics(p.stretched(factor)),
            Self::Cosine(p) => Self::Cosine(p.stretched(factor)),
        }
    }

    /// Bounds that hold from `from` to `to`, s, exact but for rounding.
    #[must_use]
    pub fn bounds(&self, from: f64, to: f64) -> Bounds {
        match self {
            Self::Cubics(p) => p.bounds(from, to),
            Self::Cosine(p) => p.bounds(from, to),
        }
    }

    /// Bounds of the whole motion.
    #[must_use]
    pub fn peaks(&self) -> Bounds {
        self.bounds(0.0, self.duration())
    }
}
