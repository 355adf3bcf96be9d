//! Claim `path-reserve`: with the reserve the explicit form keeps its band from any state, so the safe walk does.
//!
//! Hypotheses: rows as in [`crate::path_implicit`]. Push, reference and walk are arbitrary; the band `G_i = (γ1 + K γ2) U ‖∇σ_i‖`
//! may differ from sample to sample. With `e_i` the part of `φ_i` plus margin that lies above the band, `ρ` the recovery rate:
//!
//! ```text
//! e_i[k+1] <= max(0, e_i[k] - ρ T)
//! ```
//!
//! so from inside `φ_i <= G_i` at every sample, and `φ_i <= 0` with the margin [`slideway_conditioner::path::Margin::Band`].
//!
//! Source: this project; `[G12] 7.2.1` asks the designer to choose a push that is large enough, and example 9.4 does not.
//!
//! Derivation. The reserve is the smallest additional push that brings `φ_i` plus margin to at most `G_i + max(0, e_i - ρ T)`. It
//! exists by [`crate::path_implicit`]; where it does not the sample is held. Nothing about the walk is used: its speed limit
//! only makes the reserve rare.
//!
//! Dropped hypothesis: the reserve. A drift greater than the push then leaves the band.

use slideway_conditioner::PathConditioner;
use slideway_conditioner::path::{PathForm, PathOutcome, Reserve, SwitchingLaw};

use crate::claim::{Claim, Script, Twin, Verdict};
use crate::engine::{About, Choices, Cost, Engine, Stop, worse};
use crate::path_implicit::{bodies, from_first_contact};
use crate::path_world::{PERIOD, RECOVERY, Swing, norm, per_push, settings};
use crate::subject::Subject;

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "path-reserve",
    statement: "With the reserve φ_i stays in its band from any state inside it, whatever push, walk and reference do; from outside it returns at the recovery rate.",
    source: "this project; [G12] 7.2.1",
    verdict: Verdict::Ours,
    negations: &[
        Script { file: "path-reserve.smt2", text: include_str!("../smt/path-reserve.smt2") },
        Script { file: "path-reserve-recovery.smt2", text: include_str!("../smt/path-reserve-recovery.smt2") },
    ],
    twins: &[Twin {
        without: "reserve",
        script: Script {
            file: "path-reserve-without-reserve.smt2",
            text: include_str!("../smt/path-reserve-without-reserve.smt2"),
        },
    }],
    engines: &[
        Engine {
            name: "one_wall_or_ball_keeps_its_band",
            unit: "m",
            about: About::Other,
            cost: Cost::Run,
            trial: keeps_bands::<1>,
        },
        Engine {
            name: "pairs_keep_their_bands",
            unit: "m",
            about: About::Other,
            cost: Cost::Run,
            trial: keeps_bands::<2>,
        },
    ],
};

/// Pushes from far too small to ample, and starts with velocity. Where the rows depend on one another the sample is held: at rest, and the
/// band is not asked about. Rounding: 1e-12 of positions and velocities of the order of 1 to 10.
fn keeps_bands<const M: usize>(choices: &mut Choices, _: Subject) -> Result<f64, Stop> {
    let (swing, amplitude) = (Swing::draw(choices), choices.decade(-2.5, -1.0));
    let bodies = bodies::<M>(choices, &swing)?;
    let law = SwitchingLaw::Normalised { amplitude };
    let form = PathForm::Sliding { law, reserve: Reserve::On { recovery_rate: RECOVERY } };
    let conditioner = PathConditioner::<3, M>::new(settings(form))?;
    let mut state = conditioner.on_reference();
    let (mut beyond, mut margin, mut helped) = ([f64::INFINITY; M], f64::INFINITY, false);
    let longest = per_push() * amplitude;
    for reference in &from_first_contact(&swing, &bodies)? {
        let step = conditioner.step(&mut state, reference, |m| bodies.each_ref().map(|body| body.sample(m)));
        helped |= step.outcome == PathOutcome::Reserve;
        if matches!(step.outcome, PathOutcome::Held(_)) {
            if M == 1 || step.motion.velocity != [0.0; 3] {
                return Err(Stop::Refused(format!("{:?} in motion at {} s", step.outcome, reference.time)));
            }
            beyond = [f64::INFINITY; M];
            continue;
        }
        for ((beyond, body), phi) in beyond.iter_mut().zip(&bodies).zip(&step.phi) {
            let push = longest * norm(&body.sample(&step.motion).gradient);
            let left = (*beyond - RECOVERY * PERIOD).max(0.0);
            *beyond = phi - push;
            margin = worse(margin, left + 1e-11 - *beyond);
        }
    }
    // Only runs in which the push was not enough count.
    if helped { Ok(margin) } else { Err(Stop::Skipped) }
}
