//! Statements that do not hold as printed, with the smallest numbers that show it.

use slideway_conditioner::bounds::{chattering_estimate, frozen_band_with_feedback};
use slideway_conditioner::{Advance, SpeedLimits, SpeedRegulator, SpeedSettings, SpeedState};

use crate::draw::{TS, settings};
use crate::engine::Stop;

/// A statement, and a counterexample that is replayed on the shipped code.
#[derive(Clone, Copy, Debug)]
pub struct Refutation {
    /// What is said.
    pub statement: &'static str,
    /// Where.
    pub source: &'static str,
    /// The claim that holds instead.
    pub claim: &'static str,
    /// The case.
    pub numbers: &'static str,
    /// What the statement says about it.
    pub said: &'static str,
    /// By that much the shipped code contradicts it: positive if it does.
    pub excess: fn() -> Result<f64, Stop>,
    /// What the shipped code does instead, as a number.
    pub replay: fn() -> Result<f64, Stop>,
}

/// All of them.
pub const REFUTED: &[Refutation] = &[
    Refutation {
        statement: "The desired speed of a joint chatters by at most `|v_i| a λ̇d`",
        source: "[G11] eq 23, read as a bound",
        claim: "chattering-band",
        numbers: "one joint, limit 1 rad/s, `λ̇d` = 1/s, `a` = 1/2, `f` = 1/2, `v` falling from 3 to 1 rad in one sample",
        said: "a change of at most 0.5 rad/s",
        excess: || Ok(chattering()? - chattering_estimate(1.0, 0.5, 1.0)),
        replay: chattering,
    },
    Refutation {
        statement: "`λ̇d >= λ̇*` makes a joint saturate",
        source: "[G11] eq 21, read as sufficient",
        claim: "switching",
        numbers: "`a` = 1/2, `g` = 71/64, `f0` = 1/8, a path of four samples",
        said: "`m` above 1 at some sample",
        excess: || Ok(1.0 - largest_ratio()?),
        replay: largest_ratio,
    },
    Refutation {
        statement: "On a frozen path with feedback and `Kp Ts <= a`, `m <= 1 + a g - Kp Ts`",
        source: "this project's first statement of it",
        claim: "feedback-band",
        numbers: "synchronised advance, one joint that is ahead of its reference, `a` = 1/2, `Kp Ts` = 1/4, `g` = 2, `f` = 1/2, feedback -2.75 limits, `m` = 1.75 at first",
        said: "`m` at most 1.75",
        excess: || Ok(opposed()? - frozen_band_with_feedback(0.5, 2.0, 0.25).unwrap_or(f64::NAN)),
        replay: opposed,
    },
];

fn unit_joint(step: f64, target_rate: f64) -> Result<SpeedRegulator<1>, Stop> {
    Ok(SpeedRegulator::new(settings(SpeedLimits::symmetric([1.0])?, step, target_rate))?)
}

/// The change of the desired speed, rad/s.
fn chattering() -> Result<f64, Stop> {
    let regulator = unit_joint(0.5, 1.0)?;
    let mut state = SpeedState::moving(0.5)?;
    let before = 3.0 * regulator.requested_rate(&state);
    regulator.step(&mut state, &[before]);
    Ok((regulator.requested_rate(&state) - before).abs())
}

fn largest_ratio() -> Result<f64, Stop> {
    let regulator = unit_joint(0.5, 71.0 / 64.0)?;
    let mut state = SpeedState::moving(0.125)?;
    let mut largest = 0.0_f64;
    for _ in 0..4 {
        let desired = [regulator.requested_rate(&state)];
        largest = largest.max(regulator.step(&mut state, &desired).limit_ratio);
    }
    Ok(largest)
}

/// The ratio one sample after a start within the band.
fn opposed() -> Result<f64, Stop> {
    let (gain, rate) = (0.25 / TS, 2.0);
    let settings =
        SpeedSettings { advance: Advance::Synchronised, ..settings(SpeedLimits::symmetric([1.0])?, 0.5, rate) };
    let regulator = SpeedRegulator::new(settings)?;
    let mut state = SpeedState::moving(0.5)?;
    let mut lag = -2.75 / gain;
    let mut ratio = f64::NAN;
    for _ in 0..2 {
        let desired = [regulator.requested_rate(&state) + gain * lag];
        let command = regulator.step(&mut state, &desired);
        let [speed] = command.joint_speed;
        lag += TS * (command.path_rate - speed);
        ratio = command.limit_ratio;
    }
    Ok(ratio)
}
