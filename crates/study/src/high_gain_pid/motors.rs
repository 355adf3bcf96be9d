use crate::bench::{LARGEST, PERIOD};
use slideway_motion::MotionError;
use slideway_motion::motor::{Encoder, Motor, MotorCommand, MotorSettings, MotorState};
use slideway_motion::plant::{Measurement, PlantState};
use slideway_robot::JointVector;

/// Resolution of the encoders at the joints, rad: some tens of thousands of counts a turn.
const RESOLUTION: f64 = 1e-4;
/// Bandwidth of the filter of the speed that is made of counts, rad/s.
const SPEED_FILTER: f64 = 500.0;

/// Six motors with encoders; speeds are filtered differences of counts.
pub(super) struct Motors {
    motors: [Motor; 6],
    states: [MotorState; 6],
    encoder: Encoder,
    last: Option<Measurement<6>>,
}

impl Motors {
    pub(super) fn new() -> Result<Self, MotionError> {
        let motor = |largest: f64| {
            Motor::new(MotorSettings {
                torque_per_current: 10.0,
                largest_current: largest / 10.0,
                continuous_current: 0.7 * largest / 10.0,
                thermal_time: 30.0,
                current_bandwidth: 3000.0,
                speed_gain: 0.0,
                speed_integral_time: 1.0,
                delay: 1,
                sampling_period: PERIOD,
            })
        };
        let mut motors = [motor(1.0)?; 6];
        for (slot, largest) in motors.iter_mut().zip(LARGEST) {
            *slot = motor(largest)?;
        }
        Ok(Self { motors, states: [MotorState::cold(); 6], encoder: Encoder::new(RESOLUTION)?, last: None })
    }

    pub(super) fn measure(&mut self, state: &PlantState<6>) -> Measurement<6> {
        let q = state.q.map(|q| self.encoder.read(q));
        let share = 1.0 / (1.0 + SPEED_FILTER * PERIOD);
        let qd = match &self.last {
            // Implicit Euler of a first-order filter.
            Some(last) => (last.qd + (q - last.q) * SPEED_FILTER) * share,
            None => JointVector::zeros(),
        };
        let seen = Measurement { q, qd };
        self.last = Some(seen);
        seen
    }

    pub(super) fn torque(&mut self, wanted: &JointVector<6>, qd: &JointVector<6>) -> JointVector<6> {
        let mut torque = JointVector::zeros();
        for (i, (motor, state)) in self.motors.iter().zip(&mut self.states).enumerate() {
            torque[i] = motor.step(state, MotorCommand::Torque(wanted[i]), qd[i]).torque;
        }
        torque
    }
}
