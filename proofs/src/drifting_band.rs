//! Claim `drifting-band`: the width of the chattering on a path along which the limit drifts.
//!
//! Hypotheses: zero tracking error, `0 < a <= 1`, `g(λ) <= g_max`, and with `L = sup |d ln g / dλ|` (1/unit of λ), `Ts` (s),
//! `λ̇*max` (unit of λ per s), `d = L Ts λ̇*max` (unit 1) and
//!
//! ```text
//! M = (1 - a) exp(d) + a g_max
//! ```
//!
//! the conditions `M >= 1`, `m[0] <= 1` and the reaching condition `d M <= -ln(1 - a)`. Then `m[k] <= M` at every sample.
//!
//! Source: this project. `[G11]` notes that its reaching condition is not enforced by the switching action and gives no bound.
//!
//! Derivation. In the published advance `Δλ = Ts f λ̇d = Ts m λ̇*`, so one sample changes `ln g` by at most `d m`. Assume `m <= M`.
//!
//! - `m <= 1`: `u = 1`, `m' = (1 - a) m g'/g + a g' <= (1 - a) exp(d) + a g_max = M`.
//! - `1 < m <= M`: `u = 0`, `m' = (1 - a) m g'/g <= m (1 - a) exp(d M) <= m`, by the reaching condition.
//!
//! The synchronised advance moves `λ` by at most as much, so the same bound holds there; since it moves by
//! `Ts min(m, 1) λ̇*`, the second case then needs no more than `d <= -ln(1 - a)`. The function
//! [`slideway_conditioner::bounds::drifting_band`] asks for the stronger condition in both cases.
//!
//! A weaker reaching condition does. On a path the drift of one sample is at most `r f` with `r = L Ts λ̇d`, and for `g >= g_min >= 1`
//! the factor never exceeds `f_max = 1 / g_min + a (1 - 1 / g_min)`: it rises only from `f <= 1 / g <= 1 / g_min`. With
//! `λ̇*max = λ̇d / g_min` the second case then needs `r f_max <= -ln(1 - a)` only, that is `d (1 + a (g_min - 1)) <= -ln(1 - a)`,
//! which `d M <= -ln(1 - a)` implies because `M >= 1 + a (g_max - 1)`. The second script proves it, and the property test runs
//! at its edge too.
//!
//! In the scripts the two exponentials are reals of which only the bounds above are known.
//!
//! Dropped hypothesis: the reaching condition. The limit then falls faster than the filter, and `m` grows while `u = 0`.

use crate::claim::{Claim, Script, Twin, Verdict};

/// The claim and its scripts.
pub const CLAIM: Claim = Claim {
    name: "drifting-band",
    statement: "With zero error, M = (1 - a) exp(L Ts λ̇*max) + a g_max >= 1, m[0] <= 1 and L Ts λ̇*max M <= -ln(1 - a): m <= M at every sample.",
    source: "this project; [G11] section 3.3.1 has no bound for a moving path",
    verdict: Verdict::Ours,
    negations: &[
        Script { file: "drifting-band.smt2", text: include_str!("../smt/drifting-band.smt2") },
        Script { file: "drifting-band-on-path.smt2", text: include_str!("../smt/drifting-band-on-path.smt2") },
    ],
    twins: &[Twin {
        without: "reaching",
        script: Script {
            file: "drifting-band-without-reaching.smt2",
            text: include_str!("../smt/drifting-band-without-reaching.smt2"),
        },
    }],
};
