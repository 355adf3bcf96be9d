#!/usr/bin/env bash
# toppra 0.6.10 (PyPI), recorded 2026-11-29.
#
# One would expect: a trajectory asked for a time after its duration holds its last position, or raises.
# What happens: it goes on. With ParametrizeConstAccel the last deceleration is extended, so the robot turns
#   round and speeds up backwards along its path: half a second after a rest-to-rest move of 1 rad it is
#   0.25 rad back and moving at the full speed limit, still accelerating. The default spline extends its last
#   cubic and does the same. ruckig's trajectories stay at rest there, drake's keep the last position.
# Why it matters: players sample at a fixed period, and the last sample of a loop that rounds up, or of a
#   player that waits for the robot to settle, lies after the end. Clip the time to [0, duration] first.
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
line = toppra.SplineInterpolator([0, 1], [[0.0], [1.0]])
limits = [JointVelocityConstraint([[-1, 1]]), JointAccelerationConstraint([[-2, 2]])]
print("toppra", version("toppra"), "move 0 -> 1, speed limit 1, acceleration limit 2")
same = True
for parametrizer in ("ParametrizeConstAccel", "ParametrizeSpline"):
    solver = TOPPRA(limits, line, gridpoints=np.linspace(0, 1, 1001), parametrizer=parametrizer)
    trajectory = solver.compute_trajectory()
    end = trajectory.duration
    print(f"  {parametrizer}: duration {end:.4f}")
    for late in (0.0, 0.1, 0.5):
        q, v = trajectory(end + late)[0], trajectory(end + late, 1)[0]
        print(f"    {late} s after the end: position {q:.4f}, velocity {v:.4f}")
    same &= abs(q - 0.75) < 0.01 and abs(v + 1.0) < 0.01
print("as recorded" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PY
