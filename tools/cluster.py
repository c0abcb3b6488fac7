# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""A private Slurm cluster on loopback, owned by this user, in one folder.

Daemons see a host name of their own (libnss-wrapper), and use no control groups, which a container may lack.
"""

import contextlib
import os
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile
import time

HOST = "loop"
CONFIGURATION = """ClusterName=loop
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge/socket,cred_expire=5
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmctldPidFile={folder}/slurmctld.pid
SlurmctldLogFile={folder}/log/slurmctld.log
SlurmdSpoolDir={folder}/spool/%n
SlurmdPidFile={folder}/slurmd.%n.pid
SlurmdLogFile={folder}/log/slurmd.%n.log
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
MpiDefault=none
SwitchType=switch/none
SlurmctldTimeout=30
SlurmdTimeout=5
KillWait=2
ReturnToService=2
JobRequeue=1
MaxArraySize=201
SchedulerType=sched/backfill
SchedulerParameters=sched_interval=2,bf_interval=2,batch_sched_delay=0,defer_batch
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""
# By default, version 1 uses no control group; Slurm's choice does.
NO_CONTROL_GROUPS = "CgroupPlugin=cgroup/v1\nCgroupMountpoint={folder}/cgroup\n"


def started_at(pid):
    """In ticks since the machine's start; None if ended."""
    try:
        fields = pathlib.Path(f"/proc/{pid}/stat").read_text(encoding="ascii", errors="replace").rpartition(")")[2].split()
    except OSError:
        return None
    return None if fields[0] == "Z" else fields[19]


def environment_of(pid):
    try:
        return pathlib.Path(f"/proc/{pid}/environ").read_bytes().split(b"\0")
    except OSError:
        return []


def parent_of(pid):
    try:
        return int(pathlib.Path(f"/proc/{pid}/stat").read_text(encoding="ascii", errors="replace").rpartition(")")[2].split()[1])
    except OSError:
        return 0


def free_ports(count):
    """Below those that the system assigns itself."""
    for first in range(10000 + os.getpid() % 20000, 32768, count):
        with contextlib.ExitStack() as stack:
            try:
                for port in range(first, first + count):
                    stack.enter_context(contextlib.closing(socket.socket())).bind(("127.0.0.1", port))
            except OSError:
                continue
            return first
    raise RuntimeError("no free ports")


class Cluster:
    def __init__(self, folder, nodes=3):
        self.folder = pathlib.Path(folder)
        self.nodes = [f"n{i + 1}" for i in range(nodes)]
        self.processes = {}
        self.env = dict(os.environ, SLURM_CONF=str(self.folder / "slurm.conf"), PATH="/usr/sbin:/usr/bin:/sbin:/bin")

    def __enter__(self):
        try:
            self.start()
        except BaseException:
            self.stop()
            raise
        return self

    def __exit__(self, *_):
        self.stop()

    def configure(self):
        for name in ("state", "spool", "log", "munge"):
            (self.folder / name).mkdir(parents=True, exist_ok=True)
            (self.folder / name).chmod(0o755)
        self.folder.chmod(0o755)
        key = self.folder / "munge" / "key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        port = free_ports(1 + len(self.nodes))
        user = subprocess.run(["id", "-un"], capture_output=True, text=True, check=True).stdout.strip()
        lines = [
            f"NodeName={node} NodeHostname={HOST} NodeAddr=127.0.0.1 Port={port + 1 + i} CPUs=1 " "RealMemory=1000 State=UNKNOWN\n"
            for i, node in enumerate(self.nodes)
        ]
        head, partition = CONFIGURATION.format(host=HOST, port=port, user=user, folder=self.folder).split("PartitionName=")
        (self.folder / "slurm.conf").write_text(head + "".join(lines) + "PartitionName=" + partition, encoding="ascii")
        groups = NO_CONTROL_GROUPS.format(folder=self.folder)
        (self.folder / "cgroup.conf").write_text(groups, encoding="ascii")
        (self.folder / "hosts").write_text(f"127.0.0.1 {HOST}\n", encoding="ascii")

    def daemon(self, name, *command):
        """The daemon ends with this process, even if this process is killed."""
        env = dict(self.env, LD_PRELOAD="libnss_wrapper.so", NSS_WRAPPER_HOSTS=f"{self.folder}/hosts", NSS_WRAPPER_HOSTNAME=HOST)
        with open(self.folder / "log" / f"{name}.out", "ab") as log:
            process = subprocess.Popen(
                ["setpriv", "--pdeathsig", "TERM", *command],
                stdin=subprocess.DEVNULL,
                stdout=log,
                stderr=log,
                env=env,
                start_new_session=True,
            )
        self.processes[name] = (process, started_at(process.pid))

    def start(self):
        """Returns when every node is idle."""
        self.configure()
        munge = self.folder / "munge"
        self.daemon(
            "munged",
            "munged",
            "-F",
            f"--key-file={munge}/key",
            f"--socket={munge}/socket",
            f"--pid-file={munge}/pid",
            f"--log-file={munge}/log",
            f"--seed-file={munge}/seed",
        )
        self.until("munge's socket", (munge / "socket").exists)
        self.daemon("slurmctld", "slurmctld", "-D")
        self.until("the controller", lambda: self.run("scontrol", "ping").returncode == 0)
        for node in self.nodes:
            self.start_node(node)
        self.until("idle nodes", lambda: len(self.run("sinfo", "-hN", "-t", "idle", "-o", "%N").stdout.split()) == len(self.nodes))

    def start_node(self, node):
        (self.folder / "spool" / node).mkdir(parents=True, exist_ok=True)
        self.daemon(node, "slurmd", "-D", "-N", node)

    def run(self, *command):
        return subprocess.run(command, env=self.env, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False, timeout=300)

    def until(self, what, condition, seconds=300):
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end:
                logs = "\n".join(
                    f"{path.name}: {path.read_text(errors='replace')[-800:]}" for path in sorted((self.folder / "log").iterdir())
                )
                raise AssertionError(f"waited {seconds} s in vain for {what}\n{logs}")
            time.sleep(0.1)

    def job_processes(self, node, daemon):
        mine = {f"SLURMD_NODENAME={node}".encode(), f"SLURM_CONF={self.folder}/slurm.conf".encode()}
        jobs = [int(name) for name in os.listdir("/proc") if name.isdigit() and mine <= set(environment_of(name))]
        parents = {parent_of(pid) for pid in jobs} - set(jobs) - {0, 1, os.getpid()}
        steps = [pid for pid in parents if pid != daemon and b"slurmstepd" in pathlib.Path(f"/proc/{pid}/cmdline").read_bytes()]
        return steps + jobs

    def kill_node(self, node):
        """Fails a node as a power failure does. Returns the jobs' processes."""
        process, _ = self.processes.pop(node)
        found = self.job_processes(node, process.pid)
        for pid in [process.pid, *found]:
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        process.wait()
        return found

    def stop(self):
        if "slurmctld" in self.processes:
            self.run("scancel", "--me")
            with contextlib.suppress(AssertionError):
                self.until("the queue to be empty", lambda: not self.run("squeue", "-h").stdout.strip(), 10)
        for name in sorted(self.processes, key=lambda name: (name == "munged", name == "slurmctld")):
            process, begun = self.processes[name]
            if started_at(process.pid) != begun:
                continue
            process.terminate()
            try:
                process.wait(timeout=10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        self.processes.clear()


def main():
    if len(sys.argv) < 3 or not sys.argv[1].isdigit():
        sys.exit("usage: python3 -m tools.cluster NODES COMMAND...    runs COMMAND with a private Slurm cluster of NODES nodes")
    with tempfile.TemporaryDirectory(prefix="slurm.") as folder, Cluster(folder, int(sys.argv[1])) as cluster:
        return subprocess.run(sys.argv[2:], env=cluster.env, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
