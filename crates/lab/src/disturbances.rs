use rand::{RngExt, SeedableRng};
use rand_xorshift::XorShiftRng;
use serde::Serialize;
use slideway_path::{Fault, ListOf, ProblemError};
use std::fmt;

/// Disturbances of a run that the controller does not know of: the table `[disturbances]` of a speed scenario. By default none.
///
/// Optimum, certificate and what is known in advance stay those of the undisturbed problem; so do constant speed and natural
/// motion, in which the arm is exactly on the path. A trace tells the truth: positions, errors, times and arrival are those of the robot
/// itself, the demand is what the controller made of what it saw.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Disturbances {
    /// Seed of noise and jitter, which draw from sequences of their own.
    pub seed: u64,
    /// Added to the configuration at the start, rad (m), one per joint; empty for none.
    pub initial_error: Vec<f64>,
    /// Greatest noise of a measured joint position, rad (m): uniform, drawn anew for every joint and sample.
    pub joint_noise: f64,
    /// Error of the joints' zeros, rad (m), one per joint, empty for none: the controller takes joint `i` to be at `q_i + o_i`, so that its
    /// kinematic model is wrong.
    pub joint_offset: Vec<f64>,
    /// Error of the drives, one per joint, empty for none: joint `i` moves at `1 + e_i` times the commanded speed.
    pub speed_error: Vec<f64>,
    /// Samples by which measured joint positions are late. Before the start the robot stood still.
    pub delay: u32,
    /// Share of the sampling period by which a period may be longer or shorter, uniform: it lasts `Ts (1 + jitter r)` with `r` in [-1, 1),
    /// while the controller counts on `Ts`.
    pub jitter: f64,
}

/// More than a radian (a metre) of noise is no measurement.
pub const MOST_NOISE: f64 = 1.0;
/// A drive that stands still or runs at twice its command is no model error any more.
pub const MOST_SPEED_ERROR: f64 = 0.99;
/// A second at a millisecond.
pub const MOST_DELAY: u32 = 1000;
/// Time goes forwards.
pub const MOST_JITTER: f64 = 0.99;

impl fmt::Display for Disturbances {
    /// Lists the disturbances in words, apart from the seed.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let largest = |list: &[f64]| list.iter().fold(0.0_f64, |most, e| most.max(e.abs()));
        let words = [
            (largest(&self.initial_error), "start off by up to {} rad (m)"),
            (self.joint_noise, "measured joints off by up to {} rad (m)"),
            (largest(&self.joint_offset), "zeros of joints off by up to {} rad (m)"),
            (100.0 * largest(&self.speed_error), "drives off by up to {} %"),
            (f64::from(self.delay), "measurements late by {} samples"),
            (100.0 * self.jitter, "periods off by up to {} %"),
        ];
        in_words(f, &words)
    }
}

/// The phrases whose number is not zero, with the number in place of `{}`.
pub(crate) fn in_words(f: &mut fmt::Formatter<'_>, words: &[(f64, &str)]) -> fmt::Result {
    let there = words.iter().filter(|(number, _)| *number != 0.0);
    // Percentages are rounded products: nine decimals are more than anyone types.
    let shown = |number: f64| ((number * 1e9).round() / 1e9).to_string();
    let phrases: Vec<String> = there.map(|(number, phrase)| phrase.replace("{}", &shown(*number))).collect();
    f.write_str(&phrases.join(", "))
}

impl Disturbances {
    /// True if there are no disturbances.
    #[must_use]
    pub fn are_none(&self) -> bool {
        let zero = |list: &Vec<f64>| list.iter().all(|e| *e == 0.0);
        let lists = [&self.initial_error, &self.joint_offset, &self.speed_error];
        lists.into_iter().all(zero) && !self.are_random() && self.delay == 0
    }

    /// True if the seed changes anything.
    #[must_use]
    pub fn are_random(&self) -> bool {
        self.joint_noise != 0.0 || self.jitter != 0.0
    }

    /// Refuses what cannot be meant for an arm of `joints` joints; NaN cannot.
    ///
    /// # Errors
    ///
    /// The first value that no scenario may have, with its key.
    pub fn check(&self, joints: usize) -> Result<(), ProblemError> {
        for (key, list, most) in [
            ("initial_error", &self.initial_error, f64::MAX),
            ("joint_offset", &self.joint_offset, MOST_NOISE),
            ("speed_error", &self.speed_error, MOST_SPEED_ERROR),
        ] {
            if !list.is_empty() && list.len() != joints {
                let fault = Fault::WrongLength { found: list.len(), expected: joints, list: ListOf::Joints };
                return Err(ProblemError::value(format!("disturbances.{key}"), fault));
            }
            for (i, value) in list.iter().enumerate() {
                within(&format!("{key}.{i}"), *value, -most, most)?;
            }
        }
        within("joint_noise", self.joint_noise, 0.0, MOST_NOISE)?;
        within("delay", self.delay.into(), 0.0, MOST_DELAY.into())?;
        within("jitter", self.jitter, 0.0, MOST_JITTER)
    }
}

/// Refuses a value of the table outside a range; NaN is outside.
pub(crate) fn within(key: &str, value: f64, least: f64, most: f64) -> Result<(), ProblemError> {
    if (least..=most).contains(&value) {
        return Ok(());
    }
    Err(ProblemError::value(format!("disturbances.{key}"), Fault::OutOfRange { value, least, most }))
}

/// Numbers that are uniform on [-1, 1), the same on every machine.
#[derive(Clone, Debug)]
pub(crate) struct Uniform(XorShiftRng);

impl Uniform {
    /// A sequence of its own for each of several uses of one seed.
    pub(crate) fn new(seed: u64, use_number: u64) -> Self {
        // An odd multiplier keeps different seeds apart; the generator hashes the word before it uses it.
        Self(XorShiftRng::seed_from_u64(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15).wrapping_add(use_number)))
    }

    pub(crate) fn next(&mut self) -> f64 {
        2.0 * self.0.random::<f64>() - 1.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_a_number_is_refused() {
        for bad in [
            Disturbances { joint_noise: f64::NAN, ..Disturbances::default() },
            Disturbances { jitter: f64::NAN, ..Disturbances::default() },
            Disturbances { initial_error: vec![f64::NAN], ..Disturbances::default() },
            Disturbances { initial_error: vec![f64::INFINITY], ..Disturbances::default() },
            Disturbances { joint_offset: vec![f64::NAN], ..Disturbances::default() },
            Disturbances { speed_error: vec![-1.0], ..Disturbances::default() },
            Disturbances { speed_error: vec![0.0; 2], ..Disturbances::default() },
        ] {
            assert!(bad.check(1).is_err(), "{bad:?}");
        }
    }
}
