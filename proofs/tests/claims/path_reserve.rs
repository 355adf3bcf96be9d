use proptest::prelude::{prop_assert, prop_assume, proptest};
use proptest::test_runner::TestCaseError;
use slideway_conditioner::PathConditioner;
use slideway_conditioner::path::{
    Constraint, ConstraintSample, Margin, Motion, PathForm, PathOutcome, PathSettings, Reserve, SwitchingLaw,
    TrapPhase, TrapSettings, Walk,
};
use slideway_conditioner::shapes::{BoothOval, Ellipsoid, HalfSpace, Side};
use slideway_proofs::path_reserve::CLAIM;

use crate::path_support::{PERIOD, RECOVERY, explicit, norm, per_push, runs, settings, sketch, swing, triple};
use crate::support::{Outcome, counterexample, holds, proven};

#[test]
fn negation_has_no_model() -> Outcome {
    proven(&CLAIM)
}

fn with_reserve(amplitude: f64) -> PathForm {
    let law = SwitchingLaw::Normalised { amplitude };
    PathForm::Sliding { law, reserve: Reserve::On { recovery_rate: RECOVERY } }
}

/// `φ` after one sample from `phi`, with a drift that the push does not beat.
fn next_phi(form: PathForm, phi: f64, drift: f64) -> Result<f64, Box<dyn std::error::Error>> {
    let conditioner = PathConditioner::<1, 1>::new(settings(form))?;
    let wall = HalfSpace::new(&[1.0], 0.0)?;
    let mut state = conditioner.on_reference();
    let mut at = |place: f64| {
        let reference = Motion { time: 0.0, position: [place], velocity: [0.0] };
        conditioner.step(&mut state, &reference, |m| [wall.sample(m)]).phi[0]
    };
    assert_eq!(at(phi), phi);
    Ok(at(phi + drift))
}

fn band_is_left_without_the_reserve_only(phi: f64, drift: f64, band: f64) -> Outcome {
    let amplitude = band / per_push();
    assert!(next_phi(explicit(amplitude), phi, drift)? > band + 0.04);
    // Rounding of a dozen operations on numbers below 2.
    assert!(next_phi(with_reserve(amplitude), phi, drift)? <= band + 1e-14);
    Ok(())
}

#[test]
fn without_the_reserve_a_drift_beats_the_push() -> Outcome {
    band_is_left_without_the_reserve_only(0.1, 0.5, 0.2)?;
    let model = counterexample(&CLAIM, "reserve")?;
    band_is_left_without_the_reserve_only(model.value("phi")?, model.value("D")?, model.value("band")?)
}

/// Excess of `φ` over the band, sample by sample: never more than the recovery leaves of the excess before.
struct Ledger<const M: usize> {
    beyond: [f64; M],
    amplitude: f64,
}

impl<const M: usize> Ledger<M> {
    fn new(amplitude: f64) -> Self {
        Self { beyond: [f64::INFINITY; M], amplitude }
    }

    /// Rounding: 1e-12 of positions and velocities of the order of 1 to 10.
    fn see(&mut self, phi: &[f64; M], samples: &[ConstraintSample<3>; M]) -> Result<(), TestCaseError> {
        for i in 0..M {
            let push = per_push() * self.amplitude * norm(&samples[i].gradient);
            let beyond = phi[i] - push;
            let left = (self.beyond[i] - RECOVERY * PERIOD).max(0.0);
            prop_assert!(beyond <= left + 1e-11, "{beyond:e} above the band, {left:e} allowed");
            self.beyond[i] = beyond;
        }
        Ok(())
    }
}

fn walk_settings(seed: u64, amplitude: f64) -> PathSettings<1> {
    PathSettings {
        margin: Margin::Band,
        trap: Some(TrapSettings {
            walk_cutoff: 20.0,
            pace_cutoff: 20.0,
            walk: Walk::Safe { push_share: 0.5 },
            walk_speed: 2.0,
            walk_growth: 2.0,
            return_gain: 5.0,
            direction_period: 0.1,
            distance_threshold: 0.05,
            clearance_threshold: 0.02,
            activity_threshold: 0.01,
            seed,
        }),
        ..settings(with_reserve(amplitude))
    }
}

proptest! {
    #![proptest_config(runs())]

    // Pushes from far too small to ample, and starts with velocity.
    #[test]
    fn one_wall_or_ball_keeps_its_band(swing in swing(), one in sketch(3), amplitude in 0.01..3.0) {
        let body = one.around(&swing.at(0));
        prop_assume!(body.is_some());
        let body = body.expect("assumed");
        let conditioner = PathConditioner::<3, 1>::new(settings(with_reserve(amplitude)))?;
        let mut state = conditioner.on_reference();
        let mut ledger = Ledger::<1>::new(amplitude);
        let mut helped = 0;
        for k in 0..600 {
            let step = conditioner.step(&mut state, &swing.at(k), |m| [body.sample(m)]);
            helped += u32::from(step.outcome == PathOutcome::Reserve);
            prop_assert!(!matches!(step.outcome, PathOutcome::Held(_)), "{:?}", step.outcome);
            ledger.see(&step.phi, &[body.sample(&step.motion)])?;
        }
        // Only runs in which the push was not enough count.
        prop_assume!(helped > 0);
    }

    // Where the rows depend on one another the sample is held: at rest, and the band is not asked about.
    #[test]
    fn pairs_keep_their_bands(swing in swing(), one in sketch(3), two in sketch(3), amplitude in 0.01..3.0) {
        let start = swing.at(0);
        let (first, second) = (one.around(&start), two.around(&start));
        prop_assume!(first.is_some() && second.is_some());
        let bodies = [first.expect("assumed"), second.expect("assumed")];
        let conditioner = PathConditioner::<3, 2>::new(settings(with_reserve(amplitude)))?;
        let mut state = conditioner.on_reference();
        let mut ledger = Ledger::<2>::new(amplitude);
        for k in 0..600 {
            let step = conditioner.step(&mut state, &swing.at(k), |m| bodies.each_ref().map(|body| body.sample(m)));
            if matches!(step.outcome, PathOutcome::Held(_)) {
                prop_assert!(step.motion.velocity == [0.0; 3]);
                ledger = Ledger::new(amplitude);
            } else {
                ledger.see(&step.phi, &bodies.each_ref().map(|body| body.sample(&step.motion)))?;
            }
        }
    }

    // Behind an ellipsoid or an oval, walking: with the margin of the band φ stays at or below zero.
    #[test]
    fn the_safe_walk_never_breaks_its_constraint(
        axes in triple(0.1..0.8),
        oval in proptest::bool::ANY,
        seed in proptest::prelude::any::<u64>(),
        amplitude in 0.5..3.0,
        above in 0.02..0.1,
        behind in 0.05..0.4,
    ) {
        let ellipsoid = Ellipsoid::new([0.0; 3], &axes, 0.1, Side::Outside)?;
        let booth = BoothOval::new(axes.map(|a| 0.25 / a), 0.3, Side::Outside)?;
        let sample = |m: &Motion<3>| [if oval { booth.sample(m) } else { ellipsoid.sample(m) }];
        // The highest point of either body on the third axis.
        let top = if oval { 0.3 * 0.25 / axes[2] } else { axes[2] };
        let conditioner = PathConditioner::<3, 1>::new(walk_settings(seed, amplitude))?;
        let mut state = conditioner.at_rest(&[0.0, 0.0, top + above])?;
        let reference = Motion { time: 0.0, position: [0.0, 0.0, -top - behind], velocity: [0.0; 3] };
        let mut walked = 0;
        let mut inside = false;
        for _ in 0..1500 {
            let step = conditioner.step(&mut state, &reference, sample);
            prop_assert!(!matches!(step.outcome, PathOutcome::Held(_)), "{:?}", step.outcome);
            walked += u32::from(step.trap == TrapPhase::Walking);
            // A start nearer than the band counts as outside until it is regained.
            inside = inside || step.phi[0] <= 0.0;
            prop_assert!(!inside || step.phi[0] <= 1e-11, "φ = {:e}", step.phi[0]);
            prop_assert!(step.sigma[0] <= 0.0, "σ = {:e}", step.sigma[0]);
        }
        // Only runs that did walk count.
        prop_assume!(walked > 0);
    }
}

#[test]
fn shipped_code_keeps_it_over_random_cases() -> Outcome {
    holds(&CLAIM)
}
