"""Pictures of wheel and rail in three dimensions: the mesh and von Mises' stress, as a whole and cut open at the
contact. VTK draws them off the screen, which Debian's needs a virtual display for (xvfb-run)."""

import os
import shutil
import subprocess
import sys
import xml.etree.ElementTree

import numpy as np

PACKAGES = "python3-vtk9, xvfb, xauth"


def missing():
    """What keeps the pictures from being drawn, or an empty string."""
    try:
        import vtkmodules.vtkCommonCore  # noqa: F401
    except ImportError:
        return "Python's vtk is not installed"
    if not os.environ.get("DISPLAY") and not shutil.which("xvfb-run"):
        return "there is no display and no virtual one (xvfb-run)"
    return ""


def files_of(run):
    """The files of the whole mesh in volume.pvd, each with the distance rolled."""
    files = []
    for entry in xml.etree.ElementTree.parse(run.data.path("volume.pvd")).iter("DataSet"):
        rolled = "start"
        if run.history is not None and float(entry.get("timestep")) > 0:
            place = np.interp(float(entry.get("timestep")), run.history["time"], run.history["rolled_distance"])
            rolled = f"{1e3 * place:.0f} mm rolled"
        files += [run.data.path(entry.get("file")), rolled]
    return files


def draw_all(run):
    """All pictures, a list of (caption, path); a remark where they cannot be drawn."""
    name = "volume_end.vtu"
    if run.is_halfspace or run.patch is None:
        return []
    if not run.data.has(name):
        run.remarks.append(f"There is no {name} in {run.folder}; the pictures of wheel and rail are left out.")
        return []
    reason = missing()
    if reason:
        run.remarks.append(f"The pictures of wheel and rail are left out: {reason} (packages {PACKAGES}).")
        return []
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "body_scene.py")
    command = ["/usr/bin/python3", script, run.pictures_folder, *files_of(run)]
    if shutil.which("xvfb-run"):
        command = ["xvfb-run", "-a", "-s", "-screen 0 1400x1000x24", *command]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    pictures = [("Wheel and rail with their mesh, von Mises stress, at the end of the run", "bodies.png"),
                ("Cut across the track through the contact: mesh and von Mises stress", "bodies_cut.png"),
                ("The mesh along the path: cut across and along the track through the contact", "mesh_places.png")]
    drawn = [(caption, os.path.join(run.pictures_folder, file)) for caption, file in pictures
             if os.path.exists(os.path.join(run.pictures_folder, file))]
    if done.returncode != 0:
        last = (done.stderr.strip().splitlines() or ["no reason is given"])[-1]
        run.remarks.append(f"The pictures of wheel and rail could not be drawn: {last}")
        return []
    return drawn


if __name__ == "__main__":
    sys.exit("body_pictures.py is a part of report.py")
