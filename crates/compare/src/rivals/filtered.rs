use super::{Placed, empty, instants, sample, share_deviation};
use slideway_baselines::safety_filter::dense::DualActiveSet;
use slideway_baselines::safety_filter::{FilterSettings, QpFilter};
use slideway_conditioner::path::Motion;
use slideway_lab::conditioning::{ConditionedTrace, ConditioningProblem, PathMethod, Phase};

/// Linearisations of the constraints per sample: four solve the nonlinear program to rounding.
const ROUNDS: usize = 4;

/// The QP safety filter along the whole reference. A sample without a solution is held.
#[must_use]
pub fn qp_filter_trace(problem: &ConditioningProblem) -> ConditionedTrace {
    match problem.constraints.len() {
        1 => run::<1>(problem),
        2 => run::<2>(problem),
        3 => run::<3>(problem),
        4 => run::<4>(problem),
        5 => run::<5>(problem),
        6 => run::<6>(problem),
        7 => run::<7>(problem),
        _ => run::<8>(problem),
    }
}

fn run<const M: usize>(problem: &ConditioningProblem) -> ConditionedTrace {
    let settings = FilterSettings {
        period: problem.sampling_period,
        cutoff: problem.push_cutoff,
        approach: problem.approach::<M>(),
        rounds: ROUNDS,
    };
    let mut filter = QpFilter::<3, M, _>::new(settings, DualActiveSet);
    let mut trace = empty(problem, PathMethod::QpFilter);
    let mut last: Option<Motion<3>> = None;
    for (k, reference) in instants(problem).enumerate() {
        // The first sample stands on the reference: there is no interval before it.
        let found = if k == 0 { Ok(reference) } else { filter.step(&reference, |motion| problem.sample::<M>(motion)) };
        let (motion, phase) = match found {
            Ok(motion) => (motion, Phase::Free),
            Err(_) => (Motion { velocity: [0.0; 3], time: reference.time, ..last.unwrap_or(reference) }, Phase::Held),
        };
        last = Some(motion);
        let mut placed = sample(problem, &reference, &Placed { motion, has_velocity: true, phase });
        if phase == Phase::Free {
            share_deviation(&mut placed, M, |s, i| s.phi[i]);
        }
        trace.samples.push(placed);
    }
    trace
}
