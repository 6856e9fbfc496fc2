"""The launcher `wheelrail`, in a checkout of its own whose program is the one under test and whose cmake, ctest, mpirun and
dpkg-query are stand-ins, so that nothing is built, installed or computed for long.

Usage: launcher.py PROGRAM MPIEXEC WHAT

WHAT is one of the functions at the end; each works in the current folder.
"""

import fcntl
import os
import shlex
import shutil
import subprocess
import sys
import time

from checks import check, finish

PROGRAM = os.path.abspath(sys.argv[1])
SOURCES = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PLACE = os.path.abspath(sys.argv[3])
CHECKOUT, TOOLS, ELSEWHERE = (os.path.join(PLACE, name) for name in ("checkout", "tools", "elsewhere"))
LAUNCHER = "../checkout/wheelrail"  # from ELSEWHERE
COARSE = ["--no-pictures", "--set", "Half-space/Element size = 2 mm", "--set", "Output/Folder = out"]

STAND_INS = {
    "cmake": f'[ "$1" = --build ] || touch "{CHECKOUT}/build/CMakeCache.txt" "{CHECKOUT}/build/build.ninja"',
    "ctest": 'echo "ctest $*"',
    "dpkg-query": 'for package in "${@:4}"; do echo "$package install ok installed"; done',
    "lscpu": 'printf "0,0\\n1,0\\n"',
    "mpirun": 'echo "mpirun $*"',
    "nproc": "echo 2",
}


def write_program(name, lines):
    path = os.path.join(TOOLS, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write("#!/bin/bash\n" + lines + "\n")
    os.chmod(path, 0o755)


def prepare():
    """The checkout, the stand-ins, and an empty folder to call from."""
    shutil.rmtree(PLACE, ignore_errors=True)
    for folder in (os.path.join(CHECKOUT, "build"), TOOLS, ELSEWHERE):
        os.makedirs(folder)
    shutil.copy(os.path.join(SOURCES, "wheelrail"), CHECKOUT)
    os.symlink(PROGRAM, os.path.join(CHECKOUT, "build", "wheelrail"))
    os.symlink(os.path.join(SOURCES, "prm"), os.path.join(CHECKOUT, "prm"))
    for name in ("include/new.h", "source/old.cc"):
        os.mkdir(os.path.dirname(path := os.path.join(CHECKOUT, name)))
        with open(path, "w", encoding="utf-8"):
            os.utime(path, (1e9, 1e9))
    for name, lines in STAND_INS.items():
        write_program(name, lines)


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def skip(reason):
    print("skipped: " + reason, flush=True)
    sys.exit(77)


def environment():
    own = {key: value for key, value in os.environ.items() if not key.startswith("OMP_")}
    return {**own, "PATH": TOOLS + ":" + os.environ["PATH"]}


def call(*words, folder=ELSEWHERE, launcher=LAUNCHER, **how):
    """Exit code, screen and errors of a call."""
    done = subprocess.run([launcher, *words], capture_output=True, text=True, cwd=folder, env=environment(), **how)
    return done.returncode, done.stdout, done.stderr


def left_behind():
    """What lies in the folder of the call, which is emptied."""
    names = sorted(os.listdir(ELSEWHERE))
    shutil.rmtree(ELSEWHERE)
    os.mkdir(ELSEWHERE)
    return names


def in_shell(script):
    """What the launcher's functions print: a script that reads it."""
    done = subprocess.run(["bash", "-c", f"source {LAUNCHER}\n{script}"], capture_output=True, text=True, cwd=ELSEWHERE,
                          env=environment())
    return done.stdout.strip(), done.stderr


# --- the tests ------------------------------------------------------------------------------------

# two lines of /proc/stat, one after the other: user nice system idle iowait irq softirq steal
TIMES = {
    "free": ("100 0 20 1000 0 0 0 0", "101 0 20 1099 0 0 0 0", 4),
    "half busy": ("100 0 20 1000 0 0 0 0", "148 0 22 1050 0 0 0 0", 2),
    "busy": ("100 0 20 1000 0 0 0 0", "195 0 25 1000 0 0 0 0", 0),
    "busy with work of low priority": ("100 0 20 1000 0 0 0 0", "100 99 21 1000 0 0 0 0", 4),
    "waiting for its disk": ("100 0 20 1000 50 0 0 0", "100 0 20 1000 150 0 0 0", 4),
    "one that does not count": ("100 0 20 1000 0 0 0 0", "100 0 20 1000 0 0 0 0", 4),
}


def ranks():
    """No more ranks than free processors, without a word that is not meant and without a file."""
    for name, (before, after, free) in TIMES.items():
        told, errors = in_shell(f"""processors() {{ echo 4; }}
            sleep() {{ :; }}
            processor_times() {{ [ -e second ] && echo "cpu  {after}" || echo "cpu  {before}"; touch second; }}
            free_processors; rm second""")
        check(told == str(free) and errors == "", f"a machine that is {name}: {told} of 4 processors free {errors}")
        check(left_behind() == [], "and no file is left")
    told, errors = in_shell("processor_times() { return 1; }; free_processors")
    check(told == "2" and errors == "", f"without /proc/stat all count as free: {told} {errors}")

    # on the machine as it is, which may be at work
    code, screen, errors = call("run", "../checkout/prm/quickstart.prm")
    note = "note: the machine is at other work: 1 of 2 processes are started (--ranks 2 starts all)\n"
    busy = note in errors
    check(code == 0 and errors.replace(note, "").startswith("building the program, once"), f"run: {errors!r}")
    check(f"-n {1 if busy else 2} " in screen, f"without --ranks as many as are free: {screen!r}")
    check(left_behind() == [], "and no file is left")
    for share, started in (("free", 2), ("busy", 1)):
        before, after, _ = TIMES[share]
        write_program("grep", f"""if [ "$*" = "^cpu  /proc/stat" ]; then
              if [ -e {PLACE}/second ]; then echo "cpu  {after}"; else echo "cpu  {before}"; fi
              touch {PLACE}/second
            else exec /usr/bin/env PATH=/usr/bin:/bin grep "$@"; fi""")
        code, screen, errors = call("run", "../checkout/prm/quickstart.prm")
        os.remove(os.path.join(PLACE, "second"))
        check(code == 0 and errors == (note if started == 1 else ""), f"a {share} machine of two cores: {errors!r}")
        check(f"-n {started} " in screen and left_behind() == [], f"starts {started}, and leaves no file: {screen!r}")


def building():
    """A call waits while another one builds, and says so."""
    call("build")
    with open(os.path.join(CHECKOUT, "build", "lock"), "a", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        second = subprocess.Popen([LAUNCHER, "build"], cwd=ELSEWHERE, env=environment(), stderr=subprocess.PIPE, text=True)
        told = second.stderr.readline()
    _, errors = second.communicate()
    check(second.returncode == 0 and errors == "" and
          told == "another call of wheelrail builds the program; waiting for its end\n", f"it waits: {told!r} {errors!r}")


def install():
    """Two calls that both need packages, while another program holds apt's lists: one installs, all wait, the log is kept."""
    installed, log = os.path.join(PLACE, "installed"), os.path.join(CHECKOUT, "build", "install.log")
    os.mkdir(installed)
    write_program("dpkg-query", f'''for package in "${{@:4}}"; do
        [ ! -e "{installed}/$package" ] || echo "$package install ok installed"
        done''')
    write_program("sudo", 'exec "$@"')
    write_program("apt-get", f"""echo "apt-get $*"
        case "$*" in
          *update) [ -e "{PLACE}/free" ] && exit 0
            touch "{PLACE}/free"
            echo "E: Could not get lock /var/lib/apt/lists/lock. It is held by process 12 (apt-get)"
            exit 100 ;;
          *) sleep 1; for word in "$@"; do case $word in -* | install) ;; *) : >"{installed}/${{word##*/}}" ;; esac; done ;;
        esac""")
    with open(log, "w", encoding="utf-8") as file:
        file.write("of an earlier call\n")
    first = subprocess.Popen([LAUNCHER, "build"], cwd=ELSEWHERE, env=environment(), stderr=subprocess.PIPE, text=True)
    while "apt-get -o" not in text_of(log):
        time.sleep(0.05)
    code, _, errors = call("build")
    check(code == 0 and errors.startswith("another call of wheelrail installs packages; waiting for its end\n") and
          "installing" not in errors, f"the second call waits: {errors!r}")
    _, errors = first.communicate()
    check(first.returncode == 0 and "installing g++ cmake" in errors and
          "another program installs packages on this machine; waiting for its end\n" in errors, f"so does the first: {errors!r}")
    text = text_of(log)
    check(text.startswith("of an earlier call\n") and text.count("update") == 2 and text.count(" install ") == 1,
          f"the log has it all: {text!r}")

    os.remove(os.path.join(installed, "cmake"))
    write_program("apt-get", "echo E: Unable to locate package; exit 100")
    code, _, errors = call("build")
    check(code == 2 and errors == "installing cmake (log: build/install.log)\nE: Unable to locate package\n"
          "error: apt-get update failed; is there a network?\n",
          f"other faults end the call: {errors!r}")
    check(text_of(log).startswith(text), "and the log goes on")


def rights():
    """A user who may not write into the checkout runs the program that is built."""
    program, source = os.path.join(CHECKOUT, "build", "wheelrail"), os.path.join(CHECKOUT, "include", "new.h")
    how = {}
    if os.geteuid() == 0:
        how = {"user": 65534, "group": 65534, "extra_groups": []}
        os.chmod(ELSEWHERE, 0o777)
        if subprocess.run([PROGRAM, "version"], stdout=subprocess.DEVNULL, **how).returncode != 0:
            skip("the program cannot be started by another user here")
    check(call("build")[0] == 0, "the program is built by who may")
    if os.geteuid() != 0:
        for folder in (CHECKOUT, os.path.join(CHECKOUT, "build")):
            os.chmod(folder, 0o555)
    scene = "../checkout/prm/rolling.prm"
    write_program("dpkg-query", "exit 1")  # what building needs is not asked for
    for words in (["parameters", scene], ["run", scene, "--validate"], ["run", scene, "--ranks", "1"],
                  ["study", "../checkout/prm/studies/friction.prm", "--dry-run"]):
        code, _, errors = call(*words, **how)
        check(code == 0 and errors == "", f"{' '.join(words)}: exit code {code} {errors!r}")
    code, _, errors = call("compare", "nowhere", **how)
    check(code == 2 and "packages are missing" in errors and "xvfb" in errors, f"what else is missing is told: {errors!r}")
    build = os.path.join(CHECKOUT, "build")
    for command in ("build", "test"):
        code, _, errors = call(command, **how)
        check(code == 2 and errors == f"error: you may not write to {build}, so nothing can be built; who may calls: "
              f"{LAUNCHER} build\n", f"{command}: {errors!r}")

    os.utime(source, (2e9, 2e9))
    code, _, errors = call("parameters", scene, **how)
    check(code == 0 and errors == "note: include/new.h is newer than the program, which runs as it is, since you may not "
          f"write to {build}; who may calls: {LAUNCHER} build\n", f"newer sources: {errors!r}")
    if os.geteuid() != 0:
        os.chmod(build, 0o755)
    os.remove(program)
    if os.geteuid() != 0:
        os.chmod(build, 0o555)
    code, _, errors = call("parameters", scene, **how)
    check(code == 2 and errors == f"error: the program is not built, and you may not write to {build}; who may calls: "
          f"{LAUNCHER} build\n", f"no program: {errors!r}")
    if os.geteuid() != 0:
        for folder in (CHECKOUT, build):
            os.chmod(folder, 0o755)


def hints():
    """Commands in messages work where they are read; another Python, first in the path, is not in the way."""
    def hint(*words, after):
        code, _, errors = call(*words)
        check(code == 1 and after in errors, f"{' '.join(words)}: {errors!r}")
        return shlex.split(errors.split(after)[-1])

    def works(words, *more):
        done = subprocess.run([*words, *more], capture_output=True, text=True, cwd=ELSEWHERE, env=environment())
        check(done.returncode == 0, f"{' '.join(words)}: exit code {done.returncode} {done.stderr!r}")

    call("build")
    works(hint("run", "--validate", after="such as "), "--validate")
    check(hint("halfspace", after="such as ")[1:] == ["halfspace", "../checkout/prm/rolling.prm"], "a scene for halfspace")
    works(hint("material", after="such as "), *COARSE)
    works(hint("study", after="such as "), "--dry-run")
    vehicle = hint("vehicle", "../checkout/prm/rolling.prm", after="such as ")
    check(os.path.exists(os.path.join(ELSEWHERE, vehicle[-1])), "a table of rows that is there")
    works(hint("halfspace", "../checkout/prm/studies/friction.prm", after="Axes is set; ")[:3], "--dry-run")
    works(hint("run", "--validate", "a.prm", "--overwrit", after="is meant; ")[0].split())
    left_behind()

    # from the folder itself, and by a link in the path
    _, _, errors = call("run", "--validate", folder=CHECKOUT, launcher="./wheelrail")
    check("such as ./wheelrail run prm/rolling.prm\n" in errors, f"from the folder itself: {errors!r}")
    link = os.path.join(TOOLS, "wheelrail")
    os.symlink(os.path.join(CHECKOUT, "wheelrail"), link)
    _, _, errors = call("run", "--validate", launcher="wheelrail")
    check(f"such as {link} run {CHECKOUT}/prm/rolling.prm\n" in errors, f"by a link: {errors!r}")
    _, screen, _ = call("help")
    check(f"\n  {LAUNCHER} run ../checkout/prm/quickstart.prm  " in screen and "./wheelrail" not in
          screen.replace(LAUNCHER, ""), "help has them, too")

    subprocess.run(["/usr/bin/python3", "-m", "venv", "--without-pip", os.path.join(PLACE, "venv")], check=True)
    os.symlink(os.path.join(PLACE, "venv", "bin", "python3"), os.path.join(TOOLS, "python3"))
    code, _, errors = call("study", "../checkout/prm/studies/friction.prm", "--dry-run")
    check(code == 0 and errors == "", f"study in a virtual environment {errors!r}")
    code, _, errors = call("report", ".")
    check(code == 1 and "summary.json" in errors and "No module" not in errors, f"so does report {errors!r}")
    done = subprocess.run([os.path.join(PLACE, "venv", "bin", "python3"), "-c", "import wheelrail"], capture_output=True,
                          text=True, env={**os.environ, "PYTHONPATH": os.path.join(SOURCES, "source", "report")})
    check(done.returncode == 1 and "No module named 'h5py'; the virtual environment" in done.stderr and
          "hides Debian's packages: leave it (deactivate) and start your script by /usr/bin/python3" in done.stderr and
          "install the Debian package" not in done.stderr, f"the module says what hides h5py: {done.stderr!r}")


def commands():
    """Every command once from another folder: its exit code, nothing on stderr, and only its own files there."""
    with open(os.path.join(PLACE, "rows.csv"), "w", encoding="utf-8") as file:
        file.write("distance [m],lateral shift [mm]\n0,0\n1,0.5\n")
    scene = "../checkout/prm/rolling.prm"
    code, screen, errors = call("build")
    check(code == 0 and errors == "building the program, once (log: build/build.log)\n", f"build, the first call: {errors!r}")
    check(left_behind() == [], "and leaves nothing")
    calls = [
        ([], 0, "wheelrail computes how", []),
        (["help"], 0, "wheelrail computes how", []),
        (["--help"], 0, "wheelrail computes how", []),
        (["version"], 0, "wheelrail", []),
        (["build"], 0, "", []),
        (["test", "-R", "input"], 0, "ctest --output-on-failure -j 2 -LE long -R input", []),
        (["test", "--all"], 0, "ctest --output-on-failure -j 2\n", []),
        (["run", "--help"], 0, "--ranks", []),
        (["build", "--help"], 0, "wheelrail computes how", []),
        (["run", scene, "--validate"], 0, "all entries are valid", []),
        (["run", scene, "--ranks", "1"], 0, "-n 1 ", []),
        (["geometry", scene, "--shifts", "0"], 0, "contact", []),
        (["halfspace", scene, *COARSE], 0, "out-halfspace", ["out-halfspace"]),
        (["vehicle", scene, "../rows.csv", *COARSE], 0, "2 rows", ["out-vehicle"]),
        (["material", scene, "--no-pictures", "--set", "Output/Folder = out", "--set", "Material test/Axial = 0.001"], 0, "",
         ["out-material"]),
        (["contact", os.path.join(SOURCES, "tests/contact_files/basic.inp"), "--case", "1"], 0,
         "Tables in output/basic-contact", ["output"]),
        (["parameters", scene], 0, "subsection Contact", []),
        (["study", "../checkout/prm/studies/friction.prm", "--dry-run"], 0, "to compute", []),
        (["compare", "nowhere"], 1, "nowhere: no such folder", []),
        (["report", "nowhere"], 1, "nowhere: no such folder", []),
        (["no_command"], 1, "version, test, build and help", []),
    ]
    for words, expected, said, files in calls:
        code, screen, errors = call(*words)
        name = " ".join(words) or "no command"
        check(code == expected and said in screen + errors, f"{name}: exit code {code} {errors!r}")
        check((errors == "") == (expected == 0), "with words on stderr only where there is a fault")
        check((names := left_behind()) == files, f"it leaves {names or 'nothing'}")
    for tool in ("cmake", "dpkg-query"):
        write_program(tool, "sleep 9; exit 9")
    for words in (["run", "--help"], ["compare", "--help"], ["help", "study"], ["--version"], ["version"]):
        code, screen, errors = call(*words, timeout=5)
        check(code == 0 and screen and errors == "", f"{' '.join(words)} waits for no tool: exit code {code} {errors!r}")


prepare()
{f.__name__: f for f in (ranks, building, install, rights, hints, commands)}[sys.argv[3]]()
finish()
