#!/usr/bin/python3
"""Computes a study: hands its cases to Snakemake, shows how far they are, writes tables and page.

Usage: study.py --program PROGRAM --plan PLAN.json [--jobs N] [--ranks N] [--profile NAME] [--dry-run]

The program starts this script (command `study`); PLAN.json is what `wheelrail study FILE.prm --plan` prints.
Exit codes: 0 all cases are computed, 1 bad input, 2 some failed or stopped, 3 interrupted.
"""

import os
import signal
import sys


def leave(*_):
    print("interrupted: what was computed is kept; the same command goes on", file=sys.stderr)
    raise SystemExit(3)


SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
for number in SIGNALS:
    signal.signal(number, leave)
signal.pthread_sigmask(signal.SIG_UNBLOCK, SIGNALS)  # which the program has blocked for its end

import argparse
import time

sys.dont_write_bytecode = True  # the scripts may lie in a folder that is not ours to write to

import engine
import page_stamp
import progress
import study_folder
import study_table
from study_folder import StudyError

FINISHED, BAD_INPUT, STOPPED, INTERRUPTED = 0, 1, 2, 3


def parse_arguments(arguments):
    parser = argparse.ArgumentParser(prog="wheelrail study", allow_abbrev=False)
    parser.add_argument("--program", required=True)
    parser.add_argument("--plan", required=True)
    parser.add_argument("--jobs")
    parser.add_argument("--ranks", default="1")
    parser.add_argument("--profile")
    parser.add_argument("--dry-run", action="store_true")
    parser.add_argument("--no-pictures", action="store_true")
    options = parser.parse_args(arguments)
    options.ranks = count(options.ranks, "--ranks")
    options.jobs = count(options.jobs, "--jobs") if options.jobs else max(1, cores() // options.ranks)
    return options


def count(text, name):
    if not text.isdecimal() or not 0 < int(text) < 100000:
        raise StudyError(f"{name} {text}: a positive whole number is needed, such as {name} 2")
    return int(text)


def cores():
    """Physical cores, which the launcher tells; else what this process may use."""
    told = os.environ.get("WHEELRAIL_CORES", "")
    return int(told) if told.isdecimal() and int(told) > 0 else len(os.sched_getaffinity(0))


def counted(n, noun):
    return f"{n} {noun}{'' if n == 1 else 's'}"


def dry_run(study, options):
    study.check()
    todo = study.open_cases()
    print(f"{study.title}: {counted(len(study.cases), 'case')}, {len(todo)} to compute")
    for case in study.cases:
        print(f"  {study.label(case):40} {study.state(case).word}")
    where = f"with the profile {options.profile}" if options.profile else (
        f"{options.jobs} at a time, each on {counted(options.ranks, 'rank')}")
    print(f"They would be computed {where}, in {study.folder}")
    return FINISHED


def compute(study, options):
    """Computes what is open; gives whether it was interrupted."""
    stop = []  # not an event: set() in a handler waits for ever when the signal comes within wait()
    for number in SIGNALS:
        signal.signal(number, lambda *_: stop.append(True))
    line = progress.Progress(study, options.jobs)
    with engine.Engine(study, options) as running:
        ended = 0  # looks since the last case ended; on a cluster the engine takes minutes to see that there is no more
        while running.is_alive() and ended < 10 and not stop:
            time.sleep(0.3)
            ended = 0 if line.show(running.failures) else ended + 1
    line.end()
    if stop:
        study.wait_for_cases(60)
        print("interrupted: the cases at work were saved; the same command resumes", file=sys.stderr)
    else:
        for number in SIGNALS:  # tables and page can be left
            signal.signal(number, leave)
    return bool(stop), running


def print_failures(study, failures):
    """One line for each case without figures; gives their number."""
    told = 0
    for case in study.cases:
        state = study.state(case, failures)
        if state.sentence and not state.has_figures:
            print(f"{study.label(case)}: {state.word}: {state.sentence}", file=sys.stderr)
            told += 1
    return told


def main(arguments):
    try:
        options = parse_arguments(arguments)
        study = study_folder.Study(options.plan)
        if options.dry_run:
            return dry_run(study, options)
        with study.held():
            study.prepare()
            todo = study.open_cases()
            print(f"{study.title}: {counted(len(study.cases), 'case')}, {len(todo)} to compute", flush=True)
            for note in study.notes():
                print("note: " + note, flush=True)
            interrupted, failures, fault = False, {}, ""
            if todo:
                interrupted, running = compute(study, options)
                failures, fault = running.failures, running.fault()
            failed = print_failures(study, failures)
            if not interrupted and study.open_cases(failures):
                print("error: " + (fault or "some cases were not computed"), file=sys.stderr)
            study_table.write(study, failures)
            if interrupted:
                return INTERRUPTED
            page = ""
            if not options.no_pictures:
                if not page_stamp.is_current(study):
                    import study_page  # plotting takes a second to load

                    study_page.write(study, failures, min(cores(), options.jobs * options.ranks))
                    page_stamp.write(study)
                page = "; the page is " + study.path("study.html")
            study_table.show(study)
            print(f"Tables: {study.path('table.csv')}, {study.path('costs.csv')}, {study.path('table.h5')}{page}")
            return STOPPED if failed or study.open_cases() else FINISHED
    except StudyError as error:
        print(f"error: {error}", file=sys.stderr)
        return BAD_INPUT
    except OSError as error:
        print(f"error: {error.filename or 'a file'} cannot be written or read: {error.strerror}; make room or choose "
              "another Output/Folder, then give the same command again", file=sys.stderr)
        return STOPPED


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
