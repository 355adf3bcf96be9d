//! Claim `never-slower`: sliding-mode regulation is never slower than natural motion under the same joint-speed limits.
//!
//! Hypotheses: the robot on the path (`A = 0`), limits `l > 0` (rad/s), joint speed `v` per unit of path rate; natural motion at
//! a path rate `s` within the limits and not above the target rate `λ̇d` (1/s); the implicit form with its filter settled: the
//! factor is the largest the limits allow, not held down by `(1 - a) f_before + a`.
//!
//! ```text
//! |v_i| s <= l_i,  s <= λ̇d,  f = f*   =>   s <= f λ̇d
//! ```
//!
//! Source: this project.
//!
//! Derivation. Either `f* = 1`, then `f λ̇d = λ̇d >= s`; or one joint is at its limit, `f λ̇d |v_i| = l_i >= s |v_i|` with `v_i ≠ 0`.
//! It holds place by place, so over any stretch in which the filter stays settled the regulated motion takes no longer. The
//! explicit form chatters about the same rate and falls short of it by its band (claims [`crate::frozen_band`],
//! [`crate::drifting_band`]).
//!
//! Dropped hypothesis: the filter has settled.

use slideway_conditioner::{AffineSpeed, ImplicitSpeedRegulator, SpeedState};
use slideway_robot::augmented::null_vector;

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::draw::{limits, settings};
use crate::engine::{About, Choices, Cost, Engine, Stop};
use crate::natural_world::System;
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "never-slower",
    statement: "On the path and with its filter settled, the implicit form runs at least as fast as natural motion at every place, if natural motion keeps the same joint-speed limits and the target rate is no lower than its rate.",
    source: "this project",
    verdict: Verdict::Ours,
    negations: &[Script { file: "never-slower.smt2", text: include_str!("../smt/never-slower.smt2") }],
    twins: &[Twin {
        without: "settled-filter",
        script: Script {
            file: "never-slower-without-settled-filter.smt2",
            text: include_str!("../smt/never-slower-without-settled-filter.smt2"),
        },
    }],
    engines: &[Engine {
        name: "regulated_path_rate_is_no_lower_than_that_of_natural_motion",
        unit: "share of the target rate",
        about: About::Other,
        cost: Cost::Sample,
        trial: at_least_as_fast,
    }],
};

/// Natural motion of a random system of three joints, `b` as large as the limits allow times a share; the shipped implicit
/// form at the same place, 200 samples after rest. With `a >= 0.2` the filter has risen to `1 - 0.8^200 = 1 - 4e-20`: settled.
/// Roundings: some ten of 1e-16 in each of the two rates; the condition of `n / det J` cancels: both take the same quotient.
fn at_least_as_fast(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let system = System::<3>::draw(choices);
    let limits = limits::<3>(choices, -2.0, 2.0)?;
    let (share, a, headroom) = (choices.share(), choices.between(0.2, 1.0), choices.between(1.0, 100.0));
    let null = null_vector(&system.jacobian, &system.tangent);
    if !(null.path.abs() > 1e-9 * system.volume()) {
        return Err(Stop::Skipped);
    }
    let unit = null.scaled(null.path.signum());
    let speeds: [f64; 3] = unit.joints.into();
    let natural: f64 = share / limits.ratio(&speeds) * unit.path;
    let target = headroom * natural.max(1e-6);
    let regulator = ImplicitSpeedRegulator::new(settings(limits, a, target))?;
    let desired = AffineSpeed { feedback: [0.0; 3], feedforward: (unit.joints / unit.path * target).into() };
    let mut state = SpeedState::at_rest();
    let mut rate = 0.0;
    for _ in 0..200 {
        rate = regulator.step(&mut state, &desired).path_rate;
    }
    Ok((rate - natural * (1.0 - 20.0 * f64::EPSILON)) / target)
}
