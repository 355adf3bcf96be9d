//! A speed loop around a controller of your own: `cargo run --release -p slideway-conditioner --example speed_loop`.

use slideway_conditioner::{
    Advance, AffineSpeed, ImplicitSpeedRegulator, ParameterError, Saturation, SpeedLimits, SpeedSettings, SpeedState,
};
use std::f64::consts::TAU;

const PERIOD: f64 = 1e-3; // s
const LIMITS: [f64; 2] = [0.8, 0.5]; // rad/s
const GAIN: f64 = 10.0; // 1/s

/// The path: both joints swing, the second three times as often. Position in rad, and its derivative by the path parameter.
fn path(lambda: f64) -> ([f64; 2], [f64; 2]) {
    let phase = TAU * lambda;
    ([0.4 * phase.cos(), 0.1 * (3.0 * phase).sin()], [-0.4 * TAU * phase.sin(), 0.3 * TAU * (3.0 * phase).cos()])
}

/// The controller: feedforward of the path's speed, proportional feedback of the position. Any other may stand here.
fn controller(joints: &[f64; 2], lambda: f64, rate: f64) -> [f64; 2] {
    let (position, slope) = path(lambda);
    std::array::from_fn(|i| slope[i] * rate + GAIN * (position[i] - joints[i]))
}

fn main() -> Result<(), ParameterError> {
    let regulator = ImplicitSpeedRegulator::new(SpeedSettings {
        limits: SpeedLimits::symmetric(LIMITS)?,
        sampling_period: PERIOD,
        bandwidth: 20.0,  // rad/s
        target_rate: 2.0, // 1/s, faster than the joints can go anywhere on the path
        saturation: Saturation::DirectionPreserving,
        advance: Advance::Synchronised,
    })?;
    let mut state = SpeedState::at_rest();
    let (mut joints, mut lambda) = (path(0.0).0, 0.0);
    let (mut samples, mut used, mut error) = (0_u32, 0.0_f64, 0.0_f64);
    println!("    t, s    λ       λ̇, 1/s   joint speeds as shares of their limits");
    while lambda < 1.0 {
        let standing = controller(&joints, lambda, 0.0);
        let moving = controller(&joints, lambda, regulator.target_rate());
        let command = regulator.step(&mut state, &AffineSpeed::from_evaluations(standing, moving));
        let shares: [f64; 2] = std::array::from_fn(|i| command.joint_speed[i] / LIMITS[i]);
        if samples.is_multiple_of(400) {
            let time = f64::from(samples) * PERIOD;
            println!("{time:8.3}  {lambda:6.3}  {:8.3}   {:+.3}  {:+.3}", command.path_rate, shares[0], shares[1]);
        }
        // The robot of this example does what it is told.
        lambda += PERIOD * command.path_rate;
        for (joint, speed) in joints.iter_mut().zip(command.joint_speed) {
            *joint += PERIOD * speed;
        }
        used = shares.iter().fold(used, |most, share| most.max(share.abs()));
        error = path(lambda).0.iter().zip(&joints).fold(error, |most, (p, q)| most.max((p - q).abs()));
        samples += 1;
    }
    println!("one round in {:.3} s; of a limit at most {:.6} was used", f64::from(samples) * PERIOD, used);
    println!("the joints were at most {:.2} mrad off the path", 1e3 * error);
    Ok(())
}
