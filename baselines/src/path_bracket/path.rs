//! What is to be bracketed: a joint path in polynomial segments, its limits and its ends.

use super::error::BracketError;
use slideway_path::WholePath;

/// A continuous joint path `q(s)`: one polynomial of degree at most 5 for each joint between neighbouring knots.
///
/// `q'` may jump at knots (corners of lines); `q''` may jump there too (blends, splines).
#[derive(Clone, Debug, PartialEq)]
pub struct JointPath {
    joints: usize,
    knots: Vec<f64>,
    /// `segments[i][j][m]`: coefficient of `(s - knots[i])^m` of joint `j`.
    segments: Vec<Vec<Vec<f64>>>,
}

/// Jump of `q` or `q'` at a knot that counts as rounding, as a share of the largest value beside it.
const ROUNDING: f64 = 1e-9;
/// Numbers stay below this, and positive ones above its inverse: products of a few of them neither overflow nor vanish.
const LARGEST: f64 = 1e30;

impl JointPath {
    /// A path from its knots (path parameter, strictly rising) and, for each interval between them and each joint, its coefficients by
    /// rising powers of the distance from the interval's first knot (rad or m per power of the parameter).
    ///
    /// # Errors
    ///
    /// Lists that do not fit together, knots that do not rise, more than six coefficients, numbers that are not finite, and jumps of a
    /// joint at a knot.
    pub fn new(knots: Vec<f64>, segments: Vec<Vec<Vec<f64>>>) -> Result<Self, BracketError> {
        let joints = segments.first().map_or(0, Vec::len);
        count("knots", knots.len(), segments.len() + 1)?;
        if joints == 0 {
            return Err(BracketError::Count { what: "joints of the first segment", given: 0, needed: 1 });
        }
        for (knot, pair) in knots.windows(2).enumerate() {
            if !(pair[0].is_finite() && pair[1].is_finite() && pair[1] > pair[0]) {
                return Err(BracketError::Knot { knot: knot + 1 });
            }
        }
        for (segment, polynomials) in segments.iter().enumerate() {
            count("joints of a segment", polynomials.len(), joints)?;
            for (joint, c) in polynomials.iter().enumerate() {
                if c.is_empty() || c.len() > 6 {
                    return Err(BracketError::Degree { segment, joint, given: c.len() });
                }
                if c.iter().any(|c| !c.is_finite()) {
                    return Err(BracketError::NotFinite { segment, joint });
                }
                if c.iter().any(|c| !(c.abs() < LARGEST)) {
                    return Err(BracketError::Size { segment });
                }
            }
        }
        let path = Self { joints, knots, segments };
        let is_usable = |i: &usize| path.length(*i) > 1.0 / LARGEST && path.knots[*i].abs() < LARGEST;
        if let Some(segment) = (0..path.segments.len()).find(|i| !is_usable(i)) {
            return Err(BracketError::Size { segment });
        }
        path.check_jumps()?;
        Ok(path)
    }

    /// Straight lines between points, with the given parameter at each of them.
    ///
    /// # Errors
    ///
    /// As [`JointPath::new`].
    pub fn lines(knots: Vec<f64>, points: &[Vec<f64>]) -> Result<Self, BracketError> {
        count("knots", knots.len(), points.len())?;
        let line = |(k, p): (&[f64], &[Vec<f64>])| {
            p[0].iter().zip(&p[1]).map(|(from, to)| vec![*from, (to - from) / (k[1] - k[0])]).collect()
        };
        let segments = knots.windows(2).zip(points.windows(2)).map(line).collect();
        Self::new(knots, segments)
    }

    fn check_jumps(&self) -> Result<(), BracketError> {
        for i in 1..self.segments.len() {
            for joint in 0..self.joints {
                let (before, after) = (self.at_end(i - 1, joint), self.segments[i][joint][0]);
                let size = self.size(i - 1, joint).max(self.size(i, joint));
                let jump = after - before;
                if !(jump.abs() <= ROUNDING * size) {
                    return Err(BracketError::Jump { joint, s: self.knots[i], jump });
                }
            }
        }
        Ok(())
    }

    /// Sum of the absolute terms of a joint's polynomial over a segment: no value is larger.
    fn size(&self, segment: usize, joint: usize) -> f64 {
        let length = self.length(segment);
        self.segments[segment][joint].iter().rev().fold(0.0, |sum, c| sum * length + c.abs())
    }

    fn at_end(&self, segment: usize, joint: usize) -> f64 {
        let length = self.length(segment);
        self.segments[segment][joint].iter().rev().fold(0.0, |sum, c| sum * length + c)
    }

    /// Number of joints.
    #[must_use]
    pub fn joints(&self) -> usize {
        self.joints
    }

    /// Path parameter at the knots.
    #[must_use]
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// Number of segments.
    pub(crate) fn segment_count(&self) -> usize {
        self.segments.len()
    }

    /// Length of a segment in the path parameter.
    pub(crate) fn length(&self, segment: usize) -> f64 {
        self.knots[segment + 1] - self.knots[segment]
    }

    /// Powers of the derivative `q'` of all joints in a segment by the distance from its first knot, all of the same count, at least 1.
    pub(crate) fn derivative(&self, segment: usize) -> Vec<Vec<f64>> {
        let polynomials = &self.segments[segment];
        let used = |c: &Vec<f64>| c.iter().rposition(|c| *c != 0.0).unwrap_or(0);
        let count = polynomials.iter().map(used).max().unwrap_or(0).max(1);
        let term = |c: &Vec<f64>, m: usize| c.get(m + 1).map_or(0.0, |c| c * (m + 1) as f64);
        polynomials.iter().map(|c| (0..count).map(|m| term(c, m)).collect()).collect()
    }

    /// Whether `q'` of some of the joints asked for jumps at the knot that ends a segment.
    pub(crate) fn is_corner(&self, segment: usize, asked: impl Fn(usize) -> bool) -> bool {
        let length = self.length(segment);
        let (before, after) = (self.derivative(segment), self.derivative(segment + 1));
        let next = self.length(segment + 1);
        (0..self.joints).filter(|joint| asked(*joint)).any(|joint| {
            let (b, a) = (&before[joint], &after[joint]);
            let end = b.iter().rev().fold(0.0, |sum, c| sum * length + c);
            let size = |c: &[f64], l: f64| c.iter().rev().fold(0.0, |sum, c| sum * l + c.abs());
            !((a[0] - end).abs() <= ROUNDING * size(b, length).max(size(a, next)))
        })
    }
}

fn count(what: &'static str, given: usize, needed: usize) -> Result<(), BracketError> {
    if given == needed { Ok(()) } else { Err(BracketError::Count { what, given, needed }) }
}

/// Joint limits that hold along the whole path; infinity for none.
#[derive(Clone, Debug, PartialEq)]
pub struct JointLimits {
    /// Joint-speed limits of both senses, rad/s or m/s.
    speed: Vec<f64>,
    /// Lower joint-acceleration limits, below 0, rad/s² or m/s².
    lower: Vec<f64>,
    /// Upper joint-acceleration limits, above 0.
    upper: Vec<f64>,
}

impl JointLimits {
    /// Limits of speed (both senses) and of acceleration (each sense), one entry a joint, `f64::INFINITY` or its negative for none.
    /// A joint has both acceleration limits or neither: with one sense free, `q'` could jump in that sense without rest.
    ///
    /// # Errors
    ///
    /// Lists of different length, and limits that are NaN or of the wrong sign.
    pub fn new(speed: Vec<f64>, lower: Vec<f64>, upper: Vec<f64>) -> Result<Self, BracketError> {
        count("lower acceleration limits", lower.len(), speed.len())?;
        count("upper acceleration limits", upper.len(), speed.len())?;
        for joint in 0..speed.len() {
            let is_usable = |limit: f64| limit == f64::INFINITY || limit > 1.0 / LARGEST && limit < LARGEST;
            let both = lower[joint].is_finite() == upper[joint].is_finite();
            if !(is_usable(speed[joint]) && is_usable(-lower[joint]) && is_usable(upper[joint]) && both) {
                return Err(BracketError::Limit { joint });
            }
        }
        Ok(Self { speed, lower, upper })
    }

    /// Speed limits and the same acceleration limits in both senses.
    ///
    /// # Errors
    ///
    /// As [`JointLimits::new`].
    pub fn symmetric(speed: Vec<f64>, acceleration: Vec<f64>) -> Result<Self, BracketError> {
        let lower = acceleration.iter().map(|a| -a).collect();
        Self::new(speed, lower, acceleration)
    }

    pub(crate) fn joints(&self) -> usize {
        self.speed.len()
    }

    /// Speed limit of a joint.
    pub(crate) fn speed(&self, joint: usize) -> f64 {
        self.speed[joint]
    }

    /// Acceleration limit of a joint in one sense, above 0.
    pub(crate) fn acceleration(&self, joint: usize, sense: Sense) -> f64 {
        match sense {
            Sense::Upper => self.upper[joint],
            Sense::Lower => -self.lower[joint],
        }
    }

    pub(crate) fn has_speed(&self) -> bool {
        self.speed.iter().any(|v| v.is_finite())
    }

    pub(crate) fn has_acceleration(&self) -> bool {
        (0..self.joints()).any(|j| self.is_accelerated(j))
    }

    /// Whether a joint has acceleration limits.
    pub(crate) fn is_accelerated(&self, joint: usize) -> bool {
        self.upper[joint].is_finite()
    }

    /// Whether a joint has any limit.
    pub(crate) fn is_limited(&self, joint: usize) -> bool {
        self.speed[joint].is_finite() || self.is_accelerated(joint)
    }
}

/// Sense of an acceleration limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sense {
    /// The acceleration is at most the upper limit.
    Upper,
    /// The acceleration is at least the lower limit.
    Lower,
}

impl Sense {
    /// Both senses.
    pub(crate) const BOTH: [Self; 2] = [Self::Upper, Self::Lower];

    /// 1 for upper, -1 for lower.
    pub(crate) fn sign(self) -> f64 {
        if self == Self::Upper { 1.0 } else { -1.0 }
    }
}

/// State of an end of the path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// The path rate is 0.
    Rest,
    /// The path rate is free.
    Free,
}

/// A path with limits and ends.
#[derive(Clone, Debug, PartialEq)]
pub struct JointPathProblem {
    path: JointPath,
    limits: JointLimits,
    ends: [End; 2],
}

impl TryFrom<&WholePath> for JointPathProblem {
    type Error = BracketError;

    /// The problem of a scenario's joint path.
    ///
    /// # Errors
    ///
    /// As [`JointPath::new`], [`JointLimits::new`] and [`JointPathProblem::new`].
    fn try_from(whole: &WholePath) -> Result<Self, BracketError> {
        let path = JointPath::new(whole.polynomials.knots().to_vec(), whole.polynomials.coefficients())?;
        let joints = whole.speed.len();
        let none = || [vec![f64::NEG_INFINITY; joints], vec![f64::INFINITY; joints]];
        let [lower, upper] = whole.acceleration.clone().unwrap_or_else(none);
        let limits = JointLimits::new(whole.speed.clone(), lower, upper)?;
        Self::new(path, limits, whole.is_free.map(|free| if free { End::Free } else { End::Rest }))
    }
}

impl JointPathProblem {
    /// A problem: first and last end as given. Under speed limits alone a rest end costs no time and counts as free.
    ///
    /// # Errors
    ///
    /// Limits for another number of joints, a stretch on which no limited joint moves, or a free end without speed limits.
    pub fn new(path: JointPath, limits: JointLimits, ends: [End; 2]) -> Result<Self, BracketError> {
        count("joints with limits", limits.joints(), path.joints())?;
        for i in 0..path.segment_count() {
            let moves = |(joint, c): (usize, &Vec<f64>)| limits.is_limited(joint) && c.iter().any(|c| *c != 0.0);
            if !path.derivative(i).iter().enumerate().any(moves) {
                return Err(BracketError::Still { from: path.knots[i], to: path.knots[i + 1] });
            }
        }
        if ends.contains(&End::Free) && !limits.has_speed() {
            return Err(BracketError::FreeEnd);
        }
        Ok(Self { path, limits, ends })
    }

    /// The path.
    #[must_use]
    pub fn path(&self) -> &JointPath {
        &self.path
    }

    /// The limits.
    #[must_use]
    pub fn limits(&self) -> &JointLimits {
        &self.limits
    }

    /// Both ends.
    #[must_use]
    pub fn ends(&self) -> [End; 2] {
        self.ends
    }
}
