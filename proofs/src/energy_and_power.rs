//! Claim `energy-and-power`: kinetic energy is proportional to `b²`, mechanical power to `b³`.
//!
//! Hypotheses: natural motion, `b` constant in time; gravity balanced or absent; no friction. Compared are the same places of
//! the path at two values of `b`.
//!
//! ```text
//! E = ½ b² nᵀ M n (J)          P = τᵀq̇ = b³ nᵀ (M (∂n/∂q̄) n̄ + c(q, n)) (W)
//! ```
//!
//! Source: `[N] section II C`, which states it for the system of eq 11, gravity included in its `τ`. The weight's power
//! `b gᵀn` is linear in `b`, so gravity has to be left out.
//!
//! Derivation. `q̇ = b n`, `q̈ = b² (∂n/∂q̄) n̄`, and centrifugal torques are quadratic in `q̇`.
//!
//! Dropped hypotheses: gravity balanced; `b` constant.

use nalgebra::Vector3;
use slideway_robot::augmented::{PathTangent, SingularityConsistent, SpeedFactor};
use slideway_robot::models::puma560_dynamics;
use slideway_robot::{JointVector, Task, Twist};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::engine::{About, Choices, Cost, Engine, Stop, worse};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "energy-and-power",
    statement: "Under natural motion without gravity and friction, k times b gives at every place k² times the kinetic energy and k³ times the mechanical power.",
    source: "[N] section II C",
    verdict: Verdict::HoldsWithCorrection,
    negations: &[Script { file: "energy-and-power.smt2", text: include_str!("../smt/energy-and-power.smt2") }],
    twins: &[
        Twin {
            without: "balanced-gravity",
            script: Script {
                file: "energy-and-power-without-balanced-gravity.smt2",
                text: include_str!("../smt/energy-and-power-without-balanced-gravity.smt2"),
            },
        },
        Twin {
            without: "constant-b",
            script: Script {
                file: "energy-and-power-without-constant-b.smt2",
                text: include_str!("../smt/energy-and-power-without-constant-b.smt2"),
            },
        },
    ],
    engines: &[Engine {
        name: "energy_goes_with_the_square_and_power_with_the_cube",
        unit: "share of the terms",
        about: About::Other,
        cost: Cost::Sample,
        trial: square_and_cube,
    }],
};

/// The PUMA-560 without gravity, by its own energy and inverse dynamics. Roundings: some hundred of 1e-16 in each torque,
/// of the sizes that cancel in it, which are no larger than accelerations times the mass matrix and centrifugal torques.
fn square_and_cube(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    fn refused(error: impl std::fmt::Display) -> Stop {
        Stop::Refused(error.to_string())
    }
    let arm = puma560_dynamics().map_err(refused)?.with_gravity(Vector3::zeros());
    let q = JointVector::from(choices.numbers::<6>(-3.1, 3.1));
    let (twist, slope) = (choices.numbers::<6>(-1.0, 1.0), choices.numbers::<6>(-1.0, 1.0));
    let (b, k) = (choices.between(0.1, 3.0), choices.between(0.1, 10.0));
    let inversion = SingularityConsistent::new(Task::Pose, SpeedFactor::Determinant, 6).map_err(refused)?;
    let tangent = PathTangent { twist: Twist::from(twist), slope: Twist::from(slope) };
    let flow = inversion.flow(arm.arm(), &q, &tangent);
    let energy = |b: f64| arm.kinetic_energy(&q, &flow.motion(b, 0.0).joint_speed);
    let square = 1e-12 - (energy(k * b) / (k * k * energy(b)) - 1.0).abs();
    let power = |b: f64| {
        let motion = flow.motion(b, 0.0);
        arm.inverse(&q, &motion.joint_speed, &motion.joint_acceleration).dot(&motion.joint_speed)
    };
    let speed = flow.direction.joints.norm() * b;
    let size = arm.mass_matrix(&q).norm() * speed * (flow.slope.joints.norm() * b * b + speed * speed) * k.powi(3);
    Ok(worse(square, 1e-12 - (power(k * b) - k.powi(3) * power(b)).abs() / size))
}
