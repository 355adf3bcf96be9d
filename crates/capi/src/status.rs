use core::ffi::{CStr, c_char};

/// The answer of every function that can refuse: 0 where it did what it was asked.
///
/// Numbers are never reused or renumbered. From 100 on a parameter was refused; `slideway_refusal` then says which value.
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// Done.
    Ok = 0,
    /// A pointer that must not be null is null.
    Null = 1,
    /// A pointer is not aligned for what it points to.
    Alignment = 2,
    /// The first field `size` is of no version of this structure that the library knows.
    Size = 3,
    /// The memory for an object is too small.
    Memory = 4,
    /// No memory is left on the heap.
    OutOfMemory = 5,
    /// The pointer is no living object of this kind.
    Object = 6,
    /// The object is in use: one of its own callbacks calls it.
    Busy = 7,
    /// The object lies in the caller's memory and has no `free`, or on the heap and is freed, not dropped.
    Owner = 8,
    /// The function belongs to another law than the object's.
    Law = 9,
    /// A number of joints or coordinates outside of 1 to `SLIDEWAY_MAX_JOINTS`.
    Joints = 10,
    /// A number of constraints outside of 1 to `SLIDEWAY_MAX_CONSTRAINTS`.
    Constraints = 11,
    /// A field that holds one of an enumeration's values holds none of them.
    Choice = 12,
    /// A length that no array can have.
    Length = 13,
    /// An upper joint-speed limit is not positive and finite.
    UpperSpeed = 100,
    /// A lower joint-speed limit is not negative and finite.
    LowerSpeed = 101,
    /// An upper joint-acceleration limit is not positive and finite.
    UpperAcceleration = 102,
    /// A lower joint-acceleration limit is not negative and finite.
    LowerAcceleration = 103,
    /// A joint speed to start from lies outside its limits.
    Speed = 104,
    /// The gain of the position loop is not positive and finite.
    Gain = 105,
    /// Gain times sampling period exceeds one half.
    GainStep = 106,
    /// The look-ahead's margin is not in [0, 1).
    AccelerationMargin = 107,
    /// The sampling period is not positive and finite.
    SamplingPeriod = 108,
    /// The filter bandwidth is not positive and finite.
    Bandwidth = 109,
    /// The target rate is not positive and finite.
    TargetRate = 110,
    /// Bandwidth times sampling period exceeds 1.
    FilterStep = 111,
    /// A speed factor outside [0, 1].
    Factor = 112,
    /// The safe walk without the explicit form and its reserve.
    SafeWalk = 113,
    /// The push filter's cutoff is out of range.
    PushCutoff = 120,
    /// An approach time is out of range.
    Approach = 121,
    /// A safety margin is out of range.
    Margin = 122,
    /// The push's gain or amplitude is out of range.
    Push = 123,
    /// The recovery rate is out of range.
    RecoveryRate = 124,
    /// The walk filter's cutoff is out of range.
    WalkCutoff = 125,
    /// The pace filter's cutoff is out of range.
    PaceCutoff = 126,
    /// The walk speed is out of range.
    WalkSpeed = 127,
    /// The growth of the walk speed is out of range.
    WalkGrowth = 128,
    /// The gain of the walk's return is out of range.
    ReturnGain = 129,
    /// The period of the random direction is out of range.
    DirectionPeriod = 130,
    /// The distance threshold is out of range.
    DistanceThreshold = 131,
    /// The clearance threshold is out of range.
    ClearanceThreshold = 132,
    /// The activity threshold is out of range.
    ActivityThreshold = 133,
    /// The share of the push left to the walk is out of range.
    PushShare = 134,
    /// A coordinate to start from is not finite.
    Start = 135,
    /// A coordinate of a shape is not finite.
    ShapeCoordinate = 150,
    /// A component of a normal or an axis is not finite.
    ShapeDirection = 151,
    /// A normal or an axis has no length.
    ShapeDirectionLength = 152,
    /// The offset of a plane is not finite.
    ShapeOffset = 153,
    /// A radius is not positive and finite.
    ShapeRadius = 154,
    /// A semi-axis or half edge is not positive and finite.
    ShapeSemiAxis = 155,
    /// A scale is not positive and finite.
    ShapeScale = 156,
    /// The exponent of a box lies outside [2, 64].
    ShapeExponent = 157,
    /// A sharpness is not positive and finite.
    ShapeSharpness = 158,
    /// A number of faces outside of 1 to `SLIDEWAY_MAX_FACES`.
    ShapeFaceCount = 159,
    /// A weight is not positive and finite.
    ShapeWeight = 160,
    /// A parameter of a shape's carrier is not finite.
    ShapeCarrier = 161,
    /// A parameter that a newer core checks and this interface has no name for.
    Parameter = 199,
}

impl Status {
    /// One sentence: what is wrong, and what is right.
    #[must_use]
    pub fn message(self) -> &'static CStr {
        match self {
            Self::Ok => c"done",
            Self::Null => c"a pointer is null that must not be",
            Self::Alignment => {
                c"a pointer is not aligned; objects lie on multiples of SLIDEWAY_ALIGNMENT, numbers on their own size"
            }
            Self::Size => c"the field size is of no known version; set it to the sizeof of the structure",
            Self::Memory => c"the memory is too small; ask the size function of the object for its size",
            Self::OutOfMemory => c"no memory is left on the heap",
            Self::Object => c"the pointer is no living object of this kind; make one, and do not use it after it ends",
            Self::Busy => c"the object is in use; a callback must not call the object that calls it",
            Self::Owner => c"the object ends as it began: free what new made, drop what lies in your own memory",
            Self::Law => c"this function belongs to another law than the object was made with",
            Self::Joints => c"the number of joints or coordinates must be from 1 to SLIDEWAY_MAX_JOINTS",
            Self::Constraints => c"the number of constraints must be from 1 to SLIDEWAY_MAX_CONSTRAINTS",
            Self::Choice => c"a field holds none of the values of its enumeration",
            Self::Length => c"an array is longer than the address space",
            _ => self.parameter(),
        }
    }

    /// The sentence of a parameter that was refused.
    fn parameter(self) -> &'static CStr {
        match self {
            Self::UpperSpeed => c"an upper speed limit must be positive and finite",
            Self::LowerSpeed => c"a lower speed limit must be negative and finite",
            Self::UpperAcceleration => c"an upper acceleration limit must be positive and finite",
            Self::LowerAcceleration => c"a lower acceleration limit must be negative and finite",
            Self::Speed => c"a joint speed to start from must lie inside its limits",
            Self::Gain => c"the position gain (1/s) must be positive and finite",
            Self::GainStep => c"gain times sampling period must not exceed 0.5; lower the gain or sample faster",
            Self::AccelerationMargin => c"the share of the acceleration limits kept in reserve must lie in [0, 1)",
            Self::SamplingPeriod => c"the sampling period (s) must be positive and finite",
            Self::Bandwidth => c"the filter bandwidth (rad/s) must be positive and finite",
            Self::TargetRate => c"the target rate of the path parameter (1/s) must be positive and finite",
            Self::FilterStep => {
                c"bandwidth times sampling period must not exceed 1; lower the bandwidth or sample faster"
            }
            Self::Factor => c"a speed factor must lie in [0, 1]",
            Self::SafeWalk => c"the safe walk needs the sliding form with its reserve",
            Self::Start => c"a coordinate to start from must be finite",
            Self::Parameter => c"a parameter is out of range",
            _ => self.path().unwrap_or_else(|| self.shape()),
        }
    }

    /// The sentence of a quantity of the path conditioner.
    fn path(self) -> Option<&'static CStr> {
        Some(match self {
            Self::PushCutoff => c"the push filter's cutoff (rad/s) must be positive and below pi / sampling period",
            Self::Approach => c"the approach time of a constraint (s) must be positive and finite",
            Self::Margin => c"the safety margin of a constraint must not be negative, and finite",
            Self::Push => c"the push's gain or amplitude must be positive and finite",
            Self::RecoveryRate => c"the recovery rate must be positive and finite",
            Self::WalkCutoff => c"the walk filter's cutoff (rad/s) must be positive and below pi / sampling period",
            Self::PaceCutoff => c"the pace filter's cutoff (rad/s) must be positive and below pi / sampling period",
            Self::WalkSpeed => c"the walk speed must be positive and finite",
            Self::WalkGrowth => c"the growth of the walk speed must not be negative, and finite",
            Self::ReturnGain => c"the return gain (1/s) must be positive and finite",
            Self::DirectionPeriod => c"the period of the random direction (s) must be positive and finite",
            Self::DistanceThreshold => c"the distance threshold must be positive and finite",
            Self::ClearanceThreshold => c"the clearance threshold must not be negative, and finite",
            Self::ActivityThreshold => c"the activity threshold must not be negative, and finite",
            Self::PushShare => c"the share of the push left to the walk must lie between 0 and 1",
            _ => return None,
        })
    }

    /// The sentence of a parameter of a shape.
    fn shape(self) -> &'static CStr {
        match self {
            Self::ShapeCoordinate => c"a coordinate of a shape must be finite",
            Self::ShapeDirection => c"a component of a normal or an axis must be finite",
            Self::ShapeDirectionLength => c"a normal or an axis must be longer than zero",
            Self::ShapeOffset => c"the offset of a plane, and its distance from the origin, must be finite",
            Self::ShapeRadius => c"a radius must be positive and finite",
            Self::ShapeSemiAxis => c"a semi-axis or half edge must be positive and finite",
            Self::ShapeScale => c"a scale must be positive and finite",
            Self::ShapeExponent => c"the exponent of a box must lie in [2, 64]",
            Self::ShapeSharpness => c"the sharpness must be positive and finite",
            Self::ShapeFaceCount => c"a polytope has from 1 to SLIDEWAY_MAX_FACES faces",
            Self::ShapeWeight => c"a weight must be positive and finite",
            Self::ShapeCarrier => c"velocity, acceleration, frequency and phase of a moving shape must be finite",
            _ => c"no status of this library",
        }
    }

    /// The status with this number, if there is one.
    fn from_number(number: i32) -> Option<Self> {
        Self::ALL.iter().copied().find(|status| *status as i32 == number)
    }

    /// Every status.
    const ALL: [Self; 57] = [
        Self::Ok,
        Self::Null,
        Self::Alignment,
        Self::Size,
        Self::Memory,
        Self::OutOfMemory,
        Self::Object,
        Self::Busy,
        Self::Owner,
        Self::Law,
        Self::Joints,
        Self::Constraints,
        Self::Choice,
        Self::Length,
        Self::UpperSpeed,
        Self::LowerSpeed,
        Self::UpperAcceleration,
        Self::LowerAcceleration,
        Self::Speed,
        Self::Gain,
        Self::GainStep,
        Self::AccelerationMargin,
        Self::SamplingPeriod,
        Self::Bandwidth,
        Self::TargetRate,
        Self::FilterStep,
        Self::Factor,
        Self::SafeWalk,
        Self::PushCutoff,
        Self::Approach,
        Self::Margin,
        Self::Push,
        Self::RecoveryRate,
        Self::WalkCutoff,
        Self::PaceCutoff,
        Self::WalkSpeed,
        Self::WalkGrowth,
        Self::ReturnGain,
        Self::DirectionPeriod,
        Self::DistanceThreshold,
        Self::ClearanceThreshold,
        Self::ActivityThreshold,
        Self::PushShare,
        Self::Start,
        Self::ShapeCoordinate,
        Self::ShapeDirection,
        Self::ShapeDirectionLength,
        Self::ShapeOffset,
        Self::ShapeRadius,
        Self::ShapeSemiAxis,
        Self::ShapeScale,
        Self::ShapeExponent,
        Self::ShapeSharpness,
        Self::ShapeFaceCount,
        Self::ShapeWeight,
        Self::ShapeCarrier,
        Self::Parameter,
    ];
}

/// One English sentence about a status, with the remedy. Never null; the text is static and never freed.
///
/// A number that is no status gets a sentence that says so.
#[unsafe(no_mangle)]
pub extern "C" fn slideway_status_message(status: i32) -> *const c_char {
    Status::from_number(status).map_or(c"no status of this library", Status::message).as_ptr()
}
