use proptest::prelude::{prop_assert, proptest};
use slideway_motion::control::task_space::{RateController, RateLaw, ToolGains, ToolReference, pose_error};
use slideway_proofs::transpose_descent::CLAIM;
use slideway_robot::models::puma560;
use slideway_robot::{DhRow, JointVector, SerialArm, Task};

use crate::support::{Outcome, config, counterexample, joints, proven};

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

proptest! {
    #![proptest_config(config())]

    // The position of the PUMA-560's tool: V̇ by central differences over h along the joint speeds. Their third derivative is at most
    // 8 V |q̇|³ with positions of the size of 1 m, 4 V |q̇|² k |x| |q̇| beside it; roundings of V over h.
    #[test]
    fn the_potential_falls_by_the_square_of_the_speeds(
        q in joints::<6>(-3.1..3.1), goal in joints::<6>(-3.1..3.1), k in 0.1..10.0_f64,
    ) {
        let arm = puma560();
        let [q, goal] = [q, goal].map(JointVector::<6>::from);
        let gains = ToolGains::uniform(k, k)?;
        let desired = ToolReference::at_rest(arm.forward(&goal));
        let largest = JointVector::from_element(f64::INFINITY);
        let controller = RateController::new(arm.clone(), Task::Position, RateLaw::Transpose, gains, largest)?;
        let rates = controller.step(&desired, &q).rates;
        let potential = |q: JointVector<6>| gains.energy(&Task::Position.select(&pose_error(&desired.pose, &arm.forward(&q))));
        let speed = rates.norm();
        let h = 1e-5 / (1.0 + speed);
        let rate = (potential(q + rates * h) - potential(q - rates * h)) / (2.0 * h);
        let size = k * (1.0 + speed).powi(3) * 12.0 * h * h + 1e-14 * k / h;
        prop_assert!((rate + rates.norm_squared()).abs() <= size, "{rate} {}", rates.norm_squared());
    }
}
