//! The naive twins: dense matrices for the elimination and for the whole Newton system, the certificate for the measure.

use super::centre::{Centre, Correctors};
use super::factor::{Block, Factor};
use super::rows::KeptRows;
use super::state::State;
use super::{Start, forward, solve_structured};
use crate::time_optimal::{PieceProgram, feasible_time, lower_bound, repair};
use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;
use slideway_path::{EndRate, PathSample, SampledPath, SampledPiece};

/// Two joints on waves, eight intervals; ends given or free.
fn program(phases: [f64; 2], acceleration: f64, ends: [EndRate; 2]) -> PieceProgram {
    let node = |k: u32| {
        let s = f64::from(k) / 8.0;
        let wave = |f: fn(f64) -> f64| phases.iter().map(|p| f(5.0 * s + p)).collect::<Vec<f64>>();
        let second = wave(f64::cos).into_iter().map(|q| 5.0 * q).collect();
        PathSample { s, lambda: s, first: wave(f64::sin), second, ..PathSample::default() }
    };
    let piece = SampledPiece {
        nodes: (0..=8).map(node).collect(),
        between: Vec::new(),
        is_self_motion: false,
        start: ends[0],
        end: ends[1],
    };
    let path = SampledPath {
        joints: 2,
        speed_lower: vec![-1.0; 2],
        speed_upper: vec![1.0; 2],
        acceleration: Some(vec![acceleration; 2]),
        pieces: vec![piece],
    };
    PieceProgram::new(&path, 0).expect("slow ends are feasible")
}

fn any_program() -> impl Strategy<Value = PieceProgram> {
    let end = || prop_oneof![Just(EndRate::ByLimits), Just(EndRate::Free), (0.01..0.1_f64).prop_map(EndRate::Given)];
    ([0.0..6.0_f64, 0.0..6.0], 2.0..10.0_f64, [end(), end()]).prop_map(|(p, a, ends)| program(p, a, ends))
}

fn start(program: &PieceProgram, share: f64) -> State<'_> {
    let profile = forward(program);
    let mut rows = KeptRows::default();
    rows.keep(program, &profile, f64::INFINITY);
    let x = (0..9).map(|k| if program.free().contains(&k) { share * profile[k] } else { profile[k] }).collect();
    State::new(program, &rows, x, 0.03, 0.1)
}

/// The travel time in the program's units.
fn time(program: &PieceProgram, x: &DVector<f64>) -> f64 {
    program.h.iter().enumerate().map(|(k, h)| 2.0 * h / (x[k].sqrt() + x[k + 1].sqrt())).sum()
}

/// `(∇²T, ∇T)` over the free nodes by differences.
fn derivatives(program: &PieceProgram, x: &DVector<f64>) -> (DMatrix<f64>, DVector<f64>) {
    let free = program.free();
    let step = |k: usize| 1e-3 * x[k];
    let shifted = |moves: &[(usize, f64)]| {
        let mut y = x.clone();
        moves.iter().for_each(|&(k, d)| y[k] += d);
        time(program, &y)
    };
    let gradient = DVector::from_iterator(
        free.len(),
        free.clone().map(|k| {
            let d = step(k);
            // Fourth order: the error is d⁴ of the fifth derivative, 1e-12 of the slope.
            (8.0 * (shifted(&[(k, d)]) - shifted(&[(k, -d)])) - shifted(&[(k, 2.0 * d)]) + shifted(&[(k, -2.0 * d)]))
                / (12.0 * d)
        }),
    );
    let hessian = DMatrix::from_fn(free.len(), free.len(), |i, j| {
        let (k, l) = (free.start + i, free.start + j);
        let (d, e) = (step(k), step(l));
        let of = |s: f64, t: f64| shifted(&[(k, s * d), (l, t * e)]);
        (of(1.0, 1.0) - of(1.0, -1.0) - of(-1.0, 1.0) + of(-1.0, -1.0)) / (4.0 * d * e)
    });
    (hessian, gradient)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_elimination_solves_what_the_dense_matrix_does(
        diagonal in prop::collection::vec(0.1..1.0_f64, 8),
        rows in prop::collection::vec((0_usize..7, -1.0..1.0_f64, -1.0..1.0_f64, 0.0..4.0_f64), 0..30),
        values in prop::collection::vec(-1.0..1.0_f64, 8),
    ) {
        let mut dense = DMatrix::from_diagonal(&DVector::from_vec(diagonal.clone()));
        for &(k, a, c, exponent) in &rows {
            let q = 10f64.powf(exponent);
            for (i, j, value) in [(k, k, a * a), (k, k + 1, a * c), (k + 1, k, a * c), (k + 1, k + 1, c * c)] {
                dense[(i, j)] += q * value;
            }
        }
        let mut factor = Factor::default();
        prop_assert!(factor.eliminate(&diagonal, &blocks(&rows)));
        let mut solution = values.clone();
        factor.solve(&mut solution);
        let solution = DVector::from_vec(solution);
        // Backward error of the twin's residual: a few ε of the matrix's size, 30 rows of at most 2e4.
        let residual = &dense * &solution - DVector::from_vec(values);
        prop_assert!(residual.amax() <= 1e-13 * dense.amax() * (1.0 + solution.amax()), "{}", residual.amax());
    }

    #[test]
    fn no_weight_however_large_costs_a_pivot_its_sign(
        diagonal in prop::collection::vec(1e-12..1e-6_f64, 8),
        rows in prop::collection::vec((0_usize..7, -1.0..1.0_f64, -1.0..1.0_f64, 0.0..30.0_f64), 1..30),
    ) {
        prop_assert!(Factor::default().eliminate(&diagonal, &blocks(&rows)));
    }

    #[test]
    fn the_predictor_and_the_corrector_solve_the_dense_newton_system(program in any_program(), share in 0.3..0.95_f64) {
        let mut state = start(&program, share);
        let measure = state.assess();
        let free = state.free.clone();
        let x = DVector::from_vec(state.x.clone());
        let (hessian, gradient) = derivatives(&program, &x);
        // All pairs as rows over the free nodes: caps first.
        let (caps, rows) = (free.len(), state.rows.rows.len());
        let mut a = DMatrix::zeros(caps + rows, caps);
        for i in 0..caps {
            a[(i, i)] = 1.0;
        }
        for (k, range) in state.rows.first.windows(2).enumerate() {
            for j in range[0]..range[1] {
                let row = state.rows.rows[j];
                for (node, value) in [(k, row.before), (k + 1, row.after)] {
                    if free.contains(&node) {
                        a[(caps + j, node - free.start)] += value;
                    } else {
                        prop_assert_eq!(value, 0.0);
                    }
                }
            }
        }
        let pairs: Vec<_> = state.caps[free.clone()].iter().copied().chain(state.rows.rows.iter().map(|r| r.pair)).collect();
        let of = |f: fn(&super::pair::Pair) -> f64| DVector::from_iterator(pairs.len(), pairs.iter().map(f));
        let (s, z, rho) = (of(|p| p.slack), of(|p| p.multiplier), of(|p| p.residual));
        let n = caps + 2 * (caps + rows);
        let mut system = DMatrix::zeros(n, n);
        let m = caps + rows;
        system.view_mut((0, 0), (caps, caps)).copy_from(&hessian);
        system.view_mut((0, caps + m), (caps, m)).copy_from(&a.transpose());
        system.view_mut((caps, 0), (m, caps)).copy_from(&a);
        for i in 0..m {
            system[(caps + i, caps + i)] = 1.0;
            system[(caps + m + i, caps + i)] = z[i];
            system[(caps + m + i, caps + m + i)] = s[i];
        }
        let solve = |complementarity: DVector<f64>| {
            let mut right = DVector::zeros(n);
            right.rows_mut(0, caps).copy_from(&(-&gradient - a.transpose() * &z));
            right.rows_mut(caps, m).copy_from(&-&rho);
            right.rows_mut(caps + m, m).copy_from(&-complementarity);
            system.clone().lu().solve(&right)
        };
        let products = s.component_mul(&z);
        let affine = solve(products.clone()).expect("regular");
        let second = affine.rows(caps, m).component_mul(&affine.rows(caps + m, m));
        let reach = |v: &DVector<f64>, d: &DVector<f64>| (0..v.len()).map(|i| -d[i] / v[i]).fold(0.0, f64::max);
        let (ds, dz) = (affine.rows(caps, m).into_owned(), affine.rows(caps + m, m).into_owned());
        let dx = affine.rows(0, caps).into_owned();
        let x_free = DVector::from_iterator(caps, free.clone().map(|k| x[k]));
        let within = |decrease: f64, most: f64| if decrease > most { most / decrease } else { 1.0 };
        let primal = within(reach(&s, &ds), 1.0).min(within(reach(&x_free, &dx), 0.5));
        let dual = within(reach(&z, &dz), 1.0);
        let mean = products.sum() / m as f64;
        let after = (&s + primal * &ds).dot(&(&z + dual * &dz)) / m as f64;
        let target = (after / mean).powi(3).min(1.0) * mean;
        let corrected = solve(products + second - DVector::from_element(m, target)).expect("regular");
        let mut centre = Centre::default();
        prop_assert!(centre.direct(&mut state, &measure, Correctors::None).is_some());
        for (i, k) in free.enumerate() {
            // The twin's Hessian by differences is good to 1e-6 of itself (d² of the fourth derivative).
            prop_assert!((centre.step[k] - corrected[i]).abs() <= 1e-4 * corrected.rows(0, caps).amax(), "node {}", k);
        }
    }

    #[test]
    fn the_measure_of_an_iterate_is_its_certificate_but_for_rounding(program in any_program(), share in 0.3..0.95_f64) {
        let mut state = start(&program, share);
        let measure = state.assess();
        let multipliers: Vec<f64> = state.rows.rows.iter().map(|row| row.pair.multiplier).collect();
        let multipliers = state.rows.multipliers(&multipliers, program.row_count());
        let lower = lower_bound(&program, &state.x, &multipliers);
        let unit = program.unit_time();
        // Some 100 terms, each a few times the travel time and rounded to ε.
        prop_assert!((measure.lower * unit.lo - lower.lo).abs() <= 1e-12 * unit.hi * (measure.time + measure.lower.abs()));
    }

    #[test]
    fn both_starts_lead_to_a_certificate(program in any_program()) {
        for start in [Start::Greedy, Start::Inside] {
            let answer = solve_structured(&program, start);
            let profile = repair(&program, &answer.b).expect("room to spare");
            let (upper, lower) = (feasible_time(&program, &profile), lower_bound(&program, &profile, &answer.multipliers));
            // The loop's own target is 1e-8.
            prop_assert!((upper - lower).hi <= 2e-8 * lower.lo, "{:?}: {} {:?}", start, answer.status, upper - lower);
        }
    }
}

/// The sums of each interval, row by row.
fn blocks(rows: &[(usize, f64, f64, f64)]) -> Vec<Block> {
    (0..7)
        .map(|k| {
            let here = || rows.iter().filter(|r| r.0 == k).map(|r| (10f64.powf(r.3), r.1, r.2));
            let near: f64 = here().map(|(q, a, _)| q * a * a).sum();
            let cross: f64 = here().map(|(q, a, c)| q * a * c).sum();
            let ratio = if near > 0.0 { cross / near } else { 0.0 };
            let rest = here().map(|(q, a, c)| q * (c - ratio * a).powi(2)).sum();
            Block { near, cross, rest, carried: ratio * cross }
        })
        .collect()
}

#[test]
fn the_elimination_by_differences_loses_a_pivot_that_this_one_keeps() {
    // One row of weight 1e20 and entries that are no binary fractions, 1e-6 on the diagonal: q c² - (q a c)² / (ρ + q a²) is 4e14 or
    // so of rounding, of either sign, for a true value of 1e-6 c²/a² or so.
    let (rho, q) = (1e-6, 1e20);
    let mut lost = 0;
    for i in 1..100 {
        let (a, c) = (f64::from(i) / 7.0, -f64::from(i + 1) / 11.0);
        let differences = q * c * c - (q * a * c) * (q * a * c) / (rho + q * a * a);
        lost += i32::from(differences <= 0.0);
        let row = [(0, a, c, 20.0)];
        let mut factor = Factor::default();
        assert!(factor.eliminate(&[rho; 8], &blocks(&row)));
    }
    assert!(lost > 10, "{lost}");
}

/// Programs on which one start or the other once failed: a thin corner leaves the greedy start nothing for the second node, or the free
/// end's value went round in a circle of four steps, each too long for the curvature there.
#[test]
fn programs_of_thin_corners_are_solved_from_both_starts() {
    use EndRate::{ByLimits, Free, Given};
    let corners = [
        ([3.209_139_362_698_367_7, 3.381_727_335_453_848_4], 9.026_086_519_946_922, [Free, ByLimits]),
        (
            [4.106_521_952_210_153, 0.097_624_773_839_030_12],
            2.827_067_067_573_944,
            [Free, Given(0.019_335_461_498_221_542)],
        ),
        ([0.085_470_500_009_275_7, 3.454_300_832_333_887], 3.032_891_960_470_447_4, [Free, ByLimits]),
        (
            [3.389_589_794_114_688, 0.742_345_446_853_074_4],
            6.105_478_753_900_848,
            [Free, Given(0.031_477_743_090_151_36)],
        ),
        ([0.665_793_270_288_615_1, 4.426_492_743_802_029], 9.411_061_766_989_901, [ByLimits, Free]),
    ];
    for (phases, acceleration, ends) in corners {
        for start in [Start::Greedy, Start::Inside] {
            let program = program(phases, acceleration, ends);
            let answer = solve_structured(&program, start);
            let profile = repair(&program, &answer.b).expect("room to spare");
            let (upper, lower) =
                (feasible_time(&program, &profile), lower_bound(&program, &profile, &answer.multipliers));
            assert!(
                (upper - lower).hi <= 2e-8 * lower.lo,
                "{start:?}, {phases:?}: {}, {:?}",
                answer.status,
                upper - lower
            );
        }
    }
}
