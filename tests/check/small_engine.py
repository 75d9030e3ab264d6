# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the scripts in scripts/check share."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts" / "check"


class SmallEngine(unittest.TestCase):
    """A folder with the sources of a small engine, and the script that checks it."""

    SCRIPT = ""  # its name in scripts/check

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.core = Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def write(self, name, text):
        file = self.core / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text + "\n")

    def check(self, *arguments):
        command = [sys.executable, SCRIPTS / self.SCRIPT, *map(str, arguments)]
        return subprocess.run(command, capture_output=True, text=True)

    def assert_breach(self, words, *arguments):
        result = self.check(self.core, *arguments)
        self.assertEqual(result.returncode, 1)
        self.assertIn(words, result.stderr)

    def assert_accepted(self, *arguments):
        result = self.check(*arguments)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def assert_empty_folder_is_refused(self):
        with tempfile.TemporaryDirectory() as empty:
            self.assertEqual(self.check(empty).returncode, 1)
