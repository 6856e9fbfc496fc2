"""CONTACT's library called from Python, without MPI: a client of its own.

Usage: contact_calls.py PROGRAM MPIEXEC LIBRARY
"""

import ctypes
import math
import os
import re
import sys
import threading

from checks import check, finish

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
LIBRARY = ctypes.CDLL(sys.argv[3])
MM, SIMPACK, SI = 1934, 1935, 1936
UNITS, SIDE, BOUND, MOTION, NORMAL, FORCE, FRICTION_LAW = 1933, 1967, 1971, 1972, 1973, 1974, 1976


def call(name, *values):
    """Calls with pointers: integers, reals and texts as they are, lists as arrays. Returns these."""
    arguments = []
    for value in values:
        if value is None:
            arguments.append(None)
        elif isinstance(value, bytes):
            arguments.append(ctypes.c_char_p(value))
        elif isinstance(value, list):
            kind = ctypes.c_int if value and isinstance(value[0], int) else ctypes.c_double
            arguments.append((kind * max(1, len(value)))(*value))
        else:
            arguments.append((ctypes.c_int if isinstance(value, int) else ctypes.c_double)(value))
    getattr(LIBRARY, name)(*[a if a is None or isinstance(a, (ctypes.c_char_p, ctypes.Array)) else ctypes.byref(a)
                             for a in arguments])
    return [a if a is None else list(a) if isinstance(a, ctypes.Array) else a.value for a in arguments]


def flags(ire, **values):
    """Sets flags by their names above."""
    codes = [globals()[name] for name in values]
    call("cntc_setflags", ire, 1, len(codes), codes, list(values.values()))


def calculate(ire):
    return call("cntc_calculate", ire, 1, 0)[2]


def forces(ire):
    return call("cntc_getcontactforces", ire, 1, 0.0, 0.0, 0.0, 0.0)[2:]


def messages():
    with open("calls.out", encoding="utf-8") as file:
        return file.read()


def near(found, wanted, share):
    return abs(found - wanted) <= share * abs(wanted)


def all_names():
    """Every function of the header is there."""
    with open(os.path.join(ROOT, "include/wheelrail/contactcalls/contact_calls.h"), encoding="utf-8") as header:
        names = re.findall(r"^  ((?:cntc|subs)_\w+)\(", header.read(), re.MULTILINE)
    missing = [name for name in names if not hasattr(LIBRARY, name)]
    check(len(names) == 70 and not missing, f"{len(names)} functions, missing {missing}")


def start():
    folder, name = b" ", b"calls"
    if os.path.exists("calls.out"):
        os.remove("calls.out")
    version, error = call("cntc_initializefirst_new", 0, -1, 0, b" ", folder, name, 1, 1, len(name))[:2]
    check(version == 2520 and error == 0, f"version {version}, error {error}")
    for ire in range(1, 6):
        check(call("cntc_initialize", ire, 3, 0, -1, b" ", 1)[3] == 0, f"result element {ire}")


def hertz():
    """A ball on a plane: Hertz (1882), and the stresses below it (Johnson 1985, section 3.4)."""
    shear, poisson, half_curvature, force = 82000.0, 0.28, 0.001, 10000.0
    flags(1, UNITS=MM, MOTION=0)
    call("cntc_setmaterialparameters", 1, 1, 0, 4, [poisson, poisson, shear, shear])
    call("cntc_sethertzcontact", 1, 1, -1, 5, [41.0, 41.0, half_curvature, half_curvature, 1.2])
    call("cntc_setnormalforce", 1, 1, force)
    check(calculate(1) == 0, "Hertz' contact is solved")
    modulus = shear / (1 - poisson)  # of both bodies together
    radius = 1 / (2 * half_curvature)
    a = (3 * force * radius / (4 * modulus)) ** (1 / 3)
    peak = 3 * force / (2 * math.pi * a * a)
    check(near(call("cntc_getmaximumpressure", 1, 1, 0.0)[2], peak, 5e-3), f"peak pressure {peak}")
    check(near(call("cntc_getpenetration", 1, 1, 0.0)[2], a * a / radius, 5e-3), f"approach {a * a / radius}")
    check(near(call("cntc_gethertzcontact", 1, 1, 10, [0.0] * 10)[3][2], a, 1e-4), f"semi-axis {a}")
    mx, my = call("cntc_getnumelements", 1, 1, 0, 0)[2:]
    dx, dy = call("cntc_getgriddiscretization", 1, 1, 0.0, 0.0)[2:]
    pn = call("cntc_gettractions", 1, 1, mx * my, [0.0] * (mx * my), [0.0] * (mx * my), [0.0] * (mx * my))[3]
    check(near(sum(pn) * dx * dy, force, 1e-6), f"pressures of {mx} x {my} elements carry the force")
    depth = 0.5 * a
    call("subs_addblock", 1, 1, 1, 9, 1, 1, 2, [0.0], [0.0], [depth, -depth])
    check(call("subs_calculate", 1, 1, -1)[2] == 0, "stresses below the surface")
    nx, ny, nz = call("subs_getblocksize", 1, 1, 1, 0, 0, 0)[3:]
    table = call("subs_getresults", 1, 1, 1, 2, 3, [3, 21, 13], [0.0] * 6)[6]
    check([nx, ny, nz] == [1, 1, 2] and near(table[0], depth, 1e-12), f"block of {nx} x {ny} x {nz}, z {table[:2]}")
    wanted = -peak / (1 + (depth / a) ** 2)
    check(all(near(s, wanted, 1e-2) for s in table[2:4]), f"normal stress {table[2:4]}, {wanted} by Hertz")
    # SI: the same contact
    call("cntc_setflags", 1, 1, 1, [UNITS], [SI])
    check(near(call("cntc_getmaximumpressure", 1, 1, 0.0)[2], 1e6 * peak, 5e-3), "pressure in Pa")
    check(near(call("cntc_getpenetration", 1, 1, 0.0)[2], 1e-3 * a * a / radius, 5e-3), "approach in m")
    call("cntc_setflags", 1, 1, 1, [UNITS], [MM])


def roll(ire):
    """Element 1 of the library test of CONTACT, revision 2707 (test_caddon), in SIMPACK's units."""
    flags(ire, UNITS=SIMPACK, MOTION=3)
    call("cntc_setmaterialproperties", ire, 1, 82e9, 0.28, 82e9, 0.28)
    call("cntc_setfrictionmethod", ire, 1, 0, 2, [0.3, 0.3])
    call("cntc_sethertzcontact", ire, 1, -3, 5, [21.0, 33.0, 4.25e-3, 7e-3, 1.235])
    call("cntc_setpenetration", ire, 1, 0.05e-3)
    call("cntc_setreferencevelocity", ire, 1, 24.0)
    call("cntc_setrollingstepsize", ire, 1, 0.0, 0.5e-3)
    call("cntc_setcreepages", ire, 1, 0.001, 0.0, 0.4)
    return calculate(ire)


def rolling():
    check(roll(2) == 0, "rolling with creepages")
    printed = [42083.1, 4883.3, 4617.4, 23.7]
    found = forces(2)
    check(all(near(f, p, 5e-3) for f, p in zip(found, printed)), f"forces on body 2 {found}, printed {printed}")
    areas = call("cntc_getcontactpatchareas", 2, 1, 0.0, 0.0, 0.0)[2:]
    check(near(areas[0], 95e-6, 1e-2) and near(areas[2], 59e-6, 2e-2), f"area and slip {areas}")
    vx = call("cntc_getcreepages", 2, 1, 0.0, 0.0, 0.0)[2]
    check(near(vx, -0.001, 1e-12), "creepages are those of body 2")
    flags(2, UNITS=MM)
    check(near(forces(2)[1], -printed[1], 5e-3), "forces on body 1 have the other sign")
    # the force found above gives its creepages back
    fn, fx, fy, _ = forces(2)
    flags(2, FORCE=2)
    call("cntc_settangentialforces", 2, 1, fx / (0.3 * fn), fy / (0.3 * fn))
    check(calculate(2) == 0, "rolling with forces")
    vx, vy, phi = call("cntc_getcreepages", 2, 1, 0.0, 0.0, 0.0)[2:]
    check(near(vx, 0.001, 1e-3) and abs(vy) < 1e-6 and near(phi, 4e-4, 1e-9), f"creepages found {vx} {vy} {phi}")


def threads():
    """Elements in threads of their own come to the same."""
    found = [None] * 6

    def work(ire):
        roll(ire)
        found[ire] = forces(ire)

    running = [threading.Thread(target=work, args=(ire,)) for ire in (3, 4, 5)]
    for thread in running:
        thread.start()
    for thread in running:
        thread.join()
    check(found[3] and found[3] == found[4] == found[5] and near(found[3][1], 4883.3, 5e-3), f"threads {found[3:]}")
    cpu, wall = call("cntc_getcalculationtime", 3, 1, 0.0, 0.0)[2:]
    check(0 < cpu < 10 and wall > 0, f"{cpu} s of the processor")


def wheel_and_rail():
    """A wheel without cone on a round rail head, from points: Hertz along and across, sums of the patch."""
    rail_radius, wheel_radius, force = 300.0, 460.0, 80000.0
    call("cntc_initialize", 6, 1, 0, -1, b" ", 1)
    call("cntc_setflags", 6, -1, 4, [UNITS, SIDE, MOTION, NORMAL], [MM, 1, 3, 1])
    call("cntc_setmaterialparameters", 6, -1, 0, 4, [0.28, 0.28, 82000.0, 82000.0])
    call("cntc_setfrictionmethod", 6, -1, 0, 2, [0.3, 0.3])
    call("cntc_setverticalforce", 6, force)
    call("cntc_setpotcontact", 6, -1, -1, 5, [0.4, 0.4, 1.5, 8.0, 4.0])
    call("cntc_settrackdimensions", 6, 3, 11, [-1.0, 750.0, 0.0] + [0.0] * 8)
    head = [value for k in range(-30, 31) for value in (float(k), rail_radius - math.sqrt(rail_radius**2 - k * k))]
    call("cntc_setprofileinputvalues", 6, 61, head, 4, [0, 0, 0, -1], 2, [1.0, 0.0])
    tread = [value for k in range(-40, 41, 2) for value in (float(k), 0.0)]
    call("cntc_setprofileinputvalues", 6, 41, tread, 4, [1, 0, 0, -1], 2, [1.0, 0.0])
    call("cntc_setwheelsetdimensions", 6, 3, 3, [1360.0, -70.0, wheel_radius])
    call("cntc_setwheelsetposition", 6, 1, 6, [0.0] * 6)
    call("cntc_setwheelsetvelocity", 6, 2, 6, [20000.0, 0.0, 0.0, 0.0, 0.0, -1.001 * 20000.0 / wheel_radius])
    check(call("cntc_calculate", 6, -1, 0)[2] == 0, "wheel and rail are solved")
    check(call("cntc_getnumcontactpatches", 6, 0)[1] == 1, "one patch")
    total = call("cntc_getglobalforces", 6, -1, 24, [0.0] * 24)[3]
    fn, fx, fs, _ = call("cntc_getcontactforces", 6, 1, 0.0, 0.0, 0.0, 0.0)[2:]
    check(near(total[2], force, 1e-4) and near(fn, force, 1e-4) and near(total[0], fx, 1e-6), f"forces {total[:3]}")
    check(fx < 0 and abs(fs) < 1e-3 * force, "a driving wheel pushes the rail backwards")
    creep = call("cntc_getcreepages", 6, 1, 0.0, 0.0, 0.0)[2]
    check(near(creep, 0.001, 2e-2), f"creepage {creep}")
    # the same ellipse in module 3
    call("cntc_initialize", 7, 3, 0, -1, b" ", 1)
    call("cntc_setmaterialparameters", 7, 1, 0, 4, [0.28, 0.28, 82000.0, 82000.0])
    call("cntc_sethertzcontact", 7, 1, -1, 5, [41.0, 41.0, 0.5 / wheel_radius, 0.5 / rail_radius, 1.1])
    call("cntc_setnormalforce", 7, 1, force)
    call("cntc_setcreepages", 7, 1, creep, 0.0, 0.0)
    check(calculate(7) == 0 and near(fx, forces(7)[1], 1e-2), f"{fx} N, {forces(7)[1]} N by module 3")
    peak = call("cntc_getmaximumpressure", 6, 1, 0.0)[2]
    check(near(peak, call("cntc_getmaximumpressure", 7, 1, 0.0)[2], 1e-2), f"peak pressure {peak}")
    place = call("cntc_getcontactlocation", 6, 1, 38, [0.0] * 38)[3]
    check(abs(place[1] - 750) < 0.01 and abs(place[3]) < 1e-4, f"place {place[:4]}")
    check(call("cntc_getcontactforces", 6, 2, 0.0, 0.0, 0.0, 0.0)[2:] == [0, 0, 0, 0], "no second patch")
    check("there is no patch 2; the contact has 1" in messages(), "and it is said")


def profiles():
    """Points of the profiles of the contact before: a circle and a straight line."""
    radius = 300.0

    def values(task, length, kind=0, sampling=-1, spacing=1.0, ire=6):
        return call("cntc_getprofilevalues_new", ire, task, 2, [kind, sampling], 1, [spacing], length, [0.0] * length)[7]

    def all_near(found, wanted, most):
        return len(found) == len(wanted) and all(abs(f - w) <= most for f, w in zip(found, wanted))

    places = [float(k) for k in range(-30, 31)]
    heights = [radius - math.sqrt(radius**2 - y * y) for y in places]
    check(call("cntc_getprofilevalues", 6, 0, 2, [0, -1], 1, [0.0])[5] == [61.0], "61 points")
    check(values(-1, 1) == [0.0], "the profile is there")
    check(all_near(values(1, 122), places + heights, 1e-9), "points as they were set")
    check(all_near(values(2, 122), [750 + y for y in places] + heights, 1e-9), "and in the track")
    arcs, slopes = values(4, 61), values(5, 61)
    check(all_near(arcs, [radius * math.asin(y / radius) for y in places], 2e-3), f"arcs {arcs[::30]}")
    check(all_near(slopes[5:-5], [math.asin(y / radius) for y in places[5:-5]], 1e-5), f"slopes {slopes[::30]}")
    check(values(0, 1, sampling=1, spacing=5.0) == [13.0], "points 5 mm apart")
    steps = values(4, 13, sampling=1, spacing=5.0)
    check(all_near([b - a for a, b in zip(steps, steps[1:])], [5.0] * 12, 1e-6), f"by arc {steps[:3]}")
    height = call("cntc_getwheelsetposition", 6, 6, [0.0] * 6)[2][2]
    wheel = values(2, 82, kind=1)
    check(all_near(wheel, [750.0 + y for y in range(-40, 41, 2)] + [height] * 41, 1e-9), f"wheel {wheel[:2]}")
    check(values(6, 1)[0] == -32.0 and "the task 6 is not computed; taken are -1 to 5" in messages(), "cuts are refused")
    # the gauge is met 1 mm below the top
    call("cntc_initialize", 8, 1, 0, -1, b" ", 1)
    call("cntc_setflags", 8, -1, 2, [UNITS, SIDE], [MM, 1])
    call("cntc_settrackdimensions", 8, 3, 11, [1.0, 0.0, 1435.0] + [0.0] * 8)
    head = [value for y, z in zip(places, heights) for value in (y, z)]
    call("cntc_setprofileinputvalues", 8, 61, head, 4, [0, 0, 0, -1], 2, [1.0, 0.0])
    inner = -math.sqrt(radius**2 - (radius - 1) ** 2)
    gauge = values(3, 6, ire=8)
    check(all_near(gauge, [inner, 1.0, 717.5 - inner, 0.0, inner, 1.0], 0.06), f"gauge points {gauge}")


def errors():
    """Errors are codes and sentences, and change nothing."""
    before = forces(3)
    check(call("cntc_calculate", 77, 1, 0)[2] == -31, "an element that is not there")
    check("there is no result element 77" in messages(), "is named")
    check(calculate(3) == 0 and call("cntc_calculate", 3, 2, 0)[2] == -34, "no grid")
    call("cntc_setfrictionmethod", 3, 1, 4, 2, [0.3, 0.3])
    check("the method 4 needs 7 values, not 2" in messages(), "a wrong number of values is named")
    check(calculate(3) == 0 and all(near(f, b, 1e-5) for f, b in zip(forces(3), before)), "and changes nothing")
    call("cntc_setpotcontact", 3, 1, 9, 6, [1.0] * 6)
    check("IPOTCN = 9 is unknown" in messages(), "an unknown grid is named")
    call("cntc_setflags", 3, 1, 2, [FRICTION_LAW, 1999], [2, 1])
    check("the flag 1976 can be asked for only" in messages(), "a flag that is not set so")
    call("cntc_settemperaturedata", 3, 1, 3, 9, [20.0, 450.0, 50.0, 7850.0] * 2 + [1.0])
    check(calculate(3) == 0, "with heat")
    check(all(t > 20 for t in call("cntc_getmaximumtemperature", 3, 1, 0.0, 0.0)[2:]), "friction heats")
    call("cntc_setinterfaciallayer", 3, 1, 1, 4, [1.0, 1.0, 0.1, 0.1])
    check(calculate(3) == -99 and "M = 1 (material: viscoelastic) is not computed" in messages(),
          "what is not computed is named")
    check(call("cntc_getflags", 3, 1, 2, [UNITS, MOTION], [0, 0])[4] == [SIMPACK, 3], "flags read back")
    call("cntc_getcontactforces", 2, 1, None, 0.0, 0.0, 0.0)
    check("cntc_getcontactforces: an argument is a null pointer; nothing is done" in messages(), "a null pointer")
    for name, arguments in (("cntc_setcreepages", [math.inf, 0.0, 0.0]), ("cntc_setreferencevelocity", [math.nan])):
        call(name, 2, 1, *arguments)
        check(f"{name}: an argument holds a number that is not finite; nothing is done" in messages(), f"{name} {arguments}")
    call("cntc_setcreepages", 2, 1, 1e300, 0.0, 0.0)
    flags(2, FORCE=0)
    check(calculate(2) == -99 and "must be finite numbers" in messages(), "a creepage out of scale")
    call("cntc_setverticalforce", 6, 1e300)
    check(call("cntc_calculate", 6, -1, 0)[2] == -39 and call("cntc_getnumcontactpatches", 6, 9)[1] == 0,
          "a load out of scale leaves no contact behind")
    call("cntc_finalize", 3)
    check(call("cntc_calculate", 3, 1, 0)[2] == -31, "an element that is gone")


all_names()
start()
hertz()
rolling()
threads()
wheel_and_rail()
profiles()
errors()
call("cntc_finalizelast")
finish()
