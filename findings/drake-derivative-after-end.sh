#!/usr/bin/env bash
# drake 1.51.1 (PyPI), recorded 2026-11-29.
#
# One would expect: where a trajectory's value no longer changes, its derivative is 0. `value(t)` of pydrake's trajectories is clamped
#   to the last value after the end, so EvalDerivative(t) after the end is 0.
# What happens: EvalDerivative clamps the time and returns the derivative at the end. A bang-bang move that ends at rest keeps
#   its deceleration of -2 for ever after; a ramp keeps its speed. MakeDerivative() gives the same. Before the start likewise.
# Why it matters: position, velocity and acceleration of one trajectory are sent side by side. After the end the position
#   says "stay" and the feed-forward torque of the last deceleration is still applied. Zero it by hand after end_time().
set -euo pipefail
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
python3 -m venv --without-pip "$work/venv"
python3 -m pip --python "$work/venv/bin/python" -q install --no-compile --disable-pip-version-check drake==1.51.1 numpy==2.4.6
"$work/venv/bin/python" - <<'PY'
from importlib.metadata import version
import numpy as np
from pydrake.trajectories import PiecewisePolynomial

LATE = 5.0
bang = PiecewisePolynomial.CubicHermite([0, 1, 2], np.array([[0.0, 1.0, 2.0]]), np.array([[0.0, 2.0, 0.0]]))
ramp = PiecewisePolynomial.FirstOrderHold([0, 2], np.array([[0.0, 2.0]]))
print("drake", version("drake"), "trajectories on [0, 2], asked at 5")
seen = {}
for name, trajectory, order in (("rest to rest", bang, 1), ("rest to rest", bang, 2), ("ramp", ramp, 1)):
    held = trajectory.value(LATE).item()
    direct = trajectory.EvalDerivative(LATE, order).item()
    made = trajectory.MakeDerivative(order).value(LATE).item()
    seen[name, order] = (held, direct, made)
    print(f"  {name}: value {held:g}, derivative {order}: EvalDerivative {direct:g}, MakeDerivative {made:g}")
same = seen == {("rest to rest", 1): (2, 0, 0), ("rest to rest", 2): (2, -2, -2), ("ramp", 1): (2, 1, 1)}
print("as recorded" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PY
