"""Whether the page of a study is that of its tables: drawing it takes half a minute, and a second call changes nothing."""

import glob
import hashlib
import importlib.util
import os

STAMP = "page.sha256"
HERE = os.path.dirname(os.path.abspath(__file__))


def digest(study):
    """Of all that the page is made of: title, tables, and the scripts that draw it. What lies in the folder of a case
    changes only with the name of the folder or with the state of the case, which stand in the tables."""
    found = hashlib.sha256(study.title.encode())
    found.update(str(importlib.util.find_spec("plotly") is not None).encode())  # without it the page shows pictures alone
    paths = [study.path("table.csv"), study.path("costs.csv")]
    for folder in (HERE, os.path.join(HERE, os.pardir, "report")):
        paths += sorted(glob.glob(os.path.join(folder, "*.py")) + glob.glob(os.path.join(folder, "*.js")))
    for path in paths:
        with open(path, "rb") as file:
            found.update(file.read())
    return found.hexdigest()


def is_current(study):
    """Whether study.html is there and was drawn from all of that as it is now."""
    try:
        with open(study.work(STAMP), encoding="utf-8") as file:
            there = os.path.exists(study.path("study.html")) and os.path.isdir(study.path("pictures"))
            return there and file.read() == digest(study)
    except OSError:
        return False


def write(study):
    """To be called once the page is written."""
    with open(study.work(STAMP), "w", encoding="utf-8") as file:
        file.write(digest(study))
