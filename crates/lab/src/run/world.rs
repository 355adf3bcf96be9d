use crate::disturbances::{Disturbances, Uniform};
use slideway_robot::JointVector;
use std::collections::VecDeque;

/// The robot and the clock around a controller: what it sees, what the drives make of its commands, how long a period lasts.
#[derive(Clone, Debug)]
pub(crate) struct World<const N: usize> {
    noise: f64,
    /// Measured joint positions less the true ones, rad (m), without noise; `None` for no difference.
    offset: Option<JointVector<N>>,
    delay: usize,
    jitter: f64,
    /// Real joint speed per commanded one: 1 for a drive without error.
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

    /// Joint positions as the controller sees them of a robot that stands at `q` now; `None` if it sees `q`. Call it once a sample.
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

    /// Real length of the coming period, s. Call it once a sample.
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
}
