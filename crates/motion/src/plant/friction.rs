use slideway_robot::Friction;

/// Viscous and Coulomb friction without the jump: `viscous q̇ + coulomb clamp(q̇ / band, -1, 1)`. NaN stays NaN.
pub(super) fn smoothed(friction: &Friction, speed: f64, band: f64) -> f64 {
    let coulomb = if speed < 0.0 { friction.backward } else { friction.forward };
    friction.viscous * speed + coulomb * (speed / band).clamp(-1.0, 1.0)
}
