//! Claim `finite-through-singularity`: joint speeds stay finite where the Jacobian is singular.
//!
//! Hypotheses: entries of `J` and `t` in [-1, 1] (any scale), `J` singular, `[J, -t]` of full rank: a singularity of
//! codimension one. `b` finite.
//!
//! ```text
//! n̄ ≠ 0, |n_i| <= 2 (two joints), q̇* = 0;    J v = t s has no solution with s ≠ 0
//! ```
//!
//! Source: `[N] section II A`.
//!
//! Derivation. The entries of `n̄` are the minors of `[J, -t]`: bounded like every polynomial (by the product of the lengths
//! of its rows, for any number of joints), and not all zero at full rank. The path stands where `det J = 0` while the joints
//! go on. The second script is the other side: there `t` is not in the range of `J`, so constant speed has no joint speed at all.
//!
//! Dropped hypothesis: codimension one. `n̄` is then zero: the arm stands, still finite.

use slideway_robot::augmented::null_vector;

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::engine::{About, Choices, Cost, Engine, Stop, worse};
use crate::natural_world::System;
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "finite-through-singularity",
    statement: "At a singularity of codimension one the null vector is finite and not zero while its path speed is zero; no finite joint speed follows the path at another path speed.",
    source: "[N] section II A",
    verdict: Verdict::Holds,
    negations: &[
        Script {
            file: "finite-through-singularity.smt2",
            text: include_str!("../smt/finite-through-singularity.smt2"),
        },
        Script {
            file: "finite-through-singularity-constant-speed.smt2",
            text: include_str!("../smt/finite-through-singularity-constant-speed.smt2"),
        },
    ],
    twins: &[Twin {
        without: "codimension-one",
        script: Script {
            file: "finite-through-singularity-without-codimension-one.smt2",
            text: include_str!("../smt/finite-through-singularity-without-codimension-one.smt2"),
        },
    }],
    engines: &[Engine {
        name: "joints_go_on_at_bounded_speed_through_a_planted_singularity",
        unit: "share of the Hadamard bound",
        about: About::Other,
        cost: Cost::Sample,
        trial: joints_go_on,
    }],
};

/// Roundings of determinants of six rows, relative to the Hadamard bound; see the claim `null-vector`.
const SLACK: f64 = 1e-13;

/// A planted singularity: the last column depends on the others. There the path stands and the joints go on. On the way
/// through it, a share of another column running from -1e-3 to 1e-3, the null vector is no longer than the product of
/// the rows' lengths, and the path speed, linear in that column, changes its sign.
fn joints_go_on(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let (system, other) = (System::<6>::spoilt(choices, 0.0), System::<6>::draw(choices));
    let place = null_vector(&system.jacobian, &system.tangent);
    // Close to a loss of two ranks the direction is that of rounding errors.
    if !(place.joints.norm() > 1e-6 * system.volume()) {
        return Err(Stop::Skipped);
    }
    let mut margin = SLACK - place.path.abs() / system.volume();
    for share in [1e-6, 1e-3] {
        let [before, after] = [-share, share].map(|share| {
            let mut passing = system;
            passing.jacobian.set_column(5, &(system.jacobian.column(5) + other.jacobian.column(5) * share));
            (null_vector(&passing.jacobian, &passing.tangent), passing.volume())
        });
        for (null, volume) in [before, after] {
            margin = worse(margin, 1.0 + SLACK - null.norm() / volume);
        }
        margin = worse(margin, 2.0 * SLACK - (before.0.path + after.0.path).abs() / (before.1 + after.1));
    }
    Ok(margin)
}
