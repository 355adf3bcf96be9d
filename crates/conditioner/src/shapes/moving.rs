use super::Shape;
use crate::path::vector::{add_scaled, difference, dot, scaled};
use crate::path::{Constraint, ConstraintSample, Motion};

/// Where a moving shape is displaced to, and how.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Waypoint<const N: usize> {
    /// Displacement `c(t)`.
    pub position: [f64; N],
    /// `ċ(t)`, per second.
    pub velocity: [f64; N],
    /// `c̈(t)`, per second squared.
    pub acceleration: [f64; N],
}

/// A known displacement over time.
pub trait Trajectory<const N: usize> {
    /// Displacement and its derivatives at a time in seconds.
    fn at(&self, time: f64) -> Waypoint<N>;
}

/// `c = v t + a t² / 2`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UniformMotion<const N: usize> {
    /// Velocity at time 0, per second.
    pub velocity: [f64; N],
    /// Acceleration, per second squared.
    pub acceleration: [f64; N],
}

impl<const N: usize> Trajectory<N> for UniformMotion<N> {
    fn at(&self, time: f64) -> Waypoint<N> {
        let position = add_scaled(&scaled(time, &self.velocity), 0.5 * time * time, &self.acceleration);
        let velocity = add_scaled(&self.velocity, time, &self.acceleration);
        Waypoint { position, velocity, acceleration: self.acceleration }
    }
}

/// `c = A sin(ω t + ψ)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Oscillation<const N: usize> {
    /// Amplitude `A` of each coordinate.
    pub amplitude: [f64; N],
    /// Angular frequency `ω`, rad/s.
    pub frequency: f64,
    /// Phase `ψ`, rad.
    pub phase: f64,
}

impl<const N: usize> Trajectory<N> for Oscillation<N> {
    fn at(&self, time: f64) -> Waypoint<N> {
        let (w, angle) = (self.frequency, self.frequency * time + self.phase);
        let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
        Waypoint {
            position: scaled(sine, &self.amplitude),
            velocity: scaled(w * cosine, &self.amplitude),
            acceleration: scaled(-w * w * sine, &self.amplitude),
        }
    }
}

/// A shape carried along a trajectory without turning: `σ(p, t) = s(p - c(t))`, `[G12] 5.4`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moving<S, T> {
    /// The shape, where it is while the displacement is zero.
    pub shape: S,
    /// The displacement.
    pub trajectory: T,
}

/// ```text
/// ∂σ/∂t = -∇sᵀ ċ,   d∇σ/dt = H (ṗ - ċ),   d(∂σ/∂t)/dt = -(H (ṗ - ċ))ᵀ ċ - ∇sᵀ c̈
/// ```
impl<const N: usize, S: Shape<N>, T: Trajectory<N>> Constraint<N> for Moving<S, T> {
    fn sample(&self, motion: &Motion<N>) -> ConstraintSample<N> {
        let carrier = self.trajectory.at(motion.time);
        let position = difference(&motion.position, &carrier.position);
        let local = self.shape.local(&position, &difference(&motion.velocity, &carrier.velocity));
        ConstraintSample {
            value: local.value,
            gradient: local.gradient,
            time_rate: -dot(&local.gradient, &carrier.velocity),
            gradient_rate: local.curvature,
            time_rate_rate: -dot(&local.curvature, &carrier.velocity) - dot(&local.gradient, &carrier.acceleration),
        }
    }
}
