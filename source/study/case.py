#!/usr/bin/python3
"""Computes one case of a study and leaves its record.

Usage: case.py --program P --folder STUDY --from FOLDER --compute run|halfspace|both --ranks N --starter PID CASE

A case that was begun goes on from its saved state. When the process STARTER ends, or a signal comes, the run is
saved and the case ends without a record. Exit code 0 with a record, 1 without.
"""

import argparse
import fcntl
import json
import os
import select
import signal
import subprocess
import sys
import time

sys.dont_write_bytecode = True  # the scripts may lie in a folder that is not ours to write to

from study_folder import read_json, replace

STEPS = {"run": ["run"], "halfspace": ["halfspace"], "both": ["run", "compare"]}

# What fails for these reasons is tried again: they are not the scene's. They are parts of the program's sentences.
OUTSIDE = ("cannot be ", "out of memory", "a fault in the program", "another run works in this folder",
           "Give --resume to go on with it")


class Interrupted(Exception):
    """The case is to end."""


class Failed(Exception):
    """The case could not be computed; the text is a sentence."""


class Case:
    def __init__(self, options):
        self.options = options
        self.name = options.case
        self.output = os.path.join(options.folder, self.name)
        self.work = os.path.join(options.folder, "workflow", self.name)
        self.steps = {}
        self.wake = self.watch()

    def watch(self):
        """A poll object that tells when the starter is gone or a signal has come."""
        reader, writer = os.pipe()
        os.set_blocking(writer, False)
        signal.set_wakeup_fd(writer, warn_on_full_buffer=False)
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            signal.signal(number, lambda *_: None)
        self._pipe = reader
        wake = select.poll()
        wake.register(reader, select.POLLIN)
        try:
            wake.register(os.pidfd_open(self.options.starter), select.POLLIN)
        except OSError:
            raise Interrupted from None
        return wake

    # --- the steps -----------------------------------------------------------------------------------

    def summary(self, folder=None):
        return read_json(os.path.join(folder or self.output, "summary.json")) or {}

    def run(self):
        if self.summary().get("finished"):  # killed between the end of the run and the record
            return "finished", ""
        scene = self.work + ".prm"
        code, sentence = 1, ""
        if os.path.exists(os.path.join(self.output, "checkpoint.json")):
            code, sentence = self.program("run", scene, "--resume", ranks=self.options.ranks)
        if code == 1 and "would stop there again" not in sentence:
            code, sentence = self.program("run", scene, "--overwrite", ranks=self.options.ranks)
        if code == 0:
            return "finished", ""
        if code == 1 and "would stop there again" not in sentence:
            return "refused", sentence
        return "stopped", self.summary().get("stopped_because") or sentence

    def compare(self):
        if self.steps["run"]["state"] != "finished":
            return "left out", ""
        return self.halfspaces("compare", self.output, "half-spaces: ")

    def halfspace(self):
        return self.halfspaces("halfspace", self.work + ".prm", "")

    def halfspaces(self, command, operand, who):
        code, sentence = self.program(command, operand, "--no-pictures")
        if code == 1 and command == "halfspace":
            return "refused", sentence
        return "finished" if code == 0 else "stopped", who + sentence if sentence else ""

    # --- the program ---------------------------------------------------------------------------------

    def program(self, *words, ranks=0):
        """Exit code and sentence of a call of the program."""
        command = [self.options.program, *words]
        # Whoever kills this process ends the program, too: a run saves its state on SIGUSR1, on which mpirun
        # passes to its ranks. They ignore it until they have set their handler.
        if ranks:
            command = ["setpriv", "--pdeathsig", "USR1", "mpirun", "-q", "--bind-to", "none", "--oversubscribe", "-n",
                       str(ranks), "/bin/sh", "-c", 'trap "" USR1; exec "$@"', "sh", *command]
        else:
            command = ["setpriv", "--pdeathsig", "KILL", *command]
        child = subprocess.Popen(command, cwd=self.options.start, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT, text=True, errors="replace", env=environment(ranks),
                                 start_new_session=True)
        lines, interrupted = self.listen(child, saves=ranks > 0)
        code = child.wait()
        self.log(words, lines)
        if interrupted or code == 3:
            raise Interrupted
        errors = [line[7:] for line in lines if line.startswith("error: ")]
        if code not in (0, 1, 2):
            number = -code if code < 0 else code - 128
            errors.append(f"{words[0]} was ended by signal {number} (9 often means that memory ran out)"
                          if 0 < number < 65 else f"{words[0]} ended with code {code}")
        elif code != 0 and not errors:
            errors = [line for line in lines if line.strip()][-1:]
        sentence = " ".join(" ".join(errors).split())
        if code not in (0, 1, 2) or any(part in sentence for part in OUTSIDE):
            raise Failed(sentence)
        return code, sentence

    def listen(self, child, saves):
        """The lines that a child says to its end; on a wake-up it is asked to save and end."""
        self.wake.register(child.stdout, select.POLLIN)
        text, interrupted, since = "", False, 0
        os.set_blocking(child.stdout.fileno(), False)
        while True:
            ready = [place for place, _ in self.wake.poll(1000)]
            if child.stdout.fileno() in ready:
                piece = os.read(child.stdout.fileno(), 1 << 16)
                if not piece:
                    break
                text += piece.decode(errors="replace")
                ready.remove(child.stdout.fileno())
            if ready and not interrupted:
                interrupted, since = True, time.time()
                child.send_signal(signal.SIGUSR1 if saves else signal.SIGTERM)
            if interrupted and time.time() - since > 50:
                child.kill()
            elif interrupted:
                time.sleep(0.05)  # what woke us stays ready
        self.wake.unregister(child.stdout)
        return text.splitlines(), interrupted

    def log(self, words, lines):
        try:
            with open(self.work + ".log", "a", encoding="utf-8") as file:
                file.write("\n".join(["> " + " ".join(words), *lines, ""]))
        except OSError:
            pass  # a full disk shows in the sentence of the program

    # --- the whole -----------------------------------------------------------------------------------

    def compute(self):
        for step in STEPS[self.options.compute]:
            begin = time.time()
            state, sentence = getattr(self, step)()
            if state == "refused":
                raise Failed(sentence)
            self.steps[step] = {"state": state, "sentence": sentence, "seconds": round(time.time() - begin, 3)}

    def keep_record(self):
        old = read_json(self.work + ".json") or {}
        version = self.summary().get("program_version") or self.summary(self.output + "-halfspace").get("program_version")
        record = {"case": self.name, "program_version": version, "steps": {**old.get("steps", {}), **self.steps}}
        replace(self.work + ".json", json.dumps(record, indent=1) + "\n")


def environment(ranks):
    """As the launcher sets it: one thread a rank, and root may start ranks; on a machine that is shared ranks that wait
    let others go first."""
    own = {"OMP_NUM_THREADS": "1", "DEAL_II_NUM_THREADS": "1", "OMPI_MCA_btl_vader_single_copy_mechanism": "none"}
    if ranks > 1 and os.getloadavg()[0] + ranks > os.cpu_count() + 0.5:
        own["OMPI_MCA_mpi_yield_when_idle"] = os.environ.get("OMPI_MCA_mpi_yield_when_idle", "1")
    if os.geteuid() == 0:
        own.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    return {**os.environ, **own}


def forget(path):
    if os.path.exists(path):
        os.remove(path)


def fail(case, sentence):
    print(f"case {case.name} failed: {sentence}", flush=True)
    try:
        replace(case.work + ".failed.json", json.dumps({"case": case.name, "sentence": sentence}) + "\n")
    except OSError:
        pass  # on a full disk the line above has to do
    return 1


def parse_arguments():
    parser = argparse.ArgumentParser(prog="case", allow_abbrev=False)
    for name in ("program", "folder", "compute"):
        parser.add_argument("--" + name, required=True)
    parser.add_argument("--from", dest="start", required=True)
    parser.add_argument("--ranks", type=int, required=True)
    parser.add_argument("--starter", type=int, required=True)
    parser.add_argument("case")
    return parser.parse_args()


def main():
    options = parse_arguments()
    try:
        case = Case(options)
        # a case that the last study left running ends first
        with open(case.work + ".lock", "w", encoding="utf-8") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            try:
                forget(case.work + ".failed.json")
                case.compute()
                case.keep_record()
            except Failed as error:
                return fail(case, str(error))
            except OSError as error:
                return fail(case, f"{error.filename} cannot be written: {error.strerror}")
    except Interrupted:
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
