"""What all pictures share: fonts, colours, saving."""

import os
import sys

try:
    import matplotlib
except ImportError as error:
    sys.exit(f"{error}; install the Debian package python3-matplotlib")

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402  (the backend is chosen first)

BLUE, RED, GREEN, ORANGE, GREY = "#1f5fa8", "#c0392b", "#2e8b57", "#d98200", "#6b6b6b"
COLORS = [BLUE, RED, GREEN, ORANGE, "#7d4fa3", GREY]

matplotlib.rcParams.update({
    "font.size": 10,
    "axes.titlesize": 11,
    "axes.labelsize": 10,
    "legend.fontsize": 9,
    "legend.frameon": False,
    "figure.dpi": 100,
    "savefig.dpi": 150,
    "axes.grid": False,
    "axes.axisbelow": True,
    "grid.color": "#d9d9d9",
    "grid.linewidth": 0.6,
})


def save(run, figure, name):
    """Saves a figure under pictures/; the tight box keeps every label inside."""
    path = os.path.join(run.pictures_folder, name + ".png")
    figure.savefig(path, bbox_inches="tight", pad_inches=0.12)
    plt.close(figure)
    return path
