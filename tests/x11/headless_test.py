#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every program without a display, and with one that is not there."""

import os

import harness
from harness import Checks, environment, expect, expect_equal, folder, run


def writes_a_picture_by_itself(program):
    with folder() as path:
        status, out, messages = run(program.command(), environment(), cwd=path)
        expect_equal((status, out), (0, b""), messages)
        expect_equal(os.listdir(path), [program.name + ".png"])
        expect(program.name + ".png" in messages and messages.count("\n") == 1, messages)
        rows = harness.read_png(os.path.join(path, program.name + ".png"))
        expect_equal((len(rows[0]), len(rows)), program.size)
        expect(harness.has_picture(rows), "one colour only")


def needs_no_environment(program):
    with folder() as path:
        command = program.command("--frames", "3", "--output", "a.png")
        status, out, messages = run(command, {}, cwd=path)
        expect_equal((status, out, messages), (0, b"", ""))
        expect_equal(os.listdir(path), ["a.png"])


def gives_the_same_bytes_twice(program):
    streams = []
    for _ in range(2):
        command = program.command("--backend", "memory", "--frames", "3", "--output", "-")
        status, out, messages = run(command, environment())
        expect_equal((status, messages), (0, ""))
        streams.append(out)
    expect(streams[0] == streams[1], "two runs differ")
    width, height = program.size
    header = b"P6\n%d %d\n255\n" % program.size
    expect_equal(len(streams[0]), 3 * (len(header) + 3 * width * height))
    expect(streams[0].startswith(header), streams[0][:20])


def numbers_its_frames(program):
    with folder() as path:
        command = program.command("--backend", "memory", "--frames", "3", "--output", "f%03d.png")
        status, _, messages = run(command, environment(), cwd=path)
        expect_equal((status, messages), (0, ""))
        expect_equal(sorted(os.listdir(path)), ["f000.png", "f001.png", "f002.png"])


def works_without_standard_streams(program):
    for closed in ("<&-", ">&-", "2>&-", "<&- >&- 2>&-"):
        with folder() as path:
            command = 'exec "$0" "$@" ' + closed
            arguments = program.command("--frames", "2", "--output", "a.png")
            status, _, messages = run(["sh", "-c", command, *arguments], environment(), cwd=path)
            expect_equal((status, messages), (0, ""), closed)
            expect_equal(os.listdir(path), ["a.png"], closed)


def names_a_wrong_display(program):
    for display in (":4711", "nonsense", "localhost:4711", "no/such:3"):
        for more in ((), ("--backend", "ximage"), ("--no-input",)):
            with folder() as path:
                command = program.command(*more)
                status, out, messages = run(command, environment(display), cwd=path)
                expect_equal((status, out), (3, b""), display)
                expect("'%s'" % display in messages, messages)
                expect("--backend memory --output FILE" in messages, messages)
                expect_equal(messages.count("\n"), 1, messages)
                expect_equal(os.listdir(path), [])


def ignores_a_wrong_display_it_does_not_need(program):
    command = program.command("--backend", "memory", "--output", "-")
    status, out, messages = run(command, environment(":4711"))
    expect_equal((status, out[:2], messages), (0, b"P6", ""))


def takes_the_back_end_of_the_environment(program):
    with folder() as path:
        command = program.command("--output", "a.png")
        env = environment(":4711", L3D_BACKEND="memory")
        expect_equal(run(command, env, cwd=path), (0, b"", ""))
        expect_equal(os.listdir(path), ["a.png"])
        status, _, messages = run(command, environment(L3D_BACKEND="slate"), cwd=path)
        expect(status == 2 and "L3D_BACKEND: 'slate'" in messages, status, messages)


def refuses_wrong_usage(program):
    for arguments in (
        ("--nonsense",),
        ("stray", "stray"),
        ("--size", "0x5"),
        ("--fps", "nan"),
        ("--frames", "-1"),
        ("--output", "a.gif"),
        ("--output", "a%s.png"),
        ("--backend", "slate"),
    ):
        status, out, messages = run(program.command(*arguments), environment())
        expect_equal((status, out), (2, b""), arguments)
        expect(messages.startswith(program.name + ": "), messages)
        expect(all(word in messages for word in arguments), arguments, messages)
        expect_equal(messages.count("\n"), 1, messages)


def tells_about_itself(program):
    for option, text in (
        ("--help", b"--backend"),
        ("--version", program.name.encode()),
        ("--list-backends", b"memory  yes"),
        ("--diagnose", b"DISPLAY=''"),
    ):
        status, out, messages = run(program.command(option), environment())
        expect_equal((status, messages), (0, ""), option)
        expect(text in out and b"\x1b" not in out, option, out)


def reports_a_full_disk(program):
    with open("/dev/full", "wb") as full:
        command = program.command("--backend", "memory", "--output", "-")
        status, _, messages = run(command, environment(), stdout=full)
    expect_equal((status, messages.count("\n")), (1, 1), messages)


CHECKS = (
    writes_a_picture_by_itself,
    needs_no_environment,
    gives_the_same_bytes_twice,
    numbers_its_frames,
    works_without_standard_streams,
    names_a_wrong_display,
    ignores_a_wrong_display_it_does_not_need,
    takes_the_back_end_of_the_environment,
    refuses_wrong_usage,
    tells_about_itself,
    reports_a_full_disk,
)


def drawdot_leaves_a_trail():
    with folder() as path:
        command = harness.DRAWDOT.command("--backend", "memory", "--frames", "20")
        expect_equal(run([*command, "--output", "a.png"], environment(), cwd=path)[0], 0)
        rows = harness.read_png(os.path.join(path, "a.png"))
    width, height = harness.DRAWDOT.size
    expect_equal(rows[0], 21 * [harness.GREEN] + (width - 21) * [0])
    expect_equal(rows[1:], (height - 1) * [width * [0]])


if __name__ == "__main__":
    checks = Checks()
    for program in harness.PROGRAMS:
        for check in CHECKS:
            checks.run("headless.%s.%s" % (program.name, check.__name__), check, program)
    checks.run("headless.drawdot_leaves_a_trail", drawdot_leaves_a_trail)
    checks.finish()
