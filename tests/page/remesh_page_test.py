#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page that remeshes what one drops on it, in Chromium: made by scripts/release/make_page.

    remesh_page_test.py GPREMESH FOLDER      FOLDER has page/index.html
    GPR_PAGE_MOVES=50 ...                     how often the slider is moved; 20 if it is not set, 11 at least
    GPR_PAGE_PICTURES=OTHER ...               pictures of the windows go to the folder OTHER
"""

import base64
import functools
import http.server
import os
import random
import re
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path

from browser import Browser, missing
from viewer_test import PICTURES, WINDOWS, torus_obj

DROP = """
const [name, text] = arguments, bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
const given = new DataTransfer();
given.items.add(new File([bytes], name));
document.dispatchEvent(new DragEvent("drop", { dataTransfer: given, cancelable: true }));"""

SET = """
const widget = document.querySelector(arguments[0]);
if (widget.type === "checkbox") widget.checked = arguments[1]; else widget.value = arguments[1];
widget.dispatchEvent(new Event(arguments[2] || "change", { bubbles: true }));"""

AT_REST = """
const words = document.getElementById("words").textContent;
return !document.getElementById("download").disabled && words.includes("faces after") && !words.startsWith("Draft");"""

# What the button saves goes into the page instead of the disk.
CATCH = """
window.saved = null;
HTMLAnchorElement.prototype.click = async function () {
    const bytes = new Uint8Array(await (await fetch(this.href)).arrayBuffer());
    window.saved = [this.download, btoa(Array.from(bytes, (b) => String.fromCharCode(b)).join(""))];
};"""


# With these headers, browsers let threads share memory.
ISOLATED = {"Cross-Origin-Opener-Policy": "same-origin", "Cross-Origin-Embedder-Policy": "require-corp"}


class Server(http.server.ThreadingHTTPServer):
    def __init__(self, folder, headers=None):
        class Quiet(http.server.SimpleHTTPRequestHandler):
            def log_message(self, *_):
                pass

            def end_headers(self):
                for name, value in (headers or {}).items():
                    self.send_header(name, value)
                super().end_headers()
        super().__init__(("127.0.0.1", 0), functools.partial(Quiet, directory=folder))
        threading.Thread(target=self.serve_forever, daemon=True).start()


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.server = Server(FOLDER)
        cls.addClassCleanup(cls.server.shutdown)
        cls.browser = Browser(cls.folder.name + "/profile")
        cls.addClassCleanup(cls.browser.close)
        cls.mesh = cls.folder.name + "/torus.obj"
        torus_obj(cls.mesh, 80, 40)

    def setUp(self):
        self.browser.open(f"http://127.0.0.1:{self.server.server_port}/page/index.html", *WINDOWS[0])
        self.wait("example")

    def tearDown(self):
        self.assertEqual(self.browser.messages(), [])
        self.assertTrue(self.browser.run("return document.querySelector('#viewer .complaint').hidden"))

    def words(self):
        return self.browser.run("return document.getElementById('words').textContent")

    def wait(self, text, seconds=120):
        end = time.monotonic() + seconds
        while text not in self.words():
            self.assertLess(time.monotonic(), end, f"{text!r} is not told, but {self.words()!r}")
            time.sleep(0.05)

    def drop(self, path):
        self.browser.run(DROP, Path(path).name, base64.b64encode(Path(path).read_bytes()).decode())

    def set(self, selector, value, event="change"):
        self.browser.run(SET, selector, value, event)

    def result(self):
        """Waits for the default of the last change and for its figures."""
        end = time.monotonic() + 120
        while not self.browser.run(AT_REST):
            self.assertLess(time.monotonic(), end, f"no result is shown, but {self.words()!r}")
            time.sleep(0.05)

    def saved(self):
        self.browser.run(CATCH)
        self.browser.run("document.getElementById('download').click()")
        end = time.monotonic() + 30
        while self.browser.run("return window.saved") is None:
            self.assertLess(time.monotonic(), end)
            time.sleep(0.05)
        name, text = self.browser.run("return window.saved")
        return name, base64.b64decode(text)

    def command(self):
        return self.browser.run("return document.getElementById('command').textContent").split()

    def test_a_dropped_mesh_gives_the_bytes_of_the_program(self):
        self.drop(self.mesh)
        self.result()
        for form in ("obj", "ply"):
            self.set("#format", form)
            words = self.command()
            self.assertEqual(words[:4], ["gpremesh", "remesh", "torus.obj", "torus_remeshed." + form])
            name, bytes_ = self.saved()
            self.assertEqual(name, words[3])
            subprocess.run([GPREMESH, *words[1:], "--quiet"], check=True, cwd=self.folder.name)
            self.assertEqual(bytes_, (Path(self.folder.name) / name).read_bytes())

    def test_figures_views_and_the_proof(self):
        self.drop(self.mesh)
        self.result()
        rows = self.browser.run("return [...document.querySelectorAll('#figures tbody tr')].map((r) => [...r.cells].map((c) => c.textContent))")
        self.assertEqual([row[0] for row in rows], ["torus.obj", "gpremesh", "Quadric Edge Collapse"])
        self.assertGreater(float(rows[1][3]), float(rows[2][3]))
        self.assertEqual(rows[1][1], rows[2][1])
        for row in rows[1:]:
            self.assertRegex(row[6], r"^0\.\d+ %$")
        for picture in self.browser.run(PICTURES):
            self.assertGreater(picture["drawn"], 0.1)
        spots = self.browser.run("return document.querySelectorAll('#viewer .spots button').length")
        self.assertEqual(spots, 5)
        before = [picture["sum"] for picture in self.browser.run(PICTURES)]
        self.browser.run("document.querySelectorAll('#viewer .spots button')[2].click()")
        self.assertNotEqual([picture["sum"] for picture in self.browser.run(PICTURES)], before)
        self.browser.run("document.querySelector('#figures tbody button').click()")
        self.wait("No point")
        self.assertIn("≤", self.browser.run("return document.querySelector('#figures tbody').textContent"))
        self.set("#viewer [name=wipe]", True)
        self.assertTrue(self.browser.run("return document.querySelector('#viewer .panels').classList.contains('wiped')"))

    def move(self, chance):
        self.set("#slider", chance.randint(300, 900), "input")
        if chance.random() < 0.3:
            self.set("[data-option='--adapt']", str(round(chance.random(), 2)))
        time.sleep(chance.random())

    def memory(self):
        """Megabytes: of the engines, by what the page tells once they rest, and of the page's own objects."""
        self.result()
        time.sleep(0.5)
        told = self.browser.run("return document.getElementById('engine').textContent")
        return int(re.search(r"(\d+) MB", told).group(1)), self.browser.heap() / 1e6

    def test_random_moves_take_no_more_memory(self):
        chance = random.Random(1)
        self.browser.run("document.querySelectorAll('#examples button')[1].click()")
        self.wait("faces")
        for _ in range(10):
            self.move(chance)
        before = self.memory()
        for _ in range(MOVES - 10):
            self.move(chance)
        after = self.memory()
        print(f"memory after 10 moves and after {MOVES}: engines {before[0]} and {after[0]} MB, page {before[1]:.1f} and {after[1]:.1f} MB")
        self.assertLessEqual(after[0], 1.25 * before[0] + 16)  # the largest result so far counts
        self.assertLessEqual(after[1], 1.25 * before[1] + 4)
        name, bytes_ = self.saved()
        words = self.command()
        self.browser.run("window.saved = null; document.getElementById('downloadInput').click()")
        time.sleep(0.5)
        (Path(self.folder.name) / words[2]).write_bytes(base64.b64decode(self.browser.run("return window.saved")[1]))
        subprocess.run([GPREMESH, *words[1:], "--quiet"], check=True, cwd=self.folder.name)
        self.assertEqual(bytes_, (Path(self.folder.name) / name).read_bytes())

    def test_threads_where_the_server_allows_them(self):
        """The same bytes, and the page says how many."""
        isolated = Server(FOLDER, ISOLATED)
        self.addCleanup(isolated.shutdown)
        self.assertIn("One thread works", self.browser.run("return document.getElementById('engine').textContent"))
        self.browser.open(f"http://127.0.0.1:{isolated.server_port}/page/index.html", *WINDOWS[0])
        self.wait("example")
        cores = self.browser.run("return Math.min(navigator.hardwareConcurrency, 16)")
        told = "One thread works" if cores == 1 else f"{cores} threads work"
        self.assertIn(told, self.browser.run("return document.getElementById('engine').textContent"))
        self.drop(self.mesh)
        self.result()
        self.set("#number input", "900")
        self.result()
        words, (name, bytes_) = self.command(), self.saved()
        subprocess.run([GPREMESH, *words[1:], "--quiet"], check=True, cwd=self.folder.name)
        self.assertEqual(bytes_, (Path(self.folder.name) / name).read_bytes())

    def test_faults_are_told_in_a_sentence(self):
        for name, text, told in (("a.txt", "", "no other format"), ("a.ply", "ply\nnonsense", "header"),
                                 ("empty.obj", "# nothing\n", "no face")):
            path = Path(self.folder.name) / name
            path.write_text(text)
            self.drop(path)
            self.wait(told)
        self.drop(self.mesh)
        self.result()
        self.set("#size", "--vertices")
        self.set("#number input", "3")
        self.wait("smallest possible number")
        self.set("#number input", "many")
        self.wait("whole number")
        self.set("#number input", "1000")
        self.result()

    def test_a_run_can_be_cancelled(self):
        # It is clicked as soon as it is shown: a run may be over before a question from here arrives.
        self.browser.run("""
            const button = document.getElementById('cancel');
            const observer = new MutationObserver(() => {
                if (button.hidden) return;
                observer.disconnect();
                button.click();
            });
            observer.observe(button, { attributes: true, attributeFilter: ['hidden'] });
            document.querySelectorAll('#examples button')[0].click();
        """)
        self.wait("Cancelled.")
        self.assertEqual(self.words(), "Cancelled.")
        self.set("#slider", 500, "input")
        self.result()

    def test_the_package_in_a_browser(self):
        self.browser.run("""
            const vertices = new Float32Array(300), faces = [];
            for (let i = 0; i < 100; ++i) vertices.set([i % 10, Math.floor(i / 10), Math.sin(i % 10)], 3 * i);
            for (let i = 0; i < 89; ++i) if (i % 10 < 9) faces.push(i, i + 1, i + 11, i, i + 11, i + 10);
            window.made = null;
            import("/package/index.js").then(({ remesh }) => remesh({ vertices, faces: new Int32Array(faces) }, { vertices: 60 }))
                .then(({ vertices: made }) => { window.made = made.length; }, (error) => { window.made = error.message; });""")
        end = time.monotonic() + 30
        while self.browser.run("return window.made") is None:
            self.assertLess(time.monotonic(), end)
        self.assertEqual(self.browser.run("return window.made"), 180)

    def test_windows_of_three_sizes(self):
        for width, height in WINDOWS:
            self.browser.open(f"http://127.0.0.1:{self.server.server_port}/page/index.html", width, height)
            self.wait("example")
            self.browser.run("document.querySelectorAll('#examples button')[1].click()")
            self.result()
            found = self.browser.run("return [innerWidth, document.documentElement.scrollWidth]")
            self.assertLessEqual(found[1], found[0])
            if PICTURES_TO:
                self.browser.screenshot(f"{PICTURES_TO}/page_{width}.png")


def reason_to_skip():
    if missing():
        return " and ".join(missing()) + " not installed; the page is not looked at"
    if not Path(FOLDER, "page", "index.html").exists():
        return "the page was not made (scripts/release/make_page, which needs emscripten)"
    return ""


if __name__ == "__main__":
    GPREMESH, FOLDER = map(os.path.abspath, sys.argv[1:3])
    MOVES = max(11, int(os.environ.get("GPR_PAGE_MOVES", 20)))
    PICTURES_TO = os.environ.get("GPR_PAGE_PICTURES", "")
    del sys.argv[1:3]
    if reason_to_skip():
        print("SKIPPED:", reason_to_skip())
        sys.exit(77)
    unittest.main()
