#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/check/rooms accepts the engine as it is, and finds planted breaches in small engines."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CHECKER = Path(__file__).resolve().parents[2] / "scripts" / "check" / "rooms"


def check(*arguments):
    return subprocess.run([sys.executable, CHECKER, *map(str, arguments)], capture_output=True, text=True)


class Rooms(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.core = Path(self.folder.name)
        self.write("base/vector.h", "")
        self.write("mesh/half_edges.h", "#include <vcg_extras/core/base/vector.h>")
        self.write("mesh/half_edges.cpp", '#include "half_edges.h"')

    def tearDown(self):
        self.folder.cleanup()

    def write(self, name, text):
        file = self.core / name
        file.parent.mkdir(exist_ok=True)
        file.write_text(text + "\n")

    def assert_breach(self, words):
        result = check(self.core)
        self.assertEqual(result.returncode, 1)
        self.assertIn(words, result.stderr)

    def test_the_engine_is_in_order(self):
        result = check()
        self.assertEqual(result.stderr, "")
        self.assertEqual(result.returncode, 0)

    def test_a_small_engine_in_order_is_accepted(self):
        self.assertEqual(check(self.core).returncode, 0)

    def test_an_upward_include_is_found(self):
        self.write("base/vector.h", "#include <vcg_extras/core/mesh/triangle.h>")
        self.write("mesh/triangle.h", "")
        self.assert_breach("upward include: base/vector includes mesh/triangle")

    def test_a_room_that_includes_the_facade_is_found(self):
        self.write("remesh.h", "")
        self.write("mesh/half_edges.cpp", '#include "half_edges.h"\n#include <vcg_extras/core/remesh.h>')
        self.assert_breach("upward include: mesh/half_edges includes remesh")

    def test_a_circle_through_a_source_is_found(self):
        self.write("mesh/edit.h", '#include "half_edges.h"')
        self.write("mesh/half_edges.cpp", '#include "half_edges.h"\n#include "edit.h"')
        self.assert_breach("circle of includes: mesh/edit -> mesh/half_edges -> mesh/edit")

    def test_a_crowded_room_is_found(self):
        for i in range(20):
            self.write(f"mesh/m{i}.h", "")
        self.assert_breach("mesh has 21 modules")

    def test_an_unknown_room_is_found(self):
        self.write("attic/old.h", "")
        self.assert_breach("attic/old lies in an unknown room")

    def test_an_empty_folder_is_no_engine(self):
        with tempfile.TemporaryDirectory() as empty:
            self.assertEqual(check(empty).returncode, 1)


if __name__ == "__main__":
    unittest.main()
