use core::fmt;

use crate::error::ParameterError;

/// A parameter of a shape, named in [`ParameterError::Shape`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ShapeParameter {
    /// A coordinate of the centre or of a point on the shape.
    Coordinate(usize),
    /// A component of a normal or an axis.
    Direction(usize),
    /// The length of a normal or an axis.
    DirectionLength,
    /// The offset `d` of a plane `nᵀ p = d`, or its distance from the origin `d / ‖n‖`.
    Offset,
    /// A radius.
    Radius,
    /// A semi-axis or half edge.
    SemiAxis(usize),
    /// The factor that turns a dimensionless distance into one comparable with lengths.
    Scale,
    /// The exponent of a box with smoothed edges.
    Exponent,
    /// The sharpness of a smoothed maximum.
    Sharpness,
    /// The number of faces of a polytope, of their normals or of their offsets.
    FaceCount,
    /// A weight of the oval.
    Weight(usize),
}

impl fmt::Display for ShapeParameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Coordinate(i) => write!(f, "coordinate {}", i + 1),
            Self::Direction(i) => write!(f, "direction component {}", i + 1),
            Self::DirectionLength => write!(f, "length of the direction"),
            Self::Offset => write!(f, "offset"),
            Self::Radius => write!(f, "radius"),
            Self::SemiAxis(i) => write!(f, "semi-axis {}", i + 1),
            Self::Scale => write!(f, "scale"),
            Self::Exponent => write!(f, "exponent"),
            Self::Sharpness => write!(f, "sharpness"),
            Self::FaceCount => write!(f, "number of faces"),
            Self::Weight(i) => write!(f, "weight {}", i + 1),
        }
    }
}

pub(crate) fn accept(parameter: ShapeParameter, value: f64, inside: bool) -> Result<f64, ParameterError> {
    if inside && value.is_finite() { Ok(value) } else { Err(ParameterError::Shape { parameter, value }) }
}

pub(crate) fn above_zero(parameter: ShapeParameter, value: f64) -> Result<f64, ParameterError> {
    accept(parameter, value, value > 0.0)
}

pub(crate) fn each<const N: usize>(
    values: &[f64; N],
    parameter: fn(usize) -> ShapeParameter,
    inside: fn(f64) -> bool,
) -> Result<(), ParameterError> {
    for (i, &value) in values.iter().enumerate() {
        accept(parameter(i), value, inside(value))?;
    }
    Ok(())
}

/// Unit normal and distance from the origin of the plane `nᵀ p = d`: both divided by `‖n‖`.
pub(crate) fn plane<const N: usize>(normal: &[f64; N], offset: f64) -> Result<([f64; N], f64), ParameterError> {
    accept(ShapeParameter::Offset, offset, true)?;
    let unit = unit(normal)?;
    let distance = accept(ShapeParameter::Offset, offset / crate::path::vector::norm(normal), true)?;
    Ok((unit, distance))
}

/// The unit vector along a direction that is finite and not zero.
pub(crate) fn unit<const N: usize>(direction: &[f64; N]) -> Result<[f64; N], ParameterError> {
    each(direction, ShapeParameter::Direction, f64::is_finite)?;
    let length = crate::path::vector::norm(direction);
    above_zero(ShapeParameter::DirectionLength, length)?;
    Ok(direction.map(|x| x / length))
}
