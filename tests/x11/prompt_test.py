#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every program at a terminal: the question which back-end to take, and all kinds of answers."""

import contextlib
import fcntl
import os
import select
import signal
import subprocess
import termios

import harness
from harness import Checks, environment, expect, expect_equal, folder, started
from harness import wait_for, window_of, x_server, xdotool

QUESTION = "Number or name ["
END_OF_INPUT, INTERRUPT = "\x04", "\x03"  # what the keys Control-D and Control-C send


class Terminal:
    """The user's side of a terminal at which a program runs."""

    def __init__(self, master, process):
        self.master = master
        self.process = process
        self.text = ""

    def read(self):
        """Takes in what is there; an error means that nobody is at the other side any more."""
        while select.select([self.master], [], [], 0)[0]:
            try:
                self.text += os.read(self.master, 4096).decode()
            except OSError:
                return self.text
        return self.text

    def await_questions(self, count):
        wait_for(lambda: self.read().count(QUESTION) >= count, "question %d" % count)
        expect_equal(self.text.count(QUESTION), count, self.text)

    def answer(self, text):
        os.write(self.master, text.encode())

    def end(self):
        status = self.process.wait(timeout=harness.PATIENCE)
        messages = self.process.stderr.read().decode()
        self.read()
        return status, messages


@contextlib.contextmanager
def terminal(command, env, cwd, stdin=None):
    """Runs a program with a terminal of its own as standard input (if not given) and output."""
    master, slave = os.openpty()

    def take_terminal():
        os.setsid()
        fcntl.ioctl(slave, termios.TIOCSCTTY, 0)
        signal.signal(signal.SIGINT, signal.SIG_DFL)

    process = subprocess.Popen(
        command,
        env=env,
        cwd=cwd,
        stdin=slave if stdin is None else stdin,
        stdout=slave,
        stderr=subprocess.PIPE,
        preexec_fn=take_terminal,
    )
    os.close(slave)
    try:
        yield Terminal(master, process)
    finally:
        if process.poll() is None:
            process.kill()
        process.wait()
        process.stderr.close()
        os.close(master)


@contextlib.contextmanager
def asked(program, *arguments, env=None):
    """A program that has put its question, in a folder and on a server of its own."""
    with folder() as path, x_server() as server:
        env = environment(server.display) if env is None else env
        with terminal(program.command(*arguments), env, path) as it:
            it.folder, it.display = path, server.display
            it.await_questions(1)
            yield it


def expect_window(it, program):
    window = window_of(it.display, program)
    xdotool(it.display, "key", "--window", window, "q")
    expect_equal(it.end(), (0, ""))
    expect_equal(os.listdir(it.folder), [])


def expect_picture(it, program):
    status, messages = it.end()
    expect_equal((status, messages.count("\n")), (0, 1), messages)
    expect_equal(os.listdir(it.folder), [program.name + ".png"])


def number_of(it, name):
    """The number that the question gives to a back-end."""
    lines = [line.split() for line in it.text.splitlines()]
    return next(words[0] for words in lines if len(words) > 1 and words[1] == name)


def lists_what_there_is(program):
    with asked(program) as it:
        lines = it.text.splitlines()
        offered = [line for line in lines if line.split() and line.split()[0].isdigit()]
        names = [line.split()[1] for line in offered]
        expect(set(names) >= {"xshm", "ximage", "memory"}, it.text)
        default = [line.split()[1] for line in offered if "(default)" in line]
        expect_equal(default, ["xshm"], it.text)
        expect("\x1b" not in it.text, it.text)


def enter_takes_the_default(program):
    with asked(program) as it:
        it.answer("\n")
        expect_window(it, program)


def silence_takes_the_default(program):
    """After a countdown of ten seconds, of which a first key takes away what is left."""
    with asked(program) as it:
        wait_for(lambda: "(10 s) \b" in it.read(), "a countdown")
        expect_window(it, program)
        expect("(1 s) " in it.text and it.text.rstrip().endswith("xshm"), repr(it.text))


def number_is_taken(program):
    with asked(program) as it:
        it.answer(number_of(it, "memory") + "\n")
        expect_picture(it, program)


def name_is_taken(program):
    with asked(program) as it:
        it.answer("memory\n")
        expect_picture(it, program)


def window_by_name(program):
    with asked(program) as it:
        it.answer("ximage\n")
        expect_window(it, program)


def nonsense_is_asked_again(program):
    with asked(program) as it:
        for count, answer in enumerate(("9", "0", "xyz", "-1", "memory please"), start=2):
            it.answer(answer + "\n")
            it.await_questions(count)
        it.answer("memory\n")
        expect_picture(it, program)


def keys_can_be_taken_back(program):
    with asked(program) as it:
        it.answer("ximag\x7f\x7f\x15memorx\x7fy\n")
        expect_picture(it, program)


def q_quits(program):
    with asked(program) as it:
        it.answer("q\n")
        expect_equal(it.end(), (0, ""))
        expect_equal(os.listdir(it.folder), [])


def end_of_input_takes_the_default(program):
    with asked(program) as it:
        it.answer(END_OF_INPUT)
        expect_window(it, program)


def end_of_input_after_nonsense(program):
    with asked(program) as it:
        it.answer("xyz\n")
        it.await_questions(2)
        it.answer(END_OF_INPUT)
        expect_window(it, program)


def interrupt_ends_it_at_once(program):
    with asked(program) as it:
        it.answer(INTERRUPT)
        expect_equal(it.end(), (-signal.SIGINT, ""))
        expect_equal(os.listdir(it.folder), [])


def option_ask_asks(program):
    with asked(program, "--backend", "ask") as it:
        it.answer("memory\n")
        expect_picture(it, program)


def without_a_display_memory_is_the_default(program):
    with asked(program, env=environment()) as it:
        expect("DISPLAY is not set" in it.text, it.text)
        it.answer("\n")
        expect_picture(it, program)


def wrong_display_is_named_in_the_list(program):
    with asked(program, env=environment(":4711")) as it:
        expect("':4711'" in it.text, it.text)
        it.answer("ximage\n")  # which cannot serve, so it is no answer
        it.await_questions(2)
        it.answer("\n")
        expect_picture(it, program)


def is_not_asked(program, arguments=(), more={}, stdin=None):
    """A picture comes without a question, although there is a terminal."""
    with folder() as path:
        command = program.command("--output", "a.png", *arguments)
        with terminal(command, environment(**more), path, stdin) as it:
            expect_equal(it.end(), (0, ""))
            expect_equal(it.text, "")
        expect_equal(os.listdir(path), ["a.png"])


def whoever_said_it_is_not_asked(program):
    is_not_asked(program, ("--backend", "memory"))
    is_not_asked(program, ("--backend", "auto"))
    is_not_asked(program, ("--no-input",))
    is_not_asked(program, ("--no-input", "--backend", "ask"))
    is_not_asked(program, (), {"L3D_BACKEND": "memory"})


def half_a_terminal_is_not_asked(program):
    is_not_asked(program, stdin=subprocess.DEVNULL)
    with folder() as path:
        master, slave = os.openpty()
        command = program.command("--output", "-")  # standard output is a pipe
        with started(command, environment(), stdin=slave, cwd=path) as process:
            status, out, messages = harness.ended(process)
        os.close(master)
        os.close(slave)
        expect_equal((status, out[:3], messages), (0, b"P6\n", ""))


CHECKS = (
    lists_what_there_is,
    enter_takes_the_default,
    keys_can_be_taken_back,
    number_is_taken,
    name_is_taken,
    window_by_name,
    nonsense_is_asked_again,
    q_quits,
    end_of_input_takes_the_default,
    end_of_input_after_nonsense,
    interrupt_ends_it_at_once,
    option_ask_asks,
    without_a_display_memory_is_the_default,
    wrong_display_is_named_in_the_list,
    whoever_said_it_is_not_asked,
    half_a_terminal_is_not_asked,
)

if __name__ == "__main__":
    checks = Checks()
    checks.run("prompt.silence_takes_the_default", silence_takes_the_default, harness.PROGRAMS[0])
    for program in harness.PROGRAMS:
        for check in CHECKS:
            checks.run("prompt.%s.%s" % (program.name, check.__name__), check, program)
    checks.finish()
