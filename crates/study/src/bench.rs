//! A simulated arm under a sampled controller: what the studies of feedback have in common.

use crate::StudyError;
use slideway_motion::control::{Derivative, Pid, PidSettings};
use slideway_motion::plant::{Actuation, Measurement, Plant, PlantSettings, PlantState, Sensors};
use slideway_motion::{JointState, MotionError};
use slideway_robot::{DriveEffects, Dynamics, JointVector, NumericIk, NumericIkSettings, Pose, Task, models};

/// Sampling period of the controllers, s.
pub(crate) const PERIOD: f64 = 1e-3;

/// Elbow bent, wrist away from its singularity, room to move in all directions.
pub(crate) const READY: [f64; 6] = [0.2, 0.6, -3.0, 0.3, -1.0, 0.4];

/// Largest torques of the PUMA-560's joints, N·m: what its motors give at the joint, rounded (Armstrong, Khatib and Burdick 1986).
pub(crate) const LARGEST: [f64; 6] = [97.0, 186.0, 89.0, 24.0, 20.0, 21.0];

/// The PUMA-560 with its rotors, twice: as the controllers know it, without friction, and as it is, with friction.
pub(crate) struct Puma {
    /// Model that the controllers compute with: no friction.
    pub(crate) model: Dynamics<6>,
    /// Arm that is simulated: with friction.
    pub(crate) real: Dynamics<6>,
}

pub(crate) fn puma() -> Result<Puma, MotionError> {
    let arm = models::puma560_dynamics()?;
    let with = |friction| arm.clone().with_effects(DriveEffects { rotor_inertia: true, friction });
    Ok(Puma { model: with(false), real: with(true) })
}

pub(crate) fn plant<const N: usize>(dynamics: &Dynamics<N>) -> Result<Plant<N>, MotionError> {
    // Speeds to a hundredth of a micrometre per second are enough for pictures.
    let settings = PlantSettings { tolerance: 1e-8, friction_speed: 1e-2, ..PlantSettings::default() };
    Plant::new(dynamics.clone(), settings)
}

/// Runs a sampled controller for some time, through sensors, and shows each state after its sample.
pub(crate) fn run<const N: usize>(
    plant: &Plant<N>,
    sensors: &mut Sensors,
    state: &mut PlantState<N>,
    seconds: f64,
    mut control: impl FnMut(&PlantState<N>, &Measurement<N>) -> Result<Actuation<N>, MotionError>,
    mut seen: impl FnMut(&PlantState<N>),
) -> Result<(), StudyError> {
    for _ in 0..(seconds / PERIOD).round() as u32 {
        let actuation = control(state, &sensors.joints(&state.q, &state.qd))?;
        plant.advance(state, PERIOD, &mut |_| actuation)?;
        seen(state);
    }
    Ok(())
}

/// One PID of the studies: speeds are measured.
pub(crate) fn pid(proportional: f64, integral: f64, derivative: f64, largest: f64) -> Result<Pid, MotionError> {
    let derivative_from = Derivative::Measured;
    Pid::new(PidSettings { proportional, integral, derivative, derivative_from, largest, sampling_period: PERIOD })
}

/// Joints that put the PUMA's tool at a pose, from [`READY`].
pub(crate) fn joints_at(model: &Dynamics<6>, pose: &Pose) -> Result<JointState<6>, MotionError> {
    let ik = NumericIk::new(model.arm(), Task::Pose, NumericIkSettings::default());
    Ok(JointState::at_rest(ik.solve(pose, &JointVector::from(READY))?))
}
