# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sources of the engine, as the scripts that check them read them."""

import re
import sys
from pathlib import Path

CORE = Path(__file__).resolve().parents[2] / "vcg_extras" / "core"
# From the lowest to the highest. A room may include itself and the rooms before it.
ROOMS = ["base", "mesh", "surface", "input", "features", "edit", "sampling", "retriangulation", "optimization", "guard", "output", "run"]


def modules_of(core):
    """Name, such as mesh/connect, to the files of the module: a header and its source."""
    modules = {}
    for file in sorted(core.rglob("*")):
        if file.suffix in (".h", ".cpp"):
            name = file.relative_to(core).with_suffix("").as_posix()
            modules.setdefault(name, []).append(file)
    return modules


def room_of(name):
    return name.split("/")[0] if "/" in name else ""


def code_of(file):
    """The text of a file with comments and strings emptied; its lines keep their numbers."""
    def empty(found):
        kept = '""' if found[0].startswith('"') else ""
        return kept + "\n" * found[0].count("\n")

    return re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', empty, file.read_text(), flags=re.S)


def check(breaches_of):
    """Prints a line for each breach in the engine's folder, the first argument of the program where there is one.
    The exit code is 1 where there is a breach, or no module."""
    core = Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else CORE
    modules = modules_of(core)
    breaches = breaches_of(core, modules) if modules else [f"there are no modules in {core}"]
    for breach in breaches:
        print(breach, file=sys.stderr)
    sys.exit(1 if breaches else 0)
