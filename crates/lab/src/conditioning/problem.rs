use super::constraint::NamedConstraint;
use super::disturbances::PathDisturbances;
use super::trace::MAX_CONSTRAINTS;
use slideway_conditioner::path::{Constraint, Motion, Reserve, SwitchingLaw, TrapSettings};
use slideway_path::{Fault, ListOf, NameFault, PositionCurve, ProblemError};
use std::ops::Range;

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
    /// Fallback of the explicit form for when its push is not enough.
    pub reserve: Reserve,
    /// Rate at which the implicit form comes back from outside, units of `σ` per second.
    pub recovery_rate: f64,
    /// Trap avoidance.
    pub trap: Option<TrapSettings>,
    /// Attraction of the potential field, 1/s.
    pub attraction: f64,
    /// Repulsion of the potential field, m⁴/s.
    pub repulsion: f64,
    /// Distance of influence of the potential field, m.
    pub influence: f64,
    /// Disturbances that the conditioner does not know of.
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
        // [G12] eq 1
        let [position, derivative, _] = self.curve.at(self.lambda(clock));
        Motion { time: t, position: position.into(), velocity: (derivative * (self.rate * pace)).into() }
    }

    /// A reference that runs along a curve over a range of the path parameter, at a rate in 1/s; given up after `max_duration`
    /// seconds, by default twenty times its own duration.
    ///
    /// # Errors
    ///
    /// A range that is empty; a rate or duration that is not positive; a curve without a finite value somewhere.
    pub fn new(
        curve: PositionCurve,
        range: Range<f64>,
        rate: f64,
        max_duration: Option<f64>,
    ) -> Result<Self, ProblemError> {
        let Range { start, end } = range;
        if !(start < end) {
            return Err(ProblemError::value("reference.end", Fault::NotIncreasing { before: start, after: end }));
        }
        positive("reference.rate", rate)?;
        let max_duration = max_duration.unwrap_or(20.0 * (end - start) / rate);
        positive("reference.max_duration", max_duration)?;
        let reference = Self { curve, start, end, rate, max_duration };
        for i in 0..=1000 {
            let clock = reference.duration() * f64::from(i) / 1000.0;
            if !reference.at(0.0, clock, 1.0).is_finite() {
                return Err(ProblemError::value("reference.position", Fault::UndefinedAt(reference.lambda(clock))));
            }
        }
        Ok(reference)
    }
}

fn positive(key: &str, value: f64) -> Result<(), ProblemError> {
    if value > 0.0 { Ok(()) } else { Err(ProblemError::value(key, Fault::NotPositive(value))) }
}

impl ConditioningProblem {
    /// A problem with the explicit form's law, no margin, no reserve, no trap avoidance, no disturbances, and the parameters of the
    /// other methods by default. [`ConditioningProblem::check`] says whether it can be run.
    #[must_use]
    pub fn new(
        reference: Reference,
        constraints: Vec<NamedConstraint>,
        sampling_period: f64,
        push_cutoff: f64,
        law: SwitchingLaw,
    ) -> Self {
        Self {
            reference,
            constraints,
            sampling_period,
            push_cutoff,
            law,
            margin: MarginChoice::None,
            reserve: Reserve::Off,
            recovery_rate: 1.0,
            trap: None,
            attraction: 20.0,
            repulsion: 5e-6,
            influence: 0.1,
            disturbances: PathDisturbances::default(),
        }
    }

    /// Refuses what cannot be run.
    ///
    /// # Errors
    ///
    /// The first value that cannot be used, with its key: numbers that are not positive, no constraints or more than
    /// [`MAX_CONSTRAINTS`], names that are empty or stand twice, margins of another number, disturbances out of range, a constraint whose gradient vanishes on its boundary.
    pub fn check(&self) -> Result<(), ProblemError> {
        let count = self.constraints.len();
        if count == 0 || count > MAX_CONSTRAINTS {
            let fault = Fault::OutOfRange { value: count as f64, least: 1.0, most: MAX_CONSTRAINTS as f64 };
            return Err(ProblemError::value("constraint", fault));
        }
        self.check_names()?;
        if let MarginChoice::Fixed(margins) = &self.margin
            && margins.len() != count
        {
            let fault = Fault::WrongLength { found: margins.len(), expected: count, list: ListOf::Constraints };
            return Err(ProblemError::value("conditioner.margin.fixed", fault));
        }
        let (law_key, strength) = match self.law {
            SwitchingLaw::Normalised { amplitude } => ("conditioner.law.normalised.amplitude", amplitude),
            SwitchingLaw::Sum { gain } => ("conditioner.law.sum.gain", gain),
        };
        positive("conditioner.sampling_period", self.sampling_period)?;
        positive("conditioner.push_cutoff", self.push_cutoff)?;
        positive(law_key, strength)?;
        if let Reserve::On { recovery_rate } = self.reserve {
            positive("conditioner.reserve_rate", recovery_rate)?;
        }
        positive("conditioner.recovery_rate", self.recovery_rate)?;
        positive("potential_field.attraction", self.attraction)?;
        positive("potential_field.repulsion", self.repulsion)?;
        positive("potential_field.influence", self.influence)?;
        self.disturbances.check()?;
        self.check_gradients()
    }

    /// Names stand in the headings of tables: they are there, differ, and need no quotes.
    fn check_names(&self) -> Result<(), ProblemError> {
        for (i, constraint) in self.constraints.iter().enumerate() {
            let name = constraint.name.as_str();
            let reason = if name.trim().is_empty() {
                NameFault::Empty
            } else if name.contains(|c: char| c == ',' || c == '"' || c.is_control()) {
                NameFault::Character
            } else if self.constraints[..i].iter().any(|other| other.name == name) {
                NameFault::Repeated
            } else {
                continue;
            };
            return Err(ProblemError::value(
                format!("constraint.{i}.name"),
                Fault::Name { name: name.to_owned(), reason },
            ));
        }
        Ok(())
    }

    /// Looks for places on a boundary where its gradient vanishes: there no push has a direction.
    ///
    /// From points around the reference Newton's method goes down to the boundary; where `σ` ends small and its gradient
    /// much smaller than it began, the boundary is singular.
    fn check_gradients(&self) -> Result<(), ProblemError> {
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
                return Err(ProblemError::value(
                    format!("constraint.{index}.shape"),
                    Fault::VanishingGradient { near },
                ));
            }
        }
        Ok(())
    }
}

/// Length of the gradient on the boundary nearest to a point, as a multiple of its length where the search began; `None` if the
/// boundary was not found.
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
