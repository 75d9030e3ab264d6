# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs in tiles by Dask and by Slurm's scripts: the same bytes as those of one machine."""

import os
import stat
import subprocess

import numpy as np
import pytest
from meshes import command_line, torus, write_ply

from gpremesh import cluster

OPTIONS = ["--vertices", "900", "--tiles", "4"]


@pytest.fixture
def mesh(tmp_path):
    vertices, faces = torus(150, 80, np.float32)
    path = tmp_path / "torus.ply"
    write_ply(path, vertices, faces)
    return path


def by_steps(mesh, folder, out):
    """One step after the other, by the program alone."""
    command_line("tile", "plan", folder, mesh, *OPTIONS)
    command_line("tile", "split", folder)
    for unit in range(4):
        command_line("tile", "part", folder, "--unit", unit)
    command_line("tile", "join", folder)
    command_line("tile", "finish", folder, out, "--quiet")
    return out.read_bytes()


def test_dask_gives_the_same_bytes(mesh, tmp_path):
    pytest.importorskip("distributed", reason="Dask's package distributed is not installed")
    expected = by_steps(mesh, tmp_path / "steps", tmp_path / "steps.ply")
    out = tmp_path / "dask.ply"
    cluster.main(["run", str(mesh), str(out), "--folder", str(tmp_path / "dask"), "--local", "2", *OPTIONS])
    assert out.read_bytes() == expected


def test_a_lost_worker_changes_nothing(mesh, tmp_path):
    distributed = pytest.importorskip("distributed", reason="Dask's package distributed is not installed")
    expected = by_steps(mesh, tmp_path / "steps", tmp_path / "steps.ply")
    options, more = cluster._arguments(["run", str(mesh), str(tmp_path / "out.ply"), "--folder",
                                        str(tmp_path / "run"), *OPTIONS])
    steps = cluster.TileSteps(options, more)
    tile_num = cluster.tile_step(steps.plan())["tiles"]
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as workers, \
            distributed.Client(workers) as client:
        told = []

        def kill_one(sentence):
            if not told:
                workers.workers[0].process.process._process.kill()
            told.append(sentence)

        cluster.run_with_dask(client, steps, tile_num, kill_one)
    assert len(told) == tile_num + 2
    assert (tmp_path / "out.ply").read_bytes() == expected


def test_the_script_for_slurm_runs_all_steps(mesh, tmp_path):
    """With an sbatch that runs each job at once, as often as its array says."""
    expected = by_steps(mesh, tmp_path / "steps", tmp_path / "steps.ply")
    out, folder = tmp_path / "slurm.ply", tmp_path / "slurm"
    cluster.main(["slurm", str(mesh), str(out), "--folder", str(folder), *OPTIONS])
    sbatch = tmp_path / "bin" / "sbatch"
    sbatch.parent.mkdir()
    sbatch.write_text("""#!/bin/bash
array=0
while [ $# -gt 0 ]; do
	case $1 in
	--array=*) array=${1#--array=} ;;
	--dependency=afterok:[0-9]*) ;;
	--dependency=*) exit 1 ;;
	--wrap) job=$2; shift ;;
	esac
	shift
done
for unit in $(seq "${array%-*}" "${array#*-}"); do
	SLURM_ARRAY_TASK_ID=$unit bash -c "$job" >/dev/null || exit 1
done
echo 17
""")
    sbatch.chmod(sbatch.stat().st_mode | stat.S_IEXEC)
    path = f"{sbatch.parent}{os.pathsep}{os.environ['PATH']}"
    subprocess.run(["bash", str(folder / "slurm.sh")], check=True, env={**os.environ, "PATH": path})
    assert out.read_bytes() == expected


def test_a_refusal_is_the_programs_sentence(mesh, tmp_path):
    with pytest.raises(SystemExit, match="--max-error"):
        cluster.main(["slurm", str(mesh), str(tmp_path / "out.ply"), "--folder", str(tmp_path / "run"),
                      "--max-error", "0.1%"])
