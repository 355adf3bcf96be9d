use core::fmt;

/// A parameter of the path conditioner, named in [`crate::ParameterError::Path`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PathQuantity {
    /// Cutoff frequency `α1` of the push filter, rad/s.
    PushCutoff,
    /// Constraint approaching parameter `K` of this constraint, s.
    Approach(usize),
    /// Safety margin of this constraint, in units of `σ`.
    Margin(usize),
    /// Switching gain `u⁺` or amplitude `U`.
    Push,
    /// Rate of recovery from outside, in units of `σ` per second.
    RecoveryRate,
    /// Cutoff frequency `α2` of the walk filter, rad/s.
    WalkCutoff,
    /// Cutoff frequency of the filter that scales the motion of the reference, rad/s.
    PaceCutoff,
    /// Walk speed `K_c`.
    WalkSpeed,
    /// Growth of the walk speed `K_v`.
    WalkGrowth,
    /// Gain `K_e` of the walk's return.
    ReturnGain,
    /// Period `T_F` of a new random direction, s.
    DirectionPeriod,
    /// Threshold `ε1` on the distance.
    DistanceThreshold,
    /// Threshold `ε2` on the clearance of the reference.
    ClearanceThreshold,
    /// Threshold `ε3` at which a constraint counts as active for the walk.
    ActivityThreshold,
    /// Share of the push that the safe walk may use, in (0, 1).
    PushShare,
    /// A coordinate of the starting position.
    Start(usize),
}

impl fmt::Display for PathQuantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::PushCutoff => write!(f, "push filter cutoff frequency (rad/s)"),
            Self::Approach(i) => write!(f, "approach time K of constraint {} (s)", i + 1),
            Self::Margin(i) => write!(f, "safety margin of constraint {}", i + 1),
            Self::Push => write!(f, "push amplitude or gain"),
            Self::RecoveryRate => write!(f, "recovery rate"),
            Self::WalkCutoff => write!(f, "walk filter cutoff frequency (rad/s)"),
            Self::PaceCutoff => write!(f, "pace filter cutoff frequency (rad/s)"),
            Self::WalkSpeed => write!(f, "walk speed Kc"),
            Self::WalkGrowth => write!(f, "walk speed growth Kv"),
            Self::ReturnGain => write!(f, "return gain Ke (1/s)"),
            Self::DirectionPeriod => write!(f, "period of the random direction (s)"),
            Self::DistanceThreshold => write!(f, "distance threshold"),
            Self::ClearanceThreshold => write!(f, "clearance threshold"),
            Self::ActivityThreshold => write!(f, "activity threshold"),
            Self::PushShare => write!(f, "share of the push left to the walk"),
            Self::Start(i) => write!(f, "coordinate {} of the starting position", i + 1),
        }
    }
}
