//! Claim `acceleration-recovery`: when a proportional position loop under bounded acceleration does not overshoot.
//!
//! Hypotheses: one joint, a standing reference, error `e >= 0` (rad), previous command `0 <= p <= Kp e_before`, `Kp Ts <= 1`, and
//! `Kp · upper <= D` with `D` the deceleration limit (rad/s²).
//!
//! ```text
//! command = Kp e brought into the box:   0 <= command <= Kp e,   so the next error is >= (1 - Kp Ts) e >= 0
//! ```
//!
//! Source: this project.
//!
//! Derivation. `e = e_before - Ts p`, so `Kp e >= p - Kp Ts p >= p - Ts D` for `Kp p <= D`: the joint can always slow down to what the
//! law asks. From rest `p = 0` the hypothesis on `p` holds, and it is the claim's own conclusion for the next sample. Braking feedback
//! (`Recovery::Braking`) needs no bound on the gain but `Kp Ts <= 1/2`: on its root branch with deceleration `D' = (1 - Kp Ts) D` two
//! consecutive speeds are `v` and `sqrt(v² - 2 D' Ts v)`, whose difference is `2 D' Ts / (1 + sqrt(1 - 2 D' Ts / v)) <= Ts D` since
//! `v >= D' / Kp` there and `sqrt(1 - 2x) >= 1 - 2x`.
//!
//! Dropped hypothesis: the bound on the gain.

use slideway_conditioner::acceleration::{
    AccelerationLimits, AccelerationRegulator, AccelerationSettings, AccelerationState, Recovery,
};
use slideway_conditioner::{AffineSpeed, ParameterError, SpeedLimits};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::draw::TS;
use crate::engine::{About, Choices, Cost, Engine, Stop};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "acceleration-recovery",
    statement: "A joint that returns by a proportional law under bounded acceleration does not pass its reference if Kp times the speed limit is at most the deceleration limit and Kp Ts at most 1.",
    source: "this project",
    verdict: Verdict::Ours,
    negations: &[Script {
        file: "acceleration-recovery.smt2",
        text: include_str!("../smt/acceleration-recovery.smt2"),
    }],
    twins: &[Twin {
        without: "moderate-gain",
        script: Script {
            file: "acceleration-recovery-without-moderate-gain.smt2",
            text: include_str!("../smt/acceleration-recovery-without-moderate-gain.smt2"),
        },
    }],
    engines: &[
        Engine {
            name: "a_moderate_gain_never_passes_the_reference",
            unit: "rad",
            about: About::Other,
            cost: Cost::Sample,
            trial: moderate_gain,
        },
        Engine {
            name: "braking_feedback_never_passes_the_reference_at_any_gain",
            unit: "rad",
            about: About::Other,
            cost: Cost::Sample,
            trial: braking,
        },
    ],
};

/// One joint with a speed limit (rad/s) and limits of deceleration and acceleration (rad/s²).
///
/// # Errors
///
/// Numbers that the regulator refuses.
pub fn regulator(speed: f64, limits: [f64; 2], recovery: Recovery) -> Result<AccelerationRegulator<1>, ParameterError> {
    let [deceleration, acceleration] = limits;
    AccelerationRegulator::new(AccelerationSettings {
        speed_limits: SpeedLimits::symmetric([speed])?,
        acceleration_limits: AccelerationLimits::new([-deceleration], [acceleration])?,
        sampling_period: TS,
        bandwidth: 1.0,
        target_rate: 1.0,
        recovery,
    })
}

/// Runs the loop from rest; the least error on the way. Rounding: of 400 errors of at most 1 each, 1e-13 in all.
fn least_error(regulator: &AccelerationRegulator<1>, gain: f64, mut error: f64) -> f64 {
    let mut state = AccelerationState::at_rest();
    let mut least = error;
    for _ in 0..400 {
        let desired = AffineSpeed { feedback: [gain * error], feedforward: [0.0] };
        let [speed] = regulator.step(&mut state, &desired).joint_speed;
        error -= TS * speed;
        least = least.min(error);
    }
    least + 1e-13
}

fn moderate_gain(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let (error, speed) = (choices.between(1e-3, 1.0), choices.between(0.05, 2.0));
    let limits = choices.numbers::<2>(0.5, 200.0);
    let gain = choices.share().max(0.01) * (limits[0] / speed).min(1.0 / TS);
    Ok(least_error(&regulator(speed, limits, Recovery::AsDemanded)?, gain, error))
}

fn braking(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let (error, speed, gain) = (choices.between(1e-3, 1.0), choices.between(0.05, 2.0), choices.between(1.0, 512.0));
    let limits = choices.numbers::<2>(0.5, 200.0);
    Ok(least_error(&regulator(speed, limits, Recovery::Braking { gain })?, gain, error))
}
