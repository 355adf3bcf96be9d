use slideway_conditioner::SpeedCommand as CoreSpeed;
use slideway_conditioner::acceleration::{AccelerationCommand as CoreAcceleration, PathKeeping};

use crate::MAX_JOINTS;
use crate::choices::Keeping;
use crate::memory::{Output, sized};

/// Output of one sample of a speed regulator. Of an array the first `joints` elements are written.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct SpeedCommand {
    /// Size of this structure as the caller knows it: `sizeof(slideway_speed_command)`.
    pub size: u32,
    /// Number of joints that were written; 0 after a call that failed.
    pub joints: u32,
    /// Joint speed to command, rad/s, inside the limits to the last bit.
    pub joint_speed: [f64; MAX_JOINTS],
    /// Rate of the path parameter over this sample, 1/s: advance the path parameter by `sampling period * path_rate`.
    pub path_rate: f64,
    /// The factor of this sample, in [0, 1].
    pub factor: f64,
    /// Input of the filter: 0 or 1 in the explicit laws; at most 1, and possibly negative, in the implicit one.
    pub switch_input: f64,
    /// By how much all joints were slowed to keep their limits, in [0, 1].
    pub direction_factor: f64,
    /// Largest use of a limit by the desired joint speed; above 1 it exceeds one.
    pub limit_ratio: f64,
}

sized!(SpeedCommand);

/// The first `N` elements become those of a vector.
pub(crate) fn put<const N: usize>(slots: &mut [f64], values: &[f64; N]) {
    for (slot, value) in slots.iter_mut().zip(values) {
        *slot = *value;
    }
}

impl SpeedCommand {
    pub(crate) fn fill<const N: usize>(&mut self, command: &CoreSpeed<N>) {
        self.joints = N as u32;
        put(&mut self.joint_speed, &command.joint_speed);
        self.path_rate = command.path_rate;
        self.factor = command.factor;
        self.switch_input = command.switch;
        self.direction_factor = command.direction_factor;
        self.limit_ratio = command.limit_ratio;
    }
}

impl Output for SpeedCommand {
    /// Robot and reference stand still.
    #[cold]
    fn stand(&mut self) {
        let Self { size, .. } = *self;
        *self = Self {
            size,
            joints: 0,
            joint_speed: [0.0; MAX_JOINTS],
            path_rate: 0.0,
            factor: 0.0,
            switch_input: 0.0,
            direction_factor: 0.0,
            limit_ratio: 0.0,
        };
    }
}

/// Output of one sample of an acceleration-limited regulator. Of an array the first `joints` elements are written.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct AccelerationCommand {
    /// Size of this structure as the caller knows it: `sizeof(slideway_acceleration_command)`.
    pub size: u32,
    /// Number of joints that were written; 0 after a call that failed.
    pub joints: u32,
    /// Joint speed to command, rad/s: inside the speed limits and reachable from the last one.
    pub joint_speed: [f64; MAX_JOINTS],
    /// Demand at this factor, rad/s.
    pub desired: [f64; MAX_JOINTS],
    /// Rate of the path parameter over this sample, 1/s: advance the path parameter by `sampling period * path_rate`.
    pub path_rate: f64,
    /// The factor of this sample, in [0, 1].
    pub factor: f64,
    /// The filter's input that leads to this factor: 1 where nothing limits.
    pub switch_input: f64,
    /// Largest difference of a joint's demand and its command, rad/s, where the path is left; else 0.
    pub excess: f64,
    /// One of `slideway_keeping`.
    pub keeping: u32,
    /// Nothing; 0.
    pub reserved: u32,
}

sized!(AccelerationCommand);

impl AccelerationCommand {
    pub(crate) fn fill<const N: usize>(&mut self, command: &CoreAcceleration<N>) {
        self.joints = N as u32;
        put(&mut self.joint_speed, &command.joint_speed);
        put(&mut self.desired, &command.desired);
        self.path_rate = command.path_rate;
        self.factor = command.factor;
        self.switch_input = command.switch;
        let (keeping, excess) = match command.keeping {
            PathKeeping::OnPath => (Keeping::OnPath, 0.0),
            PathKeeping::LeavesPath { excess } => (Keeping::LeavesPath, excess),
            PathKeeping::Brakes => (Keeping::Brakes, 0.0),
        };
        (self.keeping, self.excess, self.reserved) = (keeping as u32, excess, 0);
    }
}

impl Output for AccelerationCommand {
    /// Robot and reference stand still.
    #[cold]
    fn stand(&mut self) {
        let Self { size, .. } = *self;
        *self = Self {
            size,
            joints: 0,
            joint_speed: [0.0; MAX_JOINTS],
            desired: [0.0; MAX_JOINTS],
            path_rate: 0.0,
            factor: 0.0,
            switch_input: 0.0,
            excess: 0.0,
            keeping: Keeping::Brakes as u32,
            reserved: 0,
        };
    }
}
