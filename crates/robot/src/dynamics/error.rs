use thiserror::Error;

/// Error in a robot's masses or drives.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum DynamicsError {
    /// A link that is no rigid body.
    #[error("link {}: {fault}", link + 1)]
    Link {
        /// Link, counted from 0.
        link: usize,
        /// The link's fault.
        fault: BodyFault,
    },
    /// A drive that no machine has.
    #[error("joint {}: {fault}", joint + 1)]
    Drive {
        /// Joint, counted from 0.
        joint: usize,
        /// The drive's fault.
        fault: DriveFault,
    },
    /// Another number of links behind followers than followers.
    #[error("{found} links given for {expected} followers")]
    FollowerLinks {
        /// Links given.
        found: usize,
        /// Followers of the arm.
        expected: usize,
    },
    /// Torques cannot tell accelerations: some motion moves no mass, or a number is not finite.
    #[error("the mass matrix is not positive definite: some joint motion moves no mass, or a number is not finite")]
    SingularMass,
}

/// Why parameters are not those of a rigid body.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum BodyFault {
    /// A mass that is negative or not finite.
    #[error("its mass is {0} kg; it must be finite and not negative")]
    Mass(f64),
    /// A number that is not finite.
    #[error("a number of its centre of mass or inertia is not finite")]
    NotFinite,
    /// A matrix that is not symmetric.
    #[error("its inertia matrix is not symmetric")]
    NotSymmetric,
    /// A principal moment below zero.
    #[error("its inertia matrix has the negative principal moment {0} kg m²")]
    NegativeMoment(f64),
}

/// A parameter of a drive that is negative or not finite.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("its {name} is {value}; it must be finite and not negative")]
pub struct DriveFault {
    /// Name of the parameter.
    pub name: &'static str,
    /// Value given.
    pub value: f64,
}
