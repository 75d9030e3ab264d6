#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The views of the page that `gpremesh compare --html` writes, in Chromium.

    viewer_test.py GPREMESH
"""

import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from browser import Browser, missing

WINDOWS = [(1600, 1000), (1024, 768), (480, 900)]

# Of each canvas: how many pixels are not white, how many colours there are, and a sum that tells two pictures apart.
PICTURES = """
return [...document.querySelectorAll("#viewer canvas")].map((canvas) => {
    const copy = document.createElement("canvas");
    copy.width = canvas.width;
    copy.height = canvas.height;
    const context = copy.getContext("2d");
    context.drawImage(canvas, 0, 0);
    const pixels = new Uint32Array(context.getImageData(0, 0, copy.width, copy.height).data.buffer);
    let sum = 0, drawn = 0;
    for (const pixel of pixels) {
        sum = (sum * 31 + pixel) % 4294967291;
        drawn += pixel !== 0xffffffff;
    }
    return { drawn: drawn / pixels.length, colours: new Set(pixels).size, sum };
});"""

CHOOSE = """
const chooser = document.querySelectorAll("#viewer .panel select")[arguments[0]];
chooser.value = arguments[1];
chooser.dispatchEvent(new Event("change"));"""

SET_TOOL = """
const tool = document.querySelector("#viewer .tools").elements[arguments[0]];
if (tool.type === "checkbox") tool.checked = arguments[1]; else tool.value = arguments[1];
tool.dispatchEvent(new Event("change"));"""

MEASURES = """
const boxes = [...document.querySelectorAll("#viewer canvas")].map((canvas) => canvas.getBoundingClientRect());
return { width: innerWidth, page: document.documentElement.scrollWidth, boxes: boxes.map((b) => [b.left, b.top, b.right, b.bottom]) };"""


def torus_obj(path, m, n):
    """A torus as OBJ, m by n quads."""
    lines = []
    for i in range(m):
        for j in range(n):
            a, b = 2 * math.pi * i / m, 2 * math.pi * j / n
            r = 3 + math.cos(b)
            lines.append(f"v {r * math.cos(a):.7f} {r * math.sin(a):.7f} {math.sin(b):.7f}")
    for i in range(m):
        for j in range(n):
            k, l = (i + 1) % m, (j + 1) % n
            lines.append("f " + " ".join(str(1 + p * n + q) for p, q in ((i, j), (k, j), (k, l), (i, l))))
    Path(path).write_text("\n".join(lines) + "\n")


class Viewer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.small = cls.page("small", 80, 40, "--percent", "20")
        cls.browser = Browser(cls.folder.name + "/profile")
        cls.addClassCleanup(cls.browser.close)

    @classmethod
    def page(cls, name, m, n, *options):
        mesh = f"{cls.folder.name}/{name}.obj"
        torus_obj(mesh, m, n)
        words = [GPREMESH, "compare", mesh, *options, "--html", f"{cls.folder.name}/{name}"]
        # Without f3d there are no still pictures, which take time.
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL, env={"PATH": "/nothing"})
        return f"file://{cls.folder.name}/{name}/index.html"

    def setUp(self):
        self.browser.open(self.small, *WINDOWS[0])
        self.pictures()

    def tearDown(self):
        self.assertEqual(self.browser.messages(), [])
        self.assertTrue(self.browser.run("return document.querySelector('#viewer .complaint').hidden"))

    def pictures(self):
        self.browser.run("return 0")
        pictures = self.browser.run(PICTURES)
        self.assertEqual(len(pictures), 3)
        return pictures

    def sums(self):
        return [picture["sum"] for picture in self.pictures()]

    def test_three_views_in_windows_of_three_sizes(self):
        for width, height in WINDOWS:
            self.browser.open(self.small, width, height)
            for picture in self.pictures():
                self.assertGreater(picture["drawn"], 0.1)
                self.assertLess(picture["drawn"], 0.9)
                self.assertGreater(picture["colours"], 50)
            self.assertEqual(len(set(self.sums())), 3)
            found = self.browser.run(MEASURES)
            self.assertLessEqual(found["page"], found["width"])
            side_by_side = len({top for _, top, _, _ in found["boxes"]}) == 1
            self.assertEqual(side_by_side, width > 1000)
            for left, top, right, bottom in found["boxes"]:
                self.assertGreater(right - left, 250)
                self.assertAlmostEqual(right - left, bottom - top, delta=1)

    def test_views_move_together(self):
        # Two views of the same mesh, so that they are the same picture wherever the camera is.
        self.browser.run(CHOOSE, 1, "input")
        before = self.sums()
        self.assertEqual(before[0], before[1])
        ways = [
            lambda: self.browser.pointer("#viewer .panel:nth-child(3) canvas", (-60, 10), (50, -40)),
            lambda: self.browser.pointer("#viewer .panel:nth-child(2) canvas", (0, 0), (40, 30), button=2),
            lambda: self.browser.scroll("#viewer .panel:nth-child(1) canvas", -300),
            lambda: self.browser.run("""document.querySelectorAll("#viewer canvas")[1].dispatchEvent(
                new KeyboardEvent("keydown", { key: "ArrowLeft" }))"""),
        ]
        for way in ways:
            way()
            after = self.sums()
            self.assertEqual(after[0], after[1])
            for old, new in zip(before, after):
                self.assertNotEqual(old, new)
            before = after

    def test_whole_model_comes_back(self):
        before = self.sums()
        self.browser.pointer("#viewer .panel:nth-child(1) canvas", (0, 0), (80, 50))
        self.assertNotEqual(self.sums(), before)
        self.browser.run("document.querySelector('#viewer [name=reset]').click()")
        self.assertEqual(self.sums(), before)

    def test_colours_edges_and_histograms(self):
        seen = [self.sums()]
        for name, value in (("edges", False), ("colour", "distance"), ("colour", "none")):
            self.browser.run(SET_TOOL, name, value)
            seen.append(self.sums())
        for before, after in zip(seen, seen[1:]):
            for old, new in zip(before, after):
                self.assertNotEqual(old, new)
        heights = """return [...document.querySelectorAll("#viewer .histogram")].map((histogram) =>
            [...histogram.querySelectorAll("rect")].map((bar) => bar.height.baseVal.value))"""
        self.assertTrue(self.browser.run("return [...document.querySelectorAll('#viewer .histogram')].every((h) => h.hidden)"))
        self.browser.run(SET_TOOL, "colour", "quality")
        for bars in self.browser.run(heights):
            self.assertEqual(len(bars), 40)
            self.assertEqual(max(bars), 60)
        ours, quadric = self.browser.run(heights)[1:]
        middle = [sum(i * bar for i, bar in enumerate(bars)) / sum(bars) for bars in (ours, quadric)]
        self.assertLess(middle[0], middle[1])  # nearer to equilateral
        self.browser.run(SET_TOOL, "colour", "distance")
        self.assertEqual(self.browser.run(heights)[0], [60] + 39 * [0])

    def test_the_worst_triangle_and_the_largest_distance_are_shown(self):
        buttons = self.browser.run("return [...document.querySelectorAll('#viewer .spots button')].map((b) => b.textContent)")
        self.assertEqual([text.split(":")[0] for text in buttons],
                         ["worst triangle", *2 * ["worst triangle", "largest distance"]])
        whole = self.sums()
        for i in range(len(buttons)):
            self.browser.run("document.querySelectorAll('#viewer .spots button')[arguments[0]].click()", i)
            for old, picture in zip(whole, self.pictures()):
                self.assertNotEqual(old, picture["sum"])
                self.assertGreater(picture["drawn"], 0.1)
            for left, top in self.browser.run("""return [...document.querySelectorAll("#viewer .mark")].map((mark) =>
                    [parseFloat(mark.style.left), parseFloat(mark.style.top)])"""):
                self.assertAlmostEqual(left, 50, delta=0.5)
                self.assertAlmostEqual(top, 50, delta=0.5)

    def test_any_method_can_be_looked_at(self):
        before = self.sums()
        self.browser.run(CHOOSE, 2, "paper")
        after = self.sums()
        self.assertEqual(before[:2], after[:2])
        self.assertNotEqual(before[2], after[2])

    def test_large_meshes_are_drawn_with_fewer_triangles(self):
        note = "return document.querySelector('#viewer .decimated').hidden"
        self.assertTrue(self.browser.run(note))
        large = self.page("large", 600, 300, "--vertices", "500", "--preset", "fast")
        self.browser.open(large, *WINDOWS[0])
        self.assertFalse(self.browser.run(note))
        counts = self.browser.run("return [...document.querySelectorAll('#viewer .count')].map((count) => count.textContent)")
        self.assertRegex(counts[0], r"^360,000 triangles, drawn with [12]\d\d,\d\d\d$")
        self.assertRegex(counts[1], r"^1,000 triangles$")
        for picture in self.pictures():
            self.assertGreater(picture["drawn"], 0.1)

    def test_without_webgl_the_page_says_so(self):
        page = Path(self.small[len("file://"):]).read_text()
        lame = page.replace("<section id=\"viewer\">", "<script>HTMLCanvasElement.prototype.getContext = () => null</script><section id=\"viewer\">")
        path = f"{self.folder.name}/lame.html"
        Path(path).write_text(lame)
        self.browser.open("file://" + path, *WINDOWS[0])
        self.assertIn("cannot be drawn", self.browser.run("return document.querySelector('#viewer .complaint').innerText"))
        self.browser.messages()  # three.js complains itself
        self.browser.open(self.small, *WINDOWS[0])


def skip(reason):
    print("SKIPPED:", reason)
    sys.exit(77)


def reason_to_skip():
    if missing():
        return " and ".join(missing()) + " not installed; the page is not looked at"
    with tempfile.TemporaryDirectory() as folder:
        torus_obj(f"{folder}/torus.obj", 20, 10)
        told = subprocess.run([GPREMESH, "compare", f"{folder}/torus.obj", "--vertices", "100", "--html", folder],
                              check=True, capture_output=True, text=True, env={"PATH": "/nothing"}).stdout
    if "without three.js" in told:
        return "gpremesh was built without three.js"
    if "without vcglib" in told:
        return "gpremesh was built without vcglib"
    return ""


if __name__ == "__main__":
    GPREMESH = sys.argv.pop(1)
    if reason_to_skip():
        skip(reason_to_skip())
    unittest.main()
