"""Rolls over a rail that yields and reads what slices.h5 holds of the unloaded rail behind the wheel.

Usage: residual_slices.py PROGRAM MPIEXEC

The laws: a free surface bears no normal stress; a steady pass leaves stresses of depth and lateral place only
(Merwin and Johnson 1963); far from the band there is no residual stress.
"""

import subprocess
import sys

import h5py
import numpy as np

from checks import SMALL_SCENE, check, finish

STEEL = """
  set Yield stress = 280 MPa
  set Tangent modulus = 21 GPa
"""
SCENE = f"""
set Title = residual stress
{SMALL_SCENE}
subsection Rail material{STEEL}end
subsection Wheel material{STEEL}end
subsection Run
  set Rolling distance = 64 mm
  set Averaging distance = 10 mm
end
subsection Output
  set Folder = run
  set Ticks = 2
  set Volume fields = false
end
"""
STRESSES = ["residual_von_mises_stress"] + ["stress_" + c for c in ("xx", "yy", "zz", "yz", "xz", "xy")]


def text_of(value):
    return value.decode() if isinstance(value, bytes) else value


with open("residual.prm", "w") as file:
    file.write(SCENE)
done = subprocess.run([sys.argv[1], "run", "residual.prm", "--overwrite"], stdout=subprocess.PIPE,
                      stderr=subprocess.STDOUT, text=True)
if done.returncode != 0:
    print(done.stdout)
check(done.returncode == 0, "the run has ended well")

with h5py.File("run/slices.h5") as slices:
    first, last = (slices[tick] for tick in sorted(slices))
    check(not any("behind" in name for name in first), "no unloaded rail after 32 mm: no slices of it")
    for name in ("AA_behind_rail", "BB_behind_rail"):
        check(set(last[name]) == set(STRESSES) | {"position", "depth", "plastic_strain"}, f"{name}: the datasets")
        shape = (len(last[name]["position"]), len(last[name]["depth"]))
        check(all(text_of(last[name][field].attrs["unit"]) == "Pa" and last[name][field].shape == shape
                  for field in STRESSES), f"{name}: units and shapes")
    along, across = (last[name] for name in ("AA_behind_rail", "BB_behind_rail"))
    rolled = last.attrs["rolled_distance_m"]
    place, depth = along["position"][:], along["depth"][:]
    check(place[0] >= -rolled and place[-1] < -0.02, f"unloaded from {1e3 * place[0]:.1f} to {1e3 * place[-1]:.1f} mm")
    check(abs(across.attrs["along_m"] - place[-1]) < 1e-12, "the plane across lies at the end of that along")
    mises, strain = along["residual_von_mises_stress"][:], along["plastic_strain"][:]
    check(np.all(np.isfinite(mises)), "all points along lie in the rail")
    components = np.stack([along[field][:] for field in STRESSES[1:]])
    normal, shear = components[:3], components[3:]
    again = np.sqrt(0.5 * ((normal - np.roll(normal, 1, axis=0))**2).sum(axis=0) + 3 * (shear**2).sum(axis=0))
    check(np.allclose(mises, again, rtol=1e-4, atol=1.), "the equivalent belongs to the components")
    peak = mises.max()
    check(5e7 < peak < 2.8e8, f"largest residual von Mises stress {1e-6 * peak:.0f} MPa, below the yield stress")
    check(1e-4 < strain.max() < 2e-2, f"largest plastic strain {1e3 * strain.max():.2f} thousandths")
    deep = depth > 13e-3
    check(np.all(strain[:, deep] == 0), "no plastic strain 13 mm below the surface")
    below = np.abs(along["stress_yy"][:]).max()
    flat = max(np.abs(along["stress_xx"][:]).max(), np.abs(along["stress_zz"][:]).max())
    check(below < 0.5 * flat, f"no load from above: {1e-6 * below:.0f} MPa upright, {1e-6 * flat:.0f} MPa in the plane")
    steady = mises[-3:, depth <= 4e-3]  # farther down nodes hang between two cell sizes
    spread = np.abs(steady - steady.mean(axis=0)).max() / peak
    check(spread < 0.05, f"the last three stations differ by {100 * spread:.1f} % of the largest stress")
    lateral, aside = across["position"][:], across["residual_von_mises_stress"][:]
    ends = np.nanmax(aside[[0, -1]])
    check(ends < 0.35 * np.nanmax(aside), f"at the ends of the plane across {1e-6 * ends:.0f} MPa")
finish()
