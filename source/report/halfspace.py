#!/usr/bin/python3
"""Draws the pictures of a half-space contact.

Usage: halfspace.py FOLDER

FOLDER holds halfspace.h5, summary.json and parameters.prm of the command halfspace; the pictures go to
FOLDER/pictures: pressure, shear traction, stick and slip, a cut along the rail, and all maps on one sheet.
"""

import sys

sys.dont_write_bytecode = True  # the scripts may lie in a folder that is not ours to write to

import maps
import patch_pictures
import run_data


def main(arguments):
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 1
    try:
        run = run_data.load(arguments[0], "last", patch_file="halfspace.h5", with_history=False)
        pictures = [("All maps", maps.draw_sheet(run))] + patch_pictures.draw_all(run)
    except (run_data.ReportError, OSError) as error:
        print(error, file=sys.stderr)
        return 1
    for sentence in run.remarks:
        print(sentence)
    print(f"{len(pictures)} pictures in {run.pictures_folder}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
