#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Parts of a sequence, made by any number of processes, are what one process makes of the whole."""

import json
import os
import signal
import time

from harness import (BIN, PATIENCE, Checks, ended, environment, expect, expect_equal, folder, run,
                     started)
from programs_test import real_of, table

ORBIT = [os.path.join(BIN, "teapot_afd"), "--no-input", "--backend", "memory", "--turntable", "7"]


def sequence(path, frames, *more):
    return [*ORBIT, "--frames", frames, "--output", os.path.join(path, "f%03d.png"), *more]


def expect_done(command, **variables):
    status, out, messages = run(command, environment(**variables))
    expect_equal((status, messages), (0, ""))
    return out


def pictures(path):
    found = {}
    for entry in os.scandir(path):
        with open(entry.path, "rb") as file:
            found[entry.name] = file.read()
    return found


def expect_pictures(found, wanted):
    expect_equal(sorted(found), sorted(wanted), "names:")
    expect_equal([name for name in wanted if found[name] != wanted[name]], [], "different:")


def part_of(row):
    def make(path, frames):
        expect_done(row.program.command(
            *row.arguments, "--backend", "memory", "--frames", frames,
            "--output", os.path.join(path, "f%03d.png")))

    with folder() as whole, folder() as part:
        make(whole, "24")
        make(part, "17:24")
        wanted = {name: data for name, data in pictures(whole).items() if name >= "f017.png"}
        expect_equal(len(wanted), 7)
        expect_pictures(pictures(part), wanted)


def by_gnu_parallel():
    with folder() as whole, folder() as shared, folder() as home:
        expect_done(sequence(whole, "36", "--size", "97x61"))
        ranges = ["%d:%d" % (first, first + 9) for first in range(0, 36, 9)]
        expect_done(["parallel", "--will-cite", "-j2", *sequence(shared, "{}", "--size", "97x61"),
                     ":::", *ranges], HOME=home)
        expect_pictures(pictures(shared), pictures(whole))


def killed_and_resumed():
    with folder() as whole, folder() as path:
        expect_done(sequence(whole, "40"))
        with started(sequence(path, "40"), environment()):
            end = time.monotonic() + PATIENCE
            while len(os.listdir(path)) < 5 and time.monotonic() < end:
                time.sleep(0.001)
        times = {entry.name: entry.stat().st_mtime_ns for entry in os.scandir(path)
                 if entry.name.endswith(".png")}
        expect(4 <= len(times) < 40, "killed too early or too late:", len(times))
        expect_done(sequence(path, "40", "--resume"))
        made = pictures(path)
        wanted = pictures(whole)
        expect_pictures({name: made[name] for name in made if name in wanted}, wanted)
        for name, when in times.items():
            expect_equal(os.stat(os.path.join(path, name)).st_mtime_ns, when, name + ": time")


def a_signal_leaves_whole_pictures_and_nothing_else():
    with folder() as whole:
        expect_done(sequence(whole, "40"))
        wanted = pictures(whole)
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT):
            with folder() as path:
                with started(sequence(path, "40"), environment()) as process:
                    end = time.monotonic() + PATIENCE
                    while len(os.listdir(path)) < 3 and time.monotonic() < end:
                        time.sleep(0.001)
                    process.send_signal(number)
                    status, _, messages = ended(process, PATIENCE)
                expect_equal((status, messages), (-number, ""))
                made = pictures(path)
                expect(2 < len(made) < 40, "too early or too late:", len(made))
                expect_pictures(made, {name: wanted[name] for name in sorted(wanted)[:len(made)]})


def what_a_disk_has_lost_is_made_again():
    with folder() as path:
        expect_done(sequence(path, "6", "--size", "97x61"))
        wanted = pictures(path)
        names = sorted(wanted)
        for name, size in ((names[0], 0), (names[2], len(wanted[names[2]]) - 1)):
            os.truncate(os.path.join(path, name), size)
        with open(os.path.join(path, names[4]), "r+b") as file:
            file.seek(100)
            file.write(bytes(200))
        expect_done(sequence(path, "6", "--size", "97x61", "--resume"))
        expect_pictures(pictures(path), wanted)


def reports_have_the_numbers():
    with folder() as path:
        for frames, *more in (["5:8"], ["8", "--resume"]):
            out = expect_done(sequence(path, frames, "--size", "97x61", "--report", "-", *more))
            numbers = [json.loads(line)["frame"] for line in out.splitlines()]
            expect_equal(numbers, [0, 1, 2, 3, 4] if more else [5, 6, 7])


if __name__ == "__main__":
    checks = Checks()
    for row in table():
        if not row.is_console and row.real in ("any", real_of(row.name)):
            checks.run("batches.part.%s" % row.title, part_of, row)
    checks.run("batches.by_gnu_parallel", by_gnu_parallel)
    checks.run("batches.killed_and_resumed", killed_and_resumed)
    for check in (a_signal_leaves_whole_pictures_and_nothing_else,
                  what_a_disk_has_lost_is_made_again):
        checks.run("batches." + check.__name__, check)
    checks.run("batches.reports_have_the_numbers", reports_have_the_numbers)
    checks.finish()
