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

/// Inputs of the trap avoidance at one sample.
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
                // [G12] eq 27
                let wanted = self.settings.walk_speed + self.settings.walk_growth * state.time;
                let walk = bounded(scaled(wanted, &direction), &active);
                TrapInputs { walk, pace: 0.0, phase: TrapPhase::Walking }
            }
            None => TrapInputs { walk: [0.0; N], pace: 0.0, phase: TrapPhase::Blocked },
        }
    }

    /// `u_2 = -Ke f_RW`: the position, as the poles of `[G12] eq 25` say.
    fn home<const N: usize>(&self, state: &TrapState<N>) -> [f64; N] {
        // [G12] eq 24
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

#[cfg(test)]
mod tests {
    use super::super::filters::PushState;
    use super::super::settings::Walk;
    use super::super::state::PathState;
    use super::*;

    const PERIOD: f64 = 1e-3;
    const SETTINGS: TrapSettings = TrapSettings {
        walk_cutoff: 20.0,
        pace_cutoff: 10.0,
        walk: Walk::Paper,
        walk_speed: 2.0,
        walk_growth: 3.0,
        return_gain: 5.0,
        direction_period: 0.1,
        distance_threshold: 0.05,
        clearance_threshold: 0.03,
        activity_threshold: 0.01,
        seed: 1,
    };

    /// A wall along the second axis.
    const WALL: ConstraintSample<2> = ConstraintSample {
        value: 0.0,
        gradient: [2.0, 0.0],
        time_rate: 0.0,
        gradient_rate: [0.0; 2],
        time_rate_rate: 0.0,
    };

    fn zero_order_hold() -> TrapAvoidance {
        TrapAvoidance::new(SETTINGS, PERIOD, Discretisation::ZeroOrderHold)
    }

    fn start(trap: &TrapAvoidance) -> TrapState<2> {
        let push = PushState { first: [0.0; 2], second: [0.0; 2] };
        PathState::<2, 1>::new(push, trap.pace_memory(), trap.settings.seed).trap
    }

    /// Decides at this distance from the reference, with this `φ` there and this one here.
    fn decide(trap: &TrapAvoidance, state: &mut TrapState<2>, distance: f64, there: f64, here: f64) -> TrapInputs<2> {
        let situation = Situation {
            distance,
            reference_excess: &[there],
            samples: &[WALL],
            excess: &[here],
            threshold: &[SETTINGS.activity_threshold],
        };
        trap.decide(state, &situation, |wanted, _| wanted)
    }

    #[test]
    fn the_reference_waits_only_where_it_is_lost_and_clearly_inside() {
        let trap = zero_order_hold();
        // Farther than ε1 = 0.05 and below -ε2 = -0.03: strictly, as the settings say.
        for (distance, there, pace) in [
            (0.06, -0.04, 0.0),
            (0.05, -0.04, 1.0),
            (0.04, -0.04, 1.0),
            (0.06, -0.03, 1.0),
            (0.06, 0.0, 1.0),
            (0.06, 0.04, 1.0),
            (0.04, 0.04, 1.0),
            (0.06, f64::NAN, 1.0),
        ] {
            let inputs = decide(&trap, &mut start(&trap), distance, there, 0.0);
            assert_eq!(inputs.pace, pace, "at {distance} with φ = {there} at the reference");
            assert_eq!(inputs.phase == TrapPhase::Following, pace == 1.0);
        }
    }

    #[test]
    fn the_walk_goes_along_the_wall_and_faster_the_longer_it_takes() {
        let trap = zero_order_hold();
        let mut state = start(&trap);
        for trial in 0..2 {
            for k in 1..=50_u32 {
                let inputs = decide(&trap, &mut state, 0.06, -0.04, 0.0);
                assert_eq!((inputs.phase, inputs.walk[0]), (TrapPhase::Walking, 0.0), "in trial {trial}");
                // Kc + Kv t, with a rounding for every sample of the clock.
                let speed = 2.0 + 3.0 * 1e-3 * f64::from(k);
                assert!((inputs.walk[1].abs() - speed).abs() < 1e-14, "{:?} after {k} samples", inputs.walk);
            }
            // Found again: the clock starts from 0 at the next trap.
            assert_eq!(decide(&trap, &mut state, 0.01, -0.04, 0.0).phase, TrapPhase::Following);
        }
    }

    #[test]
    fn away_from_every_boundary_the_walk_turns_home() {
        let trap = zero_order_hold();
        let mut state = TrapState { walk: [0.2, -0.4], ..start(&trap) };
        // Active is what lies above -ε3 = -0.01: strictly.
        for (here, phase) in [
            (0.005, TrapPhase::Walking),
            (-0.009, TrapPhase::Walking),
            (-0.01, TrapPhase::Returning),
            (-0.02, TrapPhase::Returning),
        ] {
            assert_eq!(decide(&trap, &mut state, 0.06, -0.04, here).phase, phase, "at φ = {here}");
        }
        // -Ke f_RW, whether the reference waits or moves on.
        assert_eq!(decide(&trap, &mut state, 0.06, -0.04, -0.02).walk, [-1.0, 2.0]);
        assert_eq!(decide(&trap, &mut state, 0.0, -0.04, 0.0).walk, [-1.0, 2.0]);
    }

    #[test]
    fn the_random_direction_lasts_its_period_and_no_longer() {
        let trap = zero_order_hold();
        let mut state = start(&trap);
        let mut before = state.direction;
        for k in 0..1000 {
            decide(&trap, &mut state, 0.06, -0.04, 0.0);
            // 0.1 s are 100 samples; the first one draws as well.
            assert_eq!(state.direction != before, k % 100 == 0, "at sample {k}");
            before = state.direction;
        }
    }

    #[test]
    fn walk_and_clock_follow_the_closed_form_of_their_filters() {
        let trap = zero_order_hold();
        let mut state = start(&trap);
        let inputs = TrapInputs { walk: [0.5, -2.0], pace: 0.0, phase: TrapPhase::Walking };
        let mut clock = 0.0;
        for k in 1..=200_u32 {
            clock += trap.advance(&mut state, &inputs, Discretisation::ZeroOrderHold);
            let t = f64::from(k) * PERIOD;
            // Both filters of first order: 1 - exp(-α t), and its integral. Some 200 roundings of numbers around 1.
            let risen = 1.0 - libm::exp(-20.0 * t);
            for (i, u) in inputs.walk.iter().enumerate() {
                assert!((state.speed[i] - u * risen).abs() < 1e-13);
                assert!((state.walk[i] - u * (t - risen / 20.0)).abs() < 1e-13);
            }
            // The reference runs out from full pace.
            let left = libm::exp(-10.0 * t);
            assert!((state.pace - left).abs() < 1e-13 && (clock - (1.0 - left) / 10.0).abs() < 1e-13);
        }
    }

    #[test]
    fn the_appendix_holds_the_pace_over_the_sample() {
        let trap = TrapAvoidance::new(SETTINGS, PERIOD, Discretisation::PrewarpedTustin);
        let mut state = start(&trap);
        let mut follow = TrapInputs { walk: [0.0; 2], pace: 1.0, phase: TrapPhase::Following };
        for _ in 0..100 {
            // Full pace stays full pace: the filter starts as one that has always seen a 1.
            assert!((trap.advance(&mut state, &follow, Discretisation::PrewarpedTustin) - PERIOD).abs() < 1e-16);
            assert!((state.pace - 1.0).abs() < 1e-14);
        }
        follow.pace = 0.0;
        // Tustin's rule at an input that falls from 1 to 0: c / (1 + c) is lost at once, then (1 - c) / (1 + c) is left.
        let c = libm::tan(0.5 * 10.0 * PERIOD);
        let mut pace = 1.0;
        for k in 0..100 {
            let gained = trap.advance(&mut state, &follow, Discretisation::PrewarpedTustin);
            assert!((gained - PERIOD * pace).abs() < 1e-16, "{gained} at sample {k}");
            pace = if k == 0 { 1.0 / (1.0 + c) } else { pace * (1.0 - c) / (1.0 + c) };
            assert!((state.pace - pace).abs() < 1e-13, "{} instead of {pace} at sample {k}", state.pace);
        }
    }
}
