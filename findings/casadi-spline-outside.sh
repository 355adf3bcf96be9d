#!/usr/bin/env bash
# casadi 3.8.2 (PyPI), recorded 2026-11-29.
#
# One would expect: the two methods of casadi.interpolant, "linear" and "bspline", do something alike outside the table, and a
#   smooth interpolant stays continuous there: it holds the last value, or extends the last piece.
# What happens: "linear" extends the last segment. "bspline" is exactly 0 from just outside the table on, both sides, with a
#   derivative of 0: a table of speeds that ends at 1 m/s reads 1 at its last time and 0 one ulp later.
# Why it matters: a reference or a limit looked up past its end becomes 0 without an error. An optimiser that puts a knot slightly
#   outside gets a cliff whose gradient is 0, so nothing pulls it back; a speed limit of 0 there is infeasible.
set -euo pipefail
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
python3 -m venv --without-pip "$work/venv"
python3 -m pip --python "$work/venv/bin/python" -q install --no-compile --disable-pip-version-check casadi==3.8.2 numpy==2.4.6
"$work/venv/bin/python" - <<'PY'
import casadi
import numpy as np

times = np.linspace(0, 1, 6)
speeds = 0.5 + 0.5 * times
t = casadi.MX.sym("t")
seen = {}
print("casadi", casadi.__version__, "table of 0.5 + 0.5 t on [0, 1]: value and derivative")
for method in ("linear", "bspline"):
    table = casadi.interpolant("table", method, [times], speeds)
    both = casadi.Function("both", [t], [table(t), casadi.gradient(table(t), t)])
    for at in (-0.1, 0.5, 1.0, np.nextafter(1.0, 2.0), 1.2):
        seen[method, at] = tuple(float(value) for value in both(at))
        print(f"  {method}, t = {at!r:>24}: {seen[method, at][0]:.4f}, {seen[method, at][1]:.4f}")
just = np.nextafter(1.0, 2.0)
same = abs(seen["linear", 1.2][0] - 1.1) < 1e-9 and abs(seen["bspline", 1.0][0] - 1) < 1e-9
same = same and all(seen["bspline", at] == (0.0, 0.0) for at in (-0.1, just, 1.2))
print("as recorded" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PY
