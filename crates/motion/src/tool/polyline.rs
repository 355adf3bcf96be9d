use super::curve::CurvePoint;
use super::turn::ToolTurn;
use crate::MotionError;
use crate::error::CurveFault;
use arrayvec::ArrayVec;
use nalgebra::{Translation3, Vector3};
use slideway_robot::{Pose, Twist};

/// Points that a polyline can have, its start included.
pub const MAX_POINTS: usize = 16;

/// Straight lines of the tool's origin between points, with corners rounded twice differentiably.
///
/// `u` is the share of the length of the lines, `v_i` the derivative of `p` by `u` on line `i`, of length `L` on each. About a corner
/// at `u_i`, within a half-width `w`,
///
/// ```text
/// p'(u) = v_{i-1} + (v_i - v_{i-1}) (3 τ² - 2 τ³),   τ = (u - u_i + w) / (2 w)
/// ```
///
/// so that the curvature rises and falls again continuously. The corner is missed by `‖v_i - v_{i-1}‖ 3 w / 16`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolPolyline {
    // Arrays with a count: nothing to drop, so that a whole queue is cleared at once.
    points: [Vector3<f64>; MAX_POINTS],
    /// `u` at the points.
    at: [f64; MAX_POINTS],
    count: usize,
    length: f64,
    /// Half-width of the rounding in `u`.
    width: f64,
    turn: ToolTurn,
}

impl ToolPolyline {
    /// From a pose through points to the last of them. Each corner is rounded from the distance `blend` (m) before it to the same
    /// distance behind it; the tool turns by the rotation vector `turn`, rad, on the way.
    ///
    /// # Errors
    ///
    /// [`MotionError::Curve`]: a number that is not finite, no point or too many, a line without length, a blend that is not positive
    /// or reaches the middle of a line between two corners or the end of one that has one corner.
    pub fn new(start: &Pose, points: &[Vector3<f64>], blend: f64, turn: Vector3<f64>) -> Result<Self, MotionError> {
        let refuse = |fault| Err(MotionError::Curve(fault));
        let all: Option<ArrayVec<Vector3<f64>, MAX_POINTS>> = (points.len() < MAX_POINTS)
            .then(|| std::iter::once(start.translation.vector).chain(points.iter().copied()).collect());
        let Some(all) = all.filter(|all| all.len() >= 2) else {
            return refuse(CurveFault::Points { given: points.len() });
        };
        if !all.iter().flat_map(|p| p.iter()).chain(turn.iter()).chain([&blend]).all(|x| x.is_finite()) {
            return refuse(CurveFault::NotFinite);
        }
        let lines = || all.windows(2).map(|p| (p[1] - p[0]).norm());
        let last = all.len() - 2;
        for (line, length) in lines().enumerate() {
            if !(length > 0.0) {
                return refuse(CurveFault::NoLength { line });
            }
            let corners = f64::from(u8::from(line > 0)) + f64::from(u8::from(line < last));
            if last > 0 && !(blend > 0.0 && corners * blend <= length) {
                return refuse(CurveFault::Blend { blend, line, length });
            }
        }
        let length: f64 = lines().sum();
        let mut curve = Self {
            points: [Vector3::zeros(); MAX_POINTS],
            at: [0.0; MAX_POINTS],
            count: all.len(),
            length,
            width: blend / length,
            turn: ToolTurn::new(start.rotation, turn),
        };
        let mut covered = 0.0;
        for ((point, at), (p, line)) in
            curve.points.iter_mut().zip(&mut curve.at).zip(all.iter().zip(lines().chain(std::iter::once(0.0))))
        {
            (*point, *at) = (*p, covered / length);
            covered += line;
        }
        Ok(curve)
    }

    /// The place at `u`.
    #[must_use]
    pub fn at(&self, u: f64) -> CurvePoint {
        let (position, velocity, bend) = self.position(u);
        let turn = self.turn.velocity();
        CurvePoint {
            pose: Pose::from_parts(Translation3::from(position), self.turn.at(u)),
            twist: Twist::new(velocity.x, velocity.y, velocity.z, turn.x, turn.y, turn.z),
            slope: Twist::new(bend.x, bend.y, bend.z, 0.0, 0.0, 0.0),
        }
    }

    fn position(&self, u: f64) -> (Vector3<f64>, Vector3<f64>, Vector3<f64>) {
        // The line whose corners lie around u.
        let line = self.at[1..self.count - 1].iter().take_while(|at| u >= **at).count();
        for corner in [line, line + 1] {
            let is_inner = corner > 0 && corner + 1 < self.count;
            if is_inner && (u - self.at[corner]).abs() < self.width {
                return self.rounded(corner, u);
            }
        }
        let velocity = self.velocity(line);
        (self.points[line] + velocity * (u - self.at[line]), velocity, Vector3::zeros())
    }

    fn rounded(&self, corner: usize, u: f64) -> (Vector3<f64>, Vector3<f64>, Vector3<f64>) {
        let (from, to) = (self.velocity(corner - 1), self.velocity(corner));
        let (since, span) = (u - self.at[corner] + self.width, 2.0 * self.width);
        let t = since / span;
        let turn = to - from;
        let begin = self.points[corner] - from * self.width;
        (
            begin + from * since + turn * (span * t * t * t * (1.0 - 0.5 * t)),
            from + turn * (t * t * (3.0 - 2.0 * t)),
            turn * (6.0 * t * (1.0 - t) / span),
        )
    }

    /// `dp/du` on a line: of the length of the whole polyline.
    fn velocity(&self, line: usize) -> Vector3<f64> {
        (self.points[line + 1] - self.points[line]).normalize() * self.length
    }

    /// Length of the lines, m.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.length
    }

    /// The tool's turn.
    #[must_use]
    pub fn turn(&self) -> &ToolTurn {
        &self.turn
    }
}
