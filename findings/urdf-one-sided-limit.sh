#!/usr/bin/env bash
# drake 1.51.1, mujoco 4.0.0, pin (Pinocchio) 4.1.0, all PyPI, recorded 2026-11-29.
#
# One would expect: <limit upper="2" effort="10" velocity="1"/> on a revolute joint means one range. The URDF
#   documentation gives it: an omitted `lower` is 0, so [0, 2]; and with neither bound the joint is locked at 0.
# What happens: three tools, three ranges, no warning. Pinocchio reads [0, 2]. Drake reads [-inf, 2]. MuJoCo
#   stores the range [0, 2] but leaves the joint unlimited (jnt_limited is False), so nothing enforces it:
#   it wants both attributes present. lower="0" upper="2", the same by the documentation, is limited in all three.
# Why it matters: a planner built on Pinocchio and a simulator built on MuJoCo disagree on where the robot can
#   go, and the one that finds out is the simulated arm. Write both bounds always.
set -euo pipefail
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
python3 -m venv --without-pip "$work/venv"
python3 -m pip --python "$work/venv/bin/python" -q install --no-compile --disable-pip-version-check drake==1.51.1 mujoco==4.0.0 pin==4.1.0
cat > "$work/robot.py" <<'PY'
import math

LIMITS = {"upper only": 'upper="2"', "lower only": 'lower="-2"', "neither": "", "both": 'lower="0" upper="2"'}
INERTIAL = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'


def urdf(limit):
    return (
        f'<robot name="r"><link name="base"/><link name="arm">{INERTIAL}</link><joint name="j" type="revolute">'
        '<parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>'
        f'<limit {limit} effort="10" velocity="1"/></joint></robot>'
    )


def report(tool, ranges, recorded):
    for name, bounds in ranges.items():
        print(f"  {tool}, {name}: [{bounds[0]:g}, {bounds[1]:g}]")
    same = list(ranges.values()) == recorded
    print("  as recorded" if same else "  CHANGED")
    raise SystemExit(0 if same else 1)


inf = math.inf
PY
cd "$work"
cat > drake_.py <<'PY'
from robot import *
from importlib.metadata import version
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import MultibodyPlant


def bounds(limit):
    plant = MultibodyPlant(0.0)
    Parser(plant).AddModelsFromString(urdf(limit), "urdf")
    plant.Finalize()
    joint = plant.GetJointByName("j")
    return joint.position_lower_limits()[0], joint.position_upper_limits()[0]


ranges = {name: bounds(limit) for name, limit in LIMITS.items()}
report("drake " + version("drake"), ranges, [(-inf, 2), (-2, inf), (-inf, inf), (0, 2)])
PY
cat > mujoco_.py <<'PY'
from robot import *
import mujoco


def bounds(limit):
    model = mujoco.MjModel.from_xml_string(urdf(limit))
    return tuple(model.jnt_range[0].tolist()) if model.jnt_limited[0] else (-inf, inf)


ranges = {name: bounds(limit) for name, limit in LIMITS.items()}
report("mujoco " + mujoco.__version__, ranges, [(-inf, inf), (-inf, inf), (-inf, inf), (0, 2)])
PY
cat > pinocchio_.py <<'PY'
from robot import *
import pinocchio


def bounds(limit):
    model = pinocchio.buildModelFromXML(urdf(limit))
    return model.lowerPositionLimit[0], model.upperPositionLimit[0]


ranges = {name: bounds(limit) for name, limit in LIMITS.items()}
report("pinocchio " + pinocchio.__version__, ranges, [(0, 2), (-2, 0), (0, 0), (0, 2)])
PY
status=0
for tool in drake_ mujoco_ pinocchio_; do "$work/venv/bin/python" "$tool.py" || status=1; done
exit $status
