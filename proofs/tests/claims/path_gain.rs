use proptest::prelude::{prop_assert, proptest};
use slideway_conditioner::PathConditioner;
use slideway_conditioner::path::bounds::required_gain;
use slideway_conditioner::path::{Constraint, Motion, PathForm, PathSettings, Reserve, SwitchingLaw};
use slideway_conditioner::shapes::HalfSpace;
use slideway_proofs::path_gain::CLAIM;

use crate::path_support::{APPROACH, CUTOFF, runs, settings};
use crate::support::{Outcome, counterexample, holds, proven};

/// Push of a unit gain along a unit gradient, m: `α1² K`.
const UNIT: f64 = CUTOFF * CUTOFF * APPROACH;

fn sum_law<const M: usize>(gain: f64, period: f64) -> PathSettings<M> {
    let law = SwitchingLaw::Sum { gain };
    PathSettings { sampling_period: period, ..settings(PathForm::Sliding { law, reserve: Reserve::Off }) }
}

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// Walls through the origin and a reference that stands beyond it so that holding `p*` there takes the multipliers `μ`: at
/// rest `L_f = -α1² K N f` and `L_g = α1² K N`, hence `f = -α1² K Nᵀ μ`. Gives the largest `σ` of the last tenth of a second.
fn largest_sigma<const M: usize>(
    normals: &[[f64; 3]; M],
    multipliers: &[f64; M],
    gain: f64,
) -> Result<f64, slideway_conditioner::ParameterError> {
    // Short, so that the band, which is proportional to it, is narrow.
    let (period, samples) = (1e-4, 10_000);
    let conditioner = PathConditioner::<3, M>::new(sum_law(gain, period))?;
    let mut walls = [HalfSpace::new(&[1.0, 0.0, 0.0], 0.0)?; M];
    let mut place = [0.0; 3];
    for ((wall, normal), mu) in walls.iter_mut().zip(normals).zip(multipliers) {
        *wall = HalfSpace::new(normal, 0.0)?;
        place = std::array::from_fn(|i| place[i] + UNIT * mu * normal[i]);
    }
    let reference = Motion { time: 0.0, position: place, velocity: [0.0; 3] };
    let mut state = conditioner.at_rest(&[0.0; 3])?;
    let mut largest = f64::NEG_INFINITY;
    for k in 0..samples {
        let step = conditioner.step(&mut state, &reference, |m| walls.each_ref().map(|wall| wall.sample(m)));
        if k >= samples - 1000 {
            largest = step.sigma.iter().fold(largest, |a, &b| a.max(b));
        }
    }
    Ok(largest)
}

/// With too small a gain the wall that needs most is left by `α1² K (μ - u⁺)`; a tenth of it is given to the transient, of
/// which `exp(-14)` is left after a second, and to the chattering.
fn third_wall_is_lost(multipliers: [f64; 3], gain: f64) -> Outcome {
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    // The paper's numbers are of the order of 1 m: here a hundredth of the multipliers.
    let scaled = multipliers.map(|m| 0.01 * m);
    let lost = largest_sigma(&axes, &scaled, 0.01 * gain)?;
    assert!(gain > multipliers[0] && gain > multipliers[1]);
    assert!(lost >= 0.9 * 0.01 * UNIT * (multipliers[2] - gain), "{lost}");
    let held = largest_sigma(&axes, &scaled, 0.0105 * multipliers[2])?;
    assert!(held <= 0.1 * lost, "{held} {lost}");
    Ok(())
}

#[test]
fn a_gain_that_exceeds_two_multipliers_of_three_loses_the_third_wall() -> Outcome {
    third_wall_is_lost([0.25, 0.5, 1.0], 0.75)?;
    let model = counterexample(&CLAIM, "largest-multiplier")?;
    let value = |name| model.value(name);
    third_wall_is_lost([value("m1")?, value("m2")?, value("m3")?], value("u")?)
}

proptest! {
    #![proptest_config(runs())]

    // A pair of walls with cosine c. Below the gain the wall of the larger multiplier is left by at least
    // (1 - c²) α1² K (μ - u⁺), whatever the other one does. Half of that is asked for from below, half is allowed above.
    #[test]
    fn sliding_is_reached_just_above_the_gain_and_missed_just_below(
        cosine in -0.7..0.7_f64,
        multipliers in proptest::array::uniform2(0.001..0.005_f64),
    ) {
        let normals = [[1.0, 0.0, 0.0], [cosine, (1.0 - cosine * cosine).sqrt(), 0.0]];
        let required = required_gain(&multipliers);
        let missing = 0.5 * (1.0 - cosine * cosine) * UNIT * 0.2 * required;
        let held = largest_sigma(&normals, &multipliers, 1.05 * required)?;
        prop_assert!(held <= missing, "{held} {missing}");
        let lost = largest_sigma(&normals, &multipliers, 0.8 * required)?;
        prop_assert!(lost >= missing, "{lost} {missing}");
    }
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
