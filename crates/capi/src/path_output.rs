use slideway_conditioner::path::{HoldReason, PathOutcome, PathStep, TrapPhase};

use crate::choices::{HoldCause, Outcome, Phase};
use crate::command::put;
use crate::memory::{Output, sized};
use crate::refusal::NO_INDEX;
use crate::{MAX_CONSTRAINTS, MAX_JOINTS};

/// Output of one sample of a path conditioner, with the audit of how it was found. Of an array over coordinates the first `coordinates`
/// elements are written, of one over constraints the first `constraint_count`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct PathOutput {
    /// Size of this structure as the caller knows it: `sizeof(slideway_path_output)`.
    pub size: u32,
    /// One of `slideway_outcome`.
    pub outcome: u32,
    /// One of `slideway_hold_cause`.
    pub hold_reason: u32,
    /// The constraint that held the reference, counted from 0; `SLIDEWAY_NO_INDEX` where it is none.
    pub hold_constraint: u32,
    /// One of `slideway_phase`.
    pub trap: u32,
    /// Nothing; 0.
    pub reserved: u32,
    /// Time of the sample, s.
    pub time: f64,
    /// Conditioned position: where the reference goes.
    pub position: [f64; MAX_JOINTS],
    /// Its velocity, per second.
    pub velocity: [f64; MAX_JOINTS],
    /// Value of each constraint there; NaN only where the constraint itself gives NaN.
    pub sigma: [f64; MAX_CONSTRAINTS],
    /// Value of each constraint one approach time ahead, without margin.
    pub phi: [f64; MAX_CONSTRAINTS],
    /// Share of each constraint in the push, 0 where it does not act.
    pub share: [f64; MAX_CONSTRAINTS],
    /// The push: of the coming interval in the explicit forms, of the past one in the implicit form.
    pub push: [f64; MAX_JOINTS],
    /// Push that the reserve added in the past interval.
    pub reserve: [f64; MAX_JOINTS],
    /// Filtered correction.
    pub correction: [f64; MAX_JOINTS],
    /// Walk of the trap avoidance.
    pub walk: [f64; MAX_JOINTS],
    /// Multiply the commanded path rate by this for the velocity of the next reference; 1 without trap avoidance.
    pub pace: f64,
    /// Seconds by which the reference's own clock goes on until the next sample.
    pub advance: f64,
}

sized!(PathOutput);

/// Reason and constraint of a hold.
fn hold(reason: HoldReason) -> (HoldCause, u32) {
    let index = |i| u32::try_from(i).unwrap_or(NO_INDEX);
    match reason {
        HoldReason::ReferenceNotFinite => (HoldCause::ReferenceNotFinite, NO_INDEX),
        HoldReason::ConstraintNotFinite(i) => (HoldCause::ConstraintNotFinite, index(i)),
        HoldReason::EmptyGradient(i) => (HoldCause::EmptyGradient, index(i)),
        HoldReason::OpposedGradients => (HoldCause::OpposedGradients, NO_INDEX),
        HoldReason::Contradiction(i) => (HoldCause::Contradiction, index(i)),
        HoldReason::CorrectionNotFound => (HoldCause::CorrectionNotFound, NO_INDEX),
    }
}

impl PathOutput {
    pub(crate) fn fill<const N: usize, const M: usize>(&mut self, step: &PathStep<N, M>) {
        let (outcome, (cause, constraint)) = match step.outcome {
            PathOutcome::Free => (Outcome::Free, (HoldCause::None, NO_INDEX)),
            PathOutcome::Acting => (Outcome::Acting, (HoldCause::None, NO_INDEX)),
            PathOutcome::Reserve => (Outcome::Reserve, (HoldCause::None, NO_INDEX)),
            PathOutcome::Held(reason) => (Outcome::Held, hold(reason)),
        };
        (self.outcome, self.hold_reason, self.hold_constraint) = (outcome as u32, cause as u32, constraint);
        let phase = match step.trap {
            TrapPhase::Following => Phase::Following,
            TrapPhase::Returning => Phase::Returning,
            TrapPhase::Walking => Phase::Walking,
            TrapPhase::Blocked => Phase::Blocked,
        };
        (self.trap, self.reserved, self.time) = (phase as u32, 0, step.motion.time);
        put(&mut self.position, &step.motion.position);
        put(&mut self.velocity, &step.motion.velocity);
        put(&mut self.sigma, &step.sigma);
        put(&mut self.phi, &step.phi);
        put(&mut self.share, &step.share);
        put(&mut self.push, &step.push);
        put(&mut self.reserve, &step.reserve);
        put(&mut self.correction, &step.correction);
        put(&mut self.walk, &step.walk);
        (self.pace, self.advance) = (step.pace, step.advance);
    }
}

impl Output for PathOutput {
    /// The last position stays what it is, at rest. There is no position that is safe for every robot.
    #[cold]
    fn stand(&mut self) {
        self.velocity = [0.0; MAX_JOINTS];
        (self.outcome, self.hold_reason) = (Outcome::Held as u32, HoldCause::CallFailed as u32);
        (self.hold_constraint, self.pace, self.advance) = (NO_INDEX, 0.0, 0.0);
    }
}
