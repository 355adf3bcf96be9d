//! Every `step` of the conditioner, exported so that the linker keeps it.
//!
//! Linked with `-nostdlib`. The panic handler calls a function that does not exist: if any panic survives optimisation,
//! the library has an undefined symbol and the gate fails.

#![no_std]

use slideway_conditioner::acceleration::{
    AccelerationLimits, AccelerationRegulator, AccelerationSettings, AccelerationState, LookAhead, LookAheadSettings,
    Preview, Recovery,
};
use slideway_conditioner::bounds::{Progress, SignalBand, TravelInputs, implicit_chattering, travel_bracket};
use slideway_conditioner::path::{
    Constraint, Margin, Motion, PathForm, PathSettings, PathState, PathStep, Reserve, SwitchingLaw, TrapSettings, Walk,
};
use slideway_conditioner::shapes::{Ball, HalfSpace, Side};
use slideway_conditioner::{
    Advance, AffineSpeed, ImplicitSpeedRegulator, PathConditioner, Saturation, SpeedLimits, SpeedRegulator,
    SpeedSettings, SpeedState,
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

/// A sample under acceleration limits, its ceiling from a window of the nodes' path speeds.
#[unsafe(no_mangle)]
pub extern "Rust" fn acceleration_step(
    numbers: &[f64; 8],
    desired: &AffineSpeed<6>,
    nodes: &[[f64; 6]],
    state: &mut AccelerationState<6>,
) -> f64 {
    let [speed, acceleration, sampling_period, bandwidth, target_rate, gain, offset, spacing] = *numbers;
    let (Ok(speed_limits), Ok(acceleration_limits)) =
        (SpeedLimits::symmetric([speed; 6]), AccelerationLimits::symmetric([acceleration; 6]))
    else {
        return f64::NAN;
    };
    let recovery = Recovery::Braking { gain };
    let regulator = AccelerationRegulator::new(AccelerationSettings {
        speed_limits,
        acceleration_limits,
        sampling_period,
        bandwidth,
        target_rate,
        recovery,
    });
    let settings = LookAheadSettings { speed_limits, acceleration_limits, sampling_period, target_rate, margin: 0.05 };
    let (Ok(regulator), Ok(look_ahead)) = (regulator, LookAhead::new(settings)) else { return f64::NAN };
    let preview = Preview { offset, spacing, path_speeds: nodes };
    let mut ranges = [0.0; 64];
    look_ahead.ranges(spacing, nodes, &mut ranges);
    let ceiling = look_ahead.greatest_rate(&preview).min(look_ahead.greatest_rate_within(&preview, &ranges));
    regulator.step_below(state, desired, ceiling).path_rate
}

#[unsafe(no_mangle)]
pub extern "C" fn band(filter_step: f64, overspeed: f64, drift: f64) -> f64 {
    slideway_conditioner::bounds::drifting_band(filter_step, overspeed, drift).unwrap_or(f64::INFINITY)
}

/// A sample of the collectors that can run beside the regulator.
#[unsafe(no_mangle)]
pub extern "Rust" fn signal_step(
    limits: &SpeedLimits<6>,
    demand: &AffineSpeed<6>,
    numbers: &[f64; 3],
    band: &mut SignalBand<6>,
    progress: &mut Progress,
) -> f64 {
    let [factor, switch, on_path] = *numbers;
    band.update(limits, demand, factor, switch);
    progress.update(limits, demand, factor, on_path);
    let sums = progress.sums();
    let inputs = TravelInputs { sums, optimum: [1.0; 2], period: factor, variation: switch, sample_drift: on_path };
    let lower = travel_bracket(&inputs).map_or(f64::NAN, |[lower, upper]| lower + upper);
    band.band() + implicit_chattering(&band.signals(), factor, switch) + lower
}

/// What a path step is called with: a conditioner made from raw numbers is made elsewhere, once.
pub struct Task<const M: usize> {
    conditioner: PathConditioner<3, M>,
    wall: HalfSpace<3>,
    ball: Ball<3>,
}

fn path_task<const M: usize>(numbers: &[f64; 4], form: PathForm, trap: Option<TrapSettings>) -> Option<Task<M>> {
    let settings = PathSettings {
        sampling_period: numbers[0],
        push_cutoff: numbers[1],
        approach: [numbers[2]; M],
        margin: Margin::Band,
        form,
        trap,
    };
    Some(Task {
        conditioner: PathConditioner::new(settings).ok()?,
        wall: HalfSpace::new(&[0.0, 1.0, 0.0], numbers[3]).ok()?,
        ball: Ball::new([0.0; 3], numbers[3], Side::Outside).ok()?,
    })
}

fn law(numbers: &[f64; 4]) -> SwitchingLaw {
    SwitchingLaw::Normalised { amplitude: numbers[3] }
}

fn safe_trap(numbers: &[f64; 4]) -> TrapSettings {
    TrapSettings {
        walk_cutoff: numbers[1],
        pace_cutoff: numbers[1],
        walk: Walk::Safe { push_share: 0.5 },
        walk_speed: numbers[3],
        walk_growth: numbers[3],
        return_gain: 5.0,
        direction_period: 0.1,
        distance_threshold: 0.05,
        clearance_threshold: 0.05,
        activity_threshold: 0.01,
        seed: 1,
    }
}

/// One step with one constraint; false where a parameter is refused.
fn one(task: Option<Task<1>>, state: &mut PathState<3, 1>, at: &Motion<3>, out: &mut PathStep<3, 1>) -> bool {
    let Some(task) = task else { return false };
    *out = task.conditioner.step(state, at, |m| [task.ball.sample(m)]);
    true
}

/// One step with two constraints.
fn two(task: Option<Task<2>>, state: &mut PathState<3, 2>, at: &Motion<3>, out: &mut PathStep<3, 2>) -> bool {
    let Some(task) = task else { return false };
    *out = task.conditioner.step(state, at, |m| [task.wall.sample(m), task.ball.sample(m)]);
    true
}

#[unsafe(no_mangle)]
pub extern "Rust" fn path_explicit_one(
    numbers: &[f64; 4],
    state: &mut PathState<3, 1>,
    at: &Motion<3>,
    out: &mut PathStep<3, 1>,
) -> bool {
    let form = PathForm::Sliding { law: law(numbers), reserve: Reserve::Off };
    one(path_task(numbers, form, None), state, at, out)
}

#[unsafe(no_mangle)]
pub extern "Rust" fn path_appendix_one(
    numbers: &[f64; 4],
    state: &mut PathState<3, 1>,
    at: &Motion<3>,
    out: &mut PathStep<3, 1>,
) -> bool {
    let form = PathForm::Appendix { law: law(numbers) };
    one(path_task(numbers, form, None), state, at, out)
}

#[unsafe(no_mangle)]
pub extern "Rust" fn path_implicit_one(
    numbers: &[f64; 4],
    state: &mut PathState<3, 1>,
    at: &Motion<3>,
    out: &mut PathStep<3, 1>,
) -> bool {
    let form = PathForm::Implicit { recovery_rate: numbers[3] };
    one(path_task(numbers, form, None), state, at, out)
}

#[unsafe(no_mangle)]
pub extern "Rust" fn path_safe_walk_one(
    numbers: &[f64; 4],
    state: &mut PathState<3, 1>,
    at: &Motion<3>,
    out: &mut PathStep<3, 1>,
) -> bool {
    let form = PathForm::Sliding { law: law(numbers), reserve: Reserve::On { recovery_rate: numbers[3] } };
    one(path_task(numbers, form, Some(safe_trap(numbers))), state, at, out)
}

#[unsafe(no_mangle)]
pub extern "Rust" fn path_explicit_two(
    numbers: &[f64; 4],
    state: &mut PathState<3, 2>,
    at: &Motion<3>,
    out: &mut PathStep<3, 2>,
) -> bool {
    let form = PathForm::Sliding { law: law(numbers), reserve: Reserve::Off };
    two(path_task(numbers, form, None), state, at, out)
}

#[unsafe(no_mangle)]
pub extern "Rust" fn path_appendix_two(
    numbers: &[f64; 4],
    state: &mut PathState<3, 2>,
    at: &Motion<3>,
    out: &mut PathStep<3, 2>,
) -> bool {
    let form = PathForm::Appendix { law: law(numbers) };
    two(path_task(numbers, form, None), state, at, out)
}

#[unsafe(no_mangle)]
pub extern "Rust" fn path_implicit_two(
    numbers: &[f64; 4],
    state: &mut PathState<3, 2>,
    at: &Motion<3>,
    out: &mut PathStep<3, 2>,
) -> bool {
    let form = PathForm::Implicit { recovery_rate: numbers[3] };
    two(path_task(numbers, form, None), state, at, out)
}

#[unsafe(no_mangle)]
pub extern "Rust" fn path_safe_walk_two(
    numbers: &[f64; 4],
    state: &mut PathState<3, 2>,
    at: &Motion<3>,
    out: &mut PathStep<3, 2>,
) -> bool {
    let form = PathForm::Sliding { law: law(numbers), reserve: Reserve::On { recovery_rate: numbers[3] } };
    two(path_task(numbers, form, Some(safe_trap(numbers))), state, at, out)
}
