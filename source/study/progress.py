"""How far a study is: a line for each case that ends, and one that says how many are done, running and failed."""

import sys
import time

from study_folder import is_held


class Progress:
    def __init__(self, study, jobs):
        self._study, self._jobs = study, jobs
        self._open = study.open_cases()
        self._before = len(study.cases) - len(self._open)
        self._seconds = [sum(step["seconds"] for step in study.record(case)["steps"].values())
                         for case in study.cases if study.record(case)]
        self._told, self._begin, self._shown = set(), time.time(), ""
        self._on_terminal = sys.stdout.isatty()

    def show(self, failures):
        """Shows how far the study is; gives the number of cases that have not ended."""
        done, failed, running = [], [], 0
        for case in self._open:
            name = case["name"]
            record = self._study.record(case) if name not in self._told else None
            if record or name in self._told:
                done.append(name)
            elif name in failures:
                failed.append(name)
            elif is_held(self._study.work(name + ".lock")):
                running += 1
            if record:
                self._told.add(name)
                seconds = sum(step["seconds"] for step in record["steps"].values())
                self._seconds.append(seconds)
                state = self._study.state(case)
                self._say(f"{self._study.label(case)}: {state.word} after {seconds:.0f} s")
        total, ready = len(self._study.cases), self._before + len(done)
        left = len(self._open) - len(done) - len(failed)
        line = f"{ready} of {total} done, {running} running, {len(failed)} failed{self._time_left(left)}"
        if self._on_terminal:
            print("\r" + line + "\033[K", end="", flush=True)
        elif line.split(", about")[0] != self._shown.split(", about")[0]:
            print(line, flush=True)
        self._shown = line
        return left

    def end(self):
        if self._on_terminal and self._shown:
            print("\r\033[K", end="", flush=True)

    def _say(self, line):
        print(("\r" if self._on_terminal else "") + line + ("\033[K" if self._on_terminal else ""), flush=True)

    def _time_left(self, left):
        """From the mean time of the cases that are done, and what has passed since the last of them began."""
        if not self._seconds or left == 0:
            return ""
        mean = sum(self._seconds) / len(self._seconds)
        rounds = max(left * mean / self._jobs, mean / 10)
        return f", about {rounds:.0f} s left" if rounds < 120 else f", about {rounds / 60:.0f} min left"
