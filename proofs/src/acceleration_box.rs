//! Claim `acceleration-box`: speeds and accelerations stay inside their limits, whatever is asked.
//!
//! Hypotheses: `lower < 0 < upper` (rad/s), `a_lower < 0 < a_upper` (rad/s²), `Ts > 0` (s), the previous command `p` inside the speed
//! limits. The demand is arbitrary; NaN and infinities brake.
//!
//! ```text
//! low = clamp(p + Ts a_lower), high = clamp(p + Ts a_upper),  clamp(v) = min(max(v, lower), upper)
//! command = min(max(demand, low), high)
//! ```
//!
//! Source: this project.
//!
//! Derivation. `p + Ts a_lower < p < p + Ts a_upper` and `lower <= p <= upper`, so `low <= p <= high`: the box is not empty, and its
//! ends are no further from `p` than the acceleration limits allow. By induction every command is the next sample's `p`.
//!
//! Rounding. The speed limits hold to the last bit, for the clamp comes last. `Ts a` and `p + Ts a` round once each, so the change holds
//! to one unit in the last place of `|p| + Ts |a|`.
//!
//! Dropped hypothesis: that the previous command is inside the speed limits.

use slideway_conditioner::acceleration::{
    AccelerationLimits, AccelerationRegulator, AccelerationSettings, AccelerationState, Recovery,
};
use slideway_conditioner::{AffineSpeed, ParameterError, SpeedLimits};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::draw::{self, ROUNDOFF, TS, filter_step, limits};
use crate::engine::{About, Choices, Cost, Engine, Stop, exactly, worse};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "acceleration-box",
    statement: "For any demand whatever the acceleration-limited command lies inside the speed limits and within the acceleration limits of the command before.",
    source: "this project",
    verdict: Verdict::Ours,
    negations: &[Script { file: "acceleration-box.smt2", text: include_str!("../smt/acceleration-box.smt2") }],
    twins: &[Twin {
        without: "previous-inside",
        script: Script {
            file: "acceleration-box-without-previous-inside.smt2",
            text: include_str!("../smt/acceleration-box-without-previous-inside.smt2"),
        },
    }],
    engines: &[Engine {
        name: "every_command_is_in_the_box",
        unit: "rad/s",
        about: About::Other,
        cost: Cost::Sample,
        trial: in_the_box,
    }],
};

/// Period [`TS`], target rate 5 1/s, feedback as demanded.
///
/// # Errors
///
/// Errors of the shipped regulator: settings that it refuses.
pub fn regulator<const N: usize>(
    speed_limits: SpeedLimits<N>,
    acceleration_limits: AccelerationLimits<N>,
    filter_step: f64,
) -> Result<AccelerationRegulator<N>, ParameterError> {
    AccelerationRegulator::new(AccelerationSettings {
        speed_limits,
        acceleration_limits,
        sampling_period: TS,
        bandwidth: filter_step / TS,
        target_rate: 5.0,
        recovery: Recovery::AsDemanded,
    })
}

/// Rounding: the sum and the difference in the check round once each; `TS` is a power of two, so the product does not.
fn in_the_box(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let (speeds, accelerations) = (limits::<3>(choices, -2.0, 2.0)?, limits::<3>(choices, -2.0, 3.0)?);
    let (start, a) = (choices.share(), filter_step(choices));
    let mut before = [0.0; 3];
    for ((v, lo), up) in before.iter_mut().zip(speeds.lower()).zip(speeds.upper()) {
        *v = (lo + choices.share() * (up - lo)).max(*lo).min(*up);
    }
    let desired = AffineSpeed { feedback: draw::wild(choices, 10.0), feedforward: draw::wild(choices, 10.0) };
    let ceiling = choices.bits();
    let regulator = regulator(speeds, AccelerationLimits::new(*accelerations.lower(), *accelerations.upper())?, a)?;
    let mut state = AccelerationState::moving(start, before, &speeds)?;
    let command = regulator.step_below(&mut state, &desired, ceiling);
    let mut margin = exactly(speeds.contain(&command.joint_speed) && (0.0..=1.0).contains(&command.factor));
    let ends = accelerations.lower().iter().zip(accelerations.upper());
    for ((c, p), (lo, up)) in command.joint_speed.iter().zip(&before).zip(ends) {
        let slack = 2.0 * ROUNDOFF * (c.abs() + p.abs() + TS * (up - lo));
        margin = worse(margin, worse(c - p - (TS * lo - slack), TS * up + slack - (c - p)));
    }
    Ok(margin)
}
