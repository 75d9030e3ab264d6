# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""run_tests of scripts/common.sh and scripts/check/count_tests, on small folders of tests made here."""

import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

GOOD = 'add_test(good "true")\n'
BAD = 'add_test(bad "false")\n'
NOT_BUILT = 'add_test(some_NOT_BUILT some_NOT_BUILT)\n'
DISABLED = 'add_test(off "true")\nset_tests_properties(off PROPERTIES DISABLED TRUE)\n'


def skipped_script(name, reason):
    return (f'add_test({name} "sh" "-c" "echo SKIPPED: {reason}; exit 77")\n'
            f'set_tests_properties({name} PROPERTIES SKIP_RETURN_CODE 77)\n')


def skipped_by_googletest(name, reason, lines_before=0):
    said = f"seq {lines_before}; echo /a/test.cpp:7: Skipped; echo {reason}; echo '[  SKIPPED ] a.b (0 ms)'"
    return (f'add_test({name} "sh" "-c" "{said}")\n'
            f'set_tests_properties({name} PROPERTIES SKIP_REGULAR_EXPRESSION "\\\\[  SKIPPED \\\\]")\n')


class Run:
    """A folder of tests, run: whether ctest and the count call it a success, and what the count says."""

    def __init__(self, tests):
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "CTestTestfile.cmake").write_text(tests)
            self.count_before_run = self.count(folder).returncode
            run = subprocess.run(["bash", "-c", 'source scripts/common.sh; run_tests "$1"', "run_tests", folder],
                                 cwd=ROOT, capture_output=True)
            count = self.count(folder)
        self.ran_well = run.returncode == 0
        self.counted_well = count.returncode == 0
        self.lines = count.stdout.splitlines()

    @staticmethod
    def count(folder):
        return subprocess.run([ROOT / "scripts/check/count_tests", Path(folder, "test_results.xml")],
                              capture_output=True, text=True)


class RunTests(unittest.TestCase):
    def test_no_tests_are_a_failure(self):
        run = Run("")
        self.assertFalse(run.ran_well)
        self.assertFalse(run.counted_well)
        self.assertEqual(run.lines, ["tests: 0 passed, 0 failed, 0 skipped"])

    def test_no_results_are_a_failure(self):
        self.assertNotEqual(Run(GOOD).count_before_run, 0)

    def test_only_skipped_tests_are_a_failure(self):
        run = Run(skipped_script("skip", "no display"))
        self.assertFalse(run.counted_well)
        self.assertEqual(run.lines, ["1 skipped: no display", "tests: 0 passed, 0 failed, 1 skipped"])

    def test_a_good_test_is_a_success(self):
        run = Run(GOOD)
        self.assertTrue(run.ran_well)
        self.assertTrue(run.counted_well)
        self.assertEqual(run.lines, ["tests: 1 passed, 0 failed, 0 skipped"])

    def test_a_bad_test_is_named(self):
        run = Run(GOOD + BAD)
        self.assertFalse(run.ran_well)
        self.assertFalse(run.counted_well)
        self.assertEqual(run.lines, ["failed: bad", "tests: 1 passed, 1 failed, 0 skipped"])

    def test_a_test_that_was_not_built_failed(self):
        run = Run(GOOD + NOT_BUILT)
        self.assertFalse(run.ran_well)
        self.assertFalse(run.counted_well)
        self.assertEqual(run.lines, ["failed: some_NOT_BUILT", "tests: 1 passed, 1 failed, 0 skipped"])

    def test_skipped_tests_are_grouped_by_reason(self):
        run = Run(GOOD + DISABLED + skipped_script("a", "no models") + skipped_script("b", "no display")
                  + skipped_by_googletest("c", "no models"))
        self.assertTrue(run.ran_well)
        self.assertTrue(run.counted_well)
        self.assertEqual(run.lines[0], "2 skipped: no models")
        self.assertEqual(sorted(run.lines[1:-1]), ["1 skipped: disabled in CMake", "1 skipped: no display"])
        self.assertEqual(run.lines[-1], "tests: 1 passed, 0 failed, 4 skipped")

    def test_a_reason_behind_much_output_is_found(self):
        run = Run(GOOD + skipped_by_googletest("late", "no models", lines_before=1000))
        self.assertEqual(run.lines[0], "1 skipped: no models")


if __name__ == "__main__":
    unittest.main()
