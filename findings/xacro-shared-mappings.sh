#!/usr/bin/env bash
# xacro 2.1.1 (PyPI), recorded 2026-11-29.
#
# One would expect: process_doc(document, mappings=arguments) reads the caller's dictionary, and <xacro:arg default="..."/> applies to the
#   document that has it.
# What happens: the defaults are written into the caller's dictionary. The next document that is expanded with it finds them
#   there, as though the caller had set them, and its own defaults are passed over: the second arm below gets the speed limit
#   of the first, 1.5 rad/s where its file says 0.2.
# Why it matters: programs that build several robots keep their arguments in one dictionary. Which limits an arm gets then depends
#   on which robot was loaded before it. Hand over a copy: mappings=dict(arguments).
set -euo pipefail
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
python3 -m venv --without-pip "$work/venv"
python3 -m pip --python "$work/venv/bin/python" -q install --no-compile --disable-pip-version-check xacro==2.1.1
"$work/venv/bin/python" - <<'PY'
from importlib.metadata import version
import xacro


def speed(default, arguments):
    document = xacro.parse(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        f'<xacro:arg name="speed" default="{default}"/><limit velocity="$(arg speed)"/></robot>'
    )
    xacro.process_doc(document, mappings=arguments)
    return document.getElementsByTagName("limit")[0].getAttribute("velocity")


print("xacro", version("xacro"))
arguments = {"prefix": "left"}
shared = [speed(1.5, arguments), speed(0.2, arguments)]
print("  defaults 1.5 and 0.2, one dictionary:", shared, "dictionary afterwards:", arguments)
original = {"prefix": "left"}
copied = [speed(1.5, dict(original)), speed(0.2, dict(original))]
print("  defaults 1.5 and 0.2, a copy for each:", copied)
same = shared == ["1.5", "1.5"] and arguments.get("speed") == "1.5" and copied == ["1.5", "0.2"]
print("as recorded" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PY
