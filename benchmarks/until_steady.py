#!/usr/bin/python3
"""How far runs that end by themselves are from the same scenes over a given distance, in their own standard errors.

Usage: benchmarks/until_steady.py STEADY GIVEN

Both are folders of studies, or of runs whose folders have the same names in both. Studies:

    ./wheelrail study prm/studies/friction.prm
    ./wheelrail study prm/studies/friction.prm --set "Run/Rolling distance = 60 mm" --set "Output/Folder = output/given"
    benchmarks/until_steady.py output/studies/friction output/given

Prints a line a scene (where it ended and why, deviations over errors) and what all results come to.
"""

import json
import os
import re
import sys

# forces on the wheel, creepage, and the figures of the patch
FIGURES = {"vertical force": "vertical_force{}_N", "longitudinal force": "longitudinal_force{}_N",
           "lateral force": "lateral_force{}_N", "creepage": "creepage{}", "peak pressure": "max_pressure_fitted{}_Pa",
           "area": "contact_area{}_m2", "peak shear": "max_shear_traction{}_Pa", "sticking part": "stick_fraction{}",
           "T-gamma": "t_gamma{}_N"}


def summaries(folder):
    """Summaries of the finished runs below a folder by their names, without the digest of a study."""
    found = {}
    for name in sorted(os.listdir(folder)):
        path = os.path.join(folder, name, "summary.json")
        if os.path.exists(path) and not name.endswith("-halfspace"):
            with open(path, encoding="utf-8") as file:
                summary = json.load(file)
            if summary.get("finished"):
                found[re.sub(r"-[0-9a-f]{8,}$", "", name)] = summary
    return found


def ratios_of(steady, given):
    """Deviation over standard error of each figure that both have."""
    ratios = {}
    for name, key in FIGURES.items():
        one, other, error = steady.get(key.format("")), given.get(key.format("")), steady.get(key.format("_error"))
        if None not in (one, other, error):
            ratios[name] = (one - other) / error if error else (0.0 if one == other else float("inf"))
    return ratios


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    steady, given = summaries(sys.argv[1]), summaries(sys.argv[2])
    ratios = []
    print("scene; ended at mm, why; " + ", ".join(FIGURES))
    for name in steady:
        if name not in given:
            continue
        of_scene = ratios_of(steady[name], given[name])
        if steady[name].get("ended") == "steady":
            ratios += of_scene.values()
        print(f"{name}; {1e3 * steady[name]['rolled_distance_m']:.1f} mm, {steady[name].get('ended_because')}; " +
              ", ".join(f"{ratio:+.2f}" for ratio in of_scene.values()))
    if ratios:
        within = sum(abs(ratio) <= 2 for ratio in ratios) / len(ratios)
        print(f"{len(ratios)} results of scenes that became steady: {100 * within:.1f} % within two errors, "
              f"largest {max(abs(ratio) for ratio in ratios):.2f}, mean {sum(ratios) / len(ratios):+.2f}")


if __name__ == "__main__":
    main()
