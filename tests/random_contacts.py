"""Random contacts that need no run: what is wrong in them is never trusted.

Usage: random_contacts.py PROGRAM MPIEXEC FAMILY FIRST LAST

Input N of a family is drawn from seed N. Families:

  halfspaces  profiles, cones, shift, yaw, load, elastic constants, friction and traction, solved by `halfspace` with
              half-spaces and with true bodies, and every third by `wear`: half-spaces that either trusts lie within
              5.2 % of the peak of the true bodies
  noise       the same with noise in the points of profiles: a verdict trusted lies within 5 % of the true bodies with
              the profile before the noise
  bodies      what `halfspace`, and `vehicle` for a row, answer with by default, over more entries (two patches, curves,
              unlike steels, elements, noise in worn profiles): what is trusted lies within 5 % of the true bodies on
              elements of 0.25 mm with exact profiles, in peak pressure, area and T-gamma, and its forces within 5 % of
              the friction limit
  runs        runs on cells of 1.5 mm, 40 mm rolled: the same of those that are trusted, under their own forces
  heights     a dent as a table of heights in another form (separators, decimal commas, units, order of rows and
              columns, unequal spacing): the same pressure and drop as by the entries Kind = dent within 1 %
  caches      kept tables of true bodies with bytes that were changed, cut off, added or taken from another table: the
              same answer to the last digit

What came of each input is a line of FAMILY.jsonl in the present folder; seeds that have one are not solved again.
"""

import csv
import glob
import json
import math
import os
import random
import re
import shutil
import sys

from checks import check, finish
from random_search import NOISES, TESTS, as_options, damaged, exact, execute, log_uniform, noisy, sentence_of

HELD = 0.052


def contact_entries(draw):
    """Changed entries of a contact, each with a probability of 0.3."""
    def number(low, high, unit="", digits=4):
        return f"{draw.uniform(low, high):.{digits}g} {unit}".strip()

    profiles = os.path.join(TESTS, "profiles")
    found = {
        "Profiles/Wheel": draw.choice(["S1002", "cone 1:20", "cone 1:40", os.path.join(profiles, "worn_S1002.prw")]),
        "Profiles/Rail": draw.choice(["54E1", "60E1", "60E1", os.path.join(profiles, "worn_54E1.ban")]),
        "Track/Gauge": number(1430, 1445, "mm"),
        "Track/Rail inclination": draw.choice(["0", "1/20", "1/30"]),
        "Wheelset/Nominal rolling radius": number(420, 600, "mm"),
        "Wheelset/Lateral shift": draw.choice([number(-6, 6, "mm"), number(-3, 3, "mm")]),
        "Wheelset/Yaw": draw.choice([number(-10, 10, "mrad"), number(-3, 3, "mrad")]),
        "Wheelset/Wheel load": f"{log_uniform(draw, 10, 300):.3g} kN",
        "Wheelset/Velocity": f"{log_uniform(draw, 20, 300):.3g} km/h",
        "Wheelset/Traction coefficient": number(-0.4, 0.4),
        "Contact/Friction coefficient": number(0.1, 0.8),
    }
    for body in ("Rail material", "Wheel material"):
        found[body + "/Young's modulus"] = draw.choice([number(180, 230, "GPa"), f"{log_uniform(draw, 20, 1000):.3g} GPa"])
        found[body + "/Poisson's ratio"] = draw.choice([number(0.2, 0.35), number(0, 0.49)])
    return {name: value for name, value in found.items() if draw.random() < 0.3}


def contact(program, scene, bodies, options):
    """Summary of the contact with some bodies (none: those that answer by default), or the sentence that refuses it."""
    code, screen = execute(program, "halfspace", scene, "--no-pictures", *(("--bodies", bodies) if bodies else ()), *options)
    if code not in (0, 1, 2) or "fault in the program" in screen:
        return None, screen[-3000:]
    if code == 1:
        return None, sentence_of(screen)
    with open(scene.replace(".prm", "-halfspace/summary.json")) as text:
        return json.load(text), ""


def wear_verdict(program, scene, options):
    """Of a few hundred passages, whose profiles are as good as new."""
    _, screen = execute(program, "wear", scene, "--no-pictures", "--set", "Wear/Gross load = 0.001 Mt", *options)
    words = re.findall("^verdict: (trusted|with care|not trusted)", screen, re.MULTILINE)
    return words[-1] if words else "refused"


def scene_file(seed, lines=""):
    path = f"contact_{seed}.prm"
    with open(path, "w") as file:
        file.write("# more entries by --set\n" + lines)
    return path


def halfspaces(program, seed):
    draw, refused, scene = random.Random(seed), [], scene_file(seed)
    while True:
        chosen = {"Wheelset/Traction coefficient": "0", **contact_entries(draw), "Output/Folder": scene[:-4]}
        options = as_options(chosen)
        half, why = contact(program, scene, "half-spaces", options)
        if half:
            break
        if "\n" in why or not why:
            return {"fault": why, "entries": chosen}
        refused.append(why)
    result = {"entries": chosen, "refused": refused, "halfspaces": half["verdict"], "doubts": half["doubts"]}
    real, why = contact(program, scene, "real", options)
    result["bodies"] = real["verdict"] if real else why
    if real and real["finished"] and half["max_pressure_Pa"]:
        result["miss"] = half["max_pressure_Pa"] / real["max_pressure_Pa"] - 1
    if seed % 3 == 0:
        result["wear"] = wear_verdict(program, scene, options)
    beyond = [name for name in ("halfspaces", "wear")
              if result.get(name) == "trusted" and not abs(result.get("miss", 1)) <= HELD]
    if beyond:
        result["fault"] = f"{' and '.join(beyond)} trusted, {100 * result.get('miss', math.nan):+.1f} %"
    return result


def noise(program, seed):
    draw, refused, scene = random.Random(seed), [], scene_file(seed)
    while True:
        chosen = {"Wheelset/Traction coefficient": "0", **contact_entries(draw), "Output/Folder": scene[:-4]}
        sides = draw.choice([("Wheel",), ("Rail",), ("Wheel", "Rail")])
        for side, name in (("Wheel", "manchester_S1002.txt"), ("Rail", "manchester_UIC60.txt")):
            if side in sides:
                chosen[f"Profiles/{side}"] = noisy(name, draw.choice(NOISES))
        bodies = draw.choice(["half-spaces", "real"])
        found, why = contact(program, scene, bodies, as_options(chosen))
        if found:
            break
        if "\n" in why or not why:
            return {"fault": why, "entries": chosen}
        refused.append(why)
    real, why = contact(program, scene, "real", as_options({name: exact(value) for name, value in chosen.items()}))
    result = {"entries": chosen, "refused": refused, "noise": found["verdict"], "doubts": found["doubts"]}
    if real and real["finished"] and found["max_pressure_Pa"]:
        result["miss"] = found["max_pressure_Pa"] / real["max_pressure_Pa"] - 1
    if result["noise"] == "trusted" and not abs(result.get("miss", 1)) <= 0.05:
        result["fault"] = f"trusted, {100 * result.get('miss', math.nan):+.1f} %, {why}"
    return result


def answer_entries(draw):
    """Changed entries of a contact whose answer may be trusted: those of contact_entries() and others."""
    def number(low, high, unit="", digits=4):
        return f"{draw.uniform(low, high):.{digits}g} {unit}".strip()

    chosen, more = contact_entries(draw), {
        "Wheelset/Lateral shift": draw.choice([number(-6, -4, "mm"), number(4, 8, "mm")]),
        "Half-space/Element size": draw.choice(["0.25 mm", "0.3 mm", f"{log_uniform(draw, 0.15, 1.2):.2g} mm"]),
        "Half-space/Spin": "contact",
        "Contact/Friction law": draw.choice(["exponential", "rational"]),
        "Wheelset/Drive": "rate",
        "Wheelset/Creepage": number(-0.004, 0.004),
        "Track/Radius": f"{draw.choice([-1, 1]) * log_uniform(draw, 200, 3000):.4g} m",
        "Wheelset/Roll": "from contact",
        "Wheelset/Rim inner radius": number(370, 400, "mm"),
        "Wheelset/Disc thickness": number(15, 60, "mm"),
        "Rail material/Steel": draw.choice(["R200", "R260", "R350HT"]),
        "Wheel material/Steel": draw.choice(["ER6", "ER7", "ER9"])}
    chosen.update({name: value for name, value in more.items() if draw.random() < 0.15})
    for side, name in (("Wheel", "worn_S1002.prw"), ("Rail", "worn_54E1.ban"), ("Rail", "manchester_UIC60.txt")):
        if draw.random() < 0.15:
            chosen[f"Profiles/{side}"] = noisy(name, draw.choice([0.001, 0.002] + NOISES))
    return chosen


def trusted_misses(own, real, friction):
    """Of the peak, area, T-gamma and forces: what misses by how much, over themselves or the friction limit."""
    limit = friction * real["vertical_force_N"]
    found = {name: own[name] / real[name] - 1 for name in ("max_pressure_Pa", "contact_area_m2") if real[name]}
    for name, least in (("lateral_force_N", limit), ("longitudinal_force_N", limit), ("t_gamma_N", 0)):
        if real[name] is not None and own[name] is not None:
            found[name] = (own[name] - real[name]) / max(abs(real[name]), least, 1)
    return found


FINE = {"Half-space/Element size": "0.25 mm"}


def by_row(program, scene, options, row):
    """The contact of one row of a vehicle simulation, as the summary of `halfspace` names its results."""
    path = scene[:-4] + ".csv"
    with open(path, "w") as file:
        file.write(";".join(row) + "\n" + ";".join(row.values()) + "\n")
    code, screen = execute(program, "vehicle", scene, path, "--no-pictures", "--overwrite", *options)
    if code not in (0, 1, 2) or "fault in the program" in screen:
        return None, screen[-3000:]
    if code == 1:
        return None, sentence_of(screen)
    with open(scene[:-4] + "-vehicle/vehicle.csv") as file:
        found = next(csv.DictReader(file))
    results = {name[len("right_"):]: float(value) for name, value in found.items() if name.startswith("right_") and value}
    grades = ("not trusted", "with care", "trusted")
    return {**results, "verdict": grades[int(results.get("verdict", 0))], "doubts": screen, "finished": True}, ""


def answers(program, seed):
    draw, refused, scene = random.Random(seed), [], scene_file(seed)
    while True:
        # loads that steel bears, and elements that are small enough for most
        chosen = {"Wheelset/Traction coefficient": f"{draw.uniform(-0.4, 0.4):.3g}", "Half-space/Element size": "0.3 mm",
                  "Wheelset/Wheel load": f"{draw.uniform(15, 80):.3g} kN", **answer_entries(draw), "Output/Folder": scene[:-4]}
        row = {"time [s]": "0", "lateral shift [mm]": f"{draw.uniform(-4, 5):.3g}", "yaw [mrad]": f"{draw.uniform(-8, 8):.3g}",
               "load [kN]": f"{draw.uniform(20, 100):.3g}", "curvature [1/m]": f"{draw.uniform(-0.004, 0.004):.3g}"}
        row = row if seed % 5 == 0 else None
        own, why = by_row(program, scene, as_options(chosen), row) if row else contact(program, scene, "", as_options(chosen))
        if own:
            break
        if "\n" in why or not why:
            return {"fault": why, "entries": chosen}
        refused.append(why)
    result = {"entries": chosen, "row": row, "refused": refused, "bodies": own["verdict"], "doubts": own["doubts"][-600:]}
    if not own["finished"]:
        return result
    of_halfspaces = "Half-space/Spin" in chosen  # which true bodies do not take
    options = as_options({**{name: exact(value) for name, value in chosen.items() if name != "Half-space/Spin"}, **FINE})
    real, why = by_row(program, scene, options, row) if row else contact(program, scene, "real", options)
    if not real or not real["finished"]:
        return {**result, "no_truth": why}
    result["misses"] = trusted_misses(own, real, float(chosen.get("Contact/Friction coefficient", "0.5")))
    result["miss"] = result["misses"]["max_pressure_Pa"]
    beyond = {name: round(100 * miss, 1) for name, miss in result["misses"].items()
              if not abs(miss) <= 0.05 and (name == "max_pressure_Pa" or not of_halfspaces)}
    if own["verdict"] == "trusted" and beyond:
        result["fault"] = f"trusted, {beyond} %"
    return result


def runs(program, seed):
    draw, refused, scene = random.Random(seed), [], scene_file(seed)
    fixed = {"Mesh/Solution cell size": "1.5 mm", "Mesh/Coarse cell size": "24 mm", "Run/Rolling distance": "40 mm",
             "Run/Averaging distance": "16 mm", "Output/Ticks": "2", "Output/Volume fields": "false",
             "Output/Folder": scene[:-4]}
    while True:
        chosen = {"Wheelset/Traction coefficient": "0", **contact_entries(draw), **fixed}
        code, screen = execute(program, "run", scene, "--overwrite", *as_options(chosen))
        if code == 0:
            break
        if code not in (1, 2) or not sentence_of(screen):
            return {"fault": screen[-3000:], "entries": chosen}
        refused.append(sentence_of(screen))
    with open(f"{scene[:-4]}/summary.json") as file:
        own = json.load(file)
    result = {"entries": chosen, "refused": refused, "runs": own["verdict"], "doubts": own["doubts"]}
    code, screen = execute(program, "compare", scene[:-4], "--no-pictures", *as_options(FINE))
    with open(f"{scene[:-4]}/summary.json") as file:
        compared = json.load(file)
    real = {name[len("bodies_"):]: value for name, value in compared.items() if name.startswith("bodies_")}
    if real.get("max_pressure_Pa"):
        result["misses"] = {name: own[name] / real[name] - 1 for name in ("max_pressure_Pa", "contact_area_m2", "t_gamma_N")
                            if real.get(name) and own.get(name)}
        result["miss"] = result["misses"]["max_pressure_Pa"]
        beyond = {name: round(100 * miss, 1) for name, miss in result["misses"].items() if not abs(miss) <= 0.05}
        if own["verdict"] == "trusted" and beyond:
            result["fault"] = f"trusted, {beyond} %"
    return result


def dent_table(draw, depth, length):
    """A dent d cos^2(pi z / l) as a table [mm] in some form, as a text."""
    decimal, unit = draw.choice(".,"), draw.choice(["mm", "um", "m"])
    separator = draw.choice([";", "\t"] if decimal == "," else [",", ";", "\t", " "])
    along = draw.choice(["mm", "m"])
    places = [length * (k / 80 - 0.5) for k in range(81)]
    if draw.random() < 0.5:  # unequal spacing
        places = sorted([places[0], places[-1]] + [z + draw.uniform(-0.3, 0.3) * length / 80 for z in places[1:-1]])
    per_mm = {"mm": 1, "m": 1e-3, "um": 1e3}
    rows = [(z * per_mm[along], -depth * math.cos(math.pi * z / length) ** 2 * per_mm[unit]) for z in places]
    form = draw.choice(["{}_{}", "{} [{}]", "{} ({})"])
    names = [form.format("along", along), form.format("height", unit)]
    turned = draw.random() < 0.5
    if draw.random() < 0.3:
        draw.shuffle(rows)
    if separator == " ":
        names = [name.replace(" ", "_").replace("[", "").replace("]", "").replace("(", "").replace(")", "") for name in names]
    lines = [separator.join(reversed(names) if turned else names)]
    for row in rows:
        values = [f"{value:.9f}".replace(".", decimal) for value in row]
        lines.append(separator.join(reversed(values) if turned else values))
    return "\n".join(lines) + "\n"


def heights(program, seed):
    draw, scene = random.Random(seed), scene_file(seed)
    depth, length = log_uniform(draw, 0.02, 0.3), draw.uniform(40, 120)
    table = dent_table(draw, depth, length)
    with open(f"dent_{seed}.csv", "w") as file:
        file.write(table)
    common = {"Wheelset/Traction coefficient": "0", "Irregularity 1/Place": "100 mm", "Half-space/Element size": "1 mm",
              "Output/Folder": scene[:-4]}
    found = []
    for own in ({"Irregularity 1/Kind": "file", "Irregularity 1/File": f"dent_{seed}.csv"},
                {"Irregularity 1/Kind": "dent", "Irregularity 1/Depth": f"{depth} mm", "Irregularity 1/Length": f"{length} mm"}):
        code, screen = execute(program, "halfspace", scene, "--no-pictures", "--places", "100,110 mm", *as_options({**common, **own}))
        if code == 1 and sentence_of(screen):
            return {"refused": [sentence_of(screen)], "table": table[:200]}
        if code != 0:
            return {"fault": screen[-1000:], "table": table[:200]}
        with open(scene[:-4] + "-halfspace/places.csv") as file:
            found.append([[float(row[key]) for key in ("max_pressure_Pa", "wheel_drop_m")] for row in csv.DictReader(file)])
    miss = max(abs(a / b - 1) for one, other in zip(*found) for a, b in zip(one, other))
    return {"miss": miss, "table": table[:200], **({"fault": f"{100 * miss:.1f} % off"} if miss > 0.01 else {})}


def caches(program, seed):
    draw, scene = random.Random(seed), scene_file(seed)
    folder = os.path.abspath(f"cache_{seed}")
    os.environ["WHEELRAIL_CACHE"] = folder
    options = as_options({"Half-space/Element size": "1 mm", "Output/Folder": scene[:-4]})
    first, why = contact(program, scene, "real", options)
    tables = sorted(glob.glob(f"{folder}/body-*.h5"))
    if not first or len(tables) != 2:
        return {"fault": why or f"{len(tables)} tables"}
    whole = [open(path, "rb").read() for path in tables]
    which = draw.randrange(2)
    with open(tables[which], "wb") as file:
        file.write(damaged(draw, whole[which], whole[1 - which]))
    again, why = contact(program, scene, "real", options)
    shutil.rmtree(folder)
    same = again and again["max_pressure_Pa"] == first["max_pressure_Pa"] and again["creepage"] == first["creepage"]
    return {"miss": 0} if same else {"fault": why or f"{again['max_pressure_Pa']:.6g} in place of {first['max_pressure_Pa']:.6g} Pa"}


def known(path):
    if not os.path.exists(path):
        return {}
    with open(path) as lines:
        return {result["seed"]: result for result in map(json.loads, lines)}


def print_grades(results):
    for name in ("halfspaces", "wear", "noise", "bodies", "runs"):
        for word in ("trusted", "with care", "not trusted"):
            misses = [100 * result["miss"] for result in results if result.get(name) == word and "miss" in result]
            if misses:
                print(f"{name:10} {word:11} {len(misses):4}: {min(misses):+.1f} to {max(misses):+.1f} % of the true bodies")


def main():
    program, family, first, last = os.path.abspath(sys.argv[1]), sys.argv[3], int(sys.argv[4]), int(sys.argv[5])
    path = f"{family}.jsonl"
    for seed in range(first, last + 1):
        if seed not in known(path):
            result = {"halfspaces": halfspaces, "noise": noise, "bodies": answers, "runs": runs, "heights": heights,
                      "caches": caches}[family](program, seed)
            with open(path, "a") as file:
                file.write(json.dumps({"seed": seed, **result}) + "\n")
            for left in glob.glob(f"contact_{seed}*") + glob.glob(f"dent_{seed}.csv"):
                shutil.rmtree(left) if os.path.isdir(left) else os.remove(left)
    results = {seed: result for seed, result in known(path).items() if first <= seed <= last}
    for seed, result in sorted(results.items()):
        check("fault" not in result, f"seed {seed}: {result.get('fault', 'well')}")
    print(f"{sum(1 for result in results.values() if 'miss' not in result)} of {len(results)} not compared")
    print_grades(results.values())
    finish()


if __name__ == "__main__":
    main()
