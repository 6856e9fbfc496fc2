"""What tests of interrupted runs share: killing a program with all it started, and looking at what it left."""

import glob
import json
import os
import signal
import time

import h5py
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

from checks import check


def descendants(root):
    """The processes that a process has started, and theirs."""
    parents = {}
    for path in glob.glob("/proc/[0-9]*/stat"):
        try:
            with open(path) as file:
                text = file.read()
        except OSError:
            continue
        fields = text[text.rindex(")") + 2:].split()
        parents.setdefault(int(fields[1]), []).append(int(path.split("/")[2]))
    found, waiting = [], [root]
    while waiting:
        children = parents.get(waiting.pop(), [])
        found += children
        waiting += children
    return found


def kill(process):
    """kill -9 of the run and of all its ranks."""
    for pid in descendants(process.pid) + [process.pid]:
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
    process.wait()


def wait_for(path, text, process, seconds=300):
    end = time.time() + seconds
    while time.time() < end and process.poll() is None:
        if os.path.exists(path) and text in open(path).read():
            return True
        time.sleep(0.01)
    return False


def summary_of(folder):
    with open(os.path.join(folder, "summary.json")) as file:
        return json.load(file)


def check_files(folder, what):
    """Every file there is whole."""
    broken = []
    for path in glob.glob(os.path.join(folder, "*")):
        name = os.path.basename(path)
        try:
            if name.endswith(".part"):
                broken.append(name)
            elif name.endswith(".h5"):
                with h5py.File(path, "r") as file:
                    file.visititems(lambda _, item: item[()] if isinstance(item, h5py.Dataset) else None)
            elif name.endswith(".json"):
                with open(path) as file:
                    json.load(file)
            elif name.endswith(".vtu"):
                reader = vtkXMLUnstructuredGridReader()
                reader.SetFileName(path)
                reader.Update()
                if reader.GetOutput().GetNumberOfCells() == 0 or reader.GetErrorCode() != 0:
                    broken.append(name)
            elif name.endswith(".pvd"):
                with open(path) as file:
                    if "</VTKFile>" not in file.read():
                        broken.append(name)
        except (OSError, ValueError, KeyError):
            broken.append(name)
    check(not broken, f"{what}: every file is whole {broken or ''}")
