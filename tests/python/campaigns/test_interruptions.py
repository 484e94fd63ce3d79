"""Killed at any moment, on a full disk, in company: nothing is lost, nothing is doubled, no byte differs."""

import errno
import multiprocessing
import os
import shutil
import signal
import subprocess
import tempfile
import time
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest
import zarr.storage._local

import freebody as fb
from python.campaigns.scene import campaign, tree

N = 1000

FORKS = multiprocessing.get_context("forkserver")
FORKS.set_forkserver_preload(["freebody.campaigns"])


def _tell_and_do(path, pipe):
    pipe.send(-1.0)
    campaign(path, N, progress=pipe.send)


def killed(path, part, delay):
    """A campaign of its own process, killed `delay` s after `part` of it is done; what was done at last."""
    here, there = FORKS.Pipe(duplex=False)
    process = FORKS.Process(target=_tell_and_do, args=(path, there))
    process.start()
    there.close()
    done = -2.0
    while done < part:
        done = here.recv()
    time.sleep(delay)
    process.kill()
    process.join()
    assert process.exitcode == -signal.SIGKILL
    return done


def test_killed_at_ten_moments_it_ends_as_if_it_had_not_been(tmp_path):
    rng = np.random.default_rng(4)
    parts = [-1.0, -1.0, *np.sort(rng.uniform(0.0, 0.8, 8))]
    for part in parts:
        killed(tmp_path / "killed", part, rng.uniform(0.0, 0.03))
    seen = []
    campaign(tmp_path / "killed", N, progress=seen.append)
    assert seen[0] >= 0.7, "what was done before the last kill is kept"
    campaign(tmp_path / "whole", N)
    assert tree(tmp_path / "killed") == tree(tmp_path / "whole")


def test_killed_while_it_grows(tmp_path):
    campaign(tmp_path / "a", 40)
    documents = tree(tmp_path / "a")
    campaign(tmp_path / "a", 110)
    grown = tree(tmp_path / "a")
    for key in documents:
        if key != "zarr.json":  # the root is the first to be written
            (tmp_path / "a" / key).write_bytes(documents[key])
    for path in (tmp_path / "a").glob("*/c/[234]*"):
        shutil.rmtree(path) if path.is_dir() else path.unlink()
    campaign(tmp_path / "a", 110)
    assert tree(tmp_path / "a") == grown


def test_what_a_killed_process_has_left_half_written_is_swept(tmp_path):
    campaign(tmp_path / "a", 60)
    whole = tree(tmp_path / "a")
    for folder in ("", "outcome/c", "runs_done/c"):
        (tmp_path / "a" / folder / f"0.{'0f' * 16}.partial").write_bytes(b"half")
    campaign(tmp_path / "a", 60)
    assert tree(tmp_path / "a") == whole


def test_interrupted_from_the_keyboard_it_goes_on(tmp_path):
    def interrupt(part):
        if part > 0.5:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        campaign(tmp_path / "a", 100, progress=interrupt)
    seen = []
    campaign(tmp_path / "a", 100, progress=seen.append)
    assert 0.5 <= seen[0] < 1.0
    campaign(tmp_path / "b", 100)
    assert tree(tmp_path / "a") == tree(tmp_path / "b")


def test_a_second_campaign_on_the_same_folder_is_refused(tmp_path):
    def second(part):
        with pytest.raises(fb.StoreError, match="another campaign is writing"):
            campaign(tmp_path / "a", 60)

    campaign(tmp_path / "a", 60, progress=second)


@contextmanager
def refusing(size):
    """A folder and what makes room in it, where the system's writes are refused past `size` bytes."""
    put, room = zarr.storage._local._put, [size]

    def refuse(path, value, exclusive=False):
        room[0] -= len(value.to_bytes())
        if room[0] < 0:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(path))
        return put(path, value, exclusive)

    with pytest.MonkeyPatch.context() as patch, tempfile.TemporaryDirectory() as folder:
        patch.setattr(zarr.storage._local, "_put", refuse)
        yield Path(folder), lambda: room.append(room.pop() + 2**26)


@contextmanager
def tmpfs(size):
    """The same with a file system that has no more room; who may not mount gets the other."""
    with tempfile.TemporaryDirectory() as folder:
        mount = ["mount", "-t", "tmpfs", "-o", f"size={size}", "none", folder]
        if os.geteuid() != 0 or subprocess.run(mount, capture_output=True, check=False).returncode != 0:
            with refusing(size // 3) as other:
                yield other
            return
        try:
            larger = ["mount", "-o", "remount,size=64m", folder]
            yield Path(folder), lambda: subprocess.run(larger, check=True)
        finally:
            subprocess.run(["umount", "-l", folder], check=True)


# The whole store has 0.2 MB in files, and 1.4 MB in blocks of 4 KiB.
@pytest.mark.parametrize("disk", [lambda: refusing(120 * 1024), lambda: tmpfs(400 * 1024)])
def test_a_full_disk_is_said_and_keeps_what_is_done(tmp_path, disk):
    with disk() as (folder, make_room):
        with pytest.raises(fb.StoreError, match="the disk is full"):
            campaign(folder / "a", N)
        assert not list(folder.rglob("*.partial"))
        make_room()
        seen = []
        campaign(folder / "a", N, progress=seen.append)
        assert 0.0 < seen[0] < 1.0
        campaign(tmp_path / "whole", N)
        assert tree(folder / "a") == tree(tmp_path / "whole")


def test_a_disk_that_is_full_from_the_start(tmp_path):
    with refusing(5000) as (folder, make_room):
        with pytest.raises(fb.StoreError, match="the disk is full"):
            campaign(folder / "a", 60)
        make_room()
        campaign(folder / "a", 60)
        campaign(tmp_path / "whole", 60)
        assert tree(folder / "a") == tree(tmp_path / "whole")
