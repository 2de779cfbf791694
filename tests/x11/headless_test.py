#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every program without a display, and with one that is not there."""

import contextlib
import os
import resource
import shutil
import subprocess

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
        ("--output", "a%-4d.png"),
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
        ("--list-backends", b"memory      yes"),
        ("--diagnose", b"DISPLAY=''"),
    ):
        status, out, messages = run(program.command(option), environment())
        expect_equal((status, messages), (0, ""), option)
        expect(text in out and b"\x1b" not in out, option, out)


def reports_a_full_disk(program):
    for arguments in (("--backend", "memory", "--output", "-"), ("--list-backends",),
                      ("--diagnose",), ("--help",), ("--version",)):
        with open("/dev/full", "wb") as full:
            status, _, messages = run(program.command(*arguments), environment(), stdout=full)
        expect_equal((status, messages.count("\n")), (1, 1), [arguments, messages])


def writes_no_control_characters(program):
    for arguments in (
        ("--\x1b[2J",),
        ("--fps", "\x1b[2J\n\x9b"),
        ("--backend", "\x1b]0;title\x07"),
        ("--output", "no/\x1b[31m.png"),
    ):
        status, out, messages = run(program.command(*arguments), environment())
        expect(status in (1, 2) and out == b"", status, out)
        expect_equal([c for c in messages[:-1] if ord(c) < 32 or 127 <= ord(c) < 160], [], messages)
        expect("\\x1b" in messages and messages.endswith("\n"), messages)
    with folder() as path:
        command = [os.path.join(path, "\x1b[2Jname"), "--output", "\x1b[31m.png"]
        os.symlink(program.command()[0], command[0])
        status, _, messages = run(command, environment(), cwd=path)
        expect_equal((status, "\x1b" in messages), (0, False), messages)


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
    writes_no_control_characters,
)


def drawdot_leaves_a_trail():
    with folder() as path:
        command = harness.DRAWDOT.command("--backend", "memory", "--frames", "20")
        expect_equal(run([*command, "--output", "a.png"], environment(), cwd=path)[0], 0)
        rows = harness.read_png(os.path.join(path, "a.png"))
    width, height = harness.DRAWDOT.size
    expect_equal(rows[0], 21 * [harness.GREEN] + (width - 21) * [0])
    expect_equal(rows[1:], (height - 1) * [width * [0]])


def teapot(*arguments, **options):
    command = [os.path.join(harness.BIN, "teapot_afd"), "--size", "61x43", "--backend", "memory"]
    return run([*command, *arguments], environment(), **options)


def distances_go_to_the_standard_output():
    with folder() as path:
        for option in ("--depth-output", "--error-output"):
            status, out, messages = teapot(option, "-", cwd=path)
            expect_equal((status, messages, os.listdir(path)), (0, "", []), option)
            teapot(option, "a.pfm", cwd=path)
            with open(os.path.join(path, "a.pfm"), "rb") as file:
                expect_equal(file.read(), out, option)
            os.remove(os.path.join(path, "a.pfm"))


def one_file_is_not_written_twice():
    with folder() as path:
        for first, second in (("--output", "--depth-output"), ("--report", "--error-output"),
                              ("--model", "--report")):
            name = "a.png"
            status, out, messages = teapot(first, name, second, "./" + name, cwd=path)
            expect_equal((status, out), (2, b""), messages)
            expect("a.png' is the file of --" in messages, messages)
            expect_equal(os.listdir(path), [])


def a_frame_is_not_overwritten():
    """Nor is what a link to it is given for; other numbers are names like any other."""
    with folder() as path:
        os.symlink("f0002.png", os.path.join(path, "link"))
        for output, name in (("f%d.png", "f0.png"), ("./f%04d.png", "f0012.png"), ("f%5d.png", "f    3.png"),
                             ("f%04d.png", "link"), ("%d.png", "./7.png")):
            said = teapot("--output", output, "--report", name, cwd=path)
            expect_equal(said, (2, b"", "teapot_afd: --report: '%s' is the file of a frame of --output, too\n" % name))
            expect_equal(os.listdir(path), ["link"])
        for output, name in (("f%04d.png", "f0.png"), ("f%d.png", "f.png"), ("f%d.png", "g0.png"), ("f%d.png", "f-1.png")):
            expect_equal(teapot("--output", output, "--report", name, cwd=path), (0, b"", ""), name)


def a_picture_of_the_model_is_not_overwritten():
    with folder() as path:
        chair = {"chair.obj": "mtllib chair.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                              "usemtl wood\nf 1/1 2/2 3/3\n",
                 "chair.mtl": "newmtl wood\nmap_Kd chair0.png\n"}
        for name, text in chair.items():
            with open(os.path.join(path, name), "w") as file:
                file.write(text)
        teapot("--output", "chair0.png", cwd=path)
        with open(os.path.join(path, "chair0.png"), "rb") as file:
            before = file.read()
        for program in ("modelview", "surfview"):
            def drawn_to(output):
                viewer = harness.Program(program, (32, 24)).command("chair.obj", "--backend", "memory")
                return run([*viewer, "--output", output], environment(), cwd=path)

            for output in ("chair0.png", "chair%d.png"):
                expect_equal(drawn_to(output), (2, b"", "%s: --output: '%s' is the file of a picture of 'chair.obj', too\n"
                                                % (program, output)))
                with open(os.path.join(path, "chair0.png"), "rb") as file:
                    expect_equal(file.read(), before)
            expect_equal(drawn_to("chair.png"), (0, b"", ""))


def what_no_file_can_hold_is_refused_before_it_is_drawn():
    cases = (
        (("--depth-output", "a.png"), "--depth-output: 'a.png' does not end in .pfm"),
        (("--error-output", "a"), "--error-output: 'a' does not end in .pfm"),
        (("--depth-output", "no/a.pfm"), "--depth-output: 'no/a.pfm': there is no folder 'no'"),
        (("--pick", "9,9", "--output", "-"), "--pick: its text goes to the standard output, as that of --output"),
        (("--pick", "9,9", "--report", "-"), "--pick: its text goes to the standard output, as that of --report"),
        (("--output", "b.png", "--depth-output", "link.pfm"), "'link.pfm' is the file of --output, too"))
    with folder() as path:
        os.symlink("b.png", os.path.join(path, "link.pfm"))
        for arguments, reason in cases:
            status, out, messages = teapot(*arguments, cwd=path)
            expect_equal((status in (1, 2), out), (True, b""), arguments)
            expect(reason in messages, arguments, messages)
            expect_equal(os.listdir(path), ["link.pfm"], arguments)
        expect_equal(teapot("--depth-output", "/dev/null", cwd=path), (0, b"", ""))


def model_file(name):
    built = os.path.join(harness.BIN, "..", "share", "l3d", name)
    return built if os.path.exists(built) else os.path.join("data", name)


def models_come_through_pipes():
    for model in (model_file("torus.off"), model_file("teapot.bpt")):
        for pipeline in ("zbuffer", "zsort"):
            command = [os.path.join(harness.BIN, "modelview"), "--pipeline", pipeline,
                       "--size", "61x43", "--backend", "memory", "--output", "-"]
            whole = run([*command, model], environment())
            pipe = run(["sh", "-c", 'cat "$0" | "$@" /dev/stdin', model, *command], environment())
            expect_equal((whole[0], whole[2]), (0, ""))
            expect(pipe == whole, model, pipeline, pipe[0], pipe[2])


def keys_of(name):
    """The keys and values of a file for desktops."""
    with open(os.path.join("packaging", "desktop", name)) as file:
        return dict(line.strip().split("=", 1) for line in file if "=" in line)


def file_managers_get_thumbnails():
    """As they ask for them: an absolute path, a size, a name without an ending, and no display."""
    entries = [name for name in os.listdir(os.path.join("packaging", "desktop")) if name.endswith(".thumbnailer")]
    expect_equal(entries, ["l3d-thumbnail.thumbnailer"], "two would quarrel over a type")
    entry = keys_of(entries[0])
    opens = keys_of("l3d-surfview.desktop")
    expect_equal((entry["TryExec"], entry["MimeType"]), ("l3d-thumbnail", opens["MimeType"]))
    with open(os.path.join("packaging", "desktop", "l3d.xml")) as file:
        types = file.read()
    for kind in filter(None, entry["MimeType"].split(";")):
        expect('"%s"' % kind in types, kind)
    for model in ("torus.off", "teapot.bpt"):
        with folder() as path:
            source = os.path.join(path, "a model;" + model)
            shutil.copy(model_file(model), source)
            codes = {"%s": "128", "%o": os.path.join(path, "small"), "%i": source}
            words = [codes.get(word, word) for word in entry["Exec"].split()]
            words[0] = os.path.join(harness.BIN, "thumbnail")
            # a display that does not answer is never asked
            expect_equal(run(words, {"DISPLAY": ":4711"}, cwd=path), (0, b"", ""))
            rows = harness.read_png(codes["%o"])
            expect_equal((len(rows[0]), len(rows)), (128, 128))
            expect(harness.has_picture(rows), "one colour only")


def a_broken_file_leaves_no_thumbnail():
    program = os.path.join(harness.BIN, "thumbnail")
    with open(model_file("teapot.bpt"), "rb") as file:
        teapot = file.read()
    with folder() as path:
        for contents, status in ((teapot[:len(teapot) // 2], 5), (b"", 5), (bytes(range(256)), 5)):
            with open(os.path.join(path, "broken"), "wb") as file:
                file.write(contents)
            code, out, said = run([program, "-s", "64", "broken", "small.png"], {}, cwd=path)
            expect_equal((code, out), (status, b""), said)
            expect(said.startswith("thumbnail: broken") and said.count("\n") == 1, said)
            expect_equal(os.listdir(path), ["broken"])
        for words, reason in ((("broken",), "a model and a picture"), (("-s", "0", "a", "b"), "--side: '0'")):
            code, out, said = run([program, *words], {}, cwd=path)
            expect_equal((code, out), (2, b""), said)
            expect(reason in said and said.count("\n") == 1, said)


@contextlib.contextmanager
def programs_for_everybody():
    """Copies of both viewers, and a cube of polygons, that every user may read and run."""
    with folder() as path:
        os.chmod(path, 0o755)
        for name in ("teapot_afd", "modelview"):
            shutil.copy(os.path.join(harness.BIN, name), path)
        with open(os.path.join(path, "tent.obj"), "w") as tent:
            tent.write("v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv .5 1 .5\n"
                       "f 1 5 2\nf 2 5 3\nf 3 5 4\nf 4 5 1\n")
        arguments = ("--size", "157x119", "--backend", "memory", "--threads", "8", "--output", "-")
        polygons = [os.path.join(path, "modelview"), os.path.join(path, "tent.obj"), *arguments]
        yield ([os.path.join(path, "teapot_afd"), *arguments],
               [*polygons, "--pipeline", "zbuffer"], [*polygons, "--pipeline", "zsort"])


def limited(command, limits, user=None):
    def limit():
        for which, value in limits:
            resource.setrlimit(which, (value, value))
        if user and os.getuid() == 0:
            os.setgid(user)
            os.setuid(user)

    result = subprocess.run(command, env=environment(), capture_output=True, preexec_fn=limit,
                            stdin=subprocess.DEVNULL, timeout=harness.PATIENCE)
    return result.returncode, result.stdout, result.stderr.decode()


def fewer_threads_draw_the_same():
    """As an ordinary user who may have three: no limit holds the superuser."""
    nobody_else = 54321
    with programs_for_everybody() as commands:
        for command in commands:
            whole = limited(command, ())
            expect_equal((whole[0], whole[2]), (0, ""), command)
            status, out, messages = limited(command, [(resource.RLIMIT_NPROC, 3)], nobody_else)
            expect_equal(status, 0, messages)
            expect(out == whole[1], "another picture", command)
            expect(" 8 were asked for: " in messages and messages.count("\n") == 1, messages)


def little_memory_ends_in_a_picture_or_a_line():
    """Whatever may be had, from the first picture that can be drawn down."""
    with programs_for_everybody() as commands:
        for command in commands:
            whole = limited(command, ())
            for megabytes in range(34, 80, 3):
                status, out, messages = limited(command, [(resource.RLIMIT_AS, megabytes << 20),
                                                          (resource.RLIMIT_CORE, 0)])
                fewer = " 8 were asked for: " in messages
                expect(messages.count("\n") <= 1, megabytes, messages)
                if status == 0:
                    expect(out == whole[1] and (fewer or messages == ""), megabytes, messages)
                else:
                    expect(status == 1 and "not enough memory" in messages, megabytes, status,
                           messages)


if __name__ == "__main__":
    checks = Checks()
    for program in harness.PROGRAMS:
        for check in CHECKS:
            checks.run("headless.%s.%s" % (program.name, check.__name__), check, program)
    for check in (drawdot_leaves_a_trail, distances_go_to_the_standard_output,
                  one_file_is_not_written_twice, a_frame_is_not_overwritten, a_picture_of_the_model_is_not_overwritten,
                  what_no_file_can_hold_is_refused_before_it_is_drawn, models_come_through_pipes,
                  file_managers_get_thumbnails, a_broken_file_leaves_no_thumbnail,
                  fewer_threads_draw_the_same, little_memory_ends_in_a_picture_or_a_line):
        checks.run("headless." + check.__name__, check)
    checks.finish()
