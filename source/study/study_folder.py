"""The folder of a study: the plan, the cases in it and what has become of them.

    FOLDER/CASE/, FOLDER/CASE-halfspace/   ordinary output folders
    FOLDER/workflow/CASE.prm               the scene of a case
    FOLDER/workflow/CASE.json              its record, once there is nothing more to compute
    FOLDER/workflow/CASE.failed.json       why it failed the last time; it is tried again
    FOLDER/workflow/CASE.lock              held while it is computed
    FOLDER/workflow/CASE.log               what the program said
    FOLDER/workflow/engine.config          what the jobs of the engine are called with
"""

import contextlib
import fcntl
import json
import os
import socket
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "report"))

from whole_file import part_of

#: before the keys of results, and what they are those of; the first is the run's, or what a study computes alone
SOURCES = {"": "Finite elements", "halfspace_": "Half-spaces", "bodies_": "True bodies"}


class StudyError(Exception):
    """Something that the user has to change; the text is a sentence."""


class State:
    """What has become of a case: a word for it, a sentence where there is something to say."""

    def __init__(self, word, sentence="", has_figures=False, is_open=True):
        self.word, self.sentence, self.has_figures, self.is_open = word, sentence, has_figures, is_open


def read_json(path):
    """The object in a file; None when there is none, or only a part of one."""
    try:
        with open(path, encoding="utf-8") as file:
            content = json.load(file)
    except (OSError, ValueError):
        return None
    return content if isinstance(content, dict) else None


def replace(path, text):
    """Writes a file as a whole: a reader finds the old or the new one."""
    with part_of(path) as part, open(part, "w", encoding="utf-8") as file:
        file.write(text)
        file.flush()
        os.fsync(file.fileno())


def is_held(path):
    """Whether a process holds the lock of that file."""
    try:
        with open(path, encoding="utf-8") as file:
            fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
    except BlockingIOError:
        return True
    except OSError:
        pass
    return False


def figures_of_wheels(figures):
    """The figures as both wheels of a wheelset have them."""
    return [{**figure, "key": f"{side}_{figure['key']}", "std_key": f"{side}_{figure['std_key']}",
             "label": f"{side} wheel, {figure['label']}"} for side in ("right", "left") for figure in figures]


class Study:
    """A plan and its folder."""

    def __init__(self, plan):
        with open(plan, encoding="utf-8") as file:
            plan = json.load(file)
        self.plan = plan
        self.folder = plan["folder"].rstrip("/")
        self.title = plan["title"] or os.path.basename(self.folder)
        self.version = plan["program_version"]
        self.compute = plan["compute"]
        self.axes = plan["axes"]
        self.cases = plan["cases"]
        self.figures = plan["figures"] + figures_of_wheels(plan["figures"])

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def work(self, name):
        return self.path("workflow", name)

    def label(self, case):
        """The case in words: what distinguishes it from the others."""
        words = []
        for axis, value in zip(self.axes, case["values"]):
            word = f"{axis['name'].lower()} {value}"
            if word not in words:  # rail and wheel that yield at one stress
                words.append(word)
        return ", ".join(words)

    # --- before anything is computed -----------------------------------------------------------------

    def check(self):
        if os.path.exists(self.path("parameters.prm")):
            raise StudyError(f"{self.folder} holds a run; set an Output/Folder for the study, such as "
                             f"{self.folder}_study")

    @contextlib.contextmanager
    def held(self):
        """Holds the folder against a second study. The lock is the kernel's: who is killed lets go of it."""
        self.check()
        os.makedirs(self.path("workflow"), exist_ok=True)
        with open(self.work("study.lock"), "a+", encoding="utf-8") as file:
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                file.seek(0)
                raise StudyError(f"a study is at work in {self.folder}, {file.read().strip() or 'just started'}; "
                                 "wait for its end or choose another Output/Folder") from None
            file.truncate(0)
            file.write(f"process {os.getpid()} on {socket.gethostname()}")
            file.flush()
            yield

    def prepare(self):
        """Writes the scenes of the cases and the plan."""
        for case in self.cases:
            path = self.work(case["name"] + ".prm")
            if not (os.path.exists(path) and self.record(case)):
                replace(path, case["parameters"])
        replace(self.work("plan.json"), json.dumps(self.plan, indent=1))

    def notes(self):
        """What else is there: cases of another version of the program."""
        others = {}
        for name in os.listdir(self.path("workflow")):
            if name.endswith(".json") and not name.endswith(".failed.json") and name != "plan.json":
                version = (read_json(self.work(name)) or {}).get("program_version", self.version)
                if version != self.version:
                    others[version] = others.get(version, 0) + 1
        return [f"{self.folder} holds {n} case{'' if n == 1 else 's'} computed by version {version}; they stay as they "
                f"are, and version {self.version} computes its own" for version, n in sorted(others.items())]

    # --- what has become of the cases ----------------------------------------------------------------

    def record(self, case):
        record = read_json(self.work(case["name"] + ".json"))
        return record if record and self.compute_steps() <= set(record["steps"]) else None

    def compute_steps(self):
        return {"run": {"run"}, "halfspace": {"halfspace"}, "both": {"run", "compare"}}[self.compute]

    def state(self, case, failures=None):
        record = self.record(case)
        if record:
            steps = [record["steps"][step] for step in sorted(self.compute_steps(), reverse=True)]
            sentence = " ".join(step["sentence"] for step in steps if step["sentence"])
            first = steps[0]["state"]
            return State(first if first != "finished" or not sentence else "finished in part", sentence,
                         first == "finished", False)
        if is_held(self.work(case["name"] + ".lock")):
            return State("running")
        failed = (failures or {}).get(case["name"]) or (read_json(self.work(case["name"] + ".failed.json")) or
                                                        {}).get("sentence")
        if failed:
            return State("failed", failed)
        return State("begun" if os.path.exists(self.path(case["name"])) else "open")

    def open_cases(self, failures=None):
        """Cases that are to be computed; with `failures`, those of them that nothing is known of."""
        states = [(case, self.state(case, failures)) for case in self.cases]
        return [case for case, state in states if state.is_open and (failures is None or state.word != "failed")]

    def wait_for_cases(self, seconds):
        """Waits until no case is at work any more."""
        end = time.time() + seconds
        while time.time() < end and any(is_held(self.work(case["name"] + ".lock")) for case in self.cases):
            time.sleep(0.1)

    def summaries(self, case):
        """The figures of the run, of the half-spaces and of the true bodies, each None where there are none."""
        alone = self.compute == "halfspace"
        summary = read_json(self.path(case["name"] + ("-halfspace" if alone else ""), "summary.json"))
        half_spaces, bodies = ({key[len(prefix):]: value for key, value in (summary or {}).items() if key.startswith(prefix)}
                               or None for prefix in SOURCES if prefix)
        if not alone:
            return summary, half_spaces, bodies
        # true bodies have half-spaces beside them
        of_bodies = any("halfspace_" in key and value is not None for key, value in (summary or {}).items())
        return (None, half_spaces, summary) if of_bodies else (None, summary, None)
