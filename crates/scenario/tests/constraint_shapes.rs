//! Constraints are where the scenario file puts them.

use slideway_conditioner::path::{Constraint, Motion};
use slideway_lab::conditioning::Shape3;
use slideway_scenario::ConditioningScenario;

/// `σ` of the only constraint, of this shape, at a place.
fn sigma(shape: &str, position: [f64; 3]) -> f64 {
    let problem = scenario(shape).problem().expect("valid");
    problem.constraints[0].sample(&Motion { time: 0.0, position, velocity: [0.0; 3] }).value
}

fn scenario(shape: &str) -> ConditioningScenario {
    let text = format!(
        r#"
        [reference]
        end = 1
        rate = 1
        position.formula = {{ x = "0", y = "0.5 * lambda", z = "0" }}
        [[constraint]]
        name = "wall"
        approach = 0.1
        shape.{shape}
        [conditioner]
        sampling_period = 1e-3
        push_cutoff = 20
        law.normalised.amplitude = 1
        "#
    );
    ConditioningScenario::parse("shapes", &text).expect("a scenario")
}

#[test]
fn a_half_space_ends_where_normal_times_position_is_its_offset() {
    for shape in [
        "half-space = { normal = [0, 2, 0], offset = 0.2 }",
        r#"polytope = { normals = [[0, 2, 0]], offsets = [0.2], sharpness = 50, side = "inside" }"#,
        r#"polytope = { normals = [[0, -2, 0]], offsets = [-0.2], sharpness = 50, side = "outside" }"#,
    ] {
        // 2 y = 0.2 at y = 0.1, and σ is a distance in metres. A few roundings.
        assert!(sigma(shape, [7.0, 0.1, -3.0]).abs() < 1e-15, "{shape}");
        assert!((sigma(shape, [0.0, 0.35, 0.0]) - 0.25).abs() < 1e-15, "{shape}");
    }
}

#[test]
fn what_baselines_read_of_a_half_space_is_the_plane_itself() {
    let problem = scenario("half-space = { normal = [0, 3, 4], offset = 10 }").problem().expect("valid");
    let Shape3::HalfSpace { normal, offset, .. } = &problem.constraints[0].shape else { panic!("a half-space") };
    assert_eq!((*normal, *offset), ([0.0, 0.6, 0.8], 2.0));
}

#[test]
fn a_polytope_is_made_of_the_faces_given_and_does_not_ask_for_their_order() {
    let faces = |normals: &str, offsets: &str, side: &str| {
        format!(r#"polytope = {{ normals = [{normals}], offsets = [{offsets}], sharpness = 50, side = "{side}" }}"#)
    };
    let (place, near) = ([0.0, 0.2, 0.0], |a: f64, b: f64| assert!((a - b).abs() < 1e-14, "{a} instead of {b}"));
    // The second face is 5 m away: its share, exp(-250), is below rounding.
    for inside in [faces("[0, 1, 0], [1, 0, 0]", "0.2, 5", "inside"), faces("[1, 0, 0], [0, 1, 0]", "5, 0.2", "inside")]
    {
        near(sigma(&inside, place), 0.0);
    }
    for outside in
        [faces("[0, 1, 0], [1, 0, 0]", "0.2, 5", "outside"), faces("[1, 0, 0], [0, 1, 0]", "5, 0.2", "outside")]
    {
        near(sigma(&outside, place), 2.0_f64.ln() / 50.0);
    }
    // On an edge both count alike.
    near(sigma(&faces("[0, 1, 0], [1, 0, 0]", "0.2, 0.3", "inside"), [0.3, 0.2, 9.0]), 2.0_f64.ln() / 50.0);
}
