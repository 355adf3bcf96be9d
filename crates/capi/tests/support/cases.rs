//! Recordings of the speed laws and of the acceleration-limited regulator.

use slideway_conditioner::acceleration::{
    AccelerationRegulator, AccelerationSettings, AccelerationState, LookAhead, LookAheadSettings, PathKeeping, Preview,
    Recovery,
};
use slideway_conditioner::{
    AccelerationLimits, Advance, AffineSpeed, ImplicitSpeedRegulator, Saturation, SpeedCommand, SpeedLimits,
    SpeedRegulator, SpeedSettings, SpeedState,
};

use super::{Numbers, Recording};

/// Something for a bad number to do: every 97th input is none.
fn spoil<const N: usize>(k: u32, numbers: &mut [f64; N]) {
    if k % 97 == 96 {
        numbers[(k as usize / 97) % N] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY][k as usize % 3];
    }
}

fn print_speed<const N: usize>(recording: &mut Recording, rate: f64, command: &SpeedCommand<N>) {
    recording.print(&[rate]);
    recording.print(&command.joint_speed);
    let SpeedCommand { path_rate, factor, switch, direction_factor, limit_ratio, .. } = *command;
    recording.print(&[path_rate, factor, switch, direction_factor, limit_ratio]);
    recording.end_line(&[]);
}

pub(crate) fn speed<const N: usize>(recording: &mut Recording, law: u32, saturation: u32, steps: u32) {
    let mut numbers = Numbers(u64::from(law) * 100 + N as u64);
    let lower: [f64; N] = std::array::from_fn(|i| -0.4 - 0.05 * i as f64);
    let upper: [f64; N] = std::array::from_fn(|i| 0.5 + 0.03 * i as f64);
    let settings = SpeedSettings {
        limits: SpeedLimits::new(lower, upper).expect("limits"),
        sampling_period: 1e-3,
        bandwidth: 25.0,
        target_rate: 5.0,
        saturation: [Saturation::Direct, Saturation::DirectionPreserving][saturation as usize],
        advance: [Advance::Paper, Advance::Synchronised][law as usize % 2],
    };
    recording.begin("speed", &[N as u32, law, saturation, steps]);
    recording.read(&lower);
    recording.read(&upper);
    recording.read(&[1e-3, 25.0, 5.0]);
    let mut state = SpeedState::at_rest();
    let (explicit, implicit) = (SpeedRegulator::new(settings), ImplicitSpeedRegulator::new(settings));
    let (explicit, implicit) = (explicit.expect("settings"), implicit.expect("settings"));
    for k in 0..steps {
        let (mut first, second) = (numbers.vector(0.7), numbers.vector(1.5));
        spoil(k, &mut first);
        recording.read(&first);
        recording.read(&second);
        let rate = if law == 2 { implicit.target_rate() } else { explicit.requested_rate(&state) };
        let command = if law == 2 {
            implicit.step(&mut state, &AffineSpeed { feedback: first, feedforward: second })
        } else {
            explicit.step(&mut state, &first)
        };
        print_speed(recording, rate, &command);
    }
}

pub(crate) fn acceleration<const N: usize>(recording: &mut Recording, braking: bool, steps: u32) {
    const NODES: usize = 40;
    let (period, bandwidth, target_rate, gain, margin, spacing) = (1e-3, 20.0, 5.0, 8.0, 0.05, 0.02);
    let mut numbers = Numbers(1000 + N as u64 + u64::from(braking));
    let [low, high]: [[f64; N]; 2] = [-0.5, 0.6].map(|x| [x; N]);
    let [brake, push]: [[f64; N]; 2] = [-3.0, 2.0].map(|x| [x; N]);
    let nodes: Vec<[f64; N]> =
        (0..NODES).map(|k| std::array::from_fn(|i| libm::sin(0.3 * k as f64 + 0.7 * i as f64))).collect();
    recording.begin("acceleration", &[N as u32, u32::from(braking), steps, NODES as u32]);
    for limits in [low, high, brake, push] {
        recording.read(&limits);
    }
    recording.read(&[period, bandwidth, target_rate, gain, margin, spacing]);
    nodes.iter().for_each(|node| recording.read(node));
    let speed_limits = SpeedLimits::new(low, high).expect("limits");
    let acceleration_limits = AccelerationLimits::new(brake, push).expect("limits");
    let regulator = AccelerationRegulator::new(AccelerationSettings {
        speed_limits,
        acceleration_limits,
        sampling_period: period,
        bandwidth,
        target_rate,
        recovery: if braking { Recovery::Braking { gain } } else { Recovery::AsDemanded },
    })
    .expect("settings");
    let look_ahead = LookAhead::new(LookAheadSettings {
        speed_limits,
        acceleration_limits,
        sampling_period: period,
        target_rate,
        margin,
    })
    .expect("settings");
    let mut ranges = [0.0; NODES];
    look_ahead.ranges(spacing, &nodes, &mut ranges);
    recording.print(&ranges);
    recording.end_line(&[]);
    let mut state = AccelerationState::at_rest();
    for k in 0..steps {
        let preview = Preview { offset: 0.7 * f64::from(k) / f64::from(steps), spacing, path_speeds: &nodes };
        let (mut feedback, feedforward) = (numbers.vector::<N>(0.05), numbers.vector::<N>(1.0));
        spoil(k, &mut feedback);
        recording.read(&[preview.offset]);
        recording.read(&feedback);
        recording.read(&feedforward);
        let rate = look_ahead.greatest_rate(&preview);
        recording.print(&[rate, look_ahead.greatest_rate_within(&preview, &ranges)]);
        let command = regulator.step_below(&mut state, &AffineSpeed { feedback, feedforward }, rate);
        recording.print(&command.joint_speed);
        recording.print(&command.desired);
        let (keeping, excess) = match command.keeping {
            PathKeeping::OnPath => (0, 0.0),
            PathKeeping::LeavesPath { excess } => (1, excess),
            PathKeeping::Brakes => (2, 0.0),
        };
        recording.print(&[command.path_rate, command.factor, command.switch, excess]);
        recording.end_line(&[keeping]);
    }
}
