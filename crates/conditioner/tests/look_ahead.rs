//! With a window ahead a known path is never left, and its end is reached at rest.

use slideway_conditioner::acceleration::{
    AccelerationLimits, AccelerationRegulator, AccelerationSettings, AccelerationState, LookAhead, LookAheadSettings,
    PathKeeping, Preview, Recovery,
};
use slideway_conditioner::{AffineSpeed, ParameterError, SpeedLimits};

const TS: f64 = 1e-3;
const TARGET: f64 = 5.0;
const LENGTH: f64 = 3.0;
const NODES: usize = 600;
const GAIN: f64 = 10.0;

/// A joint path whose second joint swings ever faster, and its derivative.
fn path(lambda: f64) -> ([f64; 2], [f64; 2]) {
    let phase = lambda * lambda;
    ([lambda, 0.3 * phase.sin()], [1.0, 0.6 * lambda * phase.cos()])
}

fn look_ahead(margin: f64) -> Result<LookAhead<2>, ParameterError> {
    LookAhead::new(LookAheadSettings {
        speed_limits: SpeedLimits::symmetric([1.0; 2])?,
        acceleration_limits: AccelerationLimits::symmetric([2.0; 2])?,
        sampling_period: TS,
        target_rate: TARGET,
        margin,
    })
}

#[derive(Debug, Default)]
struct Run {
    samples: usize,
    leaves: usize,
    largest_error: f64,
    last_speed: f64,
}

/// Runs the path with a window of so many intervals of `LENGTH / NODES`; none without look-ahead.
fn run(window: Option<usize>) -> Result<Run, ParameterError> {
    let spacing = LENGTH / NODES as f64;
    let nodes: Vec<[f64; 2]> = (0..=NODES).map(|k| path(spacing * k as f64).1).collect();
    let plan = look_ahead(0.05)?;
    let regulator = AccelerationRegulator::new(AccelerationSettings {
        speed_limits: SpeedLimits::symmetric([1.0; 2])?,
        acceleration_limits: AccelerationLimits::symmetric([2.0; 2])?,
        sampling_period: TS,
        bandwidth: 200.0,
        target_rate: TARGET,
        recovery: Recovery::Braking { gain: GAIN },
    })?;
    let (mut state, mut lambda, mut q) = (AccelerationState::at_rest(), 0.0_f64, [0.0; 2]);
    let mut run = Run::default();
    while lambda < LENGTH && run.samples < 20_000 {
        let (reference, slope) = path(lambda);
        let error = [reference[0] - q[0], reference[1] - q[1]];
        let desired = AffineSpeed { feedback: error.map(|e| GAIN * e), feedforward: slope.map(|v| TARGET * v) };
        let behind = ((lambda / spacing) as usize).min(NODES);
        let ceiling = window.map_or(TARGET, |intervals| {
            plan.greatest_rate(&Preview {
                offset: (lambda - spacing * behind as f64).max(0.0),
                spacing,
                path_speeds: &nodes[behind..=(behind + intervals).min(NODES)],
            })
        });
        let command = regulator.step_below(&mut state, &desired, ceiling.min((LENGTH - lambda) / TS));
        run.samples += 1;
        run.leaves += usize::from(command.keeping != PathKeeping::OnPath);
        run.largest_error = run.largest_error.max(error[0].hypot(error[1]));
        run.last_speed = command.joint_speed[0].abs();
        lambda += TS * command.path_rate;
        if LENGTH - lambda < 1e-12 {
            lambda = LENGTH;
        }
        q = [q[0] + TS * command.joint_speed[0], q[1] + TS * command.joint_speed[1]];
    }
    Ok(run)
}

#[test]
fn with_a_window_the_path_is_never_left_and_ends_at_rest() -> Result<(), ParameterError> {
    for window in [40, 120, 600] {
        let run = run(Some(window))?;
        assert_eq!(run.leaves, 0, "{window}: {run:?}");
        // Euler steps along the curved path: Ts² |q''| λ̇² / 2 a sample against a loop that forgets in 1 / Kp.
        assert!(run.largest_error < 1e-3, "{window}: {run:?}");
        // The stop is reached within one sample's change of speed.
        assert!(run.last_speed <= 2.0 * 2.0 * TS, "{window}: {run:?}");
    }
    Ok(())
}

#[test]
fn without_a_window_the_same_path_is_left_and_ends_in_motion() -> Result<(), ParameterError> {
    let run = run(None)?;
    assert!(run.leaves > 0 && run.largest_error > 5e-3 && run.last_speed > 0.1, "{run:?}");
    Ok(())
}

#[test]
fn a_longer_window_takes_no_longer() -> Result<(), ParameterError> {
    let runs = [20, 60, 200, 600].map(|window| run(Some(window)));
    let mut samples = usize::MAX;
    for run in runs {
        let run = run?;
        assert!(run.samples <= samples, "{run:?} after {samples}");
        samples = run.samples;
    }
    Ok(())
}

#[test]
fn on_a_straight_line_the_stop_is_the_closed_form() -> Result<(), ParameterError> {
    // w²/ (2 a) + Ts w / 2 = distance: v = 1, so a = 2, no margin.
    let distance = 0.1;
    let rate = look_ahead(0.0)?.greatest_rate(&Preview { offset: 0.0, spacing: 0.01, path_speeds: &[[1.0, 0.5]; 11] });
    let closed = -TS + (TS * TS + 4.0 * distance).sqrt();
    assert!((rate - closed).abs() < 1e-10, "{rate} {closed}");
    Ok(())
}

#[test]
fn what_is_not_known_allows_no_speed() -> Result<(), ParameterError> {
    let plan = look_ahead(0.0)?;
    let rate =
        |offset, spacing, path_speeds: &[[f64; 2]]| plan.greatest_rate(&Preview { offset, spacing, path_speeds });
    assert_eq!(rate(0.0, 0.1, &[]), 0.0);
    assert_eq!(rate(0.0, 0.1, &[[1.0; 2]]), 0.0);
    assert_eq!(rate(0.3, 0.1, &[[1.0; 2]; 3]), 0.0);
    assert_eq!(rate(f64::NAN, 0.1, &[[1.0; 2]; 3]), 0.0);
    assert_eq!(rate(0.0, f64::NAN, &[[1.0; 2]; 3]), 0.0);
    // A hole in the knowledge is the end of the window.
    let shorter = rate(0.0, 0.1, &[[1.0; 2]; 3]);
    let holed = rate(0.0, 0.1, &[[1.0; 2], [1.0; 2], [1.0; 2], [f64::NAN; 2], [1.0; 2]]);
    assert!(shorter > 0.0 && (holed - shorter).abs() < 1e-10, "{holed} {shorter}");
    Ok(())
}

/// The twin works every range out anew.
#[test]
fn with_the_ranges_known_the_rate_is_the_same() -> Result<(), ParameterError> {
    let spacing = LENGTH / NODES as f64;
    let nodes: Vec<[f64; 2]> = (0..=NODES).map(|k| path(spacing * k as f64).1).collect();
    let plan = look_ahead(0.05)?;
    let mut ranges = vec![f64::NAN; nodes.len()];
    plan.ranges(spacing, &nodes, &mut ranges);
    for step in 0..3000 {
        let lambda = 1e-3 * f64::from(step);
        let behind = ((lambda / spacing) as usize).min(NODES);
        let preview =
            Preview { offset: (lambda - behind as f64 * spacing).max(0.0), spacing, path_speeds: &nodes[behind..] };
        let (twin, rate) = (plan.greatest_rate(&preview), plan.greatest_rate_within(&preview, &ranges[behind..]));
        // Lengths of stretches are differences of places up to 3: rounding of 1e-15 over a spacing of 5e-3.
        assert!((rate - twin).abs() <= 1e-11 * twin + 1e-11, "{rate} {twin} at {lambda}");
    }
    // What cannot be used is a stand.
    plan.ranges(f64::NAN, &nodes, &mut ranges);
    assert!(ranges.iter().all(|b| *b == 0.0));
    let nowhere = Preview { offset: f64::NAN, spacing, path_speeds: &nodes };
    assert_eq!(plan.greatest_rate_within(&nowhere, &ranges), 0.0);
    Ok(())
}
