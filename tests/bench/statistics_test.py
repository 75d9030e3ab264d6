# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What scripts/measure makes of its figures."""

import copy
import io
import sys
import tempfile
import unittest
from contextlib import redirect_stdout
from pathlib import Path
from unittest import mock

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))

from measure import binary_ply, paper, quality, simulation_page, speed_page, speed_picture
from measure.bandwidth import memory_bandwidth
from measure.circumstances import sentence_on_load
from measure.commands import Programs, RunFailed, measured, timed
from measure.counters import count_all, counters_in, growth_of_seconds_a_face, second_level_cache, wrongs_of_counters
from measure.memory_by_stage import by_stage
from measure.methods import all_methods
from measure.pages import between_marks, table
from measure.speed import command_of, complaints, face_number, methods_of, package_version
from measure.statistics_of_runs import (Spread, amdahl, bandwidth_seconds, growth, has_same_bytes, line_through,
                                        overhead_of, parallel_share, ratio_of, spread_of)


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

    def test_amdahl_bounds_what_many_cores_gain(self):
        self.assertEqual([amdahl(1, 8), amdahl(0, 64), amdahl(1.03, 64)], [8, 1, 64])
        self.assertAlmostEqual(amdahl(parallel_share(10, 6), 2), 10 / 6)
        self.assertAlmostEqual(amdahl(0.95, 8), 1 / (0.05 + 0.95 / 8))

    def test_the_limit_is_what_fast_holds_written_and_read_once(self):
        self.assertEqual(bandwidth_seconds({"runs": {"fast-2": [run(1)]}}, 1e6), 2)  # the peak of run() is 1e6

    def test_runs_with_any_number_of_threads_are_compared(self):
        runs = {"fast-1": [run(1)], "fast-2": [run(1)], "fast-4": [run(1)]}
        self.assertTrue(has_same_bytes({"runs": runs}, "fast"))
        runs["fast-4"] = [run(1, digest="another")]
        self.assertFalse(has_same_bytes({"runs": runs}, "fast"))

    def test_memory_is_copied_at_a_likely_speed(self):
        self.assertTrue(1e8 < memory_bandwidth(1 << 24) < 1e13)


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

    def test_a_run_without_end_is_ended(self):
        with self.assertRaises(RunFailed):
            timed(["/bin/sleep", 60], longest=0.1)


class MemoryByStage(unittest.TestCase):
    def test_a_stage_has_the_most_that_was_seen_in_its_time(self):
        seconds = {"load": 2, "order": 1, "short": 0.1, "read": 1, "remesh": 3.1, "total": 4.1}
        samples = [(0.5, 7), (1.5, 20), (2.5, 10), (3.5, 15), (9, 99)]
        self.assertEqual(by_stage(samples, seconds), {"read": 7, "load": 20, "order": 15, "short": None})


CACHEGRIND_OUTPUT = """\
desc: I1 cache:         65536 B, 64 B, 16-way associative
desc: D1 cache:         49152 B, 64 B, 12-way associative
desc: LL cache:         2097152 B, 64 B, 16-way associative
cmd: program mesh.ply
events: Ir I1mr ILmr Dr D1mr DLmr Dw D1mw DLmw Bc Bcm Bi Bim
fl=some.c
fn=main
128 2 1 1 2 0 0 0 0 0 0 0 0 0
summary: 9000 3 3 2000 80 10 500 20 30 700 40 10 2
"""


def counted(instructions, **more):
    return {"instructions": instructions, "firstMisses": 20000, "lastMisses": 1000, "mispredictions": 5000,
            "caches": {"first": 1024, "last": 4096}, "sameBytes": True, **more}


class Counters(unittest.TestCase):
    def test_the_sums_of_cachegrind_are_read(self):
        self.assertEqual(counters_in(CACHEGRIND_OUTPUT),
                         {"instructions": 9000, "firstMisses": 100, "lastMisses": 40, "mispredictions": 42,
                          "caches": {"first": 49152, "last": 2097152}})

    def test_runs_without_branches_have_no_mispredictions(self):
        text = CACHEGRIND_OUTPUT.replace(" Bc Bcm Bi Bim", "").replace(" 700 40 10 2", "")
        self.assertNotIn("mispredictions", counters_in(text))

    def test_the_cache_of_the_core_is_that_of_level_two(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertIsNone(second_level_cache(Path(folder)))
            for level, size in (("1", "48K"), ("2", "2048K")):
                cache = Path(folder) / f"index{level}"
                cache.mkdir()
                for name, value in (("level", level), ("size", size), ("ways_of_associativity", "16"),
                                    ("coherency_line_size", "64")):
                    (cache / name).write_text(value + "\n")
            self.assertEqual(second_level_cache(Path(folder)), (2097152, 16, 64))

    def test_without_valgrind_there_are_none_with_a_line(self):
        told = io.StringIO()
        with redirect_stdout(told), mock.patch("shutil.which", return_value=None):
            self.assertIsNone(count_all(Programs(Path(), Path()), all_methods(), mesh_with_all_methods(), "c"))
        self.assertIn("SKIPPED: what limits the runs (valgrind is missing)", told.getvalue())

    def test_a_method_that_fails_leaves_them_out_with_a_line(self):
        told = io.StringIO()
        with redirect_stdout(told), mock.patch("shutil.which", return_value="valgrind"), \
                mock.patch("measure.counters.timed", side_effect=RunFailed("exit code 1")):
            self.assertIsNone(count_all(Programs(Path(), Path()), all_methods(), mesh_with_all_methods(), "c"))
        self.assertIn("SKIPPED: what limits the runs (exit code 1)", told.getvalue())

    def test_impossible_ones_are_found(self):
        self.assertEqual(list(wrongs_of_counters({"methods": {"fast-1": counted(10 ** 6)}})), [])
        wrong = counted(10 ** 6, lastMisses=30000, mispredictions=0)
        self.assertEqual(len(list(wrongs_of_counters({"methods": {"fast-1": wrong}}))), 2)

    def test_growth_is_that_of_the_time_of_a_face(self):
        small, large = ({"faces": faces, "runs": {"fast-1": [run(seconds)]}} for faces, seconds in ((10, 1), (100, 15)))
        self.assertAlmostEqual(growth_of_seconds_a_face(small, large, "fast-1"), 1.5)


class Complaints(unittest.TestCase):
    def test_a_sound_record_has_none(self):
        self.assertEqual(complaints({"package": "almeshopt 1", "meshes": [mesh_with_all_methods()]}), [])

    def test_other_bytes_with_other_threads_are_found(self):
        mesh = mesh_with_all_methods()
        mesh["runs"]["fast-1"][0]["digest"] = "another"
        self.assertEqual(len(complaints({"meshes": [mesh]})), 1)

    def test_missing_and_impossible_runs_are_found(self):
        mesh = mesh_with_all_methods()
        mesh["runs"]["quadric"] = []
        mesh["runs"]["meshoptimizer"] = [run(1, wall=0.5, faces=1000)]
        self.assertEqual(len(complaints({"meshes": [mesh]})), 3)

    def test_a_missing_package_leaves_its_methods_out_with_a_line(self):
        told = io.StringIO()
        with redirect_stdout(told):
            self.assertEqual(package_version(""), "")
            self.assertEqual(package_version("/no/python"), "")
        self.assertEqual(told.getvalue().count("SKIPPED: meshoptimizer of PyPI"), 2)
        self.assertFalse([method for method in methods_of({"package": ""}) if method.remesher])
        self.assertEqual(len([method for method in methods_of({"package": "almeshopt 1"}) if method.remesher]), 2)
        mesh = mesh_with_all_methods()
        for method in all_methods():
            if method.remesher:
                del mesh["runs"][method.key]
        self.assertEqual(complaints({"meshes": [mesh]}), [])
        self.assertEqual(len(complaints({"package": "almeshopt 1", "meshes": [mesh]})), 2)

    def test_sizes_are_read(self):
        self.assertEqual([face_number(t) for t in ("900", "30k", "0.27M", "7.75M")],
                         [900, 30000, 270000, 7750000])


class Pages(unittest.TestCase):
    def test_a_table_has_names_to_the_left_and_figures_to_the_right(self):
        self.assertEqual(table(("a", "b"), [["x", "1"]]), "| a | b |\n| --- | ---: |\n| x | 1 |\n")

    def test_only_what_stands_between_the_marks_is_replaced(self):
        text = "before\n<begin>\nold\n<end>\nafter\n"
        self.assertEqual(between_marks(text, "new\n", "<begin>\n", "<end>\n"),
                         "before\n<begin>\nnew\n<end>\nafter\n")
        with self.assertRaises(RuntimeError):
            between_marks("no marks", "new", "<begin>\n", "<end>\n")

    def test_a_busy_machine_is_told(self):
        self.assertEqual(sentence_on_load({"load": 0.1}), "")
        self.assertIn("load 2.50", sentence_on_load({"load": 2.5}))

    def test_the_command_names_no_folder_of_this_machine(self):
        self.assertEqual(command_of(["--grow", "/some/where/scan.ply", "--rounds", "3"]),
                         "scripts/bench --grow scan.ply --rounds 3")


class SpeedPage(unittest.TestCase):
    facts = {"processor": "P", "cores": 2, "memory": "1 GB", "compiler": "c++", "build_type": "Release",
             "meshoptimizer": "0.18", "commit": "c", "date": "d", "load": 0}

    def page(self, **more):
        mesh = mesh_with_all_methods()
        for key in ("fast-2", "default-2"):
            mesh["runs"][key] = [run(0.6)]
        mesh["runs"]["meshoptimizer-pypi"] = [run(3)]
        data = {"meshes": [mesh], "circumstances": self.facts, "command": "scripts/bench", **more}
        return speed_page.speed_page(data, methods_of(data), "")

    def test_ratios_are_those_to_all_others(self):
        text = self.page(package="almeshopt 1")
        self.assertIn("× meshoptimizer of Debian | × meshoptimizer of PyPI | × meshoptimizer of PyPI, regularised | ×", text)
        self.assertIn("| gpremesh, fast, 2 threads | 1.67 | 5.00 | 1.67 | 1.7 |", text)
        self.assertIn("meshoptimizer 0.18, almeshopt 1;", text)

    def test_without_the_package_there_are_no_columns_of_it(self):
        text = self.page()
        self.assertIn("its rows are missing", text)
        self.assertNotIn("its rows are missing", self.page(package="almeshopt 1"))
        self.assertNotIn("× meshoptimizer of PyPI", text)
        self.assertIn("| gpremesh, fast, 2 threads | 1.67 | 1.7 |", text)

    def test_bounds_for_many_cores_and_the_limit_are_told(self):
        self.assertNotIn("## Limit", self.page())
        text = self.page(bandwidth=1e8)
        self.assertIn("| fast | 1.000 | 0.600 | 1.67 | 80 % | 3.3 | 4.7 | yes |", text)
        self.assertIn("| mesh, 1,000 faces | 1000 | 0.020 | 30 | 30 |", text)

    def test_what_limits_the_runs_is_told(self):
        self.assertNotIn("## What limits", self.page())
        self.assertNotIn("## What limits", self.page(counters=None))
        methods = {"default-1": counted(4 * 10 ** 6), "fast-1": counted(2 * 10 ** 6), "meshoptimizer": counted(10 ** 6)}
        text = self.page(counters={"mesh": "mesh", "commit": "later", "methods": methods})
        self.assertIn("| gpremesh, default, 1 thread | 4000 | 20.0 | – | 1.0 | 5.0 | 2.000 | 0.0 |", text)
        self.assertIn("Counted with commit later, timed with c;\nthe results are the same, byte for byte.", text)
        self.assertIn("misses of the first cache, 5 to 5 % miss the last cache too", text)
        self.assertNotIn("The second cache", text)
        self.assertIn("takes 2.0 times the instructions of `fast`, and 1.0 times its seconds", text)
        self.assertIn("with at most 8.0 times its instructions", text)
        self.assertNotIn("seconds a face, on one thread, grow", text)  # there is one size only

    def test_the_cache_of_the_core_and_other_results_are_told(self):
        methods = {"fast-1": counted(2 * 10 ** 6, secondMisses=12000, sameBytes=False)}
        text = self.page(counters={"mesh": "mesh", "commit": "later", "methods": methods})
        self.assertIn("| gpremesh, fast, 1 thread | 2000 | 20.0 | 12.0 | 1.0 | 5.0 |", text)
        self.assertIn("60 to 60 % miss the second cache", text)
        self.assertIn("the results are NOT the same", text)
        self.assertNotIn("of meshoptimizer. It runs", text)

    def test_all_methods_have_a_colour(self):
        for method in all_methods():
            self.assertIn(method.preset or method.key, speed_picture.COLOURS)


class Files(unittest.TestCase):
    def test_a_ply_file_is_read_as_it_was_written(self):
        try:
            import numpy as np
        except ImportError:
            self.skipTest("numpy is missing")
        vertices, faces = np.eye(4, 3), np.array([[0, 1, 2], [0, 3, 1]])
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "mesh.ply"
            binary_ply.write_arrays(file, vertices, faces)
            read_vertices, read_faces = binary_ply.arrays_of(file)
        self.assertTrue((read_vertices == vertices).all() and (read_faces == faces).all())


class QualityRows(unittest.TestCase):
    figures = {"vertices": 12, "faces": 20, "radiusRatio": 0.98765, "aspectRatio": 0.9, "smallestAngle": 31.26,
               "below30Percent": 0.0618}
    mesh = {"name": "bust", "threads": 4, "seconds": {"quadric": [3, 1, 2], "1": [0.5], "0": [0.25]},
            "figures": {"input": figures, "ours": figures, "quadric": figures}}

    def test_every_row_has_medians_and_spreads(self):
        rows = quality.rows_of(self.mesh)
        self.assertEqual([row[1] for row in rows], ["input", "Quadric Edge Collapse", "gpremesh, 1 thread",
                                                    "gpremesh, 4 threads"])
        self.assertEqual([row[4] for row in rows], ["–", "2.000 (1.000–3.000)", "0.500", "0.250"])
        self.assertEqual(rows[0][5:], ["0.9877", "0.9000", "31.3°", "0.0618 %"])

    def test_readme_has_the_two_that_are_compared(self):
        rows = quality.rows_of(self.mesh, for_readme=True)
        self.assertEqual([row[1] for row in rows], ["Quadric Edge Collapse", "gpremesh, 4 threads"])


class PaperRows(unittest.TestCase):
    quality = {"aspectRatio": {"mean": 0.9641}, "angles": {"min": 32.15, "below30Percent": 0}}

    def report(self, loops):
        counts = {"eulerCharacteristic": 2, "boundaryLoops": 0, "components": 1, "vertices": 9, "faces": 14}
        return {"input": {"faces": 100}, "result": {**counts, "boundaryLoops": loops},
                "cleanedInput": counts, "counts": {"targetVertices": 10}, "seconds": {"remesh": 1.5},
                "quality": self.quality}

    def test_the_paper_preset(self):
        row = paper.preset_row("bust", self.report(loops=0))
        self.assertEqual(row[2:5], ["100 / 14", "-10.0 %", "1.50"])
        self.assertEqual(row[-1], "kept")

    def test_another_topology_is_told(self):
        self.assertEqual(paper.preset_row("bust", self.report(loops=1))[-1], "changed")

    def test_a_method_of_the_comparison(self):
        method = {"name": "ours", "faces": 14, "vertices": 11, "seconds": {"median": 0.126},
                  "toInput": {"rms": 2.3171e-05}, "fromInput": {"rmsPercent": 0.01457},
                  "quality": self.quality, "topologyKept": True}
        self.assertEqual(paper.compared_row("bust", 100, 10, method),
                         ["bust", "ours", "100 / 14", "+10.0 %", "0.13", "2.317e-05", "0.0146 %", "0.964",
                          "32.1°", "0 %", "kept"])


    def test_p999_stands_beside_the_largest_distance(self):
        method = {"name": "ours", "toInput": {"p999Percent": 0.12345, "hausdorffPercent": 0.5},
                  "fromInput": {"p999Percent": 0.25, "hausdorffPercent": 1}}
        self.assertEqual(paper.distance_row("bust", method),
                         ["bust", "ours", "0.1235 %", "0.2500 %", "0.5000 %", "1.0000 %"])

    def test_a_record_of_an_earlier_version_makes_a_page(self):
        earlier = {"name": "bust", "table1": [["earlier"]], "counts": [], "density": []}
        later = {**earlier, "distances": [["later"]]}
        with mock.patch.object(paper, "_circumstances", return_value=""):
            self.assertNotIn("p99.9", paper.paper_page({"meshes": [earlier]}))
            both = paper.paper_page({"meshes": [earlier, later]})
        self.assertIn("| earlier |", both)
        self.assertIn("| later |", both)
        self.assertIn("p99.9", both)


def surface(vertices, angle, iterations):
    return {"vertices": vertices, "faces": 2 * vertices - 4, "closed": True, "smallestAngle": angle,
            "largestAngle": 110, "below30Percent": 0, "rmsPercent": 0.05, "largestDistancePercent": 0.4,
            "conditionNumber": 1234.5, "iterations": iterations, "iterationsJacobi": 90,
            "negativeWeightsPercent": 0.5}


def volume(tetrahedra):
    return {"tetrahedra": tetrahedra, "points": 30, "smallestDihedral": 2.345, "largestDihedral": 176,
            "below10Percent": 0.5, "seconds": 0.2}


class SimulationPage(unittest.TestCase):
    """A model on which everything is done, and one on which the other method fails in both ways."""
    data = {
        "methods": [["gpremesh", "ours"], ["other", "theirs"]], "tools": ["ftetwild"],
        "meshes": [
            {"name": "bust", "results": {"gpremesh": {"surface": surface(12, 30, 100), "ftetwild": volume(100)},
                                         "other": {"surface": surface(12, 30.01, 200), "ftetwild": volume(400)}}},
            {"name": "part", "results": {"gpremesh": {"surface": surface(12, 33, 100), "ftetwild": volume(100)},
                                         "other": {"surface": surface(12, 5, 800),
                                                   "ftetwild": {"failure": "crash, signal 6"}}}},
            {"name": "soup", "results": {"gpremesh": {"surface": surface(12, 33, 100), "ftetwild": volume(100)},
                                         "other": {"failure": "not done after 9 s"}}}]}

    def test_what_failed_says_why(self):
        rows = simulation_page.rows_of(self.data, "ftetwild", simulation_page.volume_figures("ftetwild"))
        self.assertEqual(rows[1][:4], ["bust", "theirs", "yes", "400"])
        self.assertEqual(rows[3], ["part", "theirs", "crash, signal 6"] + 6 * ["–"])
        self.assertEqual(rows[5][2], "no surface: not done after 9 s")

    def test_ratios_are_of_the_models_that_both_have_done(self):
        tetrahedra, iterations = simulation_page.volume_figures("ftetwild")[0], simulation_page.POISSON[1]
        self.assertEqual(simulation_page.ratio(self.data, "other", tetrahedra), "4.00")
        self.assertEqual(simulation_page.ratio(self.data, "other", iterations), "4.00")  # of 2 and 8
        self.assertEqual(simulation_page.ratio(self.data, "gpremesh", iterations), "1.00")
        self.assertEqual(simulation_page.done_count(self.data, "other", "ftetwild"), "1 of 3")

    def test_what_is_written_alike_is_equally_good(self):
        methods, angle, iterations = self.data["methods"], simulation_page.SURFACE[2], simulation_page.POISSON[1]
        bust, part, _ = self.data["meshes"]
        self.assertEqual(simulation_page.best_methods(bust, methods, angle), ["gpremesh", "other"])
        self.assertEqual(simulation_page.best_methods(part, methods, angle), ["gpremesh"])
        self.assertEqual(simulation_page.best_methods(bust, methods, iterations), ["gpremesh"])
        self.assertIn("| surface: smallest angle | 3 | 1 |", simulation_page.best_table(self.data))

    def test_it_tells_where_others_are_better(self):
        self.assertTrue(simulation_page.others_better(self.data).endswith(":\n\n- none\n"))
        better = copy.deepcopy(self.data)
        for mesh in better["meshes"][:2]:
            mesh["results"]["other"]["surface"]["rmsPercent"] = 0.01
        self.assertTrue(simulation_page.others_better(better).endswith(
            ":\n\n- surface: E_RMS, % of the diagonal: theirs on 2; gpremesh on 1 of 3 models\n"))

    def test_iterations_without_end_are_told(self):
        endless = {"surface": surface(12, 30, None)}
        self.assertEqual(simulation_page.ITERATIONS.text(endless), "no end")
        self.assertEqual(simulation_page.ITERATIONS.text({"failure": "crash"}), "–")

    def test_only_models_that_all_methods_have_done_are_drawn(self):
        self.assertEqual([mesh["name"] for mesh in simulation_page.done_by_all(self.data, "ftetwild")], ["bust"])


if __name__ == "__main__":
    unittest.main()
