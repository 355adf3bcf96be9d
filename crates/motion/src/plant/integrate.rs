use super::state::Rate;
use super::{Actuation, Plant, PlantState};
use crate::MotionError;
use crate::error::positive;
use slideway_robot::DynamicsError;

/// Steps that a sample took, and their estimated error.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Resolution {
    /// Steps tried, refused ones included.
    pub steps: u32,
    /// Sum of the steps' estimated errors of positions and speeds.
    pub error: f64,
}

/// A step run whole and in two halves.
struct Trial<const N: usize> {
    /// By the halves.
    state: PlantState<N>,
    /// Largest difference in a position or a speed.
    change: f64,
}

impl<const N: usize> Plant<N> {
    /// Moves the arm on by `period` (s). The actuation is asked for at every instant the scheme visits, some of them more than
    /// once and not in order: a sampled controller gives the same answer throughout.
    ///
    /// Classical Runge-Kutta. Each step is run whole and in two halves; where they disagree the step is halved, where they agree
    /// the halves are kept and the next step may be twice as long. So an instant at which a force jumps, as at the first touch of
    /// a wall with a damper, costs some thirty short steps and no accuracy, unless step and halves agree by chance (about once in ten
    /// thousand touches): then the jump is misplaced by at most the period.
    ///
    /// # Errors
    ///
    /// [`MotionError::NotResolved`] if the steps run out, [`MotionError::Dynamics`] if there is no mass to accelerate or a number
    /// is not finite, [`MotionError::Setting`] for a period that is not positive. The state is left as it was.
    pub fn advance(
        &self,
        state: &mut PlantState<N>,
        period: f64,
        actuation: &mut impl FnMut(&PlantState<N>) -> Actuation<N>,
    ) -> Result<Resolution, MotionError> {
        positive("period", period)?;
        let longest = period / f64::from(self.settings.steps);
        let mut resolution = Resolution::default();
        let (mut x, mut dt, mut gone) = (*state, longest, 0.0);
        while gone < period {
            // A rest of roundings is not a step of its own.
            let last = period - gone <= dt * (1.0 + 1e-9);
            let step = if last { period - gone } else { dt };
            let trial = self.attempt(&x, step, actuation);
            resolution.steps += 1;
            match trial {
                // The error of order 4 of the whole step is 16 times that of the halves.
                Ok(trial) if trial.change / 15.0 <= self.settings.tolerance => {
                    resolution.error += trial.change / 15.0;
                    gone = if last { period } else { gone + step };
                    x = PlantState { time: state.time + gone, ..trial.state };
                    dt = (2.0 * step).min(longest);
                }
                refused if resolution.steps >= self.settings.most_steps => {
                    let change = refused?.change;
                    return Err(MotionError::NotResolved { time: state.time, steps: resolution.steps, change });
                }
                _ => dt = 0.5 * step,
            }
        }
        *state = x;
        Ok(resolution)
    }

    fn attempt(
        &self,
        from: &PlantState<N>,
        dt: f64,
        actuation: &mut impl FnMut(&PlantState<N>) -> Actuation<N>,
    ) -> Result<Trial<N>, DynamicsError> {
        let first = self.rate(from, actuation)?;
        let whole = self.step(from, &first, dt, actuation)?;
        let half = self.step(from, &first, 0.5 * dt, actuation)?;
        let second = self.rate(&half, actuation)?;
        let state = self.step(&half, &second, 0.5 * dt, actuation)?;
        let change = (state.q - whole.q).amax().max((state.qd - whole.qd).amax());
        Ok(Trial { state, change })
    }

    /// One step of the classical scheme, its first rate given.
    fn step(
        &self,
        x: &PlantState<N>,
        a: &Rate<N>,
        dt: f64,
        actuation: &mut impl FnMut(&PlantState<N>) -> Actuation<N>,
    ) -> Result<PlantState<N>, DynamicsError> {
        let b = self.rate(&x.after(0.5 * dt, a), actuation)?;
        let c = self.rate(&x.after(0.5 * dt, &b), actuation)?;
        let d = self.rate(&x.after(dt, &c), actuation)?;
        Ok(x.after(dt, &Rate::mean(a, &b, &c, &d)))
    }

    fn rate(
        &self,
        state: &PlantState<N>,
        actuation: &mut impl FnMut(&PlantState<N>) -> Actuation<N>,
    ) -> Result<Rate<N>, DynamicsError> {
        let Actuation { torque, push } = actuation(state);
        let (q, qd) = (&state.q, &state.qd);
        let frames = self.dynamics.arm().frames(q);
        let jacobian = self.dynamics.arm().jacobian_at(&frames);
        let friction = self.friction(qd);
        let driving = torque + jacobian.transpose() * push;
        let mut acting = driving - friction;
        let mut loss = friction.dot(qd);
        if let Some(wall) = &self.wall {
            let (tip, twist) = (frames.tool.translation.vector, jacobian * qd);
            let velocity = twist.fixed_rows::<3>(0).into_owned();
            acting += jacobian.fixed_rows::<3>(0).transpose() * wall.force(&tip, &velocity);
            loss += wall.loss(&tip, &velocity);
        }
        let qdd = self.dynamics.forward(q, qd, &acting)?;
        Ok(Rate { qd: *qd, qdd, power: driving.dot(qd), loss })
    }
}
