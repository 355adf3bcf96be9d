use super::columns;
use super::error::SweepError;
use super::request::SweepRequest;
use super::row::SweepRow;
use super::setting::{Setting, shown};
use crate::any::AnyScenario;
use crate::error::ScenarioError;
use crate::speed::Scenario;
use slideway_lab::conditioning::{
    ConditionedTrace, ConditioningProblem, PathMethod, PathMethodSummary, check_conditioner, run_conditioner,
};
use slideway_lab::{Disturbances, Method, MethodSummary};
use toml::{Table, Value};

/// One cell of the grid: the scenario with the cell's values in it, checked.
#[derive(Clone, Debug)]
pub(crate) struct Cell {
    /// The values of the axes.
    pub(crate) values: Vec<Value>,
    subject: Subject,
    settings: String,
    text: String,
}

#[derive(Clone, Debug)]
enum Subject {
    Conditioning { problem: Box<ConditioningProblem>, method: PathMethod },
    Speed { scenario: Box<Scenario>, method: Method },
}

impl Cell {
    /// Applies the settings of every cell and those of this one, and reads the result as a scenario of its own.
    ///
    /// Without settings the text stays as it was written, so that errors point at the user's own lines.
    pub(crate) fn new(request: &SweepRequest, values: Vec<Value>) -> Result<Self, SweepError> {
        let axes = request.axes.iter().zip(&values);
        let own = axes.map(|(axis, value)| Setting { key: axis.key.clone(), value: value.clone() });
        let settings: Vec<Setting> = request.settings.iter().cloned().chain(own).collect();
        let text = applied(&request.text, &settings)?;
        let settings: Vec<String> = settings.iter().map(|s| format!("{}={}", s.key, shown(&s.value))).collect();
        let settings = settings.join(" ");
        let pointed =
            |error| SweepError::Cell { error: Box::new(error), settings: settings.clone(), text: text.clone() };
        let scenario = AnyScenario::parse(&request.name, &text).map_err(pointed)?;
        let scenario = match &request.file {
            Some(file) => scenario.in_folder_of(file),
            None => scenario,
        };
        let subject = match scenario {
            AnyScenario::Conditioning(scenario) => {
                let method = path_method(request.method.as_deref())?;
                let problem = scenario.problem().map_err(pointed)?;
                check_conditioner(&problem, method).map_err(|error| pointed(error.into()))?;
                Subject::Conditioning { problem: Box::new(problem), method }
            }
            AnyScenario::Speed(scenario) => {
                Subject::Speed { scenario, method: speed_method(request.method.as_deref())? }
            }
        };
        Ok(Self { values, subject, settings, text })
    }

    /// The scenario with the settings in it.
    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    /// Whether a seed changes anything.
    pub(crate) fn is_random(&self) -> bool {
        match &self.subject {
            Subject::Conditioning { problem, .. } => problem.trap.is_some() || problem.disturbances.are_random(),
            Subject::Speed { scenario, .. } => scenario.is_random(),
        }
    }

    pub(crate) fn method(&self) -> &'static str {
        match &self.subject {
            Subject::Conditioning { method, .. } => method.name(),
            Subject::Speed { method, .. } => method.name(),
        }
    }

    pub(crate) fn columns(&self) -> Vec<String> {
        match &self.subject {
            Subject::Conditioning { problem, .. } => {
                columns::conditioning_names(&problem.constraints.iter().map(|c| c.name.clone()).collect::<Vec<_>>())
            }
            Subject::Speed { .. } => columns::speed_names(),
        }
    }

    /// Runs the cell with a seed; the trace is dropped as soon as it is summarised.
    pub(crate) fn run(&self, run: usize, seed: Option<u64>) -> Result<SweepRow, SweepError> {
        let row = match &self.subject {
            Subject::Conditioning { problem, method } => conditioned(problem, *method, run, seed),
            Subject::Speed { scenario, method } => regulated(scenario, *method, run, seed),
        };
        row.map_err(|error| SweepError::Cell {
            error: Box::new(error),
            settings: self.settings.clone(),
            text: self.text.clone(),
        })
    }
}

fn applied(text: &str, settings: &[Setting]) -> Result<String, SweepError> {
    if settings.is_empty() {
        return Ok(text.to_owned());
    }
    let unreadable = |message: String, span| SweepError::Cell {
        error: Box::new(ScenarioError::Syntax { message, span }),
        settings: String::new(),
        text: text.to_owned(),
    };
    let mut document: Table =
        text.parse().map_err(|e: toml::de::Error| unreadable(e.message().to_owned(), e.span()))?;
    for setting in settings {
        setting.apply(&mut document)?;
    }
    toml::to_string(&document).map_err(|error| unreadable(error.to_string(), None))
}

fn path_method(name: Option<&str>) -> Result<PathMethod, SweepError> {
    let known = || PathMethod::ALL.into_iter().filter(|m| m.is_conditioner());
    let Some(name) = name else { return Ok(PathMethod::SlidingMode) };
    let unknown = || SweepError::UnknownMethod { name: name.into(), known: known().map(PathMethod::name).collect() };
    known().find(|m| m.name() == name).ok_or_else(unknown)
}

fn speed_method(name: Option<&str>) -> Result<Method, SweepError> {
    let Some(name) = name else { return Ok(Method::SlidingMode) };
    let unknown = || SweepError::UnknownMethod { name: name.into(), known: Method::ALL.map(Method::name).to_vec() };
    Method::ALL.into_iter().find(|m| m.name() == name).ok_or_else(unknown)
}

fn conditioned(
    problem: &ConditioningProblem,
    method: PathMethod,
    run: usize,
    seed: Option<u64>,
) -> Result<SweepRow, ScenarioError> {
    let mut problem = problem.clone();
    if let Some(seed) = seed {
        problem.disturbances.seed = seed;
        problem.trap.iter_mut().for_each(|trap| trap.seed = seed);
    }
    let trace = run_conditioner(&problem, method)?;
    let summary = PathMethodSummary::new(&problem, &trace, None, None);
    let values = columns::conditioning_values(&summary);
    Ok(SweepRow { run, completed: summary.completed, broken: broken(&trace), values })
}

/// How many constraints did not hold at every sample; a NaN does not hold.
fn broken(trace: &ConditionedTrace) -> usize {
    let holds = |i: usize| trace.samples.iter().all(|s| s.sigma[i] <= 0.0);
    (0..trace.constraints.len()).filter(|&i| !holds(i)).count()
}

fn regulated(scenario: &Scenario, method: Method, run: usize, seed: Option<u64>) -> Result<SweepRow, ScenarioError> {
    let mut experiment = scenario.experiment()?;
    if let Some(seed) = seed {
        experiment = experiment.with_disturbances(&Disturbances { seed, ..experiment.disturbances().clone() })?;
    }
    let summary = MethodSummary::new(&experiment.run(method)?);
    Ok(SweepRow { run, completed: summary.completed, broken: 0, values: columns::speed_values(&summary) })
}
