//! Why a path has no bracket.

use thiserror::Error;

/// What is wrong with a path, its limits or its options. Joints and knots are counted from 0.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum BracketError {
    /// Lists whose lengths do not fit together.
    #[error("{what}: {given} given, {needed} needed")]
    Count {
        /// The list.
        what: &'static str,
        /// Entries given.
        given: usize,
        /// Entries needed.
        needed: usize,
    },
    /// A segment whose polynomials have too many coefficients, or none.
    #[error("segment {segment}: joint {joint} has {given} coefficients; 1 to 6 (degree 5) are taken")]
    Degree {
        /// The segment.
        segment: usize,
        /// The joint.
        joint: usize,
        /// Coefficients given.
        given: usize,
    },
    /// A knot that is not finite or not above the one before.
    #[error("knot {knot} is not a finite number above the knot before it")]
    Knot {
        /// The knot.
        knot: usize,
    },
    /// A coefficient that is not finite.
    #[error("segment {segment}: a coefficient of joint {joint} is not finite")]
    NotFinite {
        /// The segment.
        segment: usize,
        /// The joint.
        joint: usize,
    },
    /// A joint that jumps at a knot: no motion follows it.
    #[error("joint {joint} jumps by {jump:e} at s = {s}: a joint path is continuous")]
    Jump {
        /// The joint.
        joint: usize,
        /// The path parameter.
        s: f64,
        /// Difference of the joint's two values.
        jump: f64,
    },
    /// Numbers of a segment so large or small that products of them overflow or vanish.
    #[error("segment {segment}: coefficients and knots must be below 1e30, and lengths above 1e-30: use other units")]
    Size {
        /// The segment.
        segment: usize,
    },
    /// A limit with the wrong sign, NaN, or of a size like [`BracketError::Size`].
    #[error(
        "joint {joint}: a speed limit and an upper acceleration limit are above 0, a lower one is below 0, of sizes from \
         1e-30 to 1e30; infinity stands for none, of both acceleration limits or of neither"
    )]
    Limit {
        /// The joint.
        joint: usize,
    },
    /// A stretch on which no limited joint moves: nothing bounds its speed.
    #[error("from s = {from} to s = {to} no joint with a limit moves: remove that stretch")]
    Still {
        /// Begin of the stretch.
        from: f64,
        /// Its end.
        to: f64,
    },
    /// A place where the path stands without turning back: its rate has no bound there.
    #[error("at s = {s} all joints stand without turning back: use a parameter in which the path moves there")]
    Stall {
        /// The path parameter.
        s: f64,
    },
    /// A free end of a path without speed limits: any rate is possible there.
    #[error("an end with a free rate needs a speed limit of a joint that moves")]
    FreeEnd,
    /// An option out of range.
    #[error("{what} must be {needed}")]
    Option {
        /// The option.
        what: &'static str,
        /// What it must be.
        needed: &'static str,
    },
    /// The conic solver refused the data.
    #[error("the solver refused the problem: {0}")]
    Solver(String),
}
