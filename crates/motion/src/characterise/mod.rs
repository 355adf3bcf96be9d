//! Experiments on a controller: gain over frequency, bandwidth, tracking error, reach of the torques.

mod bandwidth;
mod frequency;
mod reach;
mod tracking;

pub use bandwidth::{BandwidthSearch, bandwidth};
pub use frequency::{FrequencyResponse, SineTest};
pub use reach::acceleration_reach;
pub use tracking::TrackingError;
