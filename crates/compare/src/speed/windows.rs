use crate::error::CompareError;
use crate::progress::{Stage, Steps};
use crate::speed::entries::OptimumEntry;
use serde::Serialize;
use slideway_lab::{Experiment, LookAheadOptions, Method, MethodSummary};

/// The look-ahead with a window of one length.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct WindowEntry {
    /// Length of the window in the path parameter.
    pub distance: f64,
    /// The same as a share of the path.
    pub share: f64,
    /// From the start of motion to the robot's arrival at rest; null if it did not arrive.
    pub travel_s: Option<f64>,
    /// `travel_s` over the optimum's duration.
    pub ratio: Option<f64>,
    /// Largest distance of the tool from its reference while the reference moves, m.
    pub peak_path_error_m: f64,
    /// Samples whose demand was out of reach.
    pub samples_off_path: usize,
}

/// Windows as shares of the path.
const SHARES: [f64; 7] = [0.01, 0.02, 0.03, 0.05, 0.1, 0.25, 1.0];

/// Intervals of the whole path, the same for all windows: they differ in what is seen, not in how finely.
const INTERVALS: f64 = 400.0;

/// Runs the look-ahead with windows of several lengths.
///
/// # Errors
///
/// Parameters that the conditioner refuses.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
pub(crate) fn windows(
    experiment: &Experiment,
    optimum: &OptimumEntry,
    steps: &mut Steps<'_, '_>,
) -> Result<Vec<WindowEntry>, CompareError> {
    if !experiment.methods().contains(&Method::AccelerationLookAhead) {
        return Ok(Vec::new());
    }
    let margin = experiment.control().look_ahead.margin;
    let entry = |share: f64| {
        steps.at(Stage::Variations)?;
        let distance = share * experiment.path_length();
        let nodes = (share * INTERVALS).ceil() as u32;
        let trace = experiment.run_seeing(LookAheadOptions { distance: Some(distance), nodes, margin })?;
        let summary = MethodSummary::new(&trace);
        let travel_s = summary.travel_s();
        Ok(WindowEntry {
            distance,
            share,
            travel_s,
            ratio: travel_s.map(|t| t / optimum.duration_s),
            peak_path_error_m: summary.peak_path_error_m,
            samples_off_path: summary.samples_off_path.unwrap_or(0),
        })
    };
    SHARES.into_iter().map(entry).collect()
}
