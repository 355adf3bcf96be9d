//! Example 9.1 of [G12]: a helix that crosses a plane and a sphere. Expected numbers are those of independent
//! simulations and, for the row-by-row comparison, of `tests/data`.

mod support;

use slideway_conditioner::path::{PathForm, PathOutcome, PathStep, SwitchingLaw};
use support::{distance, explicit, first_example, helix_beside_sphere, implicit, plane_and_sphere, run};

/// Summary of one run of the example. Lengths in mm, times in s.
struct Summary {
    mean_deviation: f64,
    largest_deviation: f64,
    sigma: [f64; 2],
    phi: [f64; 2],
    first_contact: [f64; 2],
    last_contact: [f64; 2],
    return_time: f64,
    positions: Vec<[f64; 3]>,
}

fn simulate(period: f64, form: PathForm) -> Summary {
    let (mut sum, mut positions) = (0.0, Vec::new());
    let mut out = Summary {
        mean_deviation: 0.0,
        largest_deviation: 0.0,
        sigma: [f64::NEG_INFINITY; 2],
        phi: [f64::NEG_INFINITY; 2],
        first_contact: [f64::INFINITY; 2],
        last_contact: [0.0; 2],
        return_time: f64::NAN,
        positions: Vec::new(),
    };
    run(first_example(period, form), helix_beside_sphere, plane_and_sphere, 5.0, |reference, step: &PathStep<3, 2>| {
        assert!(!matches!(step.outcome, PathOutcome::Held(_)), "held at {} s", reference.time);
        let deviation = 1e3 * distance(&reference.position, &step.motion.position);
        sum += deviation;
        out.largest_deviation = out.largest_deviation.max(deviation);
        for i in 0..2 {
            out.sigma[i] = out.sigma[i].max(1e3 * step.sigma[i]);
            out.phi[i] = out.phi[i].max(1e3 * step.phi[i]);
            if step.share[i] > 0.0 {
                out.first_contact[i] = out.first_contact[i].min(reference.time);
                out.last_contact[i] = reference.time;
                out.return_time = f64::NAN;
            }
        }
        if out.return_time.is_nan() && deviation < 1.0 {
            out.return_time = reference.time - out.last_contact[0].max(out.last_contact[1]);
        }
        positions.push(step.motion.position);
    });
    out.mean_deviation = sum / positions.len() as f64;
    out.positions = positions;
    out
}

/// Mean distance in mm between two runs of the same period.
fn mean_distance(a: &Summary, b: &Summary) -> f64 {
    let total: f64 = a.positions.iter().zip(&b.positions).map(|(p, q)| 1e3 * distance(p, q)).sum();
    total / a.positions.len() as f64
}

fn assert_near(value: f64, expected: f64, tolerance: f64) {
    assert!((value - expected).abs() <= tolerance, "{value} is not within {tolerance} of {expected}");
}

#[test]
fn the_sliding_mode_deviates_and_clears_as_the_independent_simulation_says() {
    let run = simulate(1e-3, explicit(0.1));
    assert_near(run.mean_deviation, 5.24, 0.05);
    assert_near(run.sigma[0], -0.80, 0.05);
    assert_near(run.sigma[1], -0.78, 0.05);
    let both = run.last_contact[0].min(run.last_contact[1]) - run.first_contact[0].max(run.first_contact[1]);
    assert_near(both, 0.53, 0.02);
    // 0.106 s in the independent simulation; the last contacts are single samples, some 10 ms apart.
    assert_near(run.return_time, 0.11, 0.02);
}

#[test]
fn the_appendix_scheme_deviates_as_the_independent_simulation_says() {
    let law = SwitchingLaw::Normalised { amplitude: 0.1 };
    let run = simulate(5e-5, PathForm::Appendix { law });
    // 4.94 mm, 41.1 mm and clearances of 0.06 and 0.13 mm, printed with two digits.
    assert_near(run.mean_deviation, 4.94, 0.005);
    assert_near(run.largest_deviation, 41.1, 0.05);
    assert_near(run.sigma[0], -0.06, 0.005);
    assert_near(run.sigma[1], -0.13, 0.005);
}

#[test]
fn every_row_of_the_independent_simulation_is_reproduced() {
    let text = include_str!("data/path_9_1_zoh_K0.1.csv");
    let run = simulate(1e-3, explicit(0.1));
    let mut rows = 0;
    for line in text.lines().skip(1) {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().expect("a number")).collect();
        let k = (cells[0] / 1e-3).round() as usize;
        let Some(position) = run.positions.get(k) else { continue };
        // The file carries nine digits of numbers up to 0.35 m; half a unit in the last is 5e-10.
        let apart = distance(position, &[cells[5], cells[6], cells[7]]);
        assert!(apart < 1e-8, "at {} s the positions are {apart} m apart", cells[0]);
        rows += 1;
    }
    assert!(rows > 300, "only {rows} rows were compared");
}

#[test]
fn the_distance_to_the_implicit_path_falls_linearly_with_the_period() {
    // mm at 1, 0.2 and 0.05 ms, within 10 %.
    for (period, expected) in [(1e-3, 0.336), (2e-4, 0.068), (5e-5, 0.018)] {
        let apart = mean_distance(&simulate(period, explicit(0.1)), &simulate(period, implicit()));
        assert_near(apart, expected, 0.1 * expected);
    }
}

#[test]
fn the_implicit_form_keeps_phi_at_or_below_zero_at_every_sample() {
    for period in [1e-3, 2e-4, 5e-5] {
        let run = simulate(period, implicit());
        // Rounding of a few numbers of 0.1 m, in mm: 1e3 * 0.1 * 1e-16 times some ten operations.
        assert!(run.phi.iter().all(|&phi| phi <= 1e-12), "{:?}", run.phi);
        // Between samples φ bulges by at most T² sup|φ̈| / 8, with φ̈ = σ̈ + K d³σ/dt³. From eq 5 with ‖u‖ <= 0.1 m,
        // ‖f‖ <= 0.05 m and ‖ḟ‖ <= 0.2 m/s: ‖f̈‖ <= 400 * 0.06 + 28.3 * 0.2 < 30 m/s², the third derivative is below
        // 28.3 * 30 + 400 * 0.2 < 930 m/s³, so |φ̈| < 30 + 0.1 * 930 < 125 m/s².
        let bulge = 1e3 * slideway_conditioner::path::bounds::between_samples(period, 125.0);
        assert!(run.sigma.iter().all(|&sigma| sigma <= bulge), "{:?}", run.sigma);
    }
}

#[test]
fn the_sum_law_slides_with_a_gain_above_the_required_one() {
    // Normalised to U = 0.1 with one constraint active equals u⁺ = U / (α1² K) = 0.0025.
    let run = simulate(
        1e-3,
        PathForm::Sliding {
            law: SwitchingLaw::Sum { gain: 0.0025 },
            reserve: slideway_conditioner::path::Reserve::Off,
        },
    );
    assert_near(run.mean_deviation, 5.24, 0.15);
    assert!(run.sigma.iter().all(|&sigma| sigma < 0.0), "{:?}", run.sigma);
}
