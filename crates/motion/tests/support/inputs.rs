//! Inputs that the supervisor can be given.

use slideway_motion::supervisor::{Fault, Inputs};

/// All inputs.
pub(crate) fn inputs() -> Vec<Inputs> {
    let faults = Fault::ALL.into_iter().map(Some).chain([None]);
    faults
        .flat_map(|fault| {
            (0..128_u32).map(move |bits| Inputs {
                fault,
                brake_fully: bits & 1 != 0,
                brake_on_path: bits & 2 != 0,
                discard: bits & 4 != 0,
                resume: bits & 8 != 0,
                start: bits & 16 != 0,
                reset: bits & 32 != 0,
                recover: bits & 64 != 0,
            })
        })
        .collect()
}
