"""The core builds alone: configured without the optional subjects it has none of their files, and what it calls of
them stands in source/without.

Usage: core_alone.py PROGRAM MPIEXEC CMAKE SOURCE_FOLDER BUILD_FOLDER
"""

import json
import os
import re
import shlex
import subprocess
import sys

from checks import check, finish

CMAKE, SOURCE, BUILD = sys.argv[3:6]
SUBJECTS = dict(re.findall(r"^set\(rooms_of_(\w+) (.*)\)$", open(SOURCE + "/CMakeLists.txt").read(), re.M))
LEFT_OUT = {room for rooms in SUBJECTS.values() for room in rooms.split()}


def output_of(command, **options):
    return subprocess.run(command, check=True, capture_output=True, text=True, **options).stdout


def sources_of(command):
    """The files that a command of the build compiles: those of a unit, or one."""
    included = re.findall(r'^#include "(.*\.cc)"', open(command["file"]).read(), re.M)
    return included if "/Unity/" in command["file"] else [command["file"]]


def room_of(path):
    return os.path.basename(os.path.dirname(path))


def symbols(files):
    """Pairs of object and line of nm, of archives and of objects."""
    for line in output_of(["nm", "-A", "-C", *files]).splitlines():
        place, _, symbol = line.partition(" ")
        yield place.rsplit(":", 1)[0], symbol.strip()


def room_of_object(name, rooms):
    """Objects are named after the room of their unit, or after their one file."""
    name = os.path.basename(name.rsplit(":", 1)[-1])
    unit = re.match(r"unity_([a-z]+?)(_plain)?_\d+_cxx", name)
    return unit.group(1) if unit else rooms.get(name.split(".")[0], "")


off = [f"-DWHEELRAIL_{subject}=OFF" for subject in SUBJECTS]
output_of([CMAKE, "-G", "Ninja", "-S", SOURCE, "-B", "core", *off])
commands = json.load(open("core/compile_commands.json"))
core = [c for c in commands if re.search(r"wheelrail_(core|contact)\.dir", c["command"])]
built = {source for c in core for source in sources_of(c) if "/source/" in source}
check(len(built) > 300, f"the core has {len(built)} files")
check(not [s for s in built if room_of(s) in LEFT_OUT], "and none of the rooms left out")
answers = sorted(os.path.basename(s) for s in built if room_of(s) == "without")
check(answers == sorted(os.listdir(SOURCE + "/source/without")), "what is left out has answers: " + " ".join(answers))

# What the rooms of the core call stands in one of them, or in source/without: by the objects of the whole build.
objects = []
for k, command in enumerate(c for c in core if any(room_of(s) == "without" for s in sources_of(c))):
    words = shlex.split(command["command"])
    begin = next(i for i, word in enumerate(words) if re.search(r"(c\+\+|g\+\+|clang\+\+)[-\d]*$", word))
    words = [word for word in words[begin:] if word != "-include" and not word.endswith("cmake_pch.hxx")]
    words[words.index("-o") + 1] = f"without_{k}.o"
    output_of(words + ["-O0"], cwd=command["directory"])
    objects.append(os.path.join(command["directory"], f"without_{k}.o"))
rooms = {os.path.basename(s).split(".")[0]: room_of(s) for s in built}
archives = [os.path.join(BUILD, f"libwheelrail_{name}.a") for name in ("core", "contact")]
kept, needed, elsewhere = set(), {}, set()
for place, line in symbols(archives + objects):
    kind, _, symbol = line.partition(" ")
    outside = room_of_object(place, rooms) in LEFT_OUT
    if kind in "TWVBDRu":
        (elsewhere if outside else kept).add(symbol)
    elif kind == "U" and not outside:
        needed[symbol] = place
missing = {s: p for s, p in needed.items() if s in elsewhere and s not in kept}
for symbol, place in sorted(missing.items())[:20]:
    print(f"  {symbol}, called in {place}")
check(len(needed) > 1000 and not missing, f"{len(missing)} of {len(needed)} symbols stand in rooms left out alone")
finish()
