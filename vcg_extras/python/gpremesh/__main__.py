# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line: `gpremesh` and `python -m gpremesh` run the program in the package. A package built without the
program does `gpremesh remesh` itself."""

import os
import subprocess
import sys
from pathlib import Path


def program():
    """The path of the program."""
    return str(Path(__file__).parent / "bin" / ("gpremesh.exe" if os.name == "nt" else "gpremesh"))


def main():
    words = [program(), *sys.argv[1:]]
    if not os.path.exists(words[0]):
        from ._command import run

        sys.exit(run(words[1:]))
    if os.name == "nt":  # exec would not wait
        sys.exit(subprocess.call(words))
    os.execv(words[0], words)


if __name__ == "__main__":
    main()
