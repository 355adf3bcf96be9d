//! Enumerations as they cross the border: numbers, for a C program may write any number into a field.

use slideway_conditioner::shapes::Side;
use slideway_conditioner::{Advance, Saturation};

use crate::status::Status;

/// The law of a speed regulator.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpeedLaw {
    /// Explicit, as published: while a sample saturates, the reference runs ahead of the robot.
    Paper = 0,
    /// Explicit; the reference waits by as much as the robot is slowed.
    Synchronised = 1,
    /// Implicit (backward Euler): no chattering. It wants the desired joint speed in two parts, see `slideway_speed_step_affine`.
    Implicit = 2,
}

impl SpeedLaw {
    /// The advance of an explicit law; none for the implicit one.
    pub(crate) fn from_number(number: u32) -> Result<Option<Advance>, Status> {
        match number {
            0 => Ok(Some(Advance::Paper)),
            1 => Ok(Some(Advance::Synchronised)),
            2 => Ok(None),
            _ => Err(Status::Choice),
        }
    }
}

/// Rule that brings a joint speed beyond the limits back inside them.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SaturationKind {
    /// Each joint on its own: the tool leaves its direction of motion.
    Direct = 0,
    /// All joints by one factor: the direction of motion is kept.
    DirectionPreserving = 1,
}

impl SaturationKind {
    pub(crate) fn from_number(number: u32) -> Result<Saturation, Status> {
        match number {
            0 => Ok(Saturation::Direct),
            1 => Ok(Saturation::DirectionPreserving),
            _ => Err(Status::Choice),
        }
    }
}

/// Treatment of the part of an acceleration-limited regulator's demand that pulls the robot back to its path.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RecoveryKind {
    /// Leaves it as it is.
    AsDemanded = 0,
    /// Scales it so that the joints can brake from it, for a position loop of gain `gain`.
    Braking = 1,
}

/// Outcome of one sample of an acceleration-limited regulator: the demand is met, or not.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keeping {
    /// The demand is commanded as it is.
    OnPath = 0,
    /// No path rate makes the demand reachable: the joints do what is nearest to it, `excess` off.
    LeavesPath = 1,
    /// The demand is not finite: the joints brake as fast as they may, the reference stands.
    Brakes = 2,
}

/// The form of a path conditioner's law.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Implicit: the smallest push that keeps every constraint at every sample. Uses `recovery_rate`.
    Implicit = 0,
    /// Explicit sliding mode. Uses `law` and `push`.
    Sliding = 1,
    /// Explicit, and where its push is not enough the smallest one that is. Uses `law`, `push` and `recovery_rate`.
    SlidingWithReserve = 2,
    /// The scheme of the paper's appendix: one sample of lag. Uses `law` and `push`.
    Appendix = 3,
}

/// The switching law of an explicit form.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PushLaw {
    /// The sum of the active constraints' gradients; `push` is the switching gain.
    Sum = 0,
    /// Their direction at a fixed length; `push` is that length, in units of the position.
    Normalised = 1,
}

/// Margin added to each constraint, so that chattering stays inside the allowed set.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarginKind {
    /// Nothing.
    None = 0,
    /// The proven upper band of the form.
    Band = 1,
    /// The numbers in `margins`.
    Fixed = 2,
}

/// The trap avoidance of a path conditioner.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WalkKind {
    /// No trap avoidance.
    Off = 0,
    /// The walk as published; it may ask for more push than there is.
    Paper = 1,
    /// A walk no faster than a share of the push can bend along the boundary. Needs the sliding form with its reserve.
    Safe = 2,
}

/// The shape of a constraint.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShapeKind {
    /// The caller's own function. Uses `evaluate` and `context`.
    Callback = 0,
    /// One side of a plane, `vector . p <= offset`; the vector points out of the allowed side and may have any length.
    HalfSpace = 1,
    /// A ball: `point` is its centre, `radius`, `side`.
    Ball = 2,
    /// An endless cylinder: `point` on its axis, `vector` along it, `radius`, `side`.
    Cylinder = 3,
    /// An ellipsoid along the axes: `point` is its centre, `vector` holds the semi-axes, `scale`, `side`.
    Ellipsoid = 4,
    /// A box along the axes with smoothed edges: `point` is its centre, `vector` holds the half edges, `exponent`, `scale`, `side`.
    SmoothBox = 5,
    /// The oval of Booth: `vector` holds the weights, `radius`, `side`.
    BoothOval = 6,
    /// A convex polytope, smoothed: `normals`, `offsets`, `face_count`, `sharpness`, `side`.
    Polytope = 7,
}

/// The allowed side of a closed surface.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AllowedSide {
    /// Stay inside: a work space.
    Inside = 0,
    /// Stay outside: an obstacle.
    Outside = 1,
}

impl AllowedSide {
    pub(crate) fn from_number(number: u32) -> Result<Side, Status> {
        match number {
            0 => Ok(Side::Inside),
            1 => Ok(Side::Outside),
            _ => Err(Status::Choice),
        }
    }
}

/// Motion of a built-in shape, without turning. A callback moves by itself: it is told the time.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CarrierKind {
    /// It stands still.
    Still = 0,
    /// It is displaced by `velocity t + acceleration t^2 / 2`.
    Uniform = 1,
    /// It is displaced by `velocity sin(frequency t + phase)`; `velocity` holds the amplitudes, in units of the position.
    Oscillation = 2,
}

/// The filter's answer to one reference.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// No constraint acted.
    Free = 0,
    /// At least one constraint acted.
    Acting = 1,
    /// The push was not enough and the reserve acted.
    Reserve = 2,
    /// The reference was held, at rest, at the last position that was given out; `hold_reason` tells why.
    Held = 3,
}

/// Why the conditioned reference was held.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HoldCause {
    /// It was not held.
    None = 0,
    /// The reference contains a NaN or an infinity.
    ReferenceNotFinite = 1,
    /// A constraint's value or derivatives contain a NaN or an infinity, or its callback failed.
    ConstraintNotFinite = 2,
    /// A constraint acts and its gradient vanishes: there is no direction to push.
    EmptyGradient = 3,
    /// The gradients of the active constraints cancel: the explicit push has no direction.
    OpposedGradients = 4,
    /// A constraint cannot be met together with the others.
    Contradiction = 5,
    /// The smallest correction was not found within the stated number of steps.
    CorrectionNotFound = 6,
    /// The call itself failed: see its status. The position is what the structure held before.
    CallFailed = 7,
}

/// The trap avoidance's doing at one sample.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// The reference moves on.
    Following = 0,
    /// The reference waits and the walk, if any, returns to zero.
    Returning = 1,
    /// The reference waits and the walk searches along the boundary.
    Walking = 2,
    /// As many independent constraints are active as there are dimensions: no direction is left to walk in.
    Blocked = 3,
}
