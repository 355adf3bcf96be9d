//! Random constraints and references for the claims about paths, as strategies.

use proptest::prelude::{BoxedStrategy, ProptestConfig, Strategy};

pub(crate) use slideway_proofs::path_world::{
    APPROACH, Body, CUTOFF, Held, PERIOD, RECOVERY, Sketch, Suprema, Swing, dot, explicit, implicit, norm, per_push,
    settings,
};

/// Where one case is a whole run.
pub(crate) fn runs() -> ProptestConfig {
    ProptestConfig { cases: 2_000, ..crate::support::config() }
}

pub(crate) fn swing() -> impl Strategy<Value = Swing> {
    (0.1..0.5, triple(1.0..8.0), triple(0.0..6.3)).prop_map(|(amplitude, frequency, phase)| Swing {
        amplitude,
        frequency,
        phase,
    })
}

pub(crate) fn triple(range: std::ops::Range<f64>) -> BoxedStrategy<[f64; 3]> {
    crate::support::joints(range)
}

/// A direction that is not shorter than a tenth before it is brought to unit length.
pub(crate) fn direction() -> impl Strategy<Value = [f64; 3]> + Clone {
    triple(-1.0..1.0).boxed().prop_filter_map("a direction has a length", |x| {
        let length = norm(&x);
        (length > 0.1).then(|| x.map(|x| x / length))
    })
}

/// Kinds below `kinds`: 0 walls, 1 balls from outside, 2 balls from inside.
pub(crate) fn sketch(kinds: u8) -> impl Strategy<Value = Sketch> + Clone {
    (0..kinds, direction(), 0.0..0.2, 0.1..0.5).prop_map(|(kind, normal, room, radius)| Sketch {
        kind,
        normal,
        room,
        radius,
    })
}
