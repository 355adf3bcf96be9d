#!/usr/bin/env bash
# roboticstoolbox-python 1.5.0 (PyPI), recorded 2026-11-29.
#
# One would expect: the columns of `jtraj(q0, q1, t)` belong together: `sd` is the derivative of `s` with respect to the `t` it
#   returns, and the first sample is q0.
# What happens, twice. With a step count, jtraj(q0, q1, 101), the velocities are those of a 1 s move, as the documentation has it,
#   while the t of the same result runs from 0 to 101: the peak of 1.875 is 101 times the slope of s over t. With times that do
#   not begin at 0, such as 5 to 15 s, the samples are the later two thirds of a 15 s move from time 0: the first is not q0
#   but already 21 % of the way, with a velocity. (The documentation speaks of the scale of velocities there.)
# Why it matters: both go wrong without a message: a feed-forward 101 times too large, and a step at the start of every
#   segment but the first when segments are joined on one clock. Pass times that begin at 0, and shift afterwards.
set -euo pipefail
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
python3 -m venv --without-pip "$work/venv"
python3 -m pip --python "$work/venv/bin/python" -q install --no-compile --disable-pip-version-check roboticstoolbox-python==1.5.0 numpy==2.4.6
"$work/venv/bin/python" - <<'PY'
from importlib.metadata import version
import numpy as np
import roboticstoolbox as rtb

print("roboticstoolbox", version("roboticstoolbox-python"))
steps = rtb.jtraj([0.0], [1.0], 101)
slope = np.gradient(steps.s[:, 0], steps.t).max()
print(f"  101 steps: t from {steps.t[0]:g} to {steps.t[-1]:g}, slope of s {slope:.4f}, velocity {steps.sd.max():.4f}")
zero = rtb.jtraj([0.0], [1.0], np.linspace(0, 10, 101))
print(f"  t from 0 to 10: first sample {zero.s[0, 0]:.4f}, velocity {zero.sd[0, 0]:.4f}")
late = rtb.jtraj([0.0], [1.0], np.linspace(5, 15, 101))
print(f"  t from 5 to 15: first sample {late.s[0, 0]:.4f}, velocity {late.sd[0, 0]:.4f}")
same = abs(steps.sd.max() - 1.875) < 1e-6 and abs(steps.sd.max() / slope - 101) < 1
same = same and zero.s[0, 0] == 0 and abs(late.s[0, 0] - 0.2099) < 1e-3 and late.sd[0, 0] > 0.05
print("as recorded" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PY
