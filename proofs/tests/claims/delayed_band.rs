use std::collections::VecDeque;

use proptest::prelude::{prop_assert, proptest};
use slideway_conditioner::bounds::delayed_frozen_band;
use slideway_conditioner::{SpeedRegulator, SpeedState};
use slideway_proofs::delayed_band::CLAIM;

use crate::support::{
    Outcome, Proportional, config, counterexample, filter, filter_step, proportional, proven, settings, unit_joint,
};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// Largest use of a limit over `samples`, with the switch of the regulator held back by the length of `late`.
fn largest_ratio<const N: usize>(
    regulator: &SpeedRegulator<N>,
    arm: impl Fn(f64) -> [f64; N],
    start: f64,
    mut late: VecDeque<f64>,
    samples: u32,
    a: f64,
) -> Result<f64, slideway_conditioner::ParameterError> {
    let filter = filter(a)?;
    let (mut factor, mut largest) = (start, 0.0_f64);
    for _ in 0..samples {
        let mut state = SpeedState::moving(factor)?;
        let desired = arm(regulator.requested_rate(&state));
        let command = regulator.step(&mut state, &desired);
        largest = largest.max(command.limit_ratio);
        late.push_back(command.switch);
        let arrived = late.pop_front().unwrap_or(f64::NAN);
        factor = filter.next(factor, arrived);
    }
    Ok(largest)
}

fn band_of_one_is_left_by_a_delay_of_two(a: f64, g: f64, f0: f64) -> Outcome {
    assert!(g * f0 <= 1.0);
    let late = VecDeque::from([1.0, 1.0]);
    let largest = largest_ratio(&unit_joint(a, g)?, |speed| [speed], f0, late, 4, a)?;
    assert!(largest > delayed_frozen_band(a, g, 1) + 0.05, "{largest}");
    assert!(largest <= delayed_frozen_band(a, g, 2), "{largest}");
    Ok(())
}

#[test]
fn a_longer_delay_leaves_the_band() -> Outcome {
    band_of_one_is_left_by_a_delay_of_two(0.5, 2.0, 0.4375)?;
    let model = counterexample(&CLAIM, "bounded-delay")?;
    band_of_one_is_left_by_a_delay_of_two(model.value("a")?, model.value("g")?, model.value("f0")?)
}

proptest! {
    #![proptest_config(config())]

    // Rounding. As for the frozen band, but D + 1 rises follow one another, each adding three roundings of at most
    // f <= band / g; falls add nothing. The band costs ten roundings (log1p, product, expm1 and the rest, two units each
    // from the library), the measured ratio four. 10 + 4 + 4 + 3 (D + 1) roundings = (10.5 + 1.5 D) eps.
    #[test]
    fn a_delayed_switch_keeps_the_band(
        arm in proportional::<2>(),
        a in filter_step(),
        g in 1.0..50.0,
        place in 0.0..=1.0,
        history in proptest::collection::vec(0_u8..2, 0..7),
    ) {
        let delay = history.len() as u32;
        let band = delayed_frozen_band(a, g, delay);
        let slack = (11.0 + 1.5 * f64::from(delay)) * f64::EPSILON;
        let regulator = SpeedRegulator::new(settings(arm.limits, a, g))?;
        let late = history.iter().map(|&u| f64::from(u)).collect();
        let largest = largest_ratio(&regulator, |speed| Proportional::at(&arm, speed), place / g, late, 80, a)?;
        prop_assert!(largest <= band * (1.0 + slack), "{largest} > {band}");
    }
}
