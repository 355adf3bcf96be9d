use slideway_baselines::time_optimal::{OptimumError, PieceProgram, repair};
use slideway_path::{EndRate, LimitKind, LinearLimit, PathSample};
use slideway_proofs::random_program::path_of;
use slideway_proofs::repair_feasible::CLAIM;

use crate::support::{Outcome, counterexample, holds, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// Without room a blend with `theta < 1` leaves part of the excess.
fn blend_keeps_an_excess(v: f64, theta: f64) {
    assert!(theta < 1.0 && (1.0 - theta) * v > 0.04);
}

/// Two limits that leave one acceleration only: every profile of the program is without room, and none is made up.
#[test]
fn without_room_nothing_is_repaired_and_it_is_said() -> Outcome {
    blend_keeps_an_excess(0.5, 0.5);
    let model = counterexample(&CLAIM, "room")?;
    blend_keeps_an_excess(model.value("v")?, model.value("theta")?);
    let exactly = |value: f64| LinearLimit {
        kind: LimitKind::JointAcceleration,
        index: 0,
        acceleration: 1.0,
        square: 0.0,
        offset: 0.0,
        lower: value,
        upper: value,
    };
    let node = |s: f64| PathSample {
        s,
        lambda: s,
        first: vec![1.0],
        second: vec![0.0],
        limits: vec![exactly(0.0)],
        ..PathSample::default()
    };
    let path = path_of((0..4).map(|k| node(f64::from(k))).collect(), vec![2.0], None, EndRate::Free);
    let answer = PieceProgram::new(&path, 0).and_then(|program| repair(&program, &[0.9, 0.1, 0.9, 0.1]));
    assert!(matches!(answer, Err(OptimumError::Unrepairable(_))), "{answer:?}");
    Ok(())
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
