#!/usr/bin/env bash
# mujoco 4.0.0 (PyPI), recorded 2026-11-29.
#
# One would expect: a URDF joint with <mimic joint="a" multiplier="2" offset="0.3"/> stands at 0.3 when its leader is at 0,
#   and the leader does not feel it: it is the follower that follows.
# What happens: the model loads with both joints at 0, which breaks its own mimic by 0.3 m. The mimic is a soft constraint
#   that acts on both sides, so from a reset at rest, with no input and no gravity, it kicks: within 20 ms the LEADER
#   runs backwards at more than 2 m/s and settles 0.12 m from where it was put. reset and keyframes do not mend it.
# Why it matters: every episode or test that starts from the default state starts with a jolt that no command caused,
#   and the leader's tracking error is charged to the controller. Set the follower's qpos from the leader's first.
set -euo pipefail
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
python3 -m venv --without-pip "$work/venv"
python3 -m pip --python "$work/venv/bin/python" -q install --no-compile --disable-pip-version-check mujoco==4.0.0
"$work/venv/bin/python" - <<'PY'
import mujoco

INERTIAL = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'


def slide(name, more=""):
    return (
        f'<link name="{name}">{INERTIAL}</link><joint name="{name}" type="prismatic"><parent link="base"/>'
        f'<child link="{name}"/><axis xyz="1 0 0"/><limit lower="-1" upper="1" effort="100" velocity="1"/>{more}</joint>'
    )


urdf = (
    '<robot name="r"><link name="base"/>' + slide("a")
    + slide("b", '<mimic joint="a" multiplier="2" offset="0.3"/>') + "</robot>"
)
model = mujoco.MjModel.from_xml_string(urdf)
model.opt.gravity[:] = 0


def run(start):
    data = mujoco.MjData(model)
    mujoco.mj_resetData(model, data)
    data.qpos[:] = start
    fastest = 0.0
    for _ in range(2000):
        mujoco.mj_step(model, data)
        fastest = max(fastest, abs(data.qvel[0]))
    return data.qpos.tolist(), fastest


print("mujoco", mujoco.__version__, "qpos0", model.qpos0.tolist())
place, kick = run(model.qpos0)
print(f"  from reset: leader's peak speed {kick:.2f} m/s, end {place[0]:.3f} and {place[1]:.3f}")
rest, still = run([0.0, 0.3])
print(f"  from 0 and 0.3: leader's peak speed {still:.2e} m/s, end {rest[0]:.3f} and {rest[1]:.3f}")
same = model.qpos0.tolist() == [0, 0] and kick > 1.5 and abs(place[0]) > 0.05 and still < 1e-6
print("as recorded" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PY
