use super::observed::{Observed, Reading};
use slideway_lab::conditioning::{ConditionedTrace, ConditioningProblem};

pub(crate) fn observed(_problem: &ConditioningProblem, _trace: &ConditionedTrace) -> Observed {
    Observed { hypotheses: Vec::<Reading>::new(), guarantees: Vec::new() }
}
