"""Pictures that do not depend on each other, drawn by several processes at once."""

import concurrent.futures
import ctypes
import multiprocessing
import os
import signal

MOST = 8  # processes; with more the longest pictures decide, and each takes some hundred megabytes
PR_SET_PDEATHSIG = 1  # of Linux' prctl


def begin(calls, parent):
    """In each process: the calls, which it has from its parent without a copy. It ends with its parent, and Ctrl-C is
    the parent's to act on."""
    global _calls
    _calls = calls
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
    if os.getppid() != parent:  # it ended before
        os._exit(1)


def call(number):
    return _calls[number]()


class Drawing:
    """Calls without arguments that draw, at work while its block runs."""

    def __init__(self, calls, processes):
        self._calls, self._pool = calls, None
        processes = min(processes, len(calls), MOST)
        if processes > 1:
            self._pool = concurrent.futures.ProcessPoolExecutor(processes, multiprocessing.get_context("fork"), begin,
                                                                (calls, os.getpid()))
            # the last ones, maps of all cases, take longest
            self._futures = [self._pool.submit(call, number) for number in reversed(range(len(calls)))][::-1]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self._pool is not None:
            self._pool.shutdown(cancel_futures=True)

    def results(self):
        """What the calls gave, in their order; an exception of a call is raised here."""
        if self._pool is not None:
            try:
                return [future.result() for future in self._futures]
            except concurrent.futures.BrokenExecutor:
                pass  # a process was killed, as for lack of memory: one after the other takes less
        return [one() for one in self._calls]
