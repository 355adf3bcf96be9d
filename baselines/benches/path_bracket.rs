//! The bracket of the whole path at three gaps beside the certificate on a grid of 1000 intervals: ten stored splines and 200 random ones.
//!
//! `cargo bench -p slideway-baselines --bench path_bracket`. CPU time of one thread. A table, not a criterion report: what counts is the median over the
//! paths of the quotient of two times measured one after the other. The grid knows symmetric acceleration limits: of unequal ones it gets the upper.

use rustix::time::{ClockId, clock_gettime};
use slideway_baselines::path_bracket::{BracketOptions, End, JointLimits, JointPath, JointPathProblem, PathBracket};
use slideway_baselines::time_optimal::time_optimum;
use slideway_path::{EndRate, PathSample, SampledPath, SampledPiece};

const GAPS: [f64; 3] = [1e-4, 1e-5, 1e-6];
const INTERVALS: usize = 1000;
const RANDOM: u64 = 200;
const SEED: u64 = 90_000;

/// CPU time of a call, s, and its result.
fn timed<T>(call: impl FnOnce() -> T) -> (f64, T) {
    let now = || {
        let t = clock_gettime(ClockId::ThreadCPUTime);
        t.tv_sec as f64 + 1e-9 * t.tv_nsec as f64
    };
    let start = now();
    let result = call();
    (now() - start, result)
}

/// Cubics by segment and joint with limits.
struct Case {
    knots: Vec<f64>,
    segments: Vec<Vec<Vec<f64>>>,
    speed: Vec<f64>,
    lower: Vec<f64>,
    upper: Vec<f64>,
    ends: [End; 2],
}

impl Case {
    fn problem(&self) -> JointPathProblem {
        let path = JointPath::new(self.knots.clone(), self.segments.clone()).expect("a path");
        let limits = JointLimits::new(self.speed.clone(), self.lower.clone(), self.upper.clone()).expect("limits");
        JointPathProblem::new(path, limits, self.ends).expect("a problem")
    }

    fn sampled(&self) -> SampledPath {
        let (from, to) = (self.knots[0], self.knots[self.knots.len() - 1]);
        let node = |k: usize| {
            let s = from + (to - from) * k as f64 / INTERVALS as f64;
            let i = self.knots.partition_point(|knot| *knot <= s).clamp(1, self.segments.len()) - 1;
            let r = s - self.knots[i];
            let first = self.segments[i].iter().map(|c| c[1] + r * (2.0 * c[2] + 3.0 * r * c[3])).collect();
            let second = self.segments[i].iter().map(|c| 2.0 * c[2] + 6.0 * r * c[3]).collect();
            PathSample { s, lambda: s, first, second, ..PathSample::default() }
        };
        let nodes = (0..=INTERVALS).map(node).collect();
        let piece = SampledPiece {
            nodes,
            between: vec![],
            is_self_motion: false,
            start: EndRate::ByLimits,
            end: EndRate::ByLimits,
        };
        // Far above what the accelerations allow stands for no speed limit.
        let speed: Vec<f64> = self.speed.iter().map(|v| v.min(1e3)).collect();
        SampledPath {
            joints: speed.len(),
            speed_lower: speed.iter().map(|v| -v).collect(),
            speed_upper: speed,
            acceleration: self.upper[0].is_finite().then(|| self.upper.clone()),
            pieces: vec![piece],
        }
    }
}

fn stored() -> Vec<Case> {
    let mut lines = include_str!("../tests/data/ten-splines.txt").lines();
    let mut cases = Vec::new();
    while let Some(head) = lines.next() {
        let words: Vec<&str> = head.split_whitespace().collect();
        let (joints, count): (usize, usize) = (words[1].parse().expect("joints"), words[2].parse().expect("segments"));
        let mut row = || -> Vec<f64> {
            let line = lines.next().expect("a line");
            line.split_whitespace().map(|w| w.parse().expect("a number")).collect()
        };
        let (knots, speed, lower, upper) = (row(), row(), row(), row());
        let split = |row: Vec<f64>| (0..joints).map(|j| row[4 * j..4 * j + 4].to_vec()).collect();
        let segments = (0..count).map(|_| split(row())).collect();
        let end = |word: &str| if word == "1" { End::Rest } else { End::Free };
        cases.push(Case { knots, segments, speed, lower, upper, ends: [end(words[3]), end(words[4])] });
    }
    cases
}

/// xorshift64*.
struct Numbers(u64);

impl Numbers {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        let bits = self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 11;
        low + (high - low) * bits as f64 / (1_u64 << 53) as f64
    }
}

/// A natural cubic spline of 1 to 7 joints through 5 to 10 points at distances of their chords; limits symmetric, unequal, of acceleration alone, of speed
/// alone; from rest to rest or, with speed limits, free.
fn random(seed: u64) -> Case {
    let mut n = Numbers(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    let (joints, points) = (1 + (seed % 7) as usize, n.between(5.0, 10.999) as usize);
    let mut list = |count: usize, low: f64, high: f64| (0..count).map(|_| n.between(low, high)).collect::<Vec<f64>>();
    let values: Vec<Vec<f64>> = (0..points).map(|_| list(joints, -1.5, 1.5)).collect();
    let (mut speed, mut upper) = (list(joints, 1.0, 3.0), list(joints, 3.0, 12.0));
    let mut lower: Vec<f64> = upper.iter().map(|u| -u).collect();
    let kind = seed / 7 % 6;
    match kind {
        1 | 4 => lower = list(joints, -12.0, -3.0),
        2 => speed = vec![f64::INFINITY; joints],
        5 => (lower, upper) = (vec![f64::NEG_INFINITY; joints], vec![f64::INFINITY; joints]),
        _ => {}
    }
    let ends = if kind >= 3 { [End::Free; 2] } else { [End::Rest; 2] };
    let mut knots = vec![0.0];
    for pair in values.windows(2) {
        let chord = pair[0].iter().zip(&pair[1]).map(|(a, b)| (b - a) * (b - a)).sum::<f64>().sqrt();
        knots.push(knots[knots.len() - 1] + chord);
    }
    let columns: Vec<Vec<Vec<f64>>> =
        (0..joints).map(|j| natural(&knots, &values.iter().map(|v| v[j]).collect::<Vec<f64>>())).collect();
    let segments = (0..points - 1).map(|i| columns.iter().map(|c| c[i].clone()).collect()).collect();
    Case { knots, segments, speed, lower, upper, ends }
}

/// Coefficients of a natural spline by segment; Thomas's algorithm for the second derivatives.
fn natural(knots: &[f64], q: &[f64]) -> Vec<Vec<f64>> {
    let count = q.len();
    let h = |i: usize| knots[i + 1] - knots[i];
    let (mut factor, mut value, mut bends) = (vec![0.0; count], vec![0.0; count], vec![0.0; count]);
    for i in 1..count - 1 {
        let right = 6.0 * ((q[i + 1] - q[i]) / h(i) - (q[i] - q[i - 1]) / h(i - 1));
        let pivot = 2.0 * (h(i - 1) + h(i)) - h(i - 1) * factor[i - 1];
        factor[i] = h(i) / pivot;
        value[i] = (right - h(i - 1) * value[i - 1]) / pivot;
    }
    for i in (1..count - 1).rev() {
        bends[i] = value[i] - factor[i] * bends[i + 1];
    }
    let segment = |i: usize| {
        let slope = (q[i + 1] - q[i]) / h(i) - h(i) * (2.0 * bends[i] + bends[i + 1]) / 6.0;
        vec![q[i], slope, 0.5 * bends[i], (bends[i + 1] - bends[i]) / (6.0 * h(i))]
    };
    (0..count - 1).map(segment).collect()
}

/// The value that a share of a list is not above.
fn quantile(values: &mut [f64], share: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(((values.len() - 1) as f64 * share) as usize).copied().unwrap_or(f64::NAN)
}

fn table(name: &str, cases: &[Case]) {
    let mut grid = Vec::new();
    let mut times = vec![Vec::new(); GAPS.len()];
    let mut quotients = vec![Vec::new(); GAPS.len()];
    let mut reached = [0; GAPS.len()];
    for case in cases {
        let (problem, sampled) = (case.problem(), case.sampled());
        let (on_grid, optimum) = timed(|| time_optimum(&sampled));
        let optimum = optimum.is_ok();
        grid.push(1e3 * on_grid);
        for (i, gap) in GAPS.into_iter().enumerate() {
            let options = BracketOptions { gap, ..BracketOptions::default() };
            let (time, bracket) = timed(|| PathBracket::solve(&problem, &options));
            reached[i] += usize::from(bracket.is_ok_and(|b| b.certified));
            times[i].push(1e3 * time);
            if optimum {
                quotients[i].push(time / on_grid);
            }
        }
    }
    println!("{name}: certificate on {INTERVALS} intervals, CPU ms: median {:.1}", quantile(&mut grid, 0.5));
    for (i, gap) in GAPS.iter().enumerate() {
        println!(
            "  gap {gap:e}: {} of {} reached; CPU ms median {:.1}, 90 % {:.1}, most {:.1}; over the grid's time median {:.3}, 90 % {:.3}",
            reached[i],
            cases.len(),
            quantile(&mut times[i], 0.5),
            quantile(&mut times[i], 0.9),
            quantile(&mut times[i], 1.0),
            quantile(&mut quotients[i], 0.5),
            quantile(&mut quotients[i], 0.9),
        );
    }
}

fn main() {
    // `cargo test --benches` only asks whether it starts.
    if std::env::args().any(|argument| argument == "--test") {
        return;
    }
    table("ten stored splines", &stored());
    let cases: Vec<Case> = (SEED..SEED + RANDOM).map(random).collect();
    table("200 random splines", &cases);
}
