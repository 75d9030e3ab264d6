#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What lays the files for registries of packages, and what reads the load commands of macOS; nothing is compiled."""

import importlib.machinery
import importlib.util
import struct
import subprocess
import sys
import tarfile
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "scripts/release"))

import mach_o  # noqa: E402


def load(path):
    loader = importlib.machinery.SourceFileLoader(Path(path).name, str(ROOT / path))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


def mach_o_file(commands, processor=0x0100000C):
    body = b"".join(commands)
    return struct.pack("<8I", mach_o.MAGIC_64, processor, 0, 6, len(commands), len(body), 0, 0) + body


def library(name):
    text = name.encode() + b"\0" * (8 - len(name) % 8)
    return struct.pack("<6I", mach_o.LOAD_DYLIB, 24 + len(text), 24, 0, 0, 0) + text


class MachO(unittest.TestCase):
    def test_reads_processor_system_and_libraries(self):
        least = struct.pack("<6I", mach_o.BUILD_VERSION, 24, mach_o.MACOS_PLATFORM, 11 << 16, 14 << 16, 0)
        found = mach_o.load_commands(mach_o_file([least, library("/usr/lib/libSystem.B.dylib")]))
        self.assertEqual((found.machine, found.least_system, found.libraries, found.is_signed),
                         ("arm64", "11.0", ["/usr/lib/libSystem.B.dylib"], False))
        older = struct.pack("<4I", mach_o.VERSION_MIN_MACOSX, 16, 10 << 16 | 15 << 8, 0)
        self.assertEqual(mach_o.load_commands(mach_o_file([older], 0x01000007)).least_system, "10.15")

    def test_refuses_what_is_none_or_ends_too_early(self):
        good = mach_o_file([library("/usr/lib/libc++.1.dylib")])
        phone = struct.pack("<6I", mach_o.BUILD_VERSION, 24, 2, 11 << 16, 14 << 16, 0)
        for data in b"", b"\x7fELF" * 20, good[:40], mach_o_file([phone]), mach_o_file([struct.pack("<2I", 2, 0)]):
            with self.assertRaises(ValueError):
                mach_o.load_commands(data)


class Lay(unittest.TestCase):
    def archive(self, folder):
        path = Path(folder, "gpremesh-1.2.3.tar.gz")
        with tarfile.open(path, "w:gz") as sources:
            sources.add(ROOT / "LICENSE", "gpremesh-1.2.3/LICENSE")
        return path

    def run_lay(self, *words):
        return subprocess.run([sys.executable, ROOT / "packaging/lay", *words], capture_output=True, text=True)

    def test_names_what_a_person_has_to_fill_in(self):
        with tempfile.TemporaryDirectory() as folder:
            told = self.run_lay("conda-forge", f"{folder}/laid", "--archive", self.archive(folder))
            self.assertEqual(told.returncode, 1)
            for name in "archive_url", "github_account", "homepage", "repository":
                self.assertIn(name, told.stderr)
            self.assertFalse(Path(folder, "laid").exists())

    def test_stand_ins_fill_every_receiver(self):
        with tempfile.TemporaryDirectory() as folder:
            archive = self.archive(folder)
            for receiver in "conda-forge", "vcpkg", "conan", "debian", "meshlab":
                told = self.run_lay(receiver, f"{folder}/{receiver}", "--archive", archive, "--for-checks")
                self.assertEqual(told.returncode, 0, told.stderr)
                texts = "".join(path.read_text() for path in Path(folder, receiver).rglob("*") if path.is_file())
                self.assertIn("1.2.3" if receiver != "vcpkg" else '"version": "1.2.3"', texts)
                self.assertNotRegex(texts, "@(homepage|repository|archive_url|version|sha256|sha512|md5)@")

    def test_local_packages_have_no_made_up_address(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(self.run_lay("debian", f"{folder}/debian", "--without-person").returncode, 0)
            control = Path(folder, "debian/control").read_text()
            self.assertNotIn("example.org", control)
            self.assertIn("Maintainer: the gpremesh authors", control)


class PyPI(unittest.TestCase):
    def test_links_get_whole_addresses(self):
        whole = load("packaging/pypi/lay_sources").with_whole_addresses
        text = "[a](scale.md#top) ![b](../../screenshots/x.png) [c](https://d.org) [e](#here) [f](../apps/README.md)"
        self.assertEqual(
            whole(text, "vcg_extras/docs", "https://r.org/s", "1.0"),
            "[a](https://r.org/s/blob/v1.0/vcg_extras/docs/scale.md#top) ![b](https://r.org/s/raw/v1.0/screenshots/x.png) "
            "[c](https://d.org) [e](#here) [f](https://r.org/s/blob/v1.0/vcg_extras/apps/README.md)")


if __name__ == "__main__":
    unittest.main()
