"""Reads what wheelrail writes into arrays of numpy that know their units.

    import wheelrail
    run = wheelrail.load("output/rolling")
    run.summary["max_pressure_Pa"]           # a figure, SI units in its name
    run.history["normal_force"].to("kN")     # over time; .unit tells the unit
    run.patch[-1]["pressure"].to("MPa")      # last tick, [along, lateral]
    run.slices[-1]["AA_rail"]["von_mises_stress"]

Files are read when they are first asked for. What is missing raises MissingFile, whose text says what makes it.
The attributes of a tick and of a slice (time_s, rolled_distance_m, lateral_m, ...) are in its `attributes`.
"""

import collections.abc
import functools
import json
import os
import sys


def _h5py_hint():
    """What to do where this Python has no h5py: Debian's has it, another one or a virtual environment hides it."""
    if sys.prefix != sys.base_prefix:
        return (f"the virtual environment {sys.prefix} hides Debian's packages: leave it (deactivate) and start your script "
                "by /usr/bin/python3, or install h5py into it (pip install h5py)")
    if os.path.realpath(sys.executable) != os.path.realpath("/usr/bin/python3"):
        return f"start your script by /usr/bin/python3, or install h5py for {sys.executable} ({sys.executable} -m pip install h5py)"
    return "install the Debian package python3-h5py"


try:
    import h5py
except ImportError as error:
    sys.exit(f"{error}; {_h5py_hint()}")
import numpy as np

#: how the program is called, for commands in messages; the launcher tells
CALL = os.environ.get("WHEELRAIL_COMMAND") or "./wheelrail"

#: other units by the one of the file: name -> factor
UNITS = {
    "m": {"mm": 1e3, "um": 1e6},
    "m2": {"mm2": 1e6},
    "s": {"ms": 1e3, "us": 1e6},
    "m/s": {"km/h": 3.6, "mm/s": 1e3},
    "rad": {"mrad": 1e3, "deg": 180 / np.pi},
    "N": {"kN": 1e-3},
    "N m": {"kN m": 1e-3},
    "Pa": {"kPa": 1e-3, "MPa": 1e-6, "GPa": 1e-9, "N/mm2": 1e-6},
    "W": {"kW": 1e-3},
    "J": {"mJ": 1e3, "kJ": 1e-3},
    "1": {"%": 1e2, "1e-3": 1e3},
}


class DataError(Exception):
    """Something in the files that cannot be used; the text is a sentence for the user."""


class MissingFile(DataError):
    """A file that is not there."""


class Array(np.ndarray):
    """An array with the `unit` of its file and, where the file says it, a `description`. Parts of it keep the unit;
    what is computed from it is a plain array."""

    unit = description = ""

    def __new__(cls, values, unit="", description=""):
        array = np.asarray(values).view(cls)
        array.unit, array.description = unit, description
        return array

    def __array_finalize__(self, parent):
        self.unit, self.description = getattr(parent, "unit", ""), getattr(parent, "description", "")

    def __array_ufunc__(self, function, method, *inputs, out=None, **options):
        def plain(values):
            return tuple(value.view(np.ndarray) if isinstance(value, Array) else value for value in values)
        if out is not None:
            options["out"] = plain(out)
        return getattr(function, method)(*plain(inputs), **options)

    def to(self, unit):
        """The values in another unit, as a new Array: run.history["time"].to("ms")."""
        factors = {self.unit: 1, **UNITS.get(self.unit, {})}
        if unit not in factors:
            raise DataError(f"Values in {self.unit} cannot be given in {unit}; there are {', '.join(factors)}.")
        return Array(np.asarray(self) * factors[unit], unit, self.description)


def text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


class Group(dict):
    """The datasets or groups of a group of HDF5 by their names, and its `attributes`. `span` of a tick of the patch:
    its first and last lateral place [m] by the edge line of the program; None where that is not known."""

    span = None

    def __init__(self, group):
        super().__init__((name, read(group[name])) for name in group)
        self.name = group.name.strip("/")
        self.attributes = {name: text(value) if isinstance(value, (bytes, str)) else value.item()
                           for name, value in group.attrs.items()}


def read(item):
    if isinstance(item, h5py.Group):
        return Group(item)
    return Array(item[()], text(item.attrs.get("unit", "")), text(item.attrs.get("description", "")))


def open_file(path, made_by):
    if not os.path.exists(path):
        raise MissingFile(f"There is no {os.path.basename(path)} in {os.path.dirname(path)}; {made_by} makes it.")
    try:
        return h5py.File(path, "r")
    except OSError as error:
        raise DataError(f"The file {path} cannot be read as HDF5: {error}.") from error


class Ticks(collections.abc.Sequence):
    """The ticks of a file, first to last: ticks[0], ticks[-1], len(ticks), for tick in ticks. Each is a Group, read
    when it is asked for. `span_of`: gives the span of the patch from the attributes of a tick."""

    def __init__(self, path, made_by, span_of=lambda attributes: None):
        self.path, self._span_of = path, span_of
        with open_file(path, made_by) as file:
            self.names = sorted(name for name in file if name.startswith("tick_"))
            self.attributes = {name: text(value) for name, value in file.attrs.items()}
        self._read = functools.lru_cache(maxsize=64)(self._read_tick)

    def _read_tick(self, name):
        with h5py.File(self.path, "r") as file:
            group = Group(file[name])
        group.span = self._span_of(group.attributes)
        return group

    def __len__(self):
        return len(self.names)

    def __getitem__(self, number):
        if isinstance(number, slice):
            return [self[k] for k in range(*number.indices(len(self)))]
        return self._read(self.names[number])


def _span(middle, width):
    """First and last place of a patch; None without numbers or without a patch."""
    if middle is None or width is None or not width > 0 or not np.isfinite(middle):
        return None
    return middle - 0.5 * width, middle + 0.5 * width


class Run:
    """One output folder of run, halfspace or compare."""

    def __init__(self, folder):
        self.folder = os.fspath(folder)
        if not os.path.isdir(self.folder):
            raise DataError(f"There is no folder {self.folder}; give the output folder of a run.")

    def path(self, name):
        return os.path.join(self.folder, name)

    def has(self, name):
        return os.path.exists(self.path(name))

    def _json(self, name, kind):
        path = self.path(name)
        if not os.path.exists(path):
            raise MissingFile(f"There is no {name} in {self.folder}; a run that has finished has it.")
        try:
            with open(path, encoding="utf-8") as file:
                content = json.load(file)
        except ValueError as error:
            raise DataError(f"The file {path} is no readable JSON: {error}.") from error
        if not isinstance(content, kind):
            raise DataError(f"The file {path} is not what the program writes: "
                            f"a JSON {'object' if kind is dict else 'array'} was expected.")
        return content

    @functools.cached_property
    def summary(self):
        """The figures by their keys, which end in the SI unit; None for one that the run does not give."""
        return self._json("summary.json", dict)

    @functools.cached_property
    def figures(self):
        """How figures are shown: key -> label, unit, factor from SI, decimals, remark, std_key."""
        return {figure["key"]: figure for figure in self._json("figures.json", list)}

    def _table(self, name):
        with open_file(self.path(name), "a run") as file:
            names = sorted(file, key=lambda column: int(file[column].attrs.get("column", 0)))
            return {column: read(file[column]) for column in names}

    @functools.cached_property
    def history(self):
        """Forces, creepage, energies, ...: name -> Array over the recorded steps."""
        return self._table("history.h5")

    @functools.cached_property
    def patch_history(self):
        """The figures of the patch over the recorded steps: name -> Array."""
        return self._table("patch_history.h5")

    @functools.cached_property
    def patch(self):
        """The contact patch tick by tick, arrays [along, lateral]; of a folder of halfspace its one solution."""
        only_halfspace = self.has("halfspace.h5") and not self.has("patch.h5")
        return self.halfspace if only_halfspace else Ticks(self.path("patch.h5"), "a run", self._span_of_run)

    def _span_of_run(self, attributes):
        """From the row of the history of the patch that is nearest to a tick."""
        place = attributes.get("rolled_distance_m")
        if place is None or not self.has("patch_history.h5") or not len(self.patch_history["rolled_distance"]):
            return None
        row = np.argmin(np.abs(self.patch_history["rolled_distance"] - place))
        return _span(*(float(self.patch_history[name][row]) for name in ("patch_centre_lateral", "patch_lateral")))

    def _span_of_halfspace(self, _attributes):
        prefix = "halfspace_" if self.has("patch.h5") else ""
        summary = self.summary if self.has("summary.json") else {}
        return _span(*(summary.get(f"{prefix}{name}_m") for name in ("patch_centre_lateral", "patch_lateral")))

    @functools.cached_property
    def slices(self):
        """Stresses below the contact tick by tick: plane -> position, depth and arrays [position, depth]."""
        return Ticks(self.path("slices.h5"), "a run")

    @functools.cached_property
    def residual(self):
        """Residual stresses of the unloaded rail as one tick in the form of `slices`; of a run that may yield."""
        return Ticks(self.path("residual.h5"), "a run of bodies with a yield stress")

    @functools.cached_property
    def halfspace(self):
        """The half-space solution as one tick in the form of `patch`."""
        return Ticks(self.path("halfspace.h5"), CALL + " compare", self._span_of_halfspace)

    def halfspace_patch(self, number):
        """The second, third ... patch of a half-space solution with several, each in its own plane."""
        return Ticks(self.path(f"halfspace_patch_{number}.h5"), CALL + " halfspace or compare")

    @functools.cached_property
    def halfspace_slices(self):
        """Stresses below the half-spaces as one tick in the form of `slices`."""
        only_halfspace = self.has("halfspace.h5") and not self.has("patch.h5")
        return self.slices if only_halfspace else Ticks(self.path("halfspace_slices.h5"), CALL + " compare")


def load(folder):
    """The results in an output folder; raises DataError when there is no such folder."""
    return Run(folder)


def load_vtu(path):
    """Points [m], cells (numbers of points) and fields of a VTU file, as Arrays by name: "points", "cells" and the
    names in the file. Needs the Debian package python3-vtk9."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
    import xml.etree.ElementTree as xml

    if not os.path.exists(path):
        raise MissingFile(f"There is no file {path}.")
    units = {a.get("Name"): a.get("units") for _, a in xml.iterparse(path) if a.tag == "DataArray" and a.get("units")}
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    per_cell = len(cells) // max(grid.GetNumberOfCells(), 1)
    content = {"points": Array(vtk_to_numpy(grid.GetPoints().GetData()), "m"),
               "cells": Array(cells.reshape(-1, per_cell), "1")}
    for data in (grid.GetPointData(), grid.GetCellData()):
        for k in range(data.GetNumberOfArrays()):
            array = data.GetArray(k)
            content[array.GetName()] = Array(vtk_to_numpy(array), units.get(array.GetName(), ""))
    return content
