//! The statement about a path conditioner.

use super::contact::ContactSignals;
use super::entry::{ROOM, at_most, failing, room, shown_down, shown_up, up_to};
use super::observed::{Observed, Reading};
use super::recovery::{recovered, recovery_rate};
use super::{Guarantee, Hypothesis, Relation, Statement};
use crate::error::VerifyError;
use slideway_conditioner::path::SwitchingLaw;
use slideway_lab::conditioning::{
    ConditionedTrace, ConditioningProblem, MarginChoice, PathMethod, PathMethodSummary, Phase, run_conditioner,
};

/// Rounding of `φ`: some 30 operations on positions of up to 10 m, and the smallest push's systems with conditions of up to 1e2, m.
const ROUNDING: f64 = 1e-11;

/// Everything a statement is assembled from.
pub(crate) struct ConditioningCase {
    pub(crate) problem: ConditioningProblem,
    pub(crate) method: PathMethod,
    /// The run without a trial's disturbances.
    pub(crate) trace: ConditionedTrace,
    nominal: ContactSignals,
    measured: Measured,
}

/// Measured values of the quantities that the guarantees bound, from one run, m.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Measured {
    phi: f64,
    sigma: f64,
    chattering: Option<f64>,
}

/// True if a run gave out its last position again at some sample.
pub(super) fn any_held(trace: &ConditionedTrace) -> bool {
    trace.samples.iter().any(|sample| sample.phase == Phase::Held)
}

fn measured(problem: &ConditioningProblem, trace: &ConditionedTrace) -> Measured {
    let summary = PathMethodSummary::new(problem, trace, None, None);
    let largest = |values: &mut dyn Iterator<Item = f64>| {
        values.fold(f64::NEG_INFINITY, |a, b| if b.is_nan() { f64::INFINITY } else { a.max(b) })
    };
    Measured {
        phi: largest(&mut summary.max_phi_m.iter().map(|phi| phi.unwrap_or(f64::INFINITY))),
        sigma: largest(&mut summary.max_sigma_m.iter().copied()),
        chattering: summary.chattering.map(|c| c.measured),
    }
}

impl Statement {
    /// States the guarantees of a conditioning scenario, for the sliding mode or another form of the conditioner.
    ///
    /// Runs the scenario once without disturbances.
    ///
    /// # Errors
    ///
    /// A scenario that cannot be used.
    pub fn for_conditioning(problem: ConditioningProblem, method: PathMethod) -> Result<Self, VerifyError> {
        ConditioningCase::new(problem, method)?.statement()
    }
}

impl ConditioningCase {
    pub(crate) fn new(problem: ConditioningProblem, method: PathMethod) -> Result<Self, VerifyError> {
        if !method.is_conditioner() {
            return Err(VerifyError::NoClaims { method: method.name().to_owned() });
        }
        let trace = run_conditioner(&problem, method)?;
        let nominal = ContactSignals::of(&problem, &trace);
        let measured = measured(&problem, &trace);
        Ok(Self { problem, method, trace, nominal, measured })
    }

    /// Signals of the run without disturbances.
    pub(crate) fn nominal(&self) -> &ContactSignals {
        &self.nominal
    }

    /// True if the reference reached its end.
    pub(crate) fn completed(&self) -> bool {
        self.trace.finish_s.is_some()
    }

    /// # Errors
    ///
    /// A start outside that the scenario cannot be run from.
    pub(crate) fn statement(&self) -> Result<Statement, VerifyError> {
        if self.method == PathMethod::SlidingModePaper {
            let remark = "Nothing is stated for the appendix's scheme, in which a push takes effect over three samples and its drift cannot be \
                          told from it: `sliding-mode` and `sliding-mode-implicit` have bounds.";
            let method = self.method.name().to_owned();
            return Ok(Statement {
                method,
                hypotheses: Vec::new(),
                guarantees: Vec::new(),
                remarks: vec![remark.into()],
            });
        }
        let statement = Statement {
            method: self.method.name().to_owned(),
            hypotheses: self.hypotheses(),
            guarantees: self.guarantees()?,
            remarks: self.remarks(),
        };
        Ok(statement.keep_what_holds())
    }

    /// True if the margin is that of the band, which follows the gradients.
    fn band(&self) -> bool {
        self.method == PathMethod::SlidingMode && self.problem.margin == MarginChoice::Band
    }

    fn reserve(&self) -> Option<f64> {
        recovery_rate(&self.problem, self.method)
    }

    /// Signals that the bounds are stated for: those of the run with room.
    fn declared(&self) -> ContactSignals {
        let n = &self.nominal;
        ContactSignals {
            push_share: 1.0,
            held: 0.0,
            reserve: 0.0,
            rise: room(n.rise),
            // A fall by drift is harmless; room for a quarter of the rise where the run has none.
            fall: room(n.fall).max(0.25 * n.rise),
            push: room(n.push),
            bulge: room(n.bulge),
            margin: if self.band() { n.margin / (1.0 + ROOM) } else { n.margin },
            start: n.start,
        }
    }

    fn hypotheses(&self) -> Vec<Hypothesis> {
        let (problem, n, declared) = (&self.problem, &self.nominal, self.declared());
        let period = problem.sampling_period;
        let mut list = Vec::new();
        let mut add = |name: &str, claim: &str, text: &str, unit: &str, value: f64, needed: f64| {
            list.push(Hypothesis { value, needed, ..at_most(name, claim, text, unit) });
        };
        add(
            "cutoff-step",
            "path-band",
            "cutoff times sampling period: the push takes effect slower than it is decided",
            "1",
            problem.push_cutoff * period,
            1.0,
        );
        add(
            "bulge",
            "path-lag",
            "rise of φ between two samples, from its second differences",
            "m",
            n.bulge,
            declared.bulge,
        );
        add("held", "path-implicit", "share of samples at which the reference was held", "1", n.held, 0.0);
        if self.method == PathMethod::SlidingMode {
            add(
                "rise",
                "path-band",
                "largest rise of φ over one sample beside a constraint without its push",
                "m",
                n.rise,
                declared.rise,
            );
            add("push", "path-band", "largest full push of one sample on φ", "m", n.push, declared.push);
            add(
                "fall",
                "path-band",
                "largest fall of φ over one sample of contact by its drift alone",
                "m",
                n.fall,
                declared.fall,
            );
        }
        if self.method == PathMethod::SlidingMode && self.reserve().is_some() && n.reserve == 0.0 {
            add("reserve", "path-reserve", "share of samples that the reserve answered", "1", n.reserve, 0.0);
        }
        if self.method == PathMethod::SlidingMode && self.reserve().is_none() {
            let text =
                "drift of φ over the push against it, at samples at which the constraint acts: gain against push";
            add("push-share", "path-band", text, "1", n.push_share, 1.0);
        }
        if self.band() {
            let text = "smallest margin of the band along the run";
            let margin = at_most("margin", "path-reserve", text, "m");
            list.push(Hypothesis { value: n.margin, relation: Relation::AtLeast, needed: declared.margin, ..margin });
        }
        for one in &mut list {
            one.remedy = match one.name.as_str() {
                "cutoff-step" => failing(one, || {
                    format!("`conditioner.sampling_period`: at most {}", shown_down(1.0 / problem.push_cutoff))
                }),
                "push-share" => failing(one, || self.stronger_push(one.value)),
                _ => None,
            };
        }
        list.extend(self.approach());
        list
    }

    fn stronger_push(&self, share: f64) -> String {
        if !share.is_finite() {
            return "no length of the push is enough: constraints that act together share it, and it drives one of them outwards; set \
                    `conditioner.reserve_rate`, or use `--method sliding-mode-implicit`"
                .into();
        }
        let by = |value: f64| shown_up(1.1 * share * value);
        match self.problem.law {
            SwitchingLaw::Normalised { amplitude } => {
                format!("`conditioner.law.normalised.amplitude`: at least {}", by(amplitude))
            }
            SwitchingLaw::Sum { gain } => format!("`conditioner.law.sum.gain`: at least {}", by(gain)),
        }
    }

    /// The smallest approach time beside the sampling period.
    fn approach(&self) -> Option<Hypothesis> {
        let all = self.problem.constraints.iter().map(|c| c.approach).enumerate();
        let (index, least) = all.min_by(|a, b| a.1.total_cmp(&b.1))?;
        let text = "smallest approach time: the boundary is neared over more than one sample";
        let mut one = at_most("approach-time", "path-lag", text, "s");
        (one.value, one.relation, one.needed) = (least, Relation::AtLeast, self.problem.sampling_period);
        one.remedy = failing(&one, || format!("`constraint.{index}.approach`: at least {}", shown_up(one.needed)));
        Some(one)
    }

    /// Upper bound on `φ`, the claim and what it rests on.
    fn phi(&self) -> (f64, &'static str, Vec<&'static str>) {
        let d = self.declared();
        let (bound, claim, rests) = match self.method {
            PathMethod::SlidingModeImplicit => (-d.margin, "path-implicit", vec!["held"]),
            _ if self.reserve().is_some() && self.problem.margin == MarginChoice::Band => {
                (0.0, "path-reserve", vec!["held"])
            }
            // From above the band its excess falls, while the band may grow by what the gradient does.
            _ if self.reserve().is_some() && d.start > d.push - d.margin => {
                (d.start + d.push, "path-reserve", vec!["push", "held"])
            }
            _ if self.reserve().is_some() => (d.push - d.margin, "path-reserve", vec!["push", "held"]),
            _ => (d.rise - d.margin, "path-band", vec!["cutoff-step", "rise", "push-share", "held"]),
        };
        (bound.max(d.start) + ROUNDING, claim, rests)
    }

    fn guarantees(&self) -> Result<Vec<Guarantee>, VerifyError> {
        let (declared, measured) = (self.declared(), &self.measured);
        let (phi, claim, mut rests) = self.phi();
        let text = "largest φ of any constraint at a sample";
        let mut list = vec![Guarantee { measured: Some(measured.phi), ..up_to("phi", claim, text, "m", phi, &rests) }];
        rests.extend(["bulge", "approach-time"]);
        // Claim `path-lag`: σ follows φ, which can bulge between samples.
        let sigma = (phi + declared.bulge).max(declared.start);
        let text = "largest σ of any constraint: how far it is broken, negative inside";
        list.push(Guarantee {
            measured: Some(measured.sigma),
            ..up_to("penetration", "path-lag", text, "m", sigma, &rests)
        });
        list.extend(self.chattering());
        list.extend(self.recovery()?);
        Ok(list)
    }

    /// While a constraint acts `φ` rises by no more than the push loses, and falls by no more than push and drift together. What the
    /// reserve adds for one constraint may move another by any amount: nothing is stated of runs that it answers.
    fn chattering(&self) -> Option<Guarantee> {
        if self.method != PathMethod::SlidingMode || self.nominal.reserve > 0.0 {
            return None;
        }
        let declared = self.declared();
        let text = "largest change of φ over one sample while its constraint acts";
        let bound = declared.rise.max(declared.push + declared.fall);
        let mut rests = vec!["rise", "push", "fall", "held"];
        rests.push(if self.reserve().is_some() { "reserve" } else { "push-share" });
        let guarantee = up_to("chattering", "path-band", text, "m", bound, &rests);
        Some(Guarantee { measured: self.measured.chattering, ..guarantee })
    }

    fn remarks(&self) -> Vec<String> {
        let mut list = vec![format!(
            "Bounds are stated for signals {:.0} % larger than those of the run without disturbances.",
            100.0 * ROOM
        )];
        if self.reserve().is_some() && self.method == PathMethod::SlidingMode {
            list.push(format!(
                "The reserve helps where the push is not enough; the push share was {:.3} at most.",
                self.nominal.push_share
            ));
        }
        list
    }
}

/// Reads a run in the terms of the statement: its hypotheses and its guarantees, by name.
pub(crate) fn observed(problem: &ConditioningProblem, trace: &ConditionedTrace) -> Observed {
    let (signals, measured) = (ContactSignals::of(problem, trace), measured(problem, trace));
    let hypotheses = [
        ("rise", signals.rise),
        ("push", signals.push),
        ("fall", signals.fall),
        ("bulge", signals.bulge),
        ("held", signals.held),
        ("reserve", signals.reserve),
        ("push-share", signals.push_share),
        ("margin", signals.margin),
    ];
    let guarantees = [
        ("phi", Some(measured.phi)),
        ("penetration", Some(measured.sigma)),
        ("chattering", measured.chattering),
        ("recovery", recovered(problem, trace)),
    ];
    let reading = |(name, value)| Reading { name, value };
    Observed {
        hypotheses: hypotheses.map(reading).to_vec(),
        guarantees: guarantees.into_iter().filter_map(|(name, value)| Some(reading((name, value?)))).collect(),
    }
}
