use crate::error::{Fault, LabError};
use crate::limits::EndRate;
use crate::problem::Problem;
use crate::run::acceleration::{AccelerationLaw, Sight};
use crate::run::controller::Demand;
use serde::{Deserialize, Serialize};
use slideway_conditioner::{
    Advance, AffineSpeed, ImplicitSpeedRegulator, Saturation, SpeedCommand, SpeedLimits, SpeedRegulator, SpeedSettings,
    SpeedState,
};
use std::fmt;

/// The speed laws that are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Method {
    /// Fixed speed, joints without limits (case 1 of `[G11]`).
    Ideal,
    /// Fixed speed, each joint saturated on its own (case 2).
    Saturated,
    /// Fixed speed, direction-preserving saturation (case 3).
    DirectionPreserving,
    /// Constant path speed, the largest that keeps the speed limits; the arm exactly on the path (`[N]`).
    ConstantSpeed,
    /// Natural motion: path speed in proportion to the determinant of the Jacobian, as fast as the speed limits allow; the arm
    /// exactly on the path (`[N]`).
    NaturalMotion,
    /// Sliding-mode regulation as published (case 4).
    SlidingMode,
    /// Sliding-mode regulation, the reference waiting for the robot.
    SlidingModeSynchronised,
    /// Sliding-mode regulation, backward-Euler form.
    SlidingModeImplicit,
    /// Sliding-mode regulation, backward-Euler form, under acceleration limits.
    AccelerationLimited,
    /// The same with a window of the path ahead.
    AccelerationLookAhead,
}

impl Method {
    /// All methods, in the order of the tables.
    pub const ALL: [Self; 10] = [
        Self::Ideal,
        Self::Saturated,
        Self::DirectionPreserving,
        Self::ConstantSpeed,
        Self::NaturalMotion,
        Self::SlidingMode,
        Self::SlidingModeSynchronised,
        Self::SlidingModeImplicit,
        Self::AccelerationLimited,
        Self::AccelerationLookAhead,
    ];

    /// The methods that need neither acceleration limits nor a `[natural]` table.
    pub const UNDER_SPEED_LIMITS: [Self; 6] = [
        Self::Ideal,
        Self::Saturated,
        Self::DirectionPreserving,
        Self::SlidingMode,
        Self::SlidingModeSynchronised,
        Self::SlidingModeImplicit,
    ];

    /// The name used in files, tables and on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Ideal => "ideal",
            Self::Saturated => "saturated",
            Self::DirectionPreserving => "direction-preserving",
            Self::ConstantSpeed => "constant-speed",
            Self::NaturalMotion => "natural-motion",
            Self::SlidingMode => "sliding-mode",
            Self::SlidingModeSynchronised => "sliding-mode-synchronised",
            Self::SlidingModeImplicit => "sliding-mode-implicit",
            Self::AccelerationLimited => "acceleration-limited",
            Self::AccelerationLookAhead => "acceleration-look-ahead",
        }
    }

    /// Whether the speed is regulated, rather than fixed in advance.
    #[must_use]
    pub fn is_regulated(self) -> bool {
        !self.surveys_the_path() && !matches!(self, Self::Ideal | Self::Saturated | Self::DirectionPreserving)
    }

    /// Whether the method is one of `[N]`: its speed chosen from a survey of the whole path, the arm exactly on it.
    #[must_use]
    pub fn surveys_the_path(self) -> bool {
        matches!(self, Self::ConstantSpeed | Self::NaturalMotion)
    }

    /// Whether the method keeps limits on joint acceleration, and needs them.
    #[must_use]
    pub fn limits_acceleration(self) -> bool {
        matches!(self, Self::AccelerationLimited | Self::AccelerationLookAhead)
    }

    /// Whether the change of the desired speed is bounded by what is recorded of it: not where the feedback is slowed.
    #[must_use]
    pub fn bounds_chattering(self) -> bool {
        self.is_regulated() && !self.limits_acceleration()
    }

    /// What the method knows in advance, for the comparison's table.
    #[must_use]
    pub fn knows(self) -> &'static str {
        match self {
            Self::Ideal => "nothing, and has no limits",
            Self::Saturated | Self::DirectionPreserving => "a speed chosen by hand",
            Self::ConstantSpeed | Self::NaturalMotion => "the speed limits and the whole path",
            Self::SlidingMode | Self::SlidingModeSynchronised | Self::SlidingModeImplicit => "the speed limits only",
            Self::AccelerationLimited => "the speed and acceleration limits only",
            Self::AccelerationLookAhead => "the limits and a window of the path ahead",
        }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// A speed law with its state, as the loop runs it.
#[derive(Clone, Debug)]
pub(crate) enum Law<const N: usize> {
    Fixed { rate: f64, saturation: Option<Saturation> },
    Explicit { regulator: SpeedRegulator<N>, state: SpeedState },
    Implicit { regulator: ImplicitSpeedRegulator<N>, state: SpeedState },
    Acceleration(Box<AccelerationLaw<N>>),
}

/// What a law may count on at one sample.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Situation<const N: usize> {
    /// Path parameter.
    pub(crate) lambda: f64,
    /// Joint-speed limits here.
    pub(crate) limits: SpeedLimits<N>,
    /// Path rate that the tool's speed limit allows here, 1/s; infinite without one.
    pub(crate) tool_rate: f64,
    /// Path rate that just reaches the path's end with this sample.
    pub(crate) to_end: f64,
}

/// What a law decides for one sample.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Decision<const N: usize> {
    /// The conditioner's command.
    pub(crate) command: SpeedCommand<N>,
    /// Desired joint speed `q̇d`.
    pub(crate) desired: [f64; N],
    /// The factor `g` with `q̇d = A + g B`, of a law that bounds chattering: `f`, less where something but the law cut the path rate.
    pub(crate) demand_factor: f64,
    /// Path rate with which `λ` is advanced: the command's, less where the path's end is nearer than a whole sample.
    pub(crate) advance_rate: f64,
}

impl<const N: usize> Law<N> {
    pub(crate) fn new(problem: &Problem<N>, method: Method, fixed_rate: f64) -> Result<Self, LabError> {
        let settings = |advance| SpeedSettings {
            limits: problem.speed_limits,
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
                .map_err(|error| LabError::value("control", error))
        };
        match method {
            Method::Ideal => Ok(Self::Fixed { rate: fixed_rate, saturation: None }),
            Method::Saturated => Ok(Self::Fixed { rate: fixed_rate, saturation: Some(Saturation::Direct) }),
            Method::DirectionPreserving => {
                Ok(Self::Fixed { rate: fixed_rate, saturation: Some(Saturation::DirectionPreserving) })
            }
            Method::ConstantSpeed | Method::NaturalMotion => {
                Err(LabError::value("natural", Fault::Missing("the method needs a `[natural]` table in the scenario")))
            }
            Method::SlidingMode => explicit(Advance::Paper),
            Method::SlidingModeSynchronised => explicit(Advance::Synchronised),
            Method::SlidingModeImplicit => ImplicitSpeedRegulator::new(settings(Advance::Synchronised))
                .map(|regulator| Self::Implicit { regulator, state })
                .map_err(|error| LabError::value("control", error)),
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
fn initial_state<const N: usize>(problem: &Problem<N>) -> Result<SpeedState, LabError> {
    let EndRate::Given(rate) = problem.start_rate else { return Ok(SpeedState::at_rest()) };
    let most = problem.control.target_rate;
    let too_fast = |_| LabError::value("limits.start_rate", Fault::OutOfRange { value: rate, least: 0.0, most });
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
