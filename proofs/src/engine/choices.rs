/// The numbers in [0, 1) from which one case is built, in the order in which an engine asks for them.
///
/// A case *is* its list of choices: it can be written down, replayed, changed a little (the attack does) and made simpler.
#[derive(Clone, Debug)]
pub struct Choices {
    given: Vec<f64>,
    used: Vec<f64>,
    random: SplitMix,
}

impl Choices {
    /// Case number `case` of the sequence `seed`. Cases do not depend on one another, so any number of threads gives the same.
    #[must_use]
    pub fn random(seed: u64, case: u64) -> Self {
        let mut mixed = SplitMix(seed);
        let random = SplitMix(mixed.next() ^ case.wrapping_mul(GOLDEN));
        Self { given: Vec::new(), used: Vec::new(), random }
    }

    /// The given choices first, then those of a fixed random sequence. Numbers outside [0, 1) are brought inside.
    #[must_use]
    pub fn replay(given: &[f64]) -> Self {
        Self { given: given.to_vec(), ..Self::random(0, 0) }
    }

    /// Numbers that have been handed out so far.
    #[must_use]
    pub fn used(&self) -> &[f64] {
        &self.used
    }

    /// A number in [0, 1).
    #[allow(clippy::manual_clamp)]
    pub fn unit(&mut self) -> f64 {
        let fresh = self.random.unit();
        let wanted = self.given.get(self.used.len()).copied().unwrap_or(fresh);
        // `max` first: it turns NaN into 0.
        let unit = wanted.max(0.0).min(1.0 - f64::EPSILON);
        self.used.push(unit);
        unit
    }

    /// A number in [0, 1], each end met once in ten cases.
    pub fn share(&mut self) -> f64 {
        (1.25 * self.unit() - 0.125).clamp(0.0, 1.0)
    }

    /// A number in [low, high).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + self.unit() * (high - low)
    }

    /// `10^x` with `x` in [low, high).
    pub fn decade(&mut self, low: f64, high: f64) -> f64 {
        10f64.powf(self.between(low, high))
    }

    /// A whole number below `count`; 0 if `count` is.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    pub fn below(&mut self, count: usize) -> usize {
        ((self.unit() * count as f64) as usize).min(count.saturating_sub(1))
    }

    /// True or false.
    pub fn flag(&mut self) -> bool {
        self.unit() >= 0.5
    }

    /// 1 or -1.
    pub fn sign(&mut self) -> f64 {
        if self.flag() { -1.0 } else { 1.0 }
    }

    /// One of the values.
    pub fn pick<T: Copy, const N: usize>(&mut self, values: [T; N]) -> T {
        const { assert!(N > 0, "there is something to pick") };
        values[self.below(N)]
    }

    /// Any double at all, NaNs, infinities and subnormal numbers included.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    pub fn bits(&mut self) -> f64 {
        let high = (self.unit() * TWO_32) as u64;
        let low = (self.unit() * TWO_32) as u64;
        f64::from_bits(high << 32 | low)
    }

    /// `N` numbers in [low, high).
    pub fn numbers<const N: usize>(&mut self, low: f64, high: f64) -> [f64; N] {
        std::array::from_fn(|_| self.between(low, high))
    }
}

const TWO_32: f64 = 4_294_967_296.0;
const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

/// The generator of Steele, Lea and Flood (2014): one word of state, so that every case has a generator of its own. Written out
/// because the numbers of the ledger must be the same with every version of every library.
#[derive(Clone, Copy, Debug)]
struct SplitMix(u64);

impl SplitMix {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(GOLDEN);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 * (f64::EPSILON / 2.0)
    }
}

#[cfg(test)]
mod tests {
    use super::Choices;

    #[test]
    fn a_case_is_its_choices() {
        let mut first = Choices::random(3, 14);
        let drawn: [f64; 4] = first.numbers(-1.0, 1.0);
        let mut again = Choices::replay(first.used());
        assert_eq!(again.numbers::<4>(-1.0, 1.0), drawn);
    }

    #[test]
    fn neighbouring_cases_and_seeds_have_nothing_in_common() {
        let first = |seed, case| Choices::random(seed, case).unit();
        assert!(first(1, 0) != first(1, 1) && first(1, 1) != first(2, 1) && first(1, 0) != first(0, 1));
    }

    #[test]
    fn choices_that_are_no_numbers_are_brought_inside() {
        let mut choices = Choices::replay(&[f64::NAN, 2.0, -1.0]);
        assert_eq!([choices.unit(), choices.unit(), choices.unit()], [0.0, 1.0 - f64::EPSILON, 0.0]);
    }
}
