//! The statement about a speed law.

use super::observed::{Observed, Reading};
use super::path_drift::{Asked, PathDrift};
use super::signals::{Loop, SETTLED, SpeedMeasures, SpeedSignals};
use super::entry::{ROOM, at_most, failing, room, shown_down, shown_up, up_to};
use super::{Guarantee, Hypothesis, Relation, Statement};
use crate::error::VerifyError;
use serde::{Deserialize, Serialize};
use slideway_baselines::time_optimal::time_optimum;
use slideway_conditioner::bounds::{ProgressSums, Signals, TravelInputs, travel_bracket};
use slideway_lab::{Experiment, Method, SampledPath, Scenario};

/// Samples between the grid points of the optimum at which the path's drift is read.
const BETWEEN: usize = 7;

/// What a statement about a speed law rests on, as numbers.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SpeedNumbers {
    /// Certified optimum under the speed limits alone, s.
    pub optimum_s: f64,
    /// Rate at which the filter falls, `-ln(1 - a) / Ts`, 1/s.
    pub filter_fall_rate: f64,
    /// Rate at which the limit falls along the path at the pace of the loop, 1/s.
    pub drift_rate: f64,
    /// The same from half as many samples, 1/s: whether the number has settled.
    pub drift_rate_coarse: f64,
    /// Largest path rate that the limits allow anywhere, 1/s.
    pub fastest_rate: f64,
    /// Largest overspeed along the path, `λ̇d / λ̇*`.
    pub overspeed: f64,
    /// Largest change of the demand over one sample, a share of the limits, without the filter's part.
    pub demand_change: f64,
    /// Samples at which the path was read.
    pub path_samples: usize,
}

/// The hypotheses about sums over the motion: name, text, and which sum.
type Sum = fn(&ProgressSums) -> f64;
const TIMES: [(&str, &str, Sum); 4] = [
    ("feedback-time", "integral of E over the motion", |s| s.feedback),
    ("overrun-time", "integral of (m - 1)+ over the motion, m the demand's use of a limit", |s| s.overrun),
    ("shift-time", "integral of (1 + E + (m - 1)+)|1 - b_path/b|: feedforward as seen beside the path's", |s| s.shift),
    ("hold-back-time", "time that filter, feedback and drift can hold the reference back", |s| s.held_back),
];

/// Everything a statement is assembled from.
pub(crate) struct SpeedCase {
    pub(crate) looked: Loop,
    pub(crate) numbers: SpeedNumbers,
    asked: Asked,
    pace: f64,
    nominal: SpeedSignals,
    measures: SpeedMeasures,
    declared: Declared,
    optimum: [f64; 2],
    acceleration: Option<Vec<f64>>,
    peak_acceleration: Vec<f64>,
    varying: bool,
}

/// What the bounds are stated for: the nominal numbers with room.
struct Declared {
    whole: Signals,
    settled: Option<Signals>,
    feedback: f64,
    sums: ProgressSums,
    trail: f64,
    contraction: f64,
}

fn with_room(signals: &Signals, surplus: f64) -> Signals {
    Signals {
        feedback: room(signals.feedback),
        overspeed: room(signals.overspeed),
        rise: room(signals.rise),
        surplus: room(signals.surplus.max(surplus)),
        released_change: room(signals.released_change),
        braked_change: room(signals.braked_change),
        demand_change: room(signals.demand_change),
        start: signals.start,
    }
}

impl Declared {
    fn new(nominal: &SpeedSignals, looked: &Loop, asked: &Asked) -> Self {
        let period = looked.control.sampling_period;
        let gain_step = looked.control.gain * period;
        let surplus = if asked.surplus.is_finite() { asked.surplus } else { 0.0 };
        Self {
            whole: with_room(&nominal.whole, surplus),
            settled: nominal.settled.as_ref().map(|s| with_room(s, surplus)),
            feedback: room(nominal.feedback),
            sums: ProgressSums {
                feedback: room(nominal.sums.feedback),
                overrun: room(nominal.sums.overrun),
                shift: room(nominal.sums.shift),
                held_back: room(nominal.sums.held_back) + 2.0,
                pace: room(nominal.sums.pace),
            },
            trail: room(nominal.trail).max(1.0),
            contraction: (1.0 - 0.5 * gain_step).max(0.5 * (1.0 + nominal.contraction)),
        }
    }
}

/// The loop a run of this scenario is judged in, and its path.
fn loop_on(scenario: &Scenario, experiment: &Experiment, method: Method) -> Result<(Loop, SampledPath), VerifyError> {
    let path = experiment.sample(scenario.grid_points(), BETWEEN)?;
    let limits = Loop::limits(&path).ok_or(VerifyError::NoLimits)?;
    let found = time_optimum(&nodes_alone(&path))?;
    let looked = Loop {
        method,
        control: experiment.control(),
        limits,
        drift: PathDrift::new(&path),
        optimum: [found.duration_s, found.lower_s, found.upper_s],
        by_joints: follows_joints(scenario),
    };
    Ok((looked, path))
}

/// The loop alone.
pub(crate) fn observed_loop(scenario: &Scenario, experiment: &Experiment, method: Method) -> Result<Loop, VerifyError> {
    Ok(loop_on(scenario, experiment, method)?.0)
}

/// The grid that `compare` solves for the optimum on, under the speed limits alone.
fn nodes_alone(path: &SampledPath) -> SampledPath {
    let mut path = path.under_speed_limits_alone();
    for piece in &mut path.pieces {
        piece.between.iter_mut().for_each(Vec::clear);
    }
    path
}

fn follows_joints(scenario: &Scenario) -> bool {
    let document: Option<toml::Table> = scenario.text().parse().ok();
    document.is_some_and(|d| d.get("path").and_then(|path| path.get("joints")).is_some())
}

impl SpeedCase {
    pub(crate) fn new(scenario: &Scenario, experiment: &Experiment, method: Method) -> Result<Self, VerifyError> {
        let (looked, path) = loop_on(scenario, experiment, method)?;
        let trace = experiment.run(method)?;
        let (nominal, measures) = (looked.signals(&trace), looked.measures(&trace));
        let ([optimum_s, lower_s, upper_s], closed) = (looked.optimum, path.speed_limited_time());
        let (pace, asked) = pace(&looked, &nominal);
        let (fastest, slowest) = looked.drift.slowness_range();
        let fall = fall_rate(&looked);
        let numbers = SpeedNumbers {
            optimum_s,
            filter_fall_rate: fall,
            drift_rate: asked.fall_rate,
            drift_rate_coarse: looked.drift.halved().asked(pace, fall, looked.control.sampling_period).fall_rate,
            fastest_rate: 1.0 / fastest,
            overspeed: looked.control.target_rate * slowest,
            demand_change: nominal.settled.unwrap_or(nominal.whole).demand_change,
            path_samples: looked.drift.samples(),
        };
        let peak_acceleration = slideway_lab::MethodSummary::new(&trace).peak_acceleration;
        Ok(Self {
            declared: Declared::new(&nominal, &looked, &asked),
            numbers,
            asked,
            pace,
            nominal,
            measures,
            optimum: [lower_s.min(closed), upper_s.max(closed)],
            acceleration: path.acceleration.clone(),
            peak_acceleration,
            varying: limits_vary(&path),
            looked,
        })
    }
}

/// Whether speed limits hold at some places only, or limit the tool: then the regulator's filter does not see what bounds the rate.
fn limits_vary(path: &SampledPath) -> bool {
    path.pieces.iter().flat_map(|piece| &piece.nodes).any(|node| !node.speeds.is_empty())
}

fn fall_rate(looked: &Loop) -> f64 {
    -(-looked.step()).ln_1p() / looked.control.sampling_period
}

/// `R`: at most the path rate over `λ̇*` once settled, and what the path asks at that pace.
///
/// Where the reference waits, `R = 1 + E`. In the published advance `R = Z e^S`, and `S` depends on `R`: a fixed point from below.
fn pace(looked: &Loop, nominal: &SpeedSignals) -> (f64, Asked) {
    let (fall, period) = (fall_rate(looked), looked.control.sampling_period);
    let settled = nominal.settled.unwrap_or(nominal.whole);
    let waits = looked.method != Method::SlidingMode;
    let mut pace = 1.0 + room(settled.feedback);
    let mut asked = looked.drift.asked(pace, fall, period);
    if waits {
        return (pace, asked);
    }
    let (_, slowest) = looked.drift.slowness_range();
    for _ in 0..50 {
        let drift = looked.drift.sample_drift(pace, period);
        let signals = Signals {
            feedback: room(settled.feedback),
            overspeed: looked.control.target_rate * slowest,
            rise: drift,
            surplus: asked.surplus,
            ..Signals::NONE
        };
        let next = signals.feedforward_band(looked.step());
        if !(next.is_finite() && next < 1e3) {
            return (next, Asked { fall_rate: f64::INFINITY, surplus: f64::INFINITY });
        }
        let settled = next <= pace * (1.0 + 1e-9);
        pace = next.max(pace);
        asked = looked.drift.asked(pace, fall, period);
        if settled {
            break;
        }
    }
    (pace, asked)
}

impl Statement {
    /// What is guaranteed of a speed scenario, for the method that `compare` judges or another one.
    ///
    /// Runs the scenario once without disturbances; solves for the certified optimum under the speed limits.
    ///
    /// # Errors
    ///
    /// A scenario that cannot be used, or a path without an optimum.
    pub fn for_speed(scenario: &Scenario, method: Option<Method>) -> Result<Self, VerifyError> {
        let experiment = Experiment::new(scenario)?;
        let method = method.map_or_else(|| experiment.judged_method(scenario), Ok)?;
        Ok(SpeedCase::new(scenario, &experiment, method)?.statement())
    }
}

impl SpeedCase {
    /// How much of the chattering's bound a unit of the filter step makes: the overspeed, with its room.
    pub(crate) fn chattering_per_step(&self) -> f64 {
        self.declared.whole.overspeed
    }

    pub(crate) fn statement(&self) -> Statement {
        let method = self.looked.method;
        let mut statement = Statement {
            method: method.name().to_owned(),
            hypotheses: Vec::new(),
            guarantees: Vec::new(),
            remarks: self.remarks(),
        };
        if method != Method::Ideal {
            statement.guarantees.push(self.command());
        }
        if method.limits_acceleration() {
            statement.guarantees.extend(self.accelerations());
        }
        if method.bounds_chattering() && !self.varying {
            statement.hypotheses = self.hypotheses();
            statement.guarantees.extend(self.demand());
            statement.guarantees.extend(self.times());
        }
        statement.keep_what_holds()
    }

    fn implicit(&self) -> bool {
        self.looked.method == Method::SlidingModeImplicit
    }

    fn hypotheses(&self) -> Vec<Hypothesis> {
        let mut list = self.settings();
        if !self.implicit() {
            list.push(self.drift());
        }
        list.extend(self.signals());
        list
    }

    /// Those about the scenario's settings.
    fn settings(&self) -> Vec<Hypothesis> {
        let control = &self.looked.control;
        let period = control.sampling_period;
        let mut gain = at_most("gain-step", "drift-with-feedback", "Kp Ts: the position loop does not overshoot", "1");
        (gain.value, gain.needed) = (control.gain * period, 1.0);
        gain.remedy = failing(&gain, || format!("`control.gain`: at most {}", shown_down(1.0 / period)));
        let text = "target rate over the largest path rate that the limits allow: the reference is asked to go faster than the joints can";
        let mut target = at_most("target-rate", "time-with-feedback", text, "1/s");
        target.relation = Relation::AtLeast;
        (target.value, target.needed) = (control.target_rate, self.numbers.fastest_rate);
        target.remedy = failing(&target, || format!("`control.target_rate`: at least {}", shown_up(target.needed)));
        vec![gain, target]
    }

    /// Drift against filter.
    fn drift(&self) -> Hypothesis {
        let text = "rate at which the filter falls, -ln(1 - a)/Ts, beside the steepest fall of the limit along the path at the loop's pace";
        let mut drift = at_most("drift-against-filter", "signal-band", text, "1/s");
        drift.relation = Relation::AtLeast;
        (drift.value, drift.needed) = (self.numbers.filter_fall_rate, self.asked.fall_rate);
        drift.remedy = failing(&drift, || self.faster_filter());
        drift
    }

    /// The bandwidth at which the filter falls as fast as the limit: `a = 1 - exp(-rate Ts)`. A faster filter also widens the pace of
    /// the published advance a little, for which the room is added.
    fn faster_filter(&self) -> String {
        let period = self.looked.control.sampling_period;
        if !self.asked.fall_rate.is_finite() {
            return "no `control.bandwidth` is enough: the limit falls without bound where the path meets a singularity; lead it around, or use \
                    `sliding-mode-implicit`"
                .to_owned();
        }
        let step = -(-self.asked.fall_rate * (1.0 + 0.5 * ROOM) * period).exp_m1();
        format!("`control.bandwidth`: at least {}", shown_up(step / period))
    }

    /// Those about the signals of the run.
    fn signals(&self) -> Vec<Hypothesis> {
        let (nominal, declared, a) = (&self.nominal, &self.declared, self.looked.step());
        let mut list = Vec::new();
        let mut add = |name: &str, claim: &str, text: &str, unit: &str, value: f64, needed: f64| {
            let mut one = at_most(name, claim, text, unit);
            (one.value, one.needed) = (value, needed);
            list.push(one);
        };
        if self.implicit() {
            add("feedback-inside", "implicit-band", "E, the feedback's largest use of a limit while the reference moves", "limits", nominal.feedback, 1.0);
        } else {
            let text = "band that the signals prove: from feedback, feedforward and their changes as the regulator sees them";
            add("signal-band", "signal-band", text, "limits", nominal.whole.band(a), declared.whole.band(a));
            if let (Some(seen), Some(stated)) = (&nominal.settled, &declared.settled) {
                let text = "the same once the feedback uses at most 5 % of the limits";
                add("signal-band-settled", "signal-band", text, "limits", seen.band(a), stated.band(a));
            }
        }
        let text = "largest change of the demand over one sample that the signals prove";
        add("signal-chattering", "chattering-band", text, "limits", self.chattering(&nominal.whole), self.chattering(&declared.whole));
        if let (Some(seen), Some(stated)) = (&nominal.settled, &declared.settled) {
            let text = "the same once the feedback uses at most 5 % of the limits";
            add("signal-chattering-settled", "chattering-band", text, "limits", self.chattering(seen), self.chattering(stated));
        }
        let time = "time-with-feedback";
        add("feedback", "signal-band", "E, the feedback's largest use of a limit while the reference moves", "limits", nominal.feedback, declared.feedback);
        let text = "largest path rate that the signals allow, over the path's own limit";
        add("pace", time, text, "1", nominal.sums.pace, declared.sums.pace);
        let period = self.looked.control.sampling_period;
        for (name, text, sum) in TIMES {
            add(name, time, text, "s", period * sum(&nominal.sums), period * sum(&declared.sums));
        }
        add("trail", time, "distance from the path's end when the reference is there, in tolerances of arrival", "1", nominal.trail, declared.trail);
        add("settling", time, "largest ratio of that distance to the one a sample before", "1", nominal.contraction, declared.contraction);
        list
    }

    fn chattering(&self, signals: &Signals) -> f64 {
        chattering(&self.looked, signals)
    }

    fn command(&self) -> Guarantee {
        let text = "largest use of a joint-speed limit by a command";
        Guarantee { measured: Some(self.measures.command), ..up_to("command", "command-within-limits", text, "limits", 1.0, &[]) }
    }

    /// Rounding: command and change are rounded once each, claim `acceleration-box`.
    fn accelerations(&self) -> Option<Guarantee> {
        let limits = self.acceleration.as_ref()?;
        let period = self.looked.control.sampling_period;
        let share = |values: &[f64]| values.iter().zip(limits).map(|(v, limit)| v / limit).fold(0.0, f64::max);
        let speeds = self.looked.limits.upper().iter().zip(self.looked.limits.lower()).map(|(up, lo)| up.max(-lo));
        let rounding = speeds.zip(limits).map(|(v, limit)| 4.0 * f64::EPSILON * (1.0 + v / (limit * period))).fold(0.0, f64::max);
        let text = "largest use of a joint-acceleration limit by the change of a command";
        let one = up_to("command-acceleration", "acceleration-box", text, "limits", 1.0 + rounding, &[]);
        Some(Guarantee { measured: Some(share(&self.peak_acceleration)), ..one })
    }

    fn demand(&self) -> Vec<Guarantee> {
        let (declared, a) = (&self.declared, self.looked.step());
        let mut list = Vec::new();
        let text = "largest use of a limit by the desired joint speed while the reference moves: what exceeds 1 is cut off";
        let settled = "the same once the feedback uses at most 5 % of the limits";
        if self.implicit() {
            let rounding = implicit_rounding(&self.looked);
            list.push(self.one("demand", "implicit-band", text, 1.0 + rounding, &["feedback-inside"], Some(self.measures.demand)));
        } else {
            // A last step cut short lies between A and the whole one: once settled A is inside the band anyway.
            let cut = declared.settled.map_or(declared.feedback, |s| s.feedback);
            let bound = declared.whole.band(a).max(cut);
            let mut rests = vec!["signal-band"];
            rests.push(if declared.settled.is_some() { "signal-band-settled" } else { "feedback" });
            list.push(self.one("demand", "signal-band", text, bound, &rests, Some(self.measures.demand)));
            if let Some(stated) = &declared.settled {
                let bound = stated.band(a);
                list.push(self.one("demand-settled", "signal-band", settled, bound, &["signal-band-settled"], self.measures.demand_settled));
            }
        }
        let claim = if self.implicit() { "implicit-chattering" } else { "chattering-band" };
        let text = "largest change of a desired joint speed over one sample";
        list.push(self.one("chattering", claim, text, self.chattering(&declared.whole), &["signal-chattering"], self.measures.chattering));
        if let Some(stated) = &declared.settled {
            let bound = self.chattering(stated);
            list.push(self.one("chattering-settled", claim, settled, bound, &["signal-chattering-settled"], self.measures.chattering_settled));
        }
        list
    }

    fn one(&self, name: &str, claim: &str, text: &str, bound: f64, rests_on: &[&str], measured: Option<f64>) -> Guarantee {
        Guarantee { measured, ..up_to(name, claim, text, "limits", bound, rests_on) }
    }

    fn times(&self) -> Vec<Guarantee> {
        let declared = &self.declared;
        let (period, drift) = (self.looked.control.sampling_period, &self.looked.drift);
        let published = self.looked.method == Method::SlidingMode;
        let inputs = TravelInputs {
            sums: ProgressSums { overrun: if published { declared.sums.overrun } else { 0.0 }, ..declared.sums },
            optimum: self.optimum,
            period,
            variation: drift.variation(),
            sample_drift: drift.sample_drift(declared.sums.pace, period),
        };
        let Some([lower, upper]) = travel_bracket(&inputs).filter(|_| !drift.breaks()) else { return Vec::new() };
        let mut rests = vec!["target-rate", "pace"];
        rests.extend(TIMES.iter().map(|(name, ..)| *name).filter(|name| published || *name != "overrun-time"));
        let time = |name: &str, text: &str, unit: &str, ends: [f64; 2], rests: &[&str], measured: Option<f64>| Guarantee {
            lower: Some(ends[0]),
            measured,
            ..up_to(name, "time-with-feedback", text, unit, ends[1], rests)
        };
        let text = "from the start of motion to the reference's end";
        let mut list = vec![time("reference-time", text, "s", [lower, upper], &rests, self.measures.reference_s)];
        let settling = period * (2.0 + (declared.trail.ln() / -declared.contraction.ln()).ceil());
        if declared.contraction < 1.0 {
            rests.extend(["trail", "settling"]);
            let ends = [lower, upper + settling];
            let text = "from the start of motion to the robot's arrival";
            list.push(time("travel-time", text, "s", ends, &rests, self.measures.travel_s));
            let text = "the same over the optimum under the speed limits";
            let optimum = self.numbers.optimum_s;
            let shares = ends.map(|t| t / optimum);
            list.push(time("time-over-optimum", text, "1", shares, &rests, self.measures.travel_s.map(|t| t / optimum)));
        }
        list
    }

    fn remarks(&self) -> Vec<String> {
        let n = &self.numbers;
        let mut list = vec![format!(
            "Bounds are stated for signals {:.0} % larger than those of the run without disturbances. The path was read at {} samples; its \
             steepest drift is {:.4} 1/s, and {:.4} 1/s from half as many. The loop's pace is at most {:.3} λ̇*; over any stretch the drift \
             gains at most {:.3} on the filter (in ln).",
            100.0 * ROOM, n.path_samples, n.drift_rate, n.drift_rate_coarse, self.pace, self.asked.surplus
        )];
        if self.looked.method.limits_acceleration() {
            list.push("Not guaranteed: that the tool stays on the path, and the travel time.".into());
        } else if !self.looked.method.is_regulated() {
            list.push("Nothing is regulated: the demand, its changes and the time have no bound.".into());
        } else if self.varying {
            list.push("The speed limits vary along the path or limit the tool: only the command is bounded.".into());
        }
        if self.nominal.settled.is_none() {
            list.push(format!("The feedback never stays below {:.0} % of the limits: nothing is stated for the settled loop.", 100.0 * SETTLED));
        }
        if self.looked.drift.breaks() {
            list.push("The tool stands at a singularity while the joints turn: the drift there has no bound, and the time no bracket.".into());
        }
        list
    }
}

/// Claim `implicit-band`: `e (2 + 3 (1 + κ))`, `e` half a unit in the last place of 1.
fn implicit_rounding(looked: &Loop) -> f64 {
    1.001 * 0.5 * f64::EPSILON * (2.0 + 3.0 * (1.0 + asymmetry(looked)))
}

fn asymmetry(looked: &Loop) -> f64 {
    let ends = looked.limits.lower().iter().zip(looked.limits.upper());
    ends.map(|(lo, up)| (lo / up).abs().max((up / lo).abs())).fold(1.0, f64::max)
}

fn chattering(looked: &Loop, signals: &Signals) -> f64 {
    let explicit = signals.chattering(looked.step());
    if looked.method != Method::SlidingModeImplicit {
        return explicit;
    }
    slideway_conditioner::bounds::implicit_chattering(signals, looked.step(), asymmetry(looked))
}

/// What a run shows, in the terms of the statement.
pub(crate) fn observed(signals: &SpeedSignals, measures: &SpeedMeasures, looked: &Loop) -> Observed {
    let a = looked.step();
    let mut hypotheses = vec![
        Reading { name: "feedback-inside", value: signals.feedback },
        Reading { name: "signal-band", value: signals.whole.band(a) },
        Reading { name: "signal-chattering", value: chattering(looked, &signals.whole) },
        Reading { name: "feedback", value: signals.feedback },
        Reading { name: "pace", value: signals.sums.pace },
        Reading { name: "trail", value: signals.trail },
        Reading { name: "settling", value: signals.contraction },
    ];
    let period = looked.control.sampling_period;
    hypotheses.extend(TIMES.iter().map(|(name, _, sum)| Reading { name, value: period * sum(&signals.sums) }));
    // A loop that never settles has no settled band.
    let settled = |of: fn(&Signals, &Loop) -> f64| signals.settled.as_ref().map_or(f64::INFINITY, |s| of(s, looked));
    hypotheses.push(Reading { name: "signal-band-settled", value: settled(|s, l| s.band(l.step())) });
    hypotheses.push(Reading { name: "signal-chattering-settled", value: settled(|s, l| chattering(l, s)) });
    let mut guarantees = vec![
        Reading { name: "command", value: measures.command },
        Reading { name: "demand", value: measures.demand },
        Reading { name: "reference-time", value: measures.reference_s.unwrap_or(f64::INFINITY) },
        Reading { name: "travel-time", value: measures.travel_s.unwrap_or(f64::INFINITY) },
        Reading { name: "time-over-optimum", value: measures.travel_s.map_or(f64::INFINITY, |t| t / looked.optimum[0]) },
    ];
    let optional = [
        ("demand-settled", measures.demand_settled),
        ("chattering", measures.chattering),
        ("chattering-settled", measures.chattering_settled),
    ];
    guarantees.extend(optional.into_iter().filter_map(|(name, value)| Some(Reading { name, value: value? })));
    Observed { hypotheses, guarantees }
}
