use super::*;
use crate::path::vector::{difference, norm};
use proptest::prelude::*;

#[test]
fn one_half_space_is_the_closed_form() {
    let found = smallest_correction(&[[3.0, 4.0]], &[-5.0]).expect("one half-space is never contradictory");
    // u = g b / gᵀg: three roundings of numbers below 1.
    assert!((found.vector[0] + 0.6).abs() < 1e-15 && (found.vector[1] + 0.8).abs() < 1e-15);
}

#[test]
fn opposite_half_spaces_without_overlap_contradict() {
    let found = smallest_correction(&[[1.0, 0.0], [-1.0, 0.0]], &[-1.0, -1.0]);
    assert!(matches!(found, Err(NoCorrection::Contradiction(_))));
}

#[test]
fn an_empty_row_that_asks_for_something_contradicts() {
    assert_eq!(smallest_correction(&[[0.0, 0.0]], &[-1.0]), Err(NoCorrection::Contradiction(0)));
}

#[test]
fn the_closed_form_acts_with_exactly_the_half_spaces_that_exclude_the_origin() {
    // Orthogonal rows: λ = -b / gᵀg of each by itself. The third passes through the origin, the fourth has room.
    let rows = [[2.0, 0.0], [0.0, 4.0], [1.0, 1.0], [1.0, -1.0]];
    let set = ActiveSet::of_violated(&rows, &[-3.0, -8.0, 0.0, 5.0]);
    assert_eq!(set.active, [true, true, false, false]);
    assert_eq!(set.multipliers, [0.75, 0.5, 0.0, 0.0]);
    assert_eq!(set.u, [-1.5, -2.0]);
}

/// The answer `u = (1.5, 0)` to `-2 x <= -3` and `y <= 5`, the first half-space missed by `miss`.
fn answer_that_misses_by(miss: f64) -> ActiveSet<2, 2> {
    ActiveSet { u: [1.5 - 0.5 * miss, 0.0], multipliers: [0.75, 0.0], active: [true, false] }
}

const PLANTED: [[f64; 2]; 2] = [[-2.0, 0.0], [0.0, 1.0]];

#[test]
fn a_closed_form_is_kept_if_it_solves_its_equations_to_the_rounding_of_their_terms() {
    // The terms are ‖g‖ ‖u‖ = 3 and |b| = 3: together √18 = 4.243, times MET. A miss is exact to 5e-16.
    for (miss, kept) in [(0.0, true), (4.1e-13, true), (-4.1e-13, true), (4.4e-13, false), (-4.4e-13, false)] {
        let set = answer_that_misses_by(miss);
        assert_eq!(set.is_optimal(&PLANTED, &[-3.0, 5.0]), kept, "missed by {miss}");
    }
}

#[test]
fn a_closed_form_that_pulls_violates_or_is_no_number_is_given_up() {
    let good = || answer_that_misses_by(0.0);
    assert!(good().is_optimal(&PLANTED, &[-3.0, 5.0]));
    assert!(!good().is_optimal(&PLANTED, &[-3.0, -1.0]), "y <= -1 is violated");
    assert!(!ActiveSet { multipliers: [-0.75, 0.0], ..good() }.is_optimal(&PLANTED, &[-3.0, 5.0]));
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(!ActiveSet { u: [1.5, bad], ..good() }.is_optimal(&PLANTED, &[-3.0, f64::INFINITY]), "{bad}");
        assert!(!ActiveSet { multipliers: [f64::NAN, 0.0], ..good() }.is_optimal(&PLANTED, &[-3.0, 5.0]));
    }
}

#[test]
fn a_violation_counts_from_the_rounding_of_its_terms_on() {
    // gᵀu = 3 exactly, so that the excess is a whole number of the spacing 2⁻⁵¹ of numbers there; the terms amount to
    // √18 = 4.243 and to 9.55 spacings after ROUNDING.
    let set = ActiveSet { u: [1.5, 0.0], multipliers: [0.0], active: [false] };
    let found = |spacings: f64| set.most_violated(&[[2.0, 0.0]], &[3.0 - 2.0 * spacings * f64::EPSILON]);
    assert_eq!((found(-10.0), found(0.0), found(9.0), found(10.0)), (None, None, None, Some(0)));
}

#[test]
fn of_half_spaces_violated_by_equal_distances_the_first_enters_and_a_member_never() {
    // x <= -1 twice, in other units, and x <= -2.
    let (rows, bounds) = ([[1.0], [2.0], [1.0]], [-1.0, -2.0, -2.0]);
    let with = |active| ActiveSet { u: [0.0], multipliers: [0.0; 3], active };
    assert_eq!(with([false; 3]).most_violated(&rows, &bounds), Some(2));
    assert_eq!(with([false, false, true]).most_violated(&rows, &bounds), Some(0));
    assert_eq!(with([true, false, true]).most_violated(&rows, &bounds), Some(1));
    assert_eq!(with([true; 3]).most_violated(&rows, &bounds), None);
}

#[test]
fn the_steps_of_a_correction_are_counted_and_end_at_the_stated_number() {
    let enter = |mut steps: u32| {
        let mut set = ActiveSet { u: [0.0], multipliers: [0.0], active: [false] };
        set.enter(0, &[[1.0]], &[-1.0], &mut steps).map(|()| (set.u, steps))
    };
    let most = largest_step_count(1);
    assert_eq!(enter(0), Ok(([-1.0], 1)));
    assert_eq!(enter(most - 1), Ok(([-1.0], most)));
    assert_eq!(enter(most), Err(NoCorrection::Cycling));
}

#[test]
fn a_multiplier_that_vanishes_just_as_the_boundary_is_reached_costs_no_step_of_its_own() {
    // From u = -g₁ the step of x + y <= -2 ends at u = -g₂, where λ₁ = 0: complete after one step.
    let mut set = ActiveSet { u: [-1.0, 0.0], multipliers: [1.0, 0.0], active: [true, false] };
    let mut steps = 0;
    assert_eq!(set.enter(1, &[[1.0, 0.0], [1.0, 1.0]], &[-1.0, -2.0], &mut steps), Ok(()));
    assert_eq!((set.u, set.multipliers, steps), ([-1.0, -1.0], [0.0, 1.0], 1));
}

#[test]
fn orthogonal_half_spaces_do_not_block_one_another_whatever_the_sign_of_a_zero() {
    // g₁ᵀ g₂ is +0 with the first of these and -0 with the second, and so is the dual direction.
    for zero in [0.0, -0.0] {
        let mut set = ActiveSet { u: [-1.0, 0.0], multipliers: [1.0, 0.0], active: [true, false] };
        let entered = set.enter(1, &[[1.0, 0.0], [zero, -1.0]], &[-1.0, -2.0], &mut 0);
        assert_eq!((entered, set.u, set.multipliers), (Ok(()), [-1.0, 2.0], [1.0, 2.0]), "{zero}");
    }
}

#[test]
fn a_normal_within_a_ten_millionth_of_the_active_ones_depends_on_them() {
    // From u = -g₁ the half-space -c x + y <= c - 1 needs the step to y = -1, which rounding can no longer tell from none.
    for (c, found) in [(0.9e7, Ok(())), (1.1e7, Err(NoCorrection::Contradiction(1)))] {
        let mut set = ActiveSet { u: [-1.0, 0.0], multipliers: [1.0, 0.0], active: [true, false] };
        assert_eq!(set.enter(1, &[[1.0, 0.0], [-c, 1.0]], &[-1.0, c - 1.0], &mut 0), found, "{c}");
        assert_eq!(set.u, if found.is_ok() { [-1.0, -1.0] } else { [-1.0, 0.0] });
    }
}

#[test]
fn the_units_of_a_constraint_do_not_matter() {
    // x <= -1 and y <= bound, which answer for x + y <= -1/2 as well: three equations in two unknowns, so that the closed form
    // fails and the active set decides.
    for unit in [1e-6, 1.0, 1e6] {
        for bound in [-0.25, -1.0] {
            let rows = [[1.0, 0.0], [0.0, 1.0], [1.0, 1.0]].map(|g: [f64; 2]| g.map(|x| unit * x));
            let found =
                smallest_correction(&rows, &[-unit, unit * bound, -0.5 * unit]).expect("the half-spaces overlap");
            // Some ten roundings of numbers around 1.
            assert!(norm(&difference(&found.vector, &[-1.0, bound])) < 2e-15, "{unit}: {found:?}");
        }
    }
}

proptest! {
    /// Naive twin: the distances themselves, with their roots.
    #[test]
    fn the_half_space_that_enters_is_the_one_farthest_away(
        rows in proptest::array::uniform5(proptest::array::uniform3(-1.0..1.0_f64)),
        units in proptest::array::uniform5(-3.0..3.0_f64),
        u in proptest::array::uniform3(-2.0..2.0_f64),
        offsets in proptest::array::uniform5(-2.0..2.0_f64),
        active in proptest::array::uniform5(proptest::bool::ANY),
    ) {
        let rows: [[f64; 3]; 5] = core::array::from_fn(|i| rows[i].map(|g| g * 10_f64.powf(units[i])));
        let bounds: [f64; 5] = core::array::from_fn(|i| offsets[i] * 10_f64.powf(units[i]));
        let mut farthest = None;
        let mut largest = 0.0;
        for i in (0..5).filter(|&i| !active[i]) {
            let distance = (dot(&rows[i], &u) - bounds[i]) / dot(&rows[i], &rows[i]).sqrt();
            if distance > largest {
                (farthest, largest) = (Some(i), distance);
            }
        }
        let set = ActiveSet { u, multipliers: [0.0; 5], active };
        prop_assert_eq!(set.most_violated(&rows, &bounds), farthest);
    }

    /// Half-spaces around a common point never contradict; the answer satisfies the optimality conditions.
    #[test]
    fn the_answer_is_feasible_stationary_and_complementary(
        rows in proptest::array::uniform5(proptest::array::uniform3(-1.0..1.0_f64)),
        inner in proptest::array::uniform3(-2.0..2.0_f64),
        room in proptest::array::uniform5(0.01..1.0_f64),
    ) {
        let bounds: [f64; 5] = core::array::from_fn(|i| dot(&rows[i], &inner) + room[i]);
        let found = smallest_correction(&rows, &bounds).expect("a common point exists");
        let mut stationary = found.vector;
        for (row, m) in rows.iter().zip(&found.multipliers) {
            prop_assert!(*m >= 0.0);
            stationary = add_scaled(&stationary, *m, row);
        }
        let scale = 1.0 + found.multipliers.iter().sum::<f64>();
        // Cancellation among multipliers of size `scale`, conditioned no worse than 1/sqrt(DEPENDENT) = 1e7.
        prop_assert!(dot(&stationary, &stationary).sqrt() <= 1e-9 * scale);
        for ((row, b), m) in rows.iter().zip(&bounds).zip(&found.multipliers) {
            let slack = b - dot(row, &found.vector);
            prop_assert!(slack >= -1e-8 * scale);
            prop_assert!(*m == 0.0 || slack.abs() <= 1e-8 * scale);
        }
    }
}
