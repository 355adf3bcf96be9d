#!/usr/bin/env bash
# xacro 2.1.1 with PyYAML (PyPI), recorded 2026-11-29.
#
# One would expect: `max_velocity: 1e-3` in a parameter file, read with xacro.load_yaml, is the number 0.001 in an expression, as it is
#   when written as a <xacro:property value="1e-3"/>.
# What happens: PyYAML takes a float only with a decimal point, so 1e-3 is a string. xacro turns the strings of its properties into
#   numbers, but not those of a YAML file: ${2*limits['max_velocity']} is "1e-31e-3", the string written twice, which goes
#   into the URDF without an error. A single ${...} looks right, so a file can be in use for long before someone scales it.
# Why it matters: limits and gains of robots live in YAML files and are scaled in xacro. A factor of 0.5 raises at the place; a factor
#   of 2 writes nonsense that a URDF parser later rejects with the whole file, far from its cause. Write 1.0e-3.
set -euo pipefail
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
python3 -m venv --without-pip "$work/venv"
python3 -m pip --python "$work/venv/bin/python" -q install --no-compile --disable-pip-version-check xacro==2.1.1
cd "$work"
printf 'dotted: 1.0e-3\nbare: 1e-3\n' > limits.yaml
"$work/venv/bin/python" - <<'PY'
from importlib.metadata import version
import xacro


def expand(expression):
    document = xacro.parse(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:property name="bare" value="1e-3"/>'
        '<xacro:property name="limits" value="${xacro.load_yaml(\'limits.yaml\')}"/>'
        f'<limit velocity="${{{expression}}}"/></robot>'
    )
    xacro.process_doc(document)
    return document.getElementsByTagName("limit")[0].getAttribute("velocity")


print("xacro", version("xacro"), "PyYAML", version("PyYAML"))
seen = {
    expression: expand(expression)
    for expression in ("2*bare", "2*limits['dotted']", "limits['bare']", "2*limits['bare']")
}
for expression, text in seen.items():
    print(f"  ${{{expression}}} -> {text}")
same = list(seen.values()) == ["0.002", "0.002", "1e-3", "1e-31e-3"]
print("as recorded" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PY
