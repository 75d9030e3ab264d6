# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What scripts/measure/run calls: one of the measurements, or a small service.

    python3 -m measure commit                          the commit that the sources are of
    python3 -m measure meshlab ARGUMENTS               one run of meshlabserver, see meshlab.py
    python3 -m measure quality|paper|simulation|speed BUILD COMMIT ARGUMENTS
"""

import subprocess
import sys
from pathlib import Path

from . import meshlab, paper, quality, simulation, speed
from .circumstances import commit_of_sources
from .commands import RunFailed, say

MEASUREMENTS = {"quality": quality.main, "paper": paper.main, "simulation": simulation.main, "speed": speed.main}


def main(which, *arguments):
    if which == "commit":
        print(commit_of_sources())
    elif which == "meshlab":
        meshlab.main(arguments)
    else:
        build, commit, *rest = arguments
        MEASUREMENTS[which](Path(build), commit, rest)


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except (OSError, RunFailed, RuntimeError, subprocess.CalledProcessError) as error:
        say(str(error), sys.stderr)
        sys.exit(1)
