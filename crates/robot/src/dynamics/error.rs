use thiserror::Error;

/// What can go wrong with a robot's dynamics.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum DynamicsError {
    /// A mass that is negative or not finite.
    #[error("link {}: mass is {value} kg; it must be finite and not negative", link + 1)]
    Mass {
        /// Link, counted from 0.
        link: usize,
        /// What was given.
        value: f64,
    },
    /// A matrix that is no rigid body's inertia.
    #[error("link {}: the inertia matrix is not one of a rigid body: {reason}", link + 1)]
    Inertia {
        /// Link, counted from 0.
        link: usize,
        /// What is wrong.
        reason: &'static str,
    },
    /// A parameter of a drive that is negative or not finite.
    #[error("joint {}: {name} is {value}; it must be finite and not negative", joint + 1)]
    Drive {
        /// Joint, counted from 0.
        joint: usize,
        /// Name of the parameter.
        name: &'static str,
        /// What was given.
        value: f64,
    },
    /// Torques cannot tell accelerations: some motion moves no mass, or a number is not finite.
    #[error("the mass matrix is not positive definite: some joint motion moves no mass")]
    SingularMass,
}
