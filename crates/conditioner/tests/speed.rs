//! The speed regulators by planted answers: two samples by hand for every form, and what each setting may be.

use slideway_conditioner::{
    Advance, AffineSpeed, FirstOrderFilter, ImplicitSpeedRegulator, ParameterError, Saturation, SpeedLimits,
    SpeedRegulator, SpeedSettings, SpeedState, Switch,
};

/// All numbers are exact in binary: `a = 1/4`, `λ̇d = 8`, limits ±1 and ±2.
fn settings(advance: Advance) -> Result<SpeedSettings<2>, ParameterError> {
    Ok(SpeedSettings {
        limits: SpeedLimits::symmetric([1.0, 2.0])?,
        sampling_period: 0.5,
        bandwidth: 0.5,
        target_rate: 8.0,
        saturation: Saturation::DirectionPreserving,
        advance,
    })
}

#[test]
fn the_filter_goes_a_share_of_the_way_each_sample() -> Result<(), ParameterError> {
    let filter = FirstOrderFilter::new(0.5, 0.5)?;
    assert_eq!(filter.step(), 0.25);
    assert_eq!((filter.next(0.0, 1.0), filter.next(1.0, 0.0), filter.next(0.5, 1.0)), (0.25, 0.75, 0.625));
    assert_eq!(FirstOrderFilter::new(2.0, 0.5)?.next(0.25, 1.0), 1.0);
    Ok(())
}

#[test]
fn settings_out_of_range_are_refused_with_their_value() {
    assert_eq!(FirstOrderFilter::new(4.0, 0.5), Err(ParameterError::FilterStep { step: 2.0 }));
    assert_eq!(FirstOrderFilter::new(1e-200, 1e-200), Err(ParameterError::FilterStep { step: 0.0 }));
    for bad in [0.0, -1.0, f64::INFINITY] {
        assert_eq!(FirstOrderFilter::new(bad, 0.5), Err(ParameterError::Bandwidth(bad)));
        assert_eq!(FirstOrderFilter::new(0.5, bad), Err(ParameterError::SamplingPeriod(bad)));
    }
    assert!(matches!(FirstOrderFilter::new(f64::NAN, 1.0), Err(ParameterError::Bandwidth(_))));
    for bad in [-0.25, 1.25] {
        assert_eq!(SpeedState::moving(bad), Err(ParameterError::Factor(bad)));
    }
    assert!(SpeedState::moving(f64::NAN).is_err());
    assert_eq!(SpeedState::moving(1.0).map(|s| s.factor()), Ok(1.0));
    assert_eq!(SpeedState::at_rest().factor(), 0.0);
}

#[test]
fn a_target_rate_that_is_not_positive_is_refused_by_both_regulators() -> Result<(), ParameterError> {
    for bad in [0.0, -1.0, f64::INFINITY] {
        let settings = SpeedSettings { target_rate: bad, ..settings(Advance::Paper)? };
        assert_eq!(SpeedRegulator::new(settings), Err(ParameterError::TargetRate(bad)));
        assert_eq!(ImplicitSpeedRegulator::new(settings), Err(ParameterError::TargetRate(bad)));
    }
    Ok(())
}

#[test]
fn a_sample_inside_the_limits_releases_and_one_outside_brakes() -> Result<(), ParameterError> {
    for (advance, share) in [(Advance::Paper, 1.0), (Advance::Synchronised, 0.5)] {
        let regulator = SpeedRegulator::new(settings(advance)?)?;
        let mut state = SpeedState::moving(0.5)?;
        assert_eq!(regulator.requested_rate(&state), 4.0);
        let inside = regulator.step(&mut state, &[1.0, -0.5]);
        assert_eq!((inside.joint_speed, inside.path_rate, inside.factor), ([1.0, -0.5], 4.0, 0.5));
        assert_eq!((inside.switch, inside.direction_factor, inside.limit_ratio), (1.0, 1.0, 1.0));
        assert_eq!(state.factor(), 0.625);
        let outside = regulator.step(&mut state, &[2.0, 1.0]);
        assert_eq!((outside.joint_speed, outside.path_rate, outside.factor), ([1.0, 0.5], share * 5.0, 0.625));
        assert_eq!((outside.switch, outside.direction_factor, outside.limit_ratio), (0.0, 0.5, 2.0));
        assert_eq!(state.factor(), 0.46875);
    }
    Ok(())
}

#[test]
fn what_is_not_a_number_stops_joints_and_reference_and_brakes() -> Result<(), ParameterError> {
    for advance in [Advance::Paper, Advance::Synchronised] {
        let regulator = SpeedRegulator::new(settings(advance)?)?;
        let mut state = SpeedState::moving(0.5)?;
        let command = regulator.step(&mut state, &[f64::NAN, 0.0]);
        assert_eq!((command.joint_speed, command.path_rate, command.switch), ([0.0, 0.0], 0.0, 0.0));
        assert_eq!(state.factor(), 0.375);
    }
    Ok(())
}

#[test]
fn limits_can_be_exchanged_between_samples() -> Result<(), ParameterError> {
    let wider = SpeedLimits::symmetric([4.0, 4.0])?;
    let regulator = SpeedRegulator::new(settings(Advance::Paper)?)?.with_limits(wider);
    let mut state = SpeedState::moving(1.0)?;
    assert_eq!(regulator.step(&mut state, &[2.0, 1.0]).joint_speed, [2.0, 1.0]);
    let implicit = ImplicitSpeedRegulator::new(settings(Advance::Paper)?)?.with_limits(wider);
    let mut state = SpeedState::moving(1.0)?;
    let desired = AffineSpeed { feedback: [0.0, 0.0], feedforward: [4.0, 0.0] };
    assert_eq!(implicit.step(&mut state, &desired).joint_speed, [4.0, 0.0]);
    Ok(())
}

#[test]
fn switches_are_one_and_zero() {
    assert_eq!((Switch::Release.value(), Switch::Brake.value()), (1.0, 0.0));
}

#[test]
fn two_evaluations_of_the_controller_give_the_affine_split() {
    let split = AffineSpeed::from_evaluations([1.0, -2.0], [3.0, 2.0]);
    assert_eq!((split.feedback, split.feedforward), ([1.0, -2.0], [2.0, 4.0]));
    assert_eq!((split.at(0.5), split.at(1.0)), ([2.0, 0.0], [3.0, 2.0]));
}

#[test]
fn the_implicit_factor_rises_with_the_filter_and_falls_with_the_limits() -> Result<(), ParameterError> {
    let regulator = ImplicitSpeedRegulator::new(settings(Advance::Paper)?)?;
    assert_eq!(regulator.target_rate(), 8.0);
    let mut state = SpeedState::moving(0.5)?;
    // Room enough: the filter's own step, switch 1.
    let free = regulator.step(&mut state, &AffineSpeed { feedback: [0.0, 0.5], feedforward: [0.25, 0.5] });
    assert_eq!((free.factor, free.path_rate, free.switch), (0.625, 5.0, 1.0));
    assert_eq!((free.joint_speed, free.limit_ratio), ([0.15625, 0.8125], 0.40625));
    // f* = (1 - 0.5) / 2 = 1/4 where the filter would rise to 23/32: u = 1 - (23/32 - 8/32) 4 = -7/8.
    let held = regulator.step(&mut state, &AffineSpeed { feedback: [0.5, 0.0], feedforward: [2.0, 1.0] });
    assert_eq!((held.factor, held.path_rate, held.switch), (0.25, 2.0, -0.875));
    assert_eq!((held.joint_speed, held.limit_ratio, held.direction_factor), ([1.0, 0.25], 1.0, 1.0));
    assert_eq!(state.factor(), 0.25);
    // The feedback alone is outside: the reference stands, the command is saturated.
    let far = regulator.step(&mut state, &AffineSpeed { feedback: [2.0, 2.0], feedforward: [1.0, 1.0] });
    assert_eq!((far.factor, far.path_rate, far.joint_speed, far.direction_factor), (0.0, 0.0, [1.0, 1.0], 0.5));
    Ok(())
}

#[test]
fn an_infinite_feedforward_stops_joints_and_reference() -> Result<(), ParameterError> {
    let regulator = ImplicitSpeedRegulator::new(settings(Advance::Paper)?)?;
    let mut state = SpeedState::moving(0.5)?;
    let command = regulator.step(&mut state, &AffineSpeed { feedback: [0.5; 2], feedforward: [f64::INFINITY, 0.0] });
    assert_eq!((command.factor, command.path_rate, command.joint_speed), (0.0, 0.0, [0.0; 2]));
    Ok(())
}
