use crate::AxisState;

/// A stretch of constant jerk.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Phase {
    /// Duration, s.
    pub duration: f64,
    /// State at its beginning.
    pub start: AxisState,
    /// Jerk, per s³.
    pub jerk: f64,
}

impl Phase {
    /// State `t` seconds into the phase.
    #[must_use]
    pub fn at(&self, t: f64) -> AxisState {
        self.start.after(t, self.jerk)
    }

    /// State at its end.
    #[must_use]
    pub fn end(&self) -> AxisState {
        self.at(self.duration)
    }

    /// The times in the open phase at which the velocity is zero: roots of `v + a t + j t² / 2`.
    pub(crate) fn standstills(&self) -> [Option<f64>; 2] {
        let AxisState { velocity: v, acceleration: a, .. } = self.start;
        roots(self.jerk / 2.0, a, v).map(|root| root.filter(|&t| t > 0.0 && t < self.duration))
    }

    /// The time in the open phase at which the acceleration is zero.
    pub(crate) fn speed_peak(&self) -> Option<f64> {
        Some(-self.start.acceleration / self.jerk).filter(|&t| t > 0.0 && t < self.duration)
    }
}

/// Real roots of `a x² + b x + c`, without cancellation; none if the polynomial is constant.
pub(crate) fn roots(a: f64, b: f64, c: f64) -> [Option<f64>; 2] {
    let discriminant = b * b - 4.0 * a * c;
    if !(discriminant >= 0.0) {
        return [None, None];
    }
    let q = -0.5 * (b + discriminant.sqrt().copysign(b));
    let finite = |x: f64| Some(x).filter(|x| x.is_finite());
    [finite(q / a), finite(c / q)]
}
