//! Claim `natural-speed`: under natural motion the speed along the path is proportional to `|det J|`.
//!
//! Hypotheses: `q̇ = b adj(J) t*`, the tool on a path with `t* ≠ 0` (m, 1 per unit of the path parameter), `b` constant.
//!
//! ```text
//! J q̇ = t* q̇*  =>  q̇* = b det J          q̇*(1) det J(2) = q̇*(2) det J(1)
//! ```
//!
//! Source: `[N] eq 7, 8` and section II B.
//!
//! Derivation. `J q̇ = b J adj(J) t* = b det(J) t*` (claim [`crate::null_vector`]); where `t* ≠ 0` only one path speed fits. The
//! tool moves at `‖t*‖ |q̇*|`, which on a path parametrised by its length is `|b det J|`.
//!
//! Dropped hypothesis: `b` constant, as at constant speed.

use slideway_robot::augmented::{PathTangent, SingularityConsistent, SpeedFactor};
use slideway_robot::models::puma560;
use slideway_robot::{JointVector, Task, Twist};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::engine::{About, Choices, Cost, Engine, Stop, worse};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "natural-speed",
    statement: "With q̇ = b adj(J) t* and t* ≠ 0 the path speed is b det J and nothing else; with b constant the speeds at two places are as the determinants.",
    source: "[N] eq 7, 8",
    verdict: Verdict::Holds,
    negations: &[
        Script { file: "natural-speed.smt2", text: include_str!("../smt/natural-speed.smt2") },
        Script { file: "natural-speed-places.smt2", text: include_str!("../smt/natural-speed-places.smt2") },
    ],
    twins: &[Twin {
        without: "constant-b",
        script: Script {
            file: "natural-speed-without-constant-b.smt2",
            text: include_str!("../smt/natural-speed-without-constant-b.smt2"),
        },
    }],
    engines: &[Engine {
        name: "tool_moves_along_the_path_at_b_times_the_determinant",
        unit: "1",
        about: About::Other,
        cost: Cost::Sample,
        trial: as_the_determinant,
    }],
};

/// The shipped inversion on the six-joint arm. The tool's twist is that of its Jacobian, the determinant that of its
/// elimination; lengths below 1 m and unit axes make every row shorter than 3, so products of six stay below 1e3 and
/// their roundings below 1e-12.
fn as_the_determinant(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let arm = puma560();
    let q = JointVector::from(choices.numbers::<6>(-3.1, 3.1));
    let tangent = PathTangent { twist: Twist::from(choices.numbers::<6>(-1.0, 1.0)), slope: Twist::zeros() };
    let b = choices.between(-3.0, 3.0);
    let inversion = SingularityConsistent::new(Task::Pose, SpeedFactor::Determinant, 6)
        .map_err(|error| Stop::Refused(error.to_string()))?;
    let motion = inversion.flow(&arm, &q, &tangent).motion(b, 0.0);
    let jacobian = arm.jacobian(&q);
    let determinant = jacobian.lu().determinant();
    let along = 1e-12 - (motion.path_speed - b * determinant).abs();
    Ok(worse(along, 1e-11 - (jacobian * motion.joint_speed - tangent.twist * (b * determinant)).norm()))
}
