use slideway_path::LimitKind;
use thiserror::Error;

/// Reason why there is no optimum.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum OptimumError {
    /// A piece whose joints do not move: any speed is possible.
    #[error("piece {} of the joint path does not move: its shortest time is zero", piece + 1)]
    NoMotion {
        /// The piece, counted from 0.
        piece: usize,
    },
    /// A derivative of the joint path that is NaN or infinite.
    #[error("the joint path has no finite derivatives at node {node} of piece {}", piece + 1)]
    NotFinite {
        /// The piece, counted from 0.
        piece: usize,
        /// The node, counted from 0.
        node: usize,
    },
    /// No profile keeps the limits. Named is the limit that matters most in the proof.
    #[error(
        "no speed profile keeps the {} at s = {s:.6} (node {node} of piece {}): short by at least {:.3} % of its range",
        limit(*kind, *index), piece + 1, 100.0 * share
    )]
    Infeasible {
        /// The piece, counted from 0.
        piece: usize,
        /// The node, counted from 0; of a limit between nodes, the one before.
        node: usize,
        /// The piece's parameter there.
        s: f64,
        /// Quantity that is limited.
        kind: LimitKind,
        /// The joint, counted from 0; 0 for the tool's speed, the polygon's side for its acceleration.
        index: usize,
        /// Unless some limit of the proof gives way by this share of its range, there is no profile.
        share: f64,
        /// True if the proof, a Farkas certificate, holds under outward rounding; false only within rounding of feasible.
        proven: bool,
    },
    /// Limits between the nodes stay exceeded.
    #[error("limits between the nodes are still exceeded by {excess:e} of their range after {rounds} rounds")]
    NotRefined {
        /// Largest excess that is left, as a share of a limit's range.
        excess: f64,
        /// Rounds tried.
        rounds: usize,
    },
    /// The solver refused the problem's data.
    #[error("the solver refused the problem: {0}")]
    Solver(String),
    /// The solver's answer is no profile, or breaks a limit that scaling does not mend.
    #[error("the solver's answer cannot be repaired: {0}")]
    Unrepairable(&'static str),
}

/// A limit in words. The tool has one of each kind: which side of its polygon is meant tells the reader nothing.
fn limit(kind: LimitKind, index: usize) -> String {
    let joint = index + 1;
    match kind {
        LimitKind::JointSpeed => format!("speed limit of joint {joint}"),
        LimitKind::JointAcceleration => format!("acceleration limit of joint {joint}"),
        LimitKind::JointTorque => format!("torque limit of joint {joint}"),
        LimitKind::ToolSpeed | LimitKind::ToolAcceleration => format!("{kind} limit"),
    }
}
