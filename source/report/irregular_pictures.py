"""Pictures of runs over irregular surfaces: force and axle-box acceleration over the way with the surfaces under the
wheel, and their spectra (Welch 1967, by matplotlib)."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib import mlab

import style


def surfaces(run):
    return [name for name in ("rail_irregularity", "wheel_irregularity")
            if name in run.history and np.ptp(run.history[name]) > 0]


def draw_way(run):
    """Vertical force, acceleration and heights over the rolled distance."""
    x = 1e3 * run.history["rolled_distance"]
    rows = [("force [kN]", [("vertical_force", 1e-3, style.RED)]),
            ("axle box [m/s$^2$]", [("axle_acceleration", 1, style.BLUE)]),
            ("height [um]", [(name, 1e6, color) for name, color in zip(surfaces(run), style.COLORS)])]
    figure, axes = plt.subplots(len(rows), 1, figsize=(7.6, 6.6), sharex=True)
    for one, (label, curves) in zip(axes, rows):
        for name, factor, color in curves:
            one.plot(x, factor * run.history[name], color=color, linewidth=1.2, label=name.replace("_", " "))
        one.set_ylabel(label)
        one.grid(True)
        one.margins(x=0)
        style.legend_beside(one)
    axes[0].set_title("Over the irregular surfaces")
    axes[-1].set_xlabel("rolled distance [mm]")
    return [("Force and acceleration over the irregular surfaces", style.save(run, figure, "irregular"))]


def spectrum(times, values):
    """Frequencies [Hz] and power spectral density of evenly spaced values, the mean taken off; segments of half the
    length, half of which overlap."""
    even = np.linspace(times[0], times[-1], len(times))
    segment = max(8, len(even) // 2)
    density, frequency = mlab.psd(np.interp(even, times, values), NFFT=segment, Fs=1 / (even[1] - even[0]),
                                  detrend=mlab.detrend_mean, noverlap=segment // 2)
    return frequency[1:], density[1:]


def draw_spectra(run):
    figure, axes = plt.subplots(2, 1, figsize=(7.6, 5.4), sharex=True)
    for one, (name, unit) in zip(axes, (("vertical_force", "N"), ("axle_acceleration", "m/s$^2$"))):
        frequency, density = spectrum(run.history["time"], run.history[name])
        one.loglog(frequency, np.sqrt(density), color=style.BLUE, linewidth=1.2)
        one.set_ylabel(f"{name.replace('_', ' ')}\n[{unit}/Hz$^{{1/2}}$]")
        one.grid(True, which="both", linewidth=0.4)
        one.set_xlim(right=2e4)
    axes[-1].set_xlabel("frequency [Hz]")
    axes[0].set_title("Spectra (Welch)")
    return [("Spectra of force and axle-box acceleration", style.save(run, figure, "spectra"))]


def draw_all(run):
    """A list of (caption, path); nothing of a run over smooth surfaces."""
    if not run.history or not surfaces(run) or len(run.history["time"]) < 32:
        return []
    return draw_way(run) + draw_spectra(run)
