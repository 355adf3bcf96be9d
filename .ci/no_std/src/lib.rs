//! Every `step` of the conditioner, exported so that the linker keeps it.
//!
//! Linked with `-nostdlib`. The panic handler calls a function that does not exist: if any panic survives optimisation,
//! the library has an undefined symbol and the gate fails.

#![no_std]

use slideway_conditioner::{
    Advance, AffineSpeed, ImplicitSpeedRegulator, Saturation, SpeedLimits, SpeedRegulator, SpeedSettings, SpeedState,
};

unsafe extern "C" {
    fn a_panic_is_reachable() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    unsafe { a_panic_is_reachable() }
}

/// Builds a regulator from raw numbers; null-free by construction, `None` where a parameter is refused.
fn settings(numbers: &[f64; 4], advance: Advance) -> Option<SpeedSettings<6>> {
    Some(SpeedSettings {
        limits: SpeedLimits::symmetric([numbers[0]; 6]).ok()?,
        sampling_period: numbers[1],
        bandwidth: numbers[2],
        target_rate: numbers[3],
        saturation: Saturation::DirectionPreserving,
        advance,
    })
}

#[unsafe(no_mangle)]
pub extern "C" fn explicit_step(numbers: &[f64; 4], desired: &[f64; 6], factor: f64, out: &mut [f64; 6]) -> f64 {
    let Some(settings) = settings(numbers, Advance::Synchronised) else { return f64::NAN };
    let (Ok(regulator), Ok(mut state)) = (SpeedRegulator::new(settings), SpeedState::moving(factor)) else {
        return f64::NAN;
    };
    let command = regulator.step(&mut state, desired);
    *out = command.joint_speed;
    command.path_rate
}

#[unsafe(no_mangle)]
pub extern "C" fn implicit_step(
    numbers: &[f64; 4],
    feedback: &[f64; 6],
    feedforward: &[f64; 6],
    factor: f64,
    out: &mut [f64; 6],
) -> f64 {
    let Some(settings) = settings(numbers, Advance::Paper) else { return f64::NAN };
    let (Ok(regulator), Ok(mut state)) = (ImplicitSpeedRegulator::new(settings), SpeedState::moving(factor)) else {
        return f64::NAN;
    };
    let command = regulator.step(&mut state, &AffineSpeed { feedback: *feedback, feedforward: *feedforward });
    *out = command.joint_speed;
    command.path_rate
}

#[unsafe(no_mangle)]
pub extern "C" fn band(filter_step: f64, overspeed: f64, drift: f64) -> f64 {
    slideway_conditioner::bounds::drifting_band(filter_step, overspeed, drift).unwrap_or(f64::INFINITY)
}
