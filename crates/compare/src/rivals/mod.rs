//! The rivals of the path conditioner, run along a whole reference: each gives a trace of the conditioner's own kind.

mod field;
mod filtered;
mod projected;

pub use field::potential_field_trace;
pub use filtered::qp_filter_trace;
pub use projected::{ProjectedTrace, ProjectionKind, projected_end, projection_trace};

use slideway_conditioner::path::{Constraint, ConstraintSample, Motion};
use slideway_lab::conditioning::{
    CLOCK_ROUNDING, ConditionedSample, ConditionedTrace, ConditioningProblem, MAX_CONSTRAINTS, PathMethod, Phase,
};

/// The instants of a reference that nothing stops, with the reference there: whole sampling periods, the last one at its end
/// or less than one before it, as in [`slideway_lab::conditioning::run_conditioner`].
#[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss)]
fn instants(problem: &ConditioningProblem) -> impl Iterator<Item = Motion<3>> + '_ {
    let duration = problem.reference.duration();
    let count = ((duration + CLOCK_ROUNDING) / problem.sampling_period).floor() as usize;
    (0..=count).map(move |k| {
        let t = k as f64 * problem.sampling_period;
        problem.reference.at(t, t.min(duration), 1.0)
    })
}

fn empty(problem: &ConditioningProblem, method: PathMethod) -> ConditionedTrace {
    ConditionedTrace {
        method,
        constraints: problem.constraints.iter().map(|c| c.name.clone()).collect(),
        sampling_period: problem.sampling_period,
        finish_s: Some(problem.reference.duration()),
        samples: Vec::new(),
    }
}

/// Where a method put the reference at one instant.
struct Placed {
    motion: Motion<3>,
    /// True if `motion.velocity` means anything, so that `φ` does.
    has_velocity: bool,
    phase: Phase,
}

fn sample(problem: &ConditioningProblem, reference: &Motion<3>, placed: &Placed) -> ConditionedSample {
    let duration = problem.reference.duration();
    let mut sample = ConditionedSample {
        t: reference.time,
        lambda: problem.reference.lambda(reference.time.min(duration)),
        reference: reference.position,
        position: placed.motion.position,
        sigma: [0.0; MAX_CONSTRAINTS],
        phi: [0.0; MAX_CONSTRAINTS],
        seen_phi: [0.0; MAX_CONSTRAINTS],
        share: [0.0; MAX_CONSTRAINTS],
        gradient: [0.0; MAX_CONSTRAINTS],
        push: std::array::from_fn(|i| placed.motion.position[i] - reference.position[i]),
        reserve: [0.0; 3],
        walk: [0.0; 3],
        phase: placed.phase,
    };
    for (i, constraint) in problem.constraints.iter().enumerate() {
        let s: ConstraintSample<3> = constraint.sample(&placed.motion);
        sample.sigma[i] = s.value;
        sample.phi[i] =
            if placed.has_velocity { s.phi(constraint.approach, &placed.motion.velocity) } else { f64::NAN };
        sample.gradient[i] = s.gradient.iter().map(|g| g * g).sum::<f64>().sqrt();
    }
    sample.seen_phi = sample.phi;
    sample
}

/// Shares of the constraints in a deviation from the reference: equal among those that are as good as on their boundary.
fn share_deviation(sample: &mut ConditionedSample, count: usize, value: impl Fn(&ConditionedSample, usize) -> f64) {
    if sample.deviation() <= CONTACT {
        return;
    }
    let touching: Vec<usize> = (0..count).filter(|&i| value(sample, i) > -CONTACT).collect();
    for &i in &touching {
        sample.share[i] = 1.0 / touching.len() as f64;
    }
    if !touching.is_empty() {
        sample.phase = Phase::Acting;
    }
}

/// A boundary nearer than this counts as touched, m.
const CONTACT: f64 = 1e-6;
