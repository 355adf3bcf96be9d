use serde::{Deserialize, Serialize};
use std::fmt;

/// The speed laws that are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Method {
    /// Fixed speed, joints without limits (case 1 of `[G11]`).
    Ideal,
    /// Fixed speed, each joint saturated on its own (case 2).
    Saturated,
    /// Fixed speed, direction-preserving saturation (case 3).
    DirectionPreserving,
    /// Constant path speed, the largest that keeps the speed limits; the arm exactly on the path (`[N]`).
    ConstantSpeed,
    /// Natural motion: path speed in proportion to the determinant of the Jacobian, as fast as the speed limits allow; the arm
    /// exactly on the path (`[N]`).
    NaturalMotion,
    /// Sliding-mode regulation as published (case 4).
    SlidingMode,
    /// Sliding-mode regulation, the reference waiting for the robot.
    SlidingModeSynchronised,
    /// Sliding-mode regulation, backward-Euler form.
    SlidingModeImplicit,
    /// Sliding-mode regulation, backward-Euler form, under acceleration limits.
    AccelerationLimited,
    /// The same with a window of the path ahead.
    AccelerationLookAhead,
}

impl Method {
    /// All methods, in the order of the tables.
    pub const ALL: [Self; 10] = [
        Self::Ideal,
        Self::Saturated,
        Self::DirectionPreserving,
        Self::ConstantSpeed,
        Self::NaturalMotion,
        Self::SlidingMode,
        Self::SlidingModeSynchronised,
        Self::SlidingModeImplicit,
        Self::AccelerationLimited,
        Self::AccelerationLookAhead,
    ];

    /// The methods that need neither acceleration limits nor a `[natural]` table.
    pub const UNDER_SPEED_LIMITS: [Self; 6] = [
        Self::Ideal,
        Self::Saturated,
        Self::DirectionPreserving,
        Self::SlidingMode,
        Self::SlidingModeSynchronised,
        Self::SlidingModeImplicit,
    ];

    /// The name used in files, tables and on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Ideal => "ideal",
            Self::Saturated => "saturated",
            Self::DirectionPreserving => "direction-preserving",
            Self::ConstantSpeed => "constant-speed",
            Self::NaturalMotion => "natural-motion",
            Self::SlidingMode => "sliding-mode",
            Self::SlidingModeSynchronised => "sliding-mode-synchronised",
            Self::SlidingModeImplicit => "sliding-mode-implicit",
            Self::AccelerationLimited => "acceleration-limited",
            Self::AccelerationLookAhead => "acceleration-look-ahead",
        }
    }

    /// True if the speed is regulated, rather than fixed in advance.
    #[must_use]
    pub fn is_regulated(self) -> bool {
        !self.surveys_the_path() && !matches!(self, Self::Ideal | Self::Saturated | Self::DirectionPreserving)
    }

    /// True if the method is one of `[N]`: its speed chosen from a survey of the whole path, the arm exactly on it.
    #[must_use]
    pub fn surveys_the_path(self) -> bool {
        matches!(self, Self::ConstantSpeed | Self::NaturalMotion)
    }

    /// True if the method keeps limits on joint acceleration, and needs them.
    #[must_use]
    pub fn limits_acceleration(self) -> bool {
        matches!(self, Self::AccelerationLimited | Self::AccelerationLookAhead)
    }

    /// True if the recorded bound on the change of the desired speed holds: it does not where the feedback is slowed.
    #[must_use]
    pub fn bounds_chattering(self) -> bool {
        self.is_regulated() && !self.limits_acceleration()
    }

    /// The method's knowledge in advance, in words for the comparison's table.
    #[must_use]
    pub fn knows(self) -> &'static str {
        match self {
            Self::Ideal => "nothing, and has no limits",
            Self::Saturated | Self::DirectionPreserving => "a speed chosen by hand",
            Self::ConstantSpeed | Self::NaturalMotion => "the speed limits and the whole path",
            Self::SlidingMode | Self::SlidingModeSynchronised | Self::SlidingModeImplicit => "the speed limits only",
            Self::AccelerationLimited => "the speed and acceleration limits only",
            Self::AccelerationLookAhead => "the limits and a window of the path ahead",
        }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}
