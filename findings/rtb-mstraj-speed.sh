#!/usr/bin/env bash
# roboticstoolbox-python 1.5.0 (PyPI), recorded 2026-11-29.
#
# One would expect: `mstraj(via, dt, tacc, qdmax=1)` moves through the via points at a joint speed of at most 1, and begins at
#   the first of them.
# What happens: the blend at the start and at each via point swings past qdmax, the more so the shorter it is: 26 % over with
#   tacc = 0.4 s and 37 % with 0.2 s, whatever the dt. A blend of 0.8 s stays below. And the row at t = 0 is one step
#   into the motion: with dt = 0.1 it stands 0.09 rad from the first via point, which is not in the table.
# Why it matters: qdmax is handed over as the speed limit of the joints, and a shorter blend is the usual choice for staying
#   near the via points. A robot that is commanded the first row from the first via point is asked for a step.
set -euo pipefail
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
python3 -m venv --without-pip "$work/venv"
python3 -m pip --python "$work/venv/bin/python" -q install --no-compile --disable-pip-version-check roboticstoolbox-python==1.5.0 numpy==2.4.6
"$work/venv/bin/python" - <<'PY'
from importlib.metadata import version
import numpy as np
import roboticstoolbox as rtb

VIA = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]])
LIMIT = 1.0


def move(tacc, dt):
    return rtb.mstraj(VIA, dt=dt, tacc=tacc, qdmax=LIMIT).q


print("roboticstoolbox", version("roboticstoolbox-python"), "qdmax", LIMIT)
seen = {}
for tacc in (0.8, 0.4, 0.2):
    for dt in (0.01, 0.001):
        seen[tacc, dt] = np.abs(np.diff(move(tacc, dt), axis=0)).max() / dt
        print(f"  tacc {tacc}, dt {dt}: peak speed {seen[tacc, dt]:.3f}")
first = move(0.2, 0.1)[0]
print("  first row with tacc 0.2, dt 0.1:", first.round(4).tolist())
same = abs(seen[0.4, 0.001] - 1.26) < 0.01 and abs(seen[0.2, 0.001] - 1.374) < 0.01 and seen[0.8, 0.001] < LIMIT
same = same and abs(seen[0.2, 0.01] - 1.354) < 0.02 and abs(first[0] - 0.0909) < 1e-3
print("as recorded" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PY
