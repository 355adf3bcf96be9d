use super::constraint::{ConstraintSample, Motion};
use super::evaluated::Evaluated;
use super::filters::{Discretisation, PushFilter};
use super::law::Push;
use super::outcome::{HoldReason, PathOutcome, PathStep, TrapPhase};
use super::settings::{PathForm, PathSettings};
use super::state::{PathState, Phase};
use super::trap::{TrapAvoidance, TrapInputs};
use super::vector::{add_scaled, difference, finite, scaled};
use crate::error::ParameterError;

/// Sliding-mode path conditioning with trap avoidance, `[G12]`, for `N` coordinates and `M` constraints.
///
/// ```text
/// p*   = p_ref + f_SM + f_RW                               eq 4
/// φ_i  = σ_i(p*, t) + K_i σ̇_i <= 0                         eq 3, 5.4
/// f̈_SM = -√2 α1 ḟ_SM - α1² f_SM + α1² u_1                  eq 5
/// u_1  = 0 if every φ_i < 0, else the switching law        eq 13, 17, 20
/// ```
///
/// One sample, at time `t_k`: the position `p*` at `t_k` is formed (the appendix's scheme: was formed one sample ago),
/// the constraints are evaluated there by the caller's closure, the push and the walk for the interval up to `t_{k+1}`
/// are chosen and the filters are advanced.
///
/// The implicit form and the reserve choose the push over the past interval instead, with the result in sight: the
/// smallest `u` such that every `φ_i(t_k) <= 0` (or `<=` the band). They evaluate the constraints a few times a sample.
///
/// Guaranteed, with `G_i` the full push of a sample and `D_i` the drift of `φ_i` over it:
/// - explicit, zero-order hold: `φ_i <= max D_i`, and `σ_i <= max φ_i` over time (claims `path-band`, `path-lag`);
/// - with the reserve: `φ_i <= G_i` at every sample, whatever the drift, and `<= 0` with [`super::Margin::Band`] (claim
///   `path-reserve`);
/// - implicit: `φ_i <= 0` at every sample, to rounding (claim `path-implicit`); between samples `φ_i` can rise by at
///   most `T² sup |φ̈_i| / 8`, and so can `σ_i`;
/// - a sample that cannot be served (NaN, no direction to push, contradiction) is answered with the last position, at
///   rest, which keeps every constraint that stands still.
///
/// Not guaranteed: anything about acceleration; in the appendix's scheme the smaller band; escape from every trap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathConditioner<const N: usize, const M: usize> {
    pub(super) settings: PathSettings<M>,
    pub(super) filter: PushFilter,
    pub(super) discretisation: Discretisation,
    pub(super) trap: Option<TrapAvoidance>,
}

/// The pushes one sample decides on.
struct Pushes<const N: usize, const M: usize> {
    past: Push<N, M>,
    coming: Push<N, M>,
}

impl<const N: usize, const M: usize> PathConditioner<N, M> {
    /// Validates the settings once.
    ///
    /// # Errors
    ///
    /// [`ParameterError::SamplingPeriod`], [`ParameterError::Path`] with the quantity that is out of range, or
    /// [`ParameterError::SafeWalkWithoutReserve`].
    pub fn new(settings: PathSettings<M>) -> Result<Self, ParameterError> {
        settings.validate()?;
        let discretisation = match settings.form {
            PathForm::Appendix { .. } => Discretisation::PrewarpedTustin,
            PathForm::Sliding { .. } | PathForm::Implicit { .. } => Discretisation::ZeroOrderHold,
        };
        Ok(Self {
            filter: PushFilter::new(settings.push_cutoff, settings.sampling_period, discretisation),
            trap: settings.trap.map(|trap| TrapAvoidance::new(trap, settings.sampling_period, discretisation)),
            settings,
            discretisation,
        })
    }

    /// The state before the first sample, which will start on the reference and with its velocity.
    #[must_use]
    pub fn on_reference(&self) -> PathState<N, M> {
        let pace = self.trap.as_ref().map_or(0.0, TrapAvoidance::pace_memory);
        let seed = self.trap.as_ref().map_or(0, |trap| trap.settings.seed);
        PathState::new(self.filter.resting(&[0.0; N]), pace, seed)
    }

    /// The state before a first sample that starts at rest at `position`, wherever the reference is.
    ///
    /// # Errors
    ///
    /// A coordinate is not finite.
    pub fn at_rest(&self, position: &[f64; N]) -> Result<PathState<N, M>, ParameterError> {
        self.on_reference().held_at(position)
    }

    /// One sample. `constraints` evaluates every constraint at a motion, at the time the motion carries.
    #[inline(always)]
    pub fn step<E>(&self, state: &mut PathState<N, M>, reference: &Motion<N>, constraints: E) -> PathStep<N, M>
    where
        E: Fn(&Motion<N>) -> [ConstraintSample<N>; M],
    {
        if !reference.is_finite() {
            return self.hold(state, reference, &constraints, HoldReason::ReferenceNotFinite);
        }
        self.resume(state, reference);
        let mut now = self.evaluate(self.motion(state, reference), &constraints);
        let pushes = match self.pushes(state, &mut now, &constraints) {
            Ok(pushes) => pushes,
            Err(reason) => return self.hold(state, reference, &constraints, reason),
        };
        let walk = state.trap.walk;
        let inputs = self.trap_inputs(state, reference, &now, &constraints);
        let advance = self.advance(state, reference, &now, &pushes.coming.vector, &inputs);
        let (outcome, push, reserve) = self.account(&pushes);
        PathStep {
            motion: now.motion,
            outcome,
            sigma: now.sigma(),
            phi: now.phi,
            share: push.share,
            push: push.vector,
            reserve,
            correction: difference(&difference(&now.motion.position, &reference.position), &walk),
            walk,
            trap: inputs.phase,
            pace: state.trap.pace,
            advance,
        }
    }

    /// The push over the past interval, which the motion already contains on return, and that of the coming one.
    #[inline(always)]
    fn pushes<E>(
        &self,
        state: &mut PathState<N, M>,
        now: &mut Evaluated<N, M>,
        constraints: &E,
    ) -> Result<Pushes<N, M>, HoldReason>
    where
        E: Fn(&Motion<N>) -> [ConstraintSample<N>; M],
    {
        self.check(now)?;
        let past = self.correct(state, now, constraints)?;
        Ok(Pushes { past, coming: self.push(now)? })
    }

    /// The audit: what acted, and which push answers for this sample.
    fn account(&self, Pushes { past, coming }: &Pushes<N, M>) -> (PathOutcome, Push<N, M>, [f64; N]) {
        let acts = |push: &Push<N, M>| push.share.iter().any(|&s| s > 0.0);
        let acting = if acts(coming) || acts(past) { PathOutcome::Acting } else { PathOutcome::Free };
        match self.settings.form {
            PathForm::Implicit { .. } => (acting, *past, [0.0; N]),
            PathForm::Sliding { .. } | PathForm::Appendix { .. } if acts(past) => {
                (PathOutcome::Reserve, *coming, past.vector)
            }
            PathForm::Sliding { .. } | PathForm::Appendix { .. } => (acting, *coming, [0.0; N]),
        }
    }

    /// After a held sample the filters are set so that the conditioned reference starts from rest where it stands.
    #[inline(always)]
    fn resume(&self, state: &mut PathState<N, M>, reference: &Motion<N>) {
        match state.phase {
            Phase::Running => {}
            Phase::Fresh => (state.last, state.next) = (*reference, *reference),
            Phase::Held => {
                let away = difference(&difference(&state.last.position, &reference.position), &state.trap.walk);
                state.push = self.filter.resting(&away);
                state.trap.speed = [0.0; N];
                if self.discretisation == Discretisation::ZeroOrderHold {
                    state.push.second = scaled(-1.0, &reference.velocity);
                }
                // At rest, as every held motion is.
                state.next = state.last;
            }
        }
        state.next.time = reference.time;
        state.phase = Phase::Running;
    }

    /// `p*` and `ṗ*` before any correction of this sample.
    #[inline(always)]
    fn motion(&self, state: &PathState<N, M>, reference: &Motion<N>) -> Motion<N> {
        match self.discretisation {
            Discretisation::PrewarpedTustin => state.next,
            Discretisation::ZeroOrderHold => {
                let (push, trap) = (&state.push, &state.trap);
                Motion {
                    time: reference.time,
                    // [G12] eq 4
                    position: add_scaled(&add_scaled(&reference.position, 1.0, &push.first), 1.0, &trap.walk),
                    velocity: add_scaled(&add_scaled(&reference.velocity, 1.0, &push.second), 1.0, &trap.speed),
                }
            }
        }
    }

    /// Explicit forms: the push for the coming interval.
    #[inline(always)]
    fn push(&self, now: &Evaluated<N, M>) -> Result<Push<N, M>, HoldReason> {
        match self.settings.form.law() {
            Some(law) => {
                // [G12] eq 13
                let active = now.excess.map(|e| e >= 0.0);
                law.push(self.settings.push_cutoff, &self.settings.approach, &now.samples, &active)
            }
            None => Ok(Push::NONE),
        }
    }

    /// Advances every filter to the next sample; returns what the reference's clock gains.
    #[inline(always)]
    fn advance(
        &self,
        state: &mut PathState<N, M>,
        reference: &Motion<N>,
        now: &Evaluated<N, M>,
        push: &[f64; N],
        inputs: &TrapInputs<N>,
    ) -> f64 {
        state.last = now.motion;
        if self.discretisation == Discretisation::PrewarpedTustin {
            let pushed = add_scaled(&reference.position, 1.0, &self.filter.output(&state.push, push));
            let position = add_scaled(&pushed, 1.0, &state.trap.walk);
            let change = difference(&position, &now.motion.position);
            let velocity = scaled(1.0 / self.settings.sampling_period, &change);
            state.next = Motion { time: reference.time, position, velocity };
        }
        self.filter.advance(&mut state.push, push);
        match &self.trap {
            Some(trap) => trap.advance(&mut state.trap, inputs, self.discretisation),
            None => {
                state.trap.pace = 1.0;
                self.settings.sampling_period
            }
        }
    }

    /// Gives out the last position again, at rest, and says why.
    #[cold]
    fn hold<E>(
        &self,
        state: &mut PathState<N, M>,
        reference: &Motion<N>,
        constraints: &E,
        reason: HoldReason,
    ) -> PathStep<N, M>
    where
        E: Fn(&Motion<N>) -> [ConstraintSample<N>; M],
    {
        let time = if reference.time.is_finite() { reference.time } else { state.last.time };
        let motion = Motion { time, position: state.last.position, velocity: [0.0; N] };
        state.hold(motion);
        let held = constraints(&motion);
        let away = difference(&difference(&motion.position, &reference.position), &state.trap.walk);
        PathStep {
            motion,
            outcome: PathOutcome::Held(reason),
            sigma: held.map(|s| s.value),
            phi: self.phi(&held, &motion.velocity),
            share: [0.0; M],
            push: [0.0; N],
            reserve: [0.0; N],
            correction: if finite(&away) { away } else { state.push.first },
            walk: state.trap.walk,
            trap: TrapPhase::Following,
            pace: 0.0,
            advance: 0.0,
        }
    }
}
