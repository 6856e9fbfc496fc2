"""Pictures of runs over irregular surfaces: force, axle-box acceleration, rail velocity and stress over the path with the
surfaces under the wheel, and spectra (Welch 1967, by matplotlib)."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib import mlab

import style


def surfaces(run):
    return [name for name in ("rail_irregularity", "wheel_irregularity")
            if name in run.history and np.ptp(run.history[name]) > 0]


def curves(run):
    """Title, label of the axis, and (column, factor) of what belongs together; what the history lacks is left out."""
    known = [("Both rails", "force [kN]", [("first_rail_force", 1e-3), ("second_rail_force", 1e-3)]),
             ("Axle box", "axle box [m/s2]", [("axle_acceleration", 1)]),
             ("Rail around the wheel", "rail [m/s]", [("rail_velocity", 1)]),
             ("Largest von Mises stress", "stress [MPa]", [("max_von_mises", 1e-6)]),
             ("Heights under the wheel", "height [um]", [(name, 1e6) for name in surfaces(run)])]
    return [(title, label, [one for one in columns if one[0] in run.history]) for title, label, columns in known
            if any(name in run.history for name, _ in columns)]


def groups(run):
    """The same for the interactive view, as history_pictures.groups()."""
    if not run.history or not surfaces(run):
        return {}
    x = 1e3 * run.history["rolled_distance"]
    return {title: (label, [(name.replace("_", " "), x, factor * run.history[name], None) for name, factor in columns])
            for title, label, columns in curves(run)}


def draw_histories(run):
    """Vertical force, what the history has besides, and heights over the rolled distance."""
    x = 1e3 * run.history["rolled_distance"]
    rows = [("force [kN]", [("vertical_force", 1e-3, style.RED)])]
    rows += [(label.replace(" [", "\n["), [(name, factor, color) for (name, factor), color in zip(columns, style.COLORS)])
             for _, label, columns in curves(run)]
    figure, axes = plt.subplots(len(rows), 1, figsize=(7.6, 1.0 + 1.7 * len(rows)), sharex=True)
    for one, (label, columns) in zip(axes, rows):
        for name, factor, color in columns:
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


#: of the summary: name, label
RESONANCES = [("pinned_pinned_Hz", "pinned-pinned"), ("contact_resonance_Hz", "contact resonance")]


def resonances(run):
    """Label and frequency of those that are known [Hz]."""
    found = [(label, (run.summary or {}).get(name)) for name, label in RESONANCES]
    return [(label, frequency) for label, frequency in found if frequency]


def mark_resonances(run, axes):
    for label, frequency in resonances(run):
        if axes.get_xlim()[0] < frequency < axes.get_xlim()[1]:
            axes.axvline(frequency, color=style.GREY, linewidth=0.9, linestyle=":")
            axes.text(frequency, 0.03, f"{label} {frequency:.0f} Hz ", rotation=90, va="bottom", ha="right", fontsize=7,
                      color=style.GREY, transform=axes.get_xaxis_transform())


def draw_spectra(run):
    known = [(name, unit) for name, unit in (("vertical_force", "N"), ("axle_acceleration", "m/s$^2$"),
                                             ("rail_velocity", "m/s")) if name in run.history]
    figure, axes = plt.subplots(len(known), 1, figsize=(7.6, 0.6 + 2.4 * len(known)), sharex=True, squeeze=False)
    axes = axes[:, 0]
    for one, (name, unit) in zip(axes, known):
        frequency, density = spectrum(run.history["time"], run.history[name])
        one.loglog(frequency, np.sqrt(density), color=style.BLUE, linewidth=1.2)
        one.set_ylabel(f"{name.replace('_', ' ')}\n[{unit}/Hz$^{{1/2}}$]")
        one.grid(True, which="both", linewidth=0.4)
        one.set_xlim(right=2e4)
        mark_resonances(run, one)
    axes[-1].set_xlabel("frequency [Hz]")
    axes[0].set_title("Spectra (Welch)")
    caption = "Spectra of force, axle-box acceleration and rail velocity"
    for label, frequency in resonances(run):
        if frequency < axes[0].get_xlim()[0]:
            caption += f"; the {label} of {frequency:.0f} Hz is below what so short a path resolves"
    return [(caption, style.save(run, figure, "spectra"))]


def draw_all(run):
    """A list of (caption, path); nothing of a run over smooth surfaces."""
    if not run.history or not surfaces(run) or len(run.history["time"]) < 32:
        return []
    return draw_histories(run) + draw_spectra(run)
