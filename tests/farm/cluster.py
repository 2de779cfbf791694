# SPDX-License-Identifier: MIT
"""A farm on one machine: a head and nodes in namespaces of their own, with Slurm and ssh.

The head is the process that `enter` starts anew. All that it starts, nodes as well, is gone with it.
"""

import contextlib
import functools
import os
import pathlib
import signal
import subprocess
import sys
import textwrap

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "x11"))

import harness

PATIENCE = 120  # seconds that anything may take on a busy machine before it counts as hanging
APART = ["unshare", "--net", "--uts", "--mount", "--pid", "--fork", "--kill-child", "--mount-proc"]
ADDRESSES = {"head": "10.99.0.1", "a": "10.99.0.2", "b": "10.99.0.3"}
DISK = "256M"  # of the shared disk: some sequences of 20 MB

wait_for = functools.partial(harness.wait_for, patience=PATIENCE)


def enter():
    """Starts this program anew in namespaces of its own, unless it is there already."""
    if os.environ.get("L3D_FARM") != "inside":
        os.environ["L3D_FARM"] = "inside"
        os.execvp(APART[0], [*APART, sys.executable, *sys.argv])


def do(*command, **options):
    return subprocess.run(command, check=True, capture_output=True, text=True, **options).stdout


class Node:
    """A machine that has the shared disk, sshd and slurmd."""

    def __init__(self, farm, name):
        self.farm, self.name, self.process = farm, name, None

    def start(self):
        self.process = subprocess.Popen(
            [*APART, "sh", self.farm.own / "node.sh", self.name, ADDRESSES[self.name]],
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            start_new_session=True)
        # The other end of the cable lies in the node, once its namespace is there.
        ours = os.readlink("/proc/self/ns/net")
        wait_for(lambda: os.readlink(f"/proc/{self.process.pid}/ns/net") != ours, "a namespace")
        do("ip", "link", "add", f"to-{self.name}", "type", "veth", "peer", "name", "eth0",
           "netns", str(self.process.pid))
        do("ip", "link", "set", f"to-{self.name}", "master", "switch", "up")
        wait_for(lambda: self.farm.ssh(self.name, "true"), f"sshd of {self.name}")
        wait_for(lambda: do("sinfo", "-h", "-n", self.name, "-o", "%t").strip() == "idle",
                 f"slurmd of {self.name}")

    def stop(self, program):
        """Stops a process of that name, so that it is still at work when the node dies. Says whether there was one."""
        ours = os.readlink(f"/proc/{self.process.pid}/ns/uts")
        for path in pathlib.Path("/proc").glob("[0-9]*"):
            with contextlib.suppress(OSError):  # it has just ended
                if (path / "comm").read_text().strip() == program and os.readlink(path / "ns" / "uts") == ours:
                    os.kill(int(path.name), signal.SIGSTOP)
                    return True
        return False

    def kill(self):
        """As when its power is cut: nobody says goodbye, and no process goes on."""
        do("ip", "link", "delete", f"to-{self.name}")
        self.process.send_signal(signal.SIGKILL)
        self.process.wait()

    def mount(self, path, size):
        """A small disk of its own over a folder, as if the shared one were not mounted there."""
        self._do_inside("mount", "-t", "tmpfs", "-o", f"size={size}", "disk", path)

    def unmount(self, path):
        self._do_inside("umount", "--lazy", path)

    def _do_inside(self, *command):
        pid = self.process.pid
        do("nsenter", "--mount", f"--pid=/proc/{pid}/ns/pid_for_children", f"--target={pid}", *command)


class Farm:
    """The head's side: the shared disk, slurmctld, and the nodes a and b."""

    def __init__(self, programs):
        do("ip", "link", "set", "lo", "up")
        do("ip", "link", "add", "switch", "type", "bridge")
        do("ip", "addr", "add", ADDRESSES["head"] + "/24", "dev", "switch")
        do("ip", "link", "set", "switch", "up")
        do("hostname", "head")
        for path in ("/run", "/mnt"):
            do("mount", "-t", "tmpfs", "-o", f"size={DISK}", "farm", path)
        self.own = pathlib.Path("/run/farm")
        self.shared = pathlib.Path("/mnt")
        for path in (self.own, pathlib.Path("/run/sshd")):
            path.mkdir()
        os.environ["PATH"] = f"{programs}:{os.environ['PATH']}:/usr/sbin:/sbin"
        os.environ["SLURM_CONF"] = str(self.own / "slurm.conf")
        os.environ["PARALLEL_SSH"] = f"ssh -F {self.own}/ssh.conf"
        os.environ["HOME"] = str(self.own)
        self._write_files()
        do("mount", "--bind", self.own / "hosts", "/etc/hosts")
        self.controller = None
        self.start_controller()
        self.nodes = {name: Node(self, name) for name in ("a", "b")}
        for node in self.nodes.values():
            node.start()

    def _write(self, name, text):
        path = self.own / name
        path.write_text(textwrap.dedent(text))
        path.chmod(0o600)

    def _write_files(self):
        own = self.own
        self._write("hosts", "127.0.0.1 localhost\n" + "".join(
            f"{address} {name}\n" for name, address in ADDRESSES.items()))
        # Nothing here is a secret, and nobody else is in this network: nobody proves who they are.
        self._write("slurm.conf", f"""\
            ClusterName=farm
            SlurmctldHost=head
            SlurmUser=root
            AuthType=auth/none
            CredType=cred/none
            StateSaveLocation={own}/state
            SlurmctldPidFile={own}/slurmctld.pid
            SlurmctldLogFile={own}/slurmctld.log
            SlurmdSpoolDir={own}/spool.%n
            SlurmdPidFile={own}/slurmd.%n.pid
            SlurmdLogFile={own}/slurmd.%n.log
            ProctrackType=proctrack/linuxproc
            TaskPlugin=task/none
            JobAcctGatherType=jobacct_gather/none
            SelectType=select/cons_tres
            SelectTypeParameters=CR_CPU
            MpiDefault=none
            SlurmdTimeout=5
            ReturnToService=2
            SchedulerParameters=batch_sched_delay=0,sched_min_interval=0,sched_interval=1
            NodeName=a,b CPUs=1
            PartitionName=all Nodes=a,b Default=YES
            """)
        do("ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", own / "key")
        self._write("sshd.conf", f"""\
            HostKey {own}/key
            AuthorizedKeysFile {own}/key.pub
            StrictModes no
            UsePAM no
            PidFile none
            SetEnv PATH={os.environ['PATH']}
            """)
        # As users should have it: a machine without power says nothing.
        self._write("ssh.conf", f"""\
            IdentityFile {own}/key
            UserKnownHostsFile /dev/null
            StrictHostKeyChecking no
            LogLevel ERROR
            ConnectTimeout 5
            ServerAliveInterval 1
            ServerAliveCountMax 3
            """)
        self._write("node.sh", f"""\
            hostname "$1"
            ip link set lo up
            until ip link set eth0 up; do sleep 0.05; done
            ip addr add "$2/24" dev eth0
            /usr/sbin/sshd -f {own}/sshd.conf
            slurmd -D
            """)

    def start_controller(self):
        self.controller = subprocess.Popen(
            ["slurmctld", "-D"], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL)
        wait_for(lambda: subprocess.run(["scontrol", "ping"], capture_output=True, check=False
                                        ).returncode == 0, "slurmctld")

    def settle(self):
        """Cancels what is left of Slurm's jobs, and waits until both nodes have nothing to do."""
        do("scancel", "--user=root")
        wait_for(lambda: do("sinfo", "--noheader", "--format=%T %D").strip() == "idle 2", "idle nodes")

    def ssh(self, name, command):
        return subprocess.run(["ssh", "-F", self.own / "ssh.conf", name, command],
                              capture_output=True, check=False).returncode == 0

    def logs(self):
        """The last words of each daemon, for those who look for a fault of the farm itself."""
        return "\n".join(f"{path.name}: {path.read_text()[-600:]}" for path in self.own.glob("*.log"))
