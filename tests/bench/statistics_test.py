# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What scripts/bench makes of its figures."""

import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts" / "speed"))

from bench import complaints, face_number
from measured_run import RunFailed, measured
from memory_by_stage import by_stage
from methods import all_methods
from statistics_of_runs import (Spread, growth, line_through, overhead_of, parallel_share, ratio_of,
                                spread_of)


def run(seconds, wall=None, faces=10, digest="same"):
    return {"seconds": seconds, "wall": wall or 2 * seconds, "processor": seconds, "peak": 10 ** 6,
            "vertices": 7, "faces": faces, "stages": {}, "digest": digest}


def mesh_with_all_methods():
    return {"name": "mesh", "faces": 1000, "grown": True,
            "runs": {method.key: [run(1)] for method in all_methods()}}


class Statistics(unittest.TestCase):
    def test_a_spread_is_median_and_extremes(self):
        self.assertEqual(Spread([3, 1, 2]).text("{:.1f}"), "2.0 (1.0–3.0)")
        self.assertEqual(Spread([3]).text("{:.1f}"), "3.0")

    def test_ratios_are_taken_round_by_round(self):
        mesh = {"runs": {"slow": [run(10), run(40)], "fast": [run(5), run(10), run(1)]}}
        ratio = ratio_of(mesh, "slow", "fast")
        self.assertEqual((ratio.low, ratio.median, ratio.high), (2, 3, 4))

    def test_a_method_that_was_not_run_has_no_figures(self):
        mesh = {"runs": {"fast": [run(1)]}}
        self.assertIsNone(ratio_of(mesh, "slow", "fast"))
        self.assertIsNone(spread_of(mesh, "slow", "seconds"))
        self.assertIsNone(overhead_of(mesh, "slow"))

    def test_growth_finds_the_exponent_of_a_power(self):
        factor, exponent = growth([(x, 3 * x ** 1.25) for x in (10, 100, 1000)])
        self.assertAlmostEqual(factor, 3)
        self.assertAlmostEqual(exponent, 1.25)
        self.assertIsNone(growth([(10, 1)]))

    def test_a_line_is_found_again(self):
        offset, slope = line_through([(x, 5 + 80 * x) for x in (1, 10, 100)])
        self.assertAlmostEqual(offset, 5)
        self.assertAlmostEqual(slope, 80)

    def test_a_second_thread_halves_the_parallel_share(self):
        self.assertAlmostEqual(parallel_share(10, 10 - 0.8 * 10 / 2), 0.8)
        self.assertEqual(parallel_share(10, 11), 0)


class Measured(unittest.TestCase):
    def test_sees_time_and_memory_from_outside(self):
        figures = measured(["/usr/bin/python3", "-c", "b = b'x' * 200_000_000"])
        self.assertGreater(figures.peak, 200_000_000)
        self.assertLess(figures.peak, 300_000_000)
        self.assertGreater(figures.wall, 0)

    def test_what_ran_before_does_not_count(self):
        ballast = bytes(bytearray(b"x") * 150_000_000)
        self.assertLess(measured(["/bin/true"]).peak, 20_000_000)
        del ballast

    def test_a_failure_is_told(self):
        with self.assertRaises(RunFailed):
            measured(["/bin/false"])


class MemoryByStage(unittest.TestCase):
    def test_a_stage_has_the_most_that_was_seen_in_its_time(self):
        seconds = {"load": 2, "order": 1, "short": 0.1, "read": 1, "remesh": 3.1, "total": 4.1}
        samples = [(0.5, 7), (1.5, 20), (2.5, 10), (3.5, 15), (9, 99)]
        self.assertEqual(by_stage(samples, seconds), {"read": 7, "load": 20, "order": 15, "short": None})


class Complaints(unittest.TestCase):
    def test_a_sound_record_has_none(self):
        self.assertEqual(complaints({"meshes": [mesh_with_all_methods()]}), [])

    def test_other_bytes_with_other_threads_are_found(self):
        mesh = mesh_with_all_methods()
        mesh["runs"]["fast-1"][0]["digest"] = "another"
        self.assertEqual(len(complaints({"meshes": [mesh]})), 1)

    def test_missing_and_impossible_runs_are_found(self):
        mesh = mesh_with_all_methods()
        mesh["runs"]["quadric"] = []
        mesh["runs"]["meshoptimizer"] = [run(1, wall=0.5, faces=1000)]
        self.assertEqual(len(complaints({"meshes": [mesh]})), 3)

    def test_sizes_are_read(self):
        self.assertEqual([face_number(t) for t in ("900", "30k", "0.27M", "7.75M")],
                         [900, 30000, 270000, 7750000])


if __name__ == "__main__":
    unittest.main()
