use super::disturbances::TrialDisturbances;
use crate::options::VerifyOptions;
use rand::{Rng, RngExt, SeedableRng};
use rand_xorshift::XorShiftRng;

/// Kinds of disturbances.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    InitialError,
    JointNoise,
    JointOffset,
    SpeedError,
    DistanceNoise,
    Delay,
    Jitter,
}

impl Kind {
    /// True if a trial has a disturbance of this kind.
    pub(crate) fn is_in(self, disturbances: &TrialDisturbances) -> bool {
        match self {
            Self::InitialError => disturbances.initial_error.is_some(),
            Self::JointNoise => disturbances.joint_noise.is_some(),
            Self::JointOffset => disturbances.joint_offset.is_some(),
            Self::SpeedError => disturbances.speed_error.is_some(),
            Self::DistanceNoise => disturbances.distance_noise.is_some(),
            Self::Delay => disturbances.delay.is_some(),
            Self::Jitter => disturbances.jitter.is_some(),
        }
    }
}

/// The greatest of each kind of disturbance; kinds that are not wanted are not in the list.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Ranges {
    /// Numbers that a disturbance per joint, or per coordinate, has.
    axes: usize,
    greatest: Vec<(Kind, f64)>,
}

impl Ranges {
    /// Around a speed scenario: an arm set up within 3 degrees, encoders of 0.1 mrad, zeros
    /// of 1 mrad, drives of 2 %, two samples of transport, a period
    /// within a fifth. Where no joint goes as far as 1 rad (1 m), `extent` is how far the farthest goes, and start and encoders are
    /// finer in proportion: a motion of a tenth of a millimetre is not run on an arm that is 3 degrees off.
    pub(crate) fn of_speed(options: &VerifyOptions, joints: usize, extent: f64) -> Self {
        let fine = extent.min(1.0);
        Self::new(
            joints,
            [
                (Kind::InitialError, options.initial_error.unwrap_or(0.05 * fine)),
                (Kind::JointNoise, options.joint_noise.unwrap_or(1e-4 * fine)),
                (Kind::JointOffset, options.joint_offset.unwrap_or(1e-3 * fine)),
                (Kind::SpeedError, options.speed_error.unwrap_or(0.02)),
                (Kind::Delay, options.delay.map_or(2.0, f64::from)),
                (Kind::Jitter, options.jitter.unwrap_or(0.2)),
            ],
        )
    }

    /// Around a conditioning scenario whose reference has extent `extent`, m: a start within a hundredth of it, distances to 0.1 mm, two
    /// samples of transport, a period within a fifth.
    pub(crate) fn of_conditioning(options: &VerifyOptions, extent: f64) -> Self {
        Self::new(
            3,
            [
                (Kind::InitialError, options.initial_error.unwrap_or(0.01 * extent)),
                (Kind::DistanceNoise, options.distance_noise.unwrap_or(1e-4)),
                (Kind::Delay, options.delay.map_or(2.0, f64::from)),
                (Kind::Jitter, options.jitter.unwrap_or(0.2)),
            ],
        )
    }

    fn new<const K: usize>(axes: usize, greatest: [(Kind, f64); K]) -> Self {
        Self { axes, greatest: greatest.into_iter().filter(|(_, most)| *most > 0.0).collect() }
    }
}

/// The disturbances of one trial: what they would be at size 1, and the size they have.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Draw {
    /// Seed of noise and jitter. 53 bits, so that no reader of JSON rounds it.
    seed: u64,
    size: f64,
    parts: Vec<Part>,
}

#[derive(Clone, Debug, PartialEq)]
struct Part {
    kind: Kind,
    full: Vec<f64>,
}

impl Draw {
    /// Number `number` of the campaign with seed `seed`: a function of these alone.
    ///
    /// Half the trials have a single kind of disturbance, at its whole range times the size; the others have each kind with a share of
    /// its own.
    pub(crate) fn new(seed: u64, number: u64, ranges: &Ranges) -> Self {
        // An odd multiplier keeps campaigns apart; the generator hashes the word before it uses it.
        let mut random = XorShiftRng::seed_from_u64(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15).wrapping_add(number));
        // Drawn from [0, 1): the sizes are above 0 and reach 1.
        let mut share = || 1.0 - random.random::<f64>();
        let size = share();
        let count = ranges.greatest.len();
        #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let only = (share() > 0.5).then(|| ((share() * count as f64).ceil() as usize).clamp(1, count.max(1)) - 1);
        let parts = ranges.greatest.iter().enumerate().filter_map(|(i, &(kind, most))| {
            let own = share();
            let axes: Vec<f64> = (0..ranges.axes).map(|_| 2.0 * share() - 1.0).collect();
            let reach = most * if only.is_some() { 1.0 } else { own };
            let full = match kind {
                Kind::InitialError | Kind::JointOffset | Kind::SpeedError => {
                    axes.iter().map(|axis| reach * axis).collect()
                }
                Kind::JointNoise | Kind::DistanceNoise | Kind::Delay | Kind::Jitter => vec![reach],
            };
            only.is_none_or(|only| only == i).then_some(Part { kind, full })
        });
        let parts = parts.collect();
        Self { size, parts, seed: random.next_u64() >> 11 }
    }

    pub(crate) fn size(&self) -> f64 {
        self.size
    }

    pub(crate) fn kinds(&self) -> Vec<Kind> {
        self.parts.iter().map(|part| part.kind).collect()
    }

    /// The same trial at another size.
    pub(crate) fn at(&self, size: f64) -> Self {
        Self { size, ..self.clone() }
    }

    /// The same trial with only some of its kinds.
    pub(crate) fn with_only(&self, keep: impl Fn(Kind) -> bool) -> Self {
        Self { parts: self.parts.iter().filter(|part| keep(part.kind)).cloned().collect(), ..self.clone() }
    }

    /// The disturbances at this size: what is zero is left out.
    pub(crate) fn disturbances(&self) -> TrialDisturbances {
        let list = |kind| self.part(kind).map(|_| self.list(kind)).filter(|_| self.size > 0.0);
        let number = |kind| Some(self.number(kind)).filter(|number| *number > 0.0);
        let mut found = TrialDisturbances {
            delay: Some(self.samples()).filter(|delay| *delay > 0),
            distance_noise: number(Kind::DistanceNoise),
            initial_error: list(Kind::InitialError),
            jitter: number(Kind::Jitter),
            joint_noise: number(Kind::JointNoise),
            joint_offset: list(Kind::JointOffset),
            seed: None,
            speed_error: list(Kind::SpeedError),
        };
        let is_random = found.joint_noise.or(found.distance_noise).or(found.jitter).is_some();
        found.seed = is_random.then_some(self.seed);
        found
    }

    fn part(&self, kind: Kind) -> Option<&Part> {
        self.parts.iter().find(|part| part.kind == kind)
    }

    fn list(&self, kind: Kind) -> Vec<f64> {
        self.part(kind).map_or_else(Vec::new, |part| part.full.iter().map(|full| self.size * full).collect())
    }

    fn number(&self, kind: Kind) -> f64 {
        self.list(kind).first().copied().unwrap_or(0.0)
    }

    /// The delay in whole samples.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    fn samples(&self) -> u32 {
        self.number(Kind::Delay).round() as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn draws() -> Vec<Draw> {
        let ranges = Ranges::of_speed(&VerifyOptions::default(), 6, 2.0);
        (0..1000).map(|number| Draw::new(7, number, &ranges)).collect()
    }

    #[test]
    fn draws_stay_inside_their_ranges_and_scale_with_their_size() {
        for draw in draws() {
            let (whole, half) =
                (draw.disturbances().for_speed(), draw.at(0.5 * draw.size()).disturbances().for_speed());
            let s = draw.size();
            assert!(s > 0.0 && s <= 1.0);
            assert!(whole.initial_error.iter().all(|e| e.abs() <= 0.05 * s));
            assert!(whole.joint_offset.iter().all(|o| o.abs() <= 1e-3 * s));
            assert!(whole.speed_error.iter().all(|e| e.abs() <= 0.02 * s));
            assert!(whole.joint_noise <= 1e-4 * s && whole.jitter <= 0.2 * s && whole.delay <= 2);
            // Halving is exact.
            assert_eq!(half.joint_noise, 0.5 * whole.joint_noise);
            assert!(half.initial_error.iter().zip(&whole.initial_error).all(|(h, w)| *h == 0.5 * w));
            assert!(half.delay <= whole.delay);
        }
    }

    #[test]
    fn half_of_the_trials_have_one_kind_and_every_kind_comes_alone() {
        let draws = draws();
        let alone: Vec<Kind> = draws.iter().map(Draw::kinds).filter(|k| k.len() == 1).map(|k| k[0]).collect();
        // 1000 fair coins: 500 with a deviation of 16; 90 is more than five of them.
        assert!((410..590).contains(&alone.len()), "{}", alone.len());
        let all =
            [Kind::InitialError, Kind::JointNoise, Kind::JointOffset, Kind::SpeedError, Kind::Delay, Kind::Jitter];
        for kind in all {
            assert!(alone.contains(&kind), "{kind:?}");
        }
        assert!(draws.iter().all(|draw| matches!(draw.kinds().len(), 1 | 6)));
    }

    #[test]
    fn numbers_and_seeds_of_campaigns_lead_to_trials_of_their_own() {
        let ranges = Ranges::of_speed(&VerifyOptions::default(), 2, 2.0);
        assert_eq!(Draw::new(1, 4, &ranges), Draw::new(1, 4, &ranges));
        assert_ne!(Draw::new(1, 4, &ranges), Draw::new(1, 5, &ranges));
        assert_ne!(Draw::new(1, 4, &ranges), Draw::new(2, 4, &ranges));
    }

    #[test]
    fn a_range_of_zero_leaves_its_kind_out() {
        let options = VerifyOptions { delay: Some(0), jitter: Some(0.0), ..VerifyOptions::default() };
        let ranges = Ranges::of_speed(&options, 2, 2.0);
        for number in 0..100 {
            let found = Draw::new(1, number, &ranges).disturbances();
            assert!(found.delay.is_none() && found.jitter.is_none());
        }
    }
}
