# SPDX-License-Identifier: MIT
"""A terminal that a program can be run in, and the picture that the program leaves in it."""

import fcntl
import os
import pty
import re
import struct
import termios


def picture(command, folder, environment, columns, rows, keys=b""):
    """Exit status, and two rows of colours 0xRRGGBB for each row of half blocks shown last."""
    child, terminal = pty.fork()
    if child == 0:
        os.chdir(folder)
        fcntl.ioctl(0, termios.TIOCSWINSZ, struct.pack("HHHH", rows, columns, 0, 0))
        os.execvpe(command[0], command, environment)
    os.write(terminal, keys)
    output = b""
    try:
        while data := os.read(terminal, 65536):
            output += data
    except OSError:  # what Linux says when the last one has closed its side
        pass
    os.close(terminal)
    _, status = os.waitpid(child, 0)
    return os.waitstatus_to_exitcode(status), half_blocks(output.decode())


def half_blocks(text):
    result = []
    for line in text.rsplit("\x1b[H", 1)[-1].split("\r\n"):
        cells = re.findall(r"\x1b\[38;2;(\d+);(\d+);(\d+)m\x1b\[48;2;(\d+);(\d+);(\d+)m▀", line)
        for first in (0, 3):
            result.append([int(c[first]) << 16 | int(c[first + 1]) << 8 | int(c[first + 2])
                           for c in cells])
    return result
