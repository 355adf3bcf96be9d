use slideway_robot::JointVector;

/// State of one axis: position (rad or m) and its first two time derivatives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AxisState {
    /// Position, rad or m.
    pub position: f64,
    /// Velocity, per s.
    pub velocity: f64,
    /// Acceleration, per s².
    pub acceleration: f64,
}

impl AxisState {
    /// At rest at a position.
    #[must_use]
    pub fn at_rest(position: f64) -> Self {
        Self { position, velocity: 0.0, acceleration: 0.0 }
    }

    /// The state after `t` seconds of constant jerk.
    #[must_use]
    pub fn after(&self, t: f64, jerk: f64) -> Self {
        Self {
            position: self.position + t * (self.velocity + t * (self.acceleration / 2.0 + t * jerk / 6.0)),
            velocity: self.velocity + t * (self.acceleration + t * jerk / 2.0),
            acceleration: self.acceleration + t * jerk,
        }
    }

    /// True if all three numbers are finite.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        self.position.is_finite() && self.velocity.is_finite() && self.acceleration.is_finite()
    }
}

/// State of `N` joints: a set-point for whatever follows it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointState<const N: usize> {
    /// Positions, rad or m.
    pub q: JointVector<N>,
    /// Velocities, per s.
    pub qd: JointVector<N>,
    /// Accelerations, per s².
    pub qdd: JointVector<N>,
}

impl<const N: usize> JointState<N> {
    /// All joints at rest.
    #[must_use]
    pub fn at_rest(q: JointVector<N>) -> Self {
        Self { q, qd: JointVector::zeros(), qdd: JointVector::zeros() }
    }

    /// Collects the joints' states.
    #[must_use]
    pub fn from_axes(axes: &[AxisState; N]) -> Self {
        Self {
            q: JointVector::from_fn(|i, _| axes[i].position),
            qd: JointVector::from_fn(|i, _| axes[i].velocity),
            qdd: JointVector::from_fn(|i, _| axes[i].acceleration),
        }
    }

    /// The state of joint `i`.
    #[must_use]
    pub fn axis(&self, i: usize) -> AxisState {
        AxisState { position: self.q[i], velocity: self.qd[i], acceleration: self.qdd[i] }
    }

    /// True if every joint's speed and acceleration are exactly zero.
    #[must_use]
    pub fn is_at_rest(&self) -> bool {
        self.qd.iter().chain(self.qdd.iter()).all(|&x| x == 0.0)
    }
}
