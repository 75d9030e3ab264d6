# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs gpremesh_bench: each stage by itself."""

import json
import os
import subprocess

LEAST_SECONDS = "0.2"  # of each benchmark, in which it is repeated


def measure_stages(programs, mesh_name, mesh_file=None, least_seconds=LEAST_SECONDS):
    """Rows in the order of a run: stage, and milliseconds by density and threads. A mesh without a
    file is one of those that gpremesh_bench makes itself."""
    environment = dict(os.environ, GPR_BENCH_MESHES=str(mesh_file or ""))
    command = [programs.path("gpremesh_bench"), f"--benchmark_filter=/{mesh_name}/",
               f"--benchmark_min_time={least_seconds}", "--benchmark_format=json"]
    output = subprocess.run(command, env=environment, check=True, stdout=subprocess.PIPE,
                            stderr=subprocess.DEVNULL).stdout
    rows = {}
    for benchmark in json.loads(output)["benchmarks"]:
        if benchmark.get("error_occurred"):
            raise RuntimeError(f"{benchmark['name']}: {benchmark['error_message']}")
        stage, _, density, threads = benchmark["name"].split("/")[:4]
        column = f"{density}-{threads.removeprefix('threads:')}"
        rows.setdefault(stage, {})[column] = benchmark["real_time"]
    return rows
