//! Random paths given by their overspeed alone.

use crate::engine::Choices;

/// `ln g(λ)`, linear between knots, constant outside.
#[derive(Clone, Debug)]
pub struct LogPath {
    places: Vec<f64>,
    logs: Vec<f64>,
}

impl LogPath {
    /// Pieces of 1 to 20 `unit`s, each rising or falling at up to `slope`, inside `[lowest, highest]`.
    pub fn draw(choices: &mut Choices, [lowest, highest]: [f64; 2], slope: f64, unit: f64) -> Self {
        let mut log = if choices.flag() { highest } else { lowest };
        let (mut place, mut path) = (0.0, Self { places: vec![0.0], logs: vec![log] });
        for _ in 0..2 + choices.below(8) {
            let length = choices.between(1.0, 20.0) * unit;
            // Steepest, or anything between.
            let share = (3.0 * (2.0 * choices.unit() - 1.0)).clamp(-1.0, 1.0);
            place += length;
            // Cutting a change short keeps its slope below the limit.
            log = (log + share * slope * length).max(lowest).min(highest);
            path.places.push(place);
            path.logs.push(log);
        }
        path
    }

    /// `g` at a place.
    #[must_use]
    pub fn overspeed(&self, place: f64) -> f64 {
        let after = self.places.partition_point(|&knot| knot <= place);
        let log = match (after.checked_sub(1), self.places.get(after)) {
            (None, _) => self.logs.first().copied().unwrap_or(f64::NAN),
            (Some(last), None) => self.logs.get(last).copied().unwrap_or(f64::NAN),
            (Some(before), Some(&end)) => {
                let (start, low, high) = (self.places[before], self.logs[before], self.logs[after]);
                low + (high - low) * ((place - start) / (end - start))
            }
        };
        log.exp()
    }

    /// Where the last knot is.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.places.last().copied().unwrap_or(f64::NAN)
    }

    /// Total variation of `ln g`.
    #[must_use]
    pub fn variation(&self) -> f64 {
        self.logs.windows(2).map(|log| (log[1] - log[0]).abs()).sum()
    }

    /// `∫ g dλ` from the first knot to the last: every piece in closed form, `Δλ g (e^x - 1) / x` with `x` its rise.
    #[must_use]
    pub fn integral(&self) -> f64 {
        let pieces = self.places.windows(2).zip(self.logs.windows(2));
        pieces
            .map(|(place, log)| {
                let rise = log[1] - log[0];
                let mean = if rise.abs() < 1e-8 { 1.0 + 0.5 * rise } else { rise.exp_m1() / rise };
                (place[1] - place[0]) * log[0].exp() * mean
            })
            .sum()
    }
}
