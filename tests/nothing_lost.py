"""Runs of the program that are interrupted, killed, or meet a full or read-only disk.

Usage: nothing_lost.py PROGRAM MPIEXEC WHAT [BASE]

WHAT is one of the functions at the end. Each works in the current folder; BASE is the folder in which
`interrupt` was run before, whose saved state the others start from.
"""

import glob
import json
import os
import random
import re
import shutil
import signal
import socket
import subprocess
import sys
import time

from checks import SMALL_SCENE, check, finish
from interrupted import check_files, kill, summary_of, wait_for

PROGRAM, MPIEXEC = sys.argv[1:3]
SKIPPED = 77

# the rolling scene in a size for tests, which saves its state often
SCENE = "set Title = small\n" + SMALL_SCENE + """
subsection Run
  set Rolling distance = 6 mm
  set Averaging distance = 2 mm
end
subsection Output
  set Ticks = 3
  set Checkpoint interval = 0.1 s
end
"""

FIGURES = """normal_force_N longitudinal_force_N lateral_force_N max_pressure_Pa contact_area_m2 patch_lateral_m
    max_shear_traction_Pa stick_fraction creepage max_von_mises_Pa rolled_distance_m time_steps energy_error
    relative_roll_rad normal_force_std_N""".split()


def skip(reason):
    print("skipped: " + reason, flush=True)
    sys.exit(SKIPPED)


# --- running the program --------------------------------------------------------------------------

def command(folder, *options, ranks=1, sets=()):
    scene = os.path.abspath("small.prm")
    with open(scene, "w") as file:
        file.write(SCENE)
    line = [MPIEXEC, "--bind-to", "none", "--oversubscribe", "-q", "-n", str(ranks)] if ranks > 1 else []
    line += [PROGRAM, "run", scene, "--set", "Output/Folder = " + folder, *options]
    for entry in sets:
        line += ["--set", entry]
    return line


def start(folder, *options, ranks=1, sets=(), **how):
    with open("screen.txt", "a") as screen:
        return subprocess.Popen(command(folder, *options, ranks=ranks, sets=sets), stdout=screen,
                                stderr=subprocess.STDOUT, start_new_session=True, **how)


def run(folder, *options, ranks=1, sets=(), **how):
    """Exit code and what was written on the screen."""
    done = subprocess.run(command(folder, *options, ranks=ranks, sets=sets), stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, start_new_session=True, **how)
    return done.returncode, done.stdout


def copy(base, name):
    folder = os.path.abspath(name)
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(base, folder)
    return folder


def states_of(folder):
    """The bytes of the saved states."""
    found = {}
    for path in glob.glob(os.path.join(folder, "checkpoint*")):
        with open(path, "rb") as file:
            found[os.path.basename(path)] = file.read()
    return found


# --- looking at what is there ---------------------------------------------------------------------

def largest_difference(one, other):
    """Largest relative difference of the figures and its name; the energy error is relative in itself."""
    a, b = summary_of(one), summary_of(other)
    return max((abs(a[key] - b[key]) / (1 if key == "energy_error" else abs(a[key])), key) for key in FIGURES)


def in_own_mounts():
    """Starts the script anew where it may mount, so that nothing of it is left behind."""
    if os.geteuid() != 0:
        skip("only root can mount the small disk of this test")
    if os.environ.get("NOTHING_LOST_MOUNTS") == "own":
        return
    if subprocess.run(["unshare", "-m", "mount", "-t", "tmpfs", "tmpfs", "/mnt"],
                      stderr=subprocess.DEVNULL).returncode != 0:
        skip("no mounts are allowed here")
    os.environ["NOTHING_LOST_MOUNTS"] = "own"
    os.execvp("unshare", ["unshare", "-m", sys.executable, *sys.argv])


def mount(folder, size):
    os.makedirs(folder, exist_ok=True)
    subprocess.run(["mount", "-t", "tmpfs", "-o", "size=" + size, "tmpfs", folder], check=True)


# --- the tests ------------------------------------------------------------------------------------

def interrupt():
    """SIGUSR1, as the launcher sends it for Ctrl-C, and SIGTERM to one process: saved, with exit code 3."""
    alone = os.path.abspath("alone")
    shutil.rmtree(alone, ignore_errors=True)
    process = start(alone)
    wait_for(os.path.join(alone, "checkpoint.json"), "checkpoint_1.h5", process)
    process.send_signal(signal.SIGTERM)
    check(process.wait() == 3, "a process that is asked to end does so with exit code 3")
    check(summary_of(alone)["stopped_because"] == "interrupted", "and has saved its run")
    folder = os.path.abspath("base")
    shutil.rmtree(folder, ignore_errors=True)
    process = start(folder, ranks=2)
    reached = wait_for(os.path.join(folder, "checkpoint.json"), "checkpoint_1.h5", process)
    check(reached, "two states are saved")
    process.send_signal(signal.SIGUSR1)
    check(process.wait() == 3, "an interrupted run ends with exit code 3")
    summary = summary_of(folder)
    check(summary["finished"] is False and summary["stopped_because"] == "interrupted", "its summary says so")
    check(0 < summary["time_steps"] < 397, f"after {summary['time_steps']} of 397 steps")
    with open(os.path.join(folder, "checkpoint.json")) as file:
        newest = json.load(file)["states"][0]
    check(newest["time_steps"] == summary["time_steps"] and newest["ranks"] == 2, "that step is saved")
    check_files(folder, "interrupted")


def resume(base):
    """On as many ranks the same figures bit for bit, on others up to round-off."""
    folders = {}
    for ranks in (2, 1, 3):
        folders[ranks] = copy(base, f"resumed_{ranks}")
        code, text = run(folders[ranks], "--resume", ranks=ranks)
        check(code == 0, f"resumed on {ranks} ranks")
        told = (f"warning: the state was saved by 2 ranks and goes on with {ranks}: results agree up to the growth of "
                "round-off\n")
        check((told in text) == (ranks != 2), "another number of ranks is told")
        check_files(folders[ranks], f"{ranks} ranks")
    for ranks in (1, 3):
        difference, name = largest_difference(folders[2], folders[ranks])
        check(difference < 1e-9, f"{ranks} ranks against 2: largest difference {difference:.1e} ({name})")


def limit(base):
    """A run that stops by itself leaves its last good state and says why; what cannot help is not offered."""
    folder = copy(base, "limit")
    sets = ["Run/Energy limit = 1e-9"]
    code, text = run(folder, "--resume", sets=sets)
    check(code == 2 and "error: the run stopped: the energy balance is off by" in text, "exit code 2 and a sentence")
    check("--resume\n" not in text and "would stop there again: take a smaller Run/Time step factor" in text,
          "the command that would stop again is not offered")
    summary = summary_of(folder)
    check(summary["finished"] is False and "energy balance" in summary["stopped_because"], "the summary says why")
    check_files(folder, "stopped")
    check(os.path.exists(os.path.join(folder, "checkpoint.json")), "its last good state is there")
    saved = states_of(folder)
    code, text = run(folder, "--resume", sets=sets)
    check(code == 1 and "would stop there again" in text and "start anew with --overwrite" in text,
          "the same again is refused")
    code, text = run(folder, sets=sets)
    check(code == 1 and "(it stopped since the energy balance" in text and "Give --overwrite to start anew" in text,
          "a new start is told of the saved state")
    check(states_of(folder) == saved, "which is as it was")
    check(run(folder, "--resume")[0] == 0, "with the larger limit it goes on to its end")


def unfinished(base):
    """A new start in the folder of an unfinished run does not cost its saved states."""
    folder = copy(base, "unfinished")
    saved = states_of(folder)
    code, text = run(folder)
    check(code == 1 and "the folder holds a run that has not finished, saved at" in text, "refused, with exit code 1")
    check("Give --resume to go on with it, --overwrite to start anew, or choose another" in text, "it says what to do")
    check(states_of(folder) == saved, "the saved states are as they were")
    check("run.lock" not in os.listdir(folder), "and no lock is left behind")


def together(base):
    """Two runs in one folder: the second is refused, and a killed one holds nobody up."""
    folder = copy(base, "together")
    process = start(folder, "--resume")
    lock = os.path.join(folder, "run.lock")
    check(wait_for(lock, '"boot"', process), "a run at work holds its folder")
    os.kill(process.pid, signal.SIGSTOP)  # else it may end before the others have tried
    holder = f"another run works in this folder, process {process.pid} on {socket.gethostname()}. Wait for its end"
    for options in ([], ["--overwrite"], ["--resume"]):
        code, text = run(folder, *options)
        check(code == 1 and holder in text, f"a second run is refused with {options or 'no option'}")
    check(process.poll() is None, "the first one is still at work")
    kill(process)
    check(os.path.exists(lock), "a killed run leaves its lock behind")
    code, text = run(folder, "--resume")
    check(code == 0 and summary_of(folder)["finished"], "which the next one takes over")
    check(not os.path.exists(lock), "and removes at its end")
    check_files(folder, "taken over")


def lines(base):
    """Screen and errors in one pipe: every line is written whole, at once. The pipe keeps the calls of write() apart."""
    folder = copy(base, "lines")
    ends = os.pipe2(os.O_DIRECT)
    process = subprocess.Popen(command(folder, "--resume", sets=["Run/Energy limit = 1e-9"]), stdout=ends[1],
                               stderr=ends[1])
    os.close(ends[1])
    writes = []
    while piece := os.read(ends[0], 1 << 16):
        writes.append(piece.decode())
    check(process.wait() == 2 and any(piece.startswith("error: ") for piece in writes), "a run with an error")
    torn = [piece for piece in writes if piece.count("\n") != 1 or not piece.endswith("\n")]
    check(len(writes) > 20 and not torn, f"{len(writes)} lines by as many calls of write() {torn[:3] or ''}")


def title():
    """Long texts are refused before anything is computed."""
    folder = os.path.abspath("title")
    code, text = run(folder, sets=["Title = " + "x" * 100000])
    check(code == 1 and "too long, 100000 characters; at most 200 are accepted" in text, "a title of 100 000 characters")
    check(len(text) < 1000 and not os.path.exists(folder), "is refused in a short sentence, and no folder is made")


def disk(base):
    in_own_mounts()
    # no room at all: nothing is made
    place = os.path.abspath("full")
    mount(place, "64k")
    filler = os.open(os.path.join(place, "filler"), os.O_WRONLY | os.O_CREAT)
    try:
        while True:
            os.write(filler, bytes(4096))
    except OSError:
        os.close(filler)
    code, text = run(os.path.join(place, "run"))
    check(code == 1 and "No space left on device" in text and "error: " in text, "full disk: exit code 1 and why")
    check(os.listdir(place) == ["filler"], "full disk: no folder is left")

    # room for a part: what is there is whole, and the run goes on once there is more
    place = os.path.abspath("small")
    size = sum(os.path.getsize(path) for path in glob.glob(os.path.join(base, "*"))) // 1024
    mount(place, f"{size + 600}k")
    folder = copy(base, os.path.join(place, "run"))
    code, text = run(folder, "--resume")
    check(code == 2 and "No space left on device. Free some space" in text, "a disk that fills up: exit code 2 and why")
    check_files(folder, "a disk that fills up")
    summary = summary_of(folder)
    check(summary["finished"] is False and summary["stopped_because"] != "", "the summary does not say finished")
    subprocess.run(["mount", "-o", "remount,size=100m", place], check=True)
    code, text = run(folder, "--resume")
    check(code == 0 and summary_of(folder)["finished"] is True, "with more room it goes on to the end")
    check_files(folder, "after that")

    # read-only
    place = os.path.abspath("read_only")
    mount(place, "1m")
    subprocess.run(["mount", "-o", "remount,ro", place], check=True)
    code, text = run(os.path.join(place, "run"))
    check(code == 1 and "Read-only file system" in text and "may write" in text, "read-only: exit code 1 and why")
    check(os.listdir(place) == [], "read-only: no folder is left")


def rights():
    """A folder in which the user may not write."""
    place = os.path.abspath("foreign")
    os.makedirs(place, exist_ok=True)
    how = {}
    if os.geteuid() == 0:
        how = {"user": 65534, "group": 65534, "extra_groups": []}
        if subprocess.run([PROGRAM, "version"], stdout=subprocess.DEVNULL, **how).returncode != 0:
            skip("the program cannot be started by another user here")
    else:
        os.chmod(place, 0o555)
    code, text = run(os.path.join(place, "run"), **how)
    check(code == 1 and "Permission denied" in text and "may write" in text, "no rights: exit code 1 and why")
    check(os.listdir(place) == [], "no rights: no folder is left")


def kills(base):
    """kill -9 at random moments: a resumed run ends like one that was not killed."""
    draw = random.Random(2017)
    one_go = copy(base, "one_go")
    begin = time.time()
    check(run(one_go, "--resume", ranks=2)[0] == 0, "the run that is not killed")
    length = time.time() - begin
    cut = 0
    for k in range(17):
        folder = copy(base, "killed")
        process = start(folder, "--resume", ranks=2)
        moment = draw.uniform(0, length)
        time.sleep(moment)
        cut += process.poll() is None
        kill(process)
        if not summary_of(folder)["finished"]:
            code, text = run(folder, "--resume", ranks=2)
            check(code == 0, f"kill {k} after {moment:.2f} s: resumed")
        difference, name = largest_difference(one_go, folder)
        check(difference == 0, f"kill {k}: the same figures bit for bit ({difference:.1e}, {name})")
        check_files(folder, f"kill {k}")
    check(cut >= 10, f"{cut} of 17 runs were killed before their end")
    fresh_kills(draw)


def fresh_kills(draw, count=3, sets=(), earliest=0.2):
    """The same from the very start: the static start is computed anew when no state was saved."""
    one_go = os.path.abspath("fresh_one_go")
    begin = time.time()
    code, text = run(one_go, "--overwrite", ranks=2, sets=sets)
    check(code == 0, "a run from the start")
    length = time.time() - begin
    for k in range(count):
        folder = os.path.abspath("fresh_killed")
        shutil.rmtree(folder, ignore_errors=True)
        process = start(folder, ranks=2, sets=sets)
        moment = draw.uniform(earliest, 0.95) * length
        time.sleep(moment)
        kill(process)
        options = ["--resume"] if os.path.exists(os.path.join(folder, "parameters.prm")) else []
        if not (os.path.exists(os.path.join(folder, "summary.json")) and summary_of(folder)["finished"]):
            check(run(folder, *options, ranks=2, sets=sets)[0] == 0, f"fresh kill {k} after {moment:.1f} s: gone on")
        difference, name = largest_difference(one_go, folder)
        check(difference < 1e-9, f"fresh kill {k}: the same figures, largest difference {difference:.1e} ({name})")
        check_files(folder, f"fresh kill {k}")
    return text


def changes():
    """kill -9 at 20 random moments of a path on which the fine cells move four times."""
    text = fresh_kills(random.Random(1906), 20,
                       ["Run/Rolling distance = 70 mm", "Track/Rail length = 500 mm", "Output/Ticks = 4"], earliest=0.3)
    found = re.search(r"changes of the mesh +(\d+)", text)
    check(found and int(found[1]) >= 4, "the mesh changes at least four times")


def ranks():
    """1, 2, 3 and 4 ranks from the static start on; they differ by what its solver leaves unsolved."""
    folders = {n: os.path.abspath(f"ranks_{n}") for n in (1, 2, 3, 4)}
    for n, folder in folders.items():
        check(run(folder, "--overwrite", ranks=n)[0] == 0, f"a run on {n} ranks")
    for n in (2, 3, 4):
        a, b = summary_of(folders[1]), summary_of(folders[n])
        for key in FIGURES:
            if key in ("energy_error", "normal_force_std_N"):
                continue
            difference = abs(b[key] - a[key]) / abs(a[key])
            bound = 2e-3 if key in ("creepage", "stick_fraction", "relative_roll_rad") else 2e-4
            check(difference < bound, f"{n} ranks, {key}: relative difference {difference:.1e}")


if __name__ == "__main__":
    tests = dict(interrupt=interrupt, resume=resume, limit=limit, unfinished=unfinished, together=together,
                 lines=lines, title=title, disk=disk, rights=rights, kills=kills, changes=changes,
                 ranks=ranks)
    arguments = [os.path.join(sys.argv[4], "base")] if len(sys.argv) > 4 else []
    tests[sys.argv[3]](*arguments)
    finish()
