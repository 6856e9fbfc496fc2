"""Reads what tests/output.cc wrote, with VTK and h5py, and checks names, units, ranges, counts.

Usage: read_output.py FOLDER RANKS
"""

import json
import os
import sys
import xml.etree.ElementTree as xml

import h5py
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

from checks import check, finish


def read_vtu(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def units_in(path):
    """Name and unit of the data arrays; the arrays' bytes are plain base64 text inside the XML."""
    arrays = xml.parse(path).getroot().iter("DataArray")
    return {a.get("Name"): a.get("units") for a in arrays if a.get("units")}


def check_vtu(folder, ranks):
    path = os.path.join(folder, "volume.vtu")
    grid = read_vtu(path)
    cells = 2 + 3 * (ranks - 1)
    check(grid.GetNumberOfCells() == cells, f"volume.vtu has {cells} cells")
    points = sum(4 * (n + 1) for n in [2] + [3] * (ranks - 1))
    check(grid.GetNumberOfPoints() == points, f"volume.vtu has {points} points, shared by the cells of a rank")
    check({grid.GetCellType(c) for c in range(cells)} == {12}, "all cells are hexahedra")
    points = vtk_to_numpy(grid.GetPoints().GetData())
    z_max = 0.002 if ranks == 1 else 0.01 * (ranks - 1) + 0.003
    check(np.allclose(points.max(axis=0), [1e-3, 1e-3, z_max]), "the points reach where they should")
    pressure = vtk_to_numpy(grid.GetPointData().GetArray("pressure"))
    check(pressure.ndim == 1 and np.allclose(pressure, 1e9 * points[:, 2], rtol=1e-5, atol=1),
          "pressure is the field that was written")
    motion = vtk_to_numpy(grid.GetPointData().GetArray("displacement"))
    check(motion.shape == points.shape and np.allclose(motion, points * [1, 2, 3], rtol=1e-5, atol=1e-9),
          "displacement is a vector and the field that was written")
    volumes = [grid.GetCell(c).GetBounds() for c in range(cells)]
    volumes = [(b[1] - b[0]) * (b[3] - b[2]) * (b[5] - b[4]) for b in volumes]
    check(np.allclose(volumes, 1e-9, rtol=1e-4), "every cell is a cube of 1 mm")
    check(units_in(path) == {"pressure": "Pa", "displacement": "m"}, "units of the arrays")

    surface = read_vtu(os.path.join(folder, "surface.vtu"))
    check(surface.GetNumberOfCells() == 4 and surface.GetCellType(0) == 9, "surface.vtu has 4 quadrilaterals")
    check(not os.path.exists(os.path.join(folder, "wrong.vtu")), "a refused mesh leaves no file")

    sets = list(xml.parse(os.path.join(folder, "volume.pvd")).getroot().iter("DataSet"))
    check([s.get("file") for s in sets] == ["volume.vtu"] * 3, "the series lists three files")


def check_hdf5(folder):
    with h5py.File(os.path.join(folder, "history.h5"), "r") as file:
        check(set(file) == {"time", "normal_force"}, "history.h5 has the two columns")
        units = [file[name].attrs["unit"] for name in ("time", "normal_force")]
        check([u.decode() if isinstance(u, bytes) else u for u in units] == ["s", "N"], "with their units")
        check(np.array_equal(file["normal_force"], [100e3, 101e3, 102e3]), "and their values")

    units = dict(along="m", lateral="m", gap="m", pressure="Pa", shear_along="Pa", shear_lateral="Pa",
                 slip_along="1", slip_lateral="1", state="1", area="m2")
    with h5py.File(os.path.join(folder, "patch.h5"), "r") as file:
        check(list(file) == ["tick_0000", "tick_0001", "tick_0002"], "patch.h5 has three ticks")
        group = file["tick_0002"]
        check(group.attrs["time_s"] == 0.25 and group.attrs["rolled_distance_m"] == 0.05, "time and distance")
        shape = (group.attrs["n_along"], group.attrs["n_lateral"])
        check(set(group) == set(units), "the fields of a tick")
        check(all(group[name].shape == shape for name in units), "of n_along x n_lateral values")
        check(all(np.bytes_(group[name].attrs["unit"]) == np.bytes_(unit) for name, unit in units.items()),
              "with their units")
        along, lateral = group["along"][:], group["lateral"][:]
        check(np.all(np.diff(along, axis=0) > 0) and np.all(np.diff(lateral, axis=1) > 0),
              "the first index runs along the track, the second across")
        check(abs(group["pressure"][:].max() / 1.2e9 - 1) < 0.01, "the peak pressure")


def check_summary(folder):
    with open(os.path.join(folder, "summary.json")) as file:
        summary = json.load(file)
    keys = """normal_force_N longitudinal_force_N lateral_force_N max_pressure_Pa contact_area_m2
        patch_lateral_m patch_longitudinal_m max_shear_traction_Pa stick_fraction creepage max_von_mises_Pa
        max_plastic_strain max_residual_von_mises_Pa rolled_distance_m elements time_steps time_step_s
        element_updates_per_second energy_error wall_time_s peak_memory_bytes ranks finished""".split()
    missing = [key for key in keys if key not in summary]
    check(not missing, f"summary.json has all keys {missing or ''}")
    check(not any(isinstance(v, (dict, list)) for v in summary.values()), "summary.json is flat")
    check(summary["creepage"] is None and summary["finished"] is True, "missing figures are null")
    with open(os.path.join(folder, "figures.json")) as file:
        figures = json.load(file)
    described = [figure[key] for figure in figures for key in ("key", "std_key", "error_key", "low_key", "high_key")]
    check(len(set(described)) == len(described), "figures.json describes no key twice")
    texts = ("title", "program_version", "finished", "stopped_because", "trusted", "doubts", "note", "verdict", "ended", "ended_because",
             "largest_swing_of", "largest_drift_of")
    missing = [key for key in summary if key not in described and key not in texts]
    check(not missing, f"figures.json describes the figures of summary.json {missing or ''}")
    check(summary["elements"] == 123456 and isinstance(summary["elements"], int), "counts are whole numbers")


check_vtu(sys.argv[1], int(sys.argv[2]))
check_hdf5(sys.argv[1])
check_summary(sys.argv[1])
finish()
