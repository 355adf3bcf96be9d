use super::constraint::ConstraintSample;
use super::filters::{Discretisation, RateFilter};
use super::outcome::TrapPhase;
use super::settings::TrapSettings;
use super::state::TrapState;
use super::vector::scaled;
use super::walk_direction::orthogonal_direction;

/// Trap avoidance, `[G12] section 6`: stop rule, walk and return.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TrapAvoidance {
    pub(crate) settings: TrapSettings,
    walk_filter: RateFilter,
    pace_filter: RateFilter,
    direction_samples: u32,
    period: f64,
}

/// What the trap avoidance looks at.
pub(crate) struct Situation<'a, const N: usize, const M: usize> {
    /// Distance between conditioned reference and reference.
    pub(crate) distance: f64,
    /// `φ_i` plus margin at the reference.
    pub(crate) reference_excess: &'a [f64; M],
    /// The constraints at the conditioned reference.
    pub(crate) samples: &'a [ConstraintSample<N>; M],
    /// `φ_i` plus margin there.
    pub(crate) excess: &'a [f64; M],
    /// `ε3` of each constraint.
    pub(crate) threshold: &'a [f64; M],
}

/// The inputs of the two filters for the coming interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TrapInputs<const N: usize> {
    pub(crate) walk: [f64; N],
    pub(crate) pace: f64,
    pub(crate) phase: TrapPhase,
}

impl TrapAvoidance {
    pub(crate) fn new(settings: TrapSettings, period: f64, discretisation: Discretisation) -> Self {
        Self {
            walk_filter: RateFilter::new(settings.walk_cutoff, period, discretisation),
            pace_filter: RateFilter::new(settings.pace_cutoff, period, discretisation),
            // At least one sample; a period too long for the counter is as good as never.
            direction_samples: libm::round(settings.direction_period / period).clamp(1.0, 4e9) as u32,
            settings,
            period,
        }
    }

    pub(crate) fn pace_memory(&self) -> f64 {
        self.pace_filter.resting(1.0)
    }

    /// Decides `u_SP` and `u_2`. `bounded` shortens an input that asks for more push than there is.
    ///
    /// The stop rule is that of the text: both conditions. The printed program stops on activity alone, which deadlocks
    /// a reference that still has to leave the forbidden region by itself.
    #[inline]
    pub(crate) fn decide<const N: usize, const M: usize>(
        &self,
        state: &mut TrapState<N>,
        situation: &Situation<'_, N, M>,
        bounded: impl FnOnce([f64; N], &[bool; M]) -> [f64; N],
    ) -> TrapInputs<N> {
        self.turn(state);
        let active: [bool; M] = core::array::from_fn(|i| situation.excess[i] > -situation.threshold[i]);
        let lost = situation.distance > self.settings.distance_threshold;
        let clear = situation.reference_excess.iter().all(|&e| e < -self.settings.clearance_threshold);
        if !(lost && clear) {
            state.time = 0.0;
            return TrapInputs { walk: bounded(self.home(state), &active), pace: 1.0, phase: TrapPhase::Following };
        }
        state.time += self.period;
        if !active.contains(&true) {
            return TrapInputs { walk: bounded(self.home(state), &active), pace: 0.0, phase: TrapPhase::Returning };
        }
        match orthogonal_direction(situation.samples, &active, &state.direction) {
            Some(direction) => {
                let wanted = self.settings.walk_speed + self.settings.walk_growth * state.time;
                let walk = bounded(scaled(wanted, &direction), &active);
                TrapInputs { walk, pace: 0.0, phase: TrapPhase::Walking }
            }
            None => TrapInputs { walk: [0.0; N], pace: 0.0, phase: TrapPhase::Blocked },
        }
    }

    /// `u_2 = -Ke f_RW`: the position, as the poles of `[G12] eq 25` say.
    fn home<const N: usize>(&self, state: &TrapState<N>) -> [f64; N] {
        scaled(-self.settings.return_gain, &state.walk)
    }

    /// A new random vector every `T_F`.
    fn turn<const N: usize>(&self, state: &mut TrapState<N>) {
        if state.remaining == 0 {
            state.direction = state.random.vector();
            state.remaining = self.direction_samples;
        }
        state.remaining -= 1;
    }

    /// Advances walk and pace by one sample; returns the seconds the reference's clock gains.
    #[inline]
    pub(crate) fn advance<const N: usize>(
        &self,
        state: &mut TrapState<N>,
        inputs: &TrapInputs<N>,
        discretisation: Discretisation,
    ) -> f64 {
        for ((walk, speed), &u) in state.walk.iter_mut().zip(&mut state.speed).zip(&inputs.walk) {
            *walk += self.walk_filter.gained(*speed, u);
            *speed = self.walk_filter.next(*speed, u);
        }
        let (memory, u) = (state.pace_memory, inputs.pace);
        state.pace_memory = self.pace_filter.next(memory, u);
        match discretisation {
            Discretisation::ZeroOrderHold => {
                state.pace = state.pace_memory;
                self.pace_filter.gained(memory, u)
            }
            // The appendix holds the rate of the path over the sample.
            Discretisation::PrewarpedTustin => {
                let advance = self.period * state.pace;
                state.pace = self.pace_filter.rate(memory, u);
                advance
            }
        }
    }
}
