//! Texts of refusals: which number was refused, of which joint counted from one, and what to change.

use slideway_conditioner::ParameterError;
use slideway_conditioner::path::PathQuantity;
use slideway_conditioner::shapes::ShapeParameter;

#[test]
fn every_refusal_names_the_number_its_value_and_the_way_out() {
    let value = -1.5;
    let words: [(ParameterError, &[&str]); 16] = [
        (
            ParameterError::UpperLimit { joint: 2, value },
            &["upper speed limit of joint 3 is -1.5", "positive and finite"],
        ),
        (
            ParameterError::LowerLimit { joint: 0, value: 4.0 },
            &["lower speed limit of joint 1 is 4", "negative and finite"],
        ),
        (
            ParameterError::UpperAcceleration { joint: 1, value },
            &["upper acceleration limit of joint 2 is -1.5", "positive and finite"],
        ),
        (
            ParameterError::LowerAcceleration { joint: 1, value: 4.0 },
            &["lower acceleration limit of joint 2 is 4", "negative and finite"],
        ),
        (ParameterError::Speed { joint: 5, value }, &["initial speed of joint 6 is -1.5", "outside its speed limits"]),
        (ParameterError::Gain(value), &["position gain is -1.5 1/s", "positive and finite"]),
        (
            ParameterError::GainStep { step: 0.75 },
            &["gain times sampling period is 0.75", "not exceed 0.5", "lower the gain"],
        ),
        (ParameterError::AccelerationMargin(1.0), &["kept in reserve is 1;", "[0, 1)"]),
        (ParameterError::SamplingPeriod(value), &["sampling period is -1.5 s", "positive and finite"]),
        (ParameterError::Bandwidth(value), &["filter bandwidth is -1.5 rad/s", "positive and finite"]),
        (ParameterError::TargetRate(value), &["target rate of the path parameter is -1.5 1/s", "positive and finite"]),
        (
            ParameterError::FilterStep { step: 2.0 },
            &["bandwidth times sampling period is 2,", "not exceed 1", "lower the bandwidth or sample faster"],
        ),
        (ParameterError::Factor(1.25), &["speed factor is 1.25", "[0, 1]"]),
        (ParameterError::SafeWalkWithoutReserve, &["safe walk", "explicit zero-order-hold form", "reserve"]),
        (
            ParameterError::Shape { parameter: ShapeParameter::Weight(1), value },
            &["weight 2 is -1.5", "out of its range"],
        ),
        (ParameterError::Path { quantity: PathQuantity::Approach(1), value }, &["is -1.5", "out of its range"]),
    ];
    for (error, parts) in words {
        let said = error.to_string();
        assert!(parts.iter().all(|part| said.contains(part)), "{said}");
    }
    let path = ParameterError::Path { quantity: PathQuantity::Approach(1), value }.to_string();
    assert!(path.starts_with(&PathQuantity::Approach(1).to_string()), "{path}");
}
