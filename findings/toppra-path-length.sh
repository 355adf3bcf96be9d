#!/usr/bin/env bash
# toppra 0.6.10 (PyPI), recorded 2026-11-29.
#
# One would expect: the range of the path parameter is a free choice. Way-points at s = 0, 0.25 ... 1 and the
#   same way-points at s = 0, 25 ... 100 (per cent, degrees, milliseconds) are one geometric path.
# What happens: with s up to 10 the default solver finds 6.20 s. With s up to 100 it logs a numerical error,
#   calls the instance not controllable, and `compute_trajectory` returns None. Nothing is raised.
#   If the gridpoints are left to toppra, their number grows with the range as well: 202 for 1, 32769 for 1000.
# Why it matters: None reads as "the limits cannot be met". The limits are fine; rescale s to about 1 first.
set -euo pipefail
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
python3 -m venv --without-pip "$work/venv"
python3 -m pip --python "$work/venv/bin/python" -q install --no-compile --disable-pip-version-check toppra==0.6.10 numpy==2.4.6 scipy==1.17.1
"$work/venv/bin/python" - <<'PY'
from importlib.metadata import version
import numpy as np
import toppra
from toppra.algorithm import TOPPRA
from toppra.constraint import JointAccelerationConstraint, JointVelocityConstraint

toppra.setup_logging("ERROR")
waypoints = np.array([[0, 0], [1, 0.5], [0.2, 1], [1, 0], [0, 0.3]])
box = np.array([[-1.0, 1.0], [-1.0, 1.0]])


def instance(length, points):
    path = toppra.SplineInterpolator(np.linspace(0, length, 5), waypoints)
    grid = None if points is None else np.linspace(0, length, points)
    return TOPPRA([JointVelocityConstraint(box), JointAccelerationConstraint(2 * box)], path, gridpoints=grid)


print("toppra", version("toppra"), "one path, its parameter from 0 to `length`, 101 gridpoints")
seen = {}
for length in (0.001, 1, 10, 100, 1000):
    trajectory = instance(length, 101).compute_trajectory()
    seen[length] = None if trajectory is None else float(trajectory.duration)
    print(f"  length {length}: duration {seen[length]}")
chosen = {length: len(instance(length, None).gridpoints) for length in (1, 1000)}
print("  gridpoints toppra chooses:", chosen)
same = all(abs(seen[s] - 6.20) < 0.01 for s in (0.001, 1, 10)) and seen[100] is None and seen[1000] is None
same = same and chosen[1000] > 50 * chosen[1]
print("as recorded" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PY
