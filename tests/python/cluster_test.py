# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs in tiles by Dask and by Slurm's scripts: the same bytes as those of one machine."""

import json
import os
import shutil
import socket
import stat
import subprocess
import time
from pathlib import Path

import numpy as np
import pytest
from meshes import command_line, torus, write_ply

from gpremesh import cluster

TILE_NUM = 4
OPTIONS = ["--vertices", "900", "--tiles", str(TILE_NUM)]


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
    for unit in range(TILE_NUM):
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


def run_of(*words):
    return cluster.tile_run(*cluster._arguments(["run", *map(str, words), *OPTIONS]))


def test_workers_of_one_machine_share_its_cores(mesh, tmp_path, monkeypatch):
    monkeypatch.setattr(cluster.os, "cpu_count", lambda: 8)

    def part_options(*words):
        return run_of(mesh, tmp_path / "out.ply", "--folder", tmp_path / "run", *words).part_options

    assert part_options() == ()
    assert part_options("--local", "1") == ()
    assert part_options("--local", "3") == ("--threads", "2")
    assert part_options("--local", "20") == ("--threads", "1")
    assert part_options("--local", "3", "--threads", "5") == ("--threads", "5")
    assert part_options("--scheduler", "tcp://host:8786") == ()


def test_a_lost_worker_changes_nothing(mesh, tmp_path):
    distributed = pytest.importorskip("distributed", reason="Dask's package distributed is not installed")
    expected = by_steps(mesh, tmp_path / "steps", tmp_path / "steps.ply")
    run = run_of(mesh, tmp_path / "out.ply", "--folder", tmp_path / "run")
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as workers, \
            distributed.Client(workers) as client:
        told = []

        def kill_one(sentence):
            if not told:
                workers.workers[0].process.process._process.kill()
            told.append(sentence)

        cluster.run_with_dask(client, run, kill_one)
    assert len(told) == TILE_NUM + 3
    assert (tmp_path / "out.ply").read_bytes() == expected


def test_the_script_for_slurm_runs_all_steps(mesh, tmp_path):
    """With an sbatch that runs each job at once, as often as its array says."""
    expected = by_steps(mesh, tmp_path / "steps", tmp_path / "steps.ply")
    out, folder = tmp_path / "slurm.ply", tmp_path / "slurm"
    cluster.main(["slurm", str(mesh), str(out), "--folder", str(folder), "--threads", "1", *OPTIONS])
    assert '"$SLURM_ARRAY_TASK_ID" --threads 1' in (folder / "slurm.sh").read_text()
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


def test_slurm_is_asked_for_memory_in_its_units(mesh, tmp_path):
    """Its M is 1048576 bytes, and that of --memory a million; a number alone is bytes for us and M for Slurm."""
    for memory in ("1500M", "1500000000"):
        folder = tmp_path / memory
        cluster.main(["slurm", str(mesh), str(tmp_path / "out.ply"), "--folder", str(folder), "--vertices", "900",
                      "--memory", memory])
        assert (folder / "slurm.sh").read_text().count("--mem=1431M ") == 4


def test_a_refusal_is_the_programs_sentence(mesh, tmp_path):
    with pytest.raises(SystemExit, match="--max-error"):
        cluster.main(["slurm", str(mesh), str(tmp_path / "out.ply"), "--folder", str(tmp_path / "run"),
                      "--max-error", "0.1%"])


# ---- files that have URLs


@pytest.fixture
def at_urls(mesh, tmp_path):
    """A run whose files have URLs of this machine."""
    pytest.importorskip("fsspec", reason="fsspec is not installed")
    return run_of(f"file://{mesh}", f"file://{tmp_path}/out/out.ply", "--folder", f"file://{tmp_path}/run",
                  "--scratch", tmp_path / "scratch")


def steps_behind_the_cut():
    return [*map(cluster.part_step, range(TILE_NUM)), cluster.join_step(TILE_NUM), cluster.finish_step()]


def test_only_the_cut_needs_the_input(mesh, at_urls, tmp_path):
    cut = cluster.cut_step(at_urls.plan_options)
    at_urls.do(cut)
    content = mesh.read_bytes()
    mesh.unlink()
    for step in steps_behind_the_cut():
        at_urls.do(step)
        assert list((tmp_path / "scratch").iterdir()) == []
    mesh.write_bytes(content)
    assert (tmp_path / "out" / "out.ply").read_bytes() == by_steps(mesh, tmp_path / "steps", tmp_path / "steps.ply")


@pytest.mark.parametrize("urls", ["folder", "input", "output"])
def test_paths_and_urls_go_together(mesh, urls, tmp_path):
    pytest.importorskip("fsspec", reason="fsspec is not installed")
    out = tmp_path / "out.ply"
    paths = {"input": mesh, "output": out, "folder": tmp_path / "run"}
    paths[urls] = f"file://{paths[urls]}"
    run = run_of(paths["input"], paths["output"], "--folder", paths["folder"], "--scratch", tmp_path / "scratch")
    for step in [cluster.cut_step(run.plan_options), *steps_behind_the_cut()]:
        run.do(step)
    assert (tmp_path / "run" / "join.json").exists()
    assert out.read_bytes() == by_steps(mesh, tmp_path / "steps", tmp_path / "steps.ply")


def test_what_was_put_is_not_put_again(at_urls, tmp_path):
    steps = [cluster.cut_step(at_urls.plan_options), *steps_behind_the_cut()]

    def times():
        return {path.name: path.stat().st_mtime_ns for path in (tmp_path / "run").iterdir()}

    told = [at_urls.do(step) for step in steps]
    first = times()
    assert {"plan.json", "split.json", "part3.ply", "joined.ply"} < first.keys()
    assert [at_urls.do(step) for step in steps] == told
    assert times() == first


@pytest.mark.parametrize("scheme", ["", "file://"])
def test_pieces_are_one_surface(scheme, tmp_path):
    """The two halves of a torus, in files of one name in two folders."""
    if scheme:
        pytest.importorskip("fsspec", reason="fsspec is not installed")
    vertices, faces = torus(150, 80, np.float32)
    half = np.arange(len(faces)) < len(faces) // 2
    pieces = []
    for name, which in (("west", half), ("east", ~half)):
        used, corners = np.unique(faces[which], return_inverse=True)
        pieces.append(tmp_path / name / "piece.ply")
        pieces[-1].parent.mkdir()
        write_ply(pieces[-1], vertices[used], corners.reshape(-1, 3).astype(np.int32))
    run = run_of(*(f"{scheme}{piece}" for piece in pieces), tmp_path / "out.ply", "--folder", tmp_path / "run",
                 "--scratch", tmp_path / "scratch")
    for step in [cluster.cut_step(run.plan_options), *steps_behind_the_cut()]:
        run.do(step)
    facts = json.loads(command_line("info", tmp_path / "out.ply", "--json").stdout)["input"]
    assert (facts["vertices"], facts["components"], facts["boundaryLoops"], facts["eulerCharacteristic"]) == (900, 1, 0, 0)


def test_the_record_is_put_last(at_urls, monkeypatch, tmp_path):
    put = cluster.put_file
    urls = []
    monkeypatch.setattr(cluster, "put_file", lambda path, url: (urls.append(url), put(path, url)))
    at_urls.do(cluster.cut_step(at_urls.plan_options))
    at_urls.do(cluster.part_step(0))
    names = [url.rpartition("/")[2] for url in urls]
    assert len(names) == 2 + 2 * TILE_NUM + 3
    assert names[1 + 2 * TILE_NUM] == "split.json" and names[-1] == "part0.json"


def test_another_command_in_the_same_place_is_refused(mesh, at_urls, tmp_path):
    at_urls.do(cluster.cut_step(at_urls.plan_options))
    at_urls.plan_options += ("--seed", "7")
    with pytest.raises(cluster.StepFailed, match="another plan"):
        at_urls.do(cluster.cut_step(at_urls.plan_options))


def test_a_missing_file_is_named(mesh, at_urls, tmp_path):
    with pytest.raises(cluster.StepFailed, match="holds no plan"):
        at_urls.do(cluster.part_step(0))
    mesh.unlink()
    with pytest.raises(cluster.StepFailed, match="torus.ply: the file is missing"):
        at_urls.do(cluster.cut_step(at_urls.plan_options))


def test_an_unknown_kind_of_url_is_named(mesh, tmp_path):
    pytest.importorskip("fsspec", reason="fsspec is not installed")
    run = run_of(mesh, tmp_path / "out.ply", "--folder", "nowhere://bucket/run", "--scratch", tmp_path / "scratch")
    with pytest.raises(cluster.StepFailed, match="nowhere://bucket/run"):
        run.do(cluster.cut_step(run.plan_options))


def test_slurm_wants_paths(mesh, tmp_path):
    with pytest.raises(SystemExit, match="no URLs"):
        cluster.main(["slurm", str(mesh), str(tmp_path / "out.ply"), "--folder", f"file://{tmp_path}/run"])


def test_files_are_fetched_and_put_between_dasks_workers(mesh, tmp_path):
    pytest.importorskip("distributed", reason="Dask's package distributed is not installed")
    pytest.importorskip("fsspec", reason="fsspec is not installed")
    expected = by_steps(mesh, tmp_path / "steps", tmp_path / "steps.ply")
    cluster.main(["run", f"file://{mesh}", f"file://{tmp_path}/out.ply", "--folder", f"file://{tmp_path}/run",
                  "--scratch", str(tmp_path / "scratch"), "--local", "2", *OPTIONS])
    assert (tmp_path / "out.ply").read_bytes() == expected


@pytest.fixture
def bucket(monkeypatch):
    """A bucket of S3 that a server on this machine has."""
    pytest.importorskip("s3fs", reason="s3fs is not installed")
    server_of = pytest.importorskip("moto.server", reason="moto, a server like S3, is not installed")
    server = server_of.ThreadedMotoServer(ip_address="127.0.0.1", port=0, verbose=False)
    server.start()
    host, port = server.get_host_and_port()
    for name, value in [("AWS_ENDPOINT_URL", f"http://{host}:{port}"), ("AWS_ACCESS_KEY_ID", "key"),
                        ("AWS_SECRET_ACCESS_KEY", "secret"), ("AWS_DEFAULT_REGION", "us-east-1")]:
        monkeypatch.setenv(name, value)
    import s3fs

    store = s3fs.S3FileSystem(skip_instance_cache=True, use_listings_cache=False)
    store.mkdir("bucket")
    yield store
    server.stop()


def test_s3_gives_the_same_bytes(mesh, bucket, tmp_path):
    pytest.importorskip("distributed", reason="Dask's package distributed is not installed")
    expected = by_steps(mesh, tmp_path / "steps", tmp_path / "steps.ply")
    bucket.put_file(str(mesh), "bucket/torus.ply")
    cluster.main(["run", "s3://bucket/torus.ply", "s3://bucket/out.ply", "--folder", "s3://bucket/a/run",
                  "--scratch", str(tmp_path / "scratch"), "--local", "2", *OPTIONS])
    assert bucket.cat_file("bucket/out.ply") == expected
    assert list((tmp_path / "scratch").iterdir()) == []
    assert "bucket/a/run/part3.json" in bucket.ls("bucket/a/run", detail=False)


# ---- workers by ssh


def free_port():
    with socket.socket() as some:
        some.bind(("127.0.0.1", 0))
        return some.getsockname()[1]


def accepts(port):
    with socket.socket() as some:
        return some.connect_ex(("127.0.0.1", port)) == 0


@pytest.fixture
def ssh_hosts(monkeypatch, tmp_path):
    """Two hosts in the user's configuration of ssh; both are a server on this machine with keys of its own."""
    pytest.importorskip("asyncssh", reason="asyncssh is not installed")
    server = shutil.which("sshd", path=f"{os.environ['PATH']}:/usr/sbin")
    if server is None:
        pytest.skip("sshd is not installed")
    home = tmp_path / "home"
    ssh = home / ".ssh"
    ssh.mkdir(parents=True)
    for key in ("host", "user"):
        subprocess.run(["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", ssh / key], check=True)
    port = free_port()
    (ssh / "known_hosts").write_text(f"[127.0.0.1]:{port} {(ssh / 'host.pub').read_text()}")
    (ssh / "config").write_text("".join(
        f"Host {name}\n  HostName 127.0.0.1\n  Port {port}\n  IdentityFile {ssh}/user\n"
        f"  UserKnownHostsFile {ssh}/known_hosts\n" for name in ("first", "second")))
    (ssh / "sshd_config").write_text(
        f"ListenAddress 127.0.0.1:{port}\nHostKey {ssh}/host\nAuthorizedKeysFile {ssh}/user.pub\nPidFile none\n"
        f"StrictModes no\nUsePAM no\nSetEnv PYTHONPATH={os.environ.get('PYTHONPATH', '')}\n")
    if os.geteuid() == 0:
        Path("/run/sshd").mkdir(exist_ok=True)  # where root's sshd wants to live
    process = subprocess.Popen([server, "-D", "-e", "-f", ssh / "sshd_config"], stderr=subprocess.DEVNULL)
    while not accepts(port):
        assert process.poll() is None, "sshd has ended"
        time.sleep(0.05)
    monkeypatch.setenv("HOME", str(home))
    yield "first,second"
    process.terminate()
    process.wait()


def test_workers_by_ssh_give_the_same_bytes(mesh, ssh_hosts, tmp_path):
    pytest.importorskip("distributed", reason="Dask's package distributed is not installed")
    expected = by_steps(mesh, tmp_path / "steps", tmp_path / "steps.ply")
    out = tmp_path / "ssh.ply"
    cluster.main(["run", str(mesh), str(out), "--folder", str(tmp_path / "run"), "--ssh", ssh_hosts, *OPTIONS])
    assert out.read_bytes() == expected


def test_a_host_that_lets_nobody_in_is_told(mesh, ssh_hosts, tmp_path):
    pytest.importorskip("distributed", reason="Dask's package distributed is not installed")
    (tmp_path / "home" / ".ssh" / "user.pub").unlink()
    with pytest.raises(SystemExit, match="there are no workers"):
        cluster.main(["run", str(mesh), str(tmp_path / "out.ply"), "--folder", str(tmp_path / "run"),
                      "--ssh", ssh_hosts, *OPTIONS])
