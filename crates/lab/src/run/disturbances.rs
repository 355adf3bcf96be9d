use crate::error::{Fault, LabError, ListOf};
use crate::scenario::schema::DisturbancesTable;
use rand::{RngExt, SeedableRng};
use rand_xorshift::XorShiftRng;
use serde::Serialize;
use slideway_robot::JointVector;
use std::collections::VecDeque;
use std::fmt;

/// What happens in a run and the controller does not know of: the table `[disturbances]` of a speed scenario. By default nothing.
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
pub(crate) const MOST_NOISE: f64 = 1.0;
/// A drive that stands still or runs at twice its command is no model error any more.
pub(crate) const MOST_SPEED_ERROR: f64 = 0.99;
/// A second at a millisecond.
pub(crate) const MOST_DELAY: u32 = 1000;
/// Time goes forwards.
pub(crate) const MOST_JITTER: f64 = 0.99;

impl fmt::Display for Disturbances {
    /// What disturbs the runs, in words, apart from the seed.
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
    /// Whether there are none.
    #[must_use]
    pub fn are_none(&self) -> bool {
        let zero = |list: &Vec<f64>| list.iter().all(|e| *e == 0.0);
        let lists = [&self.initial_error, &self.joint_offset, &self.speed_error];
        lists.into_iter().all(zero) && !self.are_random() && self.delay == 0
    }

    /// Whether the seed changes anything.
    #[must_use]
    pub fn are_random(&self) -> bool {
        self.joint_noise != 0.0 || self.jitter != 0.0
    }

    /// What a scenario says, for an arm of `joints` joints.
    pub(crate) fn read(table: &DisturbancesTable, joints: usize) -> Result<Self, LabError> {
        let list = |numbers: &Option<Vec<_>>| -> Vec<f64> {
            numbers.iter().flatten().map(|n: &crate::scenario::number::Number| n.0).collect()
        };
        let disturbances = Self {
            seed: table.seed.unwrap_or(0),
            initial_error: list(&table.initial_error),
            joint_noise: table.joint_noise.map_or(0.0, |n| n.0),
            joint_offset: list(&table.joint_offset),
            speed_error: list(&table.speed_error),
            delay: table.delay.unwrap_or(0),
            jitter: table.jitter.map_or(0.0, |j| j.0),
        };
        let given = [
            ("initial_error", &table.initial_error),
            ("joint_offset", &table.joint_offset),
            ("speed_error", &table.speed_error),
        ];
        if let Some((key, _)) = given.into_iter().find(|(_, list)| list.as_ref().is_some_and(Vec::is_empty)) {
            let fault = Fault::WrongLength { found: 0, expected: joints, list: ListOf::Joints };
            return Err(LabError::value(format!("disturbances.{key}"), fault));
        }
        disturbances.check(joints)?;
        Ok(disturbances)
    }

    /// Whether they can be meant for an arm of `joints` joints; NaN cannot.
    pub(crate) fn check(&self, joints: usize) -> Result<(), LabError> {
        for (key, list, most) in [
            ("initial_error", &self.initial_error, f64::MAX),
            ("joint_offset", &self.joint_offset, MOST_NOISE),
            ("speed_error", &self.speed_error, MOST_SPEED_ERROR),
        ] {
            if !list.is_empty() && list.len() != joints {
                let fault = Fault::WrongLength { found: list.len(), expected: joints, list: ListOf::Joints };
                return Err(LabError::value(format!("disturbances.{key}"), fault));
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
pub(crate) fn within(key: &str, value: f64, least: f64, most: f64) -> Result<(), LabError> {
    if (least..=most).contains(&value) {
        return Ok(());
    }
    Err(LabError::value(format!("disturbances.{key}"), Fault::OutOfRange { value, least, most }))
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

/// The robot and the clock around a controller: what it sees, what the drives make of its commands, how long a period lasts.
#[derive(Clone, Debug)]
pub(crate) struct World<const N: usize> {
    noise: f64,
    /// What the controller takes joints to be beyond where they are, rad (m); `None` for nothing.
    offset: Option<JointVector<N>>,
    delay: usize,
    jitter: f64,
    /// What the drives make of one rad/s, one m/s.
    gain: JointVector<N>,
    measurements: VecDeque<JointVector<N>>,
    measuring: Uniform,
    clock: Uniform,
}

impl<const N: usize> World<N> {
    pub(crate) fn new(disturbances: &Disturbances) -> Self {
        Self {
            noise: disturbances.joint_noise,
            offset: (disturbances.joint_offset.iter().any(|o| *o != 0.0))
                .then(|| of_joints(&disturbances.joint_offset)),
            delay: disturbances.delay as usize,
            jitter: disturbances.jitter,
            gain: of_joints::<N>(&disturbances.speed_error).map(|error| 1.0 + error),
            measurements: VecDeque::new(),
            measuring: Uniform::new(disturbances.seed, 0),
            clock: Uniform::new(disturbances.seed, 1),
        }
    }

    /// What the controller sees of a robot that stands at `q` now; `None` if that is the truth. Call it once a sample.
    pub(crate) fn measure(&mut self, q: &JointVector<N>) -> Option<JointVector<N>> {
        if self.noise == 0.0 && self.delay == 0 && self.offset.is_none() {
            return None;
        }
        let noise = self.noise;
        let measured = self.offset.map_or(*q, |offset| q + offset).map(|q| q + noise * self.measuring.next());
        self.measurements.push_back(measured);
        if self.measurements.len() > self.delay + 1 {
            self.measurements.pop_front();
        }
        self.measurements.front().copied()
    }

    /// The speeds at which the joints really move.
    pub(crate) fn moved(&self, commanded: JointVector<N>) -> JointVector<N> {
        commanded.component_mul(&self.gain)
    }

    /// How long the coming period really lasts, s. Call it once a sample.
    pub(crate) fn period(&mut self, nominal: f64) -> f64 {
        if self.jitter == 0.0 { nominal } else { nominal * (1.0 + self.jitter * self.clock.next()) }
    }
}

/// One number per joint, zero where the list is empty.
fn of_joints<const N: usize>(list: &[f64]) -> JointVector<N> {
    JointVector::from_fn(|i, _| list.get(i).copied().unwrap_or(0.0))
}

/// Where the robot really starts.
pub(crate) fn displaced<const N: usize>(start: &JointVector<N>, disturbances: &Disturbances) -> JointVector<N> {
    let mut q = *start;
    for (q, error) in q.iter_mut().zip(&disturbances.initial_error) {
        // Not `-0.0 + 0.0`, which is not the bits of `-0.0`.
        if *error != 0.0 {
            *q += error;
        }
    }
    q
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_delayed_measurement_is_the_one_of_that_many_samples_before() {
        let mut world = World::<1>::new(&Disturbances { delay: 2, ..Disturbances::default() });
        let seen: Vec<f64> =
            (0..5).filter_map(|k| world.measure(&JointVector::from([f64::from(k)]))).map(|q| q[0]).collect();
        assert_eq!(seen, [0.0, 0.0, 0.0, 1.0, 2.0]);
    }

    #[test]
    fn zeros_that_are_off_shift_what_is_seen_and_nothing_that_moves() {
        let world = World::<2>::new(&Disturbances { joint_offset: vec![0.25, -0.5], ..Disturbances::default() });
        let seen = world.clone().measure(&JointVector::from([1.0, 2.0]));
        assert_eq!(seen, Some(JointVector::from([1.25, 1.5])));
        assert_eq!(world.moved(JointVector::from([1.0, 2.0])), JointVector::from([1.0, 2.0]));
    }

    #[test]
    fn noise_and_jitter_stay_inside_what_was_asked_and_do_not_share_a_sequence() {
        let disturbances = Disturbances { seed: 5, joint_noise: 0.01, jitter: 0.3, ..Disturbances::default() };
        let mut both = World::<2>::new(&disturbances);
        let mut noise_only = World::<2>::new(&Disturbances { jitter: 0.0, ..disturbances.clone() });
        let (mut widest, mut longest) = (0.0_f64, 0.0_f64);
        for _ in 0..1000 {
            let (seen, alone) = (both.measure(&JointVector::zeros()), noise_only.measure(&JointVector::zeros()));
            assert_eq!(seen, alone);
            widest = seen.map_or(widest, |q| widest.max(q.amax()));
            longest = longest.max((both.period(1e-3) / 1e-3 - 1.0).abs());
        }
        // 2000 uniform draws leave the outer tenth of their range empty with probability 0.9^2000.
        assert!(widest <= 0.01 && widest > 0.009 && longest <= 0.3 && longest > 0.27);
    }

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
