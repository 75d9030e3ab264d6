# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A thousand calls with bad arguments: an exception or a result each time, never a crash."""

import random

import numpy as np

import gpremesh
from gpremesh import _core
from meshes import torus

CALLS = 1000
VERTICES, FACES = torus(16, 8)
ODD = [
    None, True, -1, 0, 1, 3, 10**12, -10**30, 0.5, float("nan"), float("inf"), 1e308, "", "on", "12%", "nan%", b"x",
    [], [[]], [1, 2], {}, object(), lambda *_: None, np.float32(3), np.int64(7), np.array(5), np.zeros(0),
    np.zeros((0, 3)), np.zeros((3, 0)), np.zeros((2, 3)), np.full((128, 3), np.nan), np.full((128, 3), 1e308),
    np.full((128, 3), 1e-320), np.zeros((128, 3)), np.ones(128, bool), np.ones(256, bool), np.zeros(256, bool),
    np.arange(128), np.zeros((256, 3, 2)), np.zeros((128, 2)), np.full((256, 3), 200), np.zeros((256, 3), int),
    np.array([[0, 1, 2**62]]), np.array([[0, 1, 2]], np.uint64), np.array([["a", "b", "c"]]),
    np.array([[0, 1], [5, 5]]), np.array(VERTICES, object), VERTICES.astype(complex), VERTICES[::-1],
    VERTICES.astype(np.float16), FACES[:, ::-1], FACES.astype(np.int8), FACES[:5], VERTICES * 1e200, VERTICES * 1e-200,
]
ARRAYS = ["vertices", "faces", "selected", "region", "feature_edges", "uv", "image", "progress"]


def random_value(rng, name):
    by_name = {entry["name"]: entry for entry in _core.parameters("remesh")}
    entry = by_name.get(name)
    if entry is not None and rng.random() < 0.5:
        if entry["choices"]:
            return rng.choice(entry["choices"])
        least, most = entry["minimum"], min(entry["maximum"], 1000)
        value = rng.uniform(least, most)
        return value if entry["kind"] in ("number", "length") else int(value)
    return rng.choice(ODD)


def random_call(rng, names):
    arguments = {"vertices": VERTICES, "faces": FACES, "time_limit": 0.02, "threads": 1}
    for name in rng.sample(names, rng.randint(1, 4)):
        arguments[name] = random_value(rng, name)
    if not isinstance(arguments["threads"], int) or not 0 <= arguments["threads"] <= 4:
        arguments["threads"] = 1
    return arguments


def test_a_thousand_bad_calls():
    rng = random.Random(25)
    names = ARRAYS + [entry["name"] for entry in _core.parameters("remesh")]
    refused = 0
    for _ in range(CALLS):
        arguments = random_call(rng, names)
        try:
            with np.errstate(all="ignore"):
                result = gpremesh.remesh(**arguments)
            assert np.isfinite(result.vertices).all() and result.faces.max() < len(result.vertices)
        except (ValueError, TypeError, gpremesh.Error) as error:
            assert str(error)
            refused += 1
    assert CALLS // 3 < refused < CALLS  # neither all nor none


def test_bad_calls_of_the_compiled_part():
    """Only the package calls it, but it must not read beyond an array all the same."""
    rng = random.Random(7)
    refused = 0
    for _ in range(300):
        extras = _core.Extras()
        name = rng.choice(["selected", "region", "feature_edges", "uv", "images"])
        try:
            setattr(extras, name, rng.choice(ODD))
            _core.remesh(*(rng.choice([VERTICES, FACES] + ODD) for _ in range(2)), extras, {}, None)
        except (ValueError, TypeError):
            refused += 1
    assert refused > 200
