//! Speed limits by planted answers: exact numbers, both ends of every range, what is not a number.

use slideway_conditioner::{ParameterError, Saturation, SpeedLimits};

/// Two joints with limits that are no mirror images; all numbers are exact in binary.
fn lopsided() -> Result<SpeedLimits<2>, ParameterError> {
    SpeedLimits::new([-2.0, -1.0], [4.0, 0.5])
}

#[test]
fn limits_of_the_wrong_sign_or_without_a_size_are_refused_with_their_joint() {
    for value in [0.0, 1.0, f64::NEG_INFINITY] {
        let refused = SpeedLimits::new([-1.0, value], [1.0, 1.0]);
        assert_eq!(refused, Err(ParameterError::LowerLimit { joint: 1, value }));
    }
    for value in [0.0, -1.0, f64::INFINITY] {
        let refused = SpeedLimits::new([-1.0, -1.0], [1.0, value]);
        assert_eq!(refused, Err(ParameterError::UpperLimit { joint: 1, value }));
        assert_eq!(SpeedLimits::symmetric([1.0, value]), Err(ParameterError::UpperLimit { joint: 1, value }));
    }
    assert!(matches!(SpeedLimits::new([f64::NAN], [1.0]), Err(ParameterError::LowerLimit { joint: 0, .. })));
    assert!(matches!(SpeedLimits::new([-1.0], [f64::NAN]), Err(ParameterError::UpperLimit { joint: 0, .. })));
    assert!(matches!(SpeedLimits::symmetric([f64::NAN]), Err(ParameterError::UpperLimit { joint: 0, .. })));
}

#[test]
fn symmetric_limits_are_mirror_images() -> Result<(), ParameterError> {
    let limits = SpeedLimits::symmetric([0.5, 3.0])?;
    assert_eq!((limits.lower(), limits.upper()), (&[-0.5, -3.0], &[0.5, 3.0]));
    Ok(())
}

#[test]
fn the_ends_belong_to_the_range_and_not_a_number_does_not() -> Result<(), ParameterError> {
    let limits = lopsided()?;
    assert!(limits.contain(&[4.0, 0.5]) && limits.contain(&[-2.0, -1.0]));
    for outside in [[4.0_f64.next_up(), 0.0], [(-2.0_f64).next_down(), 0.0], [0.0, 0.75], [0.0, -1.5], [f64::NAN, 0.0]]
    {
        assert!(!limits.contain(&outside), "{outside:?}");
    }
    Ok(())
}

#[test]
fn each_direction_counts_in_its_own_limit() -> Result<(), ParameterError> {
    let limits = lopsided()?;
    for (speed, ratio, joint) in [
        ([1.0, 0.0], 0.25, Some(0)),
        ([-1.0, 0.0], 0.5, Some(0)),
        ([1.0, 0.25], 0.5, Some(1)),
        ([-1.0, -0.75], 0.75, Some(1)),
        ([8.0, 0.5], 2.0, Some(0)),
        ([2.0, 0.25], 0.5, Some(0)),
        ([0.0, 0.0], 0.0, None),
    ] {
        assert_eq!((limits.ratio(&speed), limits.limiting_joint(&speed)), (ratio, joint), "{speed:?}");
    }
    assert_eq!(limits.ratio(&[0.0, f64::NAN]), f64::INFINITY);
    assert_eq!(limits.limiting_joint(&[1.0, f64::NAN]), None);
    Ok(())
}

#[test]
fn saturation_cuts_each_joint_or_scales_them_all() -> Result<(), ParameterError> {
    let limits = lopsided()?;
    let both = |speed| [Saturation::Direct, Saturation::DirectionPreserving].map(|s| limits.saturate(&speed, s));
    let [direct, scaled] = both([8.0, 0.25]);
    assert_eq!((direct.joint_speed, direct.direction_factor), ([4.0, 0.25], 0.5));
    assert_eq!((scaled.joint_speed, scaled.direction_factor), ([4.0, 0.125], 0.5));
    let [direct, scaled] = both([-1.0, -4.0]);
    assert_eq!((direct.joint_speed, direct.direction_factor), ([-1.0, -1.0], 0.25));
    assert_eq!((scaled.joint_speed, scaled.direction_factor), ([-0.25, -1.0], 0.25));
    for inside in [[3.0, -0.5], [4.0, 0.5]] {
        for saturated in both(inside) {
            assert_eq!((saturated.joint_speed, saturated.direction_factor), (inside, 1.0));
        }
    }
    for broken in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for saturated in both([1.0, broken]) {
            assert_eq!((saturated.joint_speed, saturated.direction_factor), ([0.0, 0.0], 0.0));
        }
    }
    Ok(())
}

#[test]
fn the_largest_factor_ends_at_the_bound_the_first_joint_meets() -> Result<(), ParameterError> {
    let limits = lopsided()?;
    for (constant, slope, largest) in [
        ([1.0, 0.0], [6.0, 0.0], Some(0.5)),
        ([1.0, 0.0], [-12.0, 0.0], Some(0.25)),
        ([0.0, 0.25], [1.0, 2.0], Some(0.125)),
        ([0.0, 0.25], [1.0, -10.0], Some(0.125)),
        ([0.0, 0.0], [0.5, 0.25], Some(1.0)),
        ([4.0, 0.0], [1.0, 0.0], Some(0.0)),
        ([4.0, 0.0], [-1.0, 0.0], Some(1.0)),
        ([4.5, 0.0], [-1.0, 0.0], None),
        ([0.0, 0.0], [f64::INFINITY, 0.0], None),
        ([0.0, f64::NAN], [1.0, 0.0], None),
    ] {
        assert_eq!(limits.largest_factor(&constant, &slope), largest, "{constant:?} + f {slope:?}");
    }
    Ok(())
}
