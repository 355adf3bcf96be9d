#!/usr/bin/env bash
# pin (Pinocchio) 4.1.0 and mujoco 4.0.0 (PyPI), recorded 2026-11-29.
#
# One would expect: renaming a joint changes a name, and nothing else.
# What happens: Pinocchio takes the joints that share a parent link in alphabetical order of the JOINT names,
#   whatever their order in the URDF. Rename one, and the entries of q, v and tau change places. With mimic=True it
#   decides whether the file loads at all: a follower that sorts before its leader is refused with "not in the
#   kinematic tree", and loads once it is renamed. MuJoCo keeps the order of the file for the same robot.
# Why it matters: a recorded trajectory without names is replayed on the wrong arm after a harmless clean-up of
#   names, or when it passes from one of the two tools to the other. Map by name, always.
set -euo pipefail
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
python3 -m venv --without-pip "$work/venv"
python3 -m pip --python "$work/venv/bin/python" -q install --no-compile --disable-pip-version-check pin==4.1.0 mujoco==4.0.0
cat > "$work/robot.py" <<'PY'
INERTIAL = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'


def joint(name, link, more=""):
    return (
        f'<link name="{link}">{INERTIAL}</link><joint name="{name}" type="revolute"><parent link="base"/>'
        f'<child link="{link}"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/>{more}</joint>'
    )


def robot(*joints):
    return '<robot name="r"><link name="base"/>' + "".join(joints) + "</robot>"


TORSO = robot(joint("right", "r_arm"), joint("left", "l_arm"))
RENAMED = robot(joint("right", "r_arm"), joint("starboard_left", "l_arm"))
GRIPPER = robot(joint("leader", "a"), joint("follower", "b", '<mimic joint="leader"/>'))
GRIPPER_RENAMED = robot(joint("leader", "a"), joint("z_follower", "b", '<mimic joint="leader"/>'))


def finish(same):
    print("  as recorded" if same else "  CHANGED")
    raise SystemExit(0 if same else 1)
PY
cd "$work"
cat > pinocchio_.py <<'PY'
from robot import *
import pinocchio


def order(urdf):
    return list(pinocchio.buildModelFromXML(urdf).names)[1:]


def loads(urdf):
    try:
        return pinocchio.buildModelFromXML(urdf, mimic=True).nq
    except ValueError as error:
        return str(error)


print("pinocchio", pinocchio.__version__)
for urdf in (TORSO, RENAMED):
    print("  order of q:", order(urdf))
for urdf in (GRIPPER, GRIPPER_RENAMED):
    print("  gripper with mimic, nq or error:", loads(urdf))
finish(
    order(TORSO) == ["left", "right"] and order(RENAMED) == ["right", "starboard_left"]
    and "not in the kinematic tree" in str(loads(GRIPPER)) and loads(GRIPPER_RENAMED) == 1
)
PY
cat > mujoco_.py <<'PY'
from robot import *
import mujoco


def order(urdf):
    model = mujoco.MjModel.from_xml_string(urdf)
    return [model.joint(i).name for i in range(model.njnt)]


print("mujoco", mujoco.__version__)
for urdf in (TORSO, RENAMED):
    print("  order of qpos:", order(urdf))
finish(order(TORSO) == ["right", "left"] and order(RENAMED) == ["right", "starboard_left"])
PY
status=0
for tool in pinocchio_ mujoco_; do "$work/venv/bin/python" "$tool.py" || status=1; done
exit $status
