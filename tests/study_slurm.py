"""A study on a Slurm of one node, which the test starts for itself: munge, controller and node daemon in this folder.

Usage: study_slurm.py PROGRAM MPIEXEC
"""

import csv
import os
import secrets
import shutil
import socket
import subprocess
import sys
import time

from checks import check, finish, small_study

PROGRAM = sys.argv[1]
SKIPPED = 77


def skip(reason):
    print("skipped: " + reason, flush=True)
    sys.exit(SKIPPED)


def free_port():
    with socket.socket() as place:
        place.bind(("localhost", 0))
        return place.getsockname()[1]


class Slurm:
    """Started on entry, ended on exit; every file is below `folder`."""

    def __init__(self, folder):
        self.folder = os.path.abspath(folder)
        self.daemons = []
        shutil.rmtree(self.folder, ignore_errors=True)
        os.makedirs(os.path.join(self.folder, "spool"))
        os.chmod(self.folder, 0o755)
        self.host = socket.gethostname().split(".")[0]

    def path(self, name):
        return os.path.join(self.folder, name)

    def configure(self):
        with open(self.path("munge.key"), "wb") as file:
            file.write(secrets.token_bytes(128))
        os.chmod(self.path("munge.key"), 0o600)
        with open(self.path("slurm.conf"), "w") as file:
            file.write(f"""ClusterName=one
SlurmctldHost={self.host}(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket={self.path("munge.socket")}
CryptoType=crypto/munge
SlurmctldPort={free_port()}
SlurmdPort={free_port()}
StateSaveLocation={self.path("spool")}
SlurmdSpoolDir={self.path("spool")}/%n
SlurmctldPidFile={self.path("slurmctld.pid")}
SlurmdPidFile={self.path("slurmd.pid")}
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
ReturnToService=2
NodeName={self.host} NodeAddr=127.0.0.1 CPUs={len(os.sched_getaffinity(0))} State=UNKNOWN
PartitionName=all Nodes={self.host} Default=YES MaxTime=INFINITE State=UP
""")
        os.environ["SLURM_CONF"] = self.path("slurm.conf")

    def start(self, *command):
        log = open(self.path(os.path.basename(command[0]) + ".txt"), "w")
        self.daemons.append(subprocess.Popen(command, stdout=log, stderr=subprocess.STDOUT))

    def __enter__(self):
        self.configure()
        self.start("/usr/sbin/munged", "--foreground", "--force", "--key-file", self.path("munge.key"), "--socket",
                   self.path("munge.socket"), "--pid-file", self.path("munge.pid"), "--seed-file", self.path("munge.seed"),
                   "--log-file", self.path("munge.log"))
        for _ in range(100):
            if os.path.exists(self.path("munge.socket")):
                break
            time.sleep(0.1)
        self.start("/usr/sbin/slurmctld", "-D", "-f", self.path("slurm.conf"))
        self.start("/usr/sbin/slurmd", "-D", "-f", self.path("slurm.conf"), "-N", self.host)
        for _ in range(120):
            done = subprocess.run(["sinfo", "-h", "-o", "%t"], capture_output=True, text=True)
            if done.stdout.strip() == "idle":
                return self
            time.sleep(0.5)
        skip("Slurm does not start here: " + (done.stdout + done.stderr).strip())

    def __exit__(self, *_):
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in self.daemons:
            daemon.wait()


def main():
    if os.geteuid() != 0:
        skip("only root can start daemons that run jobs")
    for program in ("snakemake", "sbatch", "/usr/sbin/slurmctld", "/usr/sbin/slurmd", "/usr/sbin/munged"):
        if not shutil.which(program):
            skip(f"{program} is not installed")
    shutil.rmtree("cluster", ignore_errors=True)
    with open("study.prm", "w") as file:
        file.write(small_study("Contact/Friction coefficient: 0.3, 0.5", more="  set Folder = cluster"))
    with Slurm("slurm") as slurm:
        done = subprocess.run([PROGRAM, "study", "study.prm", "--profile", "slurm", "--jobs", "2", "--ranks", "2"],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        check(done.returncode == 0, f"a study on one node {done.stdout[-800:] if done.returncode else ''}")
        with open("cluster/table.csv", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        check([row["state"] for row in rows] == ["finished", "finished"], "its cases are finished")
        with open("cluster/costs.csv", encoding="utf-8") as file:
            check(all(row["ranks"] == "2" for row in csv.DictReader(file)), "each on two ranks")
        with open(slurm.path("slurmctld.txt")) as file:
            jobs = file.read().count("_slurm_rpc_submit_batch_job")
        check(jobs == 2, f"{jobs} jobs were submitted to Slurm")
    finish()


main()
