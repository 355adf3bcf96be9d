use super::signals::Loop;
use super::{conditioning, speed_loop, speed_observed};
use crate::error::VerifyError;
use slideway_lab::conditioning::{ConditionedTrace, ConditioningProblem};
use slideway_lab::{Experiment, Method, Trace};

/// One number that a run showed.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// Name of the hypothesis or guarantee that it is about.
    pub name: &'static str,
    /// The number.
    pub value: f64,
}

/// Readings of a run: the numbers of the hypotheses that are about a run, and of the guarantees.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Observed {
    /// By hypothesis. Those about the scenario alone are not here: no run breaks them.
    pub hypotheses: Vec<Reading>,
    /// By guarantee. One that was not measured, such as the arrival of a robot that never arrived, is infinite.
    pub guarantees: Vec<Reading>,
}

impl Observed {
    /// The number of a hypothesis.
    #[must_use]
    pub fn hypothesis(&self, name: &str) -> Option<f64> {
        self.hypotheses.iter().find(|r| r.name == name).map(|r| r.value)
    }

    /// The number of a guarantee.
    #[must_use]
    pub fn guarantee(&self, name: &str) -> Option<f64> {
        self.guarantees.iter().find(|r| r.name == name).map(|r| r.value)
    }
}

/// Reads runs of one scenario and method, disturbed or not, in the terms of its statement.
#[derive(Clone, Debug)]
pub struct Observer {
    kind: Kind,
}

#[derive(Clone, Debug)]
enum Kind {
    Speed(Box<Loop>),
    Conditioning(Box<ConditioningProblem>),
}

impl Observer {
    /// For runs of a speed scenario under the conditions the experiment has.
    ///
    /// # Errors
    ///
    /// The inverse kinematics fails at a place it passed while tracing.
    pub fn for_speed(experiment: &Experiment, method: Method, grid_points: usize) -> Result<Self, VerifyError> {
        Ok(Self::of_loop(speed_loop::loop_on(experiment, method, grid_points)?.0))
    }

    /// For runs in a loop already looked at.
    pub(crate) fn of_loop(looked: Loop) -> Self {
        Self { kind: Kind::Speed(Box::new(looked)) }
    }

    /// For runs of a conditioning scenario's problem.
    #[must_use]
    pub fn for_conditioning(problem: ConditioningProblem) -> Self {
        Self { kind: Kind::Conditioning(Box::new(problem)) }
    }

    /// Reads a run of a speed scenario; nothing if the observer is for conditioning.
    #[must_use]
    pub fn speed(&self, trace: &Trace) -> Observed {
        match &self.kind {
            Kind::Speed(looked) => speed_observed::observed(&looked.signals(trace), &looked.measures(trace), looked),
            Kind::Conditioning(_) => Observed::default(),
        }
    }

    /// Reads a run of a conditioning scenario; nothing if the observer is for speed.
    #[must_use]
    pub fn conditioning(&self, trace: &ConditionedTrace) -> Observed {
        match &self.kind {
            Kind::Conditioning(problem) => conditioning::observed(problem, trace),
            Kind::Speed(_) => Observed::default(),
        }
    }
}
