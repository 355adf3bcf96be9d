use std::collections::VecDeque;

use slideway_conditioner::bounds::delayed_frozen_band;
use slideway_conditioner::{SpeedRegulator, SpeedState};
use slideway_proofs::delayed_band::CLAIM;

use crate::support::{Outcome, counterexample, filter, holds, proven, unit_joint};

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

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
