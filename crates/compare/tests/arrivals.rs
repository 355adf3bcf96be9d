//! A conditioning verdict says "Yes" only of a point that arrives: random scenes beside a run of its own.

use slideway_compare::{ConditioningComparison, ConditioningOptions, compare_conditioning, unwatched};
use slideway_conditioner::path::{Constraint, Motion};
use slideway_lab::conditioning::{ConditioningProblem, PathMethod, run_conditioner};
use slideway_scenario::ConditioningScenario;

/// Numbers in [0, 1), the same at every run.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        // splitmix64
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// One to three balls, walls and boxes along a line of a metre, some exactly in the way.
fn scene(numbers: &mut Numbers, hold: f64) -> String {
    let mut text = format!(
        "[reference]\nend = {}\nrate = 0.5\nposition.formula = {{ x = \"min(lambda, 1)\", y = \"0\", z = \"0\" }}\n\
         [conditioner]\nsampling_period = 2e-3\npush_cutoff = 20\nlaw.normalised.amplitude = 0.1\nreserve_rate = 1\nmargin = \"band\"\n",
        1.0 + hold
    );
    for i in 0..1 + (numbers.next() * 3.0) as usize {
        let along = numbers.within(0.25, 1.1);
        let aside = if numbers.next() < 0.4 { 0.0 } else { numbers.within(-0.3, 0.3) };
        let size = numbers.within(0.05, 0.2);
        let shape = match (numbers.next() * 4.0) as usize {
            0 | 1 => format!("sphere = {{ centre = [{along}, {aside}, 0], radius = {size}, side = \"outside\" }}"),
            2 => format!(
                "half-space = {{ normal = [{}, 1, 0], offset = {} }}",
                numbers.within(-0.5, 1.0),
                numbers.within(0.05, 0.8)
            ),
            _ => format!(
                "box = {{ centre = [{along}, {aside}, 0], half_edges = [{size}, {}, 0.1], exponent = 8, scale = 0.1, side = \"outside\" }}",
                numbers.within(0.05, 0.2)
            ),
        };
        text += &format!("[[constraint]]\nname = \"c{i}\"\napproach = 0.1\nshape.{shape}\n");
    }
    text
}

fn problem(text: &str) -> Option<ConditioningProblem> {
    ConditioningScenario::parse("scene", text).and_then(|s| s.problem()).ok()
}

fn is_allowed(problem: &ConditioningProblem, position: [f64; 3]) -> bool {
    let motion = Motion { time: 0.0, position, velocity: [0.0; 3] };
    problem.constraints.iter().all(|c| c.sample(&motion).value <= 0.0)
}

/// Distance from a point to the nearest allowed one, along 1,000 rays, two millimetres at a time.
fn nearest(problem: &ConditioningProblem, from: [f64; 3]) -> f64 {
    let rays = 1000;
    let golden = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    let mut best = 3.0_f64;
    for i in 0..rays {
        let z = 1.0 - 2.0 * (f64::from(i) + 0.5) / f64::from(rays);
        let (round, turn) = ((1.0 - z * z).sqrt(), golden * f64::from(i));
        let direction = [round * turn.cos(), round * turn.sin(), z];
        let mut far = 0.0;
        while far < best && !is_allowed(problem, std::array::from_fn(|k| from[k] + far * direction[k])) {
            far += 2e-3;
        }
        best = best.min(far);
    }
    best
}

fn compare(problem: &ConditioningProblem) -> ConditioningComparison {
    let options = ConditioningOptions { divisors: Vec::new(), ..ConditioningOptions::default() };
    compare_conditioning(problem, &options, &mut unwatched).expect("runs")
}

#[test]
fn a_verdict_of_arrival_agrees_with_where_the_point_rests() {
    let count: u64 = std::env::var("SLIDEWAY_SCENES").ok().and_then(|n| n.parse().ok()).unwrap_or(300);
    let (mut arrived, mut stuck) = (0, 0);
    for seed in 0..count {
        let text = scene(&mut Numbers(seed), 0.0);
        let Some(problem_here) = problem(&text).filter(|p| is_allowed(p, [0.0; 3])) else { continue };
        let comparison = compare(&problem_here);
        let verdict = &comparison.summary.verdict;
        let entry =
            &comparison.summary.methods.iter().find(|m| m.summary.method == PathMethod::SlidingMode).expect("run");
        // A "no" names every cause that the numbers have, and none that they have not.
        let broken = entry.summary.max_sigma_m.iter().any(|sigma| *sigma > 0.0);
        for (words, is_so) in [
            ("broke `", broken),
            ("its point never arrived", entry.summary.completed && entry.arrival.arrives_after_s.is_none()),
            ("did not reach its end", !entry.summary.completed),
            ("it was held for", entry.summary.audit.held_share > 0.0),
            ("a trap held the point", entry.arrival.trapped_s > 0.0 && entry.summary.escape_s.is_none()),
        ] {
            assert_eq!(verdict.sentence.contains(words), is_so, "{seed}: {words}: {}", verdict.sentence);
        }
        assert_eq!(
            verdict.holds,
            !broken && entry.arrival.arrives_after_s.is_some() && entry.summary.audit.held_share == 0.0
        );
        // The truth: the same scene with the reference at rest at its end for three seconds, twenty time constants.
        let held = problem(&scene(&mut Numbers(seed), 1.5)).expect("the same scene");
        let trace = run_conditioner(&held, PathMethod::SlidingMode).expect("runs");
        let last = trace.samples.last().expect("samples");
        let excess = last.deviation() - nearest(&held, last.reference);
        // The rays see the nearest point to a few millimetres, the law stands off by its band (8 mm here): nothing is judged in between.
        let resolution = entry.arrival.resolution_m;
        if excess > resolution + 0.005 {
            stuck += 1;
            assert!(
                !verdict.holds && entry.arrival.arrives_after_s.is_none(),
                "{seed}: {excess} m off\n{}\n{text}",
                verdict.sentence
            );
        } else if excess < resolution - 0.005 || last.deviation() < 0.9e-3 {
            arrived += 1;
            assert!(entry.arrival.arrives_after_s.is_some(), "{seed}: {excess} m off\n{}\n{text}", verdict.sentence);
        }
    }
    assert!(arrived > count / 3 && stuck > count / 10, "{arrived} arrived, {stuck} stuck of {count}");
}

#[test]
fn the_built_in_traps_without_their_trap_table_say_no_and_for_how_long() {
    for name in ["trap-ellipsoid", "trap-two-ellipsoids", "trap-booth-oval"] {
        let built_in = slideway_scenario::BUILT_IN.iter().find(|b| b.name == name).expect("built in").text;
        let without = &built_in[..built_in.find("[trap]").expect("a trap")];
        let comparison = compare(&problem(without).expect("valid"));
        let entry = &comparison.summary.methods[0];
        assert!(!comparison.summary.verdict.holds, "{name}: {}", comparison.summary.verdict.sentence);
        assert!(entry.arrival.trapped_s > 0.5, "{name}: {}", entry.arrival.trapped_s);
        let with = compare(&problem(built_in).expect("valid"));
        assert!(with.summary.verdict.holds, "{name}: {}", with.summary.verdict.sentence);
    }
}

#[test]
fn an_end_that_is_allowed_and_reachable_is_not_reached_from_before_a_ball() {
    let text = "
        [reference]
        end = 1
        rate = 0.5
        position.line = { from = [0, 0, 0], to = [1, 0, 0] }
        [[constraint]]
        name = 'ball'
        approach = 0.1
        shape.sphere = { centre = [0.5, 0, 0], radius = 0.2, side = 'outside' }
        [conditioner]
        sampling_period = 1e-3
        push_cutoff = 20
        law.normalised.amplitude = 0.1
        reserve_rate = 1
        margin = 'band'
    ";
    let comparison = compare(&problem(text).expect("valid"));
    let arrival = comparison.summary.methods[0].arrival;
    assert!(!comparison.summary.verdict.holds, "{}", comparison.summary.verdict.sentence);
    // From the last row: the point rests at x = 0.3.
    assert!((arrival.end_distance_m.expect("known") - 0.7).abs() < 0.01 && arrival.trapped_s > 0.3, "{arrival:?}");
}
