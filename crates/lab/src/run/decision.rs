use slideway_conditioner::{SpeedCommand, SpeedLimits};

/// The situation of a law at one sample.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Situation<const N: usize> {
    /// Path parameter.
    pub(crate) lambda: f64,
    /// Joint-speed limits here.
    pub(crate) limits: SpeedLimits<N>,
    /// Path rate that the tool's speed limit allows here, 1/s; infinite without one.
    pub(crate) tool_rate: f64,
    /// Path rate that just reaches the path's end with this sample.
    pub(crate) to_end: f64,
}

/// The decision of a law for one sample.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Decision<const N: usize> {
    /// The conditioner's command.
    pub(crate) command: SpeedCommand<N>,
    /// Desired joint speed `q̇d`.
    pub(crate) desired: [f64; N],
    /// The factor `g` with `q̇d = A + g B`, of a law that bounds chattering: `f`, less where something but the law cut the path rate.
    pub(crate) demand_factor: f64,
    /// Path rate with which `λ` is advanced: the command's, less where the path's end is nearer than a whole sample.
    pub(crate) advance_rate: f64,
}
