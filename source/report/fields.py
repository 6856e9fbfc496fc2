"""The contact patch of one tick in mm and MPa: maps, its edge, and the lines AA and BB.

The lateral coordinate s grows to the track centre, which is the side of the gauge corner (G.C.); the field
side (F.S.) is at negative s. `along` counts from the axle, positive ahead. AA is the plane along the rail through
the highest pressure, BB the one across it: AA_peak and BB_peak of slices.h5.
"""

import numpy as np

LOADED = 1e-3  # a node counts as loaded above this part of the peak, as in sampling/patch_edge.cc


class Fields:
    """The patch cut to the loaded nodes and a margin; arrays [along, lateral]. `patch` is a tick of patch.h5."""

    def __init__(self, patch, margin=2):
        loaded = patch["pressure"] > LOADED * patch["pressure"].max()
        rows, columns = np.nonzero(loaded.any(axis=1))[0], np.nonzero(loaded.any(axis=0))[0]
        cut = (slice(max(rows[0] - margin, 0), rows[-1] + margin + 1),
               slice(max(columns[0] - margin, 0), columns[-1] + margin + 1))
        self.along, self.lateral = 1e3 * patch["along"][cut], 1e3 * patch["lateral"][cut]
        self.pressure = 1e-6 * patch["pressure"][cut]
        self.shear_along, self.shear_lateral = 1e-6 * patch["shear_along"][cut], 1e-6 * patch["shear_lateral"][cut]
        self.shear = np.hypot(self.shear_along, self.shear_lateral)
        self.state = np.rint(patch["state"][cut]).astype(int)
        self.slip = np.hypot(patch["slip_along"][cut], patch["slip_lateral"][cut]) if "slip_along" in patch else None
        self.loaded = loaded[cut]
        span = getattr(patch, "span", None)
        self.span = None if span is None else (1e3 * span[0], 1e3 * span[1])  # first and last place s of the patch
        self.area = patch["area"][cut] if "area" in patch else np.ones_like(self.pressure)
        self.edge = self.edge_level(patch, cut)
        self.between = self.points_between(patch)

    @staticmethod
    def points_between(patch):
        """Points between the nodes at which shear peaks, where stick and slip meet (slip_edge() of sampling/): places
        and values by the names of the fields; no points where the file has none."""
        none = np.zeros(0)
        read = {name: factor * np.asarray(patch.get("edge_" + name, none)) for name, factor in
                (("along", 1e3), ("lateral", 1e3), ("pressure", 1e-6), ("shear_along", 1e-6), ("shear_lateral", 1e-6))}
        return {**read, "shear": np.hypot(read["shear_along"], read["shear_lateral"])}

    def peak_shear(self):
        """Place (s, along) and size of the largest shear traction, at or between the nodes."""
        s, along, shear = (np.append(getattr(self, name).ravel(), self.between[name])
                           for name in ("lateral", "along", "shear"))
        k = np.argmax(shear)
        return s[k], along[k], shear[k]

    def edge_level(self, patch, cut):
        """A field whose zero line is the edge: gap^(2/3) outside, -(p^2) inside, both linear at the edge,
        scaled so that they have the same slope there."""
        square = (self.pressure / self.pressure.max()) ** 2
        if "gap" not in patch:
            return LOADED - square
        opening = np.cbrt(np.clip(patch["gap"][cut], 0, None)) ** 2
        rim_in = self.loaded & touches(~self.loaded)
        rim_out = ~self.loaded & touches(self.loaded)
        if not rim_in.any() or not opening[rim_out].any():
            return LOADED - square
        scale = np.mean(square[rim_in]) / np.mean(opening[rim_out])
        return np.where(self.loaded, -square, np.minimum(scale * opening, 1))

    def nearest(self, values):
        """Of nodes beside the loaded ones the value of the nearest loaded one, elsewhere 0."""
        found = np.where(self.loaded, values, 0)
        known = self.loaded.copy()
        for _ in range(2):
            for axis in (0, 1):
                for step in (1, -1):
                    there, other = np.roll(known, step, axis), np.roll(found, step, axis)
                    take = ~known & there
                    found, known = np.where(take, other, found), known | take
        return found

    @property
    def spacing(self):
        return abs(self.along[1, 0] - self.along[0, 0])

    @property
    def stick_share(self):
        """Sticking part of the loaded area."""
        return np.sum(self.area[(self.state == 1) & self.loaded]) / np.sum(self.area[self.loaded])

    def peak_place(self):
        """Indices of the largest pressure."""
        return np.unravel_index(np.argmax(self.pressure), self.pressure.shape)

    def places(self):
        """Where AA (s) and BB (along) cut the patch [mm]: through the highest pressure."""
        peak = self.peak_place()
        return {"AA": self.lateral[peak], "BB": self.along[peak]}

    def line(self, plane, place):
        """Positions on the line AA (at s = place) or BB (at along = place), and a function that gives a field by its
        name there, interpolated between the rows of nodes; on AA also at the points between nodes."""
        axis = 1 if plane == "AA" else 0
        across = self.lateral[0] if axis else self.along[:, 0]
        k = int(np.clip(np.searchsorted(across, place) - 1, 0, len(across) - 2))
        weight = np.clip((place - across[k]) / (across[k + 1] - across[k]), 0, 1)
        near = np.abs(self.between["lateral"] - place) < 0.5 * abs(across[1] - across[0])
        near &= axis == 1
        position = np.append(self.along[:, 0] if axis else self.lateral[0], self.between["along"][near])
        order = np.argsort(position)

        def on_line(name):
            field = getattr(self, name)
            nodal = (1 - weight) * np.take(field, k, axis) + weight * np.take(field, k + 1, axis)
            return np.append(nodal, self.between[name][near])[order]

        return position[order], on_line


def touches(mask):
    """Nodes that have a neighbour in the mask."""
    near = np.zeros_like(mask)
    near[1:] |= mask[:-1]
    near[:-1] |= mask[1:]
    near[:, 1:] |= mask[:, :-1]
    near[:, :-1] |= mask[:, 1:]
    return near
