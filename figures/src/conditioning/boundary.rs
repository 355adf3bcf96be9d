//! Where a constraint begins: the curve `σ = 0` in a plane, by marching squares, and hatching on its forbidden side.

use slideway_conditioner::path::{Constraint, Motion};
use slideway_lab::conditioning::{ConditioningProblem, NamedConstraint};
use std::collections::BTreeMap;
use std::ops::Range;

/// Cells along each side of the grid on which a boundary is looked for.
const CELLS: usize = 120;
/// Instants at which the reference is looked at.
const INSTANTS: usize = 1000;
/// Hatch lines across a view.
const HATCHES: usize = 26;
/// Points looked at along a hatch line.
const STEPS: usize = 240;

type Flat = [f64; 2];

/// One constraint as the figures show it: cut through the point at which the reference is deepest in what it forbids.
pub(crate) struct Boundary<'a> {
    constraint: &'a NamedConstraint,
    deepest: Motion<3>,
}

/// A plane along two of the axes with the part of it that is shown.
pub(crate) struct Slice<'a> {
    boundary: &'a Boundary<'a>,
    axes: [usize; 2],
    ranges: [Range<f64>; 2],
}

impl<'a> Boundary<'a> {
    pub(crate) fn new(problem: &ConditioningProblem, constraint: &'a NamedConstraint) -> Self {
        let at = |i: usize| {
            let clock = problem.reference.duration() * i as f64 / INSTANTS as f64;
            problem.reference.at(clock, clock, 1.0)
        };
        let depth = |motion: &Motion<3>| constraint.sample(motion).value;
        let deeper = |a: Motion<3>, b: Motion<3>| if depth(&b) > depth(&a) { b } else { a };
        Self { constraint, deepest: (1..=INSTANTS).map(at).fold(at(0), deeper) }
    }

    /// The plane along `axes` through the deepest point.
    pub(crate) fn slice(&'a self, axes: [usize; 2], ranges: [Range<f64>; 2]) -> Slice<'a> {
        Slice { boundary: self, axes, ranges }
    }
}

/// A side of a grid's cell: the grid point at its lower end, and whether it goes across or up.
type Side = (usize, usize, Direction);

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Direction {
    Across,
    Up,
}

impl Slice<'_> {
    /// A point of the plane in space.
    pub(crate) fn in_space(&self, p: Flat) -> [f64; 3] {
        let mut position = self.boundary.deepest.position;
        position[self.axes[0]] = p[0];
        position[self.axes[1]] = p[1];
        position
    }

    fn sigma(&self, p: Flat) -> f64 {
        let motion = Motion { position: self.in_space(p), velocity: [0.0; 3], ..self.boundary.deepest };
        self.boundary.constraint.sample(&motion).value
    }

    fn share(&self, across: f64, up: f64) -> Flat {
        let place = |range: &Range<f64>, share: f64| range.start + share * (range.end - range.start);
        [place(&self.ranges[0], across), place(&self.ranges[1], up)]
    }

    fn node(&self, i: usize, j: usize) -> Flat {
        self.share(i as f64 / CELLS as f64, j as f64 / CELLS as f64)
    }

    /// The curves `σ = 0`.
    pub(crate) fn contour(&self) -> Vec<Vec<Flat>> {
        let values: Vec<Vec<f64>> =
            (0..=CELLS).map(|i| (0..=CELLS).map(|j| self.sigma(self.node(i, j))).collect()).collect();
        let cells = (0..CELLS).flat_map(|i| (0..CELLS).map(move |j| (i, j)));
        let segments: Vec<[Side; 2]> = cells.flat_map(|(i, j)| segments(&values, i, j)).collect();
        let point = |side: &Side| self.crossing(&values, *side);
        chains(&segments).iter().map(|chain| chain.iter().map(point).collect()).collect()
    }

    /// Where `σ`, taken to be linear along the side, is zero.
    fn crossing(&self, values: &[Vec<f64>], (i, j, direction): Side) -> Flat {
        let (k, l) = if direction == Direction::Across { (i + 1, j) } else { (i, j + 1) };
        let (from, to) = (values[i][j], values[k][l]);
        let share = (from / (from - to)).clamp(0.0, 1.0);
        let (a, b) = (self.node(i, j), self.node(k, l));
        [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])]
    }

    /// Slanted lines through what is forbidden; `slant` is 1 for rising and −1 for falling ones.
    pub(crate) fn hatching(&self, slant: f64) -> Vec<[Flat; 2]> {
        (0..HATCHES).flat_map(|k| self.hatch(2.0 * (k as f64 + 0.5) / HATCHES as f64 - 1.0, slant)).collect()
    }

    /// The forbidden parts of the line that begins at height `start` left, in heights of the view.
    fn hatch(&self, start: f64, slant: f64) -> Vec<[Flat; 2]> {
        let at = |step: usize| {
            let across = step as f64 / STEPS as f64;
            let up = start + across;
            (up, self.share(across, if slant > 0.0 { up } else { 1.0 - up }))
        };
        let is_forbidden = |step: &usize| {
            let (up, p) = at(*step);
            (0.0..=1.0).contains(&up) && self.sigma(p) > 0.0
        };
        let steps: Vec<usize> = (0..=STEPS).filter(is_forbidden).collect();
        let runs = steps.chunk_by(|a, b| a + 1 == *b);
        runs.filter(|run| run.len() > 1).map(|run| [at(run[0]).1, at(run[run.len() - 1]).1]).collect()
    }
}

/// The pieces of the boundary in one cell, as pairs of the sides that they cross.
fn segments(values: &[Vec<f64>], i: usize, j: usize) -> Vec<[Side; 2]> {
    // Corners counterclockwise from the lower left, each with the side that follows it.
    let corners = [values[i][j], values[i + 1][j], values[i + 1][j + 1], values[i][j + 1]];
    if !corners.iter().all(|v| v.is_finite()) {
        return Vec::new();
    }
    let sides =
        [(i, j, Direction::Across), (i + 1, j, Direction::Up), (i, j + 1, Direction::Across), (i, j, Direction::Up)];
    let is_out = |k: usize| corners[k % 4] > 0.0;
    let crossed: Vec<Side> = (0..4).filter(|&k| is_out(k) != is_out(k + 1)).map(|k| sides[k]).collect();
    match crossed[..] {
        [a, b] => vec![[a, b]],
        // A saddle: the mean decides which pair of opposite corners is connected.
        [a, b, c, d] if is_out(0) == (corners.iter().sum::<f64>() > 0.0) => vec![[a, b], [c, d]],
        [a, b, c, d] => vec![[d, a], [b, c]],
        _ => Vec::new(),
    }
}

/// Joins segments that share a side into curves; closed ones end where they begin.
fn chains(segments: &[[Side; 2]]) -> Vec<Vec<Side>> {
    let mut next: BTreeMap<Side, Vec<Side>> = BTreeMap::new();
    for &[a, b] in segments {
        next.entry(a).or_default().push(b);
        next.entry(b).or_default().push(a);
    }
    let mut ends: Vec<Side> = next.iter().filter(|(_, joined)| joined.len() == 1).map(|(side, _)| *side).collect();
    // Open curves first: what is left after them is closed.
    ends.extend(next.keys().copied().collect::<Vec<_>>());
    ends.into_iter().map(|end| walk(&mut next, end)).filter(|chain| chain.len() > 1).collect()
}

/// Takes the curve that begins at `side` out of `next`.
fn walk(next: &mut BTreeMap<Side, Vec<Side>>, side: Side) -> Vec<Side> {
    let mut chain = vec![side];
    let mut here = side;
    while let Some(there) = next.get_mut(&here).and_then(Vec::pop) {
        if let Some(back) = next.get_mut(&there)
            && let Some(place) = back.iter().position(|s| *s == here)
        {
            back.swap_remove(place);
        }
        chain.push(there);
        here = there;
    }
    chain
}

#[cfg(test)]
mod tests {
    use super::*;
    use slideway_scenario::BUILT_IN;
    use slideway_scenario::ConditioningScenario;
    use std::error::Error;

    fn problem(name: &str) -> Result<ConditioningProblem, Box<dyn Error>> {
        let built_in = BUILT_IN.iter().find(|b| b.name == name).ok_or("no such scenario")?;
        Ok(ConditioningScenario::parse(built_in.name, built_in.text)?.problem()?)
    }

    #[test]
    fn the_slice_of_a_sphere_is_one_closed_circle() -> Result<(), Box<dyn Error>> {
        let problem = problem("helix-plane-sphere")?;
        let sphere = problem.constraints.iter().find(|c| c.name == "sphere").ok_or("no sphere")?;
        let boundary = Boundary::new(&problem, sphere);
        let slice = boundary.slice([0, 1], [-0.1..0.1, -0.1..0.1]);
        let contour = slice.contour();
        assert_eq!(contour.len(), 1);
        assert_eq!(contour[0].first(), contour[0].last());
        for p in &contour[0] {
            let radius = slice.in_space(*p).iter().map(|x| x * x).sum::<f64>().sqrt();
            // Linear interpolation over a cell of h = 0.2 / 120 errs by at most h² / (8 r), with r the radius of the
            // circle, at least 0.02 here; twice that for cells cut aslant.
            assert!((radius - 0.05).abs() < 4e-5, "{radius}");
        }
        Ok(())
    }

    #[test]
    fn a_plane_is_hatched_on_its_forbidden_side_only() -> Result<(), Box<dyn Error>> {
        let problem = problem("helix-plane-sphere")?;
        let plane = problem.constraints.iter().find(|c| c.name == "plane").ok_or("no plane")?;
        let boundary = Boundary::new(&problem, plane);
        for slant in [1.0, -1.0] {
            let hatching = boundary.slice([0, 1], [-0.1..0.1, -0.1..0.1]).hatching(slant);
            assert!(hatching.len() > HATCHES / 2);
            assert!(hatching.iter().flatten().all(|p| p[1] > 0.0));
        }
        Ok(())
    }

    #[test]
    fn a_saddle_is_cut_into_two_pieces_that_do_not_cross() {
        let values = vec![vec![1.0, -1.0], vec![-1.0, 1.0]];
        let pieces = segments(&values, 0, 0);
        assert_eq!(pieces.len(), 2);
        assert!(pieces[0].iter().all(|side| !pieces[1].contains(side)));
    }

    #[test]
    fn a_cell_with_a_value_that_is_no_number_is_left_out() {
        assert!(segments(&[vec![f64::NAN, -1.0], vec![-1.0, 1.0]], 0, 0).is_empty());
    }
}
