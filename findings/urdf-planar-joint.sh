#!/usr/bin/env bash
# mujoco 4.0.0, pin (Pinocchio) 4.1.0, yourdfpy 0.0.60 (PyPI), recorded 2026-11-29.
#
# One would expect: a URDF joint of type "planar" with <axis xyz="1 0 0"/> moves its link in the plane normal to x,
#   and the tools agree on the number of coordinates.
# What happens: three tools, three joints. MuJoCo makes two slides in the y-z plane and a hinge about x (3
#   coordinates), and gives the whole <limit> to the first slide alone. Pinocchio ignores the axis: the link moves
#   in x-y and turns about z (4 coordinates, the angle as cosine and sine), unlimited. yourdfpy has 2 coordinates.
#   None warns.
# Why it matters: mobile bases and gantries are where planar joints are met. A trajectory from one tool means another
#   motion, or has the wrong width, in the next. Write two prismatic joints and a revolute one instead.
set -euo pipefail
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
python3 -m venv --without-pip "$work/venv"
python3 -m pip --python "$work/venv/bin/python" -q install --no-compile --disable-pip-version-check mujoco==4.0.0 pin==4.1.0 yourdfpy==0.0.60
cd "$work"
cat > robot.py <<'PY'
URDF = (
    '<robot name="r"><link name="base"/><link name="cart"><inertial><mass value="1"/>'
    '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>'
    '<joint name="j" type="planar"><parent link="base"/><child link="cart"/><axis xyz="1 0 0"/>'
    '<limit lower="-1" upper="1" effort="10" velocity="2"/></joint></robot>'
)


def finish(same):
    print("  as recorded" if same else "  CHANGED")
    raise SystemExit(0 if same else 1)
PY
cat > mujoco_.py <<'PY'
from robot import *
import mujoco

model = mujoco.MjModel.from_xml_string(URDF)
axes = abs(model.jnt_axis).round(6).tolist()
print("mujoco", mujoco.__version__, "nq", model.nq, "axes, up to sign", axes, "limited", model.jnt_limited.tolist())
finish(model.nq == 3 and axes == [[0, 0, 1], [0, 1, 0], [1, 0, 0]] and model.jnt_limited.tolist() == [True, False, False])
PY
cat > pinocchio_.py <<'PY'
from robot import *
import numpy as np
import pinocchio

model = pinocchio.buildModelFromXML(URDF)
data = model.createData()
pinocchio.forwardKinematics(model, data, np.array([0.5, 0.7, 1.0, 0.0]))
place = data.oMi[1].translation.tolist()
print("pinocchio", pinocchio.__version__, "nq", model.nq, "link at", place, "upper", model.upperPositionLimit.tolist())
finish(model.nq == 4 and place == [0.5, 0.7, 0.0] and np.isinf(model.upperPositionLimit[:2]).all())
PY
cat > yourdfpy_.py <<'PY'
from robot import *
import io
from importlib.metadata import version
import yourdfpy

robot = yourdfpy.URDF.load(io.StringIO(URDF), load_meshes=False)
print("yourdfpy", version("yourdfpy"), "coordinates", robot.num_dofs)
finish(robot.num_dofs == 2)
PY
status=0
for tool in mujoco_ pinocchio_ yourdfpy_; do "$work/venv/bin/python" "$tool.py" || status=1; done
exit $status
