#!/usr/bin/env bash
# pin (Pinocchio) 4.1.0 (PyPI), recorded 2026-11-29.
#
# One would expect: with `mimic=True` a gripper whose second finger follows the first (q2 = 4 q1) gets limits
#   that keep both fingers inside their own <limit>: the second's, [-1, 1] rad and 2 rad/s, is the tighter one.
# What happens: the follower loses its place in q, and its limits go with it. The model's limits are those of the
#   leader alone, [-3, 3] rad and 5 rad/s; at the bound the model allows, the follower stands at 12 rad.
# Why it matters: samplers, inverse kinematics and time parameterisation read model.upperPositionLimit and
#   model.velocityLimit. All of them plan motions here that the URDF forbids. Narrow the leader's limits by
#   the follower's, divided by the multiplier, after loading.
set -euo pipefail
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
python3 -m venv --without-pip "$work/venv"
python3 -m pip --python "$work/venv/bin/python" -q install --no-compile --disable-pip-version-check pin==4.1.0 numpy==2.4.6
"$work/venv/bin/python" - <<'PY'
import numpy as np
import pinocchio

INERTIAL = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'


def finger(name, lower, upper, velocity, mimic=""):
    return (
        f'<link name="{name}">{INERTIAL}</link><joint name="j_{name}" type="revolute"><parent link="base"/>'
        f'<child link="{name}"/><axis xyz="0 0 1"/>'
        f'<limit lower="{lower}" upper="{upper}" effort="1" velocity="{velocity}"/>{mimic}</joint>'
    )


urdf = (
    '<robot name="r"><link name="base"/>'
    + finger("a", -3, 3, 5)
    + finger("b", -1, 1, 2, '<mimic joint="j_a" multiplier="4"/>')
    + "</robot>"
)
model = pinocchio.buildModelFromXML(urdf, mimic=True)
data = model.createData()
pinocchio.forwardKinematics(model, data, np.array([0.5]))
follower = pinocchio.log3(data.oMi[model.getJointId("j_b")].rotation)[2]
upper, speed = model.upperPositionLimit.tolist(), model.velocityLimit.tolist()
print("pinocchio", pinocchio.__version__, "nq", model.nq, "joints", list(model.names)[1:])
print("  upper position limits", upper, "velocity limits", speed)
print(f"  leader at 0.5 rad, well inside: follower at {follower:.3f} rad, its own limit is 1")
same = model.nq == 1 and upper == [3.0] and speed == [5.0] and abs(follower - 2.0) < 1e-9
print("as recorded" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PY
