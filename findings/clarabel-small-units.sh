#!/usr/bin/env bash
# clarabel 0.11.1 (PyPI), recorded 2026-11-29.
#
# One would expect: a QP keeps its solution when the unit of length changes: min |x|^2/2 - s (2, 3) x with x1 + x2 <= s has
#   the solution s (0, 1), and a solver that says "Solved" has it to about its tolerance of 1e-8.
# What happens: with s = 1e-3 x/s is right to four digits; with s = 1e-4 it is (-0.18, 0.82); with s = 1e-6 it is
#   (-35, -34), wrong in sign and in size. The status is Solved each time and the residuals are tiny: the duality gap is
#   compared with 1e-8, and the relative test divides by no less than 1, while the whole objective is 2.5e-8 at s = 1e-4
#   and 2.5e-12 at s = 1e-6. With both gap tolerances at 1e-14 the answers are right to 2e-4 of s.
# Why it matters: small displacements in metres, one control period's change of a joint, distances to a boundary near contact:
#   such QPs are small as a whole. Scale the problem to 1, or tighten both gap tolerances, before trusting "Solved".
set -euo pipefail
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
python3 -m venv --without-pip "$work/venv"
python3 -m pip --python "$work/venv/bin/python" -q install --no-compile --disable-pip-version-check clarabel==0.11.1 numpy==2.4.6 scipy==1.17.1
"$work/venv/bin/python" - <<'PY'
import clarabel
import numpy as np
from scipy.sparse import csc_matrix


def solve(scale, gap):
    """Status and x / scale."""
    settings = clarabel.DefaultSettings()
    settings.verbose = False
    if gap is not None:
        settings.tol_gap_abs = settings.tol_gap_rel = gap
    solver = clarabel.DefaultSolver(
        csc_matrix(np.eye(2)), scale * np.array([-2.0, -3.0]), csc_matrix([[1.0, 1.0]]), np.array([scale]),
        [clarabel.NonnegativeConeT(1)], settings,
    )
    solution = solver.solve()
    return solution.status, np.array(solution.x) / scale


print("clarabel", clarabel.__version__, "x divided by the scale; exact: 0, 1")
seen = {}
for gap in (None, 1e-14):
    for scale in (1.0, 1e-3, 1e-4, 1e-6):
        status, x = solve(scale, gap)
        seen[gap, scale] = np.abs(x - [0, 1]).max() if status == clarabel.SolverStatus.Solved else np.inf
        print(f"  gap tolerances {'default' if gap is None else gap}, scale {scale:g}: {status}, {x.round(5).tolist()}")
same = seen[None, 1.0] < 1e-6 and seen[None, 1e-3] < 1e-3 and 0.1 < seen[None, 1e-4] < 1 and 10 < seen[None, 1e-6] < 100
same = same and all(seen[1e-14, scale] < 1e-3 for scale in (1.0, 1e-3, 1e-4, 1e-6))
print("as recorded" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PY
