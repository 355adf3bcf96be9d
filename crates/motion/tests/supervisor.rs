//! The supervisor, by trying everything.

#[path = "support/inputs.rs"]
mod inputs;

use inputs::inputs;
use slideway_motion::supervisor::{AfterBrake, Inputs, Mode, QueueState, SegmentKind, Signals, Supervisor, diagram};
use std::collections::{HashMap, HashSet, VecDeque};

/// The arm as the supervisor knows it: its queue, how fast it moves (0 to 2), and how long it has braked on the path.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
struct Arm {
    queue: QueueState,
    speed: u8,
    braking_for: u8,
}

const DEADLINE: u8 = 3;

fn kinds() -> [SegmentKind; 2] {
    [SegmentKind::Joint, SegmentKind::Tool]
}

/// All states that the arm may have after a sample that ends in mode `to`.
fn moves(arm: Arm, from: Mode, to: Mode) -> Vec<Arm> {
    let stop = |queue| Arm { queue, speed: 0, braking_for: 0 };
    let paused = |queue| match queue {
        QueueState::Ready(kind) | QueueState::Paused(kind) => stop(QueueState::Paused(kind)),
        QueueState::Resting => stop(queue),
    };
    match to {
        // At rest nothing moves; in Idle and Fault somebody may queue something.
        Mode::Idle | Mode::Fault(_) if from == to => {
            kinds().map(|kind| Arm { queue: QueueState::Ready(kind), ..arm }).into_iter().chain([arm]).collect()
        }
        Mode::Fault(_) => vec![Arm { queue: QueueState::Resting, ..arm }],
        Mode::Idle if from == Mode::Paused => vec![Arm { queue: QueueState::Resting, ..arm }],
        Mode::Idle | Mode::Paused => vec![arm],
        Mode::JointMotion | Mode::ToolMotion | Mode::Recovery(_) => kinds()
            .into_iter()
            .flat_map(|kind| (0..=2).map(move |speed| Arm { queue: QueueState::Ready(kind), speed, braking_for: 0 }))
            .chain([stop(QueueState::Resting), paused(arm.queue)])
            .collect(),
        Mode::BrakingOnPath => (0..=arm.speed)
            .map(|speed| Arm { speed, braking_for: arm.braking_for + 1, ..arm })
            .chain([paused(arm.queue), stop(QueueState::Resting)])
            .collect(),
        // The queue is the brake's own joint motion, which slows down in every sample.
        Mode::BrakingFully(_) => match arm.speed {
            0 => vec![stop(QueueState::Resting)],
            speed => vec![Arm { queue: QueueState::Ready(SegmentKind::Joint), speed: speed - 1, braking_for: 0 }],
        },
    }
}

type State = (Mode, Arm);

/// All states that can be reached from rest, with all their successors.
fn explore() -> HashMap<State, HashSet<State>> {
    let inputs = inputs();
    let start = Arm { queue: QueueState::Resting, speed: 0, braking_for: 0 };
    // A supervisor in each mode: its rules depend on nothing else.
    let mut seen: HashMap<State, HashSet<State>> = HashMap::new();
    let mut open = VecDeque::from([(Supervisor::default(), start)]);
    while let Some((supervisor, arm)) = open.pop_front() {
        let state = (supervisor.mode(), arm);
        if seen.contains_key(&state) {
            continue;
        }
        let mut successors = HashMap::new();
        for &inputs in &inputs {
            let mut next = supervisor.clone();
            let overdue = arm.braking_for >= DEADLINE;
            next.step(&Signals { inputs, overdue, queue: arm.queue });
            for arm in moves(arm, supervisor.mode(), next.mode()) {
                successors.entry((next.mode(), arm)).or_insert_with(|| next.clone());
            }
        }
        seen.insert(state, successors.keys().copied().collect());
        open.extend(successors.into_iter().map(|((_, arm), supervisor)| (supervisor, arm)));
    }
    seen
}

fn is_braking(mode: Mode) -> bool {
    matches!(mode, Mode::BrakingOnPath | Mode::BrakingFully(_))
}

/// Longest way from a braking state to a mode at rest, whatever is raised on it; `None` if there is a way round.
fn longest(
    state: State,
    graph: &HashMap<State, HashSet<State>>,
    known: &mut HashMap<State, Option<usize>>,
) -> Option<usize> {
    if state.0.is_at_rest() {
        return Some(0);
    }
    if let Some(&length) = known.get(&state) {
        return length;
    }
    // Met again before it is finished: a way round.
    known.insert(state, None);
    let mut length = Some(0);
    for &next in &graph[&state] {
        length = length.zip(longest(next, graph, known)).map(|(a, b)| a.max(b + 1));
    }
    known.insert(state, length);
    length
}

#[test]
fn every_mode_is_reached_and_a_mode_at_rest_means_an_arm_at_rest() {
    let graph = explore();
    let modes: HashSet<Mode> = graph.keys().map(|(mode, _)| *mode).collect();
    assert_eq!(modes, Mode::all().collect());
    for (mode, arm) in graph.keys() {
        assert!(!mode.is_at_rest() || arm.speed == 0, "{mode:?} with {arm:?}");
    }
}

#[test]
fn every_brake_comes_to_rest_whatever_is_raised_meanwhile() {
    let graph = explore();
    let mut known = HashMap::new();
    for &state in graph.keys().filter(|(mode, _)| is_braking(*mode)) {
        let length = longest(state, &graph, &mut known);
        // The deadline on the path, two samples to slow down, and one for each change of mode.
        assert!(length.is_some_and(|n| n <= usize::from(DEADLINE) + 2 + 3), "{state:?}: {length:?}");
    }
}

#[test]
fn a_fault_always_leads_to_a_brake_or_to_rest_and_stays_until_it_is_gone() {
    let inputs = inputs();
    for (mode, arm) in explore().into_keys() {
        let supervisor = in_mode(mode);
        for inputs in inputs.iter().filter(|i| i.fault.is_some()) {
            let mut next = supervisor.clone();
            next.step(&Signals { inputs: *inputs, overdue: false, queue: arm.queue });
            let leads_to_fault = matches!(next.mode(), Mode::Fault(_) | Mode::BrakingFully(AfterBrake::Fault(_)));
            assert!(leads_to_fault, "{mode:?} under {inputs:?} goes to {:?}", next.mode());
        }
    }
}

#[test]
fn a_moving_arm_always_obeys_a_brake() {
    let inputs = inputs();
    for (mode, arm) in explore().into_keys().filter(|(mode, _)| !mode.is_at_rest()) {
        let supervisor = in_mode(mode);
        for inputs in inputs.iter().filter(|i| i.brake_fully || i.brake_on_path) {
            let mut next = supervisor.clone();
            next.step(&Signals { inputs: *inputs, overdue: false, queue: arm.queue });
            assert!(is_braking(next.mode()) || next.mode().is_at_rest(), "{mode:?} goes on to {:?}", next.mode());
            if inputs.brake_fully && mode != Mode::BrakingOnPath {
                assert!(next.mode() != Mode::BrakingOnPath, "the harder brake wins");
            }
        }
    }
}

/// A supervisor brought into a mode by inputs alone.
fn in_mode(wanted: Mode) -> Supervisor {
    let mut open = VecDeque::from([Supervisor::default()]);
    let mut seen = HashSet::new();
    let queues = kinds().into_iter().flat_map(|k| [QueueState::Ready(k), QueueState::Paused(k)]);
    let queues: Vec<_> = queues.chain([QueueState::Resting]).collect();
    let inputs = inputs();
    while let Some(supervisor) = open.pop_front() {
        if supervisor.mode() == wanted {
            return supervisor;
        }
        if seen.insert(supervisor.mode()) {
            for (&inputs, &queue) in inputs.iter().flat_map(|i| queues.iter().map(move |q| (i, q))) {
                let mut next = supervisor.clone();
                next.step(&Signals { inputs, overdue: true, queue });
                if !seen.contains(&next.mode()) {
                    open.push_back(next);
                }
            }
        }
    }
    panic!("{wanted:?} cannot be reached")
}

#[test]
fn the_diagram_in_the_documentation_is_current() {
    let stored = include_str!("../docs/supervisor.md");
    assert_eq!(stored, diagram(), "run the example `supervisor_diagram` and store what it prints");
}

#[test]
fn the_log_keeps_the_last_changes_in_order() {
    let mut supervisor = Supervisor::default();
    let ready = QueueState::Ready(SegmentKind::Joint);
    for _ in 0..100 {
        supervisor.step(&Signals { inputs: Inputs { start: true, ..Inputs::default() }, overdue: false, queue: ready });
        supervisor.step(&Signals { inputs: Inputs::default(), overdue: false, queue: QueueState::Resting });
    }
    let samples: Vec<u64> = supervisor.log().iter().map(|event| event.sample).collect();
    assert_eq!(samples, (136..200).collect::<Vec<_>>());
}
