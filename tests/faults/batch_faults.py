#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Batches that are killed, run out of disk or lose power at each system call that writes.

After each of these accidents the same batch is run once more with --resume. Its folder must then
hold what an undisturbed batch makes, bit for bit, and nothing else. Needs strace.
"""

import os
import re
import subprocess
import sys
import tempfile

BIN = os.path.abspath(os.environ["L3D_BIN"])
FRAMES = 3
BATCH = [os.path.join(BIN, "teapot_afd"), "--no-input", "--backend", "memory", "--threads", "1",
         "--size", "61x43", "--turntable", "7", "--frames", str(FRAMES)]
WRITING = ("openat", "fchmod", "write", "fsync", "linkat", "rename", "close")
ERRORS = {"openat": "ENOSPC", "write": "ENOSPC", "fsync": "EIO", "linkat": "ENOSPC",
          "rename": "ENOSPC"}


def batch(path, *more):
    return [*BATCH, "--output", os.path.join(path, "f%d.png"), *more]


def contents(path):
    found = {}
    for name in sorted(os.listdir(path)):
        with open(os.path.join(path, name), "rb") as file:
            found[name] = file.read()
    return found


def run(command):
    return subprocess.run(command, capture_output=True, timeout=120, check=False)


def torn(path, wanted):
    """What an older program may have left: an empty frame and half of one."""
    for name, size in (("f0.png", 0), ("f1.png", len(wanted["f1.png"]) // 2)):
        with open(os.path.join(path, name), "wb") as file:
            file.write(wanted[name][:size])


class Table:
    def __init__(self):
        self.rows = {}
        self.faults = []

    def add(self, accident, call, fault):
        row = self.rows.setdefault((accident, call), [0, 0])
        row[0] += 1
        if fault:
            row[1] += 1
            self.faults.append("%s at %s: %s" % (accident, call, fault))

    def finish(self):
        print("| accident | at | cases | not whole afterwards |")
        print("|---|---|---|---|")
        for (accident, call), (cases, faults) in sorted(self.rows.items()):
            print("| %s | %s | %d | %d |" % (accident, call, cases, faults))
        for fault in self.faults[:20]:
            print("not ok", fault)
        print("%d cases, %d not whole" % (sum(r[0] for r in self.rows.values()),
                                          len(self.faults)))
        sys.exit(1 if self.faults else 0)


def fault_after_resume(path, wanted):
    """What is wrong with a folder, or nothing."""
    resumed = run(batch(path, "--resume"))
    if resumed.returncode != 0:
        return resumed.stderr.decode()
    found = contents(path)
    if sorted(found) != sorted(wanted):
        return "files " + " ".join(found)
    different = [name for name in wanted if found[name] != wanted[name]]
    return "different: " + " ".join(different) if different else ""


def calls_that_write(path, log):
    """The calls of a kind that concern a folder, counted as strace counts: all of that kind."""
    counts, found = {}, []
    with open(log, encoding="utf-8", errors="replace") as lines:
        for line in lines:
            match = re.match(r"\d+ +(\w+)\(", line)
            if not match or match[1] not in WRITING:
                continue
            counts[match[1]] = counts.get(match[1], 0) + 1
            if path in line:
                found.append((match[1], counts[match[1]], line))
    return found


def traced(path, *options):
    return run(["strace", "-f", "-y", "-o", os.path.join(path, "..", "log"),
                "-e", "trace=" + ",".join(WRITING), *options,
                *batch(path, "--resume")])


def interrupt(table, wanted, before):
    """Kills, and lets calls fail, at each call that concerns the folder."""
    def cell(accident, call, number, injection, is_right):
        with tempfile.TemporaryDirectory(prefix="l3d_faults_") as top:
            path = os.path.join(top, "frames")
            os.mkdir(path)
            before(path)
            ended = traced(path, "-e", "inject=%s:%s:when=%d" % (call, injection, number))
            fault = "" if is_right(ended) else "exit code %d %s" % (
                ended.returncode, ended.stderr.decode()[-200:])
            table.add(accident, call, fault or fault_after_resume(path, wanted))

    with tempfile.TemporaryDirectory(prefix="l3d_faults_") as top:
        path = os.path.join(top, "frames")
        os.mkdir(path)
        before(path)
        traced(path)
        calls = calls_that_write(path, os.path.join(top, "log"))
    for call, number, _ in calls:
        cell("kill -9", call, number, "signal=KILL", lambda ended: ended.returncode in (-9, 137))
        if call in ERRORS:
            # Opening without a name may fail where another way does not.
            cell("disk full", call, number, "error=" + ERRORS[call],
                 lambda ended, call=call: ended.returncode == 1 or
                 (ended.returncode == 0 and call == "openat") or
                 (ended.returncode == 0 and call == "fsync"))


def lose_power(table, wanted):
    """The disk holds what was synchronised: data by fsync of the file, names by that of the folder.
    A name that was not may be there or not."""
    with tempfile.TemporaryDirectory(prefix="l3d_faults_") as top:
        path = os.path.join(top, "frames")
        os.mkdir(path)
        traced(path)
        calls = calls_that_write(path, os.path.join(top, "log"))
    states = set()
    safe, linked, synchronised = {}, {}, False
    for call, _, line in calls:
        name = re.search(r'"[^"]*/(f\d+\.png)"', line)
        if call == "openat" and "O_TMPFILE" in line:
            synchronised = False
        elif call == "fsync" and not line.split("<", 1)[1].startswith(path + ">"):
            synchronised = True
        elif call == "fsync":
            safe.update(linked)
            linked = {}
        elif call in ("linkat", "rename") and name:
            linked[name[1]] = synchronised
        for kept in (safe, {**safe, **linked}):
            states.add(tuple(sorted(kept.items())))
    for state in sorted(states):
        with tempfile.TemporaryDirectory(prefix="l3d_faults_") as again:
            for name, has_data in state:
                with open(os.path.join(again, name), "wb") as file:
                    file.write(wanted[name] if has_data else b"")
            unsafe = [name for name, has_data in state if not has_data]
            table.add("power lost", "%d names on the disk" % len(state),
                      "a name without its data: " + " ".join(unsafe) if unsafe
                      else fault_after_resume(again, wanted))


def main():
    table = Table()
    with tempfile.TemporaryDirectory(prefix="l3d_faults_") as path:
        run(batch(path))
        wanted = contents(path)
    if len(wanted) != FRAMES:
        sys.exit("the undisturbed batch failed")
    interrupt(table, wanted, lambda path: None)
    interrupt(table, wanted, lambda path: torn(path, wanted))
    lose_power(table, wanted)
    table.finish()


if __name__ == "__main__":
    main()
