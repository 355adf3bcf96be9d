use crate::DriveFault;

/// Rotor inertia and friction that a joint's motor and gear add to the rigid body, seen from the joint.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Drive {
    /// Rotor inertia times the gear ratio squared, `G² Jm`, kg m² (kg for a prismatic joint).
    pub reflected_inertia: f64,
    /// Friction.
    pub friction: Friction,
}

/// Viscous and Coulomb friction of a joint: `viscous q̇ + forward` for `q̇ > 0`, `viscous q̇ - backward` for `q̇ < 0`, zero at rest.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Friction {
    /// Torque per speed, N·m·s/rad (N·s/m).
    pub viscous: f64,
    /// Coulomb torque of forward motion, N·m (N), not negative.
    pub forward: f64,
    /// Coulomb torque of backward motion, N·m (N), not negative.
    pub backward: f64,
}

impl Friction {
    /// Torque that the motor spends on friction at a joint speed. NaN stays NaN.
    #[must_use]
    pub fn torque(&self, speed: f64) -> f64 {
        let coulomb = if speed > 0.0 {
            self.forward
        } else if speed < 0.0 {
            -self.backward
        } else {
            0.0
        };
        self.viscous * speed + coulomb
    }
}

impl Drive {
    /// A motor with a gear: everything on the motor's side is reflected to the joint, inertia and viscous friction with
    /// `G²`, Coulomb friction with `|G|`.
    #[must_use]
    pub fn geared(gear_ratio: f64, rotor_inertia: f64, motor_friction: Friction) -> Self {
        let gear = gear_ratio.abs();
        Self {
            reflected_inertia: gear * gear * rotor_inertia,
            friction: Friction {
                viscous: gear * gear * motor_friction.viscous,
                forward: gear * motor_friction.forward,
                backward: gear * motor_friction.backward,
            },
        }
    }

    /// Checks that no parameter is negative or not finite.
    ///
    /// # Errors
    ///
    /// The first parameter that is.
    pub fn validate(&self) -> Result<(), DriveFault> {
        let Friction { viscous, forward, backward } = self.friction;
        let fields = [
            ("reflected inertia", self.reflected_inertia),
            ("viscous friction", viscous),
            ("forward Coulomb friction", forward),
            ("backward Coulomb friction", backward),
        ];
        match fields.into_iter().find(|(_, value)| !(*value >= 0.0 && value.is_finite())) {
            Some((name, value)) => Err(DriveFault { name, value }),
            None => Ok(()),
        }
    }
}

/// Parts of the drives that count in the dynamics; by default none.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DriveEffects {
    /// Adds the reflected rotor inertia to the diagonal of the mass matrix.
    pub rotor_inertia: bool,
    /// Adds friction to the torque.
    pub friction: bool,
}
