use thiserror::Error;

/// Reason why there is no curve through given way-points. Way-points are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum CurveError {
    /// No segment at all.
    #[error("{found} given, at least two way-points are needed")]
    TooFew {
        /// Way-points given.
        found: usize,
    },
    /// A number that is NaN or infinite.
    #[error("way-point {index} (counted from 0) has a number that is not finite")]
    NotFinite {
        /// The way-point.
        index: usize,
    },
    /// A segment without length.
    #[error("way-points {before} and {index} (counted from 0) are the same: the segment between them has no length")]
    Repeated {
        /// The way-point before.
        before: usize,
        /// The one that repeats it.
        index: usize,
    },
    /// A dwell, where the spacing goes by the distance that it does not have.
    #[error(
        "way-points {before} and {index} (counted from 0) are in the same place, and the spacing goes by their distance"
    )]
    NoDistance {
        /// The way-point before.
        before: usize,
        /// The one that repeats it.
        index: usize,
    },
    /// As many path parameters as way-points are needed.
    #[error("{found} path parameters given for {expected} way-points")]
    ParameterCount {
        /// Path parameters given.
        found: usize,
        /// Way-points.
        expected: usize,
    },
    /// A path parameter that is not finite or does not lie after the one before.
    #[error("path parameter {value} of way-point {index} (counted from 0) does not lie after {before}")]
    NotIncreasing {
        /// The way-point.
        index: usize,
        /// Path parameter of the one before.
        before: f64,
        /// Its own.
        value: f64,
    },
    /// A range of path parameters that is empty or not finite.
    #[error("the path parameter cannot run from {start} to {end}")]
    Range {
        /// Path parameter at the first way-point.
        start: f64,
        /// Path parameter at the last one.
        end: f64,
    },
    /// Blends that would overlap, or have a negative width.
    #[error("a blend of {share} is outside [0, 0.5]")]
    Blend {
        /// Half-width as a share of the shorter neighbouring interval.
        share: f64,
    },
    /// A derivative at an end that is NaN or infinite.
    #[error("the derivative at an end is not finite")]
    EndDerivative,
    /// Two neighbouring rotations half a turn apart: there are two shortest ways.
    #[error(
        "rotations {before} and {index} (counted from 0) are {degrees:.3} degrees apart: there is no single shortest way between them"
    )]
    HalfTurn {
        /// The rotation before.
        before: usize,
        /// The one after it.
        index: usize,
        /// The angle between them.
        degrees: f64,
    },
    /// A slope beyond the range of numbers.
    #[error("the curve near way-point {index} (counted from 0) is too steep for its path parameters")]
    TooSteep {
        /// The way-point.
        index: usize,
    },
    /// Three points on a line, or two of them in one place: no circle.
    #[error("the three points lie on one line: no circle passes through them")]
    Collinear,
    /// Four numbers that are not a rotation.
    #[error("the quaternion has length {norm}, not 1")]
    NotUnit {
        /// Its length.
        norm: f64,
    },
}

impl CurveError {
    /// The way-point that the error is about, counted from 0; `None` if it is about all of them.
    #[must_use]
    pub fn index(&self) -> Option<usize> {
        match self {
            Self::NotFinite { index }
            | Self::TooSteep { index }
            | Self::Repeated { index, .. }
            | Self::NoDistance { index, .. }
            | Self::NotIncreasing { index, .. }
            | Self::HalfTurn { index, .. } => Some(*index),
            _ => None,
        }
    }

    /// Remedy, in one sentence.
    #[must_use]
    pub fn remedy(&self) -> &'static str {
        match self {
            Self::TooFew { .. } => "give at least two way-points",
            Self::NotFinite { .. } | Self::EndDerivative => "give finite numbers",
            Self::TooSteep { .. } => "move the way-points closer together, or their path parameters apart",
            Self::Repeated { .. } => "remove one of the two",
            Self::NoDistance { .. } => {
                "remove one of the two; or give `spacing = \"uniform\"` or `at`, and the position stays while the orientation turns"
            }
            Self::ParameterCount { .. } => "give one path parameter per way-point, or leave `at` out",
            Self::NotIncreasing { .. } | Self::Range { .. } => "order the path parameters from small to large",
            Self::Blend { .. } => "give a share of the shorter neighbouring interval from 0 (corners) to 0.5",
            Self::HalfTurn { .. } => "put a rotation in between that says which way to turn",
            Self::Collinear => "move the point in the middle off the line, or use a line",
            Self::NotUnit { .. } => "give w, x, y, z of a unit quaternion to six decimals or more",
        }
    }
}
