//! Statements that do not hold as printed, with the smallest numbers that show it.

use slideway_conditioner::bounds::{chattering_estimate, frozen_band_with_feedback};
use slideway_conditioner::{Advance, SpeedLimits, SpeedRegulator, SpeedSettings, SpeedState};

use crate::draw::{TS, settings};
use crate::engine::Stop;

/// A statement, and a counterexample that is replayed on the shipped code.
#[derive(Clone, Copy, Debug)]
pub struct Refutation {
    /// Statement that is refuted.
    pub statement: &'static str,
    /// Source of the statement.
    pub source: &'static str,
    /// The claim that holds instead.
    pub claim: &'static str,
    /// The case.
    pub numbers: &'static str,
    /// Prediction of the statement for the case.
    pub said: &'static str,
    /// Excess by which the shipped code contradicts it: positive if it does.
    pub excess: fn() -> Result<f64, Stop>,
    /// Number that the shipped code gives instead.
    pub replay: fn() -> Result<f64, Stop>,
    /// The run in which it does, for a figure.
    pub run: fn() -> Result<RefutingRun, Stop>,
}

/// The run of a counterexample, on the shipped code, sample by sample; it goes on where the case does.
#[derive(Clone, Debug, PartialEq)]
pub struct RefutingRun {
    /// Quantity that the statement is about, with its unit.
    pub quantity: &'static str,
    /// Description of the run, in a sentence.
    pub seen: &'static str,
    /// Number of the sample, and the quantity there.
    pub found: Vec<[f64; 2]>,
    /// Number of the sample, and the value that the statement gives for the quantity there.
    pub said: Vec<[f64; 2]>,
    /// Words of the statement for the figure's legend.
    pub saying: &'static str,
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
        run: chattering_run,
    },
    Refutation {
        statement: "`λ̇d >= λ̇*` makes a joint saturate",
        source: "[G11] eq 21, read as sufficient",
        claim: "switching",
        numbers: "`a` = 1/2, `g` = 71/64, `f0` = 1/8, a path of four samples",
        said: "`m` above 1 at some sample",
        excess: || Ok(1.0 - largest_ratio()?),
        replay: largest_ratio,
        run: ratio_run,
    },
    Refutation {
        statement: "On a frozen path with feedback and `Kp Ts <= a`, `m <= 1 + a g - Kp Ts`",
        source: "this project's first statement of `feedback-band`",
        claim: "feedback-band",
        numbers: "synchronised advance, one joint that is ahead of its reference, `a` = 1/2, `Kp Ts` = 1/4, `g` = 2, `f` = 1/2, feedback -2.75 limits, `m` = 1.75 at first",
        said: "`m` at most 1.75",
        excess: || Ok(opposed()? - frozen_band_with_feedback(0.5, 2.0, 0.25).unwrap_or(f64::NAN)),
        replay: opposed,
        run: opposed_run,
    },
];

fn unit_joint(step: f64, target_rate: f64) -> Result<SpeedRegulator<1>, Stop> {
    Ok(SpeedRegulator::new(settings(SpeedLimits::symmetric([1.0])?, step, target_rate))?)
}

/// Numbered from `first`.
fn by_sample(first: u32, values: &[f64]) -> Vec<[f64; 2]> {
    (first..).zip(values).map(|(sample, value)| [f64::from(sample), *value]).collect()
}

/// The value at a sample, NaN where there is none.
fn at(values: &[f64], sample: usize) -> f64 {
    values.get(sample).copied().unwrap_or(f64::NAN)
}

/// Changes of the desired speed, rad/s, the one in which `v` falls first; it stays where it is then.
fn changes(count: usize) -> Result<Vec<f64>, Stop> {
    let regulator = unit_joint(0.5, 1.0)?;
    let mut state = SpeedState::moving(0.5)?;
    let mut before = 3.0 * regulator.requested_rate(&state);
    let mut changes = Vec::new();
    for _ in 0..count {
        regulator.step(&mut state, &[before]);
        let desired = regulator.requested_rate(&state);
        changes.push((desired - before).abs());
        before = desired;
    }
    Ok(changes)
}

fn chattering() -> Result<f64, Stop> {
    Ok(at(&changes(1)?, 0))
}

fn chattering_run() -> Result<RefutingRun, Stop> {
    let changes = changes(6)?;
    Ok(RefutingRun {
        quantity: "change of speed (rad/s)",
        seen: "Where |v| falls from 3 to 1 rad the desired speed changes by 2.5 times what is said.",
        said: by_sample(1, &vec![chattering_estimate(1.0, 0.5, 1.0); changes.len()]),
        found: by_sample(1, &changes),
        saying: "|v| a times the target rate, eq 23",
    })
}

/// The use of the limit on a path of four samples.
fn ratios() -> Result<Vec<f64>, Stop> {
    let regulator = unit_joint(0.5, 71.0 / 64.0)?;
    let mut state = SpeedState::moving(0.125)?;
    let mut ratios = Vec::new();
    for _ in 0..4 {
        let desired = [regulator.requested_rate(&state)];
        ratios.push(regulator.step(&mut state, &desired).limit_ratio);
    }
    Ok(ratios)
}

fn largest_ratio() -> Result<f64, Stop> {
    Ok(ratios()?.into_iter().fold(0.0, f64::max))
}

fn ratio_run() -> Result<RefutingRun, Stop> {
    let ratios = ratios()?;
    Ok(RefutingRun {
        quantity: "m, use of the limit",
        seen: "The path ends before the joint reaches its limit, though the target rate is 71/64 of the largest rate.",
        said: by_sample(0, &vec![1.0; ratios.len()]),
        found: by_sample(0, &ratios),
        saying: "exceeded at some sample, eq 21",
    })
}

/// The use of the limit, from a start within the band on.
fn opposed_ratios(count: usize) -> Result<Vec<f64>, Stop> {
    let (gain, rate) = (0.25 / TS, 2.0);
    let settings =
        SpeedSettings { advance: Advance::Synchronised, ..settings(SpeedLimits::symmetric([1.0])?, 0.5, rate) };
    let regulator = SpeedRegulator::new(settings)?;
    let mut state = SpeedState::moving(0.5)?;
    let mut lag = -2.75 / gain;
    let mut ratios = Vec::new();
    for _ in 0..count {
        let desired = [regulator.requested_rate(&state) + gain * lag];
        let command = regulator.step(&mut state, &desired);
        let [speed] = command.joint_speed;
        lag += TS * (command.path_rate - speed);
        ratios.push(command.limit_ratio);
    }
    Ok(ratios)
}

/// The ratio one sample after the start.
fn opposed() -> Result<f64, Stop> {
    Ok(at(&opposed_ratios(2)?, 1))
}

fn opposed_run() -> Result<RefutingRun, Stop> {
    let ratios = opposed_ratios(10)?;
    let band = frozen_band_with_feedback(0.5, 2.0, 0.25).unwrap_or(f64::NAN);
    Ok(RefutingRun {
        quantity: "m, use of the limit",
        seen: "The robot is ahead of its reference and starts on the edge of the band; one sample later it is outside.",
        said: by_sample(0, &vec![band; ratios.len()]),
        found: by_sample(0, &ratios),
        saying: "1 + a g − Kp Ts at most",
    })
}
