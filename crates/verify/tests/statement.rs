//! Bounds of a statement contain the values of a run, and there are some.

mod support;

use proptest::prelude::*;
use slideway_lab::Method;
use slideway_lab::conditioning::PathMethod;
use slideway_scenario::sweep::Setting;
use slideway_scenario::{AnyScenario, BUILT_IN};
use slideway_verify::{Guarantee, Observer, Statement};
use std::error::Error;
use support::statement;

type Outcome = Result<(), Box<dyn Error>>;

const FORMS: [Method; 3] = [Method::SlidingMode, Method::SlidingModeSynchronised, Method::SlidingModeImplicit];

fn built_in(name: &str) -> Result<AnyScenario, Box<dyn Error>> {
    Ok(AnyScenario::built_in(name).ok_or("no such scenario")??)
}

/// A scenario with values replaced.
fn changed(name: &str, settings: &[String]) -> Result<AnyScenario, Box<dyn Error>> {
    let mut document: toml::Table = built_in(name)?.text().parse()?;
    for setting in settings {
        Setting::parse(setting)?.apply(&mut document)?;
    }
    Ok(AnyScenario::parse(name, &document.to_string())?)
}

fn guarantee<'a>(statement: &'a Statement, name: &str) -> Result<&'a Guarantee, Box<dyn Error>> {
    let found = statement.guarantees.iter().find(|g| g.name == name);
    Ok(found.ok_or_else(|| format!("no guarantee `{name}` for {}", statement.method))?)
}

/// Every measured value inside, and where every hypothesis holds something is guaranteed and measured.
fn contains_what_it_measured(name: &str, statement: &Statement) {
    for g in &statement.guarantees {
        assert!(g.measured.is_none_or(|value| g.contains(value)), "{name} {}: {g:?}", statement.method);
        assert!(g.upper.is_some_and(f64::is_finite), "{name}: {g:?}");
        assert!(
            g.rests_on.iter().all(|h| statement.hypotheses.iter().any(|one| one.name == *h && one.holds())),
            "{g:?}"
        );
    }
    if statement.accepts() {
        assert!(statement.guarantees.iter().any(|g| g.measured.is_some()), "{name} {}", statement.method);
    }
}

fn runs_inside_its_bounds_in_every_form(wanted: impl Fn(&str) -> bool) -> Outcome {
    let speed = |b: &&slideway_scenario::BuiltIn| {
        matches!(AnyScenario::parse(b.name, b.text), Ok(AnyScenario::Speed(_))) && wanted(b.name)
    };
    for b in BUILT_IN.iter().filter(speed) {
        let scenario = AnyScenario::parse(b.name, b.text)?;
        contains_what_it_measured(b.name, &statement(&scenario, None)?);
        let judged = scenario.subject(None)?.method();
        for method in FORMS.into_iter().filter(|form| form.name() != judged || b.name.contains("acceleration")) {
            let statement = statement(&scenario, Some(method.name()))?;
            contains_what_it_measured(b.name, &statement);
            guarantee(&statement, "demand")?;
        }
    }
    Ok(())
}

#[test]
fn helices_run_inside_their_bounds() -> Outcome {
    runs_inside_its_bounds_in_every_form(|name| name.starts_with("puma"))
}

#[test]
fn planar_and_natural_scenarios_run_inside_their_bounds() -> Outcome {
    runs_inside_its_bounds_in_every_form(|name| name.starts_with("planar") || name.starts_with("natural"))
}

#[test]
fn every_other_speed_scenario_runs_inside_its_bounds() -> Outcome {
    let others = |name: &str| !["puma", "planar", "natural"].iter().any(|start| name.starts_with(start));
    runs_inside_its_bounds_in_every_form(others)
}

#[test]
fn every_built_in_conditioning_scenario_runs_inside_its_bounds() -> Outcome {
    for b in BUILT_IN.iter().filter(|b| matches!(AnyScenario::parse(b.name, b.text), Ok(AnyScenario::Conditioning(_))))
    {
        let scenario = AnyScenario::parse(b.name, b.text)?;
        for method in [PathMethod::SlidingMode, PathMethod::SlidingModeImplicit] {
            let statement = statement(&scenario, Some(method.name()))?;
            contains_what_it_measured(b.name, &statement);
            assert!(statement.accepts(), "{}", b.name);
            // Shapes are decimetres in size; a bound of half a centimetre says something.
            let penetration = guarantee(&statement, "penetration")?.upper.unwrap_or(f64::NAN);
            assert!(penetration < 5e-3, "{} {penetration}", b.name);
        }
    }
    Ok(())
}

#[test]
fn the_bounds_of_the_fair_race_are_close() -> Outcome {
    for method in FORMS {
        let statement = statement(&built_in("puma-helix-on-path")?, Some(method.name()))?;
        assert!(statement.accepts());
        assert!(guarantee(&statement, "demand")?.upper.is_some_and(|bound| bound < 1.1));
        let time = guarantee(&statement, "time-over-optimum")?;
        let (lower, upper) = (time.lower.unwrap_or(f64::NAN), time.upper.unwrap_or(f64::NAN));
        assert!(lower > 0.95 && upper < 1.05 && time.measured.is_some(), "{time:?}");
    }
    Ok(())
}

#[test]
fn a_filter_too_slow_for_the_path_is_rejected_with_a_number_that_is_accepted() -> Outcome {
    for (name, slow) in [("puma-helix", 1.5), ("planar-line", 4.0)] {
        let stated = statement(&changed(name, &[format!("control.bandwidth={slow}")])?, None)?;
        let drift = stated.hypotheses.iter().find(|h| h.name == "drift-against-filter").ok_or("not stated")?;
        assert!(!drift.holds() && !stated.accepts());
        let remedy = drift.remedy.as_deref().ok_or("no remedy")?;
        let number = remedy.strip_prefix("`control.bandwidth`: at least ").ok_or("no number")?;
        assert!(number.parse::<f64>()? > slow);
        let mended = statement(&changed(name, &[format!("control.bandwidth={number}")])?, None)?;
        assert!(mended.accepts(), "{name} {number}: {:?}", mended.hypotheses);
    }
    Ok(())
}

#[test]
fn a_target_rate_below_what_the_limits_allow_is_rejected_with_a_number_that_is_accepted() -> Outcome {
    let slow = statement(&changed("puma-helix-on-path", &["control.target_rate=1.8".into()])?, None)?;
    let target = slow.hypotheses.iter().find(|h| h.name == "target-rate").ok_or("not stated")?;
    let number = target.remedy.as_deref().and_then(|r| r.rsplit(' ').next()).ok_or("no number")?;
    let mended = changed("puma-helix-on-path", &[format!("control.target_rate={number}")])?;
    assert!(!slow.accepts() && statement(&mended, None)?.accepts());
    // The reference that is never held back by the limits has no bracket of its time.
    assert!(guarantee(&slow, "travel-time").is_err());
    Ok(())
}

#[test]
fn a_push_that_the_drift_beats_is_rejected_with_a_number_that_is_accepted() -> Outcome {
    let text = BUILT_IN.iter().find(|b| b.name == "helix-plane-sphere").ok_or("built in")?.text;
    let with = |amplitude: &str| -> Result<Statement, Box<dyn Error>> {
        let mut document: toml::Table = text.parse()?;
        Setting::parse(&format!("conditioner.law.normalised.amplitude={amplitude}"))?.apply(&mut document)?;
        let scenario = AnyScenario::parse("helix-plane-sphere", &document.to_string())?;
        statement(&scenario, None)
    };
    let weak = with("0.04")?;
    let share = weak.hypotheses.iter().find(|h| h.name == "push-share").ok_or("not stated")?;
    let number = share.remedy.as_deref().and_then(|r| r.rsplit(' ').next()).ok_or("no number")?;
    assert!(!weak.accepts() && guarantee(&weak, "phi").is_err());
    assert!(with(number)?.accepts(), "{number}");
    Ok(())
}

/// A reference that begins 9.5 mm behind a wall and goes on away from it does nothing to help, and the push is a hundredth of the example's:
/// the way back is as slow as the recovery rate lets it, 9.5 mm of the 10 that the bound is stated for.
#[test]
fn from_outside_a_conditioner_is_back_in_the_stated_time_and_uses_it() -> Outcome {
    let text = BUILT_IN.iter().find(|b| b.name == "helix-plane-sphere").ok_or("built in")?.text;
    for (method, keys) in [
        (PathMethod::SlidingModeImplicit, "recovery_rate = 0.5\nmargin = { fixed = [0.002, 0.001] }"),
        (PathMethod::SlidingMode, "reserve_rate = 0.5\nmargin = \"band\""),
    ] {
        let text = text.replace("offset = 0 ", "offset = -0.1845 ").replace("amplitude = 0.1", "amplitude = 0.001");
        let text = text.replace("push_cutoff = 20", &format!("push_cutoff = 20\n{keys}"));
        let statement = statement(&AnyScenario::parse("outside", &text)?, Some(method.name()))?;
        let recovery = guarantee(&statement, "recovery")?;
        let (bound, measured) = (recovery.upper.ok_or("bounded")?, recovery.measured.ok_or("measured")?);
        assert!(measured <= bound && measured >= 0.9 * bound, "{method:?}: {measured} {bound}");
    }
    // Without a reserve the explicit form pushes as it does inside, and promises no time.
    let plain = statement(&AnyScenario::parse("plain", text)?, None)?;
    assert!(guarantee(&plain, "recovery").is_err());
    Ok(())
}

#[test]
fn an_observer_reads_from_a_run_what_the_statement_says_was_measured() -> Outcome {
    let scenario = built_in("puma-helix")?;
    let AnyScenario::Speed(speed) = &scenario else { return Err("about speed".into()) };
    let experiment = speed.experiment()?;
    for method in FORMS {
        let statement = statement(&scenario, Some(method.name()))?;
        let seen = Observer::for_speed(&experiment, method, scenario.grid_points())?.speed(&experiment.run(method)?);
        for g in &statement.guarantees {
            assert_eq!(seen.guarantee(&g.name), g.measured, "{}", g.name);
        }
        let run = statement.hypotheses.iter().filter_map(|h| Some((h, seen.hypothesis(&h.name)?)));
        assert!(run.clone().count() >= 8 && run.into_iter().all(|(h, value)| h.value == value));
        assert!(statement.outside(&seen).is_empty());
    }
    Ok(())
}

/// A path of two joints through three points, with limits, filter and gain of any kind that the scenario accepts.
fn joint_scenario(points: &[[f64; 2]; 3], limits: [f64; 2], step: f64, gain_step: f64, target: f64) -> String {
    let [p, q, r] = points;
    let period = 1e-3;
    format!(
        "description = \"random\"\n[robot]\nmodel = \"planar-2r\"\ntask = \"planar-position\"\n\
         [path.joints.spline]\npoints = [{p:?}, {q:?}, {r:?}]\n[limits]\nspeed = {limits:?}\n\
         [control]\ngain = {}\nsampling_period = {period}\nbandwidth = {}\ntarget_rate = {target}\n\
         [optimum]\ngrid_points = 200\n",
        gain_step / period,
        step / period
    )
}

/// Five samples from end to end at a rate that the limits do not allow: the last, cut short, is scaled by none of them.
#[test]
fn a_synchronised_reference_of_a_few_samples_ends_inside_its_bounds() -> Outcome {
    let text = "[robot]\ndh = [{ a = 0.6, alpha = 0, d = 0 }, { a = 0.5, alpha = 0, d = 0 }]\n\
                [path]\njoints.line = { from = [0.489384, -0.940052], to = [0.443617, -0.903177] }\n\
                [limits]\nspeed = [1.70189, 0.352911]\n\
                [control]\ngain = 10\nsampling_period = 0.0204267\nbandwidth = 14.6867\ntarget_rate = 510.689\n";
    let statement = statement(&AnyScenario::parse("short", text)?, Some(Method::SlidingModeSynchronised.name()))?;
    let time = guarantee(&statement, "reference-time")?;
    // It does end before what a whole sample would take.
    assert!(time.measured.is_some_and(|t| time.contains(t) && t < time.lower.unwrap_or(0.0) + 0.0204267), "{time:?}");
    contains_what_it_measured("short", &statement);
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_joint_paths_run_inside_their_bounds(
        points in proptest::array::uniform3(proptest::array::uniform2(-1.0..1.0)),
        limits in proptest::array::uniform2(0.5..3.0),
        step in 0.005..0.5,
        gain_step in 0.005..0.2,
        target in 2.0..20.0,
        method in 0..3_usize,
    ) {
        // A path that turns back in a joint at a point where the other stands still has no rate there.
        let far = |a: &[f64; 2], b: &[f64; 2]| (a[0] - b[0]).abs().min((a[1] - b[1]).abs()) > 0.1;
        prop_assume!(far(&points[0], &points[1]) && far(&points[1], &points[2]));
        let text = joint_scenario(&points, limits, step, gain_step, target);
        let scenario = AnyScenario::parse("random", &text).expect("a scenario");
        let statement = statement(&scenario, Some(FORMS[method].name())).expect("a statement");
        for g in &statement.guarantees {
            prop_assert!(g.measured.is_none_or(|value| g.contains(value)), "{g:?}\n{text}");
        }
        prop_assert!(statement.guarantees.iter().any(|g| g.name == "demand"));
    }
}
