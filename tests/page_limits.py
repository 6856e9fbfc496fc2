"""Pages stay short, narrow, and have each measured number once: words a page and in all, lines of 120 columns (but tables,
code and links), the table of README.md as doc/measured.md has it, and the numbers of doc/measured.md in no other page.

Usage: page_limits.py SOURCE_FOLDER
"""

import glob
import os
import re
import sys

from checks import check, finish

ROOT = sys.argv[1]
ALL, A_PAGE, WIDTH = 60000, 2700, 120
PAGES = {"README.md": 800, "doc/theory/mesh.md": 2000, "doc/manual/curve.md": 3200, "doc/manual/parameters.md": 7000}
MEASURED = "doc/measured.md"


def text_of(page):
    with open(os.path.join(ROOT, page), encoding="utf-8") as file:
        return file.read()


def prose(text):
    """Its lines without code, neither fenced nor indented."""
    lines = re.sub(r"```.*?```", "", text, flags=re.S).splitlines()
    return [line for line in lines if not line.startswith("    ")]


def rows(text):
    """Rows of its tables by their first cells."""
    table = [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in prose(text) if line.startswith("|")]
    return {row[0]: row[1:] for row in table if row[0] and not row[0].startswith("--")}


def numbers_of(text):
    """Its numbers of four digits and more with what follows them, such as 186.8 mm2, from the rows of its tables."""
    cells = " | ".join(cell for row in rows(text).values() for cell in row)
    found = re.findall(r"(?<![-+\d.])\d[\d.]*(?: \d{3})*(?:e-\d)?(?: (?:MPa|mm2|mm|N))?(?= \||$)", cells)
    return {number for number in found if len(re.sub(r"e-\d|\D", "", number.split(" MPa")[0].split(" mm")[0])) > 3}


def main():
    pages = ["README.md", "CONTRIBUTING.md"]
    pages += [os.path.relpath(path, ROOT) for path in glob.glob(f"{ROOT}/doc/**/*.md", recursive=True)]
    words = {page: len(text_of(page).split()) for page in pages}
    for page in pages:
        limit = PAGES.get(page, A_PAGE)
        check(words[page] <= limit, f"{page} has {words[page]} words, at most {limit}")
    check(sum(words.values()) <= ALL, f"{sum(words.values())} words in all pages, at most {ALL}")

    for page in pages:
        wide = [line for line in prose(text_of(page)) if len(line) > WIDTH and " " in line[:WIDTH].lstrip(" -")]
        wide = [line for line in wide if not re.match(r"\||!\[", line)]
        if page != "doc/manual/parameters.md":
            check(not wide, f"{page} has at most {WIDTH} columns {[line[:40] for line in wide]}")

    measured, readme = rows(text_of(MEASURED)), rows(text_of("README.md"))
    same = [name for name in readme if name in measured]
    check(len(same) > 4, f"{len(same)} rows of README.md are those of {MEASURED}")
    for name in same:
        check(readme[name] == measured[name], f"\"{name}\" of README.md is that of {MEASURED}")

    numbers = numbers_of(text_of(MEASURED)) | {measured["steady after"][0]}
    check(len(numbers) > 10, f"{MEASURED} has {', '.join(sorted(numbers))}")
    for page in set(pages) - {MEASURED, "README.md"}:
        text = "\n".join(prose(text_of(page)))
        twice = [number for number in numbers if re.search(rf"(?<![\d.]){re.escape(number)}(?![\d.])", text)]
        check(not twice, f"{page} leaves measured numbers to {MEASURED} {twice}")
    finish()


main()
