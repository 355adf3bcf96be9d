/// Fault that makes the controller brake and wait to be reset or recovered.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Fault {
    /// Somebody pressed the button.
    EmergencyStop,
    /// A drive reports an error.
    Drive,
    /// The joints are too far from their reference.
    Tracking,
    /// The tool could not be followed: singularity, joint stop, no inverse kinematics.
    Tool,
    /// A sample could not be computed, for instance from a sampling period that is NaN.
    Computation,
}

impl Fault {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::EmergencyStop, Self::Drive, Self::Tracking, Self::Tool, Self::Computation];
}

/// Where a full brake leads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AfterBrake {
    /// To [`Mode::Idle`].
    Idle,
    /// To [`Mode::Fault`].
    Fault(Fault),
}

/// The mode of the controller.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Mode {
    /// At rest; motions may be queued and started.
    Idle,
    /// Following a joint segment.
    JointMotion,
    /// Following a Cartesian segment.
    ToolMotion,
    /// Slowing down along the path.
    BrakingOnPath,
    /// At rest in the middle of the path, which is kept.
    Paused,
    /// Slowing down as fast as the joints can; the path is given up.
    BrakingFully(AfterBrake),
    /// At rest, after a fault; nothing moves until it is reset.
    Fault(Fault),
    /// Moving slowly back to a known place after a fault.
    Recovery(Fault),
}

impl Mode {
    /// All modes.
    pub fn all() -> impl Iterator<Item = Self> {
        let plain = [
            Self::Idle,
            Self::JointMotion,
            Self::ToolMotion,
            Self::BrakingOnPath,
            Self::Paused,
            Self::BrakingFully(AfterBrake::Idle),
        ];
        let faulty = Fault::ALL.into_iter().flat_map(|fault| {
            [Self::BrakingFully(AfterBrake::Fault(fault)), Self::Fault(fault), Self::Recovery(fault)]
        });
        plain.into_iter().chain(faulty)
    }

    /// True if the joints rest in this mode.
    #[must_use]
    pub fn is_at_rest(self) -> bool {
        match self {
            Self::Idle | Self::Paused | Self::Fault(_) => true,
            Self::JointMotion | Self::ToolMotion | Self::BrakingOnPath | Self::BrakingFully(_) | Self::Recovery(_) => {
                false
            }
        }
    }
}

/// Kind of the segment at the head of the queue.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SegmentKind {
    /// Joints by their profiles.
    Joint,
    /// The tool along a line.
    Tool,
}

/// State of the queue as the supervisor sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum QueueState {
    /// Empty, joints at rest.
    Resting,
    /// A segment to follow.
    Ready(SegmentKind),
    /// A segment to follow, at a pace of zero.
    Paused(SegmentKind),
}

/// Inputs from outside in a sample; any combination may be.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Inputs {
    /// A fault that is present.
    pub fault: Option<Fault>,
    /// Brake at once, whatever the path.
    pub brake_fully: bool,
    /// Brake along the path.
    pub brake_on_path: bool,
    /// Give up a paused path.
    pub discard: bool,
    /// Go on along a paused path.
    pub resume: bool,
    /// Start what is queued.
    pub start: bool,
    /// A fault has been dealt with and the arm may stay where it is.
    pub reset: bool,
    /// A fault has been dealt with and a joint motion to a known place is queued.
    pub recover: bool,
}

/// All that a sample is decided by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Signals {
    /// From outside.
    pub inputs: Inputs,
    /// A brake on the path takes longer than it may.
    pub overdue: bool,
    /// The queue.
    pub queue: QueueState,
}
