//! Collectors of the bounds on signals, against planted answers: every sum worked out from its definition for a few samples of two
//! joints with lopsided limits that shrink on the way.

use slideway_conditioner::bounds::{
    Progress, ProgressForm, ProgressSums, SignalBand, Signals, TravelInputs, implicit_chattering, travel_bracket,
};
use slideway_conditioner::{AffineSpeed, ParameterError, SpeedLimits};

/// Equal up to some roundings and the part in 1e12 that the bounds add for theirs.
fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-11 * b.abs()
}

fn wide() -> Result<SpeedLimits<2>, ParameterError> {
    SpeedLimits::new([-1.0, -4.0], [2.0, 2.0])
}

fn split(feedback: [f64; 2], feedforward: [f64; 2]) -> AffineSpeed<2> {
    AffineSpeed { feedback, feedforward }
}

fn assert_signals(found: Signals, expected: Signals) {
    let list = |s: Signals| {
        let Signals { feedback, overspeed, rise, surplus, released_change, braked_change, demand_change, start } = s;
        [feedback, overspeed, rise, surplus, released_change, braked_change, demand_change, start]
    };
    assert!(list(found).iter().zip(list(expected)).all(|(f, e)| close(*f, e)), "{found:?} instead of {expected:?}");
}

/// A run with every kind of sample: before the start, released, braked, limits that shrink, released again.
fn seen() -> Result<SignalBand<2>, ParameterError> {
    let (wide, narrow) = (wide()?, SpeedLimits::new([-0.5, -2.0], [1.0, 1.0])?);
    let mut band = SignalBand::new(0.25);
    for (limits, demand, factor, switch) in [
        (wide, split([9.0, 9.0], [9.0, 9.0]), 0.0, 0.0),
        (wide, split([0.25, -0.5], [1.0, 1.0]), 0.5, 1.0),
        (wide, split([0.125, -0.25], [1.5, -1.0]), 0.625, 1.0),
        (wide, split([-0.125, 0.0], [3.0, 1.0]), 0.718_75, 0.0),
        (narrow, split([-0.125, 0.25], [4.0, 2.0]), 0.539_062_5, 0.0),
        (narrow, split([0.0, 0.25], [12.0, -2.0]), 0.4, 0.0),
        (narrow, split([0.0, 0.25], [2.0, 1.0]), 0.3, 1.0),
    ] {
        band.update(&limits, &demand, factor, switch);
    }
    Ok(band)
}

#[test]
fn the_signals_of_a_run_are_the_suprema_of_their_definitions() -> Result<(), ParameterError> {
    let band = seen()?;
    assert_signals(
        band.signals(),
        Signals {
            feedback: 0.25,
            overspeed: 24.0,
            rise: 2.0_f64.ln(),
            surplus: 1.504_077_396_776_274_2,
            released_change: 0.921_875,
            braked_change: 6.656_25,
            demand_change: 8.875,
            start: 0.0,
        },
    );
    assert!(close(band.signals().feedforward_band(0.25), 35.4375));
    // The vector form, braked samples: 6.65625 / 0.25.
    assert!(close(band.band(), 26.625) && close(band.signals().chattering(0.25), 14.875));
    Ok(())
}

#[test]
fn a_run_that_begins_braked_and_moving_counts_its_first_sample() -> Result<(), ParameterError> {
    let mut band = SignalBand::new(0.25);
    band.update(&wide()?, &split([0.5, 0.0], [3.0, 0.0]), 0.5, 0.0);
    assert!(close(band.signals().start, 1.0), "{:?}", band.signals());
    band.update(&wide()?, &split([0.5, 0.0], [3.0, 0.0]), 0.375, 0.0);
    let expected = Signals { feedback: 0.5, overspeed: 3.0, braked_change: 0.125, start: 1.0, ..Signals::NONE };
    assert_signals(band.signals(), expected);
    assert!(close(band.band(), 1.5));
    Ok(())
}

#[test]
fn a_feedforward_that_its_feedback_hides_counts_at_the_start() -> Result<(), ParameterError> {
    let mut band = SignalBand::new(0.25);
    // z = 0.5 * 3 / 2 while m is (1.5 - 0.5) / 2.
    band.update(&wide()?, &split([-0.5, 0.0], [3.0, 0.0]), 0.5, 0.0);
    assert_eq!(band.signals().start, 0.75);
    Ok(())
}

#[test]
fn limits_that_shrink_count_as_a_change_of_what_they_held() -> Result<(), ParameterError> {
    let mut band = SignalBand::new(0.25);
    band.update(&wide()?, &split([0.0; 2], [2.0, 0.0]), 0.5, 1.0);
    // One limit to a quarter, κ = 4, with m = 1/2 before: (1 - a)(f |ΔB| + 3 m) is 3/4 (1/2 * 1 + 3/2).
    band.update(&SpeedLimits::new([-0.5, -4.0], [0.5, 2.0])?, &split([0.0; 2], [2.5, 0.0]), 0.625, 1.0);
    let rise = 5.0_f64.ln();
    let changes = Signals { rise, released_change: 1.5, demand_change: 0.5, overspeed: 5.0, ..Signals::NONE };
    assert_signals(band.signals(), changes);
    Ok(())
}

#[test]
fn the_band_is_the_smaller_of_two_and_at_least_one() {
    let quiet = Signals { feedback: 0.5, overspeed: 4.0, released_change: 0.125, ..Signals::NONE };
    // By vector: 1 - 1/4 + 1/8 + 1; by length 0.5 + 0.75 * 1.5 + 1.
    assert!(close(quiet.band(0.25), 1.875) && close(quiet.feedforward_band(0.25), 2.125));
    let rough = Signals { braked_change: 8.0, ..quiet };
    assert!(close(rough.band(0.25), 2.625));
    let risen = Signals { rise: 2.0_f64.ln(), surplus: 3.0_f64.ln(), ..rough };
    assert!(close(risen.feedforward_band(0.25), 9.75) && close(risen.band(0.25), 10.25));
    let started = Signals { start: 5.0, ..quiet };
    assert!(close(started.feedforward_band(0.25), 5.0) && close(started.band(0.25), 5.0));
    assert_eq!(Signals::NONE.band(0.25), 1.0);
    assert!(close(Signals { overspeed: 4.0, demand_change: 0.5, ..Signals::NONE }.chattering(0.25), 1.5));
}

#[test]
fn what_the_bands_add_for_rounding_they_add_on_the_safe_side() {
    // The exact values of the test above, and 2.25 and 3.25 of the implicit form's change.
    let quiet = Signals { feedback: 0.5, overspeed: 4.0, released_change: 0.125, demand_change: 0.5, ..Signals::NONE };
    assert!(quiet.band(0.25) > 1.875 && quiet.feedforward_band(0.25) > 2.125 && quiet.chattering(0.25) > 1.5);
    assert!(implicit_chattering(&quiet, 0.25, 2.0) > 3.5);
}

#[test]
fn what_is_not_a_number_proves_nothing() -> Result<(), ParameterError> {
    let bad = Signals { feedback: f64::NAN, ..Signals::NONE };
    assert_eq!((bad.feedforward_band(0.25), bad.within(&bad)), (f64::INFINITY, false));
    let worse = Signals { released_change: f64::NAN, ..bad };
    assert_eq!(worse.band(0.25), f64::INFINITY);
    let mut band = SignalBand::new(0.25);
    band.update(&wide()?, &split([f64::NAN, 0.0], [1.0, 0.0]), 0.5, 1.0);
    assert_eq!(band.signals().feedback, f64::INFINITY);
    Ok(())
}

#[test]
fn signals_are_within_others_that_are_nowhere_smaller() {
    let ones = Signals {
        feedback: 1.0,
        overspeed: 1.0,
        rise: 1.0,
        surplus: 1.0,
        released_change: 1.0,
        braked_change: 1.0,
        demand_change: 1.0,
        start: 1.0,
    };
    assert!(ones.within(&ones) && Signals::NONE.within(&ones));
    for larger in [
        Signals { feedback: 2.0, ..ones },
        Signals { overspeed: 2.0, ..ones },
        Signals { rise: 2.0, ..ones },
        Signals { surplus: 2.0, ..ones },
        Signals { released_change: 2.0, ..ones },
        Signals { braked_change: 2.0, ..ones },
        Signals { demand_change: 2.0, ..ones },
        Signals { start: 2.0, ..ones },
    ] {
        assert!(!larger.within(&ones) && ones.within(&larger), "{larger:?}");
    }
}

#[test]
fn a_path_that_stands_at_a_cusp_does_not_drift() -> Result<(), ParameterError> {
    let mut band = SignalBand::new(0.25);
    for _ in 0..3 {
        band.update(&wide()?, &split([0.0; 2], [0.0; 2]), 0.5, 1.0);
    }
    assert_eq!(band.signals(), Signals::NONE);
    Ok(())
}

#[test]
fn the_implicit_forms_demand_changes_with_the_filter_or_the_joint_at_its_limit() {
    let signals = Signals { feedback: 0.5, overspeed: 8.0, demand_change: 0.25, ..Signals::NONE };
    // a g + X = 2.25 against X (1 + κ 3): 1 with κ = 1, 3.25 with κ = 4.
    assert!(close(implicit_chattering(&signals, 0.25, 1.0), 2.25));
    assert!(close(implicit_chattering(&signals, 0.25, 4.0), 3.25));
    for feedback in [1.0, 1.5, f64::NAN] {
        assert_eq!(implicit_chattering(&Signals { feedback, ..signals }, 0.25, 1.0), f64::INFINITY);
    }
}

fn progress(form: ProgressForm) -> Result<ProgressSums, ParameterError> {
    let (limits, mut progress) = (wide()?, Progress::new(form, 0.25));
    for (demand, factor, on_path) in [
        (split([0.25, -0.5], [1.0, 1.0]), 0.5, 0.5),
        (split([0.125, 0.0], [2.0, 3.0]), 0.5, 1.75),
        (split([0.0, 0.5], [8.0, 1.0]), 0.5, 4.0),
        (split([0.5, 0.25], [6.0, 1.0]), 0.4, 3.0),
        (split([0.0, 0.0], [1.0, 1.0]), 0.25, 0.5),
    ] {
        progress.update(&limits, &demand, factor, on_path);
    }
    Ok(progress.sums())
}

#[test]
fn the_sums_of_a_motion_are_those_of_their_definitions() -> Result<(), ParameterError> {
    for (form, held_back) in [(ProgressForm::Explicit, 2.640_625), (ProgressForm::Implicit, 2.4375)] {
        let sums = progress(form)?;
        let right = close(sums.feedback, 1.125)
            && close(sums.overrun, 1.45)
            && close(sums.shift, 0.1875)
            && close(sums.held_back, held_back)
            && close(sums.pace, 2.25);
        assert!(right, "{sums:?}");
    }
    Ok(())
}

#[test]
fn a_feedforward_seen_too_small_counts_in_shift_and_pace() -> Result<(), ParameterError> {
    let mut progress = Progress::new(ProgressForm::Explicit, 0.25);
    // b = 3 where the path has 7.5, E = 0.5 and m = 1.75.
    progress.update(&wide()?, &split([0.5, 0.25], [6.0, 1.0]), 0.5, 7.5);
    let sums = progress.sums();
    assert!(close(sums.shift, 2.25 * 1.5) && close(sums.pace, 2.25 * 2.5) && close(sums.overrun, 0.75), "{sums:?}");
    Ok(())
}

#[test]
fn a_reference_that_stands_at_a_cusp_is_held_back_and_not_shifted() -> Result<(), ParameterError> {
    let mut progress = Progress::new(ProgressForm::Explicit, 0.25);
    for _ in 0..2 {
        progress.update(&wide()?, &split([0.0; 2], [0.0; 2]), 0.5, 0.0);
    }
    assert_eq!(progress.sums(), ProgressSums { held_back: 2.0, pace: 1.0, ..ProgressSums::default() });
    Ok(())
}

#[test]
fn the_travel_bracket_is_the_formula() {
    let sums = ProgressSums { feedback: 2.0, overrun: 0.5, shift: 0.25, held_back: 3.0, pace: 1.5 };
    let inputs = TravelInputs { sums, optimum: [4.0, 4.5], period: 0.125, variation: 2.0, sample_drift: 0.5 };
    for (inputs, lower, upper) in [
        (inputs, 3.169_709_046_974_904, 5.517_790_953_025_096),
        (TravelInputs { sample_drift: 0.0, ..inputs }, 3.281_25, 5.406_25),
        // A drift too small for e^d to differ from 1 in 64 bits.
        (TravelInputs { sample_drift: 1e-17, ..inputs }, 3.281_25, 5.406_25),
        (TravelInputs { sample_drift: 0.0, optimum: [0.5, 4.5], ..inputs }, 0.0, 5.406_25),
    ] {
        let bracket = travel_bracket(&inputs);
        assert!(bracket.is_some_and(|[low, high]| close(low, lower) && close(high, upper)), "{bracket:?}");
    }
    assert_eq!(travel_bracket(&TravelInputs { variation: f64::NAN, ..inputs }), None);
    assert_eq!(travel_bracket(&TravelInputs { sample_drift: f64::NAN, ..inputs }), None);
    assert_eq!(travel_bracket(&TravelInputs { optimum: [4.0, f64::INFINITY], ..inputs }), None);
}
