//! Under acceleration limits: what looking ahead keeps that going blind cannot, on built-in scenarios.

use slideway_lab::{Experiment, Method, MethodSummary, Trace};
use slideway_scenario::{Scenario, ScenarioError};

fn experiment(name: &str) -> Result<Experiment, ScenarioError> {
    Scenario::built_in(name).expect("built in")?.experiment()
}

/// Largest change of a commanded joint speed over one sample of the whole run, from rest to rest, as an acceleration.
fn largest_acceleration(trace: &Trace) -> f64 {
    let commands: Vec<&[f64]> = trace.samples.iter().map(|s| &s.commanded[..trace.joints]).collect();
    let first = commands[0].iter().map(|v| v.abs()).fold(0.0, f64::max);
    let change = |w: &[&[f64]]| w[0].iter().zip(w[1]).map(|(a, b)| (b - a).abs()).fold(0.0, f64::max);
    commands.windows(2).map(change).fold(first, f64::max) / trace.sampling_period
}

#[test]
fn with_a_window_the_bend_is_followed_and_without_one_it_is_cut() -> Result<(), ScenarioError> {
    let experiment = experiment("planar-bend")?;
    let [blind, seeing] = [Method::AccelerationLimited, Method::AccelerationLookAhead].map(|m| experiment.run(m));
    let (blind, seeing) = (blind?, seeing?);
    for trace in [&blind, &seeing] {
        // 4 rad/s² to the rounding of speeds of order 1 over 1 ms.
        assert!(largest_acceleration(trace) <= 4.0 + 1e-12 / trace.sampling_period);
        assert!(trace.arrival_s.is_some());
    }
    let (blind, seeing) = (MethodSummary::new(&blind), MethodSummary::new(&seeing));
    assert_eq!(seeing.samples_off_path, Some(0));
    // Joints held over a sample: Ts |p''| λ̇² / (2 Kp), with p'' = 4.5 m at a bend of 2 cm and λ̇ below 1 there: 0.11 mm.
    assert!(seeing.peak_path_error_m < 0.15e-3, "{}", seeing.peak_path_error_m);
    assert!(blind.samples_off_path > Some(0) && blind.peak_path_error_m > 10e-3, "{}", blind.peak_path_error_m);
    assert!(seeing.travel_s() < blind.travel_s());
    Ok(())
}

#[test]
fn the_robot_arrives_at_rest() -> Result<(), ScenarioError> {
    let trace = experiment("puma-helix-acceleration")?.run(Method::AccelerationLookAhead)?;
    let last = trace.samples.last().expect("samples");
    // It could stop with the next sample: 2 rad/s² over 1 ms.
    assert!(last.commanded.iter().all(|v| v.abs() <= 2e-3 * (1.0 + 1e-12)), "{:?}", last.commanded);
    assert_eq!(MethodSummary::new(&trace).samples_off_path, Some(0));
    Ok(())
}

#[test]
fn without_acceleration_limits_the_methods_that_need_them_are_left_out() -> Result<(), ScenarioError> {
    let experiment = experiment("puma-helix-on-path")?;
    assert!(!experiment.methods().iter().any(|m| m.limits_acceleration()));
    let error = experiment.run(Method::AccelerationLookAhead).expect_err("no limits");
    assert!(error.to_string().contains("limits.acceleration"), "{error}");
    Ok(())
}
