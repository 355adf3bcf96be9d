//! `[G11]` Table 1: root mean square errors on the helix.

use slideway_lab::{Agreement, Experiment, Method, MethodSummary, Published};
use slideway_scenario::{Scenario, ScenarioError};

/// RMS of the six coordinates, then of the norm, as printed; cases 1 to 4.
const PRINTED: [(Method, [f64; 7]); 4] = [
    (Method::Ideal, [0.0101, 0.0101, 0.0051, 0.0202, 0.0202, 0.0101, 0.0339]),
    (Method::Saturated, [0.0497, 0.0188, 0.0834, 0.1013, 0.2127, 0.0722, 0.2655]),
    (Method::DirectionPreserving, [0.0523, 0.0517, 0.0540, 0.0642, 0.0642, 0.0321, 0.1326]),
    (Method::SlidingMode, [0.0266, 0.0266, 0.0133, 0.0531, 0.0531, 0.0266, 0.0891]),
];

const QUANTITIES: [(&str, &str); 7] = [
    ("RMS e1", "m"),
    ("RMS e2", "m"),
    ("RMS e3", "m"),
    ("RMS e4", "rad"),
    ("RMS e5", "rad"),
    ("RMS e6", "rad"),
    ("RMS of the norm", "m, rad"),
];

/// Half the last of four decimals.
const EVERY_DIGIT: f64 = 0.5e-4;

/// Euler and Runge-Kutta steps of 2.5 ms differ by as much as this; which was used is not printed.
const INTEGRATION: f64 = 2.1e-4;

pub(super) fn rows() -> Result<Vec<Published>, ScenarioError> {
    let experiment = experiment("puma-helix")?;
    let mut rows = Vec::new();
    for (case, (method, printed)) in PRINTED.into_iter().enumerate() {
        let summary = MethodSummary::new(&experiment.run(method)?);
        let ours = summary.rms_error.into_iter().chain([summary.rms_error_norm]);
        let (tolerance, remark) = if method == Method::SlidingMode {
            (EVERY_DIGIT, "")
        } else {
            (INTEGRATION, "agreement to 2.1e-4: how the run was integrated is not printed")
        };
        for ((paper, ours), (quantity, unit)) in printed.into_iter().zip(ours).zip(QUANTITIES) {
            rows.push(Published {
                source: "[G11] Table 1",
                case: format!("case {}, {method}", case + 1),
                quantity,
                unit,
                paper,
                ours: Some(ours),
                tolerance,
                expected: Agreement::Agrees,
                remark,
            });
        }
    }
    Ok(rows)
}

/// A built-in scenario made ready to run.
pub(super) fn experiment(name: &str) -> Result<Experiment, ScenarioError> {
    let missing =
        || ScenarioError::value("scenario", slideway_path::Fault::Missing("no built-in scenario of that name"));
    Scenario::built_in(name).ok_or_else(missing)??.experiment()
}
