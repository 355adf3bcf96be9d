use slideway_motion::control::task_space::{RateController, RateLaw, ToolGains, ToolReference};
use slideway_proofs::transpose_descent::CLAIM;
use slideway_robot::{DhRow, JointVector, SerialArm, Task};

use crate::support::{Outcome, counterexample, holds, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

/// The stretched arm of two unit links does not move, though the tool is not where it should be.
fn an_error_stays([e1, e2, k]: [f64; 3]) -> Outcome {
    let arm = SerialArm::from_dh([DhRow { a: 1.0, alpha: 0.0, d: 0.0, offset: 0.0 }; 2])?;
    let q = JointVector::<2>::zeros();
    let mut goal = arm.forward(&q);
    goal.translation.vector.x += e1;
    goal.translation.vector.y += e2;
    let gains = ToolGains::uniform(k, k)?;
    let largest = JointVector::from_element(f64::INFINITY);
    let controller = RateController::new(arm, Task::PlanarPosition, RateLaw::Transpose, gains, largest)?;
    let rates = controller.step(&ToolReference::at_rest(goal), &q).rates;
    assert!(rates.amax() <= 1e-15 && e1.hypot(e2) >= 0.4, "{rates}");
    Ok(())
}

#[test]
fn at_a_singularity_an_error_may_stay() -> Outcome {
    an_error_stays([-0.5, 0.0, 1.0])?;
    let model = counterexample(&CLAIM, "full-rank")?;
    an_error_stays([model.value("e1")?, model.value("e2")?, model.value("k")?])
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
