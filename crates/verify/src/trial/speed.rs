//! Runs of a speed scenario, and what they are held against.

use super::draw::{Draw, Ranges};
use super::{Always, Check, Judgement, held_against};
use crate::error::VerifyError;
use crate::options::VerifyOptions;
use crate::statement::{Guarantee, Observed, Observer, SpeedCase, Statement};
use slideway_lab::{Disturbances, Experiment, Method, MethodSummary, Sample, Trace};

const COMMAND: Always = Always {
    name: "command-within-limits",
    text: "largest use of a joint-speed limit by a command, at most 1, whatever disturbs the loop",
    unit: "limits",
};
const FACTOR: Always =
    Always { name: "factor-range", text: "the factor f stays in [0, 1], whatever disturbs the loop", unit: "1" };
const CHATTERING: Always = Always {
    name: "chattering-band",
    text: "change of the desired speed over a sample, at every sample at most |B'||Δf| + f|ΔB| + |ΔA| as the controller saw them",
    unit: "limits",
};
const ADVANCE: Always = Always {
    name: "synchronised-advance",
    text: "path rate over fdir f λ̇d, and over (1 + E) λ̇d / b as the controller saw them: at most 1",
    unit: "1",
};
const IMPLICIT: Always = Always {
    name: "implicit-band",
    text: "largest use of a limit by the demand over the samples whose feedback is inside the limits: at most 1",
    unit: "limits",
};
const SIGNAL: Always = Always {
    name: "signal-band",
    text: "largest use of a limit by the demand, at most the band that the run's own signals prove",
    unit: "limits",
};

/// Jitter: the robot's clock is not the one it was taken for, so that nothing is said of times.
const COUNTED: &str = "period-as-counted";
/// Arrival is judged by the joints, and the controller's view of them is what the settling is read from.
const SEEN: &str = "joints-as-seen";

/// A speed scenario and one of its methods, made ready to be run again and again.
#[derive(Clone, Debug)]
pub(crate) struct SpeedSubject {
    experiment: Experiment,
    observer: Observer,
    method: Method,
    ranges: Ranges,
    /// Lower and upper limit of each joint, rad/s (m/s); the widest where limits vary along the path.
    limits: Vec<[f64; 2]>,
    /// Acceleration limit of each joint, rad/s² (m/s²), where there are any.
    acceleration: Option<Vec<f64>>,
    /// True if a path of the joints is followed.
    by_joints: bool,
    /// True if limits at single places or of the tool hold the reference back, of which the law's own bounds know nothing.
    varying: bool,
}

impl SpeedSubject {
    /// The subject, what is stated of it, and how its run without a trial's disturbances is judged.
    pub(crate) fn new(
        experiment: Experiment,
        method: Method,
        grid_points: usize,
        options: &VerifyOptions,
    ) -> Result<(Self, Statement), VerifyError> {
        let case = SpeedCase::new(experiment, method, grid_points)?;
        let mut statement = case.statement();
        let SpeedCase { experiment, trace: nominal, looked, acceleration, varying, .. } = case;
        let limits = looked.limits.lower().iter().zip(looked.limits.upper());
        let subject = Self {
            method: looked.method,
            ranges: Ranges::of_speed(options, experiment.joints(), extent(&nominal)),
            limits: limits.take(experiment.joints()).map(|(lo, up)| [*lo, *up]).collect(),
            acceleration,
            by_joints: looked.by_joints,
            varying,
            observer: Observer::of_loop(looked),
            experiment,
        };
        let observed = subject.observer.speed(&nominal);
        let found = subject.always(&subject.experiment, &nominal, &observed)?;
        for always in [COMMAND, FACTOR, CHATTERING, ADVANCE, IMPLICIT, SIGNAL] {
            // What the statement says of the command is as exact, under another name.
            let said = always.name == COMMAND.name && statement.guarantees.iter().any(|g| g.claim == COMMAND.name);
            let check = found.iter().find(|check| check.guarantee == always.name && !said);
            statement.guarantees.extend(check.map(|check| always.guarantee(check)));
        }
        Ok((subject, statement))
    }

    pub(crate) fn draw(&self, seed: u64, number: u64) -> Draw {
        Draw::new(seed, number, &self.ranges)
    }

    /// The run of a trial.
    pub(crate) fn run(&self, disturbances: &Disturbances) -> Result<Trace, VerifyError> {
        Ok(self.experiment.with_disturbances(disturbances)?.run(self.method)?)
    }

    /// Runs the subject under disturbances and holds the run against a statement.
    pub(crate) fn judge(&self, disturbances: &Disturbances, statement: &Statement) -> Result<Judgement, VerifyError> {
        let trace = self.run(disturbances)?;
        let observed = self.observer.speed(&trace);
        let mut outside = statement.outside(&observed);
        let always = self.always(&self.experiment, &trace, &observed)?;
        let command = self.experiment.command_use(&trace)?;
        let measured = |guarantee: &Guarantee| match guarantee.name.as_str() {
            "command" => Some(command),
            "command-acceleration" => self.acceleration_use(&trace),
            name => observed.guarantee(name),
        };
        let leave = |guarantee: &Guarantee| self.loses(guarantee, disturbances);
        let mut checks = held_against(statement, &mut outside, measured, leave);
        let stated = |check: &Check| statement.guarantees.iter().any(|g| g.name == check.guarantee);
        checks.extend(always.into_iter().filter(stated));
        Ok(Judgement { outside, checks })
    }

    /// Largest use of an acceleration limit by the change of a command over a counted period.
    fn acceleration_use(&self, trace: &Trace) -> Option<f64> {
        let peaks = MethodSummary::new(trace).peak_acceleration;
        let uses = peaks.iter().zip(self.acceleration.as_ref()?).map(|(peak, limit)| nan_is_infinite(peak / limit));
        Some(uses.fold(0.0, f64::max))
    }

    /// Checks of the bounds that hold whatever disturbs the loop.
    fn always(&self, experiment: &Experiment, trace: &Trace, seen: &Observed) -> Result<Vec<Check>, VerifyError> {
        let method = self.method;
        let mut checks = Vec::new();
        if method != Method::Ideal && !method.surveys_the_path() {
            // Saturation ends with a clamp: exact. Under acceleration limits the command is a sum of the last command and a step, rounded
            // twice.
            let rounding = if method.limits_acceleration() { 4.0 * f64::EPSILON } else { 0.0 };
            checks.push(Check::at_most(COMMAND.name, experiment.command_use(trace)?, 1.0 + rounding, COMMAND.unit));
        }
        if !method.is_regulated() {
            return Ok(checks);
        }
        checks.push(factor_range(trace));
        if method.bounds_chattering() && !self.varying {
            checks.extend(self.chattering(trace));
        }
        if method == Method::SlidingModeSynchronised {
            checks.push(self.advance(trace));
        }
        if method == Method::SlidingModeImplicit && !self.varying {
            checks.push(self.implicit(trace));
        }
        // The last step, cut short, lies between the feedback alone and the whole one.
        let band = seen.hypothesis("signal-band").zip(seen.hypothesis("feedback")).map(|(band, cut)| band.max(cut));
        if let (Some(band), Some(peak), true) = (band, seen.guarantee("demand"), self.proves_a_band()) {
            checks.push(Check::at_most(SIGNAL.name, peak, band, SIGNAL.unit));
        }
        Ok(checks)
    }

    /// The explicit forms under limits that the regulator's filter sees.
    fn proves_a_band(&self) -> bool {
        matches!(self.method, Method::SlidingMode | Method::SlidingModeSynchronised) && !self.varying
    }

    /// The sample that comes nearest to its bound. Rounding as in claim `chattering-band`: `8 eps` times the sum of the four sizes.
    fn chattering(&self, trace: &Trace) -> Option<Check> {
        let size = |s: &Sample| self.share(&s.split.feedback) + self.share(&s.split.feedforward);
        let checks = trace.samples.windows(2).filter_map(|pair| {
            let chatter = pair[1].chatter?;
            let slack = 8.0 * f64::EPSILON * (size(&pair[0]) + size(&pair[1]));
            Some(Check::at_most(CHATTERING.name, chatter.measured, chatter.bound + slack, CHATTERING.unit))
        });
        checks.min_by(|a, b| a.margin.total_cmp(&b.margin))
    }

    /// `fdir m <= 1` and `m >= f b - E` give `fdir f b <= 1 + E`; widest limits, where they vary, only make the left side smaller. Rounding: rate, ratio, direction factor and products, eight in all.
    fn advance(&self, trace: &Trace) -> Check {
        let control = self.experiment.control();
        let (target, period) = (control.target_rate, control.sampling_period);
        let end = trace.samples.first().map_or(0.0, |s| s.lambda) + self.experiment.path_length();
        // A step cut short at the path's end is saturated as it is, not as a whole one.
        let whole = |s: &&Sample| s.factor * target * period < end - s.lambda;
        let share = |part: f64, whole: f64| if part == 0.0 { 0.0 } else { part / whole };
        let worst = trace.following().iter().filter(whole).map(|s| {
            let asked = share(s.path_rate, s.direction_factor * s.factor * target);
            let (feedback, overspeed) = (self.share(&s.split.feedback), self.ratio(&s.split.feedforward));
            let allowed = s.path_rate * overspeed / target / (1.0 + feedback);
            nan_is_infinite(asked).max(nan_is_infinite(allowed))
        });
        Check::at_most(ADVANCE.name, worst.fold(0.0, f64::max), 1.0 + 8.0 * f64::EPSILON, ADVANCE.unit)
    }

    /// Rounding as in claim `implicit-band`: `e (2 + 3 (1 + κ))` with `e` half a unit in the last place, `κ` the asymmetry.
    fn implicit(&self, trace: &Trace) -> Check {
        let inside = trace.following().iter().filter(|s| self.ratio(&s.split.feedback) <= 1.0);
        let worst = inside.map(|s| nan_is_infinite(s.limit_ratio)).fold(0.0, f64::max);
        let asymmetry = self.limits.iter().map(|[lo, up]| (lo / up).abs().max((up / lo).abs())).fold(1.0, f64::max);
        let bound = 1.0 + 0.5 * f64::EPSILON * (2.0 + 3.0 * (1.0 + asymmetry)) * (1.0 + 1e-3);
        Check::at_most(IMPLICIT.name, worst, bound, IMPLICIT.unit)
    }

    /// Largest share of the smaller limits, for speeds of either sign.
    fn share(&self, speeds: &[f64]) -> f64 {
        self.largest(speeds, |v, [lower, upper]| v.abs() / upper.min(-lower))
    }

    /// Largest use of a limit.
    fn ratio(&self, speeds: &[f64]) -> f64 {
        self.largest(speeds, |v, [lower, upper]| (v / upper).max(v / lower))
    }

    fn largest(&self, speeds: &[f64], use_of: impl Fn(f64, [f64; 2]) -> f64) -> f64 {
        let uses = speeds.iter().zip(&self.limits).map(|(v, limits)| nan_is_infinite(use_of(*v, *limits)));
        uses.fold(0.0, f64::max)
    }

    /// Name of an assumption of a guarantee that the disturbances break, if any.
    fn loses(&self, guarantee: &Guarantee, disturbances: &Disturbances) -> Option<&'static str> {
        let of_time = guarantee.claim.starts_with("time-");
        if of_time && disturbances.jitter > 0.0 {
            return Some(COUNTED);
        }
        let off = disturbances.joint_offset.iter().any(|offset| *offset != 0.0);
        let misread = self.by_joints && (disturbances.joint_noise > 0.0 || disturbances.delay > 0 || off);
        (of_time && misread && guarantee.rests_on.iter().any(|name| name == "settling")).then_some(SEEN)
    }
}

/// Greatest range over which a joint moves in a run, rad (m).
fn extent(trace: &Trace) -> f64 {
    let range = |joint: usize| {
        let ends = |[low, high]: [f64; 2], q: f64| [low.min(q), high.max(q)];
        let [low, high] = trace.samples.iter().map(|s| s.q[joint]).fold([f64::INFINITY, f64::NEG_INFINITY], ends);
        high - low
    };
    (0..trace.joints).map(range).fold(0.0, f64::max)
}

fn factor_range(trace: &Trace) -> Check {
    let factors = || trace.samples.iter().map(|s| s.factor);
    let lowest = factors().fold(f64::INFINITY, |a, f| if f.is_nan() { f } else { a.min(f) });
    let highest = factors().fold(f64::NEG_INFINITY, |a, f| if f.is_nan() { f } else { a.max(f) });
    let (below, above) = (
        Check::at_least(FACTOR.name, lowest, 0.0, FACTOR.unit),
        Check::at_most(FACTOR.name, highest, 1.0, FACTOR.unit),
    );
    if below.margin < above.margin { below } else { above }
}

fn nan_is_infinite(value: f64) -> f64 {
    if value.is_nan() { f64::INFINITY } else { value }
}
