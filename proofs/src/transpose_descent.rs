//! Claim `transpose-descent`: first-order control by the transposed Jacobian descends.
//!
//! Hypotheses: `q̇ = Jᵀ K e`, the reference at rest, `K` symmetric positive definite (here diagonal), `J` of full row rank.
//!
//! ```text
//! V = ½ eᵀ K e          V̇ = -|Jᵀ K e|² < 0 for e ≠ 0
//! ```
//!
//! Source: `[R16]` operational space control, which asks for nonsingular `J` and `K_P`: that does not make `V` positive (take
//! `K = -1`), nor is a wide `J` nonsingular.
//!
//! Derivation. `ė = -J q̇`; `Jᵀ K e = 0` only for `K e = 0` if the rows of `J` are independent.
//!
//! Dropped hypothesis: full row rank. `V` does not grow then, but an error may stay.

use slideway_motion::control::task_space::{RateController, RateLaw, ToolGains, ToolReference, pose_error};
use slideway_robot::models::puma560;
use slideway_robot::{JointVector, Task};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::engine::{About, Choices, Cost, Engine, Stop};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "transpose-descent",
    statement: "With q̇ = Jᵀ K e, K symmetric positive definite and J of full row rank, V = ½ eᵀ K e falls wherever e is not zero.",
    source: "[R16] operational space control",
    verdict: Verdict::HoldsWithCorrection,
    negations: &[Script { file: "transpose-descent.smt2", text: include_str!("../smt/transpose-descent.smt2") }],
    twins: &[Twin {
        without: "full-rank",
        script: Script {
            file: "transpose-descent-without-full-rank.smt2",
            text: include_str!("../smt/transpose-descent-without-full-rank.smt2"),
        },
    }],
    engines: &[Engine {
        name: "the_potential_falls_by_the_square_of_the_speeds",
        unit: "share of the slack",
        about: About::Other,
        cost: Cost::Sample,
        trial: falls,
    }],
};

/// The position of the PUMA-560's tool: `V̇` by central differences over `h` along the joint speeds.
///
/// Slack. A central difference leaves `h²/6` of the third derivative, which is at most `8 V |q̇|³` with positions of the size of 1 m and
/// `4 V |q̇|² k |x| |q̇|` beside it; roundings of `V` over `h`.
fn falls(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let k = choices.decade(-1.0, 1.0);
    let mut joints = || JointVector::<6>::from(choices.numbers::<6>(-3.1, 3.1));
    let (q, goal) = (joints(), joints());
    let arm = puma560();
    let gains = ToolGains::uniform(k, k)?;
    let desired = ToolReference::at_rest(arm.forward(&goal));
    let largest = JointVector::from_element(f64::INFINITY);
    let controller = RateController::new(arm.clone(), Task::Position, RateLaw::Transpose, gains, largest)?;
    let rates = controller.step(&desired, &q).rates;
    let error = |q: JointVector<6>| Task::Position.select(&pose_error(&desired.pose, &arm.forward(&q)));
    let potential = |q: JointVector<6>| gains.energy(&error(q));
    let speed = rates.norm();
    let h = 1e-5 / (1.0 + speed);
    let rate = (potential(q + rates * h) - potential(q - rates * h)) / (2.0 * h);
    let slack = k * (1.0 + speed).powi(3) * 12.0 * h * h + 1e-14 * k / h;
    Ok(1.0 - (rate + rates.norm_squared()).abs() / slack)
}
