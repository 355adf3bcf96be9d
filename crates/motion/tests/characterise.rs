//! Experiments whose outcome is known in closed form.

mod support;

use proptest::prelude::*;
use slideway_motion::MotionError;
use slideway_motion::characterise::{BandwidthSearch, SineTest, TrackingError, acceleration_reach, bandwidth};
use slideway_motion::motor::{Motor, MotorCommand, MotorSettings, MotorState};
use slideway_robot::{JointVector, Task, Twist};
use support::{arm, vector};

const PERIOD: f64 = 1e-4;

fn motor(current_bandwidth: f64) -> Motor {
    Motor::new(MotorSettings {
        torque_per_current: 2.0,
        largest_current: 1e3,
        continuous_current: 1e3,
        thermal_time: 10.0,
        current_bandwidth,
        speed_gain: 1.0,
        speed_integral_time: 1.0,
        delay: 0,
        sampling_period: PERIOD,
    })
    .expect("sound settings")
}

fn sine() -> SineTest {
    SineTest { amplitude: 1.0, settling_periods: 8, measured_periods: 2, sampling_period: PERIOD }
}

/// A current loop as a system for the experiment.
fn current_loop(motor: Motor) -> impl FnMut(f64) -> Result<f64, MotionError> {
    let mut state = MotorState::cold();
    move |wanted| Ok(motor.step(&mut state, MotorCommand::Torque(wanted), 0.0).torque)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    /// The loop is `β / (1 - p z⁻¹)`, `p = e^(-ω T)`, `β = 1 - p`: half the power at `cos(ω T) = (1 + p² - 2 β²) / (2 p)`.
    #[test]
    fn the_current_loop_has_the_bandwidth_of_its_filter(nominal in 100.0..1500.0_f64) {
        let search = BandwidthSearch { lowest: 20.0, highest: 5000.0, accuracy: 1e-3 };
        let found = bandwidth(&sine(), &search, || current_loop(motor(nominal))).expect("in range");
        let p = (-nominal * PERIOD).exp();
        let exact = ((1.0 + p * p - 2.0 * (1.0 - p).powi(2)) / (2.0 * p)).acos() / PERIOD;
        // Within a bracket of relative width w the power, near 1 / (1 + x²), is off its chord by at most w²/4. The bracket is 1e-3
        // wide, or one sample of a period: ω T / 2 π <= 0.024. 1.5e-4 and a residual transient of e^(-8 · 2 π).
        prop_assert!((found / exact - 1.0).abs() < 2e-4, "{found} {exact}");
    }

    #[test]
    fn at_its_reach_a_torque_is_at_its_limit(
        dynamics in arm(), q in vector::<3>(2.0), qd in vector::<3>(0.5), u in prop::array::uniform3(-1.0..1.0_f64)
    ) {
        let direction = Twist::new(u[0], u[1], u[2], 0.0, 0.0, 0.0);
        let largest = JointVector::from([80.0, 60.0, 40.0]);
        let jacobian = dynamics.arm().jacobian(&q).fixed_rows::<3>(0).into_owned();
        prop_assume!(direction.norm() > 0.1 && jacobian.determinant().abs() > 1e-2);
        let inverse = jacobian.try_inverse().expect("regular");
        let bias = dynamics.arm().bias_acceleration(&q, &qd);
        let largest_use = |s: f64| {
            let qdd = inverse * (direction * s - bias).fixed_rows::<3>(0);
            dynamics.inverse(&q, &qd, &qdd).component_div(&largest).amax()
        };
        match acceleration_reach(&dynamics, Task::Position, [&q, &qd], &direction, &largest) {
            // A determinant of 0.01 at lengths of 1 m leaves singular values above 0.003: the damping of 1e-6 adds 1e-7.
            Some(reach) => prop_assert!((largest_use(reach) - 1.0).abs() < 1e-5, "{}", largest_use(reach)),
            None => prop_assert!(largest_use(0.0) > 1.0 - 1e-5),
        }
    }
}

#[test]
fn a_system_that_follows_everywhere_has_no_bandwidth_in_range() {
    let search = BandwidthSearch { lowest: 20.0, highest: 500.0, accuracy: 1e-2 };
    let found = bandwidth(&sine(), &search, || Ok);
    assert_eq!(found, Err(MotionError::NoBandwidth { highest: 500.0 }));
}

#[test]
fn the_answer_of_a_delay_is_late_by_its_samples() {
    let mut before = [0.0; 2];
    let mut late = |x: f64| {
        let out = before[1];
        before = [x, before[0]];
        Ok(out)
    };
    let answer = sine().run(100.0, &mut late).expect("in range");
    assert!((answer.gain - 1.0).abs() < 1e-12 && (answer.phase + answer.frequency * 2.0 * PERIOD).abs() < 1e-12);
}

#[test]
fn a_tracking_error_keeps_its_peak_and_its_mean_square() {
    let mut error = TrackingError::default();
    [3.0, -4.0].into_iter().for_each(|e| error.add(e));
    assert!(error.peak() == 4.0 && (error.rms() - 12.5_f64.sqrt()).abs() < 1e-15);
    error.add(f64::NAN);
    error.add(1.0);
    assert!(error.peak().is_nan() && error.rms().is_nan());
}
