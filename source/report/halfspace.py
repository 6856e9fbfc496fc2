#!/usr/bin/python3
"""Draws the pictures of a half-space contact.

Usage: halfspace.py FOLDER

FOLDER holds halfspace.h5, slices.h5, summary.json and parameters.prm of the command halfspace; the pictures go to
FOLDER/pictures: maps, cuts, stresses below the contact. `report` makes a page of them.
"""

import sys

sys.dont_write_bytecode = True  # the scripts may lie in a folder that is not ours to write to

import patch_pictures
import run_data
import subsurface_pictures
import wear_pictures


def main(arguments):
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 1
    try:
        run = run_data.load(arguments[0])
        pictures = patch_pictures.draw_all(run) + subsurface_pictures.draw_all(run) + wear_pictures.draw_all(run)
        if not pictures:
            raise run_data.ReportError(f"There is no loaded contact patch in {run.folder}.")
    except (run_data.ReportError, OSError) as error:
        print(error, file=sys.stderr)
        return 1
    for sentence in run.remarks:
        print(sentence)
    print(f"{len(pictures)} pictures in {run.pictures_folder}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
