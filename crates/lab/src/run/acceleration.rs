use crate::problem::Problem;
use crate::run::controller::Demand;
use crate::run::decision::{Decision, Situation};
use crate::run::path_window::PathWindow;
use slideway_conditioner::acceleration::{
    AccelerationCommand, AccelerationLimits, AccelerationRegulator, AccelerationSettings, AccelerationState, LookAhead,
    LookAheadSettings, PathKeeping, Recovery,
};
use slideway_conditioner::{AffineSpeed, SpeedCommand};
use slideway_path::EndRate;
use slideway_path::{Fault, ProblemError};

/// Part of the path that a law under acceleration limits sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sight {
    /// The current sample only.
    Blind,
    /// A window ahead, `control.look_ahead`.
    Window,
}

/// The acceleration-limited regulator with its state and, with look-ahead, the path's nodes.
#[derive(Clone, Debug)]
pub(crate) struct AccelerationLaw<const N: usize> {
    regulator: AccelerationRegulator<N>,
    state: AccelerationState<N>,
    limits: AccelerationLimits<N>,
    period: f64,
    ahead: Option<(LookAhead<N>, PathWindow<N>)>,
}

impl<const N: usize> AccelerationLaw<N> {
    pub(crate) fn new(problem: &Problem<N>, sight: Sight) -> Result<Self, ProblemError> {
        let missing = Fault::Missing(
            "the acceleration-limited methods need joint-acceleration limits and speed limits that do not vary along the path, and rest at its ends",
        );
        let limits = online_limits(problem).ok_or_else(|| ProblemError::value("limits.acceleration", missing))?;
        let control = &problem.control;
        let regulator = AccelerationRegulator::new(AccelerationSettings {
            speed_limits: problem.path.speed_limits,
            acceleration_limits: limits,
            sampling_period: control.sampling_period,
            bandwidth: control.bandwidth,
            target_rate: control.target_rate,
            recovery: Recovery::Braking { gain: control.gain },
        })
        .map_err(|error| ProblemError::value("control", error))?;
        let ahead = match sight {
            Sight::Blind => None,
            Sight::Window => Some((look_ahead(problem, limits)?, PathWindow::new(problem))),
        };
        let period = control.sampling_period;
        Ok(Self { regulator, state: AccelerationState::at_rest(), limits, period, ahead })
    }

    pub(crate) fn step(&mut self, problem: &Problem<N>, demand: &Demand<N>, here: &Situation<N>) -> Decision<N> {
        let split = AffineSpeed {
            feedback: demand.feedback.into(),
            feedforward: (demand.path_speed * self.regulator.target_rate()).into(),
        };
        let seen = match &mut self.ahead {
            Some((plan, window)) => plan.greatest_rate(&window.preview(problem, here.lambda)),
            None => f64::INFINITY,
        };
        let ceiling = seen.min(here.tool_rate).min(here.to_end);
        let command = self.regulator.step_below(&mut self.state, &split, ceiling);
        self.decision(problem, &command, here.to_end)
    }

    /// One sample with the reference at its end.
    pub(crate) fn settle(&mut self, problem: &Problem<N>, demand: &Demand<N>) -> Decision<N> {
        let split = AffineSpeed { feedback: demand.feedback.into(), feedforward: [0.0; N] };
        let command = self.regulator.step_below(&mut self.state, &split, 0.0);
        self.decision(problem, &command, 0.0)
    }

    /// True if the joints, as commanded last, can stand still with the next sample.
    pub(crate) fn can_stand(&self) -> bool {
        let ends = self.limits.lower().iter().zip(self.limits.upper());
        let speeds = self.state.joint_speed();
        speeds.iter().zip(ends).all(|(v, (lo, up))| v + self.period * lo <= 0.0 && v + self.period * up >= 0.0)
    }

    /// A demand that is met keeps its direction, any other does not.
    fn decision(&self, problem: &Problem<N>, command: &AccelerationCommand<N>, most: f64) -> Decision<N> {
        Decision {
            command: SpeedCommand {
                joint_speed: command.joint_speed,
                path_rate: command.path_rate,
                factor: command.factor,
                switch: command.switch,
                direction_factor: if command.keeping == PathKeeping::OnPath { 1.0 } else { 0.0 },
                limit_ratio: problem.path.speed_limits.ratio(&command.desired),
            },
            desired: command.desired,
            demand_factor: command.factor,
            advance_rate: command.path_rate.min(most),
        }
    }
}

/// The limits under which the acceleration-limited methods run: constant ones, from rest to rest. `None` for any other problem.
pub(crate) fn online_limits<const N: usize>(problem: &Problem<N>) -> Option<AccelerationLimits<N>> {
    let rests = |rate: EndRate| matches!(rate, EndRate::ByLimits | EndRate::Given(0.0));
    if problem.path.speed_along.is_some() || !rests(problem.path.start_rate) || !rests(problem.path.end_rate) {
        return None;
    }
    let range = problem.path.acceleration_limits.as_ref()?.constant()?;
    AccelerationLimits::new(range.lower, range.upper).ok()
}

fn look_ahead<const N: usize>(
    problem: &Problem<N>,
    limits: AccelerationLimits<N>,
) -> Result<LookAhead<N>, ProblemError> {
    LookAhead::new(LookAheadSettings {
        speed_limits: problem.path.speed_limits,
        acceleration_limits: limits,
        sampling_period: problem.control.sampling_period,
        target_rate: problem.control.target_rate,
        margin: problem.control.look_ahead.margin,
    })
    .map_err(|error| ProblemError::value("control.look_ahead.margin", error))
}
