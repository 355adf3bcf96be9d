use slideway_conditioner::ParameterError;
use slideway_conditioner::path::PathQuantity;
use slideway_conditioner::shapes::ShapeParameter;

use crate::memory::{check_out, sized};
use crate::status::Status;

/// Which value was refused, for a message to the user.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Refusal {
    /// Size of this structure as the caller knows it: `sizeof(slideway_refusal)`.
    pub size: u32,
    /// Joint, coordinate or constraint, counted from 0; `SLIDEWAY_NO_INDEX` where the parameter has none.
    pub index: u32,
    /// The constraint whose shape was refused, counted from 0; `SLIDEWAY_NO_INDEX` where it is no shape.
    pub constraint: u32,
    /// The same number that the function returned.
    pub status: i32,
    /// The value that was refused; for `GAIN_STEP` and `FILTER_STEP` the product.
    pub value: f64,
}

sized!(Refusal);

/// The index where there is none.
pub const NO_INDEX: u32 = u32::MAX;

/// A refusal inside the library.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Refused {
    pub(crate) status: Status,
    pub(crate) index: u32,
    pub(crate) constraint: u32,
    pub(crate) value: f64,
}

impl Refused {
    fn at(status: Status, index: usize, value: f64) -> Self {
        Self { index: u32::try_from(index).unwrap_or(NO_INDEX), ..Self::of(status, value) }
    }

    pub(crate) fn of(status: Status, value: f64) -> Self {
        Self { status, index: NO_INDEX, constraint: NO_INDEX, value }
    }
}

impl From<Status> for Refused {
    fn from(status: Status) -> Self {
        Self::of(status, f64::NAN)
    }
}

impl From<ParameterError> for Refused {
    fn from(error: ParameterError) -> Self {
        match error {
            ParameterError::UpperLimit { joint, value } => Self::at(Status::UpperSpeed, joint, value),
            ParameterError::LowerLimit { joint, value } => Self::at(Status::LowerSpeed, joint, value),
            ParameterError::UpperAcceleration { joint, value } => Self::at(Status::UpperAcceleration, joint, value),
            ParameterError::LowerAcceleration { joint, value } => Self::at(Status::LowerAcceleration, joint, value),
            ParameterError::Speed { joint, value } => Self::at(Status::Speed, joint, value),
            ParameterError::Gain(value) => Self::of(Status::Gain, value),
            ParameterError::GainStep { step } => Self::of(Status::GainStep, step),
            ParameterError::AccelerationMargin(value) => Self::of(Status::AccelerationMargin, value),
            ParameterError::SamplingPeriod(value) => Self::of(Status::SamplingPeriod, value),
            ParameterError::Bandwidth(value) => Self::of(Status::Bandwidth, value),
            ParameterError::TargetRate(value) => Self::of(Status::TargetRate, value),
            ParameterError::FilterStep { step } => Self::of(Status::FilterStep, step),
            ParameterError::Factor(value) => Self::of(Status::Factor, value),
            ParameterError::SafeWalkWithoutReserve => Self::of(Status::SafeWalk, f64::NAN),
            ParameterError::Path { quantity, value } => path(quantity, value),
            ParameterError::Shape { parameter, value } => shape(parameter, value),
            _ => Self::from(Status::Parameter),
        }
    }
}

fn path(quantity: PathQuantity, value: f64) -> Refused {
    let status = match quantity {
        PathQuantity::Approach(i) => return Refused::at(Status::Approach, i, value),
        PathQuantity::Margin(i) => return Refused::at(Status::Margin, i, value),
        PathQuantity::Start(i) => return Refused::at(Status::Start, i, value),
        PathQuantity::PushCutoff => Status::PushCutoff,
        PathQuantity::Push => Status::Push,
        PathQuantity::RecoveryRate => Status::RecoveryRate,
        PathQuantity::WalkCutoff => Status::WalkCutoff,
        PathQuantity::PaceCutoff => Status::PaceCutoff,
        PathQuantity::WalkSpeed => Status::WalkSpeed,
        PathQuantity::WalkGrowth => Status::WalkGrowth,
        PathQuantity::ReturnGain => Status::ReturnGain,
        PathQuantity::DirectionPeriod => Status::DirectionPeriod,
        PathQuantity::DistanceThreshold => Status::DistanceThreshold,
        PathQuantity::ClearanceThreshold => Status::ClearanceThreshold,
        PathQuantity::ActivityThreshold => Status::ActivityThreshold,
        PathQuantity::PushShare => Status::PushShare,
        _ => Status::Parameter,
    };
    Refused::of(status, value)
}

fn shape(parameter: ShapeParameter, value: f64) -> Refused {
    let status = match parameter {
        ShapeParameter::Coordinate(i) => return Refused::at(Status::ShapeCoordinate, i, value),
        ShapeParameter::Direction(i) => return Refused::at(Status::ShapeDirection, i, value),
        ShapeParameter::SemiAxis(i) => return Refused::at(Status::ShapeSemiAxis, i, value),
        ShapeParameter::Weight(i) => return Refused::at(Status::ShapeWeight, i, value),
        ShapeParameter::DirectionLength => Status::ShapeDirectionLength,
        ShapeParameter::Offset => Status::ShapeOffset,
        ShapeParameter::Radius => Status::ShapeRadius,
        ShapeParameter::Scale => Status::ShapeScale,
        ShapeParameter::Exponent => Status::ShapeExponent,
        ShapeParameter::Sharpness => Status::ShapeSharpness,
        ShapeParameter::FaceCount => Status::ShapeFaceCount,
        _ => Status::Parameter,
    };
    Refused::of(status, value)
}

/// The status of a result; a refusal is written where the caller wants it, which a null says is nowhere.
///
/// # Safety
///
/// `why` is null or points to a [`Refusal`] that may be written.
pub(crate) unsafe fn report(result: Result<(), Refused>, why: *mut Refusal) -> Status {
    let Err(refused) = result else { return Status::Ok };
    // SAFETY: the caller's promise is the same.
    if let Ok(size) = unsafe { check_out(why) } {
        let refusal = Refusal {
            size,
            index: refused.index,
            constraint: refused.constraint,
            status: refused.status as i32,
            value: refused.value,
        };
        // SAFETY: not null, aligned, and of the size that the caller says it has.
        unsafe { why.write(refusal) };
    }
    refused.status
}
