//! Paths and problems for the tests of the bracket.

use slideway_baselines::path_bracket::{End, JointLimits, JointPath, JointPathProblem};

use super::Numbers;

/// One of the ten splines.
pub(crate) struct Stored {
    pub(crate) name: String,
    pub(crate) problem: JointPathProblem,
}

fn numbers(line: &str) -> Vec<f64> {
    line.split_whitespace().map(|word| word.parse().expect("a number")).collect()
}

/// The paths of a file in the format of `data/README.md`.
pub(crate) fn stored(text: &str) -> Vec<Stored> {
    let mut lines = text.lines();
    let mut result = Vec::new();
    while let Some(head) = lines.next() {
        let words: Vec<&str> = head.split_whitespace().collect();
        let (joints, segments): (usize, usize) =
            (words[1].parse().expect("joints"), words[2].parse().expect("segments"));
        let end = |word: &str| if word == "1" { End::Rest } else { End::Free };
        let mut row = || numbers(lines.next().expect("a line"));
        let (knots, speed, lower, upper) = (row(), row(), row(), row());
        let polynomials = |row: Vec<f64>| (0..joints).map(|j| row[4 * j..4 * j + 4].to_vec()).collect();
        let segments = (0..segments).map(|_| polynomials(row())).collect();
        let path = JointPath::new(knots, segments).expect("a path");
        let limits = JointLimits::new(speed, lower, upper).expect("limits");
        let problem = JointPathProblem::new(path, limits, [end(words[3]), end(words[4])]).expect("a problem");
        result.push(Stored { name: words[0].to_owned(), problem });
    }
    result
}

/// Knots, and coefficients by segment and joint.
#[derive(Clone)]
pub(crate) struct Cubics {
    pub(crate) knots: Vec<f64>,
    pub(crate) segments: Vec<Vec<Vec<f64>>>,
}

impl Cubics {
    /// Cubic Hermite segments through values with slopes, one list of either a knot.
    pub(crate) fn hermite(knots: &[f64], values: &[Vec<f64>], slopes: &[Vec<f64>]) -> Self {
        let segment = |i: usize| {
            let h = knots[i + 1] - knots[i];
            let joint = |j: usize| {
                let (q, p) = ([values[i][j], values[i + 1][j]], [slopes[i][j], slopes[i + 1][j]]);
                let rise = (q[1] - q[0]) / h;
                vec![q[0], p[0], (3.0 * rise - 2.0 * p[0] - p[1]) / h, (p[0] + p[1] - 2.0 * rise) / (h * h)]
            };
            (0..values[i].len()).map(joint).collect()
        };
        Self { knots: knots.to_vec(), segments: (0..knots.len() - 1).map(segment).collect() }
    }

    /// Random, once differentiable, slopes between knots as of Catmull and Rom.
    pub(crate) fn random(numbers: &mut Numbers, joints: usize, segments: usize) -> Self {
        let mut knots = vec![0.0];
        for i in 0..segments {
            knots.push(knots[i] + numbers.between(0.4, 1.6));
        }
        let mut list = |size: f64| -> Vec<f64> { (0..joints).map(|_| numbers.between(-size, size)).collect() };
        let values: Vec<Vec<f64>> = (0..=segments).map(|_| list(1.5)).collect();
        // Slopes of the chords between neighbours, as a spline's are about: slopes out of nowhere make paths that nearly stand.
        let slope = |i: usize| {
            let (a, b) = (i.saturating_sub(1), (i + 1).min(segments));
            (0..joints).map(|j| (values[b][j] - values[a][j]) / (knots[b] - knots[a])).collect()
        };
        let slopes: Vec<Vec<f64>> = (0..=segments).map(slope).collect();
        Self::hermite(&knots, &values, &slopes)
    }

    pub(crate) fn path(&self) -> JointPath {
        JointPath::new(self.knots.clone(), self.segments.clone()).expect("a path")
    }

    /// The same curve travelled the other way.
    pub(crate) fn reversed(&self) -> Self {
        let total = self.knots[0] + self.knots[self.knots.len() - 1];
        let knots: Vec<f64> = self.knots.iter().rev().map(|s| total - s).collect();
        let segment = |i: usize| {
            let h = self.knots[i + 1] - self.knots[i];
            // c(h - r) by powers of r.
            let mirrored = |c: &Vec<f64>| {
                let (a, b, c, d) = (c[0], c[1], c[2], c[3]);
                vec![a + h * (b + h * (c + h * d)), -(b + h * (2.0 * c + 3.0 * h * d)), c + 3.0 * h * d, -d]
            };
            self.segments[i].iter().map(mirrored).collect()
        };
        Self { knots, segments: (0..self.segments.len()).rev().map(segment).collect() }
    }

    /// The same curve with the parameter `offset + factor s`, joints in other units.
    pub(crate) fn rescaled(&self, offset: f64, factor: f64, units: f64) -> Self {
        let scale = |c: &Vec<f64>| c.iter().zip(0..).map(|(c, m)| units * c / factor.powi(m)).collect();
        Self {
            knots: self.knots.iter().map(|s| offset + factor * s).collect(),
            segments: self.segments.iter().map(|joints| joints.iter().map(scale).collect()).collect(),
        }
    }

    /// `q'` and `q''` of every joint.
    pub(crate) fn derivatives(&self, s: f64) -> Vec<[f64; 2]> {
        let i = self.knots.partition_point(|k| *k <= s).clamp(1, self.knots.len() - 1) - 1;
        let r = s - self.knots[i];
        let joint = |c: &Vec<f64>| [c[1] + r * (2.0 * c[2] + 3.0 * r * c[3]), 2.0 * c[2] + 6.0 * r * c[3]];
        self.segments[i].iter().map(joint).collect()
    }
}

/// A path of lines with parabolic blends: `q'` turns evenly from one line's direction to the next one's within `half` of each corner; the parameter is the
/// lines' length.
pub(crate) fn blended(points: &[[f64; 2]], half: f64) -> JointPath {
    let mut corners = vec![0.0];
    let mut directions = Vec::new();
    for pair in points.windows(2) {
        let step = [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]];
        let length = step[0].hypot(step[1]);
        directions.push([step[0] / length, step[1] / length]);
        corners.push(corners[corners.len() - 1] + length);
    }
    let (mut knots, mut segments, mut q) = (vec![0.0], Vec::new(), points[0]);
    let count = directions.len();
    for i in 0..count {
        let end = corners[i + 1] - if i + 1 < count { half } else { 0.0 };
        let length = end - knots[knots.len() - 1];
        segments.push((0..2).map(|j| vec![q[j], directions[i][j]]).collect::<Vec<_>>());
        q = [0, 1].map(|j| q[j] + length * directions[i][j]);
        knots.push(end);
        if i + 1 < count {
            let bend = [0, 1].map(|j| 0.25 * (directions[i + 1][j] - directions[i][j]) / half);
            segments.push((0..2).map(|j| vec![q[j], directions[i][j], bend[j]]).collect());
            q = [0, 1].map(|j| q[j] + 2.0 * half * directions[i][j] + 4.0 * half * half * bend[j]);
            knots.push(corners[i + 1] + half);
        }
    }
    JointPath::new(knots, segments).expect("a path")
}
