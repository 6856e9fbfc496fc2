"""How often the truth lies within the intervals of 95 %, over random scenes with kept seeds (doc/theory/intervals.md).

Usage: interval_coverage.py PROGRAM FAMILY FIRST LAST
       interval_coverage.py --picture PICTURE FAMILY:FIRST:LAST ...   of the lines that are there

Families, whose input N is drawn from seed N:

  contacts  contacts of tests/random_contacts.py by half-spaces and by true bodies; truth: elements of half the size, and
            the straight line (creep) or parabola (pressure, extents) through both sizes towards none
  noise     the same by half-spaces with a measured rail whose points are moved by noise; truth: without the noise
  runs      elastic runs of 40 mm on cells of 1.5, 2 or 3 mm; truth: true bodies under the run's own forces on elements of
            0.5 and 0.25 mm, and towards none
  yielding  the same with steel that yields, on cells of 3 mm; truth: the run on cells of 1.5 mm, and the straight line
            (creep, plastic strain) or parabola through both sizes towards none
  impacts   irregular runs on cells of 3 mm; truth: the same
  meshes    in turn runs of the last two families on cells of 2 mm with Run/Error estimate = two meshes; truth: the run on
            cells of 1 mm, and towards none

Seeds to 2053 calibrated, of peak shear and worn section to 2113, of yielding runs the area to 2104, extents and creep
to 2121 (width: 2144); those after them judge. Truths are lines of truths.jsonl in the present folder and are not solved
again; those of the program are lines of FAMILY.jsonl, with the causes of their intervals. Printed: of each family and
result the share outside (at most 8 of 93), the median width of the interval over the value (of forces over the normal
force; of creepage and T-gamma, which may be near nought, where a quarter of what friction carries is asked for), and
the seeds outside. The picture shows of narrower intervals, too, how many hold the truth: spreads times a factor hold
the share that a normal error would leave in them where they are calibrated.
"""

import csv
import glob
import json
import os
import random
import shutil
import sys
from statistics import NormalDist

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "tests"))
from random_contacts import contact, contact_entries, known, scene_file  # noqa: E402
from random_search import TESTS, as_options, execute, log_uniform  # noqa: E402

CREEP = ("max_plastic_strain", "archard_section_m2", "max_shear_traction_Pa", "stick_fraction", "t_gamma_N", "creepage",
         "lateral_force_N", "longitudinal_force_N")
OF_RUNS = ("max_residual_von_mises_Pa", "largest_vertical_force_N", "least_vertical_force_N", "impact_factor",
           "largest_pressure_Pa")
RESULTS = ("max_pressure_Pa", "contact_area_m2", "patch_lateral_m", "patch_longitudinal_m", "approach_m") + CREEP + OF_RUNS
MOST_OUTSIDE = 8 / 93


def tail(key, name):
    """max_pressure_Pa, low: max_pressure_low_Pa."""
    for unit in ("_Pa", "_m2", "_N", "_m"):
        if key.endswith(unit):
            return key[:-len(unit)] + "_" + name + unit
    return f"{key}_{name}"


def chosen(summary, folder):
    """Its results with their intervals, and the causes of these."""
    names = [name for key in RESULTS for name in (key, tail(key, "low"), tail(key, "high"))]
    names += ["grid_spacing_m", "verdict", "finished", "normal_force_N", "friction_coefficient"]
    with open(os.path.join(folder, "intervals.csv")) as file:
        return {**{name: summary.get(name) for name in names}, "causes": list(csv.DictReader(file))}


def once(path, seed, kind, solve):
    """What `solve` gives, kept as a line of a file."""
    if os.path.exists(path):
        with open(path) as lines:
            for line in map(json.loads, lines):
                if (line["seed"], line["kind"]) == (seed, kind):
                    return line["results"]
    results = solve()
    with open(path, "a") as file:
        file.write(json.dumps({"seed": seed, "kind": kind, "results": results}) + "\n")
    return results


def limit_of(key, coarse, fine):
    """Towards elements of no size, from a size and half of it."""
    if coarse.get(key) is None or fine.get(key) is None:
        return None
    return fine[key] + (fine[key] - coarse[key]) / (1 if key in CREEP else 3)


def accepted(program, seed, scene, draw_entries, bodies="half-spaces"):
    """The first drawn entries that are solved, and their summary."""
    draw = random.Random(seed)
    for _ in range(20):
        options = as_options({"Wheelset/Traction coefficient": "0", **draw_entries(draw), "Output/Folder": scene[:-4]})
        summary, _ = contact(program, scene, bodies, options)
        if summary:
            return options, summary
    return None, None


def contacts(program, seed):
    scene = scene_file(seed)
    options, half = accepted(program, seed, scene, contact_entries)
    found = {}
    for bodies in ("half-spaces", "real") if half else ():
        summary = half if bodies == "half-spaces" else contact(program, scene, bodies, options)[0]
        if not summary or not summary["finished"]:
            continue
        own, size = chosen(summary, scene[:-4] + "-halfspace"), f"{500 * summary['grid_spacing_m']:.6g} mm"
        fine = once("truths.jsonl", seed, f"contacts {bodies}",
                    lambda: contact(program, scene, bodies, options + as_options({"Half-space/Element size": size}))[0] or {})
        found[bodies] = {"own": own, "truth": {key: limit_of(key, summary, fine) for key in RESULTS}}
    return found


def noisy(draw, path, deviation):
    """The points of a measured rail, each moved by noise across the head [mm]."""
    with open(os.path.join(TESTS, "profiles", "worn_54E1.ban")) as file:
        lines = file.read().splitlines()
    with open(path, "w") as file:
        for line in lines:
            words = line.split()
            if len(words) == 5:  # x, y, angle, curvature, number
                words[1] = f"{float(words[1]) + draw.gauss(0, deviation):.6f}"
            file.write("\t".join(words) + "\n")


def noise(program, seed):
    scene, draw = scene_file(seed), random.Random(-seed)
    path, deviation = os.path.abspath(f"contact_{seed}.ban"), log_uniform(draw, 0.002, 0.02)
    clean = os.path.join(TESTS, "profiles", "worn_54E1.ban")

    def entries(draw):
        return {**contact_entries(draw), "Profiles/Rail": clean}

    options, exact = accepted(program, seed, scene, entries)
    if not exact:
        return {}
    noisy(draw, path, deviation)
    own, _ = contact(program, scene, "half-spaces", [option.replace(clean, path) for option in options])
    truth = {key: exact.get(key) for key in RESULTS}
    return {"half-spaces": {"own": chosen(own, scene[:-4] + "-halfspace"), "truth": truth}} if own else {}


def run_entries(draw):
    return {"Profiles/Wheel": draw.choice(["S1002", os.path.join(TESTS, "profiles", "worn_S1002.prw")]),
            "Profiles/Rail": draw.choice(["54E1", "60E1"]),
            "Wheelset/Lateral shift": f"{draw.uniform(-3.5, 3.5):.3g} mm",
            "Wheelset/Wheel load": f"{draw.uniform(60, 180):.4g} kN",
            "Wheelset/Traction coefficient": f"{draw.uniform(-0.3, 0.3):.3g}",
            "Contact/Friction coefficient": f"{draw.uniform(0.35, 0.6):.3g}",
            "Wheelset/Velocity": f"{draw.uniform(60, 250):.3g} km/h"}


def run(program, scene, entries, cells):
    """Summary of a run on cells of a size [mm]; None where it fails."""
    options = as_options({"Run/Rolling distance": "40 mm", "Run/Averaging distance": "16 mm", "Output/Ticks": "2",
                          "Output/Volume fields": "false", **entries, "Mesh/Solution cell size": f"{cells} mm",
                          "Mesh/Coarse cell size": f"{8 * cells} mm", "Output/Folder": scene[:-4]})
    code, _ = execute(program, "run", scene, "--overwrite", *options)
    path = os.path.join(scene[:-4], "summary.json")
    if code != 0 or not os.path.exists(path):
        return None
    with open(path) as file:
        return json.load(file)


def true_bodies(program, folder, size):
    """What they give under the forces of a run, on elements of a size."""
    execute(program, "compare", folder, "--no-pictures", "--set", f"Half-space/Element size = {size}")
    with open(os.path.join(folder, "summary.json")) as file:
        compared = json.load(file)
    return {key: compared.get("bodies_" + key) for key in RESULTS}


def runs(program, seed):
    scene, draw = scene_file(seed), random.Random(seed)
    cells = draw.choice([1.5, 2, 3])
    own = run(program, scene, run_entries(draw), cells)
    if not own:
        return {}
    results = chosen(own, scene[:-4])
    coarse, fine = (true_bodies(program, scene[:-4], size) for size in ("0.5 mm", "0.25 mm"))
    return {f"{cells} mm": {"own": results, "truth": {key: limit_of(key, coarse, fine) for key in RESULTS}}}


def with_half(program, seed, family, entries, cells=3):
    """A run on cells of a size [mm], and what those of half of it say of it."""
    scene, truth = scene_file(seed), {**entries, "Run/Error estimate": "model"}
    own = run(program, scene, entries, cells)
    results = own and chosen(own, scene[:-4])
    fine = own and once("truths.jsonl", seed, family, lambda: run(program, scene, truth, cells / 2) or {})
    return {f"{cells} mm": {"own": results, "truth": {key: limit_of(key, own, fine) for key in RESULTS}}} if fine else {}


def yielding_entries(seed):
    draw = random.Random(seed)
    entries, stress = run_entries(draw), log_uniform(draw, 300, 700)
    for body in ("Rail material", "Wheel material"):
        entries.update({f"{body}/Yield stress": f"{stress:.3g} MPa", f"{body}/Tangent modulus": "21 GPa"})
    return entries


def impact_entries(seed):
    draw = random.Random(seed)
    kind, length = draw.choice(["dent", "squat", "dipped joint", "flat", "corrugation"]), draw.uniform(20, 50)
    entries = {"Wheelset/Lateral shift": f"{draw.uniform(-2, 2):.3g} mm",
               "Wheelset/Wheel load": f"{draw.uniform(60, 140):.4g} kN",
               "Wheelset/Velocity": f"{log_uniform(draw, 40, 200):.3g} km/h", "Wheelset/Traction coefficient": "0",
               "Run/Rolling distance": "80 mm", "Run/Averaging distance": "6 mm", "Run/Evaluate at": "largest force",
               "Irregularity 1/Kind": kind, "Irregularity 1/Place": "35 mm", "Irregularity 1/Length": f"{length:.3g} mm"}
    if kind == "dipped joint":
        entries["Irregularity 1/Angle"] = f"{draw.uniform(3, 12):.3g} mrad"
    elif kind != "flat":
        entries["Irregularity 1/Depth"] = f"{draw.uniform(0.02, 0.15):.3g} mm"
    if kind == "squat":
        entries["Irregularity 1/Width"] = f"{draw.uniform(20, 40):.3g} mm"
    if kind == "corrugation":
        entries.update({"Irregularity 1/Wavelength": f"{length:.3g} mm", "Irregularity 1/Length": "60 mm"})
    return entries


def yielding(program, seed):
    return with_half(program, seed, "yielding", yielding_entries(seed))


def impacts(program, seed):
    return with_half(program, seed, "impacts", impact_entries(seed))


def meshes(program, seed):
    kind, entries = ("impacts", impact_entries) if seed % 2 else ("yielding", yielding_entries)
    two = {**entries(seed), "Run/Error estimate": "two meshes"}
    return {f"{kind} {size}": found for size, found in with_half(program, seed, f"{kind} 1 mm", two, 2).items()}


def scale_of(key, own):
    """What the width of an interval is held against; None where it is no measure."""
    force = own["normal_force_N"]
    if key in ("lateral_force_N", "longitudinal_force_N") and force:
        return force
    if key in ("creepage", "t_gamma_N", "archard_section_m2") and own.get("friction_coefficient") and own["longitudinal_force_N"]:
        if abs(own["longitudinal_force_N"]) < 0.25 * own["friction_coefficient"] * force:
            return None
    return max(abs(own[key]), 1e-30)


def print_coverage(family, lines):
    kinds = sorted({kind for line in lines for kind in line["results"]})
    for kind in kinds:
        for key in RESULTS:
            outside, n, widths = [], 0, []
            for line in lines:
                pair = line["results"].get(kind, {})
                truth, own = pair.get("truth", {}).get(key), pair.get("own", {})
                low, high = own.get(tail(key, "low")), own.get(tail(key, "high"))
                if None in (truth, low, high, own.get(key)):
                    continue
                n += 1
                if scale_of(key, own):
                    widths.append((high - low) / scale_of(key, own))
                if not low <= truth <= high:
                    outside.append(line["seed"])
            if n:
                word = "well" if len(outside) <= MOST_OUTSIDE * n else "TOO MANY"
                print(f"{family} {kind:11} {key:22} {len(outside):3} of {n:3} outside, {word:8} "
                      f"median width {100 * sorted(widths or [0])[len(widths) // 2]:6.2f} %  {outside}")


def picture(path, families):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    names = {"max_pressure_Pa": "peak", "contact_area_m2": "area", "creepage": "creepage", "t_gamma_N": "T-gamma",
             "lateral_force_N": "lateral force", "largest_vertical_force_N": "largest force"}
    figure, panels = plt.subplots(1, len(families), sharey=True, figsize=(3 * len(families), 3.2), constrained_layout=True)
    shares = [k / 100 for k in range(0, 100)] + [0.99, 0.995]
    for axes, (family, first, last) in zip(panels, families):
        lines = [line for seed, line in known(f"{family}.jsonl").items() if int(first) <= seed <= int(last)]
        for key, name in names.items():
            reach = []  # of the truth from the middle of (1), in spreads
            for pair in (pair for line in lines for pair in line["results"].values()):
                truth, own = pair["truth"].get(key), pair["own"]
                causes = [cause for cause in own["causes"] if key.startswith(cause["result"])]
                spread = sum(float(cause["spread"]) ** 2 for cause in causes) ** 0.5
                if truth is not None and own.get(tail(key, "low")) is not None and spread > 0:
                    reach.append(abs(truth - own[key] - sum(float(cause["shift"]) for cause in causes)) / spread)
            if len(reach) >= 10:
                held = [sum(one <= NormalDist().inv_cdf(0.5 + share / 2) / 1.96 for one in reach) / len(reach)
                        for share in shares]
                axes.plot(shares, held, label=f"{name}, {len(reach)}")
        axes.plot((0, 1), (0, 1), color="0.4", linewidth=0.8)
        axes.set(title=family, xlabel="share that should be within", xlim=(0, 1), ylim=(0, 1.02))
        axes.legend(loc="lower right", fontsize="small")
        axes.grid(alpha=0.3)
    panels[0].set_ylabel("share of truths within")
    figure.savefig(path, dpi=110)


FAMILIES = {"contacts": contacts, "noise": noise, "runs": runs, "yielding": yielding, "impacts": impacts,
            "meshes": meshes}


def main():
    if sys.argv[1] == "--picture":
        picture(sys.argv[2], [family.split(":") for family in sys.argv[3:]])
        return
    program, family, first, last = os.path.abspath(sys.argv[1]), sys.argv[2], int(sys.argv[3]), int(sys.argv[4])
    path = f"{family}.jsonl"
    for seed in range(first, last + 1):
        if seed not in known(path):
            results = FAMILIES[family](program, seed)
            with open(path, "a") as file:
                file.write(json.dumps({"seed": seed, "results": results}) + "\n")
            for left in glob.glob(f"contact_{seed}*"):
                shutil.rmtree(left) if os.path.isdir(left) else os.remove(left)
    print_coverage(family, [line for seed, line in sorted(known(path).items()) if first <= seed <= last])


if __name__ == "__main__":
    main()
