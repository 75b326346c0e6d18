# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run a scene with many settings; see doc/studies.md.

Each run has a directory of its own, in which it stays: a study that was stopped goes
on with the runs that have not ended.
"""

import argparse
import csv
import os
import sys
from concurrent.futures import ThreadPoolExecutor

from program import Program, Refusal, read_run
from study_file import SUMMARY, read_study, words


def main(options):
    try:
        study = read_study(options.study)
        program = Program(options.program, study.scene)
        check(study, program)
    except Refusal as refusal:
        print(f"scripts/study: {refusal}.", file=sys.stderr)
        return 1
    failures = run_all(study, program)
    runs = [None if failure else read_run(study.directory / name)
            for name, failure in zip(study.names, failures)]
    write_table(study, runs)
    try:
        draw(study, runs)
    except Refusal as refusal:
        print(f"scripts/study: {refusal}.", file=sys.stderr)
        return 1
    print(f"{len(runs)} runs, {sum(map(bool, failures))} failed; "
          f"{study.directory / 'study.csv'}")
    return 1 if any(failures) else 0


def check(study, program):
    """Raises Refusal where the program takes one of the scenes for wrong, before anything
    is written."""
    def wrong_with(settings, name):
        try:
            parameters = program.parameters(settings, study.directory / name)
            if study.sheet is not False and parameters["Output/Frames"] == "none":
                raise Refusal("Output/Frames is none, and a sheet needs frames")
        except Refusal as refusal:
            return f"with {words(settings)}: {refusal}"
        return None

    with ThreadPoolExecutor(study.jobs) as pool:
        for wrong in pool.map(wrong_with, study.settings, study.names):
            if wrong:
                raise Refusal(wrong)


def run_all(study, program):
    """What is wrong with each run; None where nothing is."""
    def run(settings, name):
        try:
            program.run(settings, study.directory / name)
        except Refusal as refusal:
            print(f"scripts/study: {name} failed: {refusal}.", file=sys.stderr,
                  flush=True)
            return str(refusal)
        return None

    with ThreadPoolExecutor(study.jobs) as pool:
        return list(pool.map(run, study.settings, study.names))


def write_table(study, runs):
    """study.csv: a line for each run, whose numbers are empty where it failed or has
    none."""
    names = list(dict.fromkeys(name for run in study.settings for name in run))
    os.makedirs(study.directory, exist_ok=True)
    temporary = study.directory / ".writing-study.csv"
    with open(temporary, "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["directory", *names, *SUMMARY])
        for name, settings, run in zip(study.names, study.settings, runs):
            numbers = [run.summary.get(key) if run else None for key in SUMMARY]
            table.writerow([name, *(settings.get(key, "") for key in names),
                            *("" if number is None else number for number in numbers)])
    os.replace(temporary, study.directory / "study.csv")


def draw(study, runs):
    from study_plots import plot_curves, plot_pair  # takes a second to import
    ended = [(settings, run) for settings, run in zip(study.settings, runs) if run]
    if not ended:
        return
    plot_curves(ended, study.directory / "forces")
    for pair in study.plots:
        plot_pair(ended, pair, study.directory)
    if study.sheet is not False:
        from study_sheet import draw_sheet
        draw_sheet(ended, study.directory / "sheet", study.sheet)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(prog="scripts/study",
                                     description="Run a scene with many settings.")
    parser.add_argument("study", help="what to run, as doc/studies.md says (.toml)")
    parser.add_argument("--program", required=True, help=argparse.SUPPRESS)
    sys.exit(main(parser.parse_args()))
