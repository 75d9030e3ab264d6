# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Remeshes a surface in tiles on many machines: `gpremesh-cluster`.

The machines share a folder. Each step of a run in tiles is one call of the program `gpremesh tile`, which does
nothing where its step was done before. So a step may be lost, repeated or done twice at once: the result has the
same bytes. Dask runs the steps, or Slurm by the scripts that `--slurm` writes.

    gpremesh-cluster run huge.ply out.ply --folder DIR --percent 1 --memory 8G --local 2
    gpremesh-cluster run huge.ply out.ply --folder DIR --percent 1 --scheduler tcp://host:8786
    gpremesh-cluster slurm huge.ply out.ply --folder DIR --percent 1 --memory 8G
"""

from __future__ import annotations

import argparse
import json
import shlex
import subprocess
import sys
from pathlib import Path

from .__main__ import program

RETRIES = 3  # of a step whose worker was lost, or that failed


class StepFailed(RuntimeError):
    """A step ended with an exit code; the text is the sentence that the program told."""


def tile_step(command: list[str]) -> dict:
    """Runs one step of the program and returns what it tells.

    Parameters
    ----------
    command : list of str
        The program and all its words.

    Returns
    -------
    dict
        The line of JSON that the step prints; empty for the last step.

    Raises
    ------
    StepFailed
        Where the program ends with another exit code than 0.
    """
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise StepFailed(done.stderr.strip() or f"exit code {done.returncode}")
    lines = done.stdout.strip().splitlines()
    return json.loads(lines[-1]) if lines and lines[-1].startswith("{") else {}


class TileSteps:
    """The commands of a run in tiles, in the order of the steps."""

    def __init__(self, options: argparse.Namespace, remesh_options: list[str]):
        self.program = options.program or program()
        self.folder = options.folder
        self.input = options.input
        self.output = options.output
        sizes = [("--memory", options.memory), ("--tiles", options.tiles)]
        self.plan_options = remesh_options + [word for name, size in sizes if size for word in (name, str(size))]

    def _step(self, name: str, *words: str) -> list[str]:
        return [self.program, "tile", name, str(self.folder), *words]

    def plan(self) -> list[str]:
        return self._step("plan", str(self.input), *self.plan_options)

    def split(self) -> list[str]:
        return self._step("split")

    def part(self, unit) -> list[str]:
        return self._step("part", "--unit", str(unit))

    def join(self) -> list[str]:
        return self._step("join")

    def finish(self) -> list[str]:
        return self._step("finish", str(self.output), "--quiet")


def run_with_dask(client, steps: TileSteps, tile_num: int, tell=print) -> None:
    """Runs all steps behind the plan by the workers of a Dask client.

    Parameters
    ----------
    client : distributed.Client
        Its workers see the folder of the run, the input and the program under the same paths.
    steps : TileSteps
    tile_num : int
        Number of tiles in the plan.
    tell : callable
        Gets a sentence after each step.

    Raises
    ------
    StepFailed
        Where a step fails in all its tries.
    """
    from distributed import as_completed

    def submit(command):
        return client.submit(tile_step, command, retries=RETRIES, pure=False)

    submit(steps.split()).result()
    tell("The input is split.")
    parts = [submit(steps.part(unit)) for unit in range(tile_num)]
    for done, part in enumerate(as_completed(parts), start=1):
        part.result()
        tell(f"{done} of {tile_num} tiles are condensed.")
    submit(steps.join()).result()
    submit(steps.finish()).result()
    tell(f"{steps.output} is written.")


def slurm_script(steps: TileSteps, tile_num: int, memory: str | None) -> str:
    """A shell script that gives all steps to Slurm: an array of jobs for the tiles, and what depends on it."""
    options = ["--parsable", f"--output={shlex.quote(str(steps.folder))}/slurm-%x-%A_%a.log"]
    if memory:
        options.append(f"--mem={shlex.quote(memory)}")
    sbatch = " ".join(["sbatch", *options])

    def job(name, command, more=""):
        return f"{name}=$({sbatch} --job-name=gpremesh-{name} {more}--wrap {shlex.quote(command)})"

    part = shlex.join(steps.part("UNIT")).replace("UNIT", "$SLURM_ARRAY_TASK_ID")
    return "\n".join([
        "#!/bin/bash",
        "# Gives the steps of a run in tiles to Slurm. Run it again after a failure: steps that were done are not",
        "# done again.",
        "set -euo pipefail",
        job("split", shlex.join(steps.split())),
        job("part", part, f'--dependency=afterok:"$split" --array=0-{tile_num - 1} '),
        job("join", shlex.join(steps.join()), '--dependency=afterok:"$part" '),
        job("finish", shlex.join(steps.finish()), '--dependency=afterok:"$join" '),
        'echo "The last job is $finish."',
        "",
    ])


def _arguments(words):
    parser = argparse.ArgumentParser(prog="gpremesh-cluster", description=__doc__.splitlines()[0])
    parser.add_argument("action", choices=["run", "slurm"],
                        help="run: by Dask; slurm: write DIR/slurm.sh, which gives the steps to Slurm")
    parser.add_argument("input", type=Path, help="binary PLY file")
    parser.add_argument("output", type=Path)
    parser.add_argument("--folder", type=Path, required=True, help="of the run; all machines see it")
    parser.add_argument("--memory", help="of each step at most, such as 8G")
    parser.add_argument("--tiles", type=int, help="number of tiles, in place of --memory")
    parser.add_argument("--program", help="gpremesh; that of this package by default")
    parser.add_argument("--scheduler", help="address of a Dask scheduler, such as tcp://host:8786")
    parser.add_argument("--local", type=int, metavar="N", help="N workers on this machine")
    return parser.parse_known_args(words)  # what is left are options of gpremesh remesh


def _client(options):
    try:
        from distributed import Client, LocalCluster
    except ImportError:
        sys.exit("gpremesh-cluster: Dask is missing. Install it with: pip install distributed")
    if options.scheduler:
        return Client(options.scheduler)
    return Client(LocalCluster(n_workers=options.local or 1, threads_per_worker=1))


def main(words=None):
    options, remesh_options = _arguments(words)
    for name in ("input", "output", "folder"):  # other machines have other current folders
        setattr(options, name, getattr(options, name).absolute())
    steps = TileSteps(options, remesh_options)
    try:
        tile_num = tile_step(steps.plan())["tiles"]
        if options.action == "slurm":
            script = options.folder / "slurm.sh"
            script.write_text(slurm_script(steps, tile_num, options.memory))
            print(f"Run 'bash {shlex.quote(str(script))}' where sbatch is.")
            return
        with _client(options) as client:
            run_with_dask(client, steps, tile_num)
    except StepFailed as failure:
        sys.exit(f"gpremesh-cluster: {failure}")


if __name__ == "__main__":
    main()
