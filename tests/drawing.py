"""Pictures drawn by several processes: in their order, with the exceptions of their calls, also when a process is
killed, and none of them outlives the one that asked for them.

Usage: drawing.py SOURCE
"""

import functools
import os
import signal
import subprocess
import sys
import time

from checks import check, finish

sys.path.insert(0, os.path.join(sys.argv[1], "source", "study"))
import drawing

here = os.getpid()


def square(number, seconds=0.0):
    time.sleep(seconds)
    return number * number, os.getpid()


def killed():
    if os.getpid() != here:
        os.kill(os.getpid(), signal.SIGKILL)
    return "drawn"


def at_work(process):
    """Whether it runs; one that has ended may wait for somebody to ask for its code."""
    try:
        with open(f"/proc/{process}/stat") as file:
            return file.read().rsplit(")", 1)[1].split()[0] not in "ZX"
    except OSError:
        return False


def full():
    raise OSError(28, "No space left on device", "pictures/a.png")


if sys.argv[2:] == ["parent"]:  # killed below, with its processes at work
    with drawing.Drawing([functools.partial(square, k, 60) for k in range(2)], 2) as drawn:
        print(*drawn._pool._processes, flush=True)
        drawn.results()

calls = [functools.partial(square, k, 0.1 * (k % 2)) for k in range(7)]
for processes in (1, 3):
    with drawing.Drawing(calls, processes) as drawn:
        results = drawn.results()
    check([value for value, _ in results] == [k * k for k in range(7)], f"results in their order, {processes} at once")
    check((here in [process for _, process in results]) == (processes == 1), "drawn here" if processes == 1 else "drawn by others")

with drawing.Drawing([killed, killed], 2) as drawn:
    check(drawn.results() == ["drawn", "drawn"], "what a killed process leaves is drawn here")

for processes in (1, 2):
    try:
        with drawing.Drawing([calls[0], full], processes) as drawn:
            drawn.results()
        check(False, "a full disk is told")
    except OSError as error:
        check((error.errno, error.filename) == (28, "pictures/a.png"), f"a full disk is told, {processes} at once: {error}")

parent = subprocess.Popen([sys.executable, __file__, sys.argv[1], "parent"], stdout=subprocess.PIPE, text=True)
workers = [int(number) for number in parent.stdout.readline().split()]
parent.kill()
parent.wait()
end = time.time() + 10
while time.time() < end and any(map(at_work, workers)):
    time.sleep(0.02)
check(len(workers) == 2 and not any(map(at_work, workers)), "they end with their parent")
finish()
