//! Subjects of scenarios: the one place where the method is chosen that comparison, sweep, campaign and tuning judge.

use crate::any::AnyScenario;
use crate::conditioning::ConditioningScenario;
use crate::error::ScenarioError;
use crate::speed::Scenario;
use slideway_compare::sweep::{conditioning_columns, speed_columns};
use slideway_lab::conditioning::{ConditioningProblem, PathMethod, check_conditioner};
use slideway_lab::{Experiment, Method, Subject};

impl AnyScenario {
    /// The problem that the scenario describes with a method, by name; without one the method that a comparison judges.
    ///
    /// # Errors
    ///
    /// The first value that cannot be used, a path that the robot cannot follow, a method that there is not.
    pub fn subject(&self, method: Option<&str>) -> Result<Subject, ScenarioError> {
        Ok(match self {
            Self::Speed(scenario) => {
                let (experiment, method) = scenario.judged(method)?;
                Subject::Speed { experiment: Box::new(experiment), method }
            }
            Self::Conditioning(scenario) => {
                let (problem, method) = scenario.judged(method)?;
                Subject::Conditioning { problem: Box::new(problem), method }
            }
        })
    }

    /// Checks what can be told without tracing a path.
    pub(crate) fn check(&self, method: Option<&str>) -> Result<(), ScenarioError> {
        match self {
            Self::Speed(_) => method.map_or(Ok(()), |name| speed_method(name).map(drop)),
            Self::Conditioning(scenario) => scenario.judged(method).map(drop),
        }
    }

    /// Grid points of the optimum; 0 where there is none.
    #[must_use]
    pub fn grid_points(&self) -> usize {
        match self {
            Self::Speed(scenario) => scenario.grid_points(),
            Self::Conditioning(_) => 0,
        }
    }

    /// Whether a seed changes anything.
    pub(crate) fn is_random(&self) -> bool {
        match self {
            Self::Speed(scenario) => scenario.is_random(),
            Self::Conditioning(scenario) => scenario.is_random(),
        }
    }

    /// Names of the values that a sweep keeps of a run.
    pub(crate) fn sweep_columns(&self) -> Result<Vec<String>, ScenarioError> {
        let named = |scenario: &ConditioningScenario| {
            let constraints = scenario.problem()?.constraints;
            Ok(conditioning_columns(&constraints.into_iter().map(|c| c.name).collect::<Vec<_>>()))
        };
        match self {
            Self::Speed(_) => Ok(speed_columns()),
            Self::Conditioning(scenario) => named(scenario),
        }
    }
}

impl Scenario {
    /// The experiment with the method that is judged.
    pub(crate) fn judged(&self, method: Option<&str>) -> Result<(Experiment, Method), ScenarioError> {
        let chosen = method.map(speed_method).transpose()?.or(self.judged_method());
        let experiment = self.experiment()?;
        let method = experiment.judged_method(chosen)?;
        Ok((experiment, method))
    }
}

impl ConditioningScenario {
    /// The problem with the method that is judged, checked.
    pub(crate) fn judged(&self, method: Option<&str>) -> Result<(ConditioningProblem, PathMethod), ScenarioError> {
        let method = path_method(method)?;
        let problem = self.problem()?;
        check_conditioner(&problem, method)?;
        Ok((problem, method))
    }
}

fn speed_method(name: &str) -> Result<Method, ScenarioError> {
    let unknown = || ScenarioError::UnknownMethod { name: name.into(), known: Method::ALL.map(Method::name).to_vec() };
    Method::ALL.into_iter().find(|m| m.name() == name).ok_or_else(unknown)
}

fn path_method(name: Option<&str>) -> Result<PathMethod, ScenarioError> {
    let known = || PathMethod::ALL.into_iter().filter(|m| m.is_conditioner());
    let Some(name) = name else { return Ok(PathMethod::JUDGED) };
    let unknown = || ScenarioError::UnknownMethod { name: name.into(), known: known().map(PathMethod::name).collect() };
    known().find(|m| m.name() == name).ok_or_else(unknown)
}
