#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What docs/FARM.md shows, on a farm of two nodes with Slurm and ssh; then the same while nodes die and
disks are full. Each time the frames are those of one machine, bit for bit."""

import contextlib
import hashlib
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time
import traceback

from cluster import Farm, do, enter, wait_for

ROOT = pathlib.Path(__file__).resolve().parents[2]
BIN = pathlib.Path(os.environ["L3D_BIN"]).resolve()
FRAMES = 120
PAGE = (ROOT / "docs" / "FARM.md").read_text()
TAKEN_OUT = re.search(r"`(scontrol [^`]*)`", PAGE)[1]
FEW = 24  # where each frame is a job


def shown(name):
    """The blocks of a section of the page, in order."""
    section = re.search(rf"^## {name}$(.*?)(?=^## |\Z)", PAGE, re.M | re.S)[1]
    return re.findall(r"^```sh$(.*?)^```$", section, re.M | re.S)


(SLURM, SAME_BY_SLURM), (PARALLEL, PIPE, ONE_PIPE), (MAKE, MAKE_BY_SLURM) = map(
    shown, ("Slurm", "GNU parallel over ssh", "Make"))


def expect(condition, *facts):
    if not condition:
        raise AssertionError(" ".join(map(str, facts)))


def digests(path):
    return {file.name: hashlib.sha256(file.read_bytes()).hexdigest() for file in path.iterdir()}


class Sequence:
    """A folder on the shared disk as the page asks for it, and what is drawn there."""

    def __init__(self, farm, wanted, size):
        self.farm, self.wanted, self.size = farm, wanted, size
        self.place = farm.shared / "sequence"
        self.frames = self.place / "turn"
        shutil.rmtree(self.place, ignore_errors=True)
        shutil.copytree(ROOT / "docs" / "farm", self.place)
        self.frames.mkdir()
        (self.place / "hosts").write_text("1/a\n1/b\n")

    def shorter(self):
        """One of few frames in the same place."""
        return Sequence(self.farm, {name: self.wanted[name] for name in sorted(self.wanted)[:FEW]}, self.size)

    def begin(self, commands):
        return subprocess.Popen(["sh", "-c", commands], cwd=self.place, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True,
                                env={**os.environ, "FRAMES": str(len(self.wanted))})

    def run(self, commands):
        done = self.begin(commands)
        out, messages = done.communicate(timeout=300)
        return done.returncode, out, messages

    def expect_done(self, commands):
        status, out, messages = self.run(commands)
        expect(status == 0, "exit status", status, messages)
        self.wait_for_slurm()
        return out

    def wait_for_slurm(self):
        def is_idle():
            jobs = do("squeue", "--noheader", "--format=%i %r").split("\n")
            # Slurm lets a job that begins anew wait for two minutes.
            for job in jobs:
                if job.endswith("BeginTime"):
                    do("scontrol", "update", f"JobId={job.split()[0]}", "StartTime=now")
            return jobs == [""]

        wait_for(is_idle, "Slurm's jobs")

    def there(self):
        return len(list(self.frames.iterdir()))

    def wait_for_middle(self, node=None):
        """Until some frames are there, and a node, if one is named, is in the middle of another one."""
        wait_for(lambda: self.there() > len(self.wanted) / 8 and (not node or node.stop("teapot_afd")), "frames")

    def missing(self):
        """How many frames finish.sh found missing, by its last log."""
        logs = sorted(self.place.glob("slurm-*[0-9].out"), key=lambda path: path.stat().st_mtime)
        found = [re.match(r"(\d+) of", path.read_text()) for path in logs if "_" not in path.name]
        return int(found[-1][1])

    def expect_whole(self, has_video=True):
        found = digests(self.frames)
        expect(sorted(found) == sorted(self.wanted), len(found), "files, besides",
               sorted(set(found) - set(self.wanted))[:5], "without", sorted(set(self.wanted) - set(found))[:5])
        different = [name for name, digest in found.items() if digest != self.wanted[name]]
        expect(not different, "different:", different)
        if has_video:
            self.expect_video()

    def expect_video(self):
        count = do("ffprobe", "-v", "error", "-count_frames", "-select_streams", "v", "-show_entries",
                   "stream=nb_read_frames", "-of", "csv=p=0", self.place / "turn.mp4").strip()
        expect(count == str(len(self.wanted)), "frames of the video:", count)


def states(key):
    """A value of each job that Slurm remembers, by the job's number."""
    return dict(re.findall(rf"^JobId=(\d+) .*? {key}=(\S+)", do("scontrol", "--oneliner", "show", "job"), re.M))


def restarted():
    return sum(int(count) for count in states("Restarts").values())


# ---- what the page shows ------------------------------------------------------------------------


def by_slurm(sequence):
    sequence.expect_done(SLURM)
    sequence.expect_whole()
    expect(sequence.missing() == 0, sequence.missing(), "frames were missing")


def same_sums(sequence):
    lines = sequence.expect_done(SAME_BY_SLURM).split("\n")
    sums = {line.split(": ")[1] for line in lines if line}
    expect(len(lines) == 3 and len(sums) == 1, lines)


def by_parallel(sequence):
    out = sequence.expect_done(PARALLEL)
    expect(out.startswith("0 of 120"), out)
    sequence.expect_whole()


def through_a_pipe(sequence):
    for commands in (PIPE, ONE_PIPE):
        sequence.expect_done(commands)
        sequence.expect_video()
        (sequence.place / "turn.mp4").unlink()


def by_make(sequence):
    sequence.frames.rmdir()
    sequence.expect_done(MAKE)
    sequence.expect_whole()


def by_make_and_slurm(sequence):
    sequence = sequence.shorter()
    sequence.expect_done(MAKE_BY_SLURM)
    sequence.expect_whole()


# ---- faults -------------------------------------------------------------------------------------


@contextlib.contextmanager
def killed(node):
    node.kill()
    try:
        yield
    finally:
        node.start()


@contextlib.contextmanager
def small_disk(node, sequence):
    """One that has room for four frames lies over the folder of the frames."""
    path = sequence.frames
    node.mount(path, 4 * sequence.size)
    try:
        yield
    finally:
        node.unmount(path)


@contextlib.contextmanager
def full(sequence):
    """Somebody else's file leaves room for some thirty frames."""
    disk = sequence.farm.shared
    other = disk / "other"
    free = os.statvfs(disk).f_bavail * os.statvfs(disk).f_frsize
    with other.open("wb") as file:
        os.posix_fallocate(file.fileno(), 0, free - 30 * sequence.size)
    try:
        yield
    finally:
        other.unlink()


def failed_jobs():
    return sum(state == "FAILED" for state in states("JobState").values())


def a_node_dies_under_slurm(sequence):
    before = restarted()
    sequence.run(SLURM)
    node = sequence.farm.nodes["b"]
    sequence.wait_for_middle(node)
    with killed(node):
        sequence.wait_for_slurm()
    again = restarted() - before
    expect(again > 0, "no job began anew")
    sequence.expect_whole()
    return f"{again} jobs began anew, {sequence.missing()} frames were missing for finish.sh"


def a_nodes_disk_is_full_under_slurm(sequence):
    before = failed_jobs()
    with small_disk(sequence.farm.nodes["b"], sequence):
        sequence.expect_done(SLURM)
        failed, missing = failed_jobs() - before, sequence.missing()
        sequence.expect_done(TAKEN_OUT)
        sequence.expect_done(SLURM)
    do("scontrol", "update", "NodeName=b", "State=RESUME")
    expect(failed > 0 and missing > 0, failed, "jobs failed,", missing, "frames were missing")
    sequence.expect_whole()
    return f"{failed} jobs failed, {missing} frames were missing for finish.sh"


def the_shared_disk_is_full_under_slurm(sequence):
    before = failed_jobs()
    with full(sequence):
        sequence.expect_done(SLURM)
        failed, there = failed_jobs() - before, sequence.there()
    expect(failed > 0, "no job failed")
    sequence.expect_done(SLURM)
    sequence.expect_whole()
    return f"{failed} jobs failed and left {there} frames"


def drawn_again(sequence, commands, torn, gone):
    """Some frames are cut short, and others are removed: the same commands draw these again, and no others."""
    sequence.expect_done(commands)
    names = sorted(sequence.wanted)
    times = {name: (sequence.frames / name).stat().st_mtime_ns for name in names}
    for number in torn:
        os.truncate(sequence.frames / names[number], 1000 * number)
    for number in gone:
        (sequence.frames / names[number]).unlink()
    sequence.expect_done(commands)
    sequence.expect_whole()
    drawn = [name for name in names if (sequence.frames / name).stat().st_mtime_ns != times[name]]
    expect(drawn == [names[number] for number in sorted((*torn, *gone))], "drawn again:", drawn)
    return "these were drawn again, and no others"


def frames_are_torn_and_gone_under_slurm(sequence):
    return drawn_again(sequence, SLURM, torn=(0, 7), gone=(119,))


def frames_are_gone_under_make(sequence):
    return drawn_again(sequence, MAKE, torn=(), gone=(7, 119))


def a_node_dies_under_parallel(sequence):
    process = sequence.begin(PARALLEL)
    node = sequence.farm.nodes["b"]
    sequence.wait_for_middle(node)
    with killed(node):
        out, messages = process.communicate(timeout=300)
    expect(process.returncode == 0, "exit status", process.returncode, messages)
    sequence.expect_whole()
    return f"{out.split()[0]} frames were missing for finish.sh"


def a_nodes_disk_is_full_under_parallel(sequence):
    node = sequence.farm.nodes["b"]
    with small_disk(node, sequence):
        out = sequence.expect_done(PARALLEL)
        lost = len(os.listdir(f"/proc/{node.process.pid}/root{sequence.frames}"))
    expect(lost > 0, "nothing was on the other disk")
    sequence.expect_whole()
    return f"{lost} frames are on the other disk, {out.split()[0]} were missing for finish.sh"


def the_shared_disk_is_full_under_parallel(sequence):
    with full(sequence):
        status, _, _ = sequence.run(PARALLEL)
    expect(status == 1, "exit status", status)
    there = sequence.there()
    sequence.expect_done(PARALLEL)
    sequence.expect_whole()
    return f"exit code 1, {there} frames"


def kill_in_the_middle(sequence, commands):
    process = sequence.begin(commands)
    sequence.wait_for_middle()
    os.killpg(process.pid, signal.SIGKILL)
    process.communicate()
    there = sequence.there()
    sequence.expect_done(commands)
    sequence.expect_whole()
    return f"{there} frames were there"


def the_head_dies_under_parallel(sequence):
    return kill_in_the_middle(sequence, PARALLEL)


def make_dies(sequence):
    return kill_in_the_middle(sequence, MAKE)


def a_node_dies_before_a_pipe(sequence):
    to_sum = "| sha256sum"
    one = sequence.expect_done(ONE_PIPE.partition("|")[0] + to_sum)
    process = sequence.begin(PIPE.partition("|\n")[0] + to_sum)
    node = sequence.farm.nodes["b"]
    time.sleep(0.5)  # for some pictures of b's first part
    wait_for(lambda: node.stop("teapot_afd"), "a part of b")
    with killed(node):
        out, messages = process.communicate(timeout=300)
    expect(out == one, "another stream:", out, one, messages)
    return "the same stream"


def a_node_dies_under_make(sequence):
    sequence = sequence.shorter()
    process = sequence.begin(MAKE_BY_SLURM)
    node = sequence.farm.nodes["b"]
    sequence.wait_for_middle(node)
    with killed(node):
        process.communicate(timeout=300)
    there = sequence.there()
    # The node may have drawn its frame just before.
    expect((process.returncode == 0) == (there == FEW), process.returncode, there, "frames")
    sequence.expect_done(MAKE_BY_SLURM)
    sequence.expect_whole()
    return f"exit code {process.returncode}, {there} frames"


def a_disk_is_full_under_make(sequence):
    with full(sequence):
        status, _, _ = sequence.run(MAKE)
    there = sequence.there()
    expect(status == 2 and there < FRAMES, status, there)
    sequence.expect_done(MAKE)
    sequence.expect_whole()
    return f"exit code 2, {there} frames"


def main():
    if os.geteuid() != 0:
        print("skipped farm: namespaces need root")
        return 0
    enter()
    farm = Farm(BIN)
    first = farm.own / "wanted"
    first.mkdir()
    do("sh", "-c", ONE_PIPE.partition("--output")[0] + "--output %04d.png", cwd=first)
    wanted = digests(first)
    size = sum(file.stat().st_size for file in first.iterdir()) // FRAMES
    expect(len(wanted) == FRAMES, len(wanted))
    failed = 0
    only = sys.argv[1:]
    for check in (by_slurm, same_sums, by_parallel, through_a_pipe, by_make, by_make_and_slurm, a_node_dies_under_slurm,
                  a_nodes_disk_is_full_under_slurm, the_shared_disk_is_full_under_slurm,
                  frames_are_torn_and_gone_under_slurm, a_node_dies_under_parallel, a_nodes_disk_is_full_under_parallel,
                  the_shared_disk_is_full_under_parallel, the_head_dies_under_parallel, a_node_dies_before_a_pipe,
                  frames_are_gone_under_make, make_dies, a_disk_is_full_under_make, a_node_dies_under_make):
        if only and check.__name__ not in only:
            continue
        begun = time.monotonic()
        farm.settle()
        try:
            seen = check(Sequence(farm, wanted, size))
            print(f"ok farm.{check.__name__}", flush=True)
            if seen:
                print("   ", seen)
        except Exception as error:  # a check may fail in any way; the others still run
            failed += 1
            line = traceback.extract_tb(error.__traceback__)[-1].lineno
            print(f"not ok farm.{check.__name__} line {line}: {error}".replace("\n", " | "), flush=True)
            print(farm.logs())
        print("    %.1f s" % (time.monotonic() - begun))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
