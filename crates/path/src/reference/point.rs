use slideway_robot::{EulerAngles, Pose, Twist};

/// One point of a tool path with its derivatives by the path parameter, in the base frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathPoint {
    /// Position and orientation.
    pub pose: Pose,
    /// `[p'(λ); ω(λ)]`, linear and angular speed per unit of path rate; at a kink, those of the piece that begins there.
    pub twist: Twist,
    /// `[p''(λ); ω'(λ)]`.
    pub acceleration: Twist,
    /// The orientation as an Euler triple, where the path gives it so: the controller then compares Euler triples, as
    /// `[G11]` does; else it takes the rotation vector between tool and reference.
    pub euler: Option<EulerPoint>,
}

/// The orientation of a path point in the convention `Rz(α) Ry(β) Rx(γ)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EulerPoint {
    /// `α, β, γ`, rad.
    pub angles: EulerAngles,
    /// Their derivatives by the path parameter.
    pub rates: EulerAngles,
}
