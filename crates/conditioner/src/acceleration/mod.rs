//! Regulation of the speed along a path under limits on joint acceleration as well.
//!
//! ```
//! use slideway_conditioner::acceleration::{
//!     AccelerationLimits, AccelerationRegulator, AccelerationSettings, AccelerationState, PathKeeping, Recovery,
//! };
//! use slideway_conditioner::{AffineSpeed, SpeedLimits};
//!
//! let regulator = AccelerationRegulator::new(AccelerationSettings {
//!     speed_limits: SpeedLimits::symmetric([0.5, 0.5])?,            // rad/s
//!     acceleration_limits: AccelerationLimits::symmetric([2.0; 2])?, // rad/s²
//!     sampling_period: 1e-3,                                        // s
//!     bandwidth: 20.0,                                              // rad/s
//!     target_rate: 5.0,                                             // 1/s
//!     recovery: Recovery::AsDemanded,
//! })?;
//! let mut state = AccelerationState::at_rest();
//! let straight = AffineSpeed { feedback: [0.0; 2], feedforward: [1.0, 1.5] };
//! for _ in 0..300 {
//!     let before = *state.joint_speed();
//!     let command = regulator.step(&mut state, &straight);
//!     assert_eq!(command.keeping, PathKeeping::OnPath);
//!     assert!(command.joint_speed[1] - before[1] <= 2e-3 * (1.0 + 1e-12));
//! }
//! assert!((state.joint_speed()[1] - 0.5).abs() < 1e-12);
//! # Ok::<(), slideway_conditioner::ParameterError>(())
//! ```

mod factor;
mod interval;
mod limits;
mod look_ahead;
mod regulator;

pub use limits::AccelerationLimits;
pub use look_ahead::{LookAhead, LookAheadSettings, Preview};
pub use regulator::{
    AccelerationCommand, AccelerationRegulator, AccelerationSettings, AccelerationState, PathKeeping, Recovery,
};
