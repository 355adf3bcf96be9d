"""Reference values for the files of this folder, by pinocchio (`pip install pin`): python reference.py > reference.json

Each file is rewritten to what it means before pinocchio reads it: decoration goes, limits are wide, missing axes are
1 0 0, missing moments are zero, quaternions become angles, `<mimic>` goes. All joints outside the arm are then held, and
the joints that follow others are eliminated with p = S q + p0: J S, S^T tau, S^T M S.
"""

import json
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pinocchio as pin

# Base and tip where they are not the root and the last link, and the joints that follow: (leader, ratio, offset).
ENDS = {
    "tilted": ("mount", "b"),
    "moved_base": ("carriage", "b"),
    "fingers": ("base", "hand"),
    "tips": ("base", "tool0"),
    "beside_gripper": ("base", "left_tool0"),
    "mimic": ("base", "tool0"),
    "mimic_of_mimic": ("base", "tool0"),
    "mimic_outside": ("base", "tool0"),
    "ten_joints": ("l0", "l10"),
}
FOLLOWERS = {
    "mimic": {"j2": ("j1", -0.5, 0.3)},
    "mimic_of_mimic": {"j1": ("j3", 2.0, -0.1), "j2": ("j3", 0.1, 0.05 * -0.1 + 0.02)},
}
HELD = {"mimic_outside": {"lead": 0.0, "j2": 0.4}, "fingers": {"f1": 0.0, "f2": 0.01}, "moved_base": {"turn": 0.0},
        "beside_gripper": {"f": 0.0}}
KEPT = {"link", "joint", "inertial", "origin", "mass", "inertia", "parent", "child", "axis"}
ENTRIES = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")


def read(path):
    """The tree of a file, the loose ampersand and the repeated attribute of `decoration` mended."""
    text = path.read_bytes().decode("latin-1" if path.stem == "latin1" else "utf-8")
    text = text.replace("1 1 & 1", "1 1 1").replace('x="1" x="2"', 'x="1"').split("?>", 1)[1]
    return ET.fromstring(text)


def prune(element):
    for child in list(element):
        if child.tag in KEPT:
            prune(child)
        else:
            element.remove(child)


def angles(origin):
    x, y, z, w = map(float, origin.attrib.pop("quat_xyzw").split())
    matrix = pin.Quaternion(w, x, y, z).normalized().toRotationMatrix()
    origin.set("rpy", " ".join(repr(float(a)) for a in pin.rpy.matrixToRpy(matrix)))


def mend_link(link, is_base):
    inertial = link.find("inertial")
    if inertial is None:
        return
    if is_base or inertial.find("mass") is None:
        link.remove(inertial)
        return
    matrix = inertial.find("inertia")
    if matrix is None:
        matrix = ET.SubElement(inertial, "inertia")
    for entry in ENTRIES:
        matrix.attrib.setdefault(entry, "0")


def mend_joint(joint):
    if joint.get("type") == "fixed":
        return
    axis = joint.find("axis")
    if axis is None:
        axis = ET.SubElement(joint, "axis")
    axis.attrib.setdefault("xyz", "1 0 0")
    # A continuous joint has two coordinates in pinocchio; a wide range is the same thing with one.
    if joint.get("type") == "continuous":
        joint.set("type", "revolute")
    ET.SubElement(joint, "limit", lower="-9", upper="9", effort="9", velocity="9")


def model_of(path):
    root = read(path)
    prune(root)
    root.attrib.pop("version", None)
    for origin in root.iter("origin"):
        if "quat_xyzw" in origin.attrib:
            angles(origin)
    for link in root.findall("link"):
        mend_link(link, link.get("name") in ("base", "box"))
    for joint in root.findall("joint"):
        mend_joint(joint)
    return pin.buildModelFromXML(ET.tostring(root, encoding="unicode"))


def reduced(model, held):
    reference = pin.neutral(model)
    for name, position in held.items():
        reference[model.joints[model.getJointId(name)].idx_q] = position
    return pin.buildReducedModel(model, [model.getJointId(name) for name in held], reference)


def states(name, model, base, tip, random):
    """Reference values at three configurations."""
    names = list(model.names)[1:]
    followers = FOLLOWERS.get(name, {})
    own = [joint for joint in names if joint not in followers]
    matrix, constant = np.zeros((model.nv, len(own))), np.zeros(model.nv)
    for row, joint in enumerate(names):
        leader, ratio, offset = followers.get(joint, (joint, 1.0, 0.0))
        matrix[row, own.index(leader)], constant[row] = ratio, offset
    data = model.createData()
    for _ in range(3):
        q, qd, qdd = (random.uniform(-1, 1, len(own)) for _ in range(3))
        p, pd, pdd = matrix @ q + constant, matrix @ qd, matrix @ qdd
        torque = matrix.T @ pin.rnea(model, data, p, pd, pdd)
        gravity = matrix.T @ pin.computeGeneralizedGravity(model, data, p)
        mass = pin.crba(model, data, p)
        mass = np.triu(mass) + np.triu(mass, 1).T
        pin.framesForwardKinematics(model, data, p)
        base_pose, tip_pose = (data.oMf[model.getFrameId(frame)] for frame in (base, tip))
        aligned = pin.LOCAL_WORLD_ALIGNED
        jacobian = pin.computeFrameJacobian(model, data, p, model.getFrameId(tip), aligned)
        turn = np.kron(np.eye(2), base_pose.rotation.T)
        yield {"q": q, "qd": qd, "qdd": qdd, "pose": base_pose.actInv(tip_pose).homogeneous,
               "jacobian": turn @ jacobian @ matrix, "mass_matrix": matrix.T @ mass @ matrix,
               "gravity": gravity, "torque": torque}


def plain(value):
    return value.tolist() if isinstance(value, np.ndarray) else value


def main():
    random = np.random.default_rng(560)
    robots = {}
    for path in sorted(Path(__file__).parent.glob("*.urdf")):
        name = path.stem
        model = reduced(model_of(path), HELD.get(name, {}))
        base, tip = ENDS.get(name, (None, None))
        frames = [frame.name for frame in model.frames if frame.type == pin.BODY]
        base, tip = base or frames[0], tip or "b"
        rows = [{k: plain(v) for k, v in row.items()} for row in states(name, model, base, tip, random)]
        lines = ",\n".join(map(json.dumps, rows))
        robots[name] = f'{{"base": {json.dumps(base)}, "tip": {json.dumps(tip)}, "states": [\n{lines}]}}'
    # One state a line.
    rows = ",\n".join(f"{json.dumps(name)}: {robot}" for name, robot in robots.items())
    print(f'{{"pinocchio": "{pin.__version__}", "robots": {{\n{rows}\n}}}}')


main()
