use crate::speed::entries::{MethodEntry, OptimumEntry};
use slideway_lab::{Disturbances, Method, Trace};

/// What a verdict is made from: a method's run beside the optimum.
#[derive(Clone, Copy)]
pub(crate) struct Judged<'a> {
    pub(crate) entry: &'a MethodEntry,
    pub(crate) trace: &'a Trace,
    pub(crate) optimum: &'a OptimumEntry,
    /// The optimum under the speed limits alone, where it is told too.
    pub(crate) speed_only: Option<&'a OptimumEntry>,
    /// What disturbed the runs, if anything.
    pub(crate) disturbances: &'a Disturbances,
    pub(crate) tolerance: f64,
}

/// The judged method in words.
pub(crate) fn subject(method: Method) -> String {
    match method {
        Method::AccelerationLookAhead => "look-ahead".into(),
        Method::SlidingMode => "sliding mode".into(),
        Method::SlidingModeSynchronised => "synchronised sliding mode".into(),
        Method::SlidingModeImplicit => "implicit sliding mode".into(),
        other => format!("method `{other}`"),
    }
}
