/// SplitMix64: a small generator whose whole state is one word, for the random walk.
///
/// Reproducible on every machine and good enough for directions; not for anything that must be unpredictable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Random {
    word: u64,
}

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self { word: seed }
    }

    /// The constants are those of the published generator (Steele, Lea, Flood 2014).
    fn next_word(&mut self) -> u64 {
        self.word = self.word.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.word;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Every component uniform on [-1/2, 1/2).
    pub(crate) fn vector<const N: usize>(&mut self) -> [f64; N] {
        // The upper 53 bits fill a mantissa: an exact multiple of 2^-53 in [0, 1).
        core::array::from_fn(|_| (self.next_word() >> 11) as f64 * (1.0 / 9_007_199_254_740_992.0) - 0.5)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sequence_is_the_published_one() {
        let mut random = Random::new(1_234_567);
        assert_eq!(random.next_word(), 6_457_827_717_110_365_317);
        assert_eq!(random.next_word(), 3_203_168_211_198_807_973);
    }

    #[test]
    fn components_stay_in_the_box_and_differ() {
        let mut random = Random::new(7);
        for _ in 0..1000 {
            let v: [f64; 3] = random.vector();
            assert!(v.iter().all(|x| (-0.5..0.5).contains(x)) && v[0] != v[1]);
        }
    }

    #[test]
    fn a_component_is_the_fraction_the_word_is_of_all_words() {
        let [x]: [f64; 1] = Random::new(1_234_567).vector();
        // The eleven lowest bits are dropped: 2^-53 at most.
        assert!((x - (6_457_827_717_110_365_317_u64 as f64 / 18_446_744_073_709_551_616.0 - 0.5)).abs() < 3e-16);
    }

    #[test]
    fn components_fill_the_box_evenly() {
        let (mut random, mut sum, mut squares) = (Random::new(7), [0.0; 3], [0.0; 3]);
        let count = 10_000.0;
        for _ in 0..10_000 {
            let v: [f64; 3] = random.vector();
            for i in 0..3 {
                sum[i] += v[i];
                squares[i] += v[i] * v[i];
            }
        }
        for i in 0..3 {
            // Of a uniform variable: variance 1/12, that of its square 1/80 - 1/144 = 1/180. Four standard errors.
            assert!((sum[i] / count).abs() < 4.0 * libm::sqrt(1.0 / 12.0 / count));
            assert!((squares[i] / count - 1.0 / 12.0).abs() < 4.0 * libm::sqrt(1.0 / 180.0 / count));
        }
    }
}
