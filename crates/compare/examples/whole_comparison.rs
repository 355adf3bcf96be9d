//! A whole comparison as a value, of a problem without a file, with its progress on the error stream:
//! `cargo run --release -p slideway-compare --example whole_comparison`.

use slideway_compare::{Progress, SpeedOptions, compare_speed};
use slideway_conditioner::SpeedLimits;
use slideway_lab::{ControlSettings, Experiment, LookAheadOptions, Problem};
use slideway_path::curve::{CubicSpline, Spacing, SplineEnds, Waypoints};
use slideway_path::{JointBounds, JointCurve, PathProblem, Reference};
use slideway_robot::models::Model;
use std::ops::ControlFlow;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // An arm, a spline through way-points of its joints, and limits: rad, rad/s, rad/s².
    let points = [[0.0, 0.5], [0.4, 0.9], [1.0, 0.6], [1.2, 0.0]].map(Into::into).to_vec();
    let spline = CubicSpline::new(Waypoints::new(points, &Spacing::Chord, 0.0..1.0)?, SplineEnds::NotAKnot)?;
    let curve = JointCurve::spline(spline, 0.0..1.0);
    let start = curve.at(0.0)[0];
    let limits = SpeedLimits::symmetric([1.5, 2.0])?;
    let mut path = PathProblem::new(Model::Planar2R.describe()?.arm()?, Reference::Joint(curve), start, limits);
    path.acceleration_limits = Some(JointBounds::symmetric([4.0, 6.0])?);

    // A controller for the loop that the speed laws run in.
    let control = ControlSettings {
        gain: 10.0,
        sampling_period: 1e-3,
        bandwidth: 20.0,
        target_rate: 5.0,
        max_duration: None,
        look_ahead: LookAheadOptions::default(),
    };
    let mut problem = Problem::new(path, control);
    problem.joint_names = vec!["shoulder".into(), "elbow".into()];
    let experiment = Experiment::try_from(problem)?;

    // Called before each run; `ControlFlow::Break(())` would end the comparison there.
    let mut watch = |Progress { done, total, stage }: Progress| {
        eprintln!("{done} of {total}: {stage}");
        ControlFlow::Continue(())
    };
    let comparison = compare_speed(&experiment, &SpeedOptions::named("two joints"), &mut watch)?;

    let optimum = &comparison.summary.optimum;
    println!("the optimum is certified to lie in [{:.6}, {:.6}] s", optimum.lower_s, optimum.upper_s);
    for entry in &comparison.summary.methods {
        let ratio = entry.ratio.map_or("-".to_owned(), |ratio| format!("{ratio:.4}"));
        println!("{:28} T / T* {ratio}", entry.summary.method.name());
    }
    println!("{}", comparison.summary.verdict.sentence);
    Ok(())
}
