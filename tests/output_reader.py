"""Reads all files of a finished run with VTK and h5py and checks names, units, ranges, and that they agree.

Usage: output_reader.py FOLDER
"""

import glob
import json
import os
import sys
import xml.etree.ElementTree as xml

import h5py
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

from checks import check, finish


FOLDER = sys.argv[1]


def path(name):
    return os.path.join(FOLDER, name)


def text_of(value):
    return value.decode() if isinstance(value, bytes) else value


def within(values, low, high):
    return bool(np.all(np.isfinite(values)) and values.min() >= low and values.max() <= high)


def read_vtu(name):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path(name))
    reader.Update()
    grid = reader.GetOutput()
    arrays = grid.GetPointData()
    fields = {arrays.GetArrayName(k): vtk_to_numpy(arrays.GetArray(k)) for k in range(arrays.GetNumberOfArrays())}
    tags = xml.parse(path(name)).getroot().iter("DataArray")
    units = {tag.get("Name"): tag.get("units") for tag in tags if tag.get("units")}
    return grid, vtk_to_numpy(grid.GetPoints().GetData()), fields, units


SURFACE = dict(displacement="m", pressure="Pa", shear_traction="Pa", slip_velocity="m/s")
BODIES = dict(displacement="m", von_mises_stress="Pa", stress="Pa", principal_stresses="Pa")


def check_fields(name, expected, cell_type):
    grid, points, fields, units = read_vtu(name)
    check(units == expected and set(fields) == set(expected), f"{name}: fields and units")
    check(all(grid.GetCellType(c) == cell_type for c in range(grid.GetNumberOfCells())), f"{name}: kind of cells")
    check(within(fields["displacement"], -2e-3, 2e-3), f"{name}: displacement against the rigid motion below 2 mm")
    return grid, points, fields


def check_vtu(summary, patch):
    ticks = sorted(patch)
    for number, tick in enumerate(ticks):
        grid, points, fields = check_fields(f"surface_{number:04d}.vtu", SURFACE, 9)
        peak = patch[tick]["pressure"][:].max()
        check(abs(fields["pressure"].max() / peak - 1) < 1e-6, f"surface at {tick}: the peak pressure of patch.h5")
        check(within(fields["pressure"], 0, 1.001 * peak), f"surface at {tick}: pressure is not negative")
        wheel = np.unique(np.array([[grid.GetCell(c).GetPointId(k) for k in range(4)] for c in
                                    np.nonzero(vtk_to_numpy(grid.GetCellData().GetArray("body")))[0]]))
        share = fields["pressure"][wheel].max() / peak
        check(0.7 < share <= 1.0001, f"surface at {tick}: the wheel bears the pressure too, up to {share:.2f} of the peak")
        shear = np.linalg.norm(fields["shear_traction"], axis=1)
        bound = summary["friction_coefficient"] * fields["pressure"]
        check(np.all(shear <= bound * (1 + 1e-5) + 1e-6 * peak), f"surface at {tick}: shear within the Coulomb bound")
        check_fields(f"window_{number:04d}.vtu", BODIES, 12)
    for name in ("surface", "window"):
        sets = list(xml.parse(path(name + ".pvd")).getroot().iter("DataSet"))
        check([s.get("file") for s in sets] == [f"{name}_{k:04d}.vtu" for k in range(len(ticks))],
              f"{name}.pvd lists the files of all ticks")
        times = [patch[tick].attrs["time_s"] for tick in ticks]
        check(np.allclose([float(s.get("timestep")) for s in sets], times, rtol=1e-5), f"{name}.pvd: their times")

    sets = list(xml.parse(path("volume.pvd")).getroot().iter("DataSet"))
    check([s.get("file") for s in sets] == ["volume_start.vtu", "volume_end.vtu"], "volume.pvd lists start and end")
    for name in ("volume_start.vtu", "volume_end.vtu"):
        grid, points, fields = check_fields(name, BODIES, 12)
        check(grid.GetNumberOfCells() == summary["elements"], f"{name}: all elements")
        mises, tensor = fields["von_mises_stress"], fields["stress"]
        s, t = tensor[:, :3], tensor[:, 3:]
        again = np.sqrt(0.5 * ((s - np.roll(s, 1, axis=1))**2).sum(axis=1) + 3 * (t**2).sum(axis=1))
        check(np.allclose(mises, again, rtol=1e-4, atol=1e-4 * mises.max()), f"{name}: von Mises of the components")
        matrix = tensor[:, [0, 3, 5, 3, 1, 4, 5, 4, 2]].reshape(-1, 3, 3).astype(float)  # xx yy zz xy yz xz
        principal = np.linalg.eigvalsh(matrix)[:, ::-1]
        check(np.allclose(principal, fields["principal_stresses"], rtol=1e-4, atol=1e-4 * mises.max()),
              f"{name}: principal stresses of the tensor, largest first")
        body = vtk_to_numpy(grid.GetCellData().GetArray("body"))
        height = np.array([grid.GetCell(int(np.argmax(body == b))).GetBounds()[3] for b in (0, 1)])
        check(set(body) == {0, 1} and height[0] < 0.02, f"{name}: cells say whether they are of rail or wheel")
        check(grid.GetNumberOfPoints() < 2 * grid.GetNumberOfCells(), f"{name}: cells share their points")
        check(within(mises, 0, 1.0001 * max(summary["max_von_mises_Pa"], mises.max()))
              and 1e8 < mises.max() < 3e9, f"{name}: range of the von Mises stress")
        bytes_per_cell = os.path.getsize(path(name)) / summary["elements"]
        # thirteen numbers and the position at about a point a cell, zlib at its fastest level
        check(bytes_per_cell < 150, f"{name}: {bytes_per_cell:.0f} bytes a cell, below 150")
    check(abs(mises.max() / summary["max_von_mises_nodal_Pa"] - 1) < 1e-5,
          "the largest stress of the VTU file is the figure that says so")


def check_history(summary):
    with h5py.File(path("history.h5"), "r") as file:
        units = {name: text_of(file[name].attrs["unit"]) for name in file}
        columns = {name: file[name][:] for name in file}
        check(all(text_of(file[name].attrs["description"]) for name in file), "history.h5: every column is described")
        check({"program", "format", "axes", "signs"} <= set(file.attrs), "history.h5: version, axes, signs at the root")
    expected = dict(time="s", rolled_distance="m", normal_force="N", longitudinal_force="N", lateral_force="N",
                    max_pressure="Pa", creepage="1", pitch_rate="rad/s", kinetic_energy="J", strain_energy="J",
                    friction_dissipation="J", energy_error="1")
    check(all(units.get(name) == unit for name, unit in expected.items()), "history.h5: names and units")
    check(len({len(column) for column in columns.values()}) == 1, "history.h5: columns of one length")
    check(all(np.all(np.isfinite(column)) for column in columns.values()), "history.h5: finite values")
    check(np.all(np.diff(columns["time"]) > 0), "history.h5: time goes on")
    speed = np.diff(columns["rolled_distance"]) / np.diff(columns["time"])
    check(np.allclose(speed, summary["velocity_m_per_s"], rtol=1e-6), "history.h5: the speed is held")
    rolled = columns["rolled_distance"]
    check(abs(rolled[-1] - summary["rolled_distance_m"]) < 1e-9, "summary.json: the distance of the last row")
    last = rolled >= rolled[-1] - 2e-3
    for name, key in (("normal_force", "normal_force_N"), ("longitudinal_force", "longitudinal_force_N"),
                      ("creepage", "creepage")):
        check(np.isclose(columns[name][last].mean(), summary[key], rtol=1e-9), f"summary.json: mean of {name}")
    for name in ("friction_dissipation", "viscous_dissipation", "contact_damping_dissipation"):
        check(columns[name][-1] >= 0, f"history.h5: {name} is not negative")


def check_patch(patch, summary):
    units = dict(along="m", lateral="m", gap="m", pressure="Pa", shear_along="Pa", shear_lateral="Pa",
                 slip_along="1", slip_lateral="1", state="1", area="m2")
    for tick, group in patch.items():
        shape = (group.attrs["n_along"], group.attrs["n_lateral"])
        good = all(text_of(group[name].attrs["unit"]) == unit and group[name].shape == shape
                   for name, unit in units.items())
        edge = {name: group[name] for name in set(group) - set(units)}  # points between the nodes, where slip begins
        good = good and len({len(points) for points in edge.values()}) <= 1
        good = good and all(name.startswith("edge_") and text_of(points.attrs["unit"]) == units[name[5:]]
                            for name, points in edge.items())
        check(good, f"patch.h5 {tick}: names, units, shapes")
        force = (group["pressure"][:] * group["area"][:]).sum()
        check(abs(force / summary["normal_force_N"] - 1) < 0.05, f"patch.h5 {tick}: pressure times area is the load")


def check_slices(patch, summary):
    names = {f"{plane}_{body}" for plane in ("AA", "BB", "AA_peak", "BB_peak") for body in ("rail", "wheel")}
    stresses = ["von_mises_stress"] + ["stress_" + c for c in ("xx", "yy", "zz", "yz", "xz", "xy")]
    with h5py.File(path("slices.h5"), "r") as file:
        check(sorted(file) == sorted(patch), "slices.h5: the ticks of patch.h5")
        for tick, group in file.items():
            check(set(group) == names, f"slices.h5 {tick}: the planes")
            for name, cut in group.items():
                shape = (len(cut["position"]), len(cut["depth"]))
                good = all(text_of(cut[field].attrs["unit"]) == "Pa" and cut[field].shape == shape for field in stresses)
                good = good and all(text_of(cut[field].attrs["unit"]) == "m" for field in ("position", "depth"))
                good = good and all(text_of(cut[field].attrs["description"]) for field in cut)
                check(good and set(cut) == set(stresses) | {"position", "depth"}, f"{tick} {name}: names, units, shapes")
                mises, depth = cut["von_mises_stress"][:], cut["depth"][:]
                inside = np.isfinite(mises)
                check(inside.mean() > 0.5, f"{tick} {name}: {100 * inside.mean():.0f} % of the points are in the body")
                check(depth[0] == 0 and np.all(np.diff(depth) > 0) and 0.01 < depth[-1] < 0.02, f"{tick} {name}: depth")
                check(0 < np.nanmax(mises) <= 1.2 * max(summary["max_von_mises_nodal_Pa"], 1), f"{tick} {name}: range")
        # below the largest pressure both bodies are pressed: the stress along Y is that of the load
        last = sorted(file)[-1]
        for body in ("rail", "wheel"):
            cut = file[last]["AA_peak_" + body]
            middle = np.argmin(np.abs(cut["position"][:]))
            pressed = cut["stress_yy"][middle, :3]
            check(np.all(pressed < -1e8), f"{body}: compression below the contact, {pressed[0] / 1e6:.0f} MPa at the surface")
        # action and reaction: at the surface both bodies carry about the same normal stress
        rail, wheel = (file[last]["AA_peak_" + body] for body in ("rail", "wheel"))
        middle = np.argmin(np.abs(rail["position"][:]))
        ratio = wheel["stress_yy"][middle, 0] / rail["stress_yy"][middle, 0]
        check(0.6 < ratio < 1.7, f"stress of the wheel over that of the rail at the surface: {ratio:.2f}")


if __name__ == "__main__":
    with open(path("summary.json")) as stream:
        figures = json.load(stream)
    power = figures["frictional_power_W"] / figures["velocity_m_per_s"]
    check(figures["t_gamma_N"] > 0 and abs(power / figures["t_gamma_N"] - 1) < 1e-9, "summary.json: T-gamma and power")
    check(isinstance(figures["patches"], int), "summary.json: the number of patches is a whole number")
    change = figures["creepage_at_patch_centre"] - figures["creepage"]
    check(0 < abs(change) < 5e-3, f"summary.json: creepage at the patch centre differs by {change:.1e}")
    check(figures["finished"] is True and figures["stopped_because"] == "", "summary.json: finished")
    check(not glob.glob(path("*.part")) and not glob.glob(path("checkpoint*")), "nothing unfinished is left")
    check_history(figures)
    with h5py.File(path("patch.h5"), "r") as patches:
        check_patch(patches, figures)
        check_vtu(figures, patches)
        check_slices(patches, figures)
    finish()
