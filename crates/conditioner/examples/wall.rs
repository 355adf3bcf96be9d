//! A reference bent along a wall: `cargo run --release -p slideway-conditioner --example wall`.

use slideway_conditioner::path::{Constraint, Margin, Motion, PathForm, PathOutcome, PathSettings};
use slideway_conditioner::shapes::HalfSpace;
use slideway_conditioner::{ParameterError, PathConditioner};
use std::f64::consts::TAU;

const PERIOD: f64 = 1e-3; // s
const ROUND: u32 = 4000; // samples for one round

/// The reference: a circle of 0.3 m, which knows nothing of the wall.
fn circle(sample: u32) -> Motion<2> {
    let time = f64::from(sample) * PERIOD;
    let rate = TAU / (f64::from(ROUND) * PERIOD);
    let (sin, cos) = (rate * time).sin_cos();
    Motion { time, position: [-0.3 * cos, 0.3 * sin], velocity: [0.3 * rate * sin, 0.3 * rate * cos] }
}

fn main() -> Result<(), ParameterError> {
    let wall = HalfSpace::new(&[1.0, 0.0], 0.2)?; // x <= 0.2 m
    let conditioner = PathConditioner::<2, 1>::new(PathSettings {
        sampling_period: PERIOD,
        push_cutoff: 20.0,                               // rad/s
        approach: [0.1],                                 // s
        margin: Margin::Fixed([1e-4]),                   // m
        form: PathForm::Implicit { recovery_rate: 0.5 }, // m/s
        trap: None,
    })?;
    let mut state = conditioner.on_reference();
    let mut nearest = f64::NEG_INFINITY;
    println!("   t, s   reference, m       conditioned, m");
    for sample in 0..=ROUND {
        let reference = circle(sample);
        let step = conditioner.step(&mut state, &reference, |motion| [wall.sample(motion)]);
        nearest = nearest.max(step.sigma[0]);
        if sample.is_multiple_of(250) {
            let ([x, y], [p, q]) = (reference.position, step.motion.position);
            let acts = if step.outcome == PathOutcome::Free { "" } else { "   bent" };
            println!("{:7.3}   {x:+.4}  {y:+.4}   {p:+.4}  {q:+.4}{acts}", reference.time);
        }
    }
    println!("where it came nearest, {:.3} mm were left to the wall", -1e3 * nearest);
    Ok(())
}
