"""Functions have at most 60 lines, but those that are tables.

Usage: function_lines.py SOURCE_FOLDER
"""

import glob
import re
import sys

from checks import check, finish

ROOT, MOST = sys.argv[1], 60
TABLES = {"commands", "units", "digit_table", "rules", "entries_of"}
NO_FUNCTION = re.compile(r"\s*(if|else|for|while|do|switch|try|catch|namespace|struct|class|enum|union|extern|case)\b")


def head_of(lines, brace):
    """The first line of what a brace on a line of its own belongs to."""
    first, depth = brace, 0
    while first > 0:
        first -= 1
        line = re.sub(r"//.*|\"(\\.|[^\"\\])*\"", "", lines[first])
        depth += line.count(")") - line.count("(")
        if depth <= 0 and not re.match(r"\s*[:,] ", line):
            break
    return lines[first]


def functions(path):
    """Name and lines between the braces, of bodies that begin on a line of their own."""
    with open(path) as file:
        lines = file.read().splitlines()
    for k, line in enumerate(lines):
        if line.strip() != "{" or k == 0:
            continue
        head = head_of(lines, k)
        name = re.search(r"([\w~]+|operator\W+)\s*\(", head)
        if not name or NO_FUNCTION.match(head):
            continue
        end = next(n for n in range(k + 1, len(lines)) if lines[n].rstrip(";,") == line.replace("{", "}"))
        yield name.group(1), end - k - 1


found = [(path, *function) for path in sorted(glob.glob(ROOT + "/source/**/*.cc", recursive=True) +
                                              glob.glob(ROOT + "/include/**/*.h", recursive=True))
         for function in functions(path)]
check(len(found) > 3000, f"{len(found)} functions")
long_ones = [f"{path[len(ROOT) + 1:]}: {name}() has {lines}" for path, name, lines in found
             if lines > MOST and name not in TABLES]
for line in long_ones:
    print("  " + line)
check(not long_ones, f"{len(long_ones)} functions have more than {MOST} lines")
finish()
