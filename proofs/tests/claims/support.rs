//! Solver, generators and small robots shared by the claims.

use std::error::Error;

use proptest::prelude::{BoxedStrategy, ProptestConfig, Strategy};
use proptest::test_runner::{TestCaseError, TestRunner};
use slideway_conditioner::{FirstOrderFilter, ParameterError, SpeedLimits, SpeedRegulator};
use slideway_proofs::Claim;
use slideway_proofs::engine::{Choices, Cost};
use slideway_proofs::subject::Subject;
use slideway_proofs::z3::{self, Answer, Model};

pub(crate) type Outcome = Result<(), Box<dyn Error>>;

pub(crate) use slideway_proofs::draw::{ROUNDOFF, TS, settings};

pub(crate) fn config() -> ProptestConfig {
    ProptestConfig {
        cases: 10_000,
        failure_persistence: None,
        max_global_rejects: 100_000,
        ..ProptestConfig::default()
    }
}

/// A failing test prints its error by `Debug`; as a string that is the message, remedy included.
fn solve(script: &str) -> Result<Answer, Box<dyn Error>> {
    z3::run(script).map_err(|error| error.to_string().into())
}

/// Ok only if the solver proves every negation of the claim impossible.
pub(crate) fn proven(claim: &Claim) -> Outcome {
    for negation in claim.negations {
        match solve(negation.text)? {
            Answer::Unsat => {}
            other => return Err(format!("{}: expected unsat, the solver says {other:?}", negation.file).into()),
        }
    }
    if claim.negations.is_empty() { Err("a claim without a script is not proven".into()) } else { Ok(()) }
}

/// Puts the shipped code to every engine of the claim, over choices that proptest makes and makes simpler.
pub(crate) fn holds(claim: &Claim) -> Outcome {
    for engine in claim.engines {
        let cases = match engine.cost {
            Cost::Sample => 10_000,
            Cost::Run => 2_000,
            Cost::Motion => 300,
        };
        let mut runner = TestRunner::new(ProptestConfig { cases, ..config() });
        let kept = runner.run(&proptest::collection::vec(0.0..1.0, 0..200), |choices| {
            match engine.violation(&mut Choices::replay(&choices), Subject::Shipped) {
                None => Ok(()),
                Some(what) => Err(TestCaseError::fail(what)),
            }
        });
        kept.map_err(|error| format!("{}: {error}", engine.name))?;
    }
    if claim.engines.is_empty() { Err("a claim without an engine is not tested".into()) } else { Ok(()) }
}

/// The solver's counterexample to the claim with one hypothesis dropped.
pub(crate) fn counterexample(claim: &Claim, without: &str) -> Result<Model, Box<dyn Error>> {
    let twin = claim.twins.iter().find(|twin| twin.without == without).ok_or("no such twin")?;
    match solve(twin.script.text)? {
        Answer::Sat(model) => Ok(model),
        other => Err(format!("{}: expected sat, the solver says {other:?}", twin.script.file).into()),
    }
}

pub(crate) fn filter(step: f64) -> Result<FirstOrderFilter, ParameterError> {
    FirstOrderFilter::new(step / TS, TS)
}

/// One joint with the limits -1 and 1.
pub(crate) fn unit_joint(step: f64, target_rate: f64) -> Result<SpeedRegulator<1>, ParameterError> {
    SpeedRegulator::new(settings(SpeedLimits::symmetric([1.0])?, step, target_rate))
}

fn array<const N: usize>(values: &[f64]) -> [f64; N] {
    std::array::from_fn(|joint| values.get(joint).copied().unwrap_or(f64::NAN))
}

/// `N` numbers of one strategy.
pub(crate) fn joints<const N: usize>(one: impl Strategy<Value = f64> + 'static) -> BoxedStrategy<[f64; N]> {
    proptest::collection::vec(one, N).prop_map(|values| array(&values)).boxed()
}
