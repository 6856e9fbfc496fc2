"""The checks of the tests in Python, as tests/check.h has them: every check prints one line."""

import sys

# a small rolling scene; Track and Mesh
SMALL_SCENE = """
subsection Track
  set Rail length = 300 mm
end
subsection Mesh
  set Solution cell size = 4 mm
  set Coarse cell size = 16 mm
  set Fine depth = 8 mm
  set Fine margin = 8 mm
end
"""

_failures = 0


def check(condition, text):
    global _failures
    _failures += not condition
    print("ok      " if condition else "FAILED  ", text, sep="", flush=True)


def finish():
    """Prints the result and ends the program, with code 1 when a check failed."""
    print("all checks passed" if _failures == 0 else f"{_failures} checks FAILED")
    sys.exit(1 if _failures else 0)
