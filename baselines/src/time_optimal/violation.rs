use slideway_lab::{PathSample, SampledPath};

/// By how much limits are exceeded between the nodes of the grid, as a share of the limit; 0 where they hold.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Violation {
    /// Joint speed.
    pub speed: f64,
    /// Joint acceleration.
    pub acceleration: f64,
}

impl Violation {
    /// Evaluates a profile at the samples between the nodes of piece `index`: `b` is linear in `s` on an interval.
    #[must_use]
    pub fn new(path: &SampledPath, index: usize, b: &[f64]) -> Self {
        let piece = &path.pieces[index];
        let mut worst = Self::default();
        for (k, samples) in piece.between.iter().enumerate() {
            let (left, right) = (&piece.nodes[k], &piece.nodes[k + 1]);
            let slope = (b[k + 1] - b[k]) / (right.s - left.s);
            for sample in samples {
                let here = b[k] + slope * (sample.s - left.s);
                worst = worst.worst(Self {
                    speed: path.slowness(sample) * here.max(0.0).sqrt() - 1.0,
                    acceleration: acceleration_ratio(path, sample, here, 0.5 * slope) - 1.0,
                });
            }
        }
        worst
    }

    /// The larger of each.
    #[must_use]
    pub fn worst(self, other: Self) -> Self {
        Self { speed: self.speed.max(other.speed), acceleration: self.acceleration.max(other.acceleration) }
    }
}

/// Largest `|q' s̈ + q'' b| / limit`; 0 without acceleration limits.
fn acceleration_ratio(path: &SampledPath, sample: &PathSample, b: f64, s_acceleration: f64) -> f64 {
    path.acceleration.iter().flatten().enumerate().fold(0.0, |worst: f64, (i, limit)| {
        worst.max((sample.first[i] * s_acceleration + sample.second[i] * b).abs() / limit)
    })
}
