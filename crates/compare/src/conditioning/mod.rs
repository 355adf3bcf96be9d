//! Path conditioners beside the projection, the QP safety filter and the potential field.

pub(crate) mod arrival;
pub(crate) mod convergence;
pub(crate) mod summary;

use crate::error::{CompareError, check_shares};
use crate::progress::{Stage, Steps, Watch};
use crate::rivals::{ProjectedTrace, potential_field_trace, projection_trace, qp_filter_trace};
use arrival::{Arrival, Goal};
use convergence::{Convergence, convergence};
use slideway_lab::conditioning::{
    ConditionedTrace, ConditioningProblem, PathMethod, PathMethodSummary, run_and_settle,
};
use summary::{ConditioningSummary, ConditioningVerdict, PathMethodEntry, ProjectionEntry};

/// Options of a comparison of path conditioners.
#[derive(Clone, Debug)]
pub struct ConditioningOptions {
    /// Name of the problem, for the summary.
    pub name: String,
    /// A line about it, for the summary.
    pub description: String,
    /// Largest excess of the mean deviation over the projection's, as a share of it; `None` for any.
    pub tolerance: Option<f64>,
    /// Divisors of the sampling period at which the distance from the QP path is measured too.
    pub divisors: Vec<f64>,
}

impl Default for ConditioningOptions {
    /// No name, any deviation, five sampling periods down to a twentieth.
    fn default() -> Self {
        let divisors = vec![1.0, 2.0, 5.0, 10.0, 20.0];
        Self { name: String::new(), description: String::new(), tolerance: None, divisors }
    }
}

/// A finished comparison of path conditioners.
#[derive(Clone, Debug)]
pub struct ConditioningComparison {
    /// Its numbers, with the verdict.
    pub summary: ConditioningSummary,
    /// One run per method, in the order of [`PathMethod::ALL`]; without the projection where the allowed set is empty somewhere.
    pub traces: Vec<ConditionedTrace>,
}

/// Runs every path conditioner and its rivals on a problem and puts them beside the projection. The same problem and options give the
/// same comparison.
///
/// # Errors
///
/// A tolerance that cannot be used, parameters that the conditioner refuses, or an end by the caller.
pub fn compare_conditioning(
    problem: &ConditioningProblem,
    options: &ConditioningOptions,
    watch: &mut Watch<'_>,
) -> Result<ConditioningComparison, CompareError> {
    check_shares(options.tolerance, None)?;
    let mut steps = Steps::new(watch, PathMethod::ALL.len() + 1);
    let mut traces = Vec::new();
    let mut projected = None;
    let mut arrivals = Vec::new();
    for method in PathMethod::ALL {
        steps.at(Stage::PathMethod(method))?;
        match method {
            PathMethod::QpFilter => traces.push(qp_filter_trace(problem)),
            PathMethod::PotentialField => traces.push(potential_field_trace(problem)),
            PathMethod::Projection => {
                // A set that is empty somewhere has no projection; the other methods are compared all the same.
                projected = projection_trace(problem).ok();
                traces.extend(projected.as_ref().map(|p| p.trace.clone()));
            }
            form => {
                let mut goal = Goal::new(problem, form);
                let (trace, after) = run_and_settle(problem, form, &mut |sample| goal.is_reached_by(sample))?;
                traces.push(trace);
                arrivals.push((form, after));
            }
        }
    }
    let convergence = convergence(problem, &options.divisors, &mut steps)?;
    let summary = summarise(problem, options, &traces, &arrivals, projected.as_ref(), convergence);
    Ok(ConditioningComparison { summary, traces })
}

fn summarise(
    problem: &ConditioningProblem,
    options: &ConditioningOptions,
    traces: &[ConditionedTrace],
    arrivals: &[(PathMethod, Option<f64>)],
    projected: Option<&ProjectedTrace>,
    convergence: Vec<Convergence>,
) -> ConditioningSummary {
    let qp = traces.iter().find(|t| t.method == PathMethod::QpFilter);
    let projection = projected.map(|p| &p.trace);
    let arrival = |trace: &ConditionedTrace| -> Arrival {
        let after = arrivals.iter().find(|(method, _)| *method == trace.method).and_then(|(_, after)| *after);
        Goal::new(problem, trace.method).arrival(trace, after)
    };
    let entry = |trace| PathMethodEntry {
        summary: PathMethodSummary::new(problem, trace, projection, qp),
        arrival: arrival(trace),
    };
    let methods: Vec<PathMethodEntry> = traces.iter().map(entry).collect();
    let constraints: Vec<String> = problem.constraints.iter().map(|c| c.name.clone()).collect();
    ConditioningSummary {
        scenario: options.name.clone(),
        description: options.description.clone(),
        verdict: ConditioningVerdict::new(&methods, &constraints, options.tolerance),
        constraints,
        methods,
        disturbances: Some(problem.disturbances).filter(|d| !d.are_none()),
        projection: projected.map(ProjectionEntry::new),
        convergence,
    }
}
