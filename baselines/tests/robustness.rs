//! Short motions, joints that hardly move, limits of very different size, any unit and any scale of the parameter: both
//! solvers answer, and agree with the closed form where there is one.

mod support;

use slideway_baselines::time_optimal::{TimeOptimum, reachable_profile, time_optimum};
use slideway_path::{PathSample, SampledPath};
use support::{Spline, one_piece, violation_at_nodes};

/// A motion between two points with limits per joint.
struct Motion {
    distance: Vec<f64>,
    speed: Vec<f64>,
    acceleration: Vec<f64>,
}

impl Motion {
    /// Along the straight line, `unit` in units per rad, `s` from 0 to `length`.
    fn straight(&self, intervals: usize, unit: f64, length: f64) -> SampledPath {
        let joints = self.distance.len();
        let line = Spline::natural(vec![vec![0.0; joints], self.distance.iter().map(|d| d * unit).collect()]);
        self.path(&line, intervals, unit, length)
    }

    /// With the clamped cubic: the path's own rate is 0 at the ends.
    fn clamped(&self, intervals: usize, unit: f64, length: f64) -> SampledPath {
        let to = self.distance.iter().map(|d| d * unit).collect();
        self.path(&Spline::clamped(vec![0.0; self.distance.len()], to), intervals, unit, length)
    }

    fn path(&self, spline: &Spline, intervals: usize, unit: f64, length: f64) -> SampledPath {
        SampledPath {
            joints: self.distance.len(),
            speed_lower: self.speed.iter().map(|v| -v * unit).collect(),
            speed_upper: self.speed.iter().map(|v| v * unit).collect(),
            acceleration: Some(self.acceleration.iter().map(|a| a * unit).collect()),
            pieces: vec![spline.piece(intervals, 0, length)],
        }
    }

    /// The rate and acceleration that the limits leave to `s` on the straight line, all joints in step.
    fn of_s(&self) -> (f64, f64) {
        let least =
            |limits: &[f64]| limits.iter().zip(&self.distance).map(|(l, d)| l / d.abs()).fold(f64::INFINITY, f64::min);
        (least(&self.speed), least(&self.acceleration))
    }

    /// `T` of the straight line, `s` from 0 to 1 at `ṡ <= v`, `|s̈| <= a`.
    fn closed_form(&self) -> f64 {
        let (v, a) = self.of_s();
        if v * v >= a { 2.0 / a.sqrt() } else { 1.0 / v + v / a }
    }

    /// The straight line on a grid with nodes where the closed form switches: there `b` is linear between the nodes.
    fn switching(&self, intervals: usize) -> SampledPath {
        let (v, a) = self.of_s();
        let ramp = (0.5 * v * v / a).min(0.5);
        let mut path = self.straight(2, 1.0, 1.0);
        let mut shares = vec![0.0];
        for (from, to) in [(0.0, ramp), (ramp, 1.0 - ramp), (1.0 - ramp, 1.0)] {
            if to > from {
                shares.extend((1..=intervals).map(|k| from + (to - from) * k as f64 / intervals as f64));
            }
        }
        let node = path.pieces[0].nodes[0].clone();
        path.pieces[0] = one_piece(shares.iter().map(|&s| PathSample { s, ..node.clone() }).collect(), vec![]);
        path
    }
}

fn motions() -> Vec<Motion> {
    let mut motions = Vec::new();
    for size in [1e-4, 1e-3, 1e-2, 0.1, 1.0] {
        for shape in [[1.0, 1.0], [1.0, 1e-6], [-1.0, 0.3], [1.0, 0.0]] {
            for limits in [[1.0, 1.0], [1e3, 1.0], [1.0, 1e-3]] {
                motions.push(Motion {
                    distance: shape.iter().map(|x| x * size).collect(),
                    speed: limits.iter().map(|x| 2.0 * x).collect(),
                    acceleration: limits.iter().map(|x| 5.0 * x).collect(),
                });
            }
        }
    }
    motions
}

fn solved(path: &SampledPath, what: &str) -> TimeOptimum {
    let optimum = time_optimum(path).unwrap_or_else(|e| panic!("{what}: {e}"));
    assert!(optimum.gap() <= 1e-5, "{what}: gap {}, {:?}", optimum.gap(), optimum.status);
    let greedy = reachable_profile(path).unwrap_or_else(|e| panic!("{what}: {e}"));
    assert!(greedy.duration_s >= optimum.lower_s, "{what}");
    for b in [&optimum.pieces[0].b, &greedy.pieces[0].b] {
        assert!(violation_at_nodes(path, 0, b) <= 1e-9, "{what}");
    }
    optimum
}

#[test]
fn straight_two_point_motions_meet_the_closed_form() {
    for (i, motion) in motions().iter().enumerate() {
        let path = motion.switching(60);
        let (exact, optimum) = (motion.closed_form(), solved(&path, &format!("motion {i}")));
        assert!((optimum.duration_s / exact - 1.0).abs() <= 1e-6, "motion {i}: {} {exact}", optimum.duration_s);
        let greedy = reachable_profile(&path).expect("feasible").duration_s;
        assert!((greedy / exact - 1.0).abs() <= 1e-6, "motion {i}: {greedy} {exact}");
    }
}

#[test]
fn two_point_motions_are_the_same_in_any_unit_and_on_any_scale_of_the_parameter() {
    for (i, motion) in motions().iter().enumerate() {
        let reference = solved(&motion.straight(60, 1.0, 1.0), &format!("motion {i}"));
        let greedy = reachable_profile(&motion.straight(60, 1.0, 1.0)).expect("feasible").duration_s;
        for (unit, length) in [(1e3, 1.0), (1.0, 1e-4), (1e3, 1e-4)] {
            let path = motion.straight(60, unit, length);
            let other = solved(&path, &format!("motion {i} in units of {unit} over {length}"));
            // Each is certified to 1e-6 of its own optimum, which is the same number.
            assert!((other.duration_s / reference.duration_s - 1.0).abs() <= 1e-6, "motion {i}");
            let other = reachable_profile(&path).expect("feasible").duration_s;
            // Rounding alone separates the sweeps.
            assert!((other / greedy - 1.0).abs() <= 1e-9, "motion {i}");
        }
    }
}

#[test]
fn clamped_two_point_splines_of_any_size_are_solved_and_certified() {
    // At the ends of the clamped cubic no joint moves: the rate there is bounded by the acceleration of the bend alone.
    for (i, motion) in motions().iter().enumerate() {
        for (unit, length) in [(1.0, 1.0), (1e3, 1e-4)] {
            solved(&motion.clamped(100, unit, length), &format!("clamped motion {i} in units of {unit}"));
        }
    }
}

#[test]
fn a_grid_of_two_intervals_is_enough() {
    let motion = Motion { distance: vec![1e-4], speed: vec![1.0], acceleration: vec![1.0] };
    let optimum = solved(&motion.straight(2, 1.0, 1.0), "two intervals");
    assert!((optimum.duration_s / motion.closed_form() - 1.0).abs() <= 1e-6);
}

#[test]
fn an_empty_or_backward_grid_is_an_error() {
    let motion = Motion { distance: vec![1.0], speed: vec![1.0], acceleration: vec![1.0] };
    let path = motion.straight(4, 1.0, 1.0);
    for nodes in [vec![], path.pieces[0].nodes[..1].to_vec(), path.pieces[0].nodes.iter().rev().cloned().collect()] {
        let path = SampledPath { pieces: vec![one_piece(nodes, vec![])], ..path.clone() };
        assert!(time_optimum(&path).is_err() && reachable_profile(&path).is_err());
    }
}
