"""Rolls over a rail that yields and reads what slices.h5 holds of the rail behind the wheel, and residual.h5 of the
unloaded rail.

Usage: residual_slices.py PROGRAM MPIEXEC

The laws: no stress beyond the yield stress, hardened by the plastic strain; no force across a free surface; a steady pass
leaves stresses of depth and lateral place only, compression at the surface (Merwin and Johnson 1963); beside a band that
has flowed the stress falls at least as the square of the distance.
"""

import json
import subprocess
import sys

import h5py
import numpy as np

from checks import SMALL_SCENE, check, finish

YOUNG, YIELD, TANGENT = 210e9, 280e6, 21e9
STEEL = f"""
  set Yield stress = {1e-6 * YIELD:g} MPa
  set Tangent modulus = {1e-9 * TANGENT:g} GPa
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
    hardened = YIELD + YOUNG * TANGENT / (YOUNG - TANGENT) * strain
    check(np.all(mises <= hardened),
          f"residual von Mises stress, {1e-6 * peak:.0f} MPa at most, nowhere beyond the hardened yield stress")
    # misfit strains of more than twice the yield strain would be far beyond the yield stress if nothing yielded
    check(strain.max() > 2 * YIELD / YOUNG and peak > 0.5 * YIELD,
          f"plastic strain up to {1e3 * strain.max():.2f} thousandths leaves stress of the order of the yield stress")
    deep = depth > 13e-3
    check(np.all(strain[:, deep] == 0), "no plastic strain 13 mm below the surface")
    for name in ("stress_xx", "stress_zz"):
        check(np.all(along[name][:][:, 0] < 0), f"{name}: compression at the surface")
    surface = {name: across[name][:][:, 0] for name in ("stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_yz")}
    largest = max(np.abs(surface[name]).max() for name in ("stress_xx", "stress_zz"))
    for name in ("stress_yy", "stress_xy", "stress_yz"):
        mean = surface[name].mean()
        # 1 % for each mm of the cells
        check(abs(mean) < 0.04 * largest, f"{name}: {100 * mean / largest:.1f} % of the largest, mean across the free surface")
    # the wheel's own stress at these places (Boussinesq, Cerruti) is 3 to 10 MPa: 1 to 5 % of the largest
    steady = mises[-3:, depth <= 4e-3]  # farther down nodes hang between two cell sizes
    spread = np.abs(steady - steady.mean(axis=0)).max() / peak
    check(spread < 0.03, f"the last three stations differ by {100 * spread:.1f} % of the largest stress")
    lateral, aside = across["position"][:], across["residual_von_mises_stress"][:]
    flowed = lateral[np.nanmax(across["plastic_strain"][:], axis=1) > 0]
    cell = lateral[1] - lateral[0]
    middle, half = (flowed[0] + flowed[-1]) / 2, (flowed[-1] - flowed[0] + cell) / 2
    for end in (0, -1):
        # from half a cell below the surface on: at the edge of the strip that is carried there from 4 mm cells
        rest, far = np.nanmax(aside[end, 1:]), abs(lateral[end] - middle)
        check(rest < (half / far)**2 * np.nanmax(aside[:, 1:]),
              f"{1e3 * far:.0f} mm from the middle of a band {2e3 * half:.0f} mm wide: {1e-6 * rest:.0f} MPa of "
              f"{1e-6 * np.nanmax(aside[:, 1:]):.0f}")

    # the loads taken off: what the wheel does to the rail behind it is gone, what flow has left stays
    with h5py.File("run/residual.h5") as residual:
        (tick,) = residual.values()
        unloaded = tick["AA_behind_rail"]
        check(set(unloaded) == set(STRESSES) | {"position", "depth", "plastic_strain", "forward_shear"},
              "residual.h5: the datasets")
        reach, far = unloaded["position"][:], len(place)
        check(reach[-1] > place[-1] + 0.01 and np.allclose(reach[:far], place),
              f"the unloaded rail reaches to {1e3 * reach[-1]:.1f} mm behind the axle")
        for name in ("stress_xx", "stress_yy", "stress_zz"):
            change = np.abs(unloaded[name][:][:far] - along[name][:])[:, depth <= 13e-3].max()
            check(0.005 < change / largest < 0.07, f"{name}: the wheel's own was {100 * change / largest:.1f} % of the largest")
        top = np.abs(tick["BB_behind_rail"]["stress_yy"][:][:, 0].mean())
        check(top < 0.02 * largest, f"no force across the free surface: {100 * top / largest:.2f} % of the largest")
        summary = json.load(open("run/summary.json"))
        check(summary["max_residual_von_mises_Pa"] > 0.8 * unloaded["residual_von_mises_stress"][:][:, 1:].max(),
              f"summary.json: {1e-6 * summary['max_residual_von_mises_Pa']:.0f} MPa")
finish()
