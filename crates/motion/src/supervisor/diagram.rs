use super::machine::next;
use super::{AfterBrake, Cause, Fault, Inputs, Mode, QueueState, SegmentKind, Signals};
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
fn all_signals() -> impl Iterator<Item = Signals> {
    let kinds = [SegmentKind::Joint, SegmentKind::Tool];
    let queues = kinds.into_iter().flat_map(|kind| [QueueState::Ready(kind), QueueState::Paused(kind)]);
    queues.chain([QueueState::Resting]).flat_map(|queue| {
        let faults = Fault::ALL.into_iter().map(Some).chain([None]);
        faults.flat_map(move |fault| (0..256).map(move |bits| signals(queue, fault, bits)))
    })
}

fn signals(queue: QueueState, fault: Option<Fault>, bits: u32) -> Signals {
    let bit = |k: u32| bits & (1 << k) != 0;
    let inputs = Inputs {
        fault,
        brake_fully: bit(0),
        brake_on_path: bit(1),
        discard: bit(2),
        resume: bit(3),
        start: bit(4),
        reset: bit(5),
        recover: bit(6),
    };
    Signals { inputs, overdue: bit(7), queue }
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
