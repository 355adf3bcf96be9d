//! The QP safety filter and the potential field, against the conditioner and the figures of an independent run.

#[path = "oracles/conic_push.rs"]
mod conic_push;
#[path = "../../crates/conditioner/tests/support/mod.rs"]
mod support;

use conic_push::ConicPush;
use proptest::prelude::*;
use slideway_baselines::potential_field::PotentialField;
use slideway_baselines::safety_filter::dense::DualActiveSet;
use slideway_baselines::safety_filter::enumeration::smallest;
use slideway_baselines::safety_filter::{FilterSettings, QpFilter, SmallestPush};
use slideway_conditioner::path::Motion;
use support::{PATH_RATE, distance, first_example, helix_beside_sphere, implicit, plane_and_sphere, run};

fn settings(period: f64, rounds: usize) -> FilterSettings<2> {
    FilterSettings { period, cutoff: 20.0, approach: [0.1; 2], rounds }
}

/// The enumeration of all active sets as a solver.
struct Enumeration;

impl SmallestPush for Enumeration {
    fn smallest(&mut self, rows: &[Vec<f64>], bounds: &[f64]) -> Option<Vec<f64>> {
        smallest(rows, bounds)
    }
}

/// Largest distance between the implicit form's path and the filter's, over the first example.
fn apart<S: SmallestPush>(period: f64, rounds: usize, solver: S) -> f64 {
    let mut filter = QpFilter::<3, 2, S>::new(settings(period, rounds), solver);
    let mut largest = 0.0_f64;
    run(first_example(period, implicit()), helix_beside_sphere, plane_and_sphere, 5.0, |reference, step| {
        let filtered = filter.step(reference, plane_and_sphere).expect("two independent constraints");
        largest = largest.max(distance(&filtered.position, &step.motion.position));
    });
    largest
}

#[test]
fn the_implicit_form_follows_the_enumerated_optimum_to_rounding() {
    for period in [1e-3, 2e-4] {
        // Both solve the same nonlinear program at every sample; errors of rounding size decay with the filter.
        let found = apart(period, 5, Enumeration);
        assert!(found <= 1e-10, "{found} m at {period} s");
    }
}

#[test]
fn the_implicit_form_follows_every_qp_filter_within_a_micrometre() {
    for rounds in [1, 3] {
        let dense = apart(1e-3, rounds, DualActiveSet);
        assert!(dense <= 1e-6, "dense active set, {rounds} rounds: {dense} m");
        let conic = apart(1e-3, rounds, ConicPush::new());
        assert!(conic <= 1e-6, "Clarabel, {rounds} rounds: {conic} m");
    }
}

#[test]
fn the_potential_field_deviates_as_the_independent_simulation_says() {
    let field = PotentialField { period: 1e-3, attraction: 20.0, repulsion: 5e-6, influence: 0.1 };
    let (mut correction, mut sum, mut largest, mut sigma) = ([0.0; 3], 0.0, 0.0_f64, [f64::NEG_INFINITY; 2]);
    for k in 0..5000 {
        let time = f64::from(k) * 1e-3;
        let (position, _) = helix_beside_sphere(PATH_RATE * time);
        let reference = Motion { time, position, velocity: [0.0; 3] };
        let found = field.step(&mut correction, &reference, plane_and_sphere).expect("inside");
        let samples = plane_and_sphere(&Motion { position: found, ..reference });
        for (s, sample) in sigma.iter_mut().zip(&samples) {
            *s = s.max(1e3 * sample.value);
        }
        sum += distance(&found, &position);
        largest = largest.max(1e3 * distance(&found, &position));
    }
    let mean = 1e3 * sum / 5000.0;
    assert!((mean - 11.36).abs() <= 0.05, "mean {mean} mm");
    assert!((largest - 62.5).abs() <= 0.5, "largest {largest} mm");
    // Clearances of 17.7 and 16.1 mm, printed with one digit.
    assert!((sigma[0] + 17.7).abs() <= 0.06 && (sigma[1] + 16.1).abs() <= 0.06, "{sigma:?}");
}

#[test]
fn more_half_spaces_than_dimensions_that_all_act_are_solved() {
    // A ring of eight that meet the same circle: any three of them span what all do. By symmetry u = (0, 0, -1 / 0.8).
    let rows: Vec<Vec<f64>> = (0..8)
        .map(|i| {
            let angle = std::f64::consts::TAU * f64::from(i) / 8.0;
            vec![0.6 * angle.cos(), 0.6 * angle.sin(), 0.8]
        })
        .collect();
    for found in [DualActiveSet.smallest(&rows, &[-1.0; 8]), ConicPush::new().smallest(&rows, &[-1.0; 8])] {
        let found = found.expect("a common point exists");
        // The interior point stops at 1e-12 in the objective, which is 1e-6 in the vector.
        assert!(distance(&[found[0], found[1], found[2]], &[0.0, 0.0, -1.25]) <= 1e-6, "{found:?}");
    }
}

#[test]
fn contradictory_half_spaces_have_no_smallest_push() {
    let rows = vec![vec![1.0, 0.0], vec![-1.0, 0.0]];
    let bounds = [-1.0, -1.0];
    assert_eq!(Enumeration.smallest(&rows, &bounds), None);
    assert_eq!(DualActiveSet.smallest(&rows, &bounds), None);
    assert_eq!(ConicPush::new().smallest(&rows, &bounds), None);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    /// Half-spaces around a common point with room to spare: all three methods give the same vector.
    #[test]
    fn the_three_solvers_agree(
        rows in prop::collection::vec(prop::collection::vec(-1.0..1.0_f64, 3), 1..7),
        inner in prop::array::uniform3(-2.0..2.0_f64),
        room in prop::array::uniform7(0.05..1.0_f64),
    ) {
        let bounds: Vec<f64> = rows
            .iter()
            .zip(&room)
            .map(|(row, room)| row.iter().zip(&inner).map(|(r, x)| r * x).sum::<f64>() + room)
            .collect();
        prop_assume!(rows.iter().all(|row| row.iter().map(|r| r * r).sum::<f64>() > 1e-4));
        let exact = Enumeration.smallest(&rows, &bounds).expect("a common point");
        let dense = DualActiveSet.smallest(&rows, &bounds).expect("a common point");
        let conic = ConicPush::new().smallest(&rows, &bounds).expect("a common point");
        for ((e, d), c) in exact.iter().zip(&dense).zip(&conic) {
            // Lengths up to 4; the dual squares the condition of the active rows, the interior point stops at 1e-12 in
            // the objective, which is 1e-6 in the vector.
            prop_assert!((e - d).abs() <= 1e-6, "{exact:?} {dense:?}");
            prop_assert!((e - c).abs() <= 1e-5, "{exact:?} {conic:?}");
        }
    }
}
