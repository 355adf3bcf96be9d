//! Claim `path-band-appendix`: how far `φ` leaves zero in the appendix's scheme.
//!
//! Hypotheses: full push `G` and drift `D <= D̄` per sample (units of `σ`), `0 <= D̄ <= G`, and a push that takes effect over
//! three samples, a quarter, a half and a quarter of it, which is what prewarped Tustin filters and finite differences give
//! in the limit of a short sampling period.
//!
//! ```text
//! φ[k+1] = φ[k] + D[k] - G (s[k] / 4 + s[k-1] / 2 + s[k-2] / 4),   s[k] = [φ[k] >= 0]
//! φ[k] <= D̄ + (D̄ - G/4)⁺ + (D̄ - 3G/4)⁺
//! ```
//!
//! Source: `[G12] eq 22` and appendix; the estimate of eq 22 is exceeded by up to 1.5 there.
//!
//! Derivation. Induction on the number `r` of samples since `φ` was last negative: `r = 1` gives `φ <= D̄`, each further
//! sample adds what the drift has over `G/4`, `3G/4` and then `G` (nothing). Older pushes still under way only help. The
//! function is [`slideway_conditioner::path::bounds::appendix_upper_band`].
//!
//! Dropped hypothesis: `D̄ <= G`.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "path-band-appendix",
    statement: "Appendix's scheme, drifts D <= D̄ <= G per sample: φ <= D̄ + (D̄ - G/4)⁺ + (D̄ - 3G/4)⁺; the width of eq 22 is no bound.",
    source: "[G12] eq 22 and appendix",
    verdict: Verdict::HoldsWithCorrection,
    negations: &[Script { file: "path-band-appendix.smt2", text: include_str!("../smt/path-band-appendix.smt2") }],
    twins: &[Twin {
        without: "push-beating-drift",
        script: Script {
            file: "path-band-appendix-without-push-beating-drift.smt2",
            text: include_str!("../smt/path-band-appendix-without-push-beating-drift.smt2"),
        },
    }],
    engines: &[],
};
