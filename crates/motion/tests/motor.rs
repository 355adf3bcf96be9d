//! The motor between command and arm.

use proptest::prelude::*;
use slideway_motion::motor::{
    Delay, DelayLine, Encoder, LONGEST_DELAY, Motor, MotorCommand, MotorSettings, MotorState,
};

fn settings() -> MotorSettings {
    MotorSettings {
        torque_per_current: 10.0,
        largest_current: 8.0,
        continuous_current: 3.0,
        thermal_time: 0.5,
        current_bandwidth: 2000.0,
        speed_gain: 20.0,
        speed_integral_time: 0.05,
        delay: 0,
        sampling_period: 1e-3,
    }
}

fn motor(settings: MotorSettings) -> Motor {
    Motor::new(settings).expect("sound settings")
}

fn command() -> impl Strategy<Value = MotorCommand> {
    let value = prop_oneof![-200.0..200.0_f64, Just(1e300), Just(f64::NAN), Just(f64::INFINITY)];
    prop_oneof![value.clone().prop_map(MotorCommand::Torque), value.prop_map(MotorCommand::Speed)]
}

proptest! {
    #[test]
    fn no_command_overheats_the_winding_or_exceeds_the_amplifier(
        commands in prop::collection::vec((command(), 1..400_u32, -3.0..3.0_f64), 1..12), delay in 0..=LONGEST_DELAY
    ) {
        let motor = motor(MotorSettings { delay, ..settings() });
        let mut state = MotorState::cold();
        for (command, samples, speed) in commands {
            for _ in 0..samples {
                let output = motor.step(&mut state, command, speed);
                prop_assert!((0.0..=1.0).contains(&state.heat()), "{state:?}");
                prop_assert!(state.current().abs() <= 8.0 && output.torque.abs() <= motor.largest_torque());
            }
        }
    }

    #[test]
    fn a_delay_gives_back_what_went_in(samples in 0..=LONGEST_DELAY, values in prop::collection::vec(any::<i32>(), 40)) {
        let delay = Delay::new(samples).expect("short");
        let mut line = DelayLine::filled(0);
        for (k, &value) in values.iter().enumerate() {
            let expected = k.checked_sub(samples).map_or(0, |k| values[k]);
            prop_assert_eq!(delay.step(&mut line, value), expected);
        }
    }

    #[test]
    fn an_encoder_is_at_most_half_a_count_off(q in -10.0..10.0_f64, counts in 100.0..1e6_f64, gear in 1.0..200.0_f64) {
        let encoder = Encoder::on_motor(counts, -gear).expect("not zero");
        prop_assert!((encoder.read(q) - q).abs() <= 0.5 * encoder.resolution() + 1e-14);
    }
}

#[test]
fn a_lasting_overload_settles_at_the_continuous_current() {
    let motor = motor(settings());
    let mut state = MotorState::cold();
    let peak = (0..10).map(|_| motor.step(&mut state, MotorCommand::Torque(1e3), 0.0).torque).fold(0.0, f64::max);
    let last = (0..5000).map(|_| motor.step(&mut state, MotorCommand::Torque(1e3), 0.0)).last().expect("some");
    // The heat nears 1 from below within rounding, and the current the square root of that.
    assert!(peak == 80.0 && last.cut && (last.torque - 30.0).abs() < 1e-6 && state.heat() > 1.0 - 1e-9, "{last:?}");
}

#[test]
fn the_speed_loop_reaches_its_speed_under_a_constant_load() {
    let motor = motor(settings());
    let (mut state, mut speed) = (MotorState::cold(), 0.0);
    for _ in 0..3000 {
        let torque = motor.step(&mut state, MotorCommand::Speed(2.0), speed).torque;
        speed += 1e-3 * (torque - 15.0) / 0.5;
    }
    // Poles of 0.5 s² + 20 s + 400: -20 ± 20i, so that 3 s leave e^-60.
    assert!((speed - 2.0).abs() < 1e-9, "{speed}");
}

#[test]
fn a_motor_without_sound_settings_is_refused() {
    let bad = [
        MotorSettings { torque_per_current: 0.0, ..settings() },
        MotorSettings { thermal_time: 0.0, ..settings() },
        MotorSettings { current_bandwidth: f64::NAN, ..settings() },
        MotorSettings { delay: LONGEST_DELAY + 1, ..settings() },
    ];
    assert!(bad.into_iter().all(|settings| Motor::new(settings).is_err()));
}
