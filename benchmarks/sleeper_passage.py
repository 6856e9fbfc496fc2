#!/usr/bin/python3
"""A wheel over sleepers before the squat of prm/squat_track.prm, against a beam in time.

Usage: benchmarks/sleeper_passage.py OUTPUT [GIVE]

    ./wheelrail run prm/squat_track.prm
    benchmarks/sleeper_passage.py output/squat_track 27.7e-6

The reduced model: a rigid wheel on the spring of Hertz rolls over Timoshenko's beam on pads, rigid sleepers and
ballast, all with one damper, and over damped ends; Newmark's method with 1/4 and 1/2. The load is spread over
0.12 m by (1 + cos), as the height of a rail spreads it on its way to the foot. GIVE [m] is how much more the
program's own rail gives way to the standing wheel half way between two sleepers than over one (difference of `axle
lowered by` with `Track/First sleeper` = 300 and 0 mm): the beam's EI is scaled until it gives the same. The beam
starts in equilibrium, at rest, or with the deflection travelling along, which is how a run starts. Prints the
vertical force, means over 40 mm of rail, and its swing from 40 to 560 mm.
"""

import os
import sys

import h5py
import numpy as np
import scipy.sparse as sparse
from scipy.optimize import brentq
from scipy.sparse.linalg import splu

# prm/squat_track.prm and 54E1
SPEED, BAY, PAD_LENGTH = 140 / 3.6, 0.6, 0.15
PAD, BALLAST, SLEEPER = 300e6, 50e6, 160.0
PAD_DAMPER, BALLAST_DAMPER = 0.25 * PAD / (2 * np.pi * 500), BALLAST / (2 * np.pi * 100)
YOUNG, SHEAR, INERTIA, AREA, DENSITY, SHEAR_FACTOR = 210e9, 80.8e9, 2.3379e-5, 69.77e-4, 7850.0, 0.4
APPROACH = 84e-6            # of Hertz under the wheel load
LENGTH, CELL, END = 15.0, 12.5e-3, 3.0
SPREAD = 0.06               # half of what the load is spread over


class Track:
    """The beam with its sleepers: K, C, M; deflections down [m], rotations, then sleepers."""

    def __init__(self, stiffer):
        self.start = LENGTH / 2
        self.bending, self.shear = stiffer * YOUNG * INERTIA, SHEAR * AREA * SHEAR_FACTOR
        self.phi = 12 * self.bending / (self.shear * CELL**2)
        self.cells = int(round(LENGTH / CELL))
        places = self.start + BAY / 2 + BAY * np.arange(-20, 20)
        self.sleepers = places[(places > 0.1) & (places < LENGTH - 0.1)]
        size = 2 * (self.cells + 1) + len(self.sleepers)
        self.K, self.C, self.M = (sparse.lil_matrix((size, size)) for _ in range(3))
        self.size = size
        self.add_beam()
        self.add_sleepers()
        self.K, self.C, self.M = (sparse.csc_matrix(m) for m in (self.K, self.C, self.M))
        self.flexible = splu(self.K)

    def add_beam(self):
        """Cubic elements with shear (Przemieniecki 1968, sections 5.6, 11.7; their mass without shear)."""
        h, phi, m = CELL, self.phi, DENSITY * AREA
        stiff = self.bending / (h**3 * (1 + phi)) * np.array(
            [[12, 6 * h, -12, 6 * h], [6 * h, (4 + phi) * h**2, -6 * h, (2 - phi) * h**2],
             [-12, -6 * h, 12, -6 * h], [6 * h, (2 - phi) * h**2, -6 * h, (4 + phi) * h**2]])
        mass = m * h / 420 * np.array(
            [[156, 22 * h, 54, -13 * h], [22 * h, 4 * h**2, 13 * h, -3 * h**2],
             [54, 13 * h, 156, -22 * h], [-13 * h, -3 * h**2, -22 * h, 4 * h**2]])
        mass += DENSITY * INERTIA / (30 * h) * np.array(
            [[36, 3 * h, -36, 3 * h], [3 * h, 4 * h**2, -3 * h, -h**2],
             [-36, -3 * h, 36, -3 * h], [3 * h, -h**2, -3 * h, 4 * h**2]])
        for e in range(self.cells):
            middle, own = (e + 0.5) * h, slice(2 * e, 2 * e + 4)
            within = max(0, END - middle, middle - (LENGTH - END))
            self.K[own, own] += stiff
            self.M[own, own] += mass
            self.C[own, own] += 15 * 2000 / END * (within / END)**2 * mass

    def add_sleepers(self):
        points = 9
        for j, place in enumerate(self.sleepers):
            own = 2 * (self.cells + 1) + j
            for s in np.linspace(-PAD_LENGTH / 2, PAD_LENGTH / 2, points):
                where, shape = self.shape(place + s)
                of = np.append(where, own)
                w = np.append(shape, -1)
                self.K[np.ix_(of, of)] += PAD / points * np.outer(w, w)
                self.C[np.ix_(of, of)] += PAD_DAMPER / points * np.outer(w, w)
            self.K[own, own] += BALLAST
            self.C[own, own] += BALLAST_DAMPER
            self.M[own, own] += SLEEPER

    def shape(self, x):
        """Unknowns and their shares of the deflection at a place."""
        e = min(int(x / CELL), self.cells - 1)
        s, p, h = x / CELL - e, self.phi, CELL
        shares = np.array([1 - 3 * s**2 + 2 * s**3 + p * (1 - s), h * (s - 2 * s**2 + s**3 + p / 2 * (s - s**2)),
                           3 * s**2 - 2 * s**3 + p * s, h * (-s**2 + s**3 + p / 2 * (s**2 - s))]) / (1 + p)
        return np.arange(2 * e, 2 * e + 4), shares

    def spread(self, x):
        """What a load at x is to all unknowns."""
        out, s = np.zeros(self.size), np.linspace(-0.9, 0.9, 7)
        weight = 1 + np.cos(np.pi * s)
        for one, part in zip(s, weight / weight.sum()):
            where, shares = self.shape(x + SPREAD * one)
            out[where] += part * shares
        return out

    def give(self, x, load):
        """Deflection at a load standing there [m]."""
        s = self.spread(x)
        return load * (s @ self.flexible.solve(s))

    def deeper_between(self, load):
        """How much deeper a standing load sinks half way between two sleepers than over one [m]."""
        return self.give(self.start, load) - self.give(self.start + BAY / 2, load)

    def travelling(self, deflected):
        """Velocities of a deflection that moves along; a sleeper follows as pad and ballast share it."""
        v = np.zeros(self.size)
        ends = 2 * (self.cells + 1)
        v[0:ends:2] = -SPEED * np.gradient(deflected[0:ends:2], CELL)
        v[1:ends:2] = np.gradient(v[0:ends:2], CELL)
        for j, place in enumerate(self.sleepers):
            where, shares = self.shape(place)
            v[ends + j] = PAD / (PAD + BALLAST) * (shares @ v[where])
        return v


def roll(track, wheel, load, path, travels):
    """Rolled distance [m] and contact force [N]."""
    dt, hertz = 2e-5, load / APPROACH**1.5
    s = track.spread(track.start)
    u = load * track.flexible.solve(s)
    v = track.travelling(u) if travels else np.zeros(track.size)
    y, yd, ya, force = s @ u + APPROACH, 0.0, 0.0, load
    a = splu(track.M).solve(load * s - track.C @ v - track.K @ u)
    step = splu(sparse.csc_matrix(track.M + dt / 2 * track.C + dt**2 / 4 * track.K))
    rows = []
    for n in range(1, int(path / SPEED / dt) + 1):
        s = track.spread(track.start + n * dt * SPEED)
        u, v = u + dt * v + dt**2 / 4 * a, v + dt / 2 * a
        y, yd = y + dt * yd + dt**2 / 4 * ya, yd + dt / 2 * ya
        free, of_force = step.solve(-track.C @ v - track.K @ u), step.solve(s)
        gap = y - s @ (u + dt**2 / 4 * free)
        moves = dt**2 / 4 * (s @ of_force)
        for _ in range(8):      # Newton's method on F = C d^(3/2)
            d = max(gap + dt**2 / 4 * (load - force) / wheel - moves * force, 1e-9)
            force -= (hertz * d**1.5 - force) / (-1.5 * hertz * d**0.5 * (dt**2 / 4 / wheel + moves) - 1)
        a, ya = free + force * of_force, (load - force) / wheel
        u, v = u + dt**2 / 4 * a, v + dt / 2 * a
        y, yd = y + dt**2 / 4 * ya, yd + dt / 2 * ya
        rows.append((n * dt * SPEED, force))
    return np.array(rows).T


def smooth(place, values, at):
    return np.array([values[np.abs(place - x) < 0.02].mean() for x in at])


def main():
    if not 2 <= len(sys.argv) <= 3:
        sys.exit(__doc__)
    with h5py.File(os.path.join(sys.argv[1], "history.h5")) as file:
        rolled, force, rises = (file[name][:] for name in ("rolled_distance", "vertical_force", "axle_acceleration"))
    at = np.arange(0.04, 0.561, 0.04)
    curves = {"run": smooth(rolled, force, at)}
    # wheel and half axle are what turns acceleration into force
    wheel, load = np.polyfit(smooth(rolled, rises, at), curves["run"], 1)

    stiffer = 1.0
    if len(sys.argv) > 2:
        stiffer = brentq(lambda x: Track(x).deeper_between(load) - float(sys.argv[2]), 0.8, 1.8, xtol=1e-2)
    track = Track(stiffer)
    print(f"wheel {wheel:.0f} kg, load {1e-3 * load:.2f} kN, EI x {stiffer:.2f}, "
          f"give {1e6 * track.deeper_between(load):.1f} um")
    for name, travels in (("beam, deflection travels", True), ("beam, at rest", False)):
        place, pressed = roll(track, wheel, load, at[-1] + 0.02, travels)
        curves[name] = smooth(place, pressed, at)
    print("place [mm]; vertical force [kN]: " + ", ".join(curves))
    for k, x in enumerate(at):
        print(f"{1e3 * x:4.0f}  " + "  ".join(f"{1e-3 * curve[k]:7.2f}" for curve in curves.values()))
    print("swing [kN]  " + ", ".join(f"{name} {1e-3 * np.ptp(curve):.2f}" for name, curve in curves.items()))


if __name__ == "__main__":
    main()
