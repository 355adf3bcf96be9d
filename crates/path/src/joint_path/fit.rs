//! A spline through points of a joint path, by length.
//!
//! Between neighbouring points the path is replaced by a [`Quintic`] with its positions, directions and curvatures at both. Its parameter is length in
//! shares of the speed limits, so that neither a path parameter that slows to nothing nor one that races beside a singularity leaves a trace. Intervals are halved until
//! the quintic needs the same accelerations as the path, to a share of the limits, at samples between.

use super::hermite::{Derivatives, Quintic};
use super::polynomials::{Builder, SplineDeviation};
use super::track::Track;
use super::{Piece, PieceKind};
use crate::jumps::{Tangent, jumps};
use crate::path_problem::PathProblem;
use slideway_robot::JointVector;

/// A point of a joint path by its length.
#[derive(Clone, Copy, Debug)]
struct Node<const N: usize> {
    lambda: f64,
    /// Configuration, direction and curvature.
    by_length: Derivatives<N>,
    /// `dλ/dσ`.
    rate: f64,
}

/// One piece of a joint path, to be replaced.
pub(super) struct Fit<'a, const N: usize> {
    problem: &'a PathProblem<N>,
    piece: &'a Piece<N>,
    /// Inverse speed limits.
    weights: JointVector<N>,
    /// Share of the limits to which accelerations, or speeds where these alone are limited, agree.
    tolerance: f64,
    length: f64,
    /// The motion of a redundant arm, which is no function of the place on the tool path.
    track: Option<Track<'a, N>>,
    deviation: SplineDeviation,
}

/// Intervals of a piece before any is halved.
const INTERVALS: usize = 32;
/// Shares of an interval at which it is cut, the first of them at which the joints are far enough from both ends.
const MIDDLES: [f64; 5] = [0.5, 0.4, 0.6, 0.3, 0.7];
/// A second place at which an interval is looked at.
const SECOND_LOOK: f64 = 0.27;
/// Motion of the joints, rad, below which an interval is not cut: configurations right to 1e-15 give its curvature to some 1e-6 only.
const SHORTEST: f64 = 2e-4;
/// Error of a curvature, as a share of the inverse length of the piece, above which it is not known at a point.
const UNKNOWN: f64 = 1e-7;
/// Change of direction over no distance that is a corner.
const CORNER: f64 = 1e-3;

impl<'a, const N: usize> Fit<'a, N> {
    /// A piece; of a redundant arm it begins at `start`. The place where the motion of such an arm breaks.
    pub(super) fn new(
        problem: &'a PathProblem<N>,
        piece: &'a Piece<N>,
        tolerance: f64,
        start: Option<JointVector<N>>,
    ) -> Result<Self, f64> {
        let track = match &piece.kind {
            PieceKind::Follow { tool, at, q, .. } if problem.is_redundant() => {
                Some(Track::new(problem, tool, at, start.unwrap_or(q[0]))?)
            }
            _ => None,
        };
        let deviation = SplineDeviation::default();
        let mut fit = Self { problem, piece, weights: weights(problem), tolerance, length: 0.0, track, deviation };
        let distance = |w: &[JointVector<N>]| (w[1] - w[0]).component_mul(&fit.weights).norm();
        fit.length = fit.traced().1.windows(2).map(distance).sum();
        Ok(fit)
    }

    /// The configuration in which a redundant arm ends the piece.
    pub(super) fn end_of_track(&self) -> Option<JointVector<N>> {
        self.track.as_ref().and_then(Track::end)
    }

    fn traced(&self) -> (&[f64], &[JointVector<N>]) {
        match &self.piece.kind {
            PieceKind::Follow { at, q, .. } | PieceKind::Prescribed { at, q, .. } => (at, q),
            PieceKind::SelfMotion { .. } => (&[], &[]),
        }
    }

    /// Adds the piece's spline to others; the largest distances seen, or the place where no direction of travel was found.
    pub(super) fn add_to(mut self, builder: &mut Builder) -> Result<SplineDeviation, f64> {
        let grid = self.piece.grid(self.problem, INTERVALS);
        let nodes: Vec<Node<N>> = grid[1..INTERVALS].iter().filter_map(|&at| self.node(at)).collect();
        let tangent = |at: f64, value| Tangent { at, value, slope: JointVector::zeros() };
        let tangents: Vec<_> = nodes.iter().map(|node| tangent(node.lambda, node.by_length.first)).collect();
        let unit = self.weights.iter().fold(0.0, |most: f64, w| most.max(1.0 / w));
        let direction = |at: f64| self.direction(at).map(|value| tangent(at, value));
        let mut corners = jumps(&tangents, CORNER * unit, direction);
        corners.push(self.piece.end());
        let mut begin = self.piece.start();
        for end in corners {
            let stretch = end - begin;
            let first = self.end(begin, stretch).ok_or(begin)?;
            let last = self.end(end, -stretch).ok_or(end)?;
            let mut all = vec![first];
            for node in nodes.iter().filter(|node| node.lambda > begin && node.lambda < end) {
                // A curvature between points that are too near would be made of rounding.
                if all.iter().chain([&last]).all(|other| distance(node, other) >= SHORTEST) {
                    all.push(*node);
                }
            }
            all.push(last);
            for pair in all.windows(2) {
                self.halve(pair[0], pair[1], builder);
            }
            begin = end;
        }
        Ok(self.deviation)
    }

    /// The joint path by the path parameter.
    fn derivatives(&self, lambda: f64) -> Option<Derivatives<N>> {
        if let Some(track) = &self.track {
            return track.at(lambda);
        }
        let point = self.piece.at(self.problem, lambda).ok()?;
        Some(Derivatives { q: point.q, first: point.first, second: point.second })
    }

    /// The direction of travel at a path parameter, known even where the parameter nearly stands.
    fn direction(&self, lambda: f64) -> Option<JointVector<N>> {
        let (by_length, speed) = self.derivatives(lambda)?.by_length(&self.weights);
        (speed > 0.0 && speed.is_finite()).then_some(by_length.first)
    }

    /// The point at a path parameter; `None` where rounding hides its direction or curvature.
    fn node(&self, lambda: f64) -> Option<Node<N>> {
        let point = self.derivatives(lambda)?;
        let (by_length, speed) = point.by_length(&self.weights);
        let error = 1e-15 * point.second.component_mul(&self.weights).norm() / (speed * speed);
        let known = speed > 0.0 && speed.is_finite() && error * self.length <= UNKNOWN;
        known.then_some(Node { lambda, by_length, rate: 1.0 / speed })
    }

    /// An end of a stretch: its configuration, with direction and curvature as they go on from the first place `by` from there that has them.
    fn end(&self, at: f64, stretch: f64) -> Option<Node<N>> {
        let q = self.configuration(at)?;
        let mut by = 1e-9 * stretch;
        while by.abs() < 0.1 * stretch.abs() {
            if let Some(near) = self.node(at + by) {
                let Derivatives { q: there, first, second } = near.by_length;
                let distance = (there - q).component_mul(&self.weights).norm().copysign(by);
                let first = first - second * distance;
                let first = first / first.component_mul(&self.weights).norm();
                return Some(Node { lambda: at, by_length: Derivatives { q, first, second }, rate: near.rate });
            }
            by *= 2.0;
        }
        None
    }

    /// The configuration at an end of the piece as it was traced, elsewhere as it is found.
    fn configuration(&self, at: f64) -> Option<JointVector<N>> {
        if self.track.is_some() {
            return self.derivatives(at).map(|point| point.q);
        }
        let (_, q) = self.traced();
        if at == self.piece.start() {
            q.first().copied()
        } else if at == self.piece.end() {
            q.last().copied()
        } else {
            self.derivatives(at).map(|point| point.q)
        }
    }

    fn halve(&mut self, from: Node<N>, to: Node<N>, builder: &mut Builder) {
        let mut rest = vec![to];
        let mut begin = from;
        while let Some(end) = rest.pop() {
            let quintic = Quintic::between(&begin.by_length, &end.by_length, &self.weights);
            match self.middle(&begin, &end, &quintic) {
                Some(middle) => rest.extend([end, middle]),
                None => {
                    builder.push(quintic.length, &quintic.powers, lambda_of(&begin, &end, quintic.length));
                    self.deviation.points += 1;
                    begin = end;
                }
            }
        }
    }

    /// The point at which an interval is to be cut; `None` if the quintic is good enough or its ends too near.
    fn middle(&mut self, begin: &Node<N>, end: &Node<N>, quintic: &Quintic<N>) -> Option<Node<N>> {
        let at = |share: f64| self.node(begin.lambda + share * (end.lambda - begin.lambda));
        let apart = |node: &Node<N>| distance(node, begin).min(distance(node, end)) >= 0.5 * SHORTEST;
        let middle = MIDDLES.into_iter().filter_map(at).find(apart);
        let looks = middle.into_iter().chain(at(SECOND_LOOK));
        let seen: Vec<_> = looks.map(|node| (node, self.nearest(begin, &node, quintic))).collect();
        if middle.is_some() && seen.iter().any(|(node, there)| !(self.error(node, there) <= self.tolerance)) {
            return middle;
        }
        seen.iter().for_each(|(node, there)| self.measure(node, there));
        None
    }

    fn nearest(&self, begin: &Node<N>, node: &Node<N>, quintic: &Quintic<N>) -> Derivatives<N> {
        let way = (node.by_length.q - begin.by_length.q).component_mul(&self.weights).norm();
        quintic.nearest(&node.by_length.q, (way / quintic.length).min(1.0), &self.weights)
    }

    /// By how much accelerations and speeds along the spline differ from those along the path at the largest rate that the limits allow, as shares of these.
    fn error(&self, node: &Node<N>, spline: &Derivatives<N>) -> f64 {
        let path = &node.by_length;
        let (spline, _) = spline.by_length(&self.weights);
        let share = |of: &JointVector<N>, limits: &JointVector<N>| of.component_div(limits).amax();
        let speeds = self.weights.map(|w| 1.0 / w);
        let slowness = share(&path.first, &speeds);
        let by_speed = share(&(spline.first - path.first), &speeds) / slowness;
        let Some(bounds) = &self.problem.acceleration_limits else { return by_speed };
        let range = bounds.at(node.lambda);
        let limits = JointVector::from_fn(|i, _| range.upper[i].min(-range.lower[i]));
        let fastest = (1.0 / (slowness * slowness)).min(1.0 / share(&path.second, &limits));
        by_speed.max(share(&(spline.second - path.second), &limits) * fastest)
    }

    fn measure(&mut self, node: &Node<N>, spline: &Derivatives<N>) {
        let (path, seen) = (&node.by_length.q, &mut self.deviation);
        seen.joint = seen.joint.max((spline.q - path).amax());
        let (a, b) = (self.problem.arm.forward(path), self.problem.arm.forward(&spline.q));
        seen.tool_m = seen.tool_m.max((a.translation.vector - b.translation.vector).norm());
        // Of a rotation matrix's small turn the skew part: its angle comes without the cancellation of an arc cosine.
        let turn = a.rotation.matrix().transpose() * b.rotation.matrix();
        let skew = [turn[(2, 1)] - turn[(1, 2)], turn[(0, 2)] - turn[(2, 0)], turn[(1, 0)] - turn[(0, 1)]];
        seen.tool_rad = seen.tool_rad.max(0.5 * skew.iter().map(|x| x * x).sum::<f64>().sqrt());
    }
}

/// Largest motion of a joint between two points, rad (m).
fn distance<const N: usize>(a: &Node<N>, b: &Node<N>) -> f64 {
    (a.by_length.q - b.by_length.q).amax()
}

/// Inverse speed limits, the wider of both senses; 1 for joints without.
pub(super) fn weights<const N: usize>(problem: &PathProblem<N>) -> JointVector<N> {
    let (lower, upper) = (problem.speed_limits.lower(), problem.speed_limits.upper());
    JointVector::from_fn(|i, _| {
        let limit = upper[i].max(-lower[i]);
        if limit.is_finite() { 1.0 / limit } else { 1.0 }
    })
}

/// The path parameter between two points, rising: a cubic by length with slopes cut to where it stays so.
fn lambda_of<const N: usize>(begin: &Node<N>, end: &Node<N>, length: f64) -> Vec<f64> {
    let mean = (end.lambda - begin.lambda) / length;
    let [from, to] = [begin.rate, end.rate].map(|rate| rate.min(3.0 * mean));
    vec![begin.lambda, from, (3.0 * mean - 2.0 * from - to) / length, (from + to - 2.0 * mean) / (length * length)]
}

impl SplineDeviation {
    pub(super) fn worst(self, other: Self) -> Self {
        Self {
            joint: self.joint.max(other.joint),
            tool_m: self.tool_m.max(other.tool_m),
            tool_rad: self.tool_rad.max(other.tool_rad),
            points: self.points + other.points,
        }
    }
}
