# SPDX-License-Identifier: MIT
"""The X servers and the window managers that displays.py starts, each as bare as it comes."""

import contextlib
import os
import shutil
import subprocess
import tempfile

from harness import environment, server_of, started, wait_for, x_server
from onlooker import Onlooker

MANAGERS = {  # and the word that another workspace is asked for with; none: it has no others
    "none": (None, None),
    "twm": (["twm"], None),
    "openbox": (["openbox"], ["wmctrl", "-s"]),
    "icewm": (["icewm"], ["wmctrl", "-s"]),
    "fluxbox": (["fluxbox"], ["wmctrl", "-s"]),
    "i3": (["i3", "-c"], ["i3-msg", "workspace"]),
    "awesome": (["awesome"], ["wmctrl", "-s"]),
    "xfwm4": (["xfwm4"], ["wmctrl", "-s"]),
    "metacity": (["metacity"], ["wmctrl", "-s"]),
    "mutter": (["mutter", "--x11"], ["wmctrl", "-s"]),
    "kwin": (["kwin_x11"], ["wmctrl", "-s"]),
    "matchbox": (["matchbox-window-manager"], None),
}
# Its usual fonts are packages of their own; this one every server has.
TWM = "RandomPlacement\n" + "".join(
    '%sFont "fixed"\n' % what for what in ("Title", "Resize", "Menu", "Icon", "IconManager")
)


class Unable(Exception):
    """What a cell cannot do, and why."""


# ---- servers ------------------------------------------------------------------------------------


@contextlib.contextmanager
def ready_server(command, **options):
    """The server, if it is there and starts."""
    if shutil.which(command[0]) is None:
        raise Unable(command[0] + " is not installed")
    with contextlib.ExitStack() as stack:
        try:
            server = stack.enter_context(server_of(command, **options))
        except AssertionError as error:
            raise Unable(command[0] + " does not start here") from error
        yield server


@contextlib.contextmanager
def xephyr():
    with x_server("-screen", "0", "1300x900x24") as outer:
        command = ["Xephyr", "-displayfd", "{fd}", "-screen", "800x600x24", "-noreset"]
        with ready_server(command, env=environment(outer.display)) as server:
            yield server


def tigervnc():
    number = "%d" % (70 + os.getpid() % 20)
    return ready_server(["Xvnc", "-displayfd", "{fd}", "-geometry", "800x600", "-depth", "24",
                         "-SecurityTypes", "None", "-rfbport", "59" + number])


DUMMY = """
Section "Device"\nIdentifier "d"\nDriver "dummy"\nVideoRam 65536\nEndSection
Section "Monitor"\nIdentifier "m"\nHorizSync 5-1000\nVertRefresh 5-200\nEndSection
Section "Screen"\nIdentifier "s"\nDevice "d"\nMonitor "m"\nDefaultDepth 24
SubSection "Display"\nDepth 24\nModes "800x600"\nVirtual 800 600\nEndSubSection\nEndSection
Section "ServerFlags"\nOption "AutoAddDevices" "false"\nOption "AllowMouseOpenFail" "true"\nEndSection
"""


@contextlib.contextmanager
def xorg():
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "dummy.conf"), "w") as file:
            file.write(DUMMY)
        with ready_server(["Xorg", "-displayfd", "{fd}", "-config", "dummy.conf", "-noreset",
                           "-novtswitch", "-sharevts", "-logfile", "xorg.log"],
                          cwd=folder) as server:
            yield server


@contextlib.contextmanager
def xwayland():
    if shutil.which("weston") is None:
        raise Unable("weston is not installed")
    with tempfile.TemporaryDirectory() as folder:
        env = environment(XDG_RUNTIME_DIR=folder)
        weston = ["weston", "--backend=headless-backend.so", "--socket=l3d", "--idle-time=0",
                  "--width=800", "--height=600"]
        with started(weston, env, stdout=subprocess.DEVNULL) as compositor:
            wait_for(lambda: os.path.exists(os.path.join(folder, "l3d")) or compositor.poll(),
                     "weston")
            if compositor.poll() is not None:
                raise Unable("weston does not start here")
            env["WAYLAND_DISPLAY"] = "l3d"
            # Without a window manager inside the compositor it is one window, as large as the output.
            command = ["Xwayland", "-displayfd", "{fd}", "-noreset"]
            with ready_server(command, env=env) as server:
                yield server


SERVERS = {
    "Xvfb": x_server,
    "Xephyr": xephyr,
    "TigerVNC": tigervnc,
    "Xorg dummy": xorg,
    "Xwayland": xwayland,
}


# ---- managers -----------------------------------------------------------------------------------


@contextlib.contextmanager
def managed(display, name):
    command, _ = MANAGERS[name]
    if command is None:
        yield None
        return
    if shutil.which(command[0]) is None:
        raise Unable(command[0] + " is not installed")
    with Onlooker(display) as eyes:
        wait_for(lambda: not eyes.has_manager(), "the end of the manager before")
    with tempfile.TemporaryDirectory() as home:
        # A configuration of its own: users' keys and rules are no part of the matrix.
        config = os.path.join(home, "config")
        with open(config, "w") as file:
            file.write(TWM if name == "twm" else "workspace 1\n")
        command = command + [config] if name == "i3" else command
        command = command + ["-f", config] if name == "twm" else command
        env = environment(display, HOME=home, XDG_CONFIG_HOME=home, XDG_RUNTIME_DIR=home,
                          XDG_SESSION_TYPE="x11")
        if name in ("mutter", "kwin", "xfwm4", "metacity") and shutil.which("dbus-run-session"):
            command = ["dbus-run-session", "--", *command]
        # What a manager starts may outlive it, and would keep a pipe open.
        command = ["sh", "-c", 'exec "$0" "$@" 2>/dev/null', *command]
        with started(command, env, stdout=subprocess.DEVNULL) as manager:
            with Onlooker(display) as eyes:
                with contextlib.suppress(AssertionError):
                    wait_for(lambda: eyes.is_served() or manager.poll() is not None, name)
                if manager.poll() is not None or not eyes.is_served():
                    raise Unable(name + " does not start here")
            yield manager
