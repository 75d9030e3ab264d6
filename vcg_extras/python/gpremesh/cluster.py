# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Remeshes a surface in tiles on many machines: `gpremesh-cluster`.

The machines share a folder, or a place with a URL of fsspec, such as S3. Each step of a run in tiles is a call of
the program `gpremesh tile`, which does nothing if the step was done before. So a step may be lost, repeated or done
twice at once: the result has the same bytes. Dask runs the steps, or Slurm with the script written by
`gpremesh-cluster slurm`.

    gpremesh-cluster run huge.ply out.ply --folder DIR --percent 1 --memory 8G --local 2
    gpremesh-cluster run huge.ply out.ply --folder DIR --percent 1 --memory 8G --ssh host1,host2
    gpremesh-cluster run huge.ply out.ply --folder DIR --percent 1 --scheduler tcp://host:8786
    gpremesh-cluster run west.ply east.ply out.ply --folder DIR --percent 1 --memory 8G
    gpremesh-cluster run s3://bucket/huge.ply s3://bucket/out.ply --folder s3://bucket/run --percent 1
    gpremesh-cluster slurm huge.ply out.ply --folder DIR --percent 1 --memory 8G
"""

from __future__ import annotations

import argparse
import contextlib
import hashlib
import itertools
import json
import math
import os
import shlex
import shutil
import subprocess
import sys
import tempfile
import uuid
from dataclasses import dataclass
from enum import Enum
from pathlib import Path

from .__main__ import program

RETRIES = 3  # of a step that failed or lost its worker

# In an object store a put is atomic, there are no folders, and a move is a copy.
OBJECT_STORES = {"s3", "s3a", "gs", "gcs", "az", "abfs"}


class StepFailed(RuntimeError):
    """A step ended with an exit code, or without its files; the text is a sentence about the failure."""


class Place(Enum):
    """A placeholder in a call, for a path that depends on the machine of the step."""

    FOLDER = 1  # of the run
    INPUTS = 2
    OUTPUT = 3


@dataclass(frozen=True)
class Step:
    """A step of a run in tiles.

    Parameters
    ----------
    calls : tuple of tuple of str or Place
        The arguments of `gpremesh tile`, for each call in order.
    record : str
        The file in the folder of the run that marks the step as done; empty if there is no such file.
    reads : tuple of str
        Files in the folder of the run that the step reads beside its record. The step writes other files.
    """

    calls: tuple
    record: str = ""
    reads: tuple[str, ...] = ()

    @property
    def name(self) -> str:
        return self.calls[-1][0]

    @property
    def reads_input(self) -> bool:
        return any(Place.INPUTS in call for call in self.calls)


PLAN_CALL = ("plan", Place.FOLDER, Place.INPUTS)  # and the options
SPLIT_CALL = ("split", Place.FOLDER)
PART_CALL = ("part", Place.FOLDER, "--unit")  # and the number
JOIN_CALL = ("join", Place.FOLDER)
FINISH_CALL = ("finish", Place.FOLDER, Place.OUTPUT, "--quiet")


def cut_step(options: tuple[str, ...]) -> Step:
    """Plan and split in a single step, because both read the input."""
    return Step(((*PLAN_CALL, *options), SPLIT_CALL), "split.json", ("plan.json",))


def part_step(unit: int, options: tuple[str, ...] = ()) -> Step:
    return Step(((*PART_CALL, str(unit), *options),), f"part{unit}.json",
                ("plan.json", "split.json", f"tile{unit}.ply", f"tile{unit}.names"))


def join_step(tile_num: int) -> Step:
    parts = [f"part{unit}.{ending}" for unit in range(tile_num) for ending in ("json", "ply", "names")]
    return Step((JOIN_CALL,), "join.json", ("plan.json", *parts))


def finish_step() -> Step:
    return Step((FINISH_CALL,), "",
                ("plan.json", "split.json", "join.json", "joined.ply"))


def is_url(path: str) -> bool:
    return "://" in path


def fetch_file(url: str, path: Path) -> bool:
    """Copies a file from a URL. False if there is no file. Raises StepFailed if the file cannot be read."""
    try:
        import fsspec

        place, remote = fsspec.core.url_to_fs(url)
        place.invalidate_cache()
        if not place.exists(remote):
            return False
        place.get_file(remote, str(path))
    except Exception as failure:  # each kind of place has its own errors
        raise StepFailed(f"cannot fetch {url}: {failure}") from failure
    return True


def put_file(path: Path, url: str) -> None:
    """Copies a file to a URL, whole or not at all. Raises StepFailed if the file cannot be written."""
    try:
        import fsspec

        place, remote = fsspec.core.url_to_fs(url)
        protocols = {place.protocol} if isinstance(place.protocol, str) else set(place.protocol)
        if protocols & OBJECT_STORES:
            place.put_file(str(path), remote)
            return
        place.makedirs(remote.rpartition("/")[0], exist_ok=True)
        partial = f"{remote}.part{uuid.uuid4().hex}"
        place.put_file(str(path), partial)
        place.mv(partial, remote)
    except Exception as failure:  # as above
        raise StepFailed(f"cannot write {url}: {failure}") from failure


class SharedFiles:
    """The files of a run with folder, inputs and output visible to all machines: nothing is fetched or put."""

    def __init__(self, folder: str, inputs: list[str], output: str):
        self.paths = {Place.FOLDER: [folder], Place.INPUTS: inputs, Place.OUTPUT: [output]}

    @contextlib.contextmanager
    def at_hand(self, step: Step):
        """Lists of paths for the calls of a step, by Place."""
        yield self.paths


class FetchedFiles:
    """The files of a run with a URL as folder, output or input.

    Each step has its own folder on its machine. The files that the step reads are fetched to the folder, and the files
    that the step has written are put back; the record goes last.

    Parameters
    ----------
    folder, output : str
        URLs or paths. Inputs and output with paths are used in place.
    inputs : list of str
        Pieces of a surface.
    scratch : str
        The place of the new folders. The plan names the paths of the inputs, so that all machines use the same paths:
        inputs from URLs lie in a folder in `scratch`, with a name that follows from the URLs.
    """

    def __init__(self, folder: str, inputs: list[str], output: str, scratch: str):
        self.folder = folder.rstrip("/")
        self.inputs = inputs
        self.output = output
        self.scratch = Path(scratch)
        name = hashlib.sha256(" ".join([self.folder, *inputs]).encode()).hexdigest()[:16]
        self.input_folder = self.scratch / f"gpremesh-input-{name}"

    @contextlib.contextmanager
    def at_hand(self, step: Step):
        """Lists of paths for the calls of a step, by Place. At the end the written files are put."""
        self.scratch.mkdir(parents=True, exist_ok=True)
        with contextlib.ExitStack() as stack:
            own = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="gpremesh-", dir=self.scratch)))
            folder = own / "run"
            folder.mkdir()
            output = own / self.output.rpartition("/")[2] if is_url(self.output) else Path(self.output)
            self._fetch(step, folder)
            fetched = set(folder.iterdir())
            paths = {Place.FOLDER: [str(folder)], Place.OUTPUT: [str(output)]}
            if step.reads_input:
                paths[Place.INPUTS] = [stack.enter_context(self._input_at_hand(i)) for i in range(len(self.inputs))]
            yield paths
            written = set(folder.iterdir()) - fetched
            for path in sorted(written, key=lambda path: (path.name == step.record, path.name)):
                put_file(path, f"{self.folder}/{path.name}")
            if is_url(self.output) and output.exists():
                put_file(output, self.output)

    def _fetch(self, step: Step, folder: Path) -> None:
        """Fetches the files of a step. The program reports missing files, and so the step that was not done."""
        def fetch(name):
            return fetch_file(f"{self.folder}/{name}", folder / name)

        is_done = step.record and fetch(step.record)
        for name in step.reads:
            if not is_done or name.endswith(".json"):
                fetch(name)

    @contextlib.contextmanager
    def _input_at_hand(self, i: int):
        url = self.inputs[i]
        if not is_url(url):
            yield url
            return
        folder = self.input_folder / str(i)
        folder.mkdir(parents=True, exist_ok=True)
        path = folder / url.rpartition("/")[2]
        partial = path.with_name(f"{path.name}.part{uuid.uuid4().hex}")
        try:
            if not fetch_file(url, partial):
                raise StepFailed(f"cannot fetch {url}: the file is missing")
            partial.replace(path)
            yield str(path)
        finally:
            shutil.rmtree(self.input_folder, ignore_errors=True)


def tile_call(command: list[str]) -> dict:
    """Runs `gpremesh tile` once.

    Parameters
    ----------
    command : list of str
        The program and all arguments.

    Returns
    -------
    dict
        The line of JSON printed by the step; empty for the last step.

    Raises
    ------
    StepFailed
        If the program ends with another exit code than 0.
    """
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise StepFailed(done.stderr.strip() or f"exit code {done.returncode}")
    lines = done.stdout.strip().splitlines()
    return json.loads(lines[-1]) if lines and lines[-1].startswith("{") else {}


class TileRun:
    """A run in tiles: its files, the program, and the options of its plan.

    Parameters
    ----------
    files : SharedFiles or FetchedFiles
    plan_options : sequence of str
        Options of `gpremesh tile plan`.
    program_path : str or None
        The program; by default the program of the package on the machine of the step.
    part_threads : int
        Number of threads that condense a tile; 0: a thread for each core of the machine.
    """

    def __init__(self, files, plan_options, program_path: str | None = None, part_threads: int = 0):
        self.files = files
        self.plan_options = tuple(plan_options)
        self.program_path = program_path
        self.part_options = ("--threads", str(part_threads)) if part_threads > 0 else ()

    def command(self, call, paths) -> list[str]:
        """The program and its arguments, with paths in place of each Place."""
        words = (paths.get(word, [word]) for word in call)
        return [self.program_path or program(), "tile", *itertools.chain.from_iterable(words)]

    def do(self, step: Step) -> dict:
        """Does a step on this machine and returns the JSON of the last call. Raises StepFailed."""
        told = {}
        with self.files.at_hand(step) as paths:
            for call in step.calls:
                told = tile_call(self.command(call, paths))
        return told


def run_with_dask(client, run: TileRun, tell=print) -> None:
    """Does all steps of a run by the workers of a Dask client.

    Parameters
    ----------
    client : distributed.Client
        Its workers have this package, and see or can fetch the files of the run.
    run : TileRun
    tell : callable
        Gets a sentence after each step.

    Raises
    ------
    StepFailed
        If a step fails in all tries.
    """
    from distributed import as_completed

    def submit(step):
        key = f"{step.name}-{uuid.uuid4().hex}"  # Dask's dashboard shows the part before the dash
        return client.submit(run.do, step, retries=RETRIES, key=key)

    tile_num = len(submit(cut_step(run.plan_options)).result()["tiles"])
    tell(f"The input is cut into {tile_num} tiles.")
    parts = [submit(part_step(unit, run.part_options)) for unit in range(tile_num)]
    for done, part in enumerate(as_completed(parts), start=1):
        part.result()
        tell(f"{done} of {tile_num} tiles are condensed.")
    submit(join_step(tile_num)).result()
    tell("The tiles are joined.")
    submit(finish_step()).result()
    tell("The result is written.")


def slurm_script(run: TileRun, tile_num: int, memory_bytes: float) -> str:
    """A shell script that submits all steps after the plan to Slurm: an array of jobs for the tiles, and the
    dependent jobs."""
    paths = run.files.paths
    log = f"{paths[Place.FOLDER][0]}/slurm-%x"
    options = ["--parsable", "--requeue", "--kill-on-invalid-dep=yes"]
    if memory_bytes > 0:
        options.append(f"--mem={math.ceil(memory_bytes / 2**20)}M")
    sbatch = " ".join(["sbatch", *options])

    def command(call):
        return shlex.join(run.command(call, paths))

    part_options = "".join(f" {word}" for word in run.part_options)

    def job(name, command, more="", number="%j"):
        return (f"{name}=$({sbatch} --job-name=gpremesh-{name} --output={shlex.quote(f'{log}-{number}.log')} "
                f"{more}--wrap {shlex.quote(command)})")

    return "\n".join([
        "#!/bin/bash",
        "# Gives the steps of a run in tiles to Slurm. Run this script again after a failure: finished steps are not",
        "# repeated.",
        "set -euo pipefail",
        job("split", command(SPLIT_CALL)),
        job("part", f'{command(PART_CALL)} "$SLURM_ARRAY_TASK_ID"{part_options}',
            f'--dependency=afterok:"$split" --array=0-{tile_num - 1} ', "%A_%a"),
        job("join", command(JOIN_CALL), '--dependency=afterok:"$part" '),
        job("finish", command(FINISH_CALL), '--dependency=afterok:"$join" '),
        'echo "The last job is $finish."',
        "",
    ])


def _write_slurm_script(run: TileRun) -> None:
    folder = Path(run.files.paths[Place.FOLDER][0])
    tile_num = run.do(Step(((*PLAN_CALL, *run.plan_options),)))["tiles"]
    plan = json.loads((folder / "plan.json").read_text())
    script = folder / "slurm.sh"
    script.write_text(slurm_script(run, tile_num, plan["memoryBytes"]))
    print(f"Run 'bash {shlex.quote(str(script))}' on a machine with sbatch.")


def _arguments(words):
    parser = argparse.ArgumentParser(prog="gpremesh-cluster", description=__doc__.splitlines()[0],
                                     epilog="All other options are options of gpremesh remesh.")
    parser.add_argument("action", choices=["run", "slurm"],
                        help="run: by Dask; slurm: write DIR/slurm.sh, which gives the steps to Slurm")
    parser.add_argument("inputs", nargs="+", metavar="input",
                        help="PLY, OBJ, OFF or binary STL files, pieces of one surface; paths or URLs of fsspec")
    parser.add_argument("output", help="a path or a URL")
    parser.add_argument("--folder", required=True, metavar="DIR",
                        help="folder of the run: a path that all machines see, or a URL")
    parser.add_argument("--memory", help="most memory of each step, such as 8G")
    parser.add_argument("--tiles", type=int, help="number of tiles, in place of --memory")
    parser.add_argument("--program", help="path of gpremesh; by default the program of this package")
    parser.add_argument("--scratch", default=tempfile.gettempdir(), metavar="DIR",
                        help="with URLs: folder of each machine for the files of a step; %(default)s by default")
    parser.add_argument("--threads", type=int, metavar="T",
                        help="threads to condense a tile; by default all cores of the machine, which the workers "
                             "of --local share")
    workers = parser.add_mutually_exclusive_group()
    workers.add_argument("--local", type=int, metavar="N", help="N workers on this machine; 1 by default")
    workers.add_argument("--ssh", metavar="HOST,HOST",
                         help="a worker on each host, by ssh; the first host also runs the scheduler")
    workers.add_argument("--scheduler", help="address of a Dask scheduler, such as tcp://host:8786")
    return parser.parse_known_args(words)  # the rest are options of gpremesh remesh


def part_threads(options) -> int:
    """Number of threads that condense a tile; 0: a thread for each core."""
    if options.threads is not None:
        return options.threads
    if options.local and options.local > 1:
        return max(1, (os.cpu_count() or 1) // options.local)  # the workers run at the same time
    return 0


def tile_run(options, remesh_options) -> TileRun:
    """The run for a command line."""
    def absolute(path):  # other machines have other current folders
        return path if is_url(path) else str(Path(path).absolute())

    sizes = [("--memory", options.memory), ("--tiles", options.tiles)]
    plan_options = [*remesh_options, *(word for name, size in sizes if size for word in (name, str(size)))]
    folder, output, *inputs = map(absolute, (options.folder, options.output, *options.inputs))
    if any(is_url(path) for path in (folder, output, *inputs)):
        files = FetchedFiles(folder, inputs, output, absolute(options.scratch))
    else:
        files = SharedFiles(folder, inputs, output)
    return TileRun(files, plan_options, options.program, part_threads(options))


def _cluster(options):
    """A Dask object with new workers, which ends the workers; the address of the scheduler, if given."""
    from distributed import LocalCluster, SSHCluster

    if options.scheduler:
        return contextlib.nullcontext(options.scheduler)
    if not options.ssh:
        return LocalCluster(n_workers=options.local or 1, threads_per_worker=1)
    import asyncssh  # noqa: F401, so that a missing package gives a sentence

    hosts = options.ssh.split(",")
    return SSHCluster([hosts[0], *hosts], worker_options={"nthreads": 1})


@contextlib.contextmanager
def _client(options):
    """A Dask client with workers. Ends the program with a sentence if there are no workers."""
    with contextlib.ExitStack() as stack:
        try:
            from distributed import Client

            client = stack.enter_context(Client(stack.enter_context(_cluster(options))))
        except ImportError as missing:
            sys.exit(f"gpremesh-cluster: {missing.name} is missing. Install it with: pip install {missing.name}")
        except (OSError, RuntimeError) as failure:
            sys.exit(f"gpremesh-cluster: there are no workers: {failure}")
        yield client


def main(words=None):
    options, remesh_options = _arguments(words)
    run = tile_run(options, remesh_options)
    try:
        if options.action == "run":
            with _client(options) as client:
                print(f"Dask's dashboard is at {client.dashboard_link}")
                run_with_dask(client, run)
        elif isinstance(run.files, SharedFiles):
            _write_slurm_script(run)
        else:
            sys.exit("gpremesh-cluster: Slurm's jobs need paths that all machines see, no URLs.")
    except StepFailed as failure:
        sys.exit(f"gpremesh-cluster: {failure}")


if __name__ == "__main__":
    main()
