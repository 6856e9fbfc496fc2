"""The program as `cmake --install` leaves it: it finds its scripts in the folder where it was installed, and
neither in the sources nor in the build folder.

Usage: installed.py PROGRAM MPIEXEC CMAKE BUILD_FOLDER
"""

import os
import re
import shutil
import subprocess
import sys

from checks import check, finish

CMAKE, BUILD = sys.argv[3:5]
PREFIX = os.path.abspath("prefix")
PROGRAM = os.path.join(PREFIX, "bin", "wheelrail")
SCRIPTS = os.path.join(PREFIX, "share", "wheelrail", "report")


def run(program, *arguments):
    done = subprocess.run([program, *arguments], capture_output=True, text=True, cwd="elsewhere")
    return done.returncode, done.stdout + done.stderr


def test_installed():
    code, text = run(PROGRAM, "geometry", os.path.join(PREFIX, "share", "wheelrail", "prm", "rolling.prm"), "--profiles")
    check(code == 0 and "Picture of the profiles: rolling_profiles.png" in text, f"geometry --profiles runs {text[-300:]!r}")
    check(os.path.exists("elsewhere/rolling_profiles.png"), "and draws the profiles")

    os.mkdir("elsewhere/empty")
    code, text = run(PROGRAM, "report", "empty")
    check(code == 1 and "empty" in text and "Error" not in text, f"report says that a folder holds no run: {text!r}")

    for page in ("README.md", "LICENSE", "CHANGELOG.md", "CITATION.cff", "doc/manual/input.md", "doc/theory/contact.md"):
        check(os.path.exists(os.path.join(PREFIX, "share", "doc", "wheelrail", page)), f"{page} is installed")


def test_without_scripts():
    os.rename(SCRIPTS, SCRIPTS + ".away")
    code, text = run(PROGRAM, "report", "empty")
    check(code == 2 and re.search("a file of the program is missing: neither .*bin/share/wheelrail/report/report.py nor "
                                  f"{re.escape(SCRIPTS)}/report.py is there; build or install the program again", text),
          f"without its scripts the program says where it looked: {text!r}")
    os.rename(SCRIPTS + ".away", SCRIPTS)


def main():
    for folder in (PREFIX, "elsewhere"):
        shutil.rmtree(folder, ignore_errors=True)
    os.mkdir("elsewhere")
    done = subprocess.run([CMAKE, "--install", BUILD, "--prefix", PREFIX], capture_output=True, text=True)
    check(done.returncode == 0, f"cmake --install ends without a fault {done.stderr}")
    test_installed()
    test_without_scripts()
    finish()


main()
