"""A Slurm of one node, of this machine: munged, slurmctld and slurmd as ordinary processes of who starts them, with every file in one
folder.  No systemd, no cgroup, no accounting; no cluster that this machine may belong to is touched.  Debian: slurmctld slurmd
slurm-client munge.
"""

import getpass
import os
import pathlib
import shutil
import socket
import subprocess
import time

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol", "sinfo")
BOOT = 30.0  # [s]
CONF = """ClusterName=twinbus
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port}
SlurmdPort={node_port}
AuthType=auth/munge
AuthInfo=cred_expire=5,socket={folder}/munge.socket
SlurmUser={user}
SlurmdUser={user}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MailProg=/bin/true
MpiDefault=none
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def search_path():
    return f"{os.environ.get('PATH', '')}:/usr/sbin:/sbin"


def missing():
    """The programs of Slurm that this machine lacks."""
    return [name for name in PROGRAMS if not shutil.which(name, path=search_path())]


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class Node:
    """environment(): of programs that shall use it.  end() leaves nothing running.  Throws OSError when it does not come up."""

    def __init__(self, folder):
        self.folder, self.processes = pathlib.Path(folder), []
        for name in ("state", "spool"):
            (self.folder / name).mkdir(parents=True)
        port, node_port = free_ports(2)
        self.host = socket.gethostname().partition(".")[0]
        (self.folder / "slurm.conf").write_text(CONF.format(folder=self.folder, host=self.host, port=port, node_port=node_port,
                                                            user=getpass.getuser(), cpus=os.cpu_count() or 1))
        if self.major() >= 23:
            (self.folder / "cgroup.conf").write_text("CgroupPlugin=disabled\n")
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        try:
            # Forced: the folder lies in /tmp, into which everybody may write.
            self.start("munged", "--foreground", "--force", f"--socket={self.folder}/munge.socket", f"--key-file={key}",
                       f"--pid-file={self.folder}/munged.pid", f"--log-file={self.folder}/munged.log", f"--seed-file={self.folder}/munged.seed")
            self.wait(lambda: (self.folder / "munge.socket").exists(), "munged")
            self.controller = self.start("slurmctld", "-D", "-i")
            self.start("slurmd", "-D")
            self.wait(self.idle, "the node")
        except BaseException:
            self.end()
            raise

    def major(self):
        """Of Slurm's version: `slurm-wlm 22.05.8`."""
        said = subprocess.run(["slurmd", "-V"], capture_output=True, text=True, env=self.environment()).stdout.split()
        return int(said[-1].partition(".")[0]) if said and said[-1][:1].isdigit() else 0

    def environment(self, base=None):
        return dict(base or os.environ, PATH=f"{(base or os.environ).get('PATH', '')}:/usr/sbin:/sbin", SLURM_CONF=str(self.folder / "slurm.conf"))

    def requeue_one(self):
        """An array task that runs begins anew, as when its node fails: its name, or None where none runs."""
        said = subprocess.run(["squeue", "-h", "-r", "-t", "RUNNING", "-o", "%i"], capture_output=True, text=True, env=self.environment()).stdout
        for name in said.split()[:1]:
            if subprocess.run(["scontrol", "requeue", name], capture_output=True, env=self.environment()).returncode == 0:
                return name
        return None

    def start(self, *words):
        with open(self.folder / f"{words[0]}.said", "w", encoding="utf-8") as said:
            process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=said, stderr=said, env=self.environment(), cwd=self.folder,
                                       start_new_session=True)
        self.processes.append(process)
        return process

    def restart_controller(self, away):
        """The controller ends, and comes back after so many seconds; jobs go on."""
        self.processes.remove(self.controller)
        self.controller.terminate()
        self.controller.wait()
        time.sleep(away)
        self.controller = self.start("slurmctld", "-D")

    def idle(self):
        done = subprocess.run(["sinfo", "-h", "-o", "%T"], capture_output=True, text=True, env=self.environment())
        return done.stdout.strip() == "idle"

    def wait(self, there, what):
        end = time.monotonic() + BOOT
        while not there():
            dead = [process for process in self.processes if process.poll() is not None]
            if dead or time.monotonic() > end:
                said = "".join(file.read_text(errors="replace")[-500:] for file in sorted(self.folder.glob("*.said")))
                raise OSError(f"Slurm of one node: {what} does not come up: {said.strip() or 'no sentence'}")
            time.sleep(0.2)

    def end(self):
        """slurmd ends its jobs' steps, then the daemons go."""
        if len(self.processes) > 1:
            subprocess.run(["scancel", "--user", getpass.getuser()], capture_output=True, env=self.environment(), timeout=30)
        for process in reversed(self.processes):
            process.terminate()
            try:
                process.wait(timeout=10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        self.processes = []
