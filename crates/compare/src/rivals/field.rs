use super::{Placed, empty, instants, sample};
use slideway_baselines::potential_field::PotentialField;
use slideway_conditioner::path::{Constraint, ConstraintSample, Motion};
use slideway_lab::conditioning::{ConditionedTrace, ConditioningProblem, MAX_CONSTRAINTS, PathMethod, Phase};

/// The potential field along the whole reference. Where the field has no meaning (a boundary was crossed) the last position
/// is held.
#[must_use]
pub fn potential_field_trace(problem: &ConditioningProblem) -> ConditionedTrace {
    let field = PotentialField {
        period: problem.sampling_period,
        attraction: problem.attraction,
        repulsion: problem.repulsion,
        influence: problem.influence,
    };
    let mut trace = empty(problem, PathMethod::PotentialField);
    let mut correction = [0.0; 3];
    let mut last = None;
    for reference in instants(problem) {
        let found = field.step(&mut correction, &reference, |motion| padded(problem, motion));
        let position = found.or(last).unwrap_or(reference.position);
        last = Some(position);
        let placed = Placed {
            motion: Motion { position, ..reference },
            has_velocity: false,
            phase: if found.is_some() { Phase::Free } else { Phase::Held },
        };
        let mut placed_sample = sample(problem, &reference, &placed);
        let count = problem.constraints.len();
        for i in 0..count {
            // The field acts within its distance of influence, measured as it measures it.
            let distance = -placed_sample.sigma[i] / placed_sample.gradient[i];
            placed_sample.share[i] = if distance < problem.influence { 1.0 / count as f64 } else { 0.0 };
        }
        if found.is_some() && placed_sample.share.iter().any(|s| *s > 0.0) {
            placed_sample.phase = Phase::Acting;
        }
        trace.samples.push(placed_sample);
    }
    trace
}

/// The constraints, padded to a fixed number with ones that are far away.
fn padded(problem: &ConditioningProblem, motion: &Motion<3>) -> [ConstraintSample<3>; MAX_CONSTRAINTS] {
    let far = ConstraintSample {
        value: -1e9,
        gradient: [1.0, 0.0, 0.0],
        time_rate: 0.0,
        gradient_rate: [0.0; 3],
        time_rate_rate: 0.0,
    };
    std::array::from_fn(|i| problem.constraints.get(i).map_or(far, |c| c.sample(motion)))
}
