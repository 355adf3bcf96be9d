use super::constraint::Motion;

/// Why the conditioned reference was held where it stood.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HoldReason {
    /// The reference contains a NaN or an infinity.
    ReferenceNotFinite,
    /// This constraint's value or derivatives contain a NaN or an infinity.
    ConstraintNotFinite(usize),
    /// This constraint acts and its gradient vanishes: there is no direction to push.
    EmptyGradient(usize),
    /// The gradients of the active constraints cancel: the explicit push has no direction.
    OpposedGradients,
    /// This constraint cannot be met together with the others.
    Contradiction(usize),
    /// The smallest correction was not found within the stated number of steps.
    CorrectionNotFound,
}

/// Outcome of one sample: the reference passed as it is, was bent, or was held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PathOutcome {
    /// No constraint acted.
    Free,
    /// At least one constraint acted; `share` tells which.
    Acting,
    /// The push was not enough and the reserve acted; `reserve` is what it added.
    Reserve,
    /// The reference was held, at rest, at the last position that was given out.
    Held(HoldReason),
}

/// State of the trap avoidance at one sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TrapPhase {
    /// The reference moves on.
    Following,
    /// The reference waits and the walk, if any, returns to zero.
    Returning,
    /// The reference waits and the walk searches along the boundary.
    Walking,
    /// As many independent constraints are active as there are dimensions: no direction is left to walk in.
    Blocked,
}

/// Output of one sample: the conditioned reference and the audit of how it was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathStep<const N: usize, const M: usize> {
    /// The conditioned reference `p*` and its velocity, always finite.
    pub motion: Motion<N>,
    /// Outcome of the sample.
    pub outcome: PathOutcome,
    /// `σ_i` at the conditioned reference. NaN only where the constraint itself gives NaN.
    pub sigma: [f64; M],
    /// `φ_i` at the conditioned reference, without margin.
    pub phi: [f64; M],
    /// Share of each constraint in the push, 0 where it does not act; the shares of a push sum to 1.
    pub share: [f64; M],
    /// `u_1`: for the explicit forms the push of the coming interval, for the implicit form that of the past one.
    pub push: [f64; N],
    /// Push that the reserve added in the past interval: zero unless the outcome says so.
    pub reserve: [f64; N],
    /// Filtered correction `f_SM`.
    pub correction: [f64; N],
    /// Walk `f_RW`.
    pub walk: [f64; N],
    /// State of the trap avoidance.
    pub trap: TrapPhase,
    /// `f_SP` at the next sample: multiply the commanded path rate by it for the reference's velocity.
    pub pace: f64,
    /// Seconds by which the reference's own clock goes on until the next sample: the integral of `f_SP`.
    pub advance: f64,
}
