#!/usr/bin/python3
"""Computes the scenes of the cookbook and makes its pictures.

Usage: doc/cookbook/make_pictures.py [NAME ...]

From the folder of the program, once it is built. NAME chooses questions (first_contact, measured_profiles, curve, braking,
yielding_rail, shakedown, measured_flat, study, accuracy); without any all are computed, which takes a quarter of an hour on two cores.
Results go to output/cookbook; what is finished there is not computed again. The pictures go to doc/cookbook/pictures with
few colours, 3 MB in all.
"""

import os
import subprocess
import sys

from PIL import Image

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
OUTPUT = "output/cookbook"
COLORS = 128
WIDTH = 1500
#: of the long scenes
COARSER = ["--set", "Mesh/Solution cell size = 2 mm"]


def call(*words):
    """Runs the program; a picture needs its result, whatever the verdict."""
    print("> ./wheelrail " + " ".join(words), flush=True)
    done = subprocess.run(["./wheelrail", *words], cwd=ROOT, check=False)
    if done.returncode not in (0, 2):
        sys.exit(done.returncode)


def folder_of(name):
    return ["--set", f"Output/Folder = {OUTPUT}/{name}"]


def run(name, scene, *more):
    """A run, unless it is there and finished."""
    if not os.path.exists(os.path.join(ROOT, OUTPUT, name, "summary.json")):
        call("run", scene, *folder_of(name), *more)


def take(source, name, width=WIDTH, box=None):
    """Copies a picture with few colours; `box`: the part that is taken, in parts of width and height."""
    with Image.open(os.path.join(ROOT, source)) as image:
        image = image.convert("RGB")
        if box:
            image = image.crop(tuple(round(part * image.size[k % 2]) for k, part in enumerate(box)))
        if image.width > width:
            image = image.resize((width, round(image.height * width / image.width)), Image.Resampling.LANCZOS)
        image.quantize(COLORS, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE).save(
            os.path.join(HERE, "pictures", name + ".png"), optimize=True)


def first_contact():
    call("halfspace", "prm/rolling.prm", *folder_of("first"))
    take(f"{OUTPUT}/first-halfspace/pictures/sheet.png", "first_contact")
    take(f"{OUTPUT}/first-halfspace/pictures/subsurface_aa.png", "first_contact_stresses", 1200)


def measured_profiles():
    profiles = ["--set", "Profiles/Wheel = tests/profiles/worn_S1002_metres.txt", "--set",
                "Profiles/Rail = tests/profiles/worn_54E1.prr"]
    call("geometry", "prm/rolling.prm", "--profiles", "--shifts", "0", *profiles)
    for kind in ("png", "csv"):
        os.replace(os.path.join(ROOT, "rolling_profiles." + kind), os.path.join(ROOT, OUTPUT, "measured_profiles." + kind))
    take(f"{OUTPUT}/measured_profiles.png", "measured_profiles", 1000)
    call("halfspace", "prm/rolling.prm", *profiles, *folder_of("measured"))
    take(f"{OUTPUT}/measured-halfspace/pictures/sheet.png", "measured_contact")


def curve():
    call("halfspace", "prm/curve_300m.prm", *folder_of("curve"))
    take(f"{OUTPUT}/curve-halfspace/pictures/wheelset.png", "curve", 1200)
    call("vehicle", "prm/rolling.prm", "prm/s_curve.csv", "--both-wheels", "--set", "Half-space/Element size = 0.8 mm",
         *folder_of("s_curve"))
    take(f"{OUTPUT}/s_curve-vehicle/pictures/heads.png", "curve_band", 1200)


def braking():
    run("braking", "prm/rolling.prm", "--set", "Wheelset/Traction coefficient = -0.2")
    call("compare", f"{OUTPUT}/braking")
    take(f"{OUTPUT}/braking/pictures/compare_maps.png", "braking")
    take(f"{OUTPUT}/braking/pictures/compare_cut_aa.png", "braking_cut", 1000)


def yielding_rail():
    run("yielding", "prm/rolling_plastic.prm", *COARSER)
    call("report", f"{OUTPUT}/yielding")
    take(f"{OUTPUT}/yielding/pictures/residual_above.png", "yielding_above", 1200)
    take(f"{OUTPUT}/yielding/pictures/residual_section.png", "yielding_section", 1200)


def shakedown():
    run("passages", "prm/passages.prm", *COARSER)
    call("report", f"{OUTPUT}/passages")
    take(f"{OUTPUT}/passages/pictures/growth.png", "shakedown_growth", 900)
    take(f"{OUTPUT}/passages/pictures/shakedown_map.png", "shakedown_map", 1100)


def measured_flat():
    """The scene that stands in the page."""
    with open(os.path.join(HERE, "measured_flat.md"), encoding="utf-8") as page:
        lines = page.read().splitlines()
    begin = lines.index("    include prm/sleepers.prm")
    end = max(k for k, line in enumerate(lines) if line == "    end") + 1
    scene = os.path.join(ROOT, "my_flat.prm")
    with open(scene, "w", encoding="utf-8") as file:
        file.write("\n".join(line[4:] for line in lines[begin:end]) + "\n")
    call("halfspace", "my_flat.prm", "--places", "0:100:2 mm", *folder_of("my_flat"))
    take(f"{OUTPUT}/my_flat-halfspace/pictures/places.png", "measured_flat_rest", 900)
    run("my_flat", "my_flat.prm")
    os.remove(scene)
    call("report", f"{OUTPUT}/my_flat")
    take(f"{OUTPUT}/my_flat/pictures/irregular.png", "measured_flat_run", 900)


def study():
    call("study", "prm/studies/lateral_shift.prm", "--set", "Study/Compute = halfspace", *folder_of("study"))
    take(f"{OUTPUT}/study/pictures/family_head.png", "study_head", 1200)
    take(f"{OUTPUT}/study/pictures/max_pressure_Pa.png", "study_pressure", 700)


def accuracy():
    run("coarse", "prm/rolling.prm", "--set", "Mesh/Solution cell size = 2 mm")
    call("compare", f"{OUTPUT}/coarse")
    take(f"{OUTPUT}/coarse/pictures/compare_cut_bb.png", "accuracy_2mm", 900)
    run("fine", "prm/rolling.prm")
    call("compare", f"{OUTPUT}/fine")
    take(f"{OUTPUT}/fine/pictures/compare_cut_bb.png", "accuracy_1mm", 900)


QUESTIONS = {question.__name__: question for question in (first_contact, measured_profiles, curve, braking, yielding_rail,
                                                          shakedown, measured_flat, study, accuracy)}


def main(names):
    unknown = [name for name in names if name not in QUESTIONS]
    if unknown:
        sys.exit(f"{unknown[0]}: no such question; there are {', '.join(QUESTIONS)}")
    os.makedirs(os.path.join(HERE, "pictures"), exist_ok=True)
    os.makedirs(os.path.join(ROOT, OUTPUT), exist_ok=True)
    for name in names or QUESTIONS:
        QUESTIONS[name]()
    size = sum(entry.stat().st_size for entry in os.scandir(os.path.join(HERE, "pictures"))) / 1e6
    print(f"pictures: {size:.2f} MB")
    return 0 if size < 3 else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
