use slideway_robot::{JointVector, Twist};

/// Torques and forces that act on an arm besides its weight and the wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Actuation<const N: usize> {
    /// Torques of the motors at the joints, N·m (N).
    pub torque: JointVector<N>,
    /// A force (N) through the tool's origin and a moment (N·m) that someone exerts on the tool, base frame.
    pub push: Twist,
}

impl<const N: usize> Actuation<N> {
    /// Motors alone.
    #[must_use]
    pub fn torque(torque: JointVector<N>) -> Self {
        Self { torque, push: Twist::zeros() }
    }
}

/// Where a simulated arm is, and what has been done to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlantState<const N: usize> {
    /// Time, s.
    pub time: f64,
    /// Positions, rad (m).
    pub q: JointVector<N>,
    /// Speeds, per s.
    pub qd: JointVector<N>,
    /// Work done by the motors and the push since the beginning, J.
    pub work: f64,
    /// Energy that friction and the wall's damper have taken, J; it never falls.
    pub lost: f64,
}

impl<const N: usize> PlantState<N> {
    /// At rest, at the beginning of time.
    #[must_use]
    pub fn at_rest(q: JointVector<N>) -> Self {
        Self { time: 0.0, q, qd: JointVector::zeros(), work: 0.0, lost: 0.0 }
    }

    /// The state after `dt` at constant rates.
    pub(super) fn after(&self, dt: f64, rate: &Rate<N>) -> Self {
        Self {
            time: self.time + dt,
            q: self.q + rate.qd * dt,
            qd: self.qd + rate.qdd * dt,
            work: self.work + rate.power * dt,
            lost: self.lost + rate.loss * dt,
        }
    }
}

/// Time derivative of a [`PlantState`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Rate<const N: usize> {
    pub(super) qd: JointVector<N>,
    pub(super) qdd: JointVector<N>,
    pub(super) power: f64,
    pub(super) loss: f64,
}

impl<const N: usize> Rate<N> {
    /// Weighted mean `(a + 2 b + 2 c + d) / 6` of the classical Runge-Kutta scheme.
    pub(super) fn mean(a: &Self, b: &Self, c: &Self, d: &Self) -> Self {
        Self {
            qd: (a.qd + (b.qd + c.qd) * 2.0 + d.qd) / 6.0,
            qdd: (a.qdd + (b.qdd + c.qdd) * 2.0 + d.qdd) / 6.0,
            power: (a.power + 2.0 * (b.power + c.power) + d.power) / 6.0,
            loss: (a.loss + 2.0 * (b.loss + c.loss) + d.loss) / 6.0,
        }
    }
}
