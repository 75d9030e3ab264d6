#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the scripts decide that make wheels and the extension for Blender; nothing is compiled."""

import importlib.machinery
import importlib.util
import sys
import tempfile
import tomllib
import unittest
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
RELEASE = ROOT / "scripts/release"
sys.path.insert(0, str(RELEASE))
sys.dont_write_bytecode = True


def load(name):
    loader = importlib.machinery.SourceFileLoader(name, str(RELEASE / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


class Wheels(unittest.TestCase):
    def test_modules_have_the_names_that_each_python_looks_for(self):
        systems = load("make_wheels").wheel_systems
        linux, arm, windows = systems.by_names("linux-x86_64,linux-aarch64,windows-x86_64")
        self.assertEqual(linux.suffix((3, 10)), ".cpython-310-x86_64-linux-gnu.so")
        self.assertEqual(arm.suffix((3, 11)), ".cpython-311-aarch64-linux-gnu.so")
        self.assertEqual(arm.suffix((3, 12)), ".abi3.so")
        self.assertEqual(windows.suffix((3, 12)), ".pyd")
        self.assertTrue(windows.has((3, 12)) and not windows.has((3, 11)) and linux.has((3, 10)))
        musl, mac = systems.by_names("musl-aarch64,macos-arm64")
        self.assertEqual(musl.suffix((3, 11)), ".cpython-311-aarch64-linux-musl.so")
        self.assertEqual(mac.suffix((3, 10)), ".cpython-310-darwin.so")
        self.assertEqual(mac.suffix((3, 13)), ".abi3.so")
        with self.assertRaises(SystemExit):
            systems.by_names("linux-x86_64,amiga")

    def test_what_a_wheel_may_need(self):
        make_wheels = load("make_wheels")
        allowed = r"(kernel32|python3)\.dll"
        make_wheels.refuse_others(["KERNEL32.dll", "python3.dll"], allowed)
        with self.assertRaisesRegex(SystemExit, "libgcc"):
            make_wheels.refuse_others(["KERNEL32.dll", "libgcc_s_seh-1.dll"], allowed)

    def test_requirements_are_those_of_the_project(self):
        found = load("make_wheels").wheel_systems.build_requirements(ROOT / "pyproject.toml")
        project = tomllib.loads((ROOT / "pyproject.toml").read_text())
        wanted = project["build-system"]["requires"]
        self.assertEqual(found[:len(wanted)], wanted)


class Blender(unittest.TestCase):
    def extensions(self, names):
        """The manifests and the files of the extensions that are made of wheels of these names."""
        made = {}
        with tempfile.TemporaryDirectory() as folder:
            wheels = [Path(folder, name) for name in names]
            for wheel in wheels:
                wheel.write_bytes(wheel.name.encode())
            make = load("make_blender_extension")
            make.main(make.argparse.Namespace(folder=folder, wheels=[str(wheel) for wheel in wheels], tries=[]))
            for path in sorted(Path(folder).glob("*.zip")):
                with zipfile.ZipFile(path) as archive:
                    files = {name: archive.read(name) for name in archive.namelist()}
                made[path.name] = tomllib.loads(files["blender_manifest.toml"].decode()), files
        return made

    def test_each_has_its_wheel_unchanged(self):
        linux = ["gpremesh-0.1.0-cp311-cp311-manylinux_2_28_x86_64.whl", "gpremesh-0.1.0-cp312-abi3-manylinux_2_28_x86_64.whl"]
        windows = ["gpremesh-0.1.0-cp312-abi3-win_amd64.whl"]
        others = ["gpremesh-0.1.0-cp310-cp310-manylinux_2_28_x86_64.whl", "gpremesh-0.1.0-cp312-abi3-manylinux_2_28_aarch64.whl"]
        made = self.extensions(linux + windows + others)
        self.assertEqual(list(made), [f"gpremesh-{load('make_blender_extension').project_version()}-{name}.zip" for name in (
            "blender4.2-linux-x64", "blender5.1-linux-x64", "blender5.1-windows-x64")])
        blenders = [("4.2.0", "5.1.0"), ("5.1.0", None), ("5.1.0", None)]  # those with Python 3.11, and with a later one
        for (manifest, files), wheel, range_of_blender in zip(made.values(), linux + windows, blenders):
            self.assertEqual(manifest["wheels"], [f"./wheels/{wheel}"])
            self.assertEqual(files[f"wheels/{wheel}"], wheel.encode())
            self.assertEqual((manifest["blender_version_min"], manifest.get("blender_version_max")), range_of_blender)
            self.assertEqual(manifest["platforms"], ["windows-x64" if "win" in wheel else "linux-x64"])
            self.assertEqual(set(files), {"__init__.py", "mesh_data.py", "blender_manifest.toml", "LICENSE", f"wheels/{wheel}"})

    def test_no_fitting_wheel_is_told(self):
        with self.assertRaisesRegex(SystemExit, "none of the wheels"):
            self.extensions(["gpremesh-0.1.0-cp310-cp310-manylinux_2_28_x86_64.whl"])


if __name__ == "__main__":
    unittest.main()
