//! The numbers that a sweep keeps of a run: one list from which both the names and the values are read.

use slideway_lab::MethodSummary;
use slideway_lab::conditioning::PathMethodSummary;

/// One number of a summary.
pub(crate) struct Column<S> {
    name: &'static str,
    read: fn(&S) -> Option<f64>,
}

/// One number per constraint; `@` in the name stands for the constraint's.
pub(crate) struct ConstraintColumn {
    name: &'static str,
    read: fn(&PathMethodSummary, usize) -> Option<f64>,
}

const CONDITIONING: [Column<PathMethodSummary>; 11] = [
    Column { name: "duration_s", read: |s| s.duration_s },
    Column { name: "mean_deviation_m", read: |s| Some(s.mean_deviation_m) },
    Column { name: "max_deviation_m", read: |s| Some(s.max_deviation_m) },
    Column { name: "escape_s", read: |s| s.escape_s },
    Column { name: "return_s", read: |s| s.return_s },
    Column { name: "all_active_s", read: |s| Some(s.all_active_s) },
    Column { name: "chattering_measured", read: |s| s.chattering.map(|c| c.measured) },
    Column { name: "chattering_bound", read: |s| s.chattering.map(|c| c.bound) },
    Column { name: "reserve_share", read: |s| Some(s.audit.reserve_share) },
    Column { name: "held_share", read: |s| Some(s.audit.held_share) },
    Column { name: "trapped_share", read: |s| Some(s.audit.trapped_share) },
];

const PER_CONSTRAINT: [ConstraintColumn; 4] = [
    ConstraintColumn { name: "max_sigma_@_m", read: |s, i| s.max_sigma_m.get(i).copied() },
    ConstraintColumn { name: "max_phi_@_m", read: |s, i| s.max_phi_m.get(i).copied().flatten() },
    ConstraintColumn { name: "active_@_s", read: |s, i| s.active_s.get(i).copied() },
    ConstraintColumn { name: "acting_share_@", read: |s, i| s.audit.acting_share.get(i).copied() },
];

const SPEED: [Column<MethodSummary>; 10] = [
    Column { name: "duration_s", read: |s| s.duration_s },
    Column { name: "motion_start_s", read: |s| s.motion_start_s },
    Column { name: "robot_arrival_s", read: |s| s.robot_arrival_s },
    Column { name: "travel_s", read: MethodSummary::travel_s },
    Column { name: "rms_error_norm", read: |s| Some(s.rms_error_norm) },
    Column { name: "peak_path_error_m", read: |s| Some(s.peak_path_error_m) },
    Column { name: "peak_path_error_rad", read: |s| Some(s.peak_path_error_rad) },
    Column { name: "limit_ratio_peak", read: |s| Some(s.limit_ratio_peak) },
    Column { name: "chattering_measured", read: |s| s.chattering.map(|c| c.measured) },
    Column { name: "chattering_bound", read: |s| s.chattering.map(|c| c.bound) },
];

/// Names of the values of a row about path conditioning, with their units: some for each constraint.
#[must_use]
pub fn conditioning_columns(constraints: &[String]) -> Vec<String> {
    let plain = CONDITIONING.iter().map(|c| c.name.to_owned());
    let each = labels(constraints);
    let named = |label: &String| PER_CONSTRAINT.iter().map(|c| c.name.replace('@', label)).collect::<Vec<_>>();
    plain.chain(each.iter().flat_map(named)).collect()
}

pub(crate) fn conditioning_values(summary: &PathMethodSummary) -> Vec<Option<f64>> {
    let plain = CONDITIONING.iter().map(|c| (c.read)(summary));
    let each = (0..summary.max_sigma_m.len()).flat_map(|i| PER_CONSTRAINT.iter().map(move |c| (c.read)(summary, i)));
    plain.chain(each).map(finite).collect()
}

/// Names of the values of a row about a speed law, with their units.
#[must_use]
pub fn speed_columns() -> Vec<String> {
    SPEED.iter().map(|c| c.name.to_owned()).collect()
}

pub(crate) fn speed_values(summary: &MethodSummary) -> Vec<Option<f64>> {
    SPEED.iter().map(|c| finite((c.read)(summary))).collect()
}

/// A number that is none has no place in a file of numbers; what it means is in `completed` and `broken`.
fn finite(value: Option<f64>) -> Option<f64> {
    value.filter(|v| v.is_finite())
}

/// The constraints' names, numbered where two are alike.
fn labels(constraints: &[String]) -> Vec<String> {
    let alike = |name: &String| constraints.iter().filter(|other| *other == name).count() > 1;
    let label = |(i, name): (usize, &String)| if alike(name) { format!("{name}-{i}") } else { name.clone() };
    constraints.iter().enumerate().map(label).collect()
}
