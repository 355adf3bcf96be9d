/// A limit of a joint's motion or strength.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitKind {
    /// Range of positions.
    Position,
    /// Largest speed.
    Velocity,
    /// Largest torque or force.
    Effort,
    /// Largest acceleration.
    Acceleration,
    /// Largest jerk.
    Jerk,
}

impl LimitKind {
    /// The limit's name, in the word of the URDF.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Position => "position",
            Self::Velocity => "velocity",
            Self::Effort => "effort",
            Self::Acceleration => "acceleration",
            Self::Jerk => "jerk",
        }
    }
}
