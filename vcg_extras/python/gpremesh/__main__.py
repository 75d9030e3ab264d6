# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line: `gpremesh` and `python -m gpremesh` run the program that the package brings."""

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
        sys.exit("gpremesh: this package was built without the program, because CLI11 (libcli11-dev on Debian) was missing.")
    if os.name == "nt":  # where exec would not wait
        sys.exit(subprocess.call(words))
    os.execv(words[0], words)


if __name__ == "__main__":
    main()
