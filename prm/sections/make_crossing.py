#!/usr/bin/python3
"""Writes the sections of crossing.prm beside this file and of ../insulated_joint.prm: rails as slices along the track.

Usage: make_crossing.py FOLDER

The heads have the radii of 54E1 (300, 80, 13 mm, sides 1:20). The joint has a rail that ends at 0 and three that begin
6 mm behind: level with it, 0.5 mm lower, 0.5 mm higher; their middle lies 2.4 mm beside the running circle. The wing leaves the running line 1:10 to the field side
and rises by 4 % of that. The nose begins behind the flangeway, 10 mm wide, and grows 1:10; its top rises 3 mm over
200 mm. y to the field side, z down [mm].
"""

import math
import os
import sys

DEPTH = 25.0


def arc(x, y, start, end, radius, step=0.5):
    """Points of an arc that begins at (x, y) with the inclination `start` downwards and ends with `end` [rad]."""
    n = max(2, math.ceil(radius * (end - start) / step))
    return [(x + radius * (math.sin(a) - math.sin(start)), y + radius * (math.cos(start) - math.cos(a)))
            for a in (start + (end - start) * k / n for k in range(1, n + 1))]


def down(x, y, slope=0.05, step=2.0):
    n = math.ceil((DEPTH - y) / step)
    return [(x + slope * (DEPTH - y) * k / n, DEPTH - (DEPTH - y) * (n - k) / n) for k in range(1, n + 1)]


def half_head():
    """Points of a half head from the middle of the crown to the side."""
    first = math.asin(10 / 300)
    second = math.asin(math.sin(first) + 15 / 80)
    points = [(0.0, 0.0)]
    for begin, end, radius in ((0, first, 300), (first, second, 80), (second, math.atan(20), 13)):
        points += arc(*points[-1], begin, end, radius)
    return points + down(*points[-1])


def lengths(points):
    total = [0.0]
    for a, b in zip(points, points[1:]):
        total.append(total[-1] + math.dist(a, b))
    return total


def wing(u):
    half = half_head()
    aside = 0 if u < 0 else u * u / 800 if u < 40 else 2 + 0.1 * (u - 40)
    points = [(aside - x, z - 0.04 * aside) for x, z in reversed(half)] + [(aside + x, z - 0.04 * aside)
                                                                            for x, z in half[1:]]
    total = lengths(points)
    return points, (0, total[-1] / 2, total[-1])


def nose(u):
    """Half a head up to a corner of 6 mm on its field side."""
    width, radius = 10 + 0.1 * (u - 380), 6
    low = 3 * max(0.0, 1 - (u - 380) / 200) ** 2
    head = [(-x, z) for x, z in reversed(half_head())]
    edge = head[0][0] + DEPTH * 0.05 + width - radius  # where the corner begins
    left = [p for p in head if p[0] < edge - 0.2]
    (xa, za), (xb, zb) = next((a, b) for a, b in zip(head, head[1:]) if b[0] >= edge)
    begin = (edge, za + (zb - za) * (edge - xa) / (xb - xa))
    tilt = math.atan2(zb - za, xb - xa)
    corner = arc(*begin, tilt, math.atan(20), radius)
    points = left + [begin] + corner + down(*corner[-1])
    total = lengths(points)
    features = (0, total[len(left)], total[len(left) + len(corner)], total[-1])
    return [(x, z + low) for x, z in points], features


def write(folder, name, places, section):
    rows = []
    for k, u in enumerate(places, 1):
        points, features = section(u)
        with open(os.path.join(folder, f"{name}_{k}.txt"), "w", encoding="utf-8") as file:
            file.writelines(f"{x:.4f} {z:.4f}\n" for x, z in points)
        rows.append((u, features))
    with open(os.path.join(folder, name + ".slcs"), "w", encoding="utf-8") as file:
        file.write(f"% made by make_crossing.py\n0 1 U_OFFSET U_SCALE, mm\n{len(rows)} NSLC\n"
                   f"{len(rows[0][1])} 0 0 NFEAT NKINK NACCEL\n1 U_INTPOL\n")
        file.writelines(f"{u} '{name}_{k}.txt'\n" for k, (u, _) in enumerate(rows, 1))
        for u, features in rows:
            file.write(f"{u} " + " ".join(f"{s:.4f}" for s in features[:-1]) + " 999\n")


def write_even(folder, name, begin, end, low):
    """Four slices of one section, `low` below the running circle."""
    half, aside = half_head(), 2.4
    section = [(aside - x, z + low) for x, z in reversed(half)] + [(aside + x, z + low) for x, z in half[1:]]
    with open(os.path.join(folder, name + ".txt"), "w", encoding="utf-8") as file:
        file.writelines(f"{x:.4f} {z:.4f}\n" for x, z in section)
    with open(os.path.join(folder, name + ".slcs"), "w", encoding="utf-8") as file:
        file.write("% made by make_crossing.py\n0 1 U_OFFSET U_SCALE, mm\n4 NSLC\n0 0 0 NFEAT NKINK NACCEL\n1 U_INTPOL\n")
        file.writelines(f"{begin + (end - begin) * k / 3:g} '{name}.txt'\n" for k in range(4))


def main(arguments):
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 1
    write(arguments[0], "wing", list(range(-200, -20, 60)) + list(range(-20, 61, 10)) + list(range(100, 781, 40)), wing)
    write(arguments[0], "nose", list(range(380, 681, 20)), nose)
    write_even(arguments[0], "joint_before", -3000, 0, 0)
    for name, low in (("level", 0), ("down", 0.5), ("up", -0.5)):
        write_even(arguments[0], "joint_" + name, 6, 3006, low)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
