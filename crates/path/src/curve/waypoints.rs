use super::error::CurveError;
use nalgebra::SVector;
use std::ops::Range;

/// Rule by which way-points are given path parameters.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Spacing {
    /// Equal steps.
    Uniform,
    /// Steps in proportion to the straight distance between neighbours: even speed along the polygon.
    #[default]
    Chord,
    /// As listed, one per way-point.
    At(Vec<f64>),
}

/// Way-points with increasing path parameters: `points[i]` at `at[i]`, at least two.
#[derive(Clone, Debug, PartialEq)]
pub struct Waypoints<const D: usize> {
    at: Vec<f64>,
    points: Vec<SVector<f64, D>>,
}

/// A segment shorter than this share of the whole polygon counts as a repeated way-point: coordinates are rounded to
/// 1e-16 of their size, so that a direction along a segment of 1e-9 is known to 1e-7 only, and a curvature to nothing.
const SHORTEST: f64 = 1e-9;

impl<const D: usize> Waypoints<D> {
    /// Way-points spaced over a range of the path parameter; a listed spacing is taken as it is and ignores the range.
    ///
    /// # Errors
    ///
    /// Fewer than two points, a number that is not finite, a neighbour repeated (closer than 1e-9 of the whole polygon),
    /// path parameters too few, too many or not increasing, an empty range.
    pub fn new(points: Vec<SVector<f64, D>>, spacing: &Spacing, range: Range<f64>) -> Result<Self, CurveError> {
        check_points(&points)?;
        let steps = distances(&points);
        let total: f64 = steps.iter().sum();
        if let Some(i) = steps.iter().position(|&d| !(d > SHORTEST * total)) {
            return Err(CurveError::Repeated { before: i, index: i + 1 });
        }
        Self::with_dwells(points, spacing, range)
    }

    /// As [`Waypoints::new`], but neighbours may coincide unless the spacing needs their distance: a tool may stand while
    /// it turns.
    ///
    /// # Errors
    ///
    /// As [`Waypoints::new`].
    pub fn with_dwells(points: Vec<SVector<f64, D>>, spacing: &Spacing, range: Range<f64>) -> Result<Self, CurveError> {
        check_points(&points)?;
        let at = parameters(spacing, &distances(&points), range).map_err(|error| match error {
            CurveError::Repeated { before, index } => CurveError::NoDistance { before, index },
            error => error,
        })?;
        Ok(Self { at, points })
    }

    /// Path parameters, increasing.
    #[must_use]
    pub fn at(&self) -> &[f64] {
        &self.at
    }

    /// The points.
    #[must_use]
    pub fn points(&self) -> &[SVector<f64, D>] {
        &self.points
    }
}

/// At least two points, all finite, and so are the distances between neighbours.
fn check_points<const D: usize>(points: &[SVector<f64, D>]) -> Result<(), CurveError> {
    if points.len() < 2 {
        return Err(CurveError::TooFew { found: points.len() });
    }
    if let Some(index) = points.iter().position(|p| !p.iter().all(|x| x.is_finite())) {
        return Err(CurveError::NotFinite { index });
    }
    match distances(points).iter().position(|d| !d.is_finite()) {
        Some(i) => Err(CurveError::TooSteep { index: i + 1 }),
        None => Ok(()),
    }
}

/// Path parameters of way-points a given distance apart.
pub(super) fn parameters(spacing: &Spacing, distances: &[f64], range: Range<f64>) -> Result<Vec<f64>, CurveError> {
    let at = match spacing {
        Spacing::Uniform => spread(&vec![1.0; distances.len()], range)?,
        Spacing::Chord => spread(distances, range)?,
        Spacing::At(at) => at.clone(),
    };
    check_parameters(&at, distances.len() + 1)?;
    Ok(at)
}

/// One finite path parameter per way-point, increasing.
fn check_parameters(at: &[f64], waypoints: usize) -> Result<(), CurveError> {
    if at.len() != waypoints {
        return Err(CurveError::ParameterCount { found: at.len(), expected: waypoints });
    }
    if let Some(index) = at.iter().position(|x| !x.is_finite()) {
        return Err(CurveError::NotFinite { index });
    }
    match at.windows(2).position(|w| !(w[0] < w[1])) {
        Some(i) => Err(CurveError::NotIncreasing { index: i + 1, before: at[i], value: at[i + 1] }),
        None => Ok(()),
    }
}

fn distances<const D: usize>(points: &[SVector<f64, D>]) -> Vec<f64> {
    points.windows(2).map(|w| (w[1] - w[0]).norm()).collect()
}

/// Path parameters over a range, their steps in proportion to weights.
fn spread(steps: &[f64], range: Range<f64>) -> Result<Vec<f64>, CurveError> {
    let length = range.end - range.start;
    if !(length > 0.0 && length.is_finite()) {
        return Err(CurveError::Range { start: range.start, end: range.end });
    }
    let total: f64 = steps.iter().sum();
    if let Some(i) = steps.iter().position(|&d| !(d > SHORTEST * total)) {
        return Err(CurveError::Repeated { before: i, index: i + 1 });
    }
    let mut at: Vec<f64> = std::iter::once(0.0)
        .chain(steps.iter().scan(0.0, |sum, step| {
            *sum += step;
            Some(*sum)
        }))
        .map(|sum| range.start + length * (sum / total))
        .collect();
    // The last one exactly, whatever the rounding of the sum.
    if let Some(last) = at.last_mut() {
        *last = range.end;
    }
    Ok(at)
}

/// The segment that holds a path parameter: the first one before the path, the last one after it, at a way-point the one
/// that begins there.
pub(super) fn segment(at: &[f64], lambda: f64) -> usize {
    at.partition_point(|&x| x <= lambda).clamp(1, at.len() - 1) - 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector2;

    fn corner() -> Vec<Vector2<f64>> {
        vec![Vector2::new(0.0, 0.0), Vector2::new(3.0, 0.0), Vector2::new(3.0, 1.0)]
    }

    #[test]
    fn chord_spacing_is_in_proportion_to_the_distances() {
        let waypoints = Waypoints::new(corner(), &Spacing::Chord, 2.0..4.0).expect("valid");
        assert_eq!(waypoints.at(), [2.0, 3.5, 4.0]);
        let waypoints = Waypoints::new(corner(), &Spacing::Uniform, 2.0..4.0).expect("valid");
        assert_eq!(waypoints.at(), [2.0, 3.0, 4.0]);
    }

    #[test]
    fn what_is_wrong_is_pointed_at() {
        let error = |points: Vec<Vector2<f64>>, spacing: Spacing| Waypoints::new(points, &spacing, 0.0..1.0).err();
        let mut repeated = corner();
        repeated.insert(2, repeated[1]);
        assert_eq!(error(repeated, Spacing::Uniform), Some(CurveError::Repeated { before: 1, index: 2 }));
        assert_eq!(error(corner()[..1].to_vec(), Spacing::Chord), Some(CurveError::TooFew { found: 1 }));
        let mut infinite = corner();
        infinite[1].y = f64::INFINITY;
        assert_eq!(error(infinite, Spacing::Chord), Some(CurveError::NotFinite { index: 1 }));
        assert_eq!(
            error(corner(), Spacing::At(vec![0.0, 1.0])),
            Some(CurveError::ParameterCount { found: 2, expected: 3 })
        );
        assert_eq!(
            error(corner(), Spacing::At(vec![0.0, 1.0, 1.0])),
            Some(CurveError::NotIncreasing { index: 2, before: 1.0, value: 1.0 })
        );
        let empty = Waypoints::new(corner(), &Spacing::Chord, 1.0..f64::NAN).err();
        assert!(matches!(empty, Some(CurveError::Range { .. })), "{empty:?}");
    }

    #[test]
    fn a_tool_may_stand_while_it_turns_unless_the_spacing_needs_the_distance() {
        let mut standing = corner();
        standing.insert(2, standing[1]);
        assert!(Waypoints::with_dwells(standing.clone(), &Spacing::Uniform, 0.0..1.0).is_ok());
        let refused = Waypoints::with_dwells(standing, &Spacing::Chord, 0.0..1.0).err();
        assert_eq!(refused, Some(CurveError::NoDistance { before: 1, index: 2 }));
    }

    #[test]
    fn a_way_point_belongs_to_the_segment_that_begins_there() {
        let at = [0.0, 1.0, 2.0];
        assert_eq!([-1.0, 0.0, 0.5, 1.0, 2.0, 3.0].map(|x| segment(&at, x)), [0, 0, 0, 1, 1, 1]);
    }
}
