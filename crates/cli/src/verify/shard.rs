use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;

/// Most trials of a campaign: they are kept in memory for the results.
pub(crate) const MAX_TRIALS: u64 = 10_000_000;

/// Every `of`-th trial, beginning with number `index - 1`: one share of a campaign that several machines run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub(crate) struct Shard {
    of: u64,
    /// From 1 to `of`.
    index: u64,
}

impl Shard {
    pub(crate) const WHOLE: Self = Self { of: 1, index: 1 };

    pub(crate) fn new(index: u64, of: u64) -> Option<Self> {
        (1..=of).contains(&index).then_some(Self { of, index })
    }

    /// How many shards make the campaign.
    pub(crate) fn of(self) -> u64 {
        self.of
    }

    /// The numbers of its trials, of so many in all.
    pub(crate) fn numbers(self, trials: u64) -> impl Iterator<Item = u64> {
        (self.index - 1..trials).step_by(usize::try_from(self.of).unwrap_or(usize::MAX))
    }

    /// The place of a trial among its own, if it is one of them.
    pub(crate) fn place(self, number: u64, trials: u64) -> Option<usize> {
        let own = number < trials && number % self.of == self.index - 1;
        own.then(|| usize::try_from(number / self.of).ok()).flatten()
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.of)
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers = text.split_once('/').and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
        let shard = numbers.and_then(|(index, of)| Self::new(index, of));
        shard.ok_or_else(|| "write I/N with I from 1 to N, for example 2/5: the second of five".to_owned())
    }
}

impl TryFrom<String> for Shard {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        text.parse()
    }
}

impl From<Shard> for String {
    fn from(shard: Shard) -> Self {
        shard.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shards_of_a_campaign_hold_every_trial_once() {
        for (trials, of) in [(0, 3), (1, 5), (10, 1), (17, 5), (20, 5)] {
            let shards: Vec<Shard> = (1..=of).filter_map(|i| Shard::new(i, of)).collect();
            let mut numbers: Vec<u64> = shards.iter().flat_map(|s| s.numbers(trials)).collect();
            numbers.sort_unstable();
            assert_eq!(numbers, (0..trials).collect::<Vec<_>>(), "{trials} in {of}");
            for shard in shards {
                for (place, number) in shard.numbers(trials).enumerate() {
                    assert_eq!(shard.place(number, trials), Some(place));
                }
            }
        }
        assert_eq!("2/5".parse::<Shard>().map(|s| s.numbers(12).collect::<Vec<_>>()), Ok(vec![1, 6, 11]));
    }

    #[test]
    fn a_number_of_another_shard_or_beyond_the_last_has_no_place() {
        let second = Shard::new(2, 5).expect("a shard");
        assert_eq!((second.place(2, 10), second.place(11, 10)), (None, None));
    }

    #[test]
    fn what_is_no_share_is_refused() {
        for text in ["0/5", "6/5", "a/b", "1", "1/0", "0/0", "-1/5", "1/5/2", ""] {
            assert!(text.parse::<Shard>().is_err_and(|remedy| remedy.contains("I/N")), "{text}");
        }
    }
}
