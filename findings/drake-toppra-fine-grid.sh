#!/usr/bin/env bash
# drake 1.51.1 (PyPI), recorded 2026-11-29.
#
# One would expect: pydrake's Toppra gives a better answer with more gridpoints, and what it solves with 501 it solves with 1001.
# What happens: with the default discretisation of an acceleration limit (kInterpolation) a smooth two-joint path is solved with
#   101, 501 and 901 gridpoints, and with 1001 and 3001 SolvePathParameterization() returns None: it "failed to find the maximum
#   path acceleration". kCollocation, the coarser scheme, fails with 901 and solves 1001 and 3001. And the limit of 2 is
#   passed at every size that works: by 20 % with 101 gridpoints, by 2 % with 901.
# Why it matters: the way to lower the excess between gridpoints is a finer grid, and some finer grids fail, with no pattern one
#   could plan for. None reads as an infeasible path; try another number of gridpoints before believing that.
set -euo pipefail
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
python3 -m venv --without-pip "$work/venv"
python3 -m pip --python "$work/venv/bin/python" -q install --no-compile --disable-pip-version-check drake==1.51.1 numpy==2.4.6
"$work/venv/bin/python" - <<'PY'
import logging
from importlib.metadata import version
import numpy as np
from pydrake.math import BsplineBasis
from pydrake.multibody.optimization import Toppra, ToppraDiscretization
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import MultibodyPlant
from pydrake.trajectories import BsplineTrajectory, PathParameterizedTrajectory

logging.getLogger("drake").setLevel(logging.CRITICAL)
INERTIAL = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
SLIDE = (
    '<link name="{0}">' + INERTIAL + '</link><joint name="j{0}" type="prismatic"><parent link="{1}"/><child link="{0}"/>'
    '<axis xyz="{2}"/><limit lower="-1" upper="1" effort="10" velocity="2"/></joint>'
)
urdf = '<robot name="r"><link name="base"/>' + SLIDE.format("a", "base", "1 0 0") + SLIDE.format("b", "a", "0 1 0") + "</robot>"
plant = MultibodyPlant(0.0)
Parser(plant).AddModelsFromString(urdf, "urdf")
plant.WeldFrames(plant.world_frame(), plant.GetFrameByName("base"))
plant.Finalize()
points = [[0, 0], [1, 0.5], [0.2, 1], [1, 0], [0, 0.3]]
path = BsplineTrajectory(BsplineBasis(4, [0, 0, 0, 0, 0.5, 1, 1, 1, 1]), [np.array([p]).T for p in points])
LIMIT = np.array([2.0, 2.0])


def solve(count, scheme):
    """(Duration, peak acceleration), or None."""
    toppra = Toppra(path, plant, np.linspace(0, 1, count))
    toppra.AddJointVelocityLimit(-LIMIT / 2, LIMIT / 2)
    toppra.AddJointAccelerationLimit(-LIMIT, LIMIT, scheme)
    timing = toppra.SolvePathParameterization()
    if timing is None:
        return None
    move = PathParameterizedTrajectory(path, timing)
    times = np.linspace(0, timing.end_time(), 5001)
    return timing.end_time(), max(np.abs(move.EvalDerivative(t, 2)).max() for t in times)


print("drake", version("drake"), "duration and peak acceleration, limit 2")
seen = {}
for name in ("kInterpolation", "kCollocation"):
    for count in (101, 501, 901, 1001, 3001):
        seen[name, count] = solve(count, getattr(ToppraDiscretization, name))
        print(f"  {name}, {count} gridpoints: {seen[name, count]}")
same = all(seen["kInterpolation", count] for count in (101, 501, 901)) and seen["kInterpolation", 101][1] > 2.3
same = same and seen["kInterpolation", 1001] is None and seen["kInterpolation", 3001] is None
same = same and all(seen["kCollocation", count] for count in (101, 501, 1001, 3001)) and seen["kCollocation", 901] is None
print("as recorded" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PY
