use super::machine::next;
use super::{AfterBrake, Cause, Fault, Mode, QueueState, SegmentKind, Signals};
use std::collections::BTreeMap;
use std::fmt::Write;

/// The state machine as a Mermaid diagram in Markdown, found by trying all signals in all modes. Faults are drawn as one.
#[must_use]
pub fn diagram() -> String {
    let mut edges: BTreeMap<(&str, &str), Vec<&str>> = BTreeMap::new();
    for mode in Mode::all() {
        for signals in all_signals() {
            if let Some((to, cause)) = next(mode, &signals) {
                let labels = edges.entry((name(mode), name(to))).or_default();
                if !labels.contains(&label(cause)) {
                    labels.push(label(cause));
                }
            }
        }
    }
    let mut text = String::from("```mermaid\nstateDiagram-v2\n    [*] --> Idle\n");
    for ((from, to), mut labels) in edges {
        labels.sort_unstable();
        // Writing to a string cannot fail.
        let _ = writeln!(text, "    {from} --> {to}: {}", labels.join(", "));
    }
    text.push_str("```\n");
    text
}

/// Every combination of signals.
pub(super) fn all_signals() -> impl Iterator<Item = Signals> {
    let kinds = [SegmentKind::Joint, SegmentKind::Tool];
    let queues: Vec<QueueState> = kinds
        .iter()
        .flat_map(|&kind| [QueueState::Ready(kind), QueueState::Paused(kind)])
        .chain([QueueState::Resting])
        .collect();
    let faults: Vec<Option<Fault>> = Fault::ALL.into_iter().map(Some).chain([None]).collect();
    queues.into_iter().flat_map(move |queue| {
        let faults = faults.clone();
        faults.into_iter().flat_map(move |fault| {
            (0..256_u32).map(move |bits| {
                let bit = |k: u32| bits & (1 << k) != 0;
                Signals {
                    fault,
                    brake_fully: bit(0),
                    overdue: bit(1),
                    brake_on_path: bit(2),
                    discard: bit(3),
                    resume: bit(4),
                    start: bit(5),
                    reset: bit(6),
                    recover: bit(7),
                    queue,
                }
            })
        })
    })
}

fn name(mode: Mode) -> &'static str {
    match mode {
        Mode::Idle => "Idle",
        Mode::JointMotion => "JointMotion",
        Mode::ToolMotion => "ToolMotion",
        Mode::BrakingOnPath => "BrakingOnPath",
        Mode::Paused => "Paused",
        Mode::BrakingFully(AfterBrake::Idle) => "BrakingToIdle",
        Mode::BrakingFully(AfterBrake::Fault(_)) => "BrakingToFault",
        Mode::Fault(_) => "Fault",
        Mode::Recovery(_) => "Recovery",
    }
}

fn label(cause: Cause) -> &'static str {
    match cause {
        Cause::Fault => "fault",
        Cause::BrakeFully => "brake fully",
        Cause::Overdue => "overdue",
        Cause::BrakeOnPath => "brake on path",
        Cause::Rest => "at rest",
        Cause::Finished => "queue empty",
        Cause::NextSegment => "next segment",
        Cause::Start => "start",
        Cause::Resume => "resume",
        Cause::Discard => "discard",
        Cause::Reset => "reset",
        Cause::Recover => "recover",
    }
}
