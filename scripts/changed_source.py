# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A copy of the project in which lines of the engine are changed: for mutants and for the ablation."""

import contextlib
import filecmp
import shutil
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
CORE = "vcg_extras/core"


def missing(changes):
    """Names of changes whose line is not there once. A change has a name, a file below the core, a line, and what
    takes the place of the line."""
    return [c.name for c in changes if (ROOT / CORE / c.file).read_text().count(c.line) != 1]


def make_copy(source):
    """Of what git tracks, as it is in the working tree. Files that are the same keep their time."""
    names = subprocess.run(["git", "-C", ROOT, "ls-files"], capture_output=True, check=True, text=True).stdout
    for name in names.splitlines():
        original, copy = ROOT / name, source / name
        if not original.is_file() or (copy.exists() and filecmp.cmp(original, copy, shallow=False)):
            continue
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(original, copy)


@contextlib.contextmanager
def changed(source, changes):
    """The copy has these changes inside of the `with` block."""
    before = {}
    try:
        for change in changes:
            place = source / CORE / change.file
            text = place.read_text()
            before.setdefault(place, text)
            place.write_text(text.replace(change.line, change.instead))
        yield
    finally:
        for place, text in before.items():
            place.write_text(text)
