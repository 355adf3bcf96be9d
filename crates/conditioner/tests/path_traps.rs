//! Examples 9.2 to 9.4 of [G12]: traps, and the walk out of them.

mod support;

use slideway_conditioner::PathConditioner;
use slideway_conditioner::path::{
    Constraint, ConstraintSample, Margin, Motion, PathForm, PathOutcome, PathSettings, Reserve, SwitchingLaw,
    TrapPhase, TrapSettings, Walk,
};
use slideway_conditioner::shapes::HalfSpace;
use support::{Path, booth_oval, helix, one_ellipsoid, run, trap_example, two_ellipsoids, wave};

/// The longest a run may take: the independent simulation needed 5.1 s of waiting at most.
const LIMIT: f64 = 30.0;

/// One run: how long the reference waited, and the largest `σ`.
struct Escape {
    waited: f64,
    sigma: f64,
    escaped: bool,
}

fn escape<const M: usize>(
    settings: PathSettings<M>,
    path: Path,
    constraints: fn(&Motion<3>) -> [ConstraintSample<3>; M],
) -> Escape {
    let mut out = Escape { waited: 0.0, sigma: f64::NEG_INFINITY, escaped: false };
    let mut last = TrapPhase::Following;
    let mut end = 0.0;
    run(settings, path, constraints, LIMIT, |reference, step| {
        assert!(!matches!(step.outcome, PathOutcome::Held(_)), "held at {} s", reference.time);
        if step.trap != TrapPhase::Following {
            out.waited += settings.sampling_period;
        }
        out.sigma = step.sigma.iter().fold(out.sigma, |a, &b| a.max(b));
        (last, end) = (step.trap, reference.time);
    });
    out.escaped = end < LIMIT - 1.0 && last == TrapPhase::Following && out.waited > 0.0;
    out
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn assert_median<const M: usize>(
    expected: f64,
    path: Path,
    constraints: fn(&Motion<3>) -> [ConstraintSample<3>; M],
    walk_speed: f64,
) {
    let runs: Vec<Escape> =
        (0..200).map(|seed| escape(trap_example::<M>(Walk::Paper, walk_speed, seed), path, constraints)).collect();
    assert!(runs.iter().all(|run| run.escaped), "a seed did not escape");
    let found = median(runs.iter().map(|run| run.waited).collect());
    assert!((found - expected).abs() <= 0.15 * expected, "median {found} s, expected {expected} s within 15 %");
}

#[test]
fn every_seed_escapes_one_ellipsoid_in_the_time_of_the_independent_simulation() {
    assert_median(1.36, helix, one_ellipsoid, 2.0);
}

#[test]
fn every_seed_escapes_two_ellipsoids_in_the_time_of_the_independent_simulation() {
    assert_median(1.20, wave, two_ellipsoids, 2.0);
}

#[test]
fn every_seed_escapes_the_oval_in_the_time_of_the_independent_simulation() {
    assert_median(1.56, helix, booth_oval, 5.0);
}

#[test]
fn the_walk_of_the_paper_breaks_the_oval_in_some_seeds() {
    let broken =
        (0..200).filter(|&seed| escape(trap_example::<1>(Walk::Paper, 5.0, seed), helix, booth_oval).sigma > 0.0);
    let share = broken.count() as f64 / 200.0;
    assert!((0.02..=0.12).contains(&share), "the independent simulation says 5 to 10 %, here {share}");
}

fn safe(seed: u64) -> PathSettings<1> {
    let law = SwitchingLaw::Normalised { amplitude: 1.6 };
    PathSettings {
        form: PathForm::Sliding { law, reserve: Reserve::On { recovery_rate: 1.0 } },
        margin: Margin::Band,
        ..trap_example(Walk::Safe { push_share: 0.4 }, 5.0, seed)
    }
}

#[test]
fn the_safe_walk_escapes_the_oval_and_never_breaks_it() {
    let runs: Vec<Escape> = (0..200).map(|seed| escape(safe(seed), helix, booth_oval)).collect();
    assert!(runs.iter().all(|run| run.escaped), "a seed did not escape");
    let worst = runs.iter().map(|run| run.sigma).fold(f64::NEG_INFINITY, f64::max);
    assert!(worst <= 0.0, "σ reached {worst}");
    let found = median(runs.iter().map(|run| run.waited).collect());
    assert!(found <= 2.0, "median {found} s");
}

#[test]
fn the_safe_walk_feels_a_boundary_as_soon_as_it_is_within_its_band() {
    let wall = HalfSpace::new(&[1.0, 0.0, 0.0], 0.0).expect("a normal");
    let phase = |settings: PathSettings<1>, away: f64| {
        let trap = settings.trap.map(|trap| TrapSettings { activity_threshold: 1e-3, ..trap });
        let conditioner = PathConditioner::<3, 1>::new(PathSettings { trap, ..settings }).expect("valid settings");
        let mut state = conditioner.at_rest(&[-away, 0.0, 0.0]).expect("a finite position");
        let reference = Motion { time: 0.0, position: [-1.0, 0.0, 0.0], velocity: [0.0; 3] };
        conditioner.step(&mut state, &reference, |motion| [wall.sample(motion)]).trap
    };
    let safe = |away| phase(PathSettings { margin: Margin::None, ..safe(1) }, away);
    // One full push is T α1² K U = 2e-4 * 400 * 0.05 * 1.6 = 6.4 mm, wider than the 1 mm that were set.
    assert_eq!((safe(6e-3), safe(7e-3)), (TrapPhase::Walking, TrapPhase::Returning));
    // The walk of the paper takes the threshold as it is.
    assert_eq!(phase(trap_example(Walk::Paper, 5.0, 1), 6e-3), TrapPhase::Returning);
    assert_eq!(phase(trap_example(Walk::Paper, 5.0, 1), 5e-4), TrapPhase::Walking);
}

#[test]
fn without_a_walk_the_reference_stays_trapped() {
    // The slowest walk there is: one that covers a micrometre in the whole run.
    let mut settings = trap_example::<1>(Walk::Paper, 1e-7, 1);
    settings.trap = settings.trap.map(|trap| TrapSettings { walk_growth: 0.0, ..trap });
    assert!(!escape(settings, helix, one_ellipsoid).escaped);
}

#[test]
fn equal_seeds_walk_equally() {
    let positions = |seed| {
        let mut all = Vec::new();
        run(trap_example::<1>(Walk::Paper, 2.0, seed), helix, one_ellipsoid, 4.0, |_, step| {
            all.push(step.motion.position);
        });
        all
    };
    assert_eq!(positions(3), positions(3));
    assert_ne!(positions(3), positions(4));
}
