//! Names and texts of the entries of a statement about a speed law.

use slideway_conditioner::bounds::ProgressSums;

/// Claim, text and unit of an entry.
pub(crate) struct Words {
    pub(crate) claim: &'static str,
    pub(crate) text: &'static str,
    pub(crate) unit: &'static str,
}

/// One of the sums over the motion.
pub(crate) type Sum = fn(&ProgressSums) -> f64;

/// The hypotheses about sums over the motion, in samples: name, and which sum.
pub(crate) const TIMES: [(&str, Sum); 4] = [
    ("feedback-time", |s| s.feedback),
    ("overrun-time", |s| s.overrun),
    ("shift-time", |s| s.shift),
    ("hold-back-time", |s| s.held_back),
];

const SETTLED: &str = "the same once the feedback uses at most 5 % of the limits";

/// Claim, text and unit of the entry of that name.
pub(crate) fn words(name: &str) -> Words {
    let time = "time-with-feedback";
    let (claim, text, unit) = match name {
        "gain-step" => ("drift-with-feedback", "Kp Ts: the position loop does not overshoot", "1"),
        "target-rate" => (
            time,
            "target rate beside the largest path rate that the limits allow: it asks for more than the joints can",
            "1/s",
        ),
        "drift-against-filter" => (
            "signal-band",
            "rate at which the filter falls, -ln(1 - a)/Ts, beside the steepest fall of the limit along the path",
            "1/s",
        ),
        "feedback-inside" => {
            ("implicit-band", "E, the feedback's largest use of a limit while the reference moves", "limits")
        }
        "signal-band" => (
            "signal-band",
            "band of the demand that the signals prove, from feedback, feedforward and their changes",
            "limits",
        ),
        "signal-band-settled" | "demand-settled" => ("signal-band", SETTLED, "limits"),
        "signal-chattering" => {
            ("chattering-band", "largest change of the demand over one sample that the signals prove", "limits")
        }
        "signal-chattering-settled" | "chattering-settled" => ("chattering-band", SETTLED, "limits"),
        "feedback" => ("signal-band", "E, the feedback's largest use of a limit while the reference moves", "limits"),
        "pace" => (time, "largest path rate that the signals allow, over the path's own limit", "1"),
        "feedback-time" => (time, "integral of E over the motion", "s"),
        "overrun-time" => (time, "integral of (m - 1)+ over the motion, m the demand's use of a limit", "s"),
        "shift-time" => {
            (time, "integral of (1 + E + (m - 1)+)|1 - b_path/b|: feedforward as seen beside the path's", "s")
        }
        "hold-back-time" => (time, "time that filter, feedback and drift can hold the reference back", "s"),
        "trail" => (time, "distance from the path's end when the reference is there, in tolerances of arrival", "1"),
        "settling" => (time, "largest ratio of that distance to the one a sample before", "1"),
        "command" => ("command-within-limits", "largest use of a joint-speed limit by a command", "limits"),
        "command-acceleration" => {
            ("acceleration-box", "largest use of a joint-acceleration limit by the change of a command", "limits")
        }
        "demand" => (
            "signal-band",
            "largest use of a limit by the desired joint speed while the reference moves; what exceeds 1 is cut off",
            "limits",
        ),
        "chattering" => ("chattering-band", "largest change of a desired joint speed over one sample", "limits"),
        "reference-time" => (time, "from the start of motion to the reference's end", "s"),
        "travel-time" => (time, "from the start of motion to the robot's arrival", "s"),
        _ => (time, "the same over the optimum under the speed limits", "1"),
    };
    Words { claim, text, unit }
}
