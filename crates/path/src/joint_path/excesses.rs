use super::{JointPath, PieceKind};
use crate::limits::position_limits::{PositionExcess, PositionLimits};
use slideway_robot::{JointVector, PositionRange};

impl<const N: usize> JointPath<N> {
    /// The joints that leave their ranges along the path, each where it is farthest outside.
    #[must_use]
    pub fn position_excesses(&self, limits: &PositionLimits<N>) -> Vec<PositionExcess> {
        let mut found: [Option<PositionExcess>; N] = [None; N];
        for piece in self.pieces() {
            match piece.kind() {
                PieceKind::Follow { at, q, .. } | PieceKind::Prescribed { at, q, .. } => {
                    at.iter().zip(q).for_each(|(lambda, q)| widen(limits, *lambda, q, &mut found));
                }
                PieceKind::SelfMotion { lambda, from, to } => {
                    [from, to].into_iter().for_each(|q| widen(limits, *lambda, q, &mut found));
                }
            }
        }
        found.into_iter().flatten().collect()
    }
}

/// Keeps the farthest excess of every joint.
fn widen<const N: usize>(
    limits: &PositionLimits<N>,
    lambda: f64,
    q: &JointVector<N>,
    found: &mut [Option<PositionExcess>; N],
) {
    for (joint, worst) in found.iter_mut().enumerate() {
        let Some(PositionRange { lower, upper }) = limits.ranges[joint] else { continue };
        let outside = |position: f64| (position - upper).max(lower - position);
        let farther = worst.is_none_or(|w| outside(q[joint]) > outside(w.position));
        if outside(q[joint]) > 0.0 && farther {
            *worst = Some(PositionExcess { joint, lambda, position: q[joint], lower, upper, source: limits.source });
        }
    }
}
