"""Studies of the whole program: killed and gone on with, grown, with failures, held, on a full disk, of another version.

Usage: study_runs.py PROGRAM MPIEXEC WHAT

WHAT is one of the functions at the end; each works in the current folder.
"""

import csv
import glob
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import time

from checks import check, finish, small_study

PROGRAM = sys.argv[1]
SKIPPED = 77

FRICTION = "Contact/Friction coefficient: "


def skip(reason):
    print("skipped: " + reason, flush=True)
    sys.exit(SKIPPED)


def write_study(axes, compute="both", distance="6 mm"):
    """Into study.prm, with states saved all the time."""
    with open("study.prm", "w") as file:
        file.write(small_study(axes, compute=compute, distance=distance, ticks=3, more="  set Checkpoint interval = 0.1 s"))


def command(folder, *options):
    return [PROGRAM, "study", "study.prm", "--jobs", "2", "--set", "Output/Folder = " + folder, *options]


def study(folder, *options):
    """Exit code and what was written on the screen; tables alone."""
    return study_with_page(folder, "--no-pictures", *options)


def study_with_page(folder, *options):
    """The same, with the page."""
    done = subprocess.run(command(folder, *options), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return done.returncode, done.stdout


def start(folder):
    with open("screen.txt", "a") as screen:
        return subprocess.Popen(command(folder, "--no-pictures"), stdout=screen, stderr=subprocess.STDOUT)


def table(folder):
    with open(os.path.join(folder, "table.csv"), encoding="utf-8") as file:
        return list(csv.DictReader(file))


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def logs(folder):
    """How often the program was called for the cases."""
    return sum(text_of(path).count("\n> ") + 1 for path in glob.glob(os.path.join(folder, "workflow", "*.log"))
               if not path.endswith("snakemake.log"))


def fresh(*names):
    for name in names:
        shutil.rmtree(name, ignore_errors=True)


def kill():
    """kill -9 at random moments, and at last the same table; an added value computes only what is new."""
    kills = int(sys.argv[4]) if len(sys.argv) > 4 else 1
    fresh("whole", "killed")
    write_study(FRICTION + "0.3, 0.5")
    code, text = study("whole", "--dry-run")
    check(code == 0 and "2 cases, 2 to compute" in text and "friction coefficient 0.5" in text, "a dry run tells the cases")
    check(not os.path.exists("whole"), "and makes nothing")
    begin = time.time()
    code, text = study("whole")
    takes = time.time() - begin
    check(code == 0, f"a study of two cases in {takes:.0f} s {text[-500:] if code else ''}")
    rows = table("whole")
    check([row["Friction coefficient"] for row in rows] == ["0.3", "0.5"], "one row a case, in their order")
    check(all(float(row["peak pressure [MPa]"]) > 500 and float(row["peak pressure, half-spaces [MPa]"]) > 500
              for row in rows), "runs and half-spaces beside each other")
    check("0 of 2 done" in text and "2 of 2 done, 0 running, 0 failed" in text, "the screen tells how far it is")

    generator = random.Random(5)
    for number in range(kills):
        process = start("killed")
        time.sleep(generator.uniform(0, takes))
        process.send_signal(signal.SIGKILL)
        process.wait()
    code, text = study("killed")
    check(code == 0, f"goes on after kill -9, {kills} times {text[-500:] if code else ''}")
    check(text_of("killed/table.csv") == text_of("whole/table.csv"), "and gives the same table")

    calls = logs("whole")
    begin = time.time()
    code, text = study("whole")
    check(code == 0 and "2 cases, 0 to compute" in text, f"nothing is computed again, in {time.time() - begin:.1f} s")
    write_study(FRICTION + "0.5, 0.35, 0.3")
    code, text = study_with_page("whole")
    check(code == 0 and "3 cases, 1 to compute" in text and logs("whole") == calls + 2, "an added value computes only itself")
    after = {row["Friction coefficient"]: row for row in table("whole")}
    check(list(after) == ["0.5", "0.35", "0.3"] and all(after[row["Friction coefficient"]] == row for row in rows),
          "the others are as they were")
    page = text_of("whole/study.html")
    check(page.count("data:image/png;base64,") > 5 and "http:" not in page, "the page holds its pictures itself")
    check("Cases side by side" in page and all(os.path.exists(f"whole/pictures/family_{name}.png")
                                               for name in ("shear", "cut_aa")), "all cases side by side")


def failures():
    """A case that fails is recorded with its sentence while the others go on; it is tried again, the others are not."""
    fresh("failures")
    write_study("Profiles/Rail: 54E1, missing.prr, 60E1; Wheelset/Lateral shift: 1 mm, 1 mm, 2 mm\n  set Combine = pairs",
                "halfspace")
    for call in ("first", "second"):
        code, text = (study if call == "first" else study_with_page)("failures")
        check(code == 2 and "missing.prr: no such file" in text, f"the {call} call says what failed")
        check(f"3 cases, {3 if call == 'first' else 1} to compute" in text, f"the {call} call computes what is open")
        rows = table("failures")
        check([row["state"] for row in rows] == ["finished", "failed", "finished"], "two are finished, one failed")
        check("missing.prr: no such file" in rows[1]["remark"], "the table says why")
    check("missing.prr: no such file" in text_of("failures/study.html"), "so does the page")
    check([row["Lateral shift [mm]"] for row in rows] == ["1", "1", "2"], "units are in the header")


def limit():
    """A run that stops by a limit is recorded with its sentence and not computed again."""
    fresh("limit")
    write_study("Run/Energy limit: 1e-9, 0.02", "run")
    code, text = study("limit")
    rows = table("limit")
    check(code == 2 and [row["state"] for row in rows] == ["stopped", "finished"], "one stops, one goes to its end")
    check("energy balance" in rows[0]["remark"] and "energy balance" in text, "table and screen say why")
    calls = logs("limit")
    code, text = study("limit")
    check(code == 2 and "2 cases, 0 to compute" in text and logs("limit") == calls, "nothing is computed again")


def together():
    """Two studies in one folder: the second is refused. A run's folder is none of a study."""
    fresh("together", "run")
    write_study(FRICTION + "0.3, 0.4", distance="20 mm")
    for number in (signal.SIGINT, signal.SIGTERM):
        process = start("together")
        while process.poll() is None and "study.py" not in text_of(f"/proc/{process.pid}/cmdline"):
            time.sleep(0.001)
        process.send_signal(number)
        check(process.wait() == 3, f"signal {number} while the script begins ends it with exit code 3")
    process = start("together")
    end = time.time() + 60
    while not os.path.exists("together/workflow/plan.json") and time.time() < end:
        time.sleep(0.02)
    process.send_signal(signal.SIGSTOP)  # else it may end before the other has tried
    code, text = study("together")
    check(code == 1 and f"a study is at work in together, process {process.pid} on" in text and
          "wait for its end or choose another Output/Folder" in text, "a second study is refused")
    process.send_signal(signal.SIGCONT)
    process.send_signal(signal.SIGINT)
    check(process.wait() == 3, "Ctrl-C ends a study with exit code 3")
    code, text = study("together")
    check(code == 0, "the same command goes on")

    os.makedirs("run")
    with open("run/parameters.prm", "w") as file:
        file.write("# of a run\n")
    code, text = study("run")
    check(code == 1 and "run holds a run; set an Output/Folder for the study, such as run_study" in text,
          "the folder of a run is refused")
    for options, sentence in ((("--ranks", "x"), "--ranks x: a positive whole number is needed, such as --ranks 2"),
                              (("--profile", "no_such_profile"), "Snakemake ended with code")):
        write_study(FRICTION + "0.6", "halfspace")
        code, text = study("together", *options)
        check(code != 0 and sentence in text and "Traceback" not in text, f"{' '.join(options)}: {text[-200:]!r}")


def paths():
    """Folders with signs that mean something to Snakemake, its YAML, the shell or parameter files."""
    for start, folder in (("at: b #c {d} {{e 'f' $HOME", "out {g}: h [i], 'j' $HOME"), ("plain", "{out}")):
        fresh(start)
        os.makedirs(start)
        os.chdir(start)
        write_study(FRICTION + "0.3", "halfspace")
        code, text = study(folder)
        check(code == 0 and sorted(os.listdir(".")) == sorted([folder, "study.prm"]),
              f"a study from {start} into {folder}: {text[-300:] if code else os.listdir('.')}")
        rows = table(folder)
        of_case = json.loads(text_of(os.path.join(folder, rows[0]["folder"] + "-halfspace", "summary.json")))
        told = [float(rows[0][f"peak pressure, {who} [MPa]"]) for who in ("true bodies", "half-spaces")]
        check(rows[0]["state"] == "finished" and
              all(abs(1e6 * value / of_case[key] - 1) < 1e-6 for value, key in zip(told, ("max_pressure_Pa", "halfspace_max_pressure_Pa"))),
              f"has its figures, each under its name: {told}")
        code, text = study(folder)
        check(code == 0 and "0 to compute" in text, "and is found again")
        os.chdir("..")


def version():
    """Cases of another version stay, are told, and are computed anew."""
    fresh("version")
    write_study(FRICTION + "0.3", "halfspace")
    check(study("version")[0] == 0, "a study of one case")
    (record,) = [path for path in glob.glob("version/workflow/*.json") if not path.endswith("plan.json")]
    old = json.loads(text_of(record))
    old["program_version"] = "0.0.9"
    # as that version would have named it
    other = record.replace(record[-13:-5], "0123abcd")
    with open(other, "w") as file:
        json.dump(old, file)
    os.remove(record)
    code, text = study("version")
    check(code == 0 and "1 case, 1 to compute" in text and
          "note: version holds 1 case computed by version 0.0.9; they stay as they are, and version" in text,
          "another version computes its own, and says so")
    check(json.loads(text_of(other)) == old, "what was there stays")


def disk():
    """A disk that is full: a sentence, nothing lost, and the same command goes on when there is room."""
    if os.geteuid() != 0:
        skip("only root can mount the small disk of this test")
    if os.environ.get("STUDY_MOUNTS") != "own":
        if subprocess.run(["unshare", "-m", "mount", "-t", "tmpfs", "tmpfs", "/mnt"],
                          stderr=subprocess.DEVNULL).returncode != 0:
            skip("no mounts are allowed here")
        os.environ["STUDY_MOUNTS"] = "own"
        os.execvp("unshare", ["unshare", "-m", sys.executable, *sys.argv])
    os.makedirs("small", exist_ok=True)
    subprocess.run(["mount", "-t", "tmpfs", "-o", "size=700k", "tmpfs", "small"], check=True)
    write_study(FRICTION + "0.3, 0.4, 0.5", "halfspace")
    code, text = study("small/study")
    check(code == 2 and "No space left on device" in text and "Traceback" not in text, f"a full disk: {text[-300:]!r}")
    check(": failed: The output file" in text, "a case says why it failed")
    subprocess.run(["mount", "-o", "remount,size=200m", "small"], check=True)
    code, text = study("small/study")
    check(code == 0 and [row["state"] for row in table("small/study")] == ["finished"] * 3, "with room it goes on to the end")


if not shutil.which("snakemake"):
    skip("snakemake is not installed")
{f.__name__: f for f in (kill, failures, limit, together, paths, version, disk)}[sys.argv[3]]()
finish()
