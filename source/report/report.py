#!/usr/bin/python3
"""Draws the pictures of one run and writes its page.

Usage: report.py FOLDER [--tick last|NUMBER]

FOLDER is the output folder of a run: patch.h5, history.h5 and summary.json are read from it. The
pictures go to FOLDER/pictures, the page to FOLDER/report.html; the page holds its pictures itself and
needs no network. What a file that is missing would have given is left out, and a sentence says so.
Exit code 0 when there was something to report, 1 otherwise.
"""

import argparse
import sys

sys.dont_write_bytecode = True  # the scripts may lie in a folder that is not ours to write to

import page
import patch_pictures
import plastic_pictures
import history_pictures
import run_data


def parse_arguments(arguments):
    parser = argparse.ArgumentParser(prog="report", description="Pictures and one page of a run.")
    parser.add_argument("folder", help="output folder of the run")
    parser.add_argument("--tick", default="last", help="tick of patch.h5 to draw: a number, or last")
    return parser.parse_args(arguments)


def main(arguments):
    options = parse_arguments(arguments)
    try:
        run = run_data.load(options.folder, options.tick)
        pictures = patch_pictures.draw_all(run) + history_pictures.draw_all(run) + plastic_pictures.draw_all(run)
        path = page.write(run, pictures)
    except (run_data.ReportError, OSError) as error:
        print(error, file=sys.stderr)
        return 1
    for sentence in run.remarks:
        print(sentence)
    print(f"{len(pictures)} pictures in {run.pictures_folder}, the page is {path}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
