# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A simplifier of PyPI on a file, as gpr_bench_baseline runs those of Debian: prints its own seconds and what is left
as JSON. The Python must have numpy and almeshopt.

    python3 -m measure.package_baseline METHOD IN OUT FACES     METHOD is one of simulation_tasks.REMESHERS
"""

import json
import sys
import time
from pathlib import Path

import almeshopt  # noqa: F401: so that its loading is not timed
import numpy as np

from .binary_ply import arrays_of, write_arrays
from .simulation_tasks import REMESHERS, only_used


def main(method, source, target, face_goal):
    vertices, faces = arrays_of(Path(source))
    # The types that the package works on: the remesher has nothing to convert while it is timed.
    vertices, faces = vertices.astype(np.float32), faces.view(np.uint32)
    start = time.perf_counter()
    _, left = REMESHERS[method](vertices, faces, 0, int(face_goal))
    seconds = time.perf_counter() - start
    if len(left) == 0:
        sys.exit("package_baseline: no face was left")
    vertices, left = only_used(vertices, left)
    write_arrays(Path(target), vertices, left)
    print(json.dumps({"seconds": seconds, "vertices": len(vertices), "faces": len(left)}))


if __name__ == "__main__":
    main(*sys.argv[1:])
