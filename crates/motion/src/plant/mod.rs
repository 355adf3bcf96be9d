//! The arm in simulation: forward dynamics, friction, a compliant wall, noisy sensors.
//!
//! ```
//! use slideway_motion::plant::{Actuation, Plant, PlantSettings, PlantState};
//! use slideway_robot::{JointVector, models};
//!
//! let plant = Plant::new(models::puma560_dynamics()?, PlantSettings::default())?;
//! let mut state = PlantState::at_rest([0.0, 0.8, -2.6, 0.0, 0.5, 0.0].into());
//! // Nothing holds the arm: what it loses in height it gains in speed.
//! let before = plant.energy(&state);
//! for _ in 0..50 {
//!     plant.advance(&mut state, 1e-3, &mut |_| Actuation::torque(JointVector::zeros()))?;
//! }
//! assert!((plant.energy(&state) - before).abs() < 1e-6);
//! # Ok::<(), slideway_motion::MotionError>(())
//! ```

mod friction;
mod integrate;
mod sensors;
mod state;
mod wall;

pub use integrate::Resolution;
pub use sensors::{Measurement, Noise, Sensors};
pub use state::{Actuation, PlantState};
pub use wall::Wall;

use crate::MotionError;
use crate::error::{positive, setting};
use friction::smoothed;
use slideway_robot::{DriveEffects, Dynamics, JointVector, Twist};

/// Settings of the simulation of a [`Plant`]: steps, tolerance, smoothing of friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlantSettings {
    /// Fewest steps of a sample.
    pub steps: u32,
    /// Largest number of steps of a sample, refused ones included.
    pub most_steps: u32,
    /// Largest estimated error of a step, in each joint's position (rad, m) and speed (per s).
    pub tolerance: f64,
    /// Speed below which Coulomb friction is proportional to it, per s.
    pub friction_speed: f64,
}

impl Default for PlantSettings {
    /// One step, at most 4096, an error of 1e-9, friction smoothed below 1 mrad/s.
    fn default() -> Self {
        Self { steps: 1, most_steps: 4096, tolerance: 1e-9, friction_speed: 1e-3 }
    }
}

/// An arm that moves as its masses, its friction, a wall and what acts on it make it move.
///
/// ```text
/// M(q) q̈ + c(q, q̇) + g(q) + friction(q̇) = τ + Jᵀ (wall + push)
/// ```
///
/// Rotor inertia and friction take part as far as the effects of the `Dynamics` say. Coulomb friction grows linearly up to
/// `friction_speed`, which stands for sticking: the arm creeps under a load that would not move it.
///
/// Guaranteed: a step is kept only if halving it changes no position and no speed by more than 15 times the tolerance, so that the
/// error of the halves, which are kept, is estimated to be inside it (Richardson, fourth order; where a force jumps within a step
/// the order is one, and the change bounds the error of the halves itself).
#[derive(Clone, Debug, PartialEq)]
pub struct Plant<const N: usize> {
    /// Without friction, which is smoothed here.
    dynamics: Dynamics<N>,
    effects: DriveEffects,
    wall: Option<Wall>,
    settings: PlantSettings,
}

impl<const N: usize> Plant<N> {
    /// An arm in free space.
    ///
    /// # Errors
    ///
    /// [`MotionError::Setting`] with the first setting out of its range.
    pub fn new(dynamics: Dynamics<N>, settings: PlantSettings) -> Result<Self, MotionError> {
        setting("steps", f64::from(settings.steps), settings.steps >= 1)?;
        setting("most_steps", f64::from(settings.most_steps), settings.most_steps >= settings.steps)?;
        positive("tolerance", settings.tolerance)?;
        positive("friction_speed", settings.friction_speed)?;
        let effects = dynamics.effects();
        let dynamics = dynamics.with_effects(DriveEffects { friction: false, ..effects });
        Ok(Self { dynamics, effects, wall: None, settings })
    }

    /// The same arm before a wall.
    #[must_use]
    pub fn with_wall(self, wall: Wall) -> Self {
        Self { wall: Some(wall), ..self }
    }

    /// The arm's masses, without friction.
    #[must_use]
    pub fn dynamics(&self) -> &Dynamics<N> {
        &self.dynamics
    }

    /// The wall, if there is one.
    #[must_use]
    pub fn wall(&self) -> Option<&Wall> {
        self.wall.as_ref()
    }

    /// Torque that friction takes, N·m (N).
    #[must_use]
    pub fn friction(&self, qd: &JointVector<N>) -> JointVector<N> {
        if !self.effects.friction {
            return JointVector::zeros();
        }
        let drives = self.dynamics.drives();
        JointVector::from_fn(|i, _| smoothed(&drives[i].friction, qd[i], self.settings.friction_speed))
    }

    /// Wrench of the wall on the tool: a force through the tool's origin, base frame, N. The moment is zero.
    #[must_use]
    pub fn contact(&self, q: &JointVector<N>, qd: &JointVector<N>) -> Twist {
        let Some(wall) = &self.wall else { return Twist::zeros() };
        let velocity = (self.dynamics.arm().jacobian(q) * qd).fixed_rows::<3>(0).into_owned();
        let force = wall.force(&self.dynamics.arm().forward(q).translation.vector, &velocity);
        Twist::new(force.x, force.y, force.z, 0.0, 0.0, 0.0)
    }

    /// Kinetic energy, potential energy in the field of gravity and in the wall's spring, J.
    #[must_use]
    pub fn energy(&self, state: &PlantState<N>) -> f64 {
        let tip = self.dynamics.arm().forward(&state.q).translation.vector;
        self.dynamics.kinetic_energy(&state.q, &state.qd)
            + self.dynamics.potential_energy(&state.q)
            + self.wall.map_or(0.0, |wall| wall.energy(&tip))
    }

    /// Remainder of `energy - work done + energy lost`, less its value at another instant, J: zero but for the error of
    /// the integration.
    #[must_use]
    pub fn imbalance(&self, from: &PlantState<N>, to: &PlantState<N>) -> f64 {
        self.energy(to) - self.energy(from) - (to.work - from.work) + (to.lost - from.lost)
    }
}
