//! Proposed parameters satisfy the request; values offered instead would have done so.

mod support;

use slideway_scenario::{AnyScenario, ScenarioError, TunedScenario, Tuning, TuningError};
use slideway_verify::{Impossible, MARGIN, Statement, TuneRequest, VerifyError};
use std::error::Error;
use support::statement;

type Outcome = Result<(), Box<dyn Error>>;

/// A scenario with what is asked for.
#[derive(Clone)]
struct Asked {
    scenario: AnyScenario,
    request: TuneRequest,
}

impl Asked {
    fn tune(&self) -> Result<Tuning, TuningError> {
        self.scenario.tuned(None, self.request)
    }
}

fn asked(name: &str, chattering: f64, rate: f64) -> Result<Asked, Box<dyn Error>> {
    let scenario = AnyScenario::built_in(name).ok_or("no such scenario")??;
    Ok(Asked { scenario, request: TuneRequest { chattering, rate } })
}

fn tuned(asked: &Asked) -> Result<TunedScenario, Box<dyn Error>> {
    match asked.tune()? {
        Tuning::Tuned(tuned) => Ok(*tuned),
        Tuning::Impossible(why) => Err(format!("{why:?}").into()),
    }
}

fn impossible(asked: &Asked) -> Result<Impossible, Box<dyn Error>> {
    match asked.tune()? {
        Tuning::Tuned(tuned) => Err(format!("{:?}", tuned.changes).into()),
        Tuning::Impossible(why) => Ok(why),
    }
}

/// The statement of the text that was proposed is the one that came with it, accepts, and bounds the chattering as asked.
fn does_what_was_asked(request: &TuneRequest, tuned: &TunedScenario, again: &Statement) {
    assert_eq!(&tuned.statement, again);
    assert!(again.accepts() && again.violated().count() == 0, "{again:?}");
    let chattering = tuned.predictions.iter().find(|p| p.name == "chattering");
    let (bound, found) = chattering.map_or((None, None), |p| (p.upper, p.measured));
    assert!(bound.is_some_and(|bound| bound <= request.chattering), "{chattering:?}");
    assert!(found.is_some_and(|found| found > 0.0 && found <= request.chattering), "{chattering:?}");
    assert!(!tuned.trade_off.is_empty());
}

/// The hypotheses about settings hold with the margin, to the three digits that are proposed.
fn holds_with_a_margin(statement: &Statement, names: &[&str]) {
    for name in names {
        let margin = statement.hypotheses.iter().find(|h| h.name == *name).map(slideway_verify::Hypothesis::margin);
        assert!(margin.is_some_and(|m| m >= MARGIN * (1.0 - 0.05)), "{name} {margin:?}");
    }
}

#[test]
fn speed_scenarios_are_tuned_to_an_amplitude_at_a_rate() -> Outcome {
    for (name, chattering, rate) in [("planar-line", 0.05, 1000.0), ("natural-2r", 0.35, 2000.0)] {
        let asked = asked(name, chattering, rate)?;
        let tuned = tuned(&asked)?;
        does_what_was_asked(&asked.request, &tuned, &statement(&AnyScenario::parse(name, &tuned.text)?, None)?);
        holds_with_a_margin(&tuned.statement, &["drift-against-filter", "target-rate"]);
        let document: toml::Table = tuned.text.parse()?;
        assert_eq!(document["control"]["sampling_period"].as_float(), Some(1.0 / rate));
    }
    Ok(())
}

#[test]
fn a_conditioning_scenario_is_tuned_to_an_amplitude_at_a_rate() -> Outcome {
    for chattering in [2e-2, 4e-3] {
        let asked = asked("helix-plane-sphere", chattering, 1000.0)?;
        let tuned = tuned(&asked)?;
        let scenario = AnyScenario::parse("helix-plane-sphere", &tuned.text)?;
        does_what_was_asked(&asked.request, &tuned, &statement(&scenario, None)?);
        let share = tuned.statement.hypotheses.iter().find(|h| h.name == "push-share").ok_or("not stated")?;
        assert!(share.value * (1.0 + MARGIN) <= 1.0 + 1e-9, "{share:?}");
    }
    Ok(())
}

#[test]
fn a_gain_too_high_for_the_rate_comes_down() -> Outcome {
    let mut asked = asked("planar-line", 0.2, 1000.0)?;
    asked.scenario = AnyScenario::parse("mine", &asked.scenario.text().replace("gain = 20", "gain = 950"))?;
    let tuned = tuned(&asked)?;
    let gain = tuned.statement.hypotheses.iter().find(|h| h.name == "gain-step").ok_or("not stated")?;
    assert!(
        gain.value <= 1.0 / (1.0 + MARGIN) + 1e-9 && tuned.changes.iter().any(|c| c.key == "control.gain"),
        "{gain:?}"
    );
    Ok(())
}

#[test]
fn an_impossible_amplitude_comes_with_a_rate_and_an_amplitude_that_would_do() -> Outcome {
    for (name, chattering, rate) in [("planar-line", 0.01, 200.0), ("helix-plane-sphere", 1e-3, 1000.0)] {
        let asked = asked(name, chattering, rate)?;
        let why = impossible(&asked)?;
        let (faster, wider) = (why.rate.ok_or("no rate")?, why.chattering.ok_or("no amplitude")?);
        assert!(faster > rate && wider > chattering, "{why:?}");
        tuned(&Asked { request: TuneRequest { rate: faster, ..asked.request }, ..asked.clone() })?;
        // A twentieth more, for the last digits of the proposal.
        tuned(&Asked { request: TuneRequest { chattering: 1.05 * wider, ..asked.request }, ..asked })?;
    }
    Ok(())
}

#[test]
fn a_rate_too_low_for_any_filter_comes_with_one_that_would_do() -> Outcome {
    let asked = asked("natural-2r", 0.9, 50.0)?;
    let faster = impossible(&asked)?.rate.ok_or("no rate")?;
    tuned(&Asked { request: TuneRequest { rate: faster, ..asked.request }, ..asked })?;
    Ok(())
}

#[test]
fn a_path_through_a_singularity_has_no_filter_that_does() -> Outcome {
    let why = impossible(&asked("puma-wrist-singularity", 0.5, 4000.0)?)?;
    assert!(why.rate.is_none() && why.chattering.is_none() && why.reason.contains("singularity"), "{why:?}");
    Ok(())
}

#[test]
fn what_makes_no_sense_is_refused() -> Outcome {
    for (chattering, rate) in [(0.0, 1000.0), (f64::NAN, 1000.0), (0.1, -1.0), (0.1, f64::INFINITY)] {
        let refused = asked("planar-line", chattering, rate)?.tune();
        assert!(matches!(refused, Err(TuningError::Verify(VerifyError::NotPositive { .. }))));
    }
    let judged_by_acceleration = asked("planar-bend", 0.1, 1000.0)?.tune();
    assert!(matches!(judged_by_acceleration, Err(TuningError::Verify(VerifyError::NoClaims { .. }))));
    Ok(())
}

/// Paths without a rate somewhere, and with one everywhere.
const JOINTS: &str = "
    robot.model = 'planar-2r'
    path.joints.lines = { points = [[0, 0], [1, 1], [0, 2]], blend = 0.2 }
    limits.speed = 1
    control = { gain = 10, sampling_period = 1e-3, bandwidth = 20, target_rate = 3 }
";

#[test]
fn no_proposal_has_a_number_that_is_none_whatever_the_path_and_the_method() {
    let mut proposed = 0;
    for (path, text) in [
        ("corner", JOINTS.replace("blend = 0.2", "blend = 0")),
        ("round", JOINTS.to_owned()),
        ("back", JOINTS.replace("[0, 2]", "[0, 0]")),
        ("slow", JOINTS.replace("speed = 1", "speed = 0.05")),
        (
            "spline",
            JOINTS.replace(
                "lines = { points = [[0, 0], [1, 1], [0, 2]], blend = 0.2 }",
                "spline = { points = [[0, 0], [1, 1], [0, 2]] }",
            ),
        ),
    ] {
        for method in ["sliding-mode", "sliding-mode-synchronised", "sliding-mode-implicit"] {
            for (chattering, rate) in [(0.05, 1000.0), (1e-4, 200.0)] {
                let scenario = AnyScenario::parse(path, &text).expect("TOML");
                match scenario.tuned(Some(method), TuneRequest { chattering, rate }) {
                    Ok(Tuning::Tuned(tuned)) => {
                        proposed += 1;
                        assert!(tuned.changes.iter().all(|change| change.after.is_finite() && change.after > 0.0));
                        assert!(
                            !tuned.text.to_lowercase().contains("nan") && !tuned.text.contains("inf"),
                            "{}",
                            tuned.text
                        );
                        assert!(!tuned.trade_off.join(" ").contains("NaN"), "{:?}", tuned.trade_off);
                    }
                    Ok(Tuning::Impossible(impossible)) => {
                        let numbers = [impossible.rate, impossible.chattering];
                        assert!(
                            numbers.iter().flatten().all(|x| x.is_finite() && *x > 0.0),
                            "{path} {method}: {numbers:?}"
                        );
                        assert!(!impossible.reason.contains("NaN"), "{}", impossible.reason);
                    }
                    // What is wrong is wrong with the text as it was given, not with a proposal.
                    Err(error) => assert!(!error.to_string().contains("nan"), "{path} {method}: {error}"),
                }
            }
        }
    }
    assert!(proposed > 0);
}

#[test]
fn a_method_is_chosen_by_name_and_an_unknown_one_is_answered_with_those_there_are() -> Outcome {
    let mine = AnyScenario::parse("mine", JOINTS)?;
    let asked = |method: &str| mine.tuned(Some(method), TuneRequest { chattering: 0.1, rate: 1000.0 });
    let Tuning::Tuned(tuned) = asked("sliding-mode-implicit")? else { panic!("not possible") };
    assert_eq!(tuned.statement.method, "sliding-mode-implicit");
    assert!(matches!(asked("ideal"), Err(TuningError::Verify(VerifyError::NoClaims { .. }))));
    let refused = asked("slidng-mode");
    let Err(TuningError::Scenario(ScenarioError::UnknownMethod { known, .. })) = refused else { panic!("{refused:?}") };
    assert!(known.contains(&"sliding-mode"));
    Ok(())
}
