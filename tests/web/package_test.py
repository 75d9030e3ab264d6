#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The npm package in node, beside the program.

    package_test.py GPREMESH FOLDER      FOLDER has the package, made by scripts/release/make_page
"""

import json
import shutil
import subprocess
import sys
import tarfile
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "page"))
from viewer_test import torus_obj  # noqa: E402


def types_fit(work):
    """Whether TypeScript takes a program that uses the package."""
    if not shutil.which("tsc"):
        print("SKIPPED: tsc is missing (node-typescript); the types of the package are not checked")
        return True
    shutil.copy(Path(__file__).with_name("consumer.mts"), work)
    settings = {"noEmit": True, "strict": True, "target": "es2022", "module": "nodenext", "moduleResolution": "nodenext",
                "lib": ["es2022", "dom"], "types": []}
    Path(work, "tsconfig.json").write_text(json.dumps({"compilerOptions": settings, "files": ["consumer.mts"]}))
    return subprocess.run(["tsc", "--project", work]).returncode == 0


def main(gpremesh, folder):
    archives = list(Path(folder).glob("gpremesh-*.tgz"))
    if not archives or not shutil.which("node"):
        print("SKIPPED: the npm package was not made (scripts/release/make_page, which needs emscripten)")
        return 77
    with tempfile.TemporaryDirectory() as work:
        modules = Path(work, "node_modules")
        modules.mkdir()
        with tarfile.open(archives[0]) as archive:
            archive.extractall(modules)
        (modules / "package").rename(modules / "gpremesh")
        torus_obj(f"{work}/torus.obj", 80, 40)
        for name, options in (("plain", []), ("options", ["--vertices", "700", "--adapt", "1"])):
            subprocess.run([gpremesh, "remesh", f"{work}/torus.obj", f"{work}/{name}.ply", *options, "--quiet"], check=True)
        shutil.copy(Path(__file__).with_name("package_test.mjs"), work)
        if not types_fit(work):
            return 1
        return subprocess.run(["node", "--test", "package_test.mjs"], cwd=work).returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
