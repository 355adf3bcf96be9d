//! Trap avoidance inside the conditioner: what it looks at, and the safe walk.

use super::conditioner::PathConditioner;
use super::constraint::{ConstraintSample, Motion};
use super::evaluated::Evaluated;
use super::outcome::TrapPhase;
use super::quadratic::largest_factor;
use super::settings::{SwitchingLaw, Walk};
use super::state::PathState;
use super::trap::{Situation, TrapInputs};
use super::vector::{add_scaled, difference, dot, norm, scaled};
use super::walk_direction::orthogonal_direction;

impl<const N: usize, const M: usize> PathConditioner<N, M> {
    /// The inputs of walk and pace for the coming interval.
    #[inline]
    pub(super) fn trap_inputs<E>(
        &self,
        state: &mut PathState<N, M>,
        reference: &Motion<N>,
        now: &Evaluated<N, M>,
        constraints: &E,
    ) -> TrapInputs<N>
    where
        E: Fn(&Motion<N>) -> [ConstraintSample<N>; M],
    {
        let Some(trap) = &self.trap else {
            return TrapInputs { walk: [0.0; N], pace: 1.0, phase: TrapPhase::Following };
        };
        let mut threshold = [trap.settings.activity_threshold; M];
        let safe = match (trap.settings.walk, self.settings.form.law()) {
            (Walk::Safe { push_share }, Some(law)) => {
                // [G12] 7.2.1: the threshold has to be wider than the band.
                for (t, g) in threshold.iter_mut().zip(self.full_push(law, &now.samples)) {
                    *t = t.max(g);
                }
                Some(self.safe_walk(state, now, law, push_share, trap.settings.walk_cutoff))
            }
            (Walk::Paper, _) | (_, None) => None,
        };
        let situation = Situation {
            distance: norm(&difference(&now.motion.position, &reference.position)),
            // A reference where the constraints cannot be evaluated is not clearly inside: its NaN compares false.
            reference_excess: &self.evaluate(*reference, constraints).excess,
            samples: &now.samples,
            excess: &now.excess,
            threshold: &threshold,
        };
        trap.decide(&mut state.trap, &situation, |wanted, active| match &safe {
            None => wanted,
            Some(walk) => walk.shorten(&wanted, active, constraints),
        })
    }

    fn safe_walk<'a>(
        &'a self,
        state: &PathState<N, M>,
        now: &'a Evaluated<N, M>,
        law: SwitchingLaw,
        push_share: f64,
        walk_cutoff: f64,
    ) -> SafeWalk<'a, N, M> {
        let a = self.settings.push_cutoff;
        let (push, speed) = (&state.push, state.trap.speed);
        let pull = add_scaled(&scaled(-a * a, &push.first), -core::f64::consts::SQRT_2 * a, &push.second);
        let longest = law.longest(a, &self.settings.approach, &now.samples);
        let mut room = self.settings.approach;
        for ((room, sample), excess) in room.iter_mut().zip(&now.samples).zip(&now.excess) {
            let reach = a * a * *room * norm(&sample.gradient) * longest;
            *room = push_share * reach + walk_cutoff * (-excess).max(0.0);
        }
        SafeWalk { now, approach: &self.settings.approach, speed, pull: add_scaled(&pull, -walk_cutoff, &speed), room }
    }
}

/// The safe walk at one sample: how fast every `φ_i` would rise without a push, `L_f φ_i`, against the push there is.
///
/// ```text
/// L_f φ_i(v) = ∇σᵀ v + ∂σ/∂t + K (∇σᵀ p̈ + vᵀ H v + ...)  <=  share · α1² K ‖∇σ_i‖ U + α2 (-φ_i)⁺
/// ```
///
/// The second term lets a constraint be neared in the time the walk needs to brake. `p̈` is what the filters give without
/// inputs, with the reference standing. `L_f φ_i` is quadratic in the speed, so three evaluations give the largest one.
/// Where the present motion already asks for too much, the walk brakes along the boundary instead.
struct SafeWalk<'a, const N: usize, const M: usize> {
    now: &'a Evaluated<N, M>,
    approach: &'a [f64; M],
    /// `ḟ_RW`.
    speed: [f64; N],
    /// `p̈*` without inputs.
    pull: [f64; N],
    room: [f64; M],
}

impl<const N: usize, const M: usize> SafeWalk<'_, N, M> {
    fn shorten<E>(&self, wanted: &[f64; N], active: &[bool; M], constraints: &E) -> [f64; N]
    where
        E: Fn(&Motion<N>) -> [ConstraintSample<N>; M],
    {
        let present = self.drift(self.now.motion.velocity, constraints);
        // Written so that a NaN brakes.
        if !present.iter().zip(&self.room).all(|(drift, room)| drift <= room) {
            return match orthogonal_direction(&self.now.samples, active, &self.speed) {
                Some(ahead) => scaled(-norm(wanted), &ahead),
                None => [0.0; N],
            };
        }
        let rest = difference(&self.now.motion.velocity, &self.speed);
        let [none, half, full] = [0.0, 0.5, 1.0].map(|w| self.drift(add_scaled(&rest, w, wanted), constraints));
        let mut factor = 1.0_f64;
        for (((a, b), c), &room) in none.iter().zip(&half).zip(&full).zip(&self.room) {
            factor = factor.min(largest_factor([*a, *b, *c], room));
        }
        scaled(factor, wanted)
    }

    /// `L_f φ_i` at velocity `v`.
    fn drift<E>(&self, velocity: [f64; N], constraints: &E) -> [f64; M]
    where
        E: Fn(&Motion<N>) -> [ConstraintSample<N>; M],
    {
        let samples = constraints(&Motion { velocity, ..self.now.motion });
        let mut drift = *self.approach;
        for (drift, s) in drift.iter_mut().zip(&samples) {
            let acceleration = dot(&s.gradient, &self.pull) + dot(&s.gradient_rate, &velocity) + s.time_rate_rate;
            // [G12] eq 10
            *drift = s.rate(&velocity) + *drift * acceleration;
        }
        drift
    }
}

#[cfg(test)]
mod tests;
