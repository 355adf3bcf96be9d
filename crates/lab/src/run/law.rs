use crate::method::Method;
use crate::problem::Problem;
use crate::run::acceleration::{AccelerationLaw, Sight};
use crate::run::controller::Demand;
use crate::run::decision::{Decision, Situation};
use slideway_conditioner::{
    Advance, AffineSpeed, ImplicitSpeedRegulator, Saturation, SpeedCommand, SpeedRegulator, SpeedSettings, SpeedState,
};
use slideway_path::EndRate;
use slideway_path::{Fault, ProblemError};

/// A speed law with its state, as the loop runs it.
#[derive(Clone, Debug)]
pub(crate) enum Law<const N: usize> {
    Fixed { rate: f64, saturation: Option<Saturation> },
    Explicit { regulator: SpeedRegulator<N>, state: SpeedState },
    Implicit { regulator: ImplicitSpeedRegulator<N>, state: SpeedState },
    Acceleration(Box<AccelerationLaw<N>>),
}

impl<const N: usize> Law<N> {
    pub(crate) fn new(problem: &Problem<N>, method: Method, fixed_rate: f64) -> Result<Self, ProblemError> {
        let settings = |advance| SpeedSettings {
            limits: problem.path.speed_limits,
            sampling_period: problem.control.sampling_period,
            bandwidth: problem.control.bandwidth,
            target_rate: problem.control.target_rate,
            saturation: Saturation::DirectionPreserving,
            advance,
        };
        let state = initial_state(problem)?;
        let explicit = |advance| {
            SpeedRegulator::new(settings(advance))
                .map(|regulator| Self::Explicit { regulator, state })
                .map_err(|error| ProblemError::value("control", error))
        };
        match method {
            Method::Ideal => Ok(Self::Fixed { rate: fixed_rate, saturation: None }),
            Method::Saturated => Ok(Self::Fixed { rate: fixed_rate, saturation: Some(Saturation::Direct) }),
            Method::DirectionPreserving => {
                Ok(Self::Fixed { rate: fixed_rate, saturation: Some(Saturation::DirectionPreserving) })
            }
            Method::ConstantSpeed | Method::NaturalMotion => Err(ProblemError::value(
                "natural",
                Fault::Missing("the method needs a `[natural]` table in the scenario"),
            )),
            Method::SlidingMode => explicit(Advance::Paper),
            Method::SlidingModeSynchronised => explicit(Advance::Synchronised),
            Method::SlidingModeImplicit => ImplicitSpeedRegulator::new(settings(Advance::Synchronised))
                .map(|regulator| Self::Implicit { regulator, state })
                .map_err(|error| ProblemError::value("control", error)),
            Method::AccelerationLimited => {
                AccelerationLaw::new(problem, Sight::Blind).map(|law| Self::Acceleration(Box::new(law)))
            }
            Method::AccelerationLookAhead => {
                AccelerationLaw::new(problem, Sight::Window).map(|law| Self::Acceleration(Box::new(law)))
            }
        }
    }

    /// One sample.
    pub(crate) fn step(&mut self, problem: &Problem<N>, demand: &Demand<N>, here: &Situation<N>) -> Decision<N> {
        match self {
            Self::Fixed { rate, saturation } => fixed(demand, *rate, *saturation, here),
            Self::Explicit { regulator, state } => explicit(&regulator.with_limits(here.limits), state, demand, here),
            Self::Implicit { regulator, state } => implicit(&regulator.with_limits(here.limits), state, demand, here),
            Self::Acceleration(law) => law.step(problem, demand, here),
        }
    }
}

/// The reference at rest, or as fast as the scenario says.
fn initial_state<const N: usize>(problem: &Problem<N>) -> Result<SpeedState, ProblemError> {
    let EndRate::Given(rate) = problem.path.start_rate else { return Ok(SpeedState::at_rest()) };
    let most = problem.control.target_rate;
    let too_fast = |_| ProblemError::value("limits.start_rate", Fault::AboveTarget { rate, target: most });
    SpeedState::moving(rate / most).map_err(too_fast)
}

/// The explicit forms. The filter knows the joints only: a path rate capped for the tool's sake stays capped while `f` rises.
fn explicit<const N: usize>(
    regulator: &SpeedRegulator<N>,
    state: &mut SpeedState,
    demand: &Demand<N>,
    here: &Situation<N>,
) -> Decision<N> {
    let requested = regulator.requested_rate(state);
    let capped = requested.min(here.tool_rate);
    let cut = capped.min(here.to_end);
    let desired = demand.at(cut).into();
    let mut command = regulator.step(state, &desired);
    // A shortened step is scaled as the whole one would be: by 1 or, in the synchronised form, by fdir.
    let share = if requested > 0.0 { command.path_rate / requested } else { 0.0 };
    command.path_rate = share * capped;
    let demand_factor = if cut < requested { command.factor * (cut / requested) } else { command.factor };
    Decision { command, desired, demand_factor, advance_rate: share * cut }
}

fn implicit<const N: usize>(
    regulator: &ImplicitSpeedRegulator<N>,
    state: &mut SpeedState,
    demand: &Demand<N>,
    here: &Situation<N>,
) -> Decision<N> {
    let split = AffineSpeed {
        feedback: demand.feedback.into(),
        feedforward: (demand.path_speed * regulator.target_rate()).into(),
    };
    let mut command = regulator.step(state, &split);
    let capped = command.path_rate.min(here.tool_rate);
    let advance_rate = capped.min(here.to_end);
    let (mut desired, mut demand_factor) = (split.at(command.factor), command.factor);
    if advance_rate < command.path_rate {
        demand_factor *= advance_rate / command.path_rate;
        // A shorter step along the same line: the limits are convex, so it keeps them too.
        desired = demand.at(advance_rate).into();
        command.joint_speed = here.limits.saturate(&desired, Saturation::DirectionPreserving).joint_speed;
    }
    command.path_rate = capped;
    Decision { command, desired, demand_factor, advance_rate }
}

/// Fixed speed: nothing is regulated, the joints take what saturation leaves.
fn fixed<const N: usize>(
    demand: &Demand<N>,
    rate: f64,
    saturation: Option<Saturation>,
    here: &Situation<N>,
) -> Decision<N> {
    let desired: [f64; N] = demand.at(rate.min(here.to_end)).into();
    let saturated = here.limits.saturate(&desired, saturation.unwrap_or(Saturation::Direct));
    let command = SpeedCommand {
        joint_speed: if saturation.is_some() { saturated.joint_speed } else { desired },
        path_rate: rate,
        factor: 1.0,
        switch: 1.0,
        direction_factor: if saturation.is_some() { saturated.direction_factor } else { 1.0 },
        limit_ratio: here.limits.ratio(&desired),
    };
    Decision { command, desired, demand_factor: command.factor, advance_rate: rate.min(here.to_end) }
}
