# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of MeshLab's meshlabserver, which wants a display."""

import argparse
from pathlib import Path

from .commands import RunFailed, timed

# As MeshLab's dialog proposes it, but for the number of faces.
QUADRIC_EDGE_COLLAPSE = """\
<!DOCTYPE FilterScript>
<FilterScript>
 <filter name="Simplification: Quadric Edge Collapse Decimation">
  <Param name="TargetFaceNum" type="RichInt" value="{faces}"/>
  <Param name="TargetPerc" type="RichFloat" value="0"/>
  <Param name="QualityThr" type="RichFloat" value="0.3"/>
  <Param name="PreserveBoundary" type="RichBool" value="false"/>
  <Param name="BoundaryWeight" type="RichFloat" value="1"/>
  <Param name="PreserveNormal" type="RichBool" value="false"/>
  <Param name="PreserveTopology" type="RichBool" value="false"/>
  <Param name="OptimalPlacement" type="RichBool" value="true"/>
  <Param name="PlanarQuadric" type="RichBool" value="false"/>
  <Param name="PlanarWeight" type="RichFloat" value="0.001"/>
  <Param name="QualityWeight" type="RichBool" value="false"/>
  <Param name="AutoClean" type="RichBool" value="true"/>
  <Param name="Selected" type="RichBool" value="false"/>
 </filter>
</FilterScript>
"""

NOTHING = """\
<!DOCTYPE FilterScript>
<FilterScript>
 <filter name="Select None">
  <Param name="allFaces" type="RichBool" value="true"/>
  <Param name="allVerts" type="RichBool" value="true"/>
 </filter>
</FilterScript>
"""


class MeshLab:
    """The MeshLab in a folder made by scripts/release/private_meshlab."""

    def __init__(self, folder):
        self.program = folder / "bin" / "meshlabserver"

    def run(self, mesh, script, log, result=None):
        """Wall seconds of one run. Without a result nothing is written."""
        command = [self.program, "-i", mesh, "-s", script]
        if result:
            command += ["-o", result]
        with log.open("w") as words:
            try:
                return timed(command, words, words)
            except RunFailed as failure:
                lines = log.read_text(errors="replace").splitlines()[-20:]
                raise RunFailed("\n".join([*lines, str(failure)])) from failure

    def quadric_edge_collapse(self, mesh, face_num, stem, result=None):
        """Leaves the script and the log beside the path `stem`."""
        return self._run_text(QUADRIC_EDGE_COLLAPSE.format(faces=face_num), mesh, stem, result)

    def nothing(self, mesh, stem):
        """What start, reading and a filter without work take."""
        return self._run_text(NOTHING, mesh, stem)

    def _run_text(self, script, mesh, stem, result=None):
        file = Path(f"{stem}.mlx")
        file.write_text(script)
        return self.run(mesh, file, Path(f"{stem}.log"), result)


def main(arguments):
    """One run for a shell script; prints the seconds."""
    parser = argparse.ArgumentParser(prog="scripts/measure/run meshlab")
    parser.add_argument("meshlab", type=Path, help="folder made by scripts/release/private_meshlab")
    parser.add_argument("mesh", type=Path)
    parser.add_argument("result", type=Path)
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--script", type=Path, help="filter script to run")
    what.add_argument("--quadric", type=int, metavar="FACES", help="Quadric Edge Collapse to so many faces")
    options = parser.parse_args(arguments)
    meshlab = MeshLab(options.meshlab)
    stem = options.result.with_suffix("")
    if options.script:
        seconds = meshlab.run(options.mesh, options.script, Path(f"{stem}.log"), options.result)
    else:
        seconds = meshlab.quadric_edge_collapse(options.mesh, options.quadric, stem, options.result)
    print(f"{seconds:.3f}")
