"""Snakemake at work on the cases of a study."""

import json
import os
import re
import shutil
import subprocess
import threading

from study_folder import StudyError, replace

HERE = os.path.dirname(os.path.abspath(__file__))


def profile_folder(name):
    """A profile of this program (slurm), or a name or folder of the user's."""
    own = os.path.join(HERE, "profiles", name)
    if os.path.isdir(own):
        return own
    return os.path.abspath(name) if os.path.isdir(name) else name


class Engine:
    """Snakemake as a process of its own, with what its cases say as they fail."""

    def __init__(self, study, options):
        self.failures = {}  # case: sentence
        self._study = study
        self._last = ""
        if shutil.which("snakemake") is None:
            raise StudyError("Snakemake, which schedules the cases, is missing; install the Debian package snakemake")
        targets = [case["name"] + ".json" for case in study.open_cases()]
        config = {"script": os.path.join(HERE, "case.py"), "program": options.program, "ranks": options.ranks,
                  "folder": os.path.abspath(study.folder), "from": os.getcwd(), "compute": study.compute}
        # by a file: on the command line Snakemake reads values as YAML, here and again for jobs of a cluster
        replace(study.work("engine.config"), json.dumps(config, indent=1))
        # killed with this process, so that no case is started by an engine that nobody looks after
        command = ["setpriv", "--pdeathsig", "KILL", "snakemake", "--snakefile", os.path.join(HERE, "Snakefile"),
                   "--directory", study.path("workflow"), "--keep-going", "--nolock", "--forceall",
                   "--rerun-triggers", "mtime", "--scheduler", "greedy", "--nocolor", "--latency-wait", "20"]
        if options.profile:
            command += ["--profile", profile_folder(options.profile), "--jobs", str(options.jobs)]
        else:
            command += ["--cores", str(options.jobs * options.ranks)]
        # not in the terminal's group: Ctrl-C reaches the study, which ends the engine
        self._process = subprocess.Popen(command + ["--", *targets], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                         stderr=subprocess.STDOUT, text=True, errors="replace",
                                         start_new_session=True)
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        """Cases see that their engine is gone, save and end."""
        if self.is_alive():
            self._process.kill()
        self._process.wait()
        self._reader.join(5)

    def is_alive(self):
        return self._process.poll() is None

    def fault(self):
        """Why the engine itself could not go on; empty when it could."""
        if self._process.returncode in (0, -9):
            return ""
        return f"Snakemake ended with code {self._process.returncode}: {self._last or 'it gave no reason'}"

    def _read(self):
        """Sentences of cases; the rest goes into snakemake.log as far as there is room."""
        try:
            log = open(self._study.work("snakemake.log"), "w", encoding="utf-8")
        except OSError:
            log = None
        for line in self._process.stdout:
            match = re.match(r"case (\S+) failed: (.*)", line)
            if match:
                self.failures[match[1]] = match[2]
            elif re.match(r"\w*(Error|Exception)\b", line):
                self._last = line.strip()
            try:
                if log:
                    log.write(line)
                    log.flush()
            except OSError:
                log = None
