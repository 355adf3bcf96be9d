use super::filters::below_nyquist;
use super::quantity::PathQuantity;
use crate::error::{ParameterError, positive};

/// The discontinuous push `u_SM`, `[G12] eq 13`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SwitchingLaw {
    /// `u = -u⁺ Σ α1² K_i ∇σ_i` over the active constraints, `[G12] eq 20`. Sliding needs `u⁺ > max μ_i`, see
    /// [`crate::path::bounds::required_gain`].
    Sum {
        /// The switching gain `u⁺`.
        gain: f64,
    },
    /// The direction of `-Σ ∇σ_i` over the active constraints at a fixed length `U`, the law of the paper's appendix.
    Normalised {
        /// The length `U`, in units of the position.
        amplitude: f64,
    },
}

/// Fallback of an explicit form for when its push is not enough.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reserve {
    /// None, as published: a constraint may break.
    Off,
    /// Adds the smallest push that brings every constraint back into its band at this very sample, and reports it.
    On {
        /// Rate at which a band left behind is regained, in units of `σ` per second.
        recovery_rate: f64,
    },
}

/// The form of the law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PathForm {
    /// Explicit sliding mode on exact zero-order-hold filters with analytic velocity: the default.
    Sliding {
        /// The switching law.
        law: SwitchingLaw,
        /// Fallback for when the push is not enough.
        reserve: Reserve,
    },
    /// The appendix's scheme: prewarped Tustin filters, finite differences, one sample of lag.
    Appendix {
        /// The switching law; the appendix uses [`SwitchingLaw::Normalised`].
        law: SwitchingLaw,
    },
    /// Implicit (backward-Euler) sliding mode: at each sample the smallest push with `φ_i <= 0` for every constraint.
    Implicit {
        /// From outside, `φ_i` falls at least this fast, in units of `σ` per second.
        recovery_rate: f64,
    },
}

/// Margin added to every `φ_i`, so that chattering stays inside the allowed set (`[G12] 5.2`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Margin<const M: usize> {
    /// Nothing.
    None,
    /// The proven upper band of the form, see [`crate::path::bounds`]: one full push for zero-order hold, two for the
    /// appendix's scheme, nothing for the implicit form.
    Band,
    /// A fixed margin for each constraint, in units of its `σ`.
    Fixed([f64; M]),
}

/// Speed law of the walk out of a trap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Walk {
    /// `Kc + Kv t_trap`, `[G12] eq 27`. May ask for more push than there is: constraints can break.
    Paper,
    /// At most `Kc + Kv t_trap`, and no faster than a share of the push can bend along the boundary. For the explicit
    /// form with its reserve, which answers for what the limit did not foresee: the walk brakes with its filter's lag.
    /// Every constraint then stays in its band, whatever the boundary's shape.
    Safe {
        /// The share, in (0, 1). Larger than what holding the reference at the boundary takes by itself, or the walk
        /// never sets out.
        push_share: f64,
    },
}

/// Parameters of the trap avoidance of `[G12] section 6`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrapSettings {
    /// Cutoff frequency `α2` of the walk filter, rad/s.
    pub walk_cutoff: f64,
    /// Cutoff frequency of the filter behind `f_SP`, rad/s.
    pub pace_cutoff: f64,
    /// Speed law of the walk.
    pub walk: Walk,
    /// `Kc`, walk speed at first, units of position per second.
    pub walk_speed: f64,
    /// `Kv`, growth of the walk speed, units of position per second squared.
    pub walk_growth: f64,
    /// `Ke`, gain of the return, 1/s; `α2 / 4` damps it critically.
    pub return_gain: f64,
    /// `T_F`, how long one random direction lasts, s.
    pub direction_period: f64,
    /// `ε1`: the conditioned reference is lost when farther than this from the reference.
    pub distance_threshold: f64,
    /// `ε2`: the reference counts as clearly inside when every `φ_i` is below `-ε2`.
    pub clearance_threshold: f64,
    /// `ε3`: a constraint counts as active for the walk when its `φ_i` is above `-ε3`. The safe walk raises it to the
    /// band where the band is wider (`[G12] 7.2.1`).
    pub activity_threshold: f64,
    /// Seed of the random directions: equal seeds walk equally.
    pub seed: u64,
}

/// Parameters of a path conditioner, validated by [`crate::PathConditioner::new`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathSettings<const M: usize> {
    /// Sampling period `T`, s.
    pub sampling_period: f64,
    /// Cutoff frequency `α1` of the second-order push filter, rad/s.
    pub push_cutoff: f64,
    /// Constraint approaching parameter `K_i` of each constraint, s: the boundary is neared with this time constant.
    pub approach: [f64; M],
    /// Safety margin.
    pub margin: Margin<M>,
    /// The form of the law.
    pub form: PathForm,
    /// Trap avoidance, if wanted.
    pub trap: Option<TrapSettings>,
}

fn accept(quantity: PathQuantity, value: f64, inside: bool) -> Result<(), ParameterError> {
    if inside && value.is_finite() { Ok(()) } else { Err(ParameterError::Path { quantity, value }) }
}

fn above_zero(quantity: PathQuantity, value: f64) -> Result<(), ParameterError> {
    accept(quantity, value, value > 0.0)
}

fn not_negative(quantity: PathQuantity, value: f64) -> Result<(), ParameterError> {
    accept(quantity, value, value >= 0.0)
}

impl<const M: usize> PathSettings<M> {
    pub(crate) fn validate(&self) -> Result<(), ParameterError> {
        positive(self.sampling_period, ParameterError::SamplingPeriod)?;
        above_zero(PathQuantity::PushCutoff, self.push_cutoff)?;
        self.below_nyquist(PathQuantity::PushCutoff, self.push_cutoff)?;
        for (i, &k) in self.approach.iter().enumerate() {
            above_zero(PathQuantity::Approach(i), k)?;
        }
        if let Margin::Fixed(margins) = &self.margin {
            for (i, &m) in margins.iter().enumerate() {
                not_negative(PathQuantity::Margin(i), m)?;
            }
        }
        self.form.validate()?;
        self.trap.iter().try_for_each(|trap| self.validate_trap(trap))
    }

    /// The push filter and the trap's filters have to be slower than the sampling.
    fn below_nyquist(&self, quantity: PathQuantity, cutoff: f64) -> Result<(), ParameterError> {
        accept(quantity, cutoff, below_nyquist(cutoff, self.sampling_period))
    }

    fn validate_trap(&self, trap: &TrapSettings) -> Result<(), ParameterError> {
        for (quantity, value) in [
            (PathQuantity::WalkCutoff, trap.walk_cutoff),
            (PathQuantity::PaceCutoff, trap.pace_cutoff),
            (PathQuantity::WalkSpeed, trap.walk_speed),
            (PathQuantity::ReturnGain, trap.return_gain),
            (PathQuantity::DirectionPeriod, trap.direction_period),
            (PathQuantity::DistanceThreshold, trap.distance_threshold),
        ] {
            above_zero(quantity, value)?;
        }
        for (quantity, value) in [
            (PathQuantity::WalkGrowth, trap.walk_growth),
            (PathQuantity::ClearanceThreshold, trap.clearance_threshold),
            (PathQuantity::ActivityThreshold, trap.activity_threshold),
        ] {
            not_negative(quantity, value)?;
        }
        self.below_nyquist(PathQuantity::WalkCutoff, trap.walk_cutoff)?;
        self.below_nyquist(PathQuantity::PaceCutoff, trap.pace_cutoff)?;
        match (trap.walk, self.form) {
            (Walk::Paper, _) => Ok(()),
            (Walk::Safe { push_share }, PathForm::Sliding { reserve: Reserve::On { .. }, .. }) => {
                accept(PathQuantity::PushShare, push_share, push_share > 0.0 && push_share < 1.0)
            }
            (Walk::Safe { .. }, _) => Err(ParameterError::SafeWalkWithoutReserve),
        }
    }
}

impl PathForm {
    /// The switching law of an explicit form.
    pub(crate) fn law(&self) -> Option<SwitchingLaw> {
        match *self {
            Self::Sliding { law, .. } | Self::Appendix { law } => Some(law),
            Self::Implicit { .. } => None,
        }
    }

    fn validate(&self) -> Result<(), ParameterError> {
        match self.law() {
            Some(SwitchingLaw::Sum { gain: push } | SwitchingLaw::Normalised { amplitude: push }) => {
                above_zero(PathQuantity::Push, push)?;
            }
            None => {}
        }
        match *self {
            Self::Implicit { recovery_rate } | Self::Sliding { reserve: Reserve::On { recovery_rate }, .. } => {
                above_zero(PathQuantity::RecoveryRate, recovery_rate)
            }
            Self::Sliding { reserve: Reserve::Off, .. } | Self::Appendix { .. } => Ok(()),
        }
    }
}
