//! The optimum of the whole path, where its limits are such that it can be bracketed.

use serde::Serialize;
use slideway_baselines::path_bracket::{
    BracketError, BracketOptions, CellGap, JointPathProblem, LimitName, PathBracket, Solver, StopReason,
};
use slideway_baselines::time_optimal::Solver as GridSolver;
use slideway_lab::Experiment;
use slideway_path::{Likeness, LimitKind, NotWhole, WholePath};
use thiserror::Error;

/// What an optimum's bounds hold for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum CertifiedFor {
    /// Every point of the joint path.
    Path,
    /// Every point of a spline through points of the joint path, which is what a robot is sent.
    Spline,
    /// The nodes of a grid on the joint path.
    Nodes,
}

impl CertifiedFor {
    /// The same in one word.
    #[must_use]
    pub fn short(self) -> &'static str {
        match self {
            Self::Path => "path",
            Self::Spline => "spline",
            Self::Nodes => "nodes",
        }
    }

    /// What the bounds hold for, in words.
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            Self::Path => "for the whole path",
            Self::Spline => "for the whole of the spline that a robot is sent",
            Self::Nodes => "at the grid's nodes alone",
        }
    }
}

/// The time optimum of a whole path, with the path.
#[derive(Clone, Debug)]
pub struct WholeOptimum {
    /// The path and its limits.
    pub path: WholePath,
    /// Its bracket, with a profile.
    pub bracket: PathBracket,
    pub(crate) solver: GridSolver,
    /// Time that it took, s.
    pub(crate) solve_s: f64,
}

/// A point of the optimum's profile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfileSample {
    /// Time since the start of motion, s.
    pub time: f64,
    /// Path parameter.
    pub lambda: f64,
    /// Its rate, 1/s; infinite under speed limits alone where the path asks nothing of the joints.
    pub path_rate: f64,
    /// The largest rate that the limits leave at this place, whatever comes before and after, 1/s.
    pub rate_limit: f64,
}

/// A cell with much of the gap.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct WorstCell {
    /// Path parameter where it begins and ends.
    pub lambda: [f64; 2],
    /// Its part of the gap, s.
    pub gap_s: f64,
    /// The limit that the profile uses most there.
    pub limit: Option<LimitKind>,
    /// Name of the joint of that limit.
    pub joint: Option<String>,
}

/// Why there is no optimum of the whole path.
#[derive(Clone, Debug, PartialEq, Error)]
pub(crate) enum NoWhole {
    /// Limits or ends that it does not take.
    #[error(transparent)]
    Path(#[from] NotWhole),
    /// A path that it does not take.
    #[error("the whole path could not be bracketed: {0}")]
    Bracket(#[from] BracketError),
    /// No profile came out.
    #[error("no profile of the whole path was found")]
    NoProfile,
}

/// How an optimum is sought.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WholeOptions {
    pub(crate) gap: f64,
    pub(crate) cells: usize,
    pub(crate) solver: GridSolver,
}

/// Part of the gap that the spline in place of a path may cost, in acceleration.
const SPLINE_SHARE: f64 = 0.1;

impl WholeOptimum {
    /// The optimum of an experiment's joint path. A path of the joints whose parameter stands somewhere is replaced by a spline.
    pub(crate) fn new(experiment: &Experiment, options: WholeOptions) -> Result<Self, NoWhole> {
        let tolerance = SPLINE_SHARE * options.gap;
        match Self::of(experiment.whole_path(tolerance)?, options) {
            Err(NoWhole::Bracket(BracketError::Stall { .. })) => Self::of(experiment.spline_path(tolerance)?, options),
            result => result,
        }
    }

    /// The optimum of the same path under its speed limits alone.
    pub(crate) fn under_speed_limits_alone(&self, options: WholeOptions) -> Result<Self, NoWhole> {
        Self::of(self.path.under_speed_limits_alone(), options)
    }

    fn of(path: WholePath, options: WholeOptions) -> Result<Self, NoWhole> {
        let asked = options.solver;
        let solver = match asked {
            GridSolver::Structured => Solver::InteriorPoint,
            GridSolver::Conic => Solver::Conic,
        };
        let WholeOptions { gap, cells, .. } = options;
        let began = std::time::Instant::now();
        let options = BracketOptions { gap, cells, solver, ..BracketOptions::default() };
        let bracket = PathBracket::solve(&JointPathProblem::try_from(&path)?, &options)?;
        if !bracket.upper_s.is_finite() || bracket.profile.is_empty() {
            return Err(NoWhole::NoProfile);
        }
        Ok(Self { path, bracket, solver: asked, solve_s: began.elapsed().as_secs_f64() })
    }

    /// The profile and the limit curve above it, at the ends and in the middle of every cell.
    #[must_use]
    pub fn profile(&self) -> Vec<ProfileSample> {
        let profile = &self.bracket.profile;
        let sample = |time: f64| {
            let state = profile.at_time(time);
            let place = self.path.polynomials.at(state.s);
            let [path_rate, rate_limit] =
                [state.s_dot, self.path.rate_limit(&place)].map(|rate| place.lambda_rate * rate);
            ProfileSample { time, lambda: place.lambda, path_rate, rate_limit }
        };
        let times = profile.cell_times();
        let inside = |w: &[f64]| [w[0], 0.5 * (w[0] + w[1])];
        times.windows(2).flat_map(inside).chain(times.last().copied()).map(sample).collect()
    }

    /// The cells that hold most of the gap, by the path parameter: those with a hundredth of it, beside which the others are rounding.
    pub(crate) fn worst_cells(&self, joint_names: &[String]) -> Vec<WorstCell> {
        let lambda = |s: f64| self.path.polynomials.at(s).lambda;
        let cell = |cell: &CellGap| {
            let (limit, joint) = match cell.limit {
                None => (None, None),
                Some(LimitName::Speed { joint }) => (Some(LimitKind::JointSpeed), Some(joint)),
                Some(LimitName::Acceleration { joint, .. }) => (Some(LimitKind::JointAcceleration), Some(joint)),
            };
            let joint = joint.map(|joint| joint_names[joint].clone());
            WorstCell { lambda: [lambda(cell.from), lambda(cell.to)], gap_s: cell.gap_s, limit, joint }
        };
        let least = 0.01 * (self.bracket.upper_s - self.bracket.lower_s);
        self.bracket.worst.iter().filter(|cell| cell.gap_s >= least).map(cell).collect()
    }

    pub(crate) fn certified_for(&self) -> CertifiedFor {
        match self.path.polynomials.likeness() {
            Likeness::Same => CertifiedFor::Path,
            Likeness::Spline(_) => CertifiedFor::Spline,
        }
    }
}

/// Why the refinement of a bracket ended, with what would take it further.
pub(crate) fn stop_in_words(stop: StopReason) -> &'static str {
    match stop {
        StopReason::GapReached => "gap reached",
        StopReason::CellsSpent => "cells spent: raise `optimum.cells`, or ask for a wider `optimum.gap`",
        StopReason::NoProgress => "no progress: ask for a wider `optimum.gap`",
    }
}
