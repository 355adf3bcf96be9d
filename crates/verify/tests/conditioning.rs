//! What is stated of a path conditioner holds in runs and trials of scenarios of any kind, or it is not stated.

use proptest::prelude::*;
use slideway_lab::conditioning::PathMethod;
use slideway_scenario::ConditioningScenario;
use slideway_verify::{Campaign, CampaignRequest, Statement, TuneOutcome, TuneRequest, tune};

/// A reference that swings through the origin, the constraints, and lines of the table `[conditioner]`.
fn scenario(constraints: &str, lines: &str) -> String {
    format!(
        "[reference]\nend = 2\nrate = 1\nposition.formula = {{ x = \"0.2 * sin(2 * lambda)\", y = \"0.15 - 0.15 * lambda\", z = \"0.1 * lambda\" }}\n\
         {constraints}\n[conditioner]\nsampling_period = 1e-3\npush_cutoff = 20\n{lines}\n"
    )
}

fn constraint(name: &str, approach: f64, shape: &str) -> String {
    format!("[[constraint]]\nname = \"{name}\"\napproach = {approach}\nshape.{shape}\n")
}

fn statement(text: &str, method: PathMethod) -> Statement {
    let scenario = ConditioningScenario::parse("mine", text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    Statement::for_conditioning(&scenario, Some(method)).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn upper(statement: &Statement, name: &str) -> Option<f64> {
    statement.guarantees.iter().find(|g| g.name == name)?.upper
}

fn kept(text: &str, method: PathMethod, trials: u64) -> Result<(), TestCaseError> {
    let stated = statement(text, method);
    let violated: Vec<_> = stated.violated().collect();
    prop_assert!(violated.is_empty(), "{method:?}: {violated:?}\n{text}");
    let request = CampaignRequest {
        name: "mine".into(),
        text: text.into(),
        file: None,
        method: Some(method.name().into()),
        seed: 5,
        trials,
    };
    let campaign = Campaign::new(request).expect("valid");
    for number in 0..trials {
        let trial = campaign.trial(number).expect("runs");
        prop_assert!(trial.kept(), "{method:?} {number}: {:?} in {trial:?}\n{text}", trial.violated());
    }
    Ok(())
}

/// Contact is at `φ = -m`: rises have to be looked for there, however large the margin is beside a push.
#[test]
fn a_margin_of_many_pushes_has_its_rise_and_is_kept() {
    let wall = constraint("wall", 0.1, "half-space = { normal = [1, 0, 0], offset = 0.1 }");
    let text = scenario(&wall, "law.normalised.amplitude = 0.3\nmargin = { fixed = [0.05] }");
    for method in [PathMethod::SlidingMode, PathMethod::SlidingModeImplicit] {
        assert!(kept(&text, method, 8).is_ok());
    }
    let stated = statement(&text, PathMethod::SlidingMode);
    let rise = stated.hypotheses.iter().find(|h| h.name == "rise").expect("stated");
    assert!(rise.value > 0.0 && upper(&stated, "phi").is_some_and(|phi| phi < 0.0), "{rise:?}");
}

/// The band of the sum law counts every constraint, those that do not act too.
#[test]
fn the_band_of_a_reserve_is_the_longest_push_of_its_law() {
    let near = constraint("near", 0.05, "half-space = { normal = [1, 0, 0], offset = 0.02 }");
    let far = constraint("far", 0.5, "half-space = { normal = [0, 0, 1], offset = 1 }");
    let with = |constraints: &str| {
        let text = scenario(constraints, "law.sum.gain = 0.001\nreserve_rate = 1");
        assert!(kept(&text, PathMethod::SlidingMode, 8).is_ok());
        upper(&statement(&text, PathMethod::SlidingMode), "phi").expect("stated")
    };
    assert!(with(&format!("{near}{far}")) > 5.0 * with(&near));
}

const OPPOSED: [&str; 2] = ["x", "3 * (-0.8*x - 0.6*y)"];

#[test]
fn a_push_that_drives_a_constraint_outwards_has_lost_and_is_not_tuned() {
    let [a, b] = OPPOSED.map(|formula| constraint(&formula[..1], 0.1, &format!("formula = \"{formula}\"")));
    let text = scenario(&format!("{a}{b}"), "law.normalised.amplitude = 0.15").replace("0.2 * sin(2 * lambda)", "0");
    let stated = statement(&text, PathMethod::SlidingMode);
    let share = stated.hypotheses.iter().find(|h| h.name == "push-share").expect("stated");
    assert!(share.value == f64::INFINITY && !share.holds() && !stated.accepts());
    assert!(upper(&stated, "phi").is_none() && upper(&stated, "chattering").is_none());
    assert!(share.remedy.as_deref().is_some_and(|remedy| remedy.contains("reserve_rate")), "{share:?}");
    let request = TuneRequest {
        name: "mine".into(),
        text: text.clone(),
        file: None,
        method: None,
        chattering: 0.05,
        rate: 2000.0,
    };
    assert!(matches!(tune(&request), Ok(TuneOutcome::Impossible(_))));
    // With what the remedy says it holds.
    let text = text.replace("push_cutoff", "reserve_rate = 1\npush_cutoff");
    assert!(kept(&text, PathMethod::SlidingMode, 4).is_ok() && statement(&text, PathMethod::SlidingMode).accepts());
}

#[test]
fn no_chattering_is_stated_of_runs_that_the_reserve_answers() {
    let wall = constraint("wall", 0.02, "half-space = { normal = [1, 0, 0], offset = 0.1 }");
    let with = |amplitude: f64| {
        let text = scenario(&wall, &format!("law.normalised.amplitude = {amplitude}\nreserve_rate = 1"));
        upper(&statement(&text, PathMethod::SlidingMode), "chattering")
    };
    assert!(with(0.002).is_none() && with(0.4).is_some());
}

#[test]
fn a_start_outside_bounds_what_follows() {
    let wall = constraint("wall", 0.05, "half-space = { normal = [1, 0, 0], offset = -0.008 }");
    for (method, lines) in [
        (PathMethod::SlidingModeImplicit, "recovery_rate = 0.01\nlaw.normalised.amplitude = 0.1"),
        (PathMethod::SlidingMode, "law.normalised.amplitude = 0.001\nreserve_rate = 0.01"),
    ] {
        // The reference itself begins 8 mm outside, with a velocity that leads farther out.
        let text = scenario(&wall, lines);
        kept(&text, method, 8).unwrap_or_else(|error| panic!("{method:?} {error}"));
        assert!(upper(&statement(&text, method), "phi").is_some_and(|phi| phi > 0.008));
        // What is seen too high at first may be seen too low afterwards.
        let noisy = format!("{text}\n[verify]\ninitial_error = 0\ndelay = 0\njitter = 0\ndistance_noise = 1e-3\n");
        kept(&noisy, method, 30).unwrap_or_else(|error| panic!("{method:?} {error}"));
    }
}

fn shape() -> impl Strategy<Value = String> {
    let unit = |angle: f64, tilt: f64| [tilt.cos() * angle.cos(), tilt.cos() * angle.sin(), tilt.sin()];
    prop_oneof![
        (0.0..6.2, -1.5..1.5, 0.02..0.15).prop_map(move |(angle, tilt, offset)| {
            format!("half-space = {{ normal = {:?}, offset = {offset} }}", unit(angle, tilt))
        }),
        (proptest::array::uniform3(-0.2..0.2), 0.03..0.15).prop_map(|(centre, radius)| {
            format!("sphere = {{ centre = {centre:?}, radius = {radius}, side = \"outside\" }}")
        }),
    ]
}

fn law() -> impl Strategy<Value = String> {
    prop_oneof![
        (-3.0..0.0).prop_map(|decade| format!("law.normalised.amplitude = {}", 10f64.powf(decade))),
        (-3.5..-1.0).prop_map(|decade| format!("law.sum.gain = {}", 10f64.powf(decade))),
    ]
}

fn lines(count: usize) -> impl Strategy<Value = String> {
    let margin = prop_oneof![
        Just("margin = \"none\"".to_owned()),
        Just("margin = \"band\"".to_owned()),
        (0.0005..0.03).prop_map(move |margin: f64| format!("margin = {{ fixed = {:?} }}", vec![margin; count])),
    ];
    let reserve = prop_oneof![Just(String::new()), (0.1..2.0).prop_map(|rate: f64| format!("reserve_rate = {rate}"))];
    (law(), margin, reserve).prop_map(|(law, margin, reserve)| format!("{law}\n{margin}\n{reserve}"))
}

fn any_scenario() -> impl Strategy<Value = String> {
    (1..3_usize).prop_flat_map(|count| (proptest::collection::vec((shape(), 0.01..0.3), count), lines(count))).prop_map(
        |(shapes, lines)| {
            let one = |(i, (shape, approach)): (usize, &(String, f64))| constraint(&format!("c{i}"), *approach, shape);
            scenario(&shapes.iter().enumerate().map(one).collect::<String>(), &lines)
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_scenarios_keep_what_is_stated_of_them(text in any_scenario(), implicit in 0..2) {
        let method = if implicit == 0 { PathMethod::SlidingMode } else { PathMethod::SlidingModeImplicit };
        kept(&text, method, 3)?;
    }
}
