use super::constraint::NamedConstraint;
use super::disturbances::PathDisturbances;
use super::schema::{ConditionerTable, ConditioningFile, LawTable, MarginTable, ReferenceTable, TrapTable, WalkTable};
use super::trace::MAX_CONSTRAINTS;
use crate::error::{Fault, LabError, ListOf};
use crate::path::position::PositionCurve;
use crate::path::waypoint_reader::Place;
use crate::scenario::number::Number;
use slideway_conditioner::path::{Constraint, Motion, Reserve, SwitchingLaw, TrapSettings, Walk};
use std::path::Path;

/// A reference with its constraints and the parameters of every method.
#[derive(Clone, Debug)]
pub struct ConditioningProblem {
    /// The reference.
    pub reference: Reference,
    /// The constraints, at most [`MAX_CONSTRAINTS`].
    pub constraints: Vec<NamedConstraint>,
    /// Sampling period, s.
    pub sampling_period: f64,
    /// Cutoff `α1` of the push filter, rad/s.
    pub push_cutoff: f64,
    /// Switching law of the explicit forms.
    pub law: SwitchingLaw,
    /// Safety margin of the explicit form.
    pub margin: MarginChoice,
    /// What helps the explicit form when its push is not enough.
    pub reserve: Reserve,
    /// How fast the implicit form comes back from outside, units of `σ` per second.
    pub recovery_rate: f64,
    /// Trap avoidance.
    pub trap: Option<TrapSettings>,
    /// Attraction of the potential field, 1/s.
    pub attraction: f64,
    /// Repulsion of the potential field, m⁴/s.
    pub repulsion: f64,
    /// Distance of influence of the potential field, m.
    pub influence: f64,
    /// What the conditioner does not know of.
    pub disturbances: PathDisturbances,
}

/// Safety margin, for any number of constraints.
#[derive(Clone, Debug, PartialEq)]
pub enum MarginChoice {
    /// Nothing.
    None,
    /// The proven band.
    Band,
    /// One margin per constraint.
    Fixed(Vec<f64>),
}

/// A reference that runs along a curve at a constant rate.
#[derive(Clone, Debug)]
pub struct Reference {
    curve: PositionCurve,
    start: f64,
    end: f64,
    rate: f64,
    max_duration: f64,
}

impl Reference {
    /// Path parameter after `clock` seconds of motion.
    #[must_use]
    pub fn lambda(&self, clock: f64) -> f64 {
        self.start + self.rate * clock
    }

    /// Seconds of motion from start to end.
    #[must_use]
    pub fn duration(&self) -> f64 {
        (self.end - self.start) / self.rate
    }

    /// Time after which a run is given up, s.
    #[must_use]
    pub fn max_duration(&self) -> f64 {
        self.max_duration
    }

    /// The motion at time `t` when the reference's own clock shows `clock` and runs at `pace` of its rate.
    #[must_use]
    pub fn at(&self, t: f64, clock: f64, pace: f64) -> Motion<3> {
        let [position, derivative, _] = self.curve.at(self.lambda(clock));
        Motion { time: t, position: position.into(), velocity: (derivative * (self.rate * pace)).into() }
    }

    fn new(table: &ReferenceTable, folder: &Path) -> Result<Self, LabError> {
        let (start, end) = (table.start.0, table.end.0);
        if !(start < end) {
            return Err(LabError::value("reference.end", Fault::NotIncreasing { before: start, after: end }));
        }
        let rate = positive("reference.rate", table.rate)?;
        let place = Place { key: "reference.position".to_owned(), folder, range: start..end };
        let curve = PositionCurve::new(&table.position, &place)?;
        let default = 20.0 * (end - start) / rate;
        let max_duration = table.max_duration.map_or(Ok(default), |d| positive("reference.max_duration", d))?;
        let reference = Self { curve, start, end, rate, max_duration };
        for i in 0..=1000 {
            let clock = reference.duration() * f64::from(i) / 1000.0;
            if !reference.at(0.0, clock, 1.0).is_finite() {
                return Err(LabError::value("reference.position", Fault::UndefinedAt(reference.lambda(clock))));
            }
        }
        Ok(reference)
    }
}

fn positive(key: &str, number: Number) -> Result<f64, LabError> {
    if number.0 > 0.0 { Ok(number.0) } else { Err(LabError::value(key, Fault::NotPositive(number.0))) }
}

impl ConditioningProblem {
    pub(crate) fn new(file: &ConditioningFile, folder: &Path) -> Result<Self, LabError> {
        if file.constraint.is_empty() || file.constraint.len() > MAX_CONSTRAINTS {
            let fault =
                Fault::OutOfRange { value: file.constraint.len() as f64, least: 1.0, most: MAX_CONSTRAINTS as f64 };
            return Err(LabError::value("constraint", fault));
        }
        let constraints = file
            .constraint
            .iter()
            .enumerate()
            .map(|(i, table)| NamedConstraint::new(table, i))
            .collect::<Result<Vec<_>, _>>()?;
        let conditioner = &file.conditioner;
        let field = &file.potential_field;
        let problem = Self {
            reference: Reference::new(&file.reference, folder)?,
            margin: margin(conditioner, constraints.len())?,
            constraints,
            sampling_period: positive("conditioner.sampling_period", conditioner.sampling_period)?,
            push_cutoff: positive("conditioner.push_cutoff", conditioner.push_cutoff)?,
            law: match &conditioner.law {
                LawTable::Normalised { amplitude } => SwitchingLaw::Normalised {
                    amplitude: positive("conditioner.law.normalised.amplitude", *amplitude)?,
                },
                LawTable::Sum { gain } => SwitchingLaw::Sum { gain: positive("conditioner.law.sum.gain", *gain)? },
            },
            reserve: match conditioner.reserve_rate {
                Some(rate) => Reserve::On { recovery_rate: positive("conditioner.reserve_rate", rate)? },
                None => Reserve::Off,
            },
            recovery_rate: conditioner.recovery_rate.map_or(Ok(1.0), |r| positive("conditioner.recovery_rate", r))?,
            trap: file.trap.as_ref().map(trap),
            attraction: field.attraction.map_or(Ok(20.0), |v| positive("potential_field.attraction", v))?,
            repulsion: field.repulsion.map_or(Ok(5e-6), |v| positive("potential_field.repulsion", v))?,
            influence: field.influence.map_or(Ok(0.1), |v| positive("potential_field.influence", v))?,
            disturbances: PathDisturbances::read(&file.disturbances)?,
        };
        file.verify.read()?;
        problem.check_gradients()?;
        Ok(problem)
    }

    /// Looks for places on a boundary where its gradient vanishes: there no push has a direction.
    ///
    /// From points around the reference Newton's method goes down to the boundary; where `σ` ends small and its gradient
    /// much smaller than it began, the boundary is singular.
    fn check_gradients(&self) -> Result<(), LabError> {
        for (index, constraint) in self.constraints.iter().enumerate() {
            let (mut singular, mut regular) = (None, 0_usize);
            for i in 0..200 {
                let clock = self.reference.duration() * f64::from(i % 50) / 49.0;
                let reference = self.reference.at(clock, clock, 1.0);
                match boundary_gradient(constraint, &reference, i) {
                    Some(ratio) if ratio < 1e-4 => singular = Some(reference.position),
                    Some(_) => regular += 1,
                    None => {}
                }
            }
            if let Some(near) = singular
                && regular == 0
            {
                return Err(LabError::value(format!("constraint.{index}.shape"), Fault::VanishingGradient { near }));
            }
        }
        Ok(())
    }
}

/// How long the gradient is on the boundary nearest to a point, relative to where the search began; `None` if the boundary
/// was not found.
fn boundary_gradient(constraint: &NamedConstraint, reference: &Motion<3>, seed: i32) -> Option<f64> {
    // Quasi-random offsets of up to 0.1 m: multiples of irrational numbers, the same at every run.
    let offset = |factor: f64| 0.2 * (f64::from(seed) * factor).fract() - 0.1;
    let [x, y, z] = reference.position;
    let mut motion = Motion {
        position: [x + offset(0.754_877), y + offset(0.569_840), z + offset(0.430_160)],
        velocity: [0.0; 3],
        ..*reference
    };
    let square = |g: &[f64; 3]| g.iter().map(|g| g * g).sum::<f64>();
    let first = constraint.sample(&motion);
    let (size, start) = (first.value.abs(), square(&first.gradient).sqrt());
    for _ in 0..200 {
        let sample = constraint.sample(&motion);
        let slope = square(&sample.gradient);
        if sample.value.abs() <= 1e-12 * size || !(slope > 0.0) {
            return (sample.value.abs() <= 1e-9 * size && start > 0.0).then(|| slope.sqrt() / start);
        }
        for (p, g) in motion.position.iter_mut().zip(&sample.gradient) {
            *p -= sample.value * g / slope;
        }
    }
    None
}

fn margin(table: &ConditionerTable, constraints: usize) -> Result<MarginChoice, LabError> {
    Ok(match &table.margin {
        MarginTable::None => MarginChoice::None,
        MarginTable::Band => MarginChoice::Band,
        MarginTable::Fixed(margins) if margins.len() == constraints => {
            MarginChoice::Fixed(margins.iter().map(|m| m.0).collect())
        }
        MarginTable::Fixed(margins) => {
            let fault = Fault::WrongLength { found: margins.len(), expected: constraints, list: ListOf::Constraints };
            return Err(LabError::value("conditioner.margin.fixed", fault));
        }
    })
}

fn trap(table: &TrapTable) -> TrapSettings {
    TrapSettings {
        walk_cutoff: table.walk_cutoff.0,
        pace_cutoff: table.pace_cutoff.0,
        walk: match table.walk {
            WalkTable::Paper => Walk::Paper,
            WalkTable::Safe { push_share } => Walk::Safe { push_share: push_share.0 },
        },
        walk_speed: table.walk_speed.0,
        walk_growth: table.walk_growth.map_or(table.walk_speed.0, |g| g.0),
        return_gain: table.return_gain.0,
        direction_period: table.direction_period.0,
        distance_threshold: table.distance_threshold.0,
        clearance_threshold: table.clearance_threshold.0,
        activity_threshold: table.activity_threshold.0,
        seed: table.seed,
    }
}
