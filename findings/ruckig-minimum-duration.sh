#!/usr/bin/env bash
# ruckig 0.19.4 (PyPI), recorded 2026-11-29.
#
# One would expect: `minimum_duration = 5` makes the whole move take at least 5 s, so a control loop that
#   feeds the measured state back every cycle still arrives after about 5 s.
# What happens: the minimum applies anew from every recalculation, and any changed input is a recalculation.
#   A target that moves once, at 2 s, arrives after 7 s. With a position reading that differs by one part in
#   10^9 each cycle, the arm slows down for ever and is not there after 60 s; without the minimum, 1.7 s.
# Why it matters: duration limits are how trajectories are matched to other axes or to a conveyor. In a loop
#   that closes through measurements, the remaining time must be counted down by the caller.
set -euo pipefail
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
python3 -m venv --without-pip "$work/venv"
python3 -m pip --python "$work/venv/bin/python" -q install --no-compile --disable-pip-version-check ruckig==0.19.4
"$work/venv/bin/python" - <<'PY'
from importlib.metadata import version
from ruckig import InputParameter, OutputParameter, Result, Ruckig

STEP = 0.01


def arrival(minimum, touch, longest=60.0):
    """Seconds until ruckig reports the target as reached, or None after `longest`."""
    otg, inp, out = Ruckig(1, STEP), InputParameter(1), OutputParameter(1)
    inp.current_position, inp.target_position = [0.0], [1.0]
    inp.max_velocity, inp.max_acceleration, inp.max_jerk = [1.0], [2.0], [10.0]
    if minimum is not None:
        inp.minimum_duration = minimum
    for cycle in range(1, int(longest / STEP) + 1):
        if otg.update(inp, out) == Result.Finished:
            return round(cycle * STEP, 2)
        out.pass_to_input(inp)
        touch(inp, cycle)
    return None


def nothing(inp, cycle):
    pass


def target_moves_once(inp, cycle):
    if cycle == round(2 / STEP):
        inp.target_position = [1.2]


def measured_position(inp, cycle):
    inp.current_position = [inp.current_position[0] + (1e-9 if cycle % 2 else -1e-9)]


seen = {
    "minimum 5 s, input untouched": arrival(5.0, nothing),
    "minimum 5 s, target moves at 2 s": arrival(5.0, target_moves_once),
    "minimum 5 s, position read back each cycle": arrival(5.0, measured_position),
    "no minimum, position read back each cycle": arrival(None, measured_position),
}
print("ruckig", version("ruckig"))
for name, seconds in seen.items():
    print(f"  {name}: {'not within 60 s' if seconds is None else f'{seconds} s'}")
untouched, moved, fed_back, free = seen.values()
same = abs(untouched - 5) < 0.05 and abs(moved - 7) < 0.05 and fed_back is None and free is not None and free < 2
print("as recorded" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PY
