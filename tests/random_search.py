"""Random scenes over the accepted entries, each held against its own half-spaces, trusted ones against true bodies.

Usage: random_search.py PROGRAM MPIEXEC FIRST LAST

Scene N is drawn from seed N: cells of 3 mm, 8 mm of rolling, one rank, a fifth of the other entries changed, a fourth
of the scenes irregular (30 mm of rolling, mostly on sleepers or pads), a third with measured noise in their profiles.
All share a folder of kept tables, a third of them with one that is damaged. Scenes that are refused are drawn again from
the same seed. Each scene that starts must

  - finish, within 25 % of its own half-spaces in peak pressure; or
  - finish with a warning that tells the miss and its cause (the warning before the run, that 3 mm are coarse, does not
    count); or
  - stop with a sentence;

without values that are not finite, a crash, or more than ten minutes of processor time. A peak pressure that is trusted
must be within 5 % of the true bodies with the profiles before the noise, if the surfaces are smooth. What came of each scene is a
line of results.jsonl in the present folder; seeds that have one are not run again, so that a search can go on where it
was ended, and several can share the seeds.
"""

import glob
import json
import math
import os
import random
import re
import resource
import shutil
import subprocess
import sys

from checks import check, finish

TESTS = os.path.dirname(os.path.abspath(__file__))
RESULTS = "results.jsonl"
MOST_SECONDS = 600
PEAK = 0.25
TRUSTED_PEAK = 0.05
NOISES = [0.005, 0.02, 0.05]  # of measured profiles [mm]

# what every scene has
FIXED = {
    "Mesh/Solution cell size": "3 mm",
    "Mesh/Coarse cell size": "24 mm",
    "Run/Rolling distance": "8 mm",
    "Run/Averaging distance": "4 mm",
    "Output/Ticks": "4",
    "Output/Volume fields": "false",
}


def log_uniform(draw, low, high):
    return math.exp(draw.uniform(math.log(low), math.log(high)))


def noisy(name, sigma):
    """A profile of a file with normal noise of `sigma` [mm] in its heights, written into the present folder."""
    path = os.path.abspath(f"noise_{1000 * sigma:g}_um_{name}")
    if not os.path.exists(path):
        draw = random.Random(path[-30:])
        with open(os.path.join(TESTS, "profiles", name)) as whole, open(path, "w") as file:
            file.write("\n".join(re.sub(r"^(\s*-?\d+\.\d+\s+)(-?\d+\.\d+)",
                                        lambda m: f"{m[1]}{float(m[2]) + draw.gauss(0, sigma):.4f}", line)
                                 for line in whole.read().splitlines()) + "\n")
    return path


def exact(value):
    """An entry with the profile before the noise."""
    return os.path.join(TESTS, "profiles", re.sub(".*noise_[0-9]+_um_", "", value)) if "noise_" in value else value


def damaged(draw, data, other):
    """Bytes of a kept table, damaged."""
    kind, at = draw.choice(["flip", "zero", "cut", "add", "swap", "empty"]), draw.randrange(len(data))
    if kind == "flip":
        return data[:at] + bytes([data[at] ^ (1 << draw.randrange(8))]) + data[at + 1:]
    if kind == "zero":
        return data[:at] + bytes(len(data) - at)
    if kind == "swap":
        return other
    return {"cut": data[:at], "add": data + bytes(draw.randrange(1, 100)), "empty": b""}[kind]


def damage_tables(draw):
    tables = sorted(glob.glob(os.path.join(os.environ["WHEELRAIL_CACHE"], "body-*.h5")))
    if tables and draw.random() < 0.3:
        path, other = draw.choice(tables), draw.choice(tables)
        with open(path, "rb") as file, open(other, "rb") as more:
            data = damaged(draw, file.read() or b" ", more.read())
        with open(path, "wb") as file:
            file.write(data)


def irregular(draw):
    """An irregular surface beyond the patch of the start, mostly on a track."""
    kind = draw.choice(["dent", "squat", "corrugation", "weld", "rounded flat", "flat", "polygon", "dipped joint", "file"])
    length, depth = draw.uniform(12, 30), log_uniform(draw, 0.005, 0.2)
    found = {"Kind": kind, "Place": f"{draw.uniform(22, 26):.3g} mm"}
    if kind == "file":
        found["File"] = os.path.abspath("heights_%08x.csv" % draw.randrange(1 << 32))
        with open(found["File"], "w") as file:
            rough = depth * draw.choice([0, 0, 0.05])
            file.write("along_mm;height_um\n" + "".join(
                f"{x:.3f};{1000 * (-depth * math.cos(math.pi * x / length) ** 2 + fade * draw.gauss(0, rough)):.4f}\n"
                for x, fade in ((length * (k / 40 - 0.5), 0 < k < 40) for k in range(41))))
    elif kind == "polygon":
        found.update(Order=str(draw.randrange(1, 60)), Depth=f"{depth:.3g} mm")
    else:
        found["Length"] = f"{length:.3g} mm"
        if kind not in ("flat", "rounded flat"):
            found["Depth"] = f"{depth:.3g} mm"
        if kind == "corrugation":
            found["Wavelength"] = f"{draw.uniform(12, 40):.3g} mm"
    support = draw.choice(["sleepers", "continuous pads", "clamped foot"])
    track = {} if support == "clamped foot" else {"Track/Support": support, "Track/Rail length": "6 m",
                                                  "Track/Damped ends": "2 m"}
    return {**{f"Irregularity 1/{name}": value for name, value in found.items()}, **track,
            "Run/Rolling distance": "30 mm", "Run/Evaluate at": draw.choice(["largest force", "end"])}


def entries(draw):
    """Changed entries of one scene, in the words of a parameter file."""
    def number(low, high, unit="", digits=4):
        return f"{draw.uniform(low, high):.{digits}g} {unit}".strip()

    def size(low, high, unit="", digits=3):
        return f"{log_uniform(draw, low, high):.{digits}g} {unit}".strip()

    profiles = os.path.join(TESTS, "profiles")
    found = {
        "Profiles/Wheel": draw.choice(["S1002", os.path.join(profiles, "worn_S1002.prw")]),
        "Profiles/Rail": draw.choice(["54E1", "60E1", "60E1", os.path.join(profiles, "worn_54E1.ban")]),
        "Track/Gauge": number(1425, 1450, "mm"),
        "Track/Gauge height": number(10, 20, "mm"),
        "Track/Rail inclination": draw.choice(["0", "1/20", "1/30", number(0, 0.1)]),
        "Track/Rail length": number(0.3, 2.5, "m"),
        "Wheelset/Nominal rolling radius": number(420, 600, "mm"),
        "Wheelset/Flange back distance": number(1353, 1366, "mm"),
        "Wheelset/Lateral shift": draw.choice([number(-6, 6, "mm"), number(-3, 3, "mm"), number(-12, 12, "mm")]),
        "Wheelset/Yaw": draw.choice([number(-10, 10, "mrad"), number(-3, 3, "mrad")]),
        "Wheelset/Roll": draw.choice(["none", "from contact"]),
        "Wheelset/Rim width": number(125, 145, "mm"),
        "Wheelset/Disc thickness": number(15, 60, "mm"),
        "Wheelset/Disc position": number(40, 95, "mm"),
        "Wheelset/Hub length": number(120, 250, "mm"),
        "Wheelset/Hub outer radius": number(110, 180, "mm"),
        "Wheelset/Bore radius": number(50, 100, "mm"),
        "Wheelset/Fillet radius": number(5, 40, "mm"),
        "Wheelset/Sprung mass": size(1, 50, "t"),
        "Wheelset/Axle mass": size(1, 5000, "kg"),
        "Wheelset/Axle pitch inertia": draw.choice(["0 kg m2", size(0.1, 1000, "kg m2")]),
        "Wheelset/Suspension stiffness": draw.choice(["0 MN/m", size(0.1, 1000, "MN/m")]),
        "Wheelset/Suspension damping": draw.choice(["0 N s/m", size(100, 1e6, "N s/m")]),
        "Wheelset/Velocity": size(20, 500, "km/h"),
        "Wheelset/Drive": draw.choice(["torque", "rate"]),
        "Wheelset/Traction coefficient": draw.choice(["0", number(-0.5, 0.5), number(-1, 1)]),
        "Wheelset/Creepage": draw.choice([number(-0.01, 0.01), number(-0.1, 0.1)]),
        "Contact/Friction coefficient": draw.choice(["0", number(0.1, 0.8), number(0, 1.5)]),
        "Contact/Friction law": draw.choice(["exponential", "rational"]),
        "Contact/Dynamic friction coefficient": number(0, 0.6),
        "Contact/Friction decay": size(0.001, 10, "s/m"),
        "Contact/Friction half velocity": size(0.1, 1000, "m/s"),
        "Contact/Penalty scale": size(0.5, 50),
        "Contact/Surface filter": draw.choice(["consistent", "none"]),
        "Contact/Damping": size(0.05, 1),
        # coarse cells of 6 mm would be a million of them, and a search of days
        "Mesh/Coarse cell size": draw.choice(["12 mm", "48 mm", "48 mm"]),
        "Mesh/Fine depth": number(6, 30, "mm"),
        "Mesh/Fine margin": number(3, 15, "mm"),
        "Mesh/Element": "full",
        "Mesh/Rail element": draw.choice(["reduced", "full"]),
        "Run/Start": draw.choice(["without creepage", "without tractions", "without velocities", "normal load"]),
        "Run/Time step factor": draw.choice(["0.98", number(0.3, 0.98)]),
        "Run/Bulk viscosity": draw.choice(["0", number(0, 0.3), number(0, 1)]),
    }
    for body in ("Rail material", "Wheel material"):
        modulus = draw.choice([draw.uniform(180, 230), log_uniform(draw, 20, 1000), log_uniform(draw, 1, 1000)])
        found[body + "/Young's modulus"] = f"{modulus:.4g} GPa"
        found[body + "/Poisson's ratio"] = draw.choice([number(0.2, 0.35), number(0, 0.49)])
        found[body + "/Density"] = size(1000, 20000, "kg/m3")
        found[body + "/Yield stress"] = draw.choice([size(250, 1000, "MPa"), size(100, 3000, "MPa"), size(1, 1e4, "MPa")])
        found[body + "/Tangent modulus"] = draw.choice(["0 GPa", f"{modulus * draw.uniform(0, 0.3):.3g} GPa"])
        found[body + "/Kinematic hardening fraction"] = number(0, 1)
    chosen = {name: value for name, value in found.items() if draw.random() < 0.2}
    if draw.random() < 0.25:
        chosen.update(irregular(draw))
    if draw.random() < 0.3:
        chosen["Profiles/Wheel"] = noisy("worn_S1002.prw", draw.choice(NOISES))
    if draw.random() < 0.3:
        chosen["Profiles/Rail"] = noisy("worn_54E1.ban", draw.choice(NOISES))
    if draw.random() < 0.5:  # half of the scenes have elastic bodies
        chosen = {name: value for name, value in chosen.items() if not name.endswith("Yield stress")}
    return chosen


def limit_time():
    resource.setrlimit(resource.RLIMIT_CPU, (MOST_SECONDS, MOST_SECONDS + 10))


def execute(program, *arguments):
    """Exit code and screen."""
    done = subprocess.run([program, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          preexec_fn=limit_time)
    return done.returncode, done.stdout


def as_options(chosen):
    return [word for name, value in chosen.items() for word in ("--set", f"{name} = {value}")]


def not_finite(screen):
    return re.search(r"(?<![\w-])-?(nan|inf)(?![\w-])", screen, re.IGNORECASE) is not None


def sentence_of(screen):
    lines = [line for line in screen.splitlines() if line.startswith("error: ")]
    return lines[-1][len("error: "):] if lines else ""


# what a run says of a peak pressure that is not that of its half-spaces: "the peak pressure is 30 % below ..."
CAUSES = {
    "turn": r"the surfaces turn by \d+ degrees across the patch",
    "flow": r"steel has yielded",
    "patches": r"the run has \d+ patches",
    "penalty": r"the penalty contact sinks in by [\d.]+ % of the approach",
    "forces": r"the forces vary by [\d.]+ % of the load",
    "noise": r"fluctuates by [\d.]+ % of its mean",
    "cells": r"too few cells: [\d.]+ of 3 mm lie across",
    "drift": r"still changes, by",
    "torque": r"from what the torque of the wheel demands",
}


def causes_of(screen):
    """Which causes the verdict of a run names, or its warning that half-spaces are no reference."""
    end = "\n".join(line for line in screen.splitlines() if re.match("warning: the peak pressure is| *verdict: |    - ", line))
    return [name for name, words in CAUSES.items() if re.search(words, end, re.IGNORECASE)]


def peak_of_bodies(program, scene, options):
    """Peak pressure [Pa] of the true bodies with the profiles before the noise; None: they have no answer."""
    before = [" = ".join(map(exact, word.split(" = "))) for word in options]
    code, _ = execute(program, "halfspace", scene, "--no-pictures", "--bodies", "real", *before)
    if code != 0:
        return None
    with open(scene.replace(".prm", "-halfspace/summary.json")) as text:
        return json.load(text)["max_pressure_Pa"]


def judge(program, scene, options, folder):
    """Runs a scene that was accepted; its verdict and figures."""
    code, screen = execute(program, "run", scene, *options)
    result = {"verdict": "fault", "code": code}
    if code < 0 or code > 3 or "fault in the program" in screen or not_finite(screen):
        result["screen"] = screen[-3000:]
        return result
    if code != 0:
        result["sentence"] = sentence_of(screen)
        result["verdict"] = "stopped" if result["sentence"] and code == 2 else "fault"
        return result
    with open(os.path.join(folder, "summary.json")) as text:
        figures = json.load(text)
    miss = figures.get("relative_difference_max_pressure")
    smooth = not any(word.startswith("Irregularity") for word in options)
    if figures["trusted"] and smooth and not any("Yield stress" in word for word in options):
        result["real"] = peak_of_bodies(program, scene, options)
    result.update(miss=miss, peak=figures["max_pressure_Pa"], energy_error=figures["energy_error"],
                  trusted=figures["trusted"], seconds=figures["wall_time_s"], causes=causes_of(screen))
    if result.get("real") and abs(result["peak"] / result["real"] - 1) > TRUSTED_PEAK:
        result["verdict"] = "trusted"
    elif not figures["finished"] or (miss is None and smooth):
        result["screen"] = screen[-3000:]
    elif miss is None or abs(miss) <= PEAK:
        result["verdict"] = "within"
    else:
        result["verdict"] = "warned" if result["causes"] else "silent"
    return result


def search(program, seed):
    draw, refused = random.Random(seed), []
    folder = f"scene_{seed}"
    os.environ["WHEELRAIL_CACHE"] = os.path.abspath("cache")
    damage_tables(draw)
    with open(f"{folder}.prm", "w") as file:
        file.write("# more entries by --set\nsubsection Wheelset\n  set Traction coefficient = 0.25\nend\n")
    while True:
        chosen = {**FIXED, **entries(draw), "Output/Folder": folder, "Title": f"random scene {seed}"}
        options = as_options(chosen)
        code, screen = execute(program, "run", f"{folder}.prm", "--validate", *options)
        if code == 0:
            break
        sentence = sentence_of(screen)
        if code != 1 or not sentence or not_finite(screen):
            return {"verdict": "fault", "code": code, "screen": screen[-3000:], "entries": chosen}
        refused.append(sentence)
    shutil.rmtree(folder, ignore_errors=True)
    result = judge(program, f"{folder}.prm", options, folder)
    result.update(seed=seed, refused=refused, entries=chosen)
    if result["verdict"] in ("within", "warned", "stopped"):
        shutil.rmtree(folder, ignore_errors=True)
        for left in glob.glob(f"{folder}.prm") + glob.glob(f"{folder}-halfspace") + glob.glob("heights_*.csv"):
            shutil.rmtree(left) if os.path.isdir(left) else os.remove(left)
    return result


def known():
    if not os.path.exists(RESULTS):
        return {}
    with open(RESULTS) as lines:
        return {result["seed"]: result for result in map(json.loads, lines)}


def main():
    program, first, last = sys.argv[1], int(sys.argv[3]), int(sys.argv[4])
    for seed in range(first, last + 1):
        if seed not in known():
            result = search(program, seed)
            with open(RESULTS, "a") as file:
                file.write(json.dumps({"seed": seed, **result}) + "\n")
    results = {seed: result for seed, result in known().items() if first <= seed <= last}
    for seed, result in sorted(results.items()):
        check(result["verdict"] in ("within", "warned", "stopped"),
              f"seed {seed}: {result['verdict']}, {len(result.get('refused', []))} draws refused, "
              + (f"peak {100 * result['miss']:+.1f} %" if result.get("miss") is not None
                 else result.get("sentence", "")))
    for verdict in ("within", "warned", "stopped", "silent", "trusted", "fault"):
        print(f"{sum(result['verdict'] == verdict for result in results.values()):5} {verdict}")
    finish()


if __name__ == "__main__":
    main()
