//! The loop that runs of a speed scenario are judged in.

use super::path_drift::PathDrift;
use super::signals::Loop;
use crate::error::VerifyError;
use slideway_baselines::time_optimal::time_optimum;
use slideway_lab::{Experiment, Method};
use slideway_path::SampledPath;

/// Samples between the grid points of the optimum at which the path's drift is read.
const BETWEEN: usize = 7;

/// The loop that a run of this experiment is judged in, and its path.
pub(crate) fn loop_on(
    experiment: &Experiment,
    method: Method,
    grid_points: usize,
) -> Result<(Loop, SampledPath), VerifyError> {
    let path = experiment.sample(grid_points, BETWEEN)?;
    let limits = Loop::limits(&path).ok_or(VerifyError::NoLimits)?;
    let found = time_optimum(&nodes_alone(&path))?;
    let looked = Loop {
        method,
        control: experiment.control(),
        limits,
        drift: PathDrift::new(&path),
        optimum: [found.duration_s, found.lower_s, found.upper_s],
        by_joints: experiment.follows_joints(),
    };
    Ok((looked, path))
}

/// The grid that `compare` solves for the optimum on, under the speed limits alone.
fn nodes_alone(path: &SampledPath) -> SampledPath {
    let mut path = path.under_speed_limits_alone();
    for piece in &mut path.pieces {
        piece.between.iter_mut().for_each(Vec::clear);
    }
    path
}
