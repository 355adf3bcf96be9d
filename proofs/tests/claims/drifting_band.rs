use proptest::prelude::{Just, Strategy, any, prop_assert, prop_oneof, proptest};
use proptest::test_runner::TestCaseError;
use slideway_conditioner::bounds::drifting_band;
use slideway_conditioner::{Advance, SpeedRegulator, SpeedState};
use slideway_proofs::drifting_band::CLAIM;

use crate::support::{
    Outcome, Proportional, TS, advance, config, counterexample, proportional, proven, settings, unit_joint,
};

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

/// `ln g(λ)`, linear between knots, constant outside.
#[derive(Clone, Debug)]
struct Path {
    places: Vec<f64>,
    logs: Vec<f64>,
}

impl Path {
    fn overspeed(&self, place: f64) -> f64 {
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
}

/// Which reaching condition a case is at, or within.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Reaching {
    /// `d M <= -ln(1 - a)`, as the shipped function asks.
    Shipped,
    /// `d (1 + a (g_min - 1)) <= -ln(1 - a)`, for `g_min >= 1`.
    Weaker,
}

/// Parameters that meet every hypothesis, and a path.
#[derive(Clone, Debug)]
struct Case {
    reaching: Reaching,
    a: f64,
    g_max: f64,
    /// `L Ts λ̇*max`.
    drift: f64,
    target_rate: f64,
    start: f64,
    path: Path,
    /// `L`, per unit of λ.
    slope: f64,
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

/// The largest drift that meets the weaker condition `d (1 + a (g_min - 1)) <= -ln(1 - a)`, less a hundred roundings, and
/// `place` of it.
fn weaker_drift(a: f64, g_min: f64, place: f64) -> f64 {
    place * (1.0 - 1e-14) * -(-a).ln_1p() / (1.0 + a * (g_min - 1.0))
}

/// Steps of 1 to 20 samples at the admissible rate, each rising, falling, resting, or anything between.
fn steps() -> impl Strategy<Value = Vec<(f64, f64)>> {
    let slope = prop_oneof![3 => Just(1.0), 2 => Just(-1.0), 1 => Just(0.0), 2 => -1.0..=1.0];
    proptest::collection::vec((1.0..20.0, slope), 2..10)
}

fn case() -> impl Strategy<Value = Case> {
    let place = prop_oneof![Just(1.0), 0.0..=1.0];
    (0.01..0.8, 0.0..2.0, 0.0..2.0, place, 0.5..50.0, 0.0..=1.0, steps(), any::<bool>(), any::<bool>()).prop_map(
        |(a, ln_max, span, place, target_rate, start, steps, from_the_top, weaker): (
            f64,
            f64,
            f64,
            _,
            f64,
            f64,
            _,
            _,
            _,
        )| {
            let (ln_min, g_max) = (ln_max - span, ln_max.exp());
            // The weaker condition is stated for paths that ask for regulation everywhere.
            let reaching = if weaker && ln_min >= 0.0 { Reaching::Weaker } else { Reaching::Shipped };
            let drift = match reaching {
                Reaching::Shipped => admissible_drift(a, g_max, place),
                Reaching::Weaker => weaker_drift(a, ln_min.exp(), place),
            };
            // λ̇*max = λ̇d / g_min.
            let slope = drift * ln_min.exp() / (TS * target_rate);
            let (mut places, mut logs) = (vec![0.0], vec![if from_the_top { ln_max } else { ln_min }]);
            for (samples, share) in steps {
                let (place, log) = (places[places.len() - 1], logs[logs.len() - 1]);
                let length = samples * TS * target_rate / g_max;
                places.push(place + length);
                // Cutting a change short keeps its slope below L.
                logs.push((log + share * slope * length).max(ln_min).min(ln_max));
            }
            let first = logs[0].exp();
            Case {
                reaching,
                a,
                g_max,
                drift,
                target_rate,
                start: (start / first).min(1.0),
                path: Path { places, logs },
                slope,
            }
        },
    )
}

const SAMPLES: u32 = 120;

/// Rounding, relative to `m`, one sample. Place, interpolation and exponential put `ln g` off by at most four roundings of
/// `|ln g| <= 4` (16) and of the place times the slope (`4 L λ_end`); rate, share, product, ratio and the filter's three
/// add 8, so do the band's own operations once. A sample with `u = 0` at the very edge of the reaching condition passes on what
/// it inherits, so all samples add up.
fn slack(case: &Case, end: f64) -> f64 {
    let one = 16.0 + 8.0 + 4.0 * case.slope * end;
    (f64::from(SAMPLES) * one + 8.0) * (f64::EPSILON / 2.0)
}

fn keeps_the_band<const N: usize>(arm: &Proportional<N>, case: &Case, advance: Advance) -> Result<(), TestCaseError> {
    let band = match case.reaching {
        Reaching::Shipped => drifting_band(case.a, case.g_max, case.drift)
            .ok_or_else(|| TestCaseError::fail("the generator meets the shipped condition"))?,
        Reaching::Weaker => (1.0 - case.a) * case.drift.exp() + case.a * case.g_max,
    };
    let mut settings = settings(arm.limits, case.a, case.target_rate);
    settings.advance = advance;
    let regulator = SpeedRegulator::new(settings)?;
    let mut state = SpeedState::moving(case.start)?;
    let mut place = 0.0;
    for sample in 0..SAMPLES {
        let desired = arm.at(regulator.requested_rate(&state) * (case.path.overspeed(place) / case.target_rate));
        let command = regulator.step(&mut state, &desired);
        let bound = band * (1.0 + slack(case, place));
        prop_assert!(command.limit_ratio <= bound, "sample {sample}: {} > {band}", command.limit_ratio);
        place += TS * command.path_rate;
    }
    Ok(())
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

proptest! {
    #![proptest_config(config())]

    #[test]
    fn one_joint_keeps_the_band(arm in proportional::<1>(), case in case(), advance in advance()) {
        keeps_the_band(&arm, &case, advance)?;
    }

    #[test]
    fn three_joints_keep_the_band(arm in proportional::<3>(), case in case(), advance in advance()) {
        keeps_the_band(&arm, &case, advance)?;
    }
}
