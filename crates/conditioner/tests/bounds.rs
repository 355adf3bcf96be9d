//! The bounds by planted answers, worked out by hand or in the plainest form of their formulas; and what has no bound.

use slideway_conditioner::bounds::{
    FeedbackLoop, chattering_bound, chattering_estimate, delayed_frozen_band, drifting_band,
    drifting_band_with_feedback, frozen_band, frozen_band_with_feedback, switches_by, time_bracket,
};
use slideway_conditioner::path::{bounds as path, largest_step_count};

/// Equal up to a few roundings and what the functions add for theirs: 1e-13 of `1 + E`, thirty times that of an `E` of 0.04.
fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-11 * b.abs()
}

#[test]
fn frozen_bands_are_a_filter_step_beyond_the_limit() {
    assert_eq!(frozen_band(0.25, 3.0), 1.5);
    assert_eq!((frozen_band(0.25, 1.0), frozen_band(0.25, 0.5)), (1.0, 1.0));
    // 1 - (3/4)^3 = 37/64, times 2.
    assert!(close(delayed_frozen_band(0.25, 3.0, 2), 1.0 + 37.0 / 32.0));
    assert!(close(delayed_frozen_band(0.25, 3.0, 0), 1.5));
    assert_eq!(delayed_frozen_band(0.25, 0.5, 2), 1.0);
}

#[test]
fn the_frozen_band_with_feedback_needs_a_filter_at_least_as_fast_as_the_loop() {
    assert_eq!(frozen_band_with_feedback(0.5, 3.0, 0.25), Some(2.25));
    assert_eq!(frozen_band_with_feedback(0.5, 3.0, 0.5), Some(2.0));
    assert_eq!(frozen_band_with_feedback(0.5, 3.0, 0.0), Some(2.5));
    for refused in [(0.25, 0.5), (0.25, -0.25), (f64::NAN, 0.25), (0.25, f64::NAN)] {
        assert_eq!(frozen_band_with_feedback(refused.0, 3.0, refused.1), None, "{refused:?}");
    }
}

#[test]
fn the_drifting_band_is_the_formula_where_the_filter_reaches_and_nothing_elsewhere() {
    assert!(drifting_band(0.01, 3.0, 0.005).is_some_and(|m| close(m, 1.024_962_395_650_807)));
    assert!(drifting_band(0.25, 3.0, 0.0).is_some_and(|m| close(m, 1.5)));
    // -ln(0.99) = 0.01005: a drift of 0.00976 with the band of 1.0297 is inside by a hair, one of 0.00977 is not.
    assert!(drifting_band(0.01, 3.0, 0.009_76).is_some());
    for (step, overspeed, drift) in [(0.01, 3.0, 0.009_77), (0.01, 3.0, 0.02), (0.01, 3.0, -1e-3), (0.25, 0.5, 0.0)] {
        assert_eq!(drifting_band(step, overspeed, drift), None, "{step} {overspeed} {drift}");
    }
    assert_eq!(drifting_band(f64::NAN, 3.0, 0.005), None);
}

/// The last number accepted on the way from one that is to one that is not.
fn edge(mut accepted: f64, mut refused: f64, accepts: impl Fn(f64) -> bool) -> f64 {
    while (accepted - refused).abs() > f64::EPSILON * accepted {
        let middle = 0.5 * (accepted + refused);
        *(if accepts(middle) { &mut accepted } else { &mut refused }) = middle;
    }
    accepted
}

#[test]
fn a_condition_that_rounding_could_decide_is_taken_for_unmet() {
    for step in [0.01_f64, 0.1, 0.3] {
        // L Ts λ̇*max M < -ln(1 - a), strictly, at the largest drift that has a band.
        let reach = -(-step).ln_1p();
        let drift = edge(0.0, reach, |drift| drifting_band(step, 3.0, drift).is_some());
        assert!(drifting_band(step, 3.0, drift).is_some_and(|band| drift * band < reach), "{step}: {drift}");
        // r (1 - r) < a g_min, strictly, at the smallest overspeed that has a bracket.
        let ratio = (1.0 - step) * (-0.3_f64).exp();
        let overspeed = edge(100.0, 0.0, |overspeed| time_bracket(step, overspeed, 0.3, 0.0).is_some());
        assert!(ratio * (1.0 - ratio) < step * overspeed, "{step}: {overspeed}");
    }
}

#[test]
fn the_switch_acts_once_the_filter_has_risen_to_the_limit() {
    // g = 2, a = 1/4: 2 (1 - (3/4)^k) is 0.875 after two samples, 1.156 after three.
    assert_eq!([2, 3].map(|k| switches_by(0.25, 2.0, 0.0, k)), [false, true]);
    // From f0 = 1/2 the first sample is at g f = 1, which is no switch; at g = 2.5 it is one.
    assert!(!switches_by(0.25, 2.0, 0.5, 0) && switches_by(0.25, 2.5, 0.5, 0));
    assert!(switches_by(1.0, 1.5, 1.0, 0) && !switches_by(1.0, 1.5, 0.0, 0) && switches_by(1.0, 1.5, 0.0, 1));
    assert!(!switches_by(0.25, 1.0, 0.0, 1000));
}

#[test]
fn the_chattering_bound_adds_the_drift_to_what_the_factor_changes() {
    assert_eq!(chattering_estimate(-3.0, 0.25, 8.0), 6.0);
    assert_eq!(chattering_bound(-3.0, 0.25, 0.5), 1.25);
    assert_eq!(chattering_bound(3.0, -0.5, -0.25), 1.75);
}

const LOOP: FeedbackLoop = FeedbackLoop {
    filter_step: 0.25,
    gain: 2.0,
    sampling_period: 0.125,
    target_rate: 8.0,
    path_rate_max: 2.0,
    overspeed_max: 4.0,
    curvature: 0.5,
    initial_lag: 0.0,
};

#[test]
fn lag_rates_and_band_of_the_loop_are_those_of_the_formulas() {
    // x = 1/32; E = x ρ P with ρ = 2 (1 + E), P = 3/4 ρ + 2 gives E = 1/3, ρ = 8/3, P = 4, M = 23/9.
    let slow = FeedbackLoop {
        filter_step: 0.05,
        gain: 5.0,
        sampling_period: 0.01,
        target_rate: 6.0,
        path_rate_max: 1.5,
        curvature: 3.0,
        ..LOOP
    };
    let both_at_work = FeedbackLoop {
        filter_step: 0.5,
        gain: 1.0,
        target_rate: 4.0,
        path_rate_max: 3.0,
        overspeed_max: 1.5,
        curvature: 16.0,
        ..LOOP
    };
    let lagging = FeedbackLoop { initial_lag: 0.5, ..LOOP };
    for (system, lag, requested, rate, ratio) in [
        (LOOP, 1.0 / 3.0, 4.0, 8.0 / 3.0, 23.0 / 9.0),
        (lagging, 0.5, 4.25, 3.0, 3.171_875),
        // The quadratic has a larger root as well; the smaller one counts.
        (slow, 0.041_833_564_791_095_526, 1.784_612_829_827_311_2, 1.562_750_347_186_643_3, 1.668_141_856_567_205),
        (both_at_work, 16.0, 4.0, 4.0, 52.0),
        // Both minima at work below the quadratic's root, 7/9; and a start beyond its larger root, 5.3: E = x λ̇d² either way.
        (FeedbackLoop { curvature: 0.5, ..both_at_work }, 0.5, 4.0, 4.0, 2.0),
        (FeedbackLoop { target_rate: 16.0, initial_lag: 6.0, ..LOOP }, 8.0, 16.0, 16.0, 64.0),
        // Gain steps below and above the filter step; the released entry of M decides in the first four.
        (
            FeedbackLoop { filter_step: 0.5, initial_lag: 0.25, ..LOOP },
            0.527_864_045_000_420_5,
            5.527_864_045_000_42,
            3.055_728_090_000_841,
            2.996_711_095_625_933,
        ),
        (
            FeedbackLoop { filter_step: 0.5, curvature: 0.25, initial_lag: 0.25, ..LOOP },
            0.25,
            5.25,
            2.5,
            2.684_570_312_5,
        ),
        (FeedbackLoop { gain: 1.0, overspeed_max: 8.0, ..lagging }, 0.5, 4.25, 3.0, 3.269_531_25),
        (FeedbackLoop { gain: 4.0, overspeed_max: 16.0, ..lagging }, 0.5, 4.25, 3.0, 5.4375),
        (FeedbackLoop { gain: 1.0, ..lagging }, 0.5, 4.25, 3.0, 3.031_25),
        (FeedbackLoop { filter_step: 0.125, gain: 4.0, overspeed_max: 2.0, ..lagging }, 0.5, 3.625, 3.0, 7.882_812_5),
        // A gain step above the filter step, and a filter too slow for the drift: the second entry of M decides.
        (FeedbackLoop { gain: 6.0, ..lagging }, 0.5, 4.25, 3.0, 4.734_375),
        (FeedbackLoop { filter_step: 0.01, ..lagging }, 0.5, 3.05, 3.0, 76.146_875),
    ] {
        let band = drifting_band_with_feedback(&system);
        let right = band.is_some_and(|b| {
            close(b.lag, lag)
                && close(b.requested_rate, requested)
                && close(b.path_rate, rate)
                && close(b.limit_ratio, ratio)
        });
        assert!(right, "{system:?}: {band:?}");
    }
}

#[test]
fn a_planted_lag_is_found_however_small_or_large() {
    let (small, large) = ((-36..0).map(|k| 10.0_f64.powf(0.25 * f64::from(k))), (1..400).map(|k| 0.25 * f64::from(k)));
    for lag in small.chain(large) {
        // E = x ρ P with ρ = (1 + E) λ̇*max and P = (1 - a) ρ + a λ̇d, both below λ̇d, solved for x.
        let (y, step) = (1.0 + lag, 0.25);
        let target = 8.0 * y * y;
        let half = lag / (y * ((1.0 - step) * y + step * target));
        let curvature = 2.0 * half / LOOP.sampling_period;
        let system = FeedbackLoop { filter_step: step, target_rate: target, path_rate_max: 1.0, curvature, ..LOOP };
        let found = drifting_band_with_feedback(&system).map_or(f64::NAN, |b| b.lag);
        // Upwards only. What is added for rounding, 1e-13 of x and of 1 + E, grows by 1 / (1 - d(x ρ P)/dE), about 1 + E.
        assert!(lag <= found && found <= lag + 1e-12 * y * y, "{found} instead of {lag}");
    }
}

#[test]
fn what_the_bounds_of_a_loop_add_for_rounding_they_add_on_the_safe_side() {
    // E = x λ̇d² = 8 and M = 64 in exact numbers; without curvature, M = 1 + a (g - 1) + 0.
    let fast = FeedbackLoop { target_rate: 16.0, initial_lag: 6.0, ..LOOP };
    assert!(drifting_band_with_feedback(&fast).is_some_and(|b| b.lag > 8.0 && b.limit_ratio > 64.0));
    let straight = FeedbackLoop { curvature: 0.0, ..LOOP };
    assert!(drifting_band_with_feedback(&straight).is_some_and(|b| b.lag == 0.0 && b.limit_ratio > 1.75));
}

#[test]
fn a_loop_with_a_number_out_of_range_has_no_band() {
    let bad = f64::NAN;
    for system in [
        FeedbackLoop { filter_step: 0.0, ..LOOP },
        FeedbackLoop { filter_step: 0.0, curvature: 0.0, gain: 0.0, ..LOOP },
        FeedbackLoop { filter_step: 1.25, ..LOOP },
        FeedbackLoop { gain: -1.0, ..LOOP },
        FeedbackLoop { gain: 9.0, ..LOOP },
        FeedbackLoop { sampling_period: 0.0, ..LOOP },
        FeedbackLoop { target_rate: 0.0, ..LOOP },
        FeedbackLoop { path_rate_max: 0.0, ..LOOP },
        FeedbackLoop { overspeed_max: -1.0, ..LOOP },
        FeedbackLoop { curvature: -1.0, ..LOOP },
        FeedbackLoop { initial_lag: -1.0, ..LOOP },
        FeedbackLoop { filter_step: bad, ..LOOP },
        FeedbackLoop { gain: bad, ..LOOP },
        FeedbackLoop { sampling_period: bad, ..LOOP },
        FeedbackLoop { target_rate: bad, ..LOOP },
        FeedbackLoop { path_rate_max: bad, ..LOOP },
        FeedbackLoop { overspeed_max: bad, ..LOOP },
        FeedbackLoop { curvature: bad, ..LOOP },
        FeedbackLoop { initial_lag: bad, ..LOOP },
        FeedbackLoop { overspeed_max: f64::INFINITY, ..LOOP },
    ] {
        assert_eq!(drifting_band_with_feedback(&system), None, "{system:?}");
    }
    for edge in [
        FeedbackLoop { filter_step: 1.0, ..LOOP },
        FeedbackLoop { gain: 0.0, ..LOOP },
        FeedbackLoop { gain: 8.0, ..LOOP },
        FeedbackLoop { overspeed_max: 0.0, ..LOOP },
        FeedbackLoop { curvature: 0.0, ..LOOP },
    ] {
        assert!(drifting_band_with_feedback(&edge).is_some(), "{edge:?}");
    }
}

#[test]
fn the_time_bracket_is_the_formula_where_its_hypotheses_hold() {
    for (step, overspeed, drift, factor, upper, samples) in [
        (0.25, 2.0, 0.125, 0.0, 1.611_588_911_028_375, 3.0),
        (0.1, 1.25, 0.05, 0.0, 1.198_029_739_459_856_5, 12.0),
        (0.25, 2.0, 0.125, 0.75, 1.611_588_911_028_375, 0.0),
        (0.25, 2.0, 0.0, 0.0, 4.0 / 3.0, 3.0),
        (0.25, 2.0, 0.125, 1.0, 1.611_588_911_028_375, 0.0),
    ] {
        let bracket = time_bracket(step, overspeed, drift, factor);
        let right = bracket.is_some_and(|b| {
            close(b.lower, 1.0 - 0.5 * drift) && close(b.upper, upper) && b.approach_samples == samples
        });
        assert!(right, "{step} {overspeed} {drift} {factor}: {bracket:?}");
    }
    for (step, overspeed, drift, factor) in [
        (0.0, 2.0, 0.0, 0.0),
        (1.0, 2.0, 0.0, 0.0),
        (0.25, 0.75, 0.0, 0.0),
        (0.25, 2.0, -0.125, 0.0),
        (0.9, 2.0, 2.0, 0.0),
        (0.25, 2.0, 0.125, -0.5),
        (0.25, 2.0, 0.125, 1.5),
        // r (1 - r) = 0.244 exceeds a g = 0.1.
        (0.1, 1.0, 0.3, 0.0),
        (f64::NAN, 2.0, 0.125, 0.0),
        (0.25, f64::NAN, 0.125, 0.0),
        (0.25, 2.0, f64::NAN, 0.0),
        (0.25, 2.0, 0.125, f64::NAN),
    ] {
        assert_eq!(time_bracket(step, overspeed, drift, factor), None, "{step} {overspeed} {drift} {factor}");
    }
}

#[test]
fn bands_of_the_path_conditioner_are_push_and_drift() {
    assert_eq!(path::chattering_estimate(0.5, 2.0, 0.25, -3.0, -4.0), 6.0);
    let band = path::band(3.0, 1.0, 1.5);
    assert_eq!((band.lower, band.upper), (-2.0, 1.5));
    let idle = path::band(1.0, 3.0, -1.0);
    assert_eq!((idle.lower, idle.upper), (0.0, 0.0));
    assert_eq!(path::appendix_upper_band(2.0, 3.0), 3.0 + 2.5 + 1.5);
    assert_eq!(path::appendix_upper_band(8.0, 3.0), 4.0);
    assert_eq!(path::appendix_upper_band(8.0, -3.0), 0.0);
    assert!(close(path::pair_push(3.0, 0.5), 3.0 * 0.75_f64.sqrt()));
    assert_eq!((path::pair_push(3.0, 1.0), path::pair_push(3.0, -1.0), path::pair_push(3.0, -1.5)), (3.0, 0.0, 0.0));
    assert_eq!(path::between_samples(0.5, -4.0), 0.125);
    assert!(close(path::recovery_time(0.5, 0.25, 0.5, 2.0), 1.5 + 2.0 * 3.0_f64.ln()));
    assert_eq!(path::recovery_time(0.5, 0.0, 0.5, 2.0), f64::INFINITY);
    assert_eq!((path::required_gain(&[-1.0, 3.0, 2.0]), path::required_gain(&[-1.0])), (3.0, 0.0));
}

#[test]
fn a_push_moves_phi_by_the_step_response_of_its_filter() {
    // Butterworth with poles -s ± j s, s = cutoff / √2: where s T = π/2 the rotation is a quarter turn, so that the position is
    // 1 - exp(-π/2) and the velocity 2 s exp(-π/2).
    let (half_pi, root_two) = (std::f64::consts::FRAC_PI_2, std::f64::consts::SQRT_2);
    let push = path::push_per_sample(0.5, root_two * std::f64::consts::PI, 0.25);
    assert!(close(push, 1.0 + (-half_pi).exp() * (half_pi - 1.0)), "{push}");
}

#[test]
fn the_active_set_ends_within_a_step_for_every_set_and_member() {
    assert_eq!([0, 1, 3].map(largest_step_count), [1, 4, 32]);
    assert_eq!(largest_step_count(24), 25 << 24);
    assert_eq!([63, 64, 100].map(largest_step_count), [64 << 24, 64 << 24, 64 << 24]);
}

#[test]
fn a_bound_of_what_is_not_known_is_not_known() {
    let nan = f64::NAN;
    for value in [
        frozen_band(nan, 2.0),
        frozen_band(0.25, nan),
        delayed_frozen_band(nan, 2.0, 1),
        delayed_frozen_band(0.25, nan, 1),
        chattering_estimate(nan, 0.25, 2.0),
        chattering_bound(1.0, nan, 0.0),
        chattering_bound(1.0, 0.0, nan),
        path::band(nan, 0.0, 1.0).lower,
        path::band(1.0, nan, 1.0).lower,
        path::band(1.0, 0.0, nan).upper,
        path::appendix_upper_band(nan, 1.0),
        path::appendix_upper_band(1.0, nan),
        path::pair_push(nan, 0.5),
        path::pair_push(1.0, nan),
        path::between_samples(nan, 1.0),
        path::between_samples(0.1, nan),
        path::recovery_time(nan, 0.1, 1.0, 0.1),
        path::required_gain(&[nan, 1.0]),
        path::required_gain(&[1.0, nan]),
    ] {
        assert!(value.is_nan(), "{value}");
    }
}
