use slideway_path::{LimitKind, PathSample, SampledPath};

/// By how much limits are exceeded between the nodes of the grid, as a share of the limit (of half the distance of its bounds);
/// 0 where they hold.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Violation {
    /// Joint speed.
    pub speed: f64,
    /// Joint acceleration.
    pub acceleration: f64,
    /// Joint torque.
    pub torque: f64,
    /// Tool speed.
    pub tool_speed: f64,
    /// Tool acceleration.
    pub tool_acceleration: f64,
}

impl Violation {
    /// Evaluates a profile at the samples between the nodes of piece `index`: `b` is linear in `s` on an interval.
    #[must_use]
    pub fn new(path: &SampledPath, index: usize, b: &[f64]) -> Self {
        let intervals = path.pieces[index].between.len();
        (0..intervals).flat_map(|k| at_samples(path, index, b, k)).fold(Self::default(), Self::worst)
    }

    /// The larger of each; not a number counts as infinite.
    #[must_use]
    pub fn worst(self, other: Self) -> Self {
        let worse = |a: f64, b: f64| if a.is_nan() || b.is_nan() { f64::INFINITY } else { a.max(b) };
        Self {
            speed: worse(self.speed, other.speed),
            acceleration: worse(self.acceleration, other.acceleration),
            torque: worse(self.torque, other.torque),
            tool_speed: worse(self.tool_speed, other.tool_speed),
            tool_acceleration: worse(self.tool_acceleration, other.tool_acceleration),
        }
    }

    /// The largest of all.
    #[must_use]
    pub fn largest(&self) -> f64 {
        [self.speed, self.acceleration, self.torque, self.tool_speed, self.tool_acceleration]
            .into_iter()
            .fold(0.0, f64::max)
    }

    fn of(path: &SampledPath, sample: &PathSample, b: f64, s_acceleration: f64) -> Self {
        let mut found = Self::default();
        let rate = b.max(0.0).sqrt();
        let (kind, _) = path.tightest_speed(sample);
        found.raise(kind, path.slowness(sample) * rate - 1.0);
        for (i, limit) in path.acceleration.iter().flatten().enumerate() {
            let value = sample.first[i] * s_acceleration + sample.second[i] * b;
            found.raise(LimitKind::JointAcceleration, value.abs() / limit - 1.0);
        }
        for limit in &sample.limits {
            found.raise(limit.kind, limit.excess(s_acceleration, b));
        }
        found
    }

    fn raise(&mut self, kind: LimitKind, excess: f64) {
        let entry = match kind {
            LimitKind::JointSpeed => &mut self.speed,
            LimitKind::JointAcceleration => &mut self.acceleration,
            LimitKind::JointTorque => &mut self.torque,
            LimitKind::ToolSpeed => &mut self.tool_speed,
            LimitKind::ToolAcceleration => &mut self.tool_acceleration,
        };
        *entry = if excess.is_nan() { f64::INFINITY } else { entry.max(excess) };
    }
}

/// The violations at the samples of one interval, in order.
pub(super) fn at_samples(path: &SampledPath, index: usize, b: &[f64], interval: usize) -> Vec<Violation> {
    let piece = &path.pieces[index];
    let (left, right) = (&piece.nodes[interval], &piece.nodes[interval + 1]);
    let slope = (b[interval + 1] - b[interval]) / (right.s - left.s);
    let here = |s: f64| b[interval] + slope * (s - left.s);
    piece.between[interval].iter().map(|p| Violation::of(path, p, here(p.s), 0.5 * slope)).collect()
}
