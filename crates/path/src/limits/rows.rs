use serde::{Deserialize, Serialize};
use std::fmt;

/// Quantity that a limit is on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LimitKind {
    /// Speed of a joint.
    JointSpeed,
    /// Acceleration of a joint.
    JointAcceleration,
    /// Torque or force of a joint's drive.
    JointTorque,
    /// Speed of the tool.
    ToolSpeed,
    /// Acceleration of the tool.
    ToolAcceleration,
}

impl LimitKind {
    /// Whether it is one of a joint, rather than of the tool.
    #[must_use]
    pub fn is_of_a_joint(self) -> bool {
        matches!(self, Self::JointSpeed | Self::JointAcceleration | Self::JointTorque)
    }
}

impl fmt::Display for LimitKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::JointSpeed => "joint speed",
            Self::JointAcceleration => "joint acceleration",
            Self::JointTorque => "joint torque",
            Self::ToolSpeed => "tool speed",
            Self::ToolAcceleration => "tool acceleration",
        })
    }
}

/// A limit that is linear in path acceleration and squared path rate, at one point of the path:
///
/// ```text
/// lower <= acceleration · s̈ + square · ṡ² + offset <= upper
/// ```
///
/// Joint acceleration, torque and tool acceleration are all of this form. The bounds may have any sign, differ in size, be
/// infinite, and vary along the path. Units are those of the limited quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearLimit {
    /// Quantity that is limited.
    pub kind: LimitKind,
    /// Joint, or side of a tool limit's polygon, counted from 0.
    pub index: usize,
    /// Coefficient of `s̈`.
    pub acceleration: f64,
    /// Coefficient of `ṡ²`.
    pub square: f64,
    /// Value at rest: gravity, Coulomb friction.
    pub offset: f64,
    /// Lower bound.
    pub lower: f64,
    /// Upper bound.
    pub upper: f64,
}

impl LinearLimit {
    /// Joint acceleration `q' s̈ + q'' ṡ²` between bounds, rad/s².
    #[must_use]
    pub fn joint_acceleration(joint: usize, first: f64, second: f64, lower: f64, upper: f64) -> Self {
        Self {
            kind: LimitKind::JointAcceleration,
            index: joint,
            acceleration: first,
            square: second,
            offset: 0.0,
            lower,
            upper,
        }
    }

    /// Joint torque `τ = m s̈ + c ṡ² + g` between bounds, Nm, with `m = (M q')_i`, `c = (M q'' + C(q, q') q')_i` and `g` the
    /// gravity torque plus Coulomb friction `f · sign(q'_i)`.
    ///
    /// Viscous friction is proportional to `ṡ` and not of this form; subtract its largest value from the bounds.
    #[must_use]
    pub fn joint_torque(joint: usize, [m, c, g]: [f64; 3], lower: f64, upper: f64) -> Self {
        Self { kind: LimitKind::JointTorque, index: joint, acceleration: m, square: c, offset: g, lower, upper }
    }

    /// Length of the tool acceleration `p' s̈ + p'' ṡ²` at most `limit`, m/s², as a regular polygon of `2 · pairs` sides
    /// inscribed in the circle of that radius.
    ///
    /// The acceleration lies in the plane of `p'` and `p''`, so the polygon is exact in that plane. It is inside the circle: the
    /// limit is never exceeded, and at most the share `1 - cos(π / (2 pairs))` of it is given away (0.5 % with 16 pairs).
    #[must_use]
    #[allow(clippy::cast_precision_loss)]
    pub fn tool_acceleration(first: [f64; 3], second: [f64; 3], limit: f64, pairs: usize) -> Vec<Self> {
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let forward = dot(first, first).sqrt();
        let along = if forward > 0.0 { dot(first, second) / forward } else { 0.0 };
        let across = (dot(second, second) - along * along).max(0.0).sqrt();
        let angle = std::f64::consts::PI / pairs as f64;
        let bound = limit * (0.5 * angle).cos();
        (0..pairs)
            .map(|side| {
                let (sin, cos) = side_direction(side, pairs);
                Self {
                    kind: LimitKind::ToolAcceleration,
                    index: side,
                    acceleration: cos * forward,
                    square: cos * along + sin * across,
                    offset: 0.0,
                    lower: -bound,
                    upper: bound,
                }
            })
            .collect()
    }

    /// The limited quantity at a path acceleration and a squared path rate.
    #[must_use]
    pub fn value(&self, s_acceleration: f64, b: f64) -> f64 {
        self.acceleration * s_acceleration + self.square * b + self.offset
    }

    /// Half of the distance between the bounds; with one bound alone its magnitude, and 1 where that is zero too.
    #[must_use]
    pub fn half_range(&self) -> f64 {
        let half = 0.5 * (self.upper - self.lower);
        if half.is_finite() && half > 0.0 {
            return half;
        }
        let one = [self.upper, self.lower].into_iter().filter(|b| b.is_finite()).map(f64::abs).fold(0.0, f64::max);
        if one > 0.0 { one } else { 1.0 }
    }

    /// By how much a value is outside the bounds, as a share of [`LinearLimit::half_range`]; negative inside. NaN stays NaN.
    #[must_use]
    pub fn excess(&self, s_acceleration: f64, b: f64) -> f64 {
        let value = self.value(s_acceleration, b);
        let (over, under) = (value - self.upper, self.lower - value);
        (if over >= under { over } else { under }) / self.half_range()
    }
}

/// Sine and cosine of `π side / pairs`, a side across having cosine 0 and mirrored sides the same numbers but for the sign.
///
/// `π / 2` is no floating-point number, and its cosine as computed is some 6e-17. A side across would then weigh the path
/// acceleration by that much rounding, which a solver takes for a limit on it.
#[allow(clippy::cast_precision_loss)]
fn side_direction(side: usize, pairs: usize) -> (f64, f64) {
    let mirrored = pairs - side;
    if side == mirrored {
        return (1.0, 0.0);
    }
    let (sin, cos) = (std::f64::consts::PI / pairs as f64 * side.min(mirrored) as f64).sin_cos();
    (sin, if side < mirrored { cos } else { -cos })
}

/// A bound on the path rate at one point of the path: `ṡ <= rate`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpeedLimit {
    /// Quantity that is limited.
    pub kind: LimitKind,
    /// Joint, counted from 0; 0 for the tool.
    pub index: usize,
    /// The path rate at which the limit is reached, 1/s; infinite where nothing moves.
    pub rate: f64,
}

impl SpeedLimit {
    /// Joint speed `q' ṡ` between a negative and a positive bound, rad/s. Bounds of another sign give NaN, which every
    /// solver refuses.
    #[must_use]
    pub fn joint(joint: usize, first: f64, lower: f64, upper: f64) -> Self {
        let valid = lower < 0.0 && upper > 0.0;
        let rate = if !valid {
            f64::NAN
        } else if first == 0.0 {
            f64::INFINITY
        } else {
            (upper / first).max(lower / first)
        };
        Self { kind: LimitKind::JointSpeed, index: joint, rate }
    }

    /// Tool speed `|p'| ṡ` at most `limit`, m/s.
    #[must_use]
    pub fn tool(first: [f64; 3], limit: f64) -> Self {
        let length = first.iter().map(|x| x * x).sum::<f64>().sqrt();
        let rate = if limit > 0.0 { limit / length } else { f64::NAN };
        Self { kind: LimitKind::ToolSpeed, index: 0, rate }
    }
}

/// The path rate at an end of a piece.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum EndRate {
    /// At rest if any limit depends on the acceleration, free otherwise.
    #[default]
    ByLimits,
    /// Any rate within the limits.
    Free,
    /// Exactly this rate, 1/s, not negative; 0 is rest.
    Given(f64),
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_polygon_stays_inside_the_circle_and_gives_away_little() {
        let (first, second) = ([0.3, -0.2, 0.9], [1.0, 0.5, -0.1]);
        let sides = LinearLimit::tool_acceleration(first, second, 2.0, 16);
        for step in 0..200 {
            let (sin, cos) = (f64::from(step) * 0.0314).sin_cos();
            let length = |r: f64| (0..3).map(|i| (r * (first[i] * cos + second[i] * sin)).powi(2)).sum::<f64>().sqrt();
            let r = 2.0 / length(1.0);
            let worst = |r: f64| sides.iter().map(|l| l.excess(r * cos, r * sin)).fold(f64::NEG_INFINITY, f64::max);
            // At the circle no row has room left (but for rounding); at the inscribed radius none is exceeded.
            assert!(worst(r) >= -1e-12);
            assert!(worst(r * (std::f64::consts::PI / 32.0).cos()) <= 1e-12);
        }
    }

    #[test]
    fn a_side_across_does_not_depend_on_the_path_acceleration_and_mirrored_sides_are_equal() {
        for pairs in [2, 6, 16, 33] {
            let sides = LinearLimit::tool_acceleration([0.3, 0.0, 0.4], [0.0, 2.0, 0.0], 1.0, pairs);
            assert_eq!((sides[0].acceleration, sides[0].square), (0.5, 0.0));
            for side in 1..pairs {
                let mirrored = &sides[pairs - side];
                assert_eq!(sides[side].acceleration, -mirrored.acceleration);
                assert_eq!(sides[side].square, mirrored.square);
                assert_eq!(sides[side].acceleration == 0.0, 2 * side == pairs, "side {side} of {pairs}");
            }
        }
    }

    #[test]
    fn a_joint_speed_limit_uses_the_bound_of_the_direction_of_motion() {
        assert_eq!(SpeedLimit::joint(0, 2.0, -1.0, 3.0).rate, 1.5);
        assert_eq!(SpeedLimit::joint(0, -2.0, -1.0, 3.0).rate, 0.5);
        assert_eq!(SpeedLimit::joint(0, 0.0, -1.0, 3.0).rate, f64::INFINITY);
        assert!(SpeedLimit::joint(0, 1.0, 1.0, 3.0).rate.is_nan());
    }
}
