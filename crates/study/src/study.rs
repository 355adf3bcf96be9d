use crate::{
    Report, StudyError, cartesian_2r, high_gain_pid, impedance_wall, interrupts, opspace_vs_queue, profiles_vs_gravity,
    welding_cell,
};

/// A study.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Study {
    /// The four ways to interrupt a motion.
    Interrupts,
    /// Straight and cubic profiles, with and without gravity compensation.
    ProfilesVsGravity,
    /// PID with gains near those that shake.
    HighGainPid,
    /// Control in operational space against a Cartesian queue under joint PID.
    OpspaceVsQueue,
    /// A queue of Cartesian speeds on two joints.
    Cartesian2r,
    /// Pushing against a wall that gives way.
    ImpedanceWall,
    /// A seam between two Go-Tos, under two speed laws, braked half-way.
    WeldingCell,
}

impl Study {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::Interrupts,
        Self::ProfilesVsGravity,
        Self::HighGainPid,
        Self::OpspaceVsQueue,
        Self::Cartesian2r,
        Self::ImpedanceWall,
        Self::WeldingCell,
    ];

    /// The name by which it is called.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Interrupts => "interrupts",
            Self::ProfilesVsGravity => "profiles-vs-gravity",
            Self::HighGainPid => "high-gain-pid",
            Self::OpspaceVsQueue => "opspace-vs-queue",
            Self::Cartesian2r => "cartesian-2r",
            Self::ImpedanceWall => "impedance-wall",
            Self::WeldingCell => "welding-cell",
        }
    }

    /// Subject of the study, in one line.
    #[must_use]
    pub fn summary(self) -> &'static str {
        match self {
            Self::Interrupts => {
                "a path broken off in four ways: at a way-point, on the path, at full brake, for a new target"
            }
            Self::ProfilesVsGravity => "straight and cubic profiles under PID and under gravity compensation",
            Self::HighGainPid => "weight, pushes and far targets under PID with low and with high gains",
            Self::OpspaceVsQueue => "steps, a line and a push in operational space and under joint PID",
            Self::Cartesian2r => "Cartesian speeds for two joints, stopped before singularities and joint stops",
            Self::ImpedanceWall => "a compliant wall under position, impedance and force control",
            Self::WeldingCell => {
                "Go-To, seam under sliding mode and under natural motion beside the certified optimum, brake on it, recover"
            }
        }
    }

    /// The study of a name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|study| study.name() == name)
    }
}

/// Runs a study. `seed` is that of its noise, in studies that have any.
///
/// # Errors
///
/// A motion that was refused or that does not end.
pub fn run(study: Study, seed: u64) -> Result<Report, StudyError> {
    match study {
        Study::Interrupts => interrupts::run(),
        Study::ProfilesVsGravity => profiles_vs_gravity::run_study(seed),
        Study::HighGainPid => high_gain_pid::run_study(),
        Study::OpspaceVsQueue => opspace_vs_queue::run_study(),
        Study::Cartesian2r => cartesian_2r::run_study(seed),
        Study::ImpedanceWall => impedance_wall::run_study(seed),
        Study::WeldingCell => welding_cell::run(),
    }
}
