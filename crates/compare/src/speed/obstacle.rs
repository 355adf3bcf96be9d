//! What keeps a method's time from being compared with the optimum's.

use crate::speed::entries::{MethodEntry, OptimumEntry};
use crate::speed::judged::{Judged, subject};
use crate::words::decimals;
use slideway_lab::{LimitUse, MAX_SAMPLES, Method, Trace};
use slideway_path::LimitKind;

/// By how much a limit, measured from whole samples, may be exceeded before the times count as not comparable.
pub(crate) const LIMIT_SLACK: f64 = 0.01;

/// The first reason why the two times say nothing beside each other.
pub(crate) fn obstacle(judged: &Judged<'_>) -> Option<String> {
    let Judged { entry, trace, speed_only, .. } = judged;
    if entry.summary.motion_start_s.is_none() {
        return Some(never_moved(entry.summary.method).into());
    }
    if !entry.summary.completed {
        return Some(unfinished(entry, trace));
    }
    if entry.travel_s.is_none() {
        return Some("the robot never came within 0.1 mm and 1 mrad of the path's end".into());
    }
    exceeded(entry, *speed_only)
}

fn never_moved(method: Method) -> &'static str {
    if method.surveys_the_path() {
        "the reference never moved: at the speed that the limits leave it, the run has more samples than a trace holds"
    } else {
        "the reference never moved: the position error alone used up the speed limits"
    }
}

/// A reference that stands still elsewhere, or one that time ran out on.
fn unfinished(entry: &MethodEntry, trace: &Trace) -> String {
    let Some(last) = trace.samples.last() else { return "the run has no samples".into() };
    if entry.summary.method.surveys_the_path() {
        let farthest = trace.samples.iter().map(|s| s.lambda).fold(f64::NEG_INFINITY, f64::max);
        return format!(
            "the reference did not reach the path's end: it turned back or stood still at a singularity, having come to path parameter {} \
             and ended at {}; another `natural.factor`, or none, may carry it across",
            decimals(farthest, 4),
            decimals(last.lambda, 4)
        );
    }
    // A chattering reference may stand for a sample: what counts is whether the last tenth of the run brought it on.
    let moving = trace.samples[trace.samples.len() * 9 / 10..].first().is_some_and(|s| s.lambda < last.lambda)
        || (trace.samples.len() < 10 && last.path_rate > 0.0);
    if !moving {
        let at = decimals(last.lambda, 4);
        return format!("the reference did not reach the path's end, it stopped at path parameter {at}");
    }
    format!(
        "the run was given up after {} s with the reference still moving, at path parameter {}: {}",
        decimals(last.t + trace.sampling_period, 4),
        decimals(last.lambda, 4),
        what_would_help(entry, trace)
    )
}

fn what_would_help(entry: &MethodEntry, trace: &Trace) -> String {
    let method = entry.summary.method;
    if method.is_regulated() && !reached_a_limit(entry, trace) {
        return "no limit was ever reached, raise `control.target_rate`".into();
    }
    if trace.samples.len() >= MAX_SAMPLES {
        let table = if method.is_regulated() { "control" } else { "fixed_speed" };
        return format!("a run has at most {MAX_SAMPLES} samples, raise `{table}.sampling_period`");
    }
    "raise `control.max_duration`".into()
}

/// Whether a regulated method ever had to hold back, or was about to: for the joints, or for the tool's speed, which the switch does not
/// see.
pub(crate) fn reached_a_limit(entry: &MethodEntry, trace: &Trace) -> bool {
    let tool = |u: &LimitUse| u.kind == LimitKind::ToolSpeed && u.share >= 1.0 - LIMIT_SLACK;
    let demanded = entry.summary.limit_ratio_peak >= 1.0 - LIMIT_SLACK;
    demanded || trace.following().iter().any(|s| s.switch < 1.0) || entry.limit_use.iter().any(tool)
}

/// The limit that the optimum keeps and the method exceeds most.
fn exceeded(entry: &MethodEntry, speed_only: Option<&OptimumEntry>) -> Option<String> {
    let commands = (LimitKind::JointSpeed, entry.command_use);
    let others = entry.limit_use.iter().map(|u| (u.kind, u.share));
    let (kind, share) = others.chain([commands]).max_by(|a, b| a.1.total_cmp(&b.1))?;
    // Not a number exceeds.
    if share <= 1.0 + LIMIT_SLACK {
        return None;
    }
    let method = entry.summary.method;
    let share = decimals(share, if share < 2.0 { 2 } else { 1 });
    let speed = matches!(kind, LimitKind::JointSpeed | LimitKind::ToolSpeed);
    let see = if speed || speed_only.is_none() { "" } else { " (see the optimum under speed limits alone)" };
    Some(format!(
        "the optimum keeps the limits on {kind} and the {}, {}, exceeds them {share} times; its time is not comparable{see}",
        subject(method),
        excuse(method, kind)
    ))
}

/// Why a method exceeds limits of one kind. Every regulated law caps its path rate for the tool's speed; torque and tool acceleration bind
/// the optimum alone.
fn excuse(method: Method, kind: LimitKind) -> &'static str {
    let speed = matches!(kind, LimitKind::JointSpeed | LimitKind::ToolSpeed);
    match kind {
        _ if method == Method::Ideal => "which has no limits",
        _ if speed && method.surveys_the_path() => "which keeps them where it surveyed the path",
        LimitKind::ToolSpeed if method.limits_acceleration() => {
            "which keeps them as far as acceleration limits and feedback let it"
        }
        LimitKind::ToolSpeed if method.is_regulated() => "whose reference keeps them and whose feedback does not",
        LimitKind::JointAcceleration if method.limits_acceleration() => "which keeps them by its own reckoning",
        LimitKind::JointSpeed => "which keeps them by its own reckoning",
        _ => "which does not know them",
    }
}
