"""An include points down only: the floors are the table of CONTRIBUTING.md; types of all rooms have names of their own.

Usage: floors.py SOURCE_FOLDER
"""

import glob
import os
import re
import sys

from checks import check, finish

ROOT = sys.argv[1]


def floors_of(page):
    """Floor of each room, and the rooms beside the core."""
    floors, beside = {}, set()
    for number, text in re.findall(r"^\| (\d+) \| (.*) \|$", page, re.MULTILINE):
        for room in re.findall(r"(?:^|; )`(\w+)`", text):
            check(room not in floors, f"{room} stands on one floor")
            floors[room] = int(number)
        beside.update(re.findall(r"`(\w+)`\\\*", text))
    return floors, beside


def rooms_in(folder):
    return {name for name in os.listdir(os.path.join(ROOT, folder))
            if glob.glob(os.path.join(ROOT, folder, name, "*.cc")) + glob.glob(os.path.join(ROOT, folder, name, "*.h"))}


def includes():
    """Room, file and included room of every include of the program."""
    for folder in ("include/wheelrail", "source"):
        for room in sorted(rooms_in(folder)):
            for path in sorted(glob.glob(os.path.join(ROOT, folder, room, "*"))):
                with open(path, encoding="utf-8") as file:
                    for other in re.findall(r"^#include <wheelrail/(\w+)/", file.read(), re.MULTILINE):
                        yield room, os.path.relpath(path, ROOT), other


with open(os.path.join(ROOT, "CONTRIBUTING.md"), encoding="utf-8") as contributing:
    FLOORS, BESIDE = floors_of(contributing.read())
check(set(FLOORS) == rooms_in("source") | rooms_in("include/wheelrail"),
      f"the table has all rooms: {sorted(set(FLOORS) ^ (rooms_in('source') | rooms_in('include/wheelrail')))}")
ALL = list(includes())
check(len(ALL) > 500, f"{len(ALL)} includes looked at")
UP = [f"{path} includes {other}" for room, path, other in ALL
      if room != other and not FLOORS.get(other, 99) < FLOORS.get(room, 0)]
check(not UP, f"includes point to lower floors {UP}")
TYPES = {}
for header in glob.glob(os.path.join(ROOT, "include/wheelrail/*/*.h")):
    with open(header, encoding="utf-8") as text:
        for name in re.findall(r"^  (?:class|struct|enum class) (\w+)(?: *:.*)?$", text.read(), re.MULTILINE):
            TYPES.setdefault(name, []).append(os.path.relpath(header, ROOT))
TWICE = {name: where for name, where in TYPES.items() if len(where) > 1}
check(len(TYPES) > 300 and not TWICE, f"each of {len(TYPES)} types has a name of its own {TWICE}")
check(len(BESIDE) >= 5, f"rooms beside the core {sorted(BESIDE)}")
INTO = [f"{path} includes {other}" for room, path, other in ALL
        if other in BESIDE and room not in BESIDE | {"application", "without"}]
check(not INTO, f"the core includes none of the rooms beside it {INTO}")
finish()
