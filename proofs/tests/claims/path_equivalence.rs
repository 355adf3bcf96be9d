use proptest::prelude::{prop_assert, prop_assume, proptest};
use slideway_baselines::safety_filter::enumeration::smallest;
use slideway_conditioner::PathConditioner;
use slideway_conditioner::path::{Constraint, Motion};
use slideway_conditioner::shapes::HalfSpace;
use slideway_proofs::path_equivalence::CLAIM;

use crate::path_support::{APPROACH, direction, dot, implicit, norm, per_push, settings, triple};
use crate::support::{Outcome, config, counterexample, holds, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// The equivalent control of two walls, one of which would have to be pulled, against what the conditioner pushes.
fn pulling_is_not_smallest(cosine: f64, pushing: f64, pulling: f64) -> Outcome {
    let rows = [[1.0, 0.0], [cosine, 1.0]];
    let control: [f64; 2] = std::array::from_fn(|i| -(pushing * rows[0][i] + pulling * rows[1][i]));
    // At rest on the reference, φ = -per_push gᵀu_eq makes u_eq the control that brings both to zero.
    let conditioner = PathConditioner::<2, 2>::new(settings(implicit()))?;
    let unit = per_push();
    let mut walls = [HalfSpace::new(&[1.0, 0.0], 0.0)?; 2];
    for (wall, row) in walls.iter_mut().zip(&rows) {
        *wall = HalfSpace::new(row, unit * dot(row, &control))?;
    }
    let mut state = conditioner.at_rest(&[0.0; 2])?;
    let reference = Motion { time: 0.0, position: [0.0; 2], velocity: [0.0; 2] };
    let sample = |m: &Motion<2>| walls.each_ref().map(|wall| wall.sample(m));
    // The first sample of a run stands where it starts; the second is corrected to the last bit.
    conditioner.step(&mut state, &reference, sample);
    let step = conditioner.step(&mut state, &reference, sample);
    assert!(norm(&step.push) < norm(&control) - 0.004, "{:?} {control:?}", step.push);
    Ok(())
}

#[test]
fn a_negative_multiplier_is_not_the_optimum() -> Outcome {
    pulling_is_not_smallest(0.0, 0.5, -0.5)?;
    let model = counterexample(&CLAIM, "positive-multiplier")?;
    pulling_is_not_smallest(model.value("c")?, model.value("m1")?, model.value("m2")?)
}

/// `|n1 (n2 x n3)|`: the volume the normals span, 0 where they depend on one another.
fn volume([a, b, c]: &[[f64; 3]; 3]) -> f64 {
    let cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
    dot(a, &cross).abs()
}

proptest! {
    #![proptest_config(config())]

    // One implicit step beside the enumerated program, from a start that moves: φ of the free motion is what the twin
    // evaluates, the rows are (γ1 + K γ2) n. Rounding: condition 1e4 as above, times φ / (γ1 + K γ2) of up to 1 / 0.02 and
    // 1e-15. The shares are the multipliers: u is the sum of the normals weighted by them.
    #[test]
    fn the_implicit_push_is_the_optimum_of_the_program_and_its_shares_are_the_multipliers(
        one in direction(),
        two in direction(),
        three in direction(),
        velocity in triple(-1.0..1.0),
        excess in triple(-0.2..0.5),
    ) {
        let normals = [one, two, three];
        prop_assume!(volume(&normals) > 0.05);
        let conditioner = PathConditioner::<3, 3>::new(settings(implicit()))?;
        let far = normals.map(|n| HalfSpace::new(&n, 10.0));
        let [Ok(a), Ok(b), Ok(c)] = far else { return Err(proptest::test_runner::TestCaseError::fail("a wall")) };
        let mut state = conditioner.on_reference();
        let start = Motion { time: 0.0, position: [0.0; 3], velocity };
        conditioner.step(&mut state, &start, |m| [a.sample(m), b.sample(m), c.sample(m)]);
        // Nothing has acted: the motion is free, on the reference. The walls appear where φ is the wanted one.
        let mut walls = [a, b, c];
        for ((wall, normal), e) in walls.iter_mut().zip(&normals).zip(&excess) {
            *wall = HalfSpace::new(normal, APPROACH * dot(normal, &velocity) - e)?;
        }
        let step = conditioner.step(&mut state, &start, |m| walls.each_ref().map(|wall| wall.sample(m)));
        let rows: Vec<Vec<f64>> = normals.iter().map(|n| n.map(|x| per_push() * x).to_vec()).collect();
        let bounds = excess.map(|e| -e);
        let found = smallest(&rows, &bounds).expect("independent rows");
        let force = found.iter().map(|x| x * x).sum::<f64>().sqrt();
        for i in 0..3 {
            prop_assert!((found[i] - step.push[i]).abs() <= 1e-9 * (1.0 + force), "{found:?} {:?}", step.push);
        }
        let mut along = [0.0; 3];
        for (normal, share) in normals.iter().zip(&step.share) {
            prop_assert!(*share >= 0.0);
            along = std::array::from_fn(|i| along[i] - share * normal[i]);
        }
        if force > 0.0 {
            let size = force / norm(&along);
            for (a, push) in along.iter().zip(&step.push) {
                prop_assert!((size * a - push).abs() <= 1e-9 * (1.0 + force));
            }
        }
    }
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
