use super::{Placed, empty, instants, sample, share_deviation};
use slideway_baselines::projection::beside_ball::BesideBall;
use slideway_baselines::projection::convex::{self, ConvexSet};
use slideway_baselines::projection::multi_start::{Effort, nearest};
use slideway_baselines::projection::outside_ellipsoid::OutsideEllipsoid;
use slideway_baselines::projection::{Projection, ProjectionError};
use slideway_conditioner::path::Motion;
use slideway_conditioner::shapes::Side;
use slideway_lab::conditioning::{ConditionedTrace, ConditioningProblem, NamedConstraint, PathMethod, Phase, Shape3};

/// Way in which the projections were found, and their worth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProjectionKind {
    /// A closed form for this very set: the nearest point of all.
    ClosedForm,
    /// A convex program, each answer bracketed by a lower bound.
    Convex,
    /// Descents from several starts: a local optimum, the nearest of those found.
    MultiStart,
}

impl ProjectionKind {
    /// In words, for tables.
    #[must_use]
    pub fn describe(self) -> &'static str {
        match self {
            Self::ClosedForm => "closed form, globally optimal",
            Self::Convex => "convex program, globally optimal, bracketed",
            Self::MultiStart => "several starts, locally optimal",
        }
    }
}

/// The projection of every reference point.
#[derive(Clone, Debug, PartialEq)]
pub struct ProjectedTrace {
    /// The points.
    pub trace: ConditionedTrace,
    /// Way in which they were found.
    pub kind: ProjectionKind,
    /// Largest `distance - lower bound` over the points, m; for [`ProjectionKind::MultiStart`] the largest step a further
    /// descent would make.
    pub worst_gap: f64,
}

/// Samples after which a followed local optimum is compared with others again.
const LOOK_AROUND: usize = 50;

/// The set that a scenario's constraints describe, as far as a closed form or a convex program knows it.
enum Set<'a> {
    BesideBall(BesideBall),
    OutsideEllipsoid(OutsideEllipsoid<3>),
    Convex(Vec<ConvexSet<3>>),
    General(&'a ConditioningProblem),
}

/// Projects every point of the reference onto the allowed set.
///
/// # Errors
///
/// A point without a projection: the set is empty there, or the solver failed.
pub fn projection_trace(problem: &ConditioningProblem) -> Result<ProjectedTrace, ProjectionError> {
    let set = Set::new(problem);
    let mut projected =
        ProjectedTrace { trace: empty(problem, PathMethod::Projection), kind: set.kind(), worst_gap: 0.0 };
    let mut last = None;
    for (k, reference) in instants(problem).enumerate() {
        let effort = if k % LOOK_AROUND == 0 { Effort::Many } else { Effort::Follow };
        let found = set.project(&reference, last, effort)?;
        last = Some(found.point);
        projected.worst_gap = projected.worst_gap.max(found.distance - found.lower_bound);
        let motion = Motion { position: found.point, ..reference };
        let placed = Placed { motion, has_velocity: false, phase: Phase::Free };
        let mut sample = sample(problem, &reference, &placed);
        share_deviation(&mut sample, problem.constraints.len(), |s, i| s.sigma[i]);
        projected.trace.samples.push(sample);
    }
    Ok(projected)
}

/// Projects the end of the reference onto the allowed set as it is at a time, s: where a conditioned point should come to rest.
///
/// # Errors
///
/// No projection: the set is empty then, or the solver failed.
pub fn projected_end(problem: &ConditioningProblem, time: f64) -> Result<Projection<3>, ProjectionError> {
    let end = problem.reference.at(time, problem.reference.duration(), 0.0);
    Set::new(problem).project(&end, None, Effort::Many)
}

impl<'a> Set<'a> {
    fn new(problem: &'a ConditioningProblem) -> Self {
        if problem.constraints.iter().any(NamedConstraint::is_carried) {
            return Self::General(problem);
        }
        let shapes: Vec<&Shape3> = problem.constraints.iter().map(|c| &c.shape).collect();
        match shapes.as_slice() {
            [Shape3::HalfSpace { normal, offset, .. }, Shape3::Ball { centre, radius, side: Side::Outside, .. }]
            | [Shape3::Ball { centre, radius, side: Side::Outside, .. }, Shape3::HalfSpace { normal, offset, .. }] => {
                Self::BesideBall(BesideBall { normal: *normal, offset: *offset, centre: *centre, radius: *radius })
            }
            [Shape3::Ellipsoid { centre, semi_axes, side: Side::Outside, .. }] => {
                Self::OutsideEllipsoid(OutsideEllipsoid { centre: *centre, semi_axes: *semi_axes })
            }
            [Shape3::Ball { centre, radius, side: Side::Outside, .. }] => {
                Self::OutsideEllipsoid(OutsideEllipsoid { centre: *centre, semi_axes: [*radius; 3] })
            }
            shapes => {
                shapes.iter().map(|s| convex_set(s)).collect::<Option<_>>().map_or(Self::General(problem), Self::Convex)
            }
        }
    }

    fn kind(&self) -> ProjectionKind {
        match self {
            Self::BesideBall(_) | Self::OutsideEllipsoid(_) => ProjectionKind::ClosedForm,
            Self::Convex(_) => ProjectionKind::Convex,
            Self::General(_) => ProjectionKind::MultiStart,
        }
    }

    fn project(
        &self,
        reference: &Motion<3>,
        last: Option<[f64; 3]>,
        effort: Effort,
    ) -> Result<Projection<3>, ProjectionError> {
        match self {
            Self::BesideBall(set) => set.project(&reference.position),
            Self::OutsideEllipsoid(set) => set.project(&reference.position),
            Self::Convex(sets) if sets.iter().all(|s| s.violation(&reference.position) <= 0.0) => {
                Ok(Projection { point: reference.position, distance: 0.0, lower_bound: 0.0, violation: 0.0 })
            }
            Self::Convex(sets) => convex::project(&reference.position, sets),
            Self::General(problem) => nearest(&problem.constraints, reference, last, effort)
                // A local optimum that ends is no reason to give up.
                .or_else(|_| nearest(&problem.constraints, reference, last, Effort::Many)),
        }
    }
}

fn convex_set(shape: &Shape3) -> Option<ConvexSet<3>> {
    match shape {
        Shape3::HalfSpace { normal, offset, .. } => Some(ConvexSet::HalfSpace { normal: *normal, offset: *offset }),
        Shape3::Ball { centre, radius, side: Side::Inside, .. } => {
            Some(ConvexSet::Ellipsoid { centre: *centre, semi_axes: [*radius; 3] })
        }
        Shape3::Ellipsoid { centre, semi_axes, side: Side::Inside, .. } => {
            Some(ConvexSet::Ellipsoid { centre: *centre, semi_axes: *semi_axes })
        }
        _ => None,
    }
}
