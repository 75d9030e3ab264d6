# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Progress, cancelling, Ctrl+C and threads."""

import os
import subprocess
import sys
import textwrap
import threading

import numpy as np
import pytest

import gpremesh
from meshes import torus

FOLDER = os.path.dirname(os.path.abspath(__file__))


def test_progress_goes_from_0_to_1():
    told = []  # some ten times: this run takes .7 s on a quiet machine, and is told of every 40 ms
    gpremesh.remesh(*torus(800, 400), vertex_count=32000, threads=1, progress=lambda share, stage: told.append((share, stage)))
    shares = [share for share, _ in told]
    assert len(told) > 3 and shares == sorted(shares)
    assert 0 <= shares[0] and shares[-1] <= 1
    assert all(stage and isinstance(stage, str) for _, stage in told)


@pytest.mark.parametrize("tool", [gpremesh.remesh, gpremesh.sample, gpremesh.features])
@pytest.mark.parametrize("no", [False, np.False_, np.array(False)], ids=["bool", "numpy", "array"])
def test_false_cancels(tool, no):
    vertices, faces = torus(200, 100)
    with pytest.raises(gpremesh.Error) as cancelled:
        tool(vertices, faces, progress=lambda share, stage: no)
    assert cancelled.value.status == "cancelled"
    with pytest.raises(gpremesh.Error, match="Cancelled"):
        gpremesh.distance((vertices, faces), (vertices, faces), progress=lambda share, stage: False)


def test_only_false_cancels():
    for answer in (None, 0, "", True, np.True_, np.array(0)):
        gpremesh.remesh(*torus(), vertex_count=100, progress=lambda share, stage: answer)


def test_what_progress_raises_comes_out():
    def stop(share, stage):
        raise ZeroDivisionError("mine")

    with pytest.raises(ZeroDivisionError, match="mine"):
        gpremesh.remesh(*torus(), vertex_count=100, progress=stop)
    with pytest.raises(TypeError):
        gpremesh.remesh(*torus(), vertex_count=100, progress=lambda: True)


def test_time_limit():
    with pytest.raises(gpremesh.Error) as late:
        gpremesh.remesh(*torus(400, 200), vertex_count=20000, time_limit=0.001)
    assert late.value.status == "out of time"


INTERRUPTED = """
    import os, signal, sys, threading, time
    sys.path.insert(0, sys.argv[1])
    import gpremesh, meshes
    vertices, faces = meshes.torus(1400, 700)
    before = len(os.listdir("/proc/self/task"))
    began = None
    def interrupt():
        global began
        began = time.perf_counter()
        os.kill(os.getpid(), signal.SIGINT)
    timer = threading.Timer(0.3, interrupt)
    timer.start()
    try:
        gpremesh.remesh(vertices, faces, percent=50, threads=2)
        print("done")
    except KeyboardInterrupt:
        print(time.perf_counter() - began)
    timer.join()
    for _ in range(100):  # the timer's own thread may take a moment to go
        if len(os.listdir("/proc/self/task")) == before:
            break
        time.sleep(0.01)
    assert len(os.listdir("/proc/self/task")) == before
    assert len(gpremesh.remesh(*meshes.torus(), vertex_count=100).vertices) == 100
"""


def seconds_to_interrupt():
    words = [sys.executable, "-c", textwrap.dedent(INTERRUPTED), FOLDER]
    done = subprocess.run(words, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    return float(done.stdout)


def test_ctrl_c_cancels_within_200_ms():
    # The machine may be busy with other tests; an engine that did not listen would take seconds each time.
    assert min(seconds_to_interrupt() for _ in range(3)) < 0.2


def test_other_python_threads_go_on():
    vertices, faces = torus(400, 200)
    running, ticks = threading.Event(), []
    running.set()

    def tick():
        pause = threading.Event()
        while running.is_set():
            ticks.append(1)
            pause.wait(0.001)

    thread = threading.Thread(target=tick)
    thread.start()
    before = len(ticks)
    result = gpremesh.remesh(vertices, faces, vertex_count=2000, threads=1)
    passed = len(ticks) - before
    running.clear()
    thread.join()
    assert passed > 20 * result.report["seconds"]["remesh"]


def test_two_threads_get_the_same_bytes():
    vertices, faces = torus(150, 80)
    expected = gpremesh.remesh(vertices, faces, vertex_count=900)
    results = [None] * 4

    def run(number):
        results[number] = gpremesh.remesh(vertices, faces, vertex_count=900, threads=1 + number % 2)

    threads = [threading.Thread(target=run, args=(number,)) for number in range(len(results))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for result in results:
        assert result.vertices.tobytes() == expected.vertices.tobytes()
        assert np.array_equal(result.faces, expected.faces)
