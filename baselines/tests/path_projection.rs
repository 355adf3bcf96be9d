//! Exact projections: against one another, against their own certificates and against the figures of an independent run.

#[path = "../../crates/conditioner/tests/support/mod.rs"]
mod support;

use proptest::prelude::*;
use slideway_baselines::projection::beside_ball::BesideBall;
use slideway_baselines::projection::branch_and_bound::{Bounded, Search, project as branch_and_bound};
use slideway_baselines::projection::convex::{ConvexSet, project};
use slideway_baselines::projection::outside_ellipsoid::OutsideEllipsoid;
use slideway_baselines::projection::{Projection, ProjectionError};
use slideway_conditioner::shapes::{Ball, BoothOval, Ellipsoid, HalfSpace, Side};
use support::helix_beside_sphere;

const FIRST: BesideBall = BesideBall { normal: [0.0, 1.0, 0.0], offset: 0.0, centre: [0.0; 3], radius: 0.05 };

#[test]
fn the_projection_of_the_first_example_deviates_as_the_independent_simulation_says() {
    let (mut sum, mut largest) = (0.0, 0.0_f64);
    for k in 0..5000 {
        let (p, _) = helix_beside_sphere(std::f64::consts::TAU * f64::from(k) / 5000.0);
        let found = FIRST.project(&p).expect("a finite point");
        assert!(found.violation <= 1e-15, "violated by {}", found.violation);
        sum += found.distance;
        largest = largest.max(found.distance);
    }
    let mean = 1e3 * sum / 5000.0;
    assert!((mean - 4.52).abs() <= 0.05, "mean {mean} mm");
    assert!((1e3 * largest - 37.6).abs() <= 0.05, "largest {} mm", 1e3 * largest);
}

fn near(search: f64) -> Search {
    Search { reach: search, gap: 2e-4, boxes: 2_000_000 }
}

#[test]
fn branch_and_bound_brackets_the_closed_form_beside_a_ball() {
    let plane = HalfSpace::new(&FIRST.normal, 0.0).expect("a normal");
    let ball = Ball::new(FIRST.centre, FIRST.radius, Side::Outside).expect("a radius");
    let set = [Bounded { constraint: &plane, lipschitz: 1.0 }, Bounded { constraint: &ball, lipschitz: 1.0 }];
    for k in 0..40 {
        let (p, _) = helix_beside_sphere(2.3 + 0.04 * f64::from(k));
        let exact = FIRST.project(&p).expect("a finite point");
        let found = branch_and_bound(&p, &set, near(0.1)).expect("a bracket");
        assert!(found.lower_bound <= exact.distance + 1e-12, "{found:?} {exact:?}");
        // The descent ends at rounding; its point is allowed, so it is no nearer than the optimum.
        assert!(found.distance >= exact.distance - 1e-12 && found.distance <= exact.distance + 2e-4);
    }
}

#[test]
fn branch_and_bound_brackets_the_closed_form_outside_an_ellipsoid() {
    let axes = [0.8, 0.8, 0.1];
    let exact = OutsideEllipsoid { centre: [0.0; 3], semi_axes: axes };
    let shape = Ellipsoid::new([0.0; 3], &axes, 0.1, Side::Outside).expect("positive semi-axes");
    // ∇σ = 0.1 D⁻¹ (a unit vector): at most 0.1 / 0.1.
    let set = [Bounded { constraint: &shape, lipschitz: 1.0 }];
    for p in [[0.1, 0.0, 0.05], [0.1, 0.02, -0.01], [0.3, -0.2, 0.0], [0.0; 3]] {
        let closed = exact.project(&p).expect("a finite point");
        assert!(closed.distance - closed.lower_bound <= 1e-8, "the closed form's own bracket: {closed:?}");
        let found = branch_and_bound(&p, &set, near(0.15)).expect("a bracket");
        assert!(found.lower_bound <= closed.distance + 1e-12 && found.distance <= closed.distance + 2e-4);
    }
}

#[test]
fn branch_and_bound_brackets_the_third_and_fourth_example() {
    let left = Ellipsoid::new([-0.55, 0.0, 0.0], &[0.8, 0.8, 0.1], 0.1, Side::Outside).expect("positive");
    let right = Ellipsoid::new([0.55, 0.0, 0.0], &[0.8, 0.8, 0.1], 0.1, Side::Outside).expect("positive");
    let both = [Bounded { constraint: &left, lipschitz: 1.0 }, Bounded { constraint: &right, lipschitz: 1.0 }];
    let found = branch_and_bound(&[0.0, 0.05, 0.02], &both, near(0.15)).expect("a bracket");
    assert!(found.distance - found.lower_bound <= 2e-4 && found.violation <= 1e-12, "{found:?}");

    let oval = BoothOval::new([1.0, 1.0, 0.3], 0.5, Side::Outside).expect("positive weights");
    // ‖∇σ‖ <= 2‖p‖/n + ‖p‖²‖W² p‖/n³ <= (2 + 1) (‖p‖/n) <= 3 / 0.3 everywhere, since ‖W² p‖ <= n.
    let set = [Bounded { constraint: &oval, lipschitz: 10.0 }];
    let found = branch_and_bound(&[0.1, 0.0, 0.1], &set, near(0.2)).expect("a bracket");
    assert!(found.distance - found.lower_bound <= 2e-4 && found.violation <= 1e-12, "{found:?}");
}

#[test]
fn an_empty_search_and_an_exhausted_one_say_so() {
    let ball = Ball::new([0.0; 3], 1.0, Side::Outside).expect("a radius");
    let set = [Bounded { constraint: &ball, lipschitz: 1.0 }];
    let small = Search { reach: 0.1, gap: 1e-3, boxes: 100_000 };
    assert_eq!(branch_and_bound(&[0.0, 0.0, 0.1], &set, small).map(|p| p.distance.is_finite()), Ok(true));
    let starved = Search { reach: 2.0, gap: 1e-9, boxes: 10 };
    assert!(matches!(branch_and_bound(&[0.1, 0.2, 0.3], &set, starved), Err(ProjectionError::Budget { .. })));
    assert_eq!(FIRST.project(&[f64::NAN, 0.0, 0.0]), Err(ProjectionError::NotFinite));
}

fn sets() -> [ConvexSet<3>; 3] {
    [
        ConvexSet::HalfSpace { normal: [1.0, 1.0, 0.5], offset: 0.3 },
        ConvexSet::Ellipsoid { centre: [0.1, 0.0, 0.0], semi_axes: [0.9, 0.5, 0.7] },
        ConvexSet::Cylinder { point: [0.0, 0.1, 0.0], axis: [0.0, 0.0, 1.0], radius: 0.6 },
    ]
}

#[test]
fn sets_without_a_common_point_are_called_empty() {
    let apart = [
        ConvexSet::HalfSpace { normal: [1.0, 0.0, 0.0], offset: -1.0 },
        ConvexSet::HalfSpace { normal: [-1.0, 0.0, 0.0], offset: -1.0 },
    ];
    assert_eq!(project(&[0.0; 3], &apart), Err(ProjectionError::Empty));
}

fn bracket_holds(found: &Projection<3>) -> bool {
    // 1e-12 in the squared distance is at most 1e-6 in the distance, and 1e-12 / d away from the set. Constraints are kept to 1e-7 of
    // `1 + ‖b‖ + ‖x‖ + ‖s‖` where the solver gets no farther: below 10 for points and sets of this size; a cone's distance has a factor 2.
    found.lower_bound <= found.distance + 1e-9 && found.distance - found.lower_bound <= 2e-6 && found.violation <= 2e-6
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn the_conic_projection_closes_its_own_bracket(p in prop::array::uniform3(-2.0..2.0_f64)) {
        let found = project(&p, &sets()).expect("the sets share a neighbourhood of the origin");
        prop_assert!(bracket_holds(&found), "{found:?}");
    }

    /// Naive twin of the conic program: a single ball has the projection everyone knows.
    #[test]
    fn the_conic_projection_onto_a_ball_is_the_radial_one(p in prop::array::uniform3(-2.0..2.0_f64)) {
        let length = p.iter().map(|x| x * x).sum::<f64>().sqrt();
        let ball = [ConvexSet::Ellipsoid { centre: [0.0; 3], semi_axes: [0.5; 3] }];
        let found = project(&p, &ball).expect("a ball is not empty");
        let exact = if length > 0.5 { p.map(|x| 0.5 * x / length) } else { p };
        prop_assert!(support::distance(&found.point, &exact) <= 1e-7, "{found:?} {exact:?}");
    }

    #[test]
    fn the_ellipsoid_projection_is_certified_by_its_own_lower_bound(
        p in prop::array::uniform3(-0.3..0.3_f64),
        axes in prop::array::uniform3(0.1..1.0_f64),
    ) {
        let found = OutsideEllipsoid { centre: [0.0; 3], semi_axes: axes }.project(&p).expect("a finite point");
        // A point that is a share v short of the boundary is brought onto it by moving it v times the longest axis, below 1, at most.
        prop_assert!(found.lower_bound <= found.distance + found.violation.max(0.0) + 1e-12);
        // Bisection leaves one bit of t, relative to the shortest axis' square; the squares lose half the digits.
        prop_assert!(found.distance - found.lower_bound <= 1e-7, "{found:?}");
        prop_assert!(found.violation <= 1e-6, "{found:?}");
    }
}
