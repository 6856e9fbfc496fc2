"""The checks of the tests in Python: every check prints one line."""

import sys

# a small rolling scene, driving; Track, Wheelset and Mesh
SMALL_SCENE = """
subsection Track
  set Rail length = 300 mm
end
subsection Wheelset
  set Traction coefficient = 0.25
end
subsection Mesh
  set Solution cell size = 4 mm
  set Coarse cell size = 16 mm
  set Fine depth = 8 mm
  set Fine margin = 8 mm
end
"""


def small_study(axes, *, compute="both", distance="4 mm", ticks=2, more=""):
    """The text of a family of small runs, with half-spaces on coarse elements. `more`: lines of subsection Output."""
    return f"""set Title = small
{SMALL_SCENE}
subsection Run
  set Rolling distance = {distance}
  set Averaging distance = 2 mm
end
subsection Half-space
  set Element size = 1 mm
end
subsection Output
  set Ticks = {ticks}
  set Volume fields = false
{more}
end
subsection Study
  set Axes = {axes}
  set Compute = {compute}
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
