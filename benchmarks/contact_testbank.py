#!/usr/bin/env python3
"""Cases of input files of CONTACT against the results that CONTACT printed for them.

Usage: contact_testbank.py FOLDER [--program build/wheelrail] [--cases] [--csv TABLE.csv]

FOLDER holds NAME.inp with NAME.ref_out beside it, in any depth. A row a file: what its cases need, cases, taken,
refused, not within the limits, the worst difference over its limit and where, processor seconds. Limits: forces
0.5 % of the load, moments that times half the patch, peak pressure and approach 0.5 %, creepage and number of
elements 1 %, place 0.05 mm, angle 1 mrad; four printed digits may add one unit of the last. A case whose temperatures had
not settled when CONTACT stopped is named and not compared.
"""

import argparse
import csv
import math
import os
import re
import resource
import subprocess
import sys
import tempfile

NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[EeDd][-+]?\d+)?"


def numbers(line):
    return [float(word.replace("D", "E")) for word in re.findall(NUMBER, line)]


def names(line):
    return re.findall(r"(?:FX|FY|FS)/(?:FSTAT/)?FN|FN/G|(?:CREEP|SHIFT) [XY]|FRIC\.\w+|ELAST\.EN\.|[\w/()]+",
                      line)


HEADS = {"FN": ("FN ", "BAR_FN"), "FN/G": ("FN/G", "TILDE_FN"), "FX(TR)": ("FX(TR)",), "XCP(TR)": ("XCP(TR)",),
         "CHI": ("CHI ", "DT "), "NPOT": ("NPOT",), "SPINXO": ("SPINXO",), "S_WS": ("S_WS", "X_WS"),
         "VX_WS": ("VX_WS", "RPITCH", "VPITCH_R")}


def cases_of(path):
    """Cases in their order: digits, values of the case and of its patches."""
    found = []
    patch = None
    with open(path, encoding="latin-1") as file:
        lines = file.read().splitlines()
    for k, line in enumerate(lines[:-1]):
        if re.match(r"^ Case +\d+", line):
            found.append({"name": line.strip(), "patches": [], "digits": {}, "head": {}})
            patch = None
        if not found:
            continue
        case = found[-1]
        if "|Tk-Tk-1|" in line: # a round of CONTACT's friction by temperature: change, tolerance
            case["change"] = numbers(line.split(":")[-1])
        if re.match(r"^ *(C?PBTNFS|V?LDCMZE|HGIAOWR)\.", line):
            case["digits"].update({name: int(value) for name, value in re.findall(r"([A-Z]+)\s*(\d)(?=,|\s|$)", line)})
        if "DATA FOR CONTACT PATCH" in line:
            patch = {}
            case["patches"].append(patch)
        text = line.strip() + " "
        for head, starts in HEADS.items():
            if text.startswith(starts) and not re.search(r"\d\.\d|PRESCRIBED|=", text):
                pairs = dict(zip(names(line.replace("BAR_", "")), numbers(lines[k + 1])))
                if head in ("FX(TR)", "S_WS", "VX_WS"):
                    case["head"].update(pairs)
                    continue
                if patch is None:
                    patch = {}
                    case["patches"].append(patch)
                patch.update(pairs)
    return found


def off(ours, theirs, limit):
    """Difference over the limit; the last printed digit is not counted."""
    digit = 0.6 * 10 ** (math.floor(math.log10(abs(theirs))) - 3) if theirs else 0
    return max(0.0, abs(ours - theirs) - digit) / limit if limit > 0 else 0.0


def compare_patch(ours, theirs, load, printed):
    worst = {}

    def put(name, limit, key=None):
        key = key or name
        if key in theirs and key in ours:
            worst[name] = off(ours[key], theirs[key], limit)

    fn = abs(theirs.get("FN", 0)) or 1e-30
    side = "FS" if "FS" in theirs else "FY"
    for key in ("FN", "FX", side):
        put(key, 5e-3 * load)
    size = math.sqrt(1.5 * fn / (math.pi * theirs["PMAX"])) if theirs.get("PMAX", 0) > 0 else 0
    if size:
        reach = size + (math.hypot(theirs["SPINXO"], theirs["SPINYO"]) if "SPINYO" in theirs else 0)
        put("MN" if "MN" in theirs else "MZ", 5e-3 * fn * reach)
    put("PMAX", 5e-3 * abs(theirs.get("PMAX", 0)))
    put("APPROACH", 5e-3 * abs(theirs.get("APPROACH", 0)))
    slip = math.hypot(theirs.get("CKSI", 0), theirs.get("CETA", 0))
    spin = abs(theirs.get("CPHI", 0))
    least = 0 if "SPINYO" in theirs and theirs.get("VELOC") == 1 else 1e-4 # creepages; none of shifts
    for key in ("CKSI", "CETA"):
        put(key, 1e-2 * max(slip, spin * size, least))
    put("CPHI", 1e-2 * max(spin, slip / size if size else 0, least / size if size else 0))
    for pair in ("CREEP", "SHIFT"):
        size_of = math.hypot(theirs.get(pair + " X", 0), theirs.get(pair + " Y", 0))
        for axis in (" X", " Y"):
            put(pair + axis, 1e-2 * size_of)
    if theirs.get("NCON"):
        put("NCON", max(1e-2 * theirs["NCON"], 1.001))
    for key in ("XCP(TR)", "YCP(TR)", "ZCP(TR)", "YCP(R)", "ZCP(R)", "XCP(W)", "YCP(W)", "ZCP(W)"):
        put(key, 0.05)
    put("DELTCP(TR)", 1e-3)
    return worst


def compare_case(ours, theirs):
    """Worst differences over their limits."""
    if len(ours["patches"]) != len(theirs["patches"]):
        return {"patches": math.inf}
    head = theirs["head"]
    load = math.sqrt(sum(head.get(key, 0) ** 2 for key in ("FX(TR)", "FY(TR)", "FZ(TR)")))
    worst = {key: off(ours["head"][key], head[key], 5e-3 * load)
             for key in head if key.startswith("F") and key in ours["head"] and load > 0}
    if "Z_WS" in head and "Z_WS" in ours["head"] and theirs["digits"].get("NORM") == 1: # else it is given
        worst["Z_WS"] = off(ours["head"]["Z_WS"], head["Z_WS"], 5e-3 * max(
            [p.get("APPROACH", 0) for p in theirs["patches"]] + [2e-2]))
    for a, b in zip(ours["patches"], theirs["patches"]):
        for key, value in compare_patch(a, b, load or abs(b.get("FN", 0)) or 1, True).items():
            worst[key] = max(worst.get(key, 0), value)
    return worst


def features(cases):
    seen = {}
    for case in cases:
        for name, value in case["digits"].items():
            seen.setdefault(name, set()).add(value)
    letters = {"CONFIG": "C", "BOUND": "B", "TANG": "T", "NORM": "N", "FORCE": "F", "STRESS": "S", "VARFRC": "V",
               "FRCLAW": "L", "DISCNS": "D", "INFLCF": "C", "MATER": "M", "HEAT": "H"}
    plain = {"CONFIG": {0, 1}, "BOUND": {0}, "STRESS": {0}, "VARFRC": {0}, "FRCLAW": {0, 1}, "DISCNS": {0, 1, 2},
             "INFLCF": {0, 1, 2}, "MATER": {0}, "HEAT": {0}}
    return " ".join(letter + ",".join(str(v) for v in sorted(seen[name] - plain.get(name, set())))
                    for name, letter in letters.items() if seen.get(name, set()) - plain.get(name, set()))


def run(program, path):
    """What the program prints for a file, and its processor seconds."""
    with tempfile.TemporaryDirectory() as folder:
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        call = subprocess.run([os.path.abspath(program), "contact", os.path.abspath(path), "--printed", "--no-pictures"],
                              cwd=folder, capture_output=True, text=True, check=False)
        seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        stem = os.path.splitext(os.path.basename(path))[0]
        printed = os.path.join(folder, "output", stem + "-contact", stem + ".out")
        if os.path.exists(printed):
            return cases_of(printed), seconds, call.stdout + call.stderr
        return [], seconds, call.stdout + call.stderr


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--program", default="build/wheelrail")
    parser.add_argument("--cases", action="store_true", help="a line for each case beyond its limits")
    parser.add_argument("--csv", help="write the table there, too")
    options = parser.parse_args()
    rows, unsettled = [], []
    print(f"{'file':34} {'needs':24} {'cases':>6} {'taken':>6} {'refused':>8} {'beyond':>7} {'worst':>7} {'of':12} "
          f"{'case':>5} {'s':>7}")
    for folder, _, files in sorted(os.walk(options.folder)):
        for name in sorted(files):
            reference = os.path.join(folder, os.path.splitext(name)[0] + ".ref_out")
            if not name.endswith(".inp") or not os.path.exists(reference):
                continue
            theirs = [c for c in cases_of(reference)]
            ours, seconds, message = run(options.program, os.path.join(folder, name))
            taken, beyond, worst = 0, 0, (0.0, "", 0)
            if len(theirs) != len(ours): # results of some cases only
                named = {case["name"]: case for case in theirs}
                none = {"patches": [], "head": {}, "digits": {}}
                theirs = [named.get(case["name"], none) for case in ours] or theirs
            for k, (a, b) in enumerate(zip(ours, theirs)):
                if not a["patches"] and not a["head"]:
                    continue
                taken += 1
                if not b["patches"] and not b["head"]:
                    continue
                change = b.get("change", [0, 1])
                if change[0] > change[1]:
                    unsettled.append(f"{name} {k + 1} ({change[0]:.3g} C)")
                    continue
                found = compare_case(a, b)
                far = {key: value for key, value in found.items() if value > 1}
                beyond += bool(far)
                if far and options.cases:
                    print(f"    case {k + 1}: " + ", ".join(f"{key} {value:.2f}" for key, value in far.items()))
                for key, value in found.items():
                    if value > worst[0]:
                        worst = (value, key, k + 1)
            if not ours and options.cases:
                print("    " + message.strip().splitlines()[0][:200])
            row = [os.path.relpath(os.path.join(folder, name), options.folder), features(theirs), len(theirs), taken,
                   len(theirs) - taken, beyond, round(worst[0], 3), worst[1], worst[2], round(seconds, 2)]
            rows.append(row)
            print(f"{row[0][-34:]:34} {row[1][:24]:24} {row[2]:6} {row[3]:6} {row[4]:8} {row[5]:7} {row[6]:7} "
                  f"{row[7]:12} {row[8]:5} {row[9]:7}", flush=True)
    if unsettled:
        print("CONTACT stopped while temperatures still changed in " + ", ".join(unsettled))
    sums = [sum(row[k] for row in rows) for k in range(2, 6)]
    print(f"{'all':59} {sums[0]:6} {sums[1]:6} {sums[2]:8} {sums[3]:7}")
    if options.csv:
        with open(options.csv, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(["file", "needs", "cases", "taken", "refused", "beyond", "worst_over_limit", "of", "case",
                             "seconds"])
            writer.writerows(rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
