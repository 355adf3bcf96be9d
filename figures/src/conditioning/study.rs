use crate::error::FigureError;
use crate::scale::span;
use crate::style::path_label;
use slideway_lab::conditioning::{
    ConditionedSample, ConditionedTrace, ConditioningProblem, Contact, PathMethod, PathMethodSummary, Phase,
};
use std::ops::Range;

/// Data of the figures of a path-conditioning study.
#[derive(Clone, Copy, Debug)]
pub struct ConditioningStudy<'a> {
    /// Heading of every figure: the scenario, in a few words.
    pub title: &'a str,
    /// The problem whose reference and constraints are drawn.
    pub problem: &'a ConditioningProblem,
    /// One trace per method, any subset of the methods in any order, all of `problem`.
    pub traces: &'a [ConditionedTrace],
    /// Proven bands of `φ`, for any of the methods and constraints; may be empty.
    pub bands: &'a [PhiBand],
}

/// A proven band: `lower <= φ_i <= upper` while constraint `i` acts, `φ_i <= upper` always.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhiBand {
    /// For this method.
    pub method: PathMethod,
    /// For this constraint, counted from 0.
    pub constraint: usize,
    /// Lower end, in the unit of `φ`.
    pub lower: f64,
    /// Upper end, in the unit of `φ`.
    pub upper: f64,
}

/// A study found fit to draw.
#[derive(Clone, Debug)]
pub(crate) struct Checked<'a> {
    pub(crate) study: &'a ConditioningStudy<'a>,
    /// In drawing order: what is drawn later lies on top.
    pub(crate) runs: Vec<PathRun<'a>>,
}

/// One trace as far as it is finite.
#[derive(Clone, Debug)]
pub(crate) struct PathRun<'a> {
    pub(crate) method: PathMethod,
    pub(crate) samples: &'a [ConditionedSample],
    pub(crate) finish_s: Option<f64>,
    /// Of the finite part.
    pub(crate) summary: PathMethodSummary,
    is_whole: bool,
}

/// Broad lines first, thin and dashed ones on top.
const DRAWING_ORDER: [PathMethod; 6] = [
    PathMethod::Projection,
    PathMethod::PotentialField,
    PathMethod::SlidingMode,
    PathMethod::SlidingModePaper,
    PathMethod::QpFilter,
    PathMethod::SlidingModeImplicit,
];

impl<'a> Checked<'a> {
    pub(crate) fn new(study: &'a ConditioningStudy<'a>) -> Result<Self, FigureError> {
        if study.traces.is_empty() {
            return Err(FigureError::NoTraces);
        }
        let constraints = study.problem.constraints.len();
        if let Some(index) = study.bands.iter().position(|b| !(b.constraint < constraints && b.lower <= b.upper)) {
            return Err(FigureError::Value { what: "bands of φ", index });
        }
        let mut runs =
            study.traces.iter().map(|trace| PathRun::new(study.problem, trace)).collect::<Result<Vec<_>, _>>()?;
        runs.sort_by_key(|run| DRAWING_ORDER.iter().position(|&m| m == run.method));
        Ok(Self { study, runs })
    }

    pub(crate) fn constraints(&self) -> usize {
        self.study.problem.constraints.len()
    }

    pub(crate) fn name(&self, constraint: usize) -> &'a str {
        &self.study.problem.constraints[constraint].name
    }

    pub(crate) fn run(&self, method: PathMethod) -> Option<&PathRun<'a>> {
        self.runs.iter().find(|run| run.method == method)
    }

    /// Runs of the conditioner's own forms.
    pub(crate) fn conditioners(&self) -> impl Iterator<Item = &PathRun<'a>> {
        self.runs.iter().filter(|run| run.method.is_conditioner())
    }

    /// True if a trap stopped the reference of some run, so that the runs' clocks differ.
    pub(crate) fn has_trap(&self) -> bool {
        self.runs.iter().any(PathRun::is_trapped)
    }

    /// End of the time axes: when the last reference arrives that does, s.
    pub(crate) fn end(&self) -> f64 {
        let finish = self.runs.iter().filter_map(|run| run.finish_s).fold(0.0, f64::max);
        let last = self.runs.iter().filter_map(|run| run.samples.last()).map(|s| s.t).fold(0.0, f64::max);
        if finish > 0.0 { last.min(1.02 * finish) } else { last }
    }

    /// Samples within the time axes.
    pub(crate) fn shown(&self) -> impl Iterator<Item = &'a ConditionedSample> {
        let end = self.end();
        self.runs.iter().flat_map(|run| run.samples).filter(move |s| s.t <= end)
    }

    /// Tells which runs outlast the time axis and which are broken.
    pub(crate) fn time_remark(&self) -> String {
        let end = self.end();
        let longer = self.runs.iter().filter(|run| run.samples.last().is_some_and(|s| s.t > end));
        let names: Vec<&str> = longer.map(|run| path_label(run.method)).collect();
        if names.is_empty() {
            return self.remark();
        }
        format!(" The time axis ends at {end:.3} s; longer runs: {}.{}", names.join(", "), self.remark())
    }

    /// Tells which curves end early because their trace stops being finite.
    pub(crate) fn remark(&self) -> String {
        let broken = self.runs.iter().filter(|run| !run.is_whole);
        broken
            .filter_map(|run| Some((path_label(run.method), run.samples.last()?.t)))
            .map(|(name, t)| format!(" The trace of {name} is not finite after {t:.3} s and is drawn up to there."))
            .collect()
    }
}

impl<'a> PathRun<'a> {
    fn new(problem: &ConditioningProblem, trace: &'a ConditionedTrace) -> Result<Self, FigureError> {
        let (method, constraints) = (trace.method, problem.constraints.len());
        if trace.constraints.len() != constraints {
            let found = trace.constraints.len();
            return Err(FigureError::Length { what: "constraints of a trace", expected: constraints, found });
        }
        if trace.samples.is_empty() {
            return Err(FigureError::EmptyPathTrace { method });
        }
        let finite = trace.samples.iter().take_while(|s| is_finite(s, constraints)).count();
        if finite == 0 {
            return Err(FigureError::PathNotFinite { method });
        }
        let is_whole = finite == trace.samples.len();
        let summary = if is_whole {
            PathMethodSummary::new(problem, trace, None, None)
        } else {
            let samples = trace.samples[..finite].to_vec();
            PathMethodSummary::new(problem, &ConditionedTrace { samples, ..trace.clone() }, None, None)
        };
        Ok(Self { method, samples: &trace.samples[..finite], finish_s: trace.finish_s, summary, is_whole })
    }

    pub(crate) fn is_trapped(&self) -> bool {
        self.samples.iter().any(|s| s.phase == Phase::Trapped)
    }

    /// Points of a quantity against time.
    pub(crate) fn against_time(&self, value: impl Fn(&ConditionedSample) -> f64) -> Vec<(f64, f64)> {
        self.samples.iter().map(|s| (s.t, value(s))).collect()
    }

    /// Samples within the stretches in which constraint `i` acts.
    pub(crate) fn touching(&self, i: usize) -> impl Iterator<Item = &'a ConditionedSample> {
        let within = |c: &Contact| {
            let from = self.samples.partition_point(|s| s.t < c.from_s);
            &self.samples[from..self.samples.partition_point(|s| s.t <= c.to_s).max(from)]
        };
        self.summary.active_intervals[i].iter().flat_map(within)
    }
}

/// `φ` is not looked at: a method without a velocity has none.
fn is_finite(sample: &ConditionedSample, constraints: usize) -> bool {
    let lists = [&sample.sigma[..constraints], &sample.reference, &sample.position, &sample.push, &sample.walk];
    [sample.t, sample.lambda].iter().chain(lists.into_iter().flatten()).all(|v| v.is_finite())
}

/// A unit of length with the factor that converts metres to it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Unit {
    pub(crate) name: &'static str,
    pub(crate) factor: f64,
}

impl Unit {
    /// Millimetres, for ranges within a metre; otherwise metres.
    pub(crate) fn of(range: &Range<f64>) -> Self {
        let is_small = range.end.max(-range.start) < 1.0;
        if is_small { Self { name: "mm", factor: 1e3 } } else { Self { name: "m", factor: 1.0 } }
    }

    pub(crate) fn scale(&self, range: &Range<f64>) -> Range<f64> {
        self.factor * range.start..self.factor * range.end
    }

    /// A function of a sample in this unit.
    pub(crate) fn apply<'f>(
        self,
        value: impl Fn(&ConditionedSample) -> f64 + 'f,
    ) -> impl Fn(&ConditionedSample) -> f64 + 'f {
        move |s| self.factor * value(s)
    }
}

/// The range of values, zero included, widened a little.
pub(crate) fn roomy(values: impl IntoIterator<Item = f64>) -> Range<f64> {
    let all = span(values.into_iter().chain([0.0]));
    let room = 0.06 * (all.end - all.start).max(1e-9);
    all.start - room..all.end + room
}
