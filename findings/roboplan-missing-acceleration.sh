#!/usr/bin/env bash
# roboplan and roboplan-toppra 0.7.0 (PyPI), recorded 2026-11-29.
#
# One would expect: a time parameteriser for acceleration limits that has none (a URDF carries none) refuses, or plans by
#   speed alone and says so. A limits file that names a joint the robot does not have is refused as well.
# What happens: neither. The missing limit is the largest double, and the trajectory's accelerations are whatever the grid
#   gives: over 100 rad/s^2 with the default fitting mode and 50 with another, for a speed limit of 1 rad/s. A misspelt
#   joint in the limits file changes nothing and raises nothing, so a typing error ends the same way.
# Why it matters: the result looks like any other trajectory (times, velocities, accelerations of finite size) and starts
#   with a jump in speed. Check getAccelerationLimitVectors() before generating.
set -euo pipefail
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
python3 -m venv --without-pip "$work/venv"
python3 -m pip --python "$work/venv/bin/python" -q install --no-compile --disable-pip-version-check roboplan==0.7.0 roboplan-toppra==0.7.0 numpy==2.4.6
cd "$work"
printf 'joint_limits:\n  shoudler: {max_acceleration: [2.0]}\n' > misspelt.yaml
printf 'joint_limits:\n  shoulder: {max_acceleration: [2.0]}\n' > limits.yaml
"$work/venv/bin/python" - <<'PY'
from importlib.metadata import version
import numpy as np
import roboplan.core as core
import roboplan.toppra as timing

URDF = (
    '<robot name="r"><link name="base"/><link name="arm"><inertial><mass value="1"/>'
    '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>'
    '<joint name="shoulder" type="revolute"><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>'
    '<limit lower="-3" upper="3" effort="10" velocity="1"/></joint></robot>'
)


def peak(mode, limits):
    scene = core.Scene("scene", core.loadUrdfSceneDescriptionFromXml(URDF))
    if limits:
        scene.importJointLimitsFromConfig(core.loadJointLimitsConfig(limits))
    path, options = core.JointPath(), timing.TOPPRAOptions()
    path.joint_names, path.positions = ["shoulder"], [np.array([0.0]), np.array([1.0])]
    options.mode = mode
    trajectory = timing.PathParameterizerTOPPRA(scene).generate(path, options)
    return float(np.abs(np.array(trajectory.accelerations)).max())


print("roboplan", version("roboplan"), "one joint 0 -> 1 rad, speed limit 1 rad/s, peak acceleration in rad/s^2")
hermite, cubic = timing.SplineFittingMode.Hermite, timing.SplineFittingMode.Cubic
seen = {
    "no limits file, default mode": peak(hermite, None),
    "no limits file, cubic mode": peak(cubic, None),
    "misspelt joint, default mode": peak(hermite, "misspelt.yaml"),
    "right joint, default mode": peak(hermite, "limits.yaml"),
}
for name, value in seen.items():
    print(f"  {name}: {value:.2f}")
none, none_cubic, misspelt, right = seen.values()
same = none > 100 and 40 < none_cubic < 60 and misspelt == none and right < 2.01
print("as recorded" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PY
