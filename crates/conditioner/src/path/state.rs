use super::constraint::Motion;
use super::filters::PushState;
use super::quantity::PathQuantity;
use super::random::Random;
use crate::error::ParameterError;

/// Where a run of samples stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Phase {
    /// No sample yet; the first one starts on the reference, with its velocity.
    Fresh,
    /// Samples follow one another.
    Running,
    /// The last sample was held: the next one starts from rest at the position given out.
    Held,
}

/// Memory of the trap avoidance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TrapState<const N: usize> {
    /// `f_RW`.
    pub(crate) walk: [f64; N],
    /// Memory of the walk filter: `ḟ_RW` under zero-order hold.
    pub(crate) speed: [f64; N],
    /// `f_SP`.
    pub(crate) pace: f64,
    /// Memory of the pace filter.
    pub(crate) pace_memory: f64,
    /// `t_trap`, s.
    pub(crate) time: f64,
    /// The random vector `F`.
    pub(crate) direction: [f64; N],
    /// Samples until the next `F`.
    pub(crate) remaining: u32,
    pub(crate) random: Random,
}

/// The whole state of a path conditioner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathState<const N: usize, const M: usize> {
    pub(crate) push: PushState<N>,
    pub(crate) trap: TrapState<N>,
    /// Height of each `φ_i` plus margin above its band at the last sample, for the recovery.
    pub(crate) beyond: [f64; M],
    /// The motion given out last.
    pub(crate) last: Motion<N>,
    /// The appendix's scheme: the motion to be given out next, which was decided a sample before.
    pub(crate) next: Motion<N>,
    pub(crate) phase: Phase,
}

impl<const N: usize, const M: usize> PathState<N, M> {
    /// `f_SP`: the factor by which the host multiplies the commanded path rate to get the velocity of the coming
    /// reference. 1 without trap avoidance.
    #[must_use]
    pub fn pace(&self) -> f64 {
        self.trap.pace
    }

    pub(crate) fn new(push: PushState<N>, pace_memory: f64, seed: u64) -> Self {
        let rest = Motion { time: 0.0, position: [0.0; N], velocity: [0.0; N] };
        let trap = TrapState {
            walk: [0.0; N],
            speed: [0.0; N],
            pace: 1.0,
            pace_memory,
            time: 0.0,
            direction: [0.0; N],
            remaining: 0,
            random: Random::new(seed),
        };
        Self { push, trap, beyond: [f64::INFINITY; M], last: rest, next: rest, phase: Phase::Fresh }
    }

    /// Stands still at `motion`; the next sample starts from there.
    pub(crate) fn hold(&mut self, motion: Motion<N>) {
        self.last = motion;
        self.phase = Phase::Held;
        self.beyond = [f64::INFINITY; M];
        self.trap.pace = 0.0;
        self.trap.pace_memory = 0.0;
    }

    pub(crate) fn held_at(mut self, position: &[f64; N]) -> Result<Self, ParameterError> {
        for (i, &value) in position.iter().enumerate() {
            if !value.is_finite() {
                return Err(ParameterError::Path { quantity: PathQuantity::Start(i), value });
            }
        }
        self.last.position = *position;
        self.phase = Phase::Held;
        Ok(self)
    }
}
