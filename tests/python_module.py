"""source/report/wheelrail.py on a finished run: arrays with units that agree with the files, words for what is missing.

Usage: python_module.py PROGRAM MPIEXEC FOLDER
"""

import os
import sys
import tempfile

import h5py
import numpy as np

from checks import check, finish

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "source", "report"))
sys.dont_write_bytecode = True
import history_pictures  # noqa: E402
import inputs  # noqa: E402
import wheelrail  # noqa: E402


def message(work, kind=wheelrail.DataError):
    try:
        work()
    except kind as error:
        return str(error)
    return ""


run = wheelrail.load(sys.argv[3])
force = run.history["longitudinal_force"]
with h5py.File(run.path("history.h5"), "r") as file:
    check(np.array_equal(force, file["longitudinal_force"][:]), "a column is that of the file")
check(force.unit == "N" and force.to("kN").unit == "kN" and np.allclose(force.to("kN"), 1e-3 * np.asarray(force)),
      "its unit, and another one")
check(force[3:].unit == "N" and type(2 * force) is np.ndarray and type(force.max()) is np.float64,
      "a part keeps the unit, what is computed is plain")
check("cannot be given in MPa" in message(lambda: force.to("MPa")), "a unit that does not fit is refused")
with h5py.File(run.path("patch.h5"), "r") as file:
    names = sorted(file)
    check(len(run.patch) == len(names), "as many ticks as in the file")
    check(np.array_equal(run.patch[-1]["pressure"], file[names[-1]]["pressure"][:]), "the last tick is the last")
    check(run.patch[0].attributes["time_s"] == file[names[0]].attrs["time_s"], "attributes of the first")
check([tick.name for tick in run.patch] == names and len(run.patch[1:]) == len(names) - 1, "ticks can be gone through")
cut = run.slices[-1]["AA_rail"]
check(cut["von_mises_stress"].shape == (len(cut["position"]), len(cut["depth"])) and cut["depth"].unit == "m",
      "a plane below the contact")
check(abs(run.summary["normal_force_N"] / np.sum(run.patch[-1]["pressure"] * run.patch[-1]["area"]) - 1) < 0.05,
      "the pressures of a tick sum up to the load of the summary")
check(run.figures["max_pressure_Pa"]["label"] == "peak pressure", "labels of the figures")
check("./wheelrail compare makes it" in message(lambda: run.halfspace, wheelrail.MissingFile),
      "a file that is missing is named, with what makes it")
volume = wheelrail.load_vtu(run.path("volume_end.vtu"))
check(volume["von_mises_stress"].unit == "Pa" and volume["points"].shape[1] == 3
      and volume["cells"].shape == (run.summary["elements"], 8), "a VTU file")
check("There is no folder" in message(lambda: wheelrail.load("nowhere")), "a folder that is not there")
with tempfile.TemporaryDirectory() as empty:
    check("summary.json" in message(lambda: wheelrail.load(empty).summary, wheelrail.MissingFile), "an empty folder")
rails = {"Profiles/Wheel": "S1002", "Profiles/Rail": "sections/wing.slcs", "Profiles/Second rail": "sections/nose.slcs"}
check(inputs.rows(rails)[0][1].startswith("S1002 wheel on rails wing.slcs and nose.slcs,"), "a page names both rails")
shares = {name: wheelrail.Array([1.0, 2.0], "N") for name in ("vertical_force", "first_rail_force", "lateral_force")}
check(history_pictures.force_groups(shares) == [["vertical_force"], ["lateral_force"]],
      "forces on two rails have no mean, which the summary does not know, nor a place among small ones")
finish()
