use slideway_conditioner::SpeedState;
use slideway_conditioner::bounds::drifting_band;
use slideway_proofs::drifting_band::CLAIM;

use crate::support::{Outcome, counterexample, holds, proven, unit_joint};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// Three samples with the target rate 1, so that the desired speed is `g f`.
fn band_is_left(a: f64, f0: f64, g: [f64; 3], e_release: f64) -> Outcome {
    let drift = e_release.ln();
    let regulator = unit_joint(a, 1.0)?;
    let mut state = SpeedState::moving(f0)?;
    let ratios = g.map(|g| {
        let desired = [g * state.factor()];
        regulator.step(&mut state, &desired).limit_ratio
    });
    let [g0, g1, g2] = g;
    let [m0, m1, m2] = ratios;
    // Every other hypothesis holds: the start, and a drift of ln g of at most d m at both samples.
    assert!(m0 <= 1.0 && (g1 / g0).ln() <= drift * m0 && (g2 / g1).ln() <= drift * m1);
    let band = (1.0 - a) * e_release + a * g0.max(g1).max(g2);
    assert!(band >= 1.0 && m2 > band + 0.05, "{m2} {band}");
    // And the shipped function refuses to answer.
    assert_eq!(drifting_band(a, g2, drift), None);
    Ok(())
}

#[test]
fn without_the_reaching_condition_the_band_is_left() -> Outcome {
    band_is_left(0.25, 0.5, [2.0, 3.75, 7.375], 2.0)?;
    let model = counterexample(&CLAIM, "reaching")?;
    let g = [model.value("g0")?, model.value("g1")?, model.value("g2")?];
    band_is_left(model.value("a")?, model.value("f0")?, g, model.value("e_release")?)
}

#[test]
fn without_the_reaching_condition_a_smooth_path_leaves_the_band() -> Outcome {
    // g = exp(d λ) on λ in [0, 2], with λ counted in Ts λ̇d: L Ts λ̇*max = d, since g >= 1 everywhere.
    let (a, drift) = (0.1, 1.0);
    let regulator = unit_joint(a, 1.0)?;
    let mut state = SpeedState::moving(1.0)?;
    let (mut place, mut largest) = (0.0_f64, 0.0_f64);
    while place <= 2.0 {
        let desired = [(drift * place).exp() * state.factor()];
        let command = regulator.step(&mut state, &desired);
        largest = largest.max(command.limit_ratio);
        place += command.path_rate;
    }
    let band = (1.0 - a) * drift.exp() + a * (drift * 2.0).exp();
    assert!(largest > 1.5 * band, "{largest} {band}");
    Ok(())
}

/// The largest drift that meets the reaching condition, by bisection, and `place` of it.
fn admissible_drift(a: f64, g_max: f64, place: f64) -> f64 {
    let (mut low, mut high) = (0.0, -(-a).ln_1p());
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if drifting_band(a, g_max, middle).is_some() {
            low = middle;
        } else {
            high = middle;
        }
    }
    place * low
}

#[test]
fn the_band_is_nearly_reached() -> Outcome {
    // A fall of the limit right after the last released sample: m = 1, then (1 - a) exp(d) + a g. Not a loose bound.
    let (a, g_max) = (0.2_f64, 3.0_f64);
    let drift = admissible_drift(a, g_max, 1.0);
    let band = drifting_band(a, g_max, drift).ok_or("the reaching condition holds")?;
    let regulator = unit_joint(a, 1.0)?;
    let before = g_max / drift.exp();
    let mut state = SpeedState::moving(1.0 / before * (1.0 - f64::EPSILON))?;
    let desired = [before * state.factor()];
    let first = regulator.step(&mut state, &desired);
    assert_eq!(first.switch, 1.0);
    let desired = [g_max * state.factor()];
    let second = regulator.step(&mut state, &desired);
    assert!(second.limit_ratio > band * (1.0 - 1e-14) && second.limit_ratio < band * (1.0 + 1e-14));
    Ok(())
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
