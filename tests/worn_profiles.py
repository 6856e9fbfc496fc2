"""A worn wheel on a worn rail, both from files: the command geometry and a short run.

Usage: worn_profiles.py PROGRAM MPIEXEC geometry
       worn_profiles.py PROGRAM MPIEXEC run RANKS [FOLDER]

The wheel file is in metres and mirrored, the rail file points downwards. FOLDER holds the same run on one
rank, with whose figures those on RANKS ranks are compared.
"""

import json
import os
import re
import subprocess
import sys

from checks import SMALL_SCENE, check, finish

PROGRAM, MPIEXEC, WHAT = sys.argv[1:4]
FILES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "profiles")
WHEEL = os.path.join(FILES, "worn_S1002_metres.txt")
RAIL = os.path.join(FILES, "worn_54E1.prr")

SCENE = f"""
set Title = worn
subsection Profiles
  set Wheel = {WHEEL}
  set Rail = {RAIL}
end
{SMALL_SCENE}
subsection Run
  set Rolling distance = 5 mm
  set Averaging distance = 4 mm
end
subsection Output
  set Folder = run
  set Ticks = 2
  set Volume fields = false
end
"""

# what is done to the two files, in the order in which it is done
DONE = {
    "Profiles/Wheel = " + WHEEL: [
        r"two columns, 306 points",
        r"unit taken as m, since the profile then is 129\.5 mm wide; Profiles/Wheel unit changes it",
        r"mirrored: the flange of the file lies at positive lateral coordinates",
        r"noise of 3\.\d* um found in the points smoothed; the curve lies at most 1\d\.\d* um off the points",
        r"moved laterally by 31\.5\d* mm: flange back 70 mm off the running circle",
        r"moved vertically by -0\.9\d* mm: the running circle has the nominal rolling radius",
        r"tread continued straight by 0\.\d* mm on the field side"],
    "Profiles/Rail = " + RAIL: [
        r"SIMPACK, 215 points",
        r"unit mm as the file states",
        r"turned upside down: the vertical coordinate of the file points down",
        r"not mirrored: x taken as positive to the field side; Profiles/Rail mirror changes it",
        r"noise of 4\.\d* um found in the points smoothed; the curve lies at most \d*\.\d* um off the points",
        r"body of the rail: 54E1, whose head is as wide; Profiles/Rail body changes it",
        r"origin of the file kept: top at y = -0\.\d* mm of 54E1",
        # side wear of the gauge corner: the body of the standard rail stands 2.5 mm farther out
        r"the gauge side ends 2\.5 mm off the side of 54E1: joined to it by a straight line of 4\.9 mm, which was not measured",
        r"joined to the sides of 54E1 21\.8 mm \(field side\) and 30 mm \(gauge side\) below its top; below that it is "
        r"the body"]}

def check_near(value, expected, tolerance, text):
    check(abs(value - expected) <= tolerance, f"{text}: {value:.6g}, expected {expected:.6g}, tolerance {tolerance:.2g}")


def execute(*arguments, ranks=1):
    """Exit code and what was written on the screen."""
    with open("worn.prm", "w") as file:
        file.write(SCENE)
    line = [MPIEXEC, "--bind-to", "none", "--oversubscribe", "-q", "-n", str(ranks)] if ranks > 1 else []
    done = subprocess.run(line + [PROGRAM, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        print(done.stdout)
    return done.returncode, done.stdout


def check_notes(text, where):
    """Everything that is done to the files is told, in three lines at most, and nothing else."""
    for entry, patterns in DONE.items():
        lines = re.findall(r"^(?:note: |  profile +)" + re.escape(entry) + ": (.*)$", text, re.MULTILINE)
        kinds = [line.split(": ")[0] for line in lines]
        check(kinds == [kind for kind in ("placed", "points", "read") if kind in kinds], f"{where}: lines {kinds}")
        said = "; ".join(line.split(": ", 1)[1] for line in lines)
        for pattern in patterns:
            check(re.search("(?:^|; )" + pattern + "(?:;|$)", said), f"{where}: {pattern}")
            said = re.sub("(?:^|; )" + pattern + "(?=;|$)", "", said, count=1)
        check(said == "", f"{where}: nothing else is said [{said}]")


def contact_of(text):
    """Lateral places of the contact point on wheel and rail [mm], rolling radius [mm], angle [degrees]."""
    part = text[text.index("The scene's own shift"):]
    return [float(re.search(pattern, part)[1]) for pattern in
            (r"point on the wheel \(x, y\) +(\S+),", r"point on the rail \(x, y\) +(\S+),", r"rolling radius +(\S+) mm",
             r"contact angle +(\S+) deg")]


def geometry():
    code, text = execute("geometry", "worn.prm", "--shifts", "0")
    check(code == 0, "geometry of two files")
    check_notes(text, "screen")
    wheel, rail, radius, angle = contact_of(text)
    print(f"        contact at {wheel} mm of the wheel, {rail} mm of the rail, radius {radius} mm, {angle} degrees")
    # hollow tread, worn crown and gauge corner: contact next to the flange root, on a larger radius
    check(-30 < wheel < -10 and -30 < rail < -10, "contact lies towards the flange root")
    check(460 < radius < 463 and 4 < angle < 12, "on a larger radius, inclined")
    # the same worn profiles, measured by others: millimetres, not mirrored, another origin and another format
    code, text = execute("geometry", "worn.prm", "--shifts", "0",
                         "--set", "Profiles/Wheel = " + os.path.join(FILES, "worn_S1002.prw"),
                         "--set", "Profiles/Rail = " + os.path.join(FILES, "worn_54E1.ban"))
    check(code == 0, "geometry of the same profiles from other files")
    # The second rail file has another origin: its head is put on the standard one by its side 14 mm below its
    # top. There a head whose top is worn by 0.799 mm is wider by 1/20 of that, the lean of the sides of 54E1.
    rail -= 0.799 / 20
    for value, expected, name in zip(contact_of(text), (wheel, rail, radius, angle),
                                     ("wheel x [mm]", "rail x [mm]", "radius [mm]", "angle [degrees]")):
        check_near(value, expected, 5e-3, "the same profiles from other files, " + name)


def halfspace_centre():
    """Lateral place of the patch between half-spaces, from the contact point to the track centre [mm]."""
    code, text = execute("halfspace", "worn.prm")
    check(code == 0, "the same contact as half-spaces")
    with open(re.search(r"^Results in (.+), all results", text, re.MULTILINE)[1] + "/summary.json") as file:
        return 1e3 * json.load(file)["patch_centre_lateral_m"]


def run(ranks, alone=None):
    code, text = execute("run", "worn.prm", "--overwrite", ranks=ranks)
    check(code == 0, f"a run on {ranks} ranks ends")
    with open("run/log.txt") as file:
        log = file.read()
    check_notes(log, "log")
    with open("run/summary.json") as file:
        found = json.load(file)
    rail, rail_side, wheel, wheel_side = re.search(
        r"contact point .*: (\S+) mm to the (\S+) side of the rail's axis, (\S+) mm to the (\S+) side", log).groups()
    rail, wheel = (float(x) if side == "field" else -float(x)
                   for x, side in ((rail, rail_side), (wheel, wheel_side)))
    point = contact_of(execute("geometry", "worn.prm", "--shifts", "0")[1])
    check_near(wheel, point[0], 6e-4, "contact point on the wheel as by geometry [mm]")
    check_near(rail, point[1], 6e-4, "contact point on the rail as by geometry [mm]")
    check_near(1e3 * found["rolling_radius_m"], point[2], 6e-4, "rolling radius as by geometry [mm]")
    load = found["wheel_load_N"]
    # The worn patch is 5.4 mm wide. Cells of 4 mm that pass through it move the force by 4 % with their own
    # period, so that the mean is taken over one cell; it is -0.9 % off the weight. With cells of 2 mm the
    # force moves by 0.3 % and its mean is -0.08 % off.
    check_near(found["vertical_force_N"] / load, 1, 0.015, "vertical force over the weight")
    # In so coarse a patch the creepage predicted by half-spaces carries less, and the torque makes up for that
    # over many millimetres: -1.4 % after 9 mm with cells of 2 mm.
    check_near(found["longitudinal_force_N"] / load, 0.25, 0.0125, "longitudinal force over the weight")
    # The distance of the profiles grows faster on the gauge side. Half-spaces tell where the patch then lies;
    # the edges of one that is hardly wider than a cell are known to some quarter of a cell.
    check_near(1e3 * found["patch_centre_lateral_m"], halfspace_centre(), 1, "centre of the patch as of half-spaces [mm]")
    check(found["patches"] == 1, "one patch")
    check_near(found["energy_error"], 0, 0.005, "energy error")
    check(found["finished"] is True, "the run has finished")
    if alone:
        with open(os.path.join(alone, "summary.json")) as file:
            expected = json.load(file)
        for key in ("normal_force_N", "vertical_force_N", "longitudinal_force_N", "max_pressure_Pa", "contact_area_m2",
                    "patch_lateral_m", "max_von_mises_Pa"):
            check_near(found[key] / expected[key], 1, 2e-4, key + " over that of one rank")
        check_near(found["creepage"] / expected["creepage"], 1, 2e-3, "creepage over that of one rank")


if WHAT == "geometry":
    geometry()
else:
    run(int(sys.argv[4]), *sys.argv[5:6])
finish()
