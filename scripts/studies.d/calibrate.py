# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fit parameters of a scene to a measured force-travel curve; see doc/calibration.md.

Each run of the fit has a directory of its own, in which it stays: a calibration that was
stopped goes on.
"""

import argparse
import csv
import os
import pathlib
import sys
from concurrent.futures import ThreadPoolExecutor
from types import SimpleNamespace

import numpy as np
from free_parameters import OF_FORCE, follows_from_scale, free_parameters
from measured_curve import cells_around, mean_forces, read_curve, work_of
from program import Program, Refusal, read_run
from study_file import names_of, words

QUIET = {"Output/Frames": "none", "Output/Node tables": "false",
         "Output/CalculiX decks": "false"}
FAR = 1e9  # times the data's travel: beyond the end of any cut


class Model:
    """The mean forces that the scene gives in the cells of the data."""

    def __init__(self, program, free, travel, directory, jobs):
        self.program, self.free, self.jobs = program, free, jobs
        self.directory = pathlib.Path(directory)
        self.ends = cells_around(travel)
        self.parameters = program.parameters({}, directory)
        stops = list(self.ends[self.ends > 0])
        if not self.parameters["Board/Plane"]:  # which ends the way
            stops.append(FAR * stops[-1])
        self.settings = {**QUIET,
                         "Blade/Travel": ", ".join(f"{stop:.12g}" for stop in stops)}
        program.parameters(self.settings, directory)
        self.runs = {}

    def settings_at(self, x):
        return {parameter.name: f"{parameter.outward(value):.12g}"
                for parameter, value in zip(self.free, x)}

    def work(self, x):
        """Travels and works of a run, which is made unless it has been."""
        settings = self.settings_at(x)
        name, = names_of([settings])
        if name not in self.runs:
            try:
                self.program.run({**settings, **self.settings}, self.directory / name)
            except Refusal as refusal:
                raise Refusal(f"with {words(settings)}, from which --bounds may keep the "
                              f"fit: {refusal}") from refusal
            self.runs[name] = work_of(read_run(self.directory / name).statistics)
        return self.runs[name]

    def __call__(self, x):
        return mean_forces(self.work(x), self.ends)

    def jacobian(self, x):
        """Central differences; at a bound one-sided ones. Of a linear body the column of
        Young's modulus follows from the others."""
        low, high = bounds_of(self.free)
        follows = follows_from_scale(self.free, self.parameters)
        pairs = {}
        for i, parameter in enumerate(self.free):
            if not (follows and parameter.name == OF_FORCE[0]):
                pairs[i] = [np.clip(x + sign * parameter.step * np.eye(len(x))[i],
                                    low, high) for sign in (-1, 1)]
        with ThreadPoolExecutor(self.jobs) as pool:
            forces = list(pool.map(self, [x, *(y for pair in pairs.values()
                                               for y in pair)]))
        columns = np.zeros((len(forces[0]), len(x)))
        for n, (i, (below, above)) in enumerate(pairs.items()):
            columns[:, i] = ((forces[2 * n + 2] - forces[2 * n + 1]) /
                             (above[i] - below[i]))
        for i, parameter in enumerate(self.free):
            if i not in pairs:
                columns[:, i] = forces[0] - sum(
                    columns[:, other] for other in pairs
                    if self.free[other].name in OF_FORCE)
        return columns


def bounds_of(free):
    return tuple(np.array([parameter.inward(getattr(parameter, end))
                           for parameter in free]) for end in ("low", "high"))


def prepare(options):
    """The model and the data; raises Refusal where something is wrong, before anything
    is written."""
    program = Program(options.program, options.scene)
    parameters = program.parameters({}, options.output)
    for name, allowed in (("Blade/Drive", "travel"), ("Blade/Travel", ""),
                          ("Blade/Slice-push ratio", "0")):
        if parameters[name] != allowed:
            raise Refusal(f"{name} of the scene must be {allowed or 'empty'}, not "
                          f"'{parameters[name]}'")
    free = free_parameters(options.free, options.bounds, parameters)
    travel, force = read_curve(options.curve, parameters)
    if len(travel) < len(free) + 1:
        raise Refusal(f"'{options.curve}' has {len(travel)} points, and must have at "
                      f"least {len(free) + 1} for {len(free)} free parameters")
    if travel[-1] <= 0:
        raise Refusal(f"'{options.curve}' ends before the blade touches the body, at a "
                      "travel of 0")
    for parameter in free:
        for bound in (parameter.low, parameter.high):
            try:
                program.parameters({parameter.name: f"{bound:.12g}"}, options.output)
            except Refusal as refusal:
                raise Refusal(f"the bound {bound:g} of {parameter.name} is not allowed "
                              f"(--bounds '{parameter.name}=low,high'): {refusal}"
                              ) from refusal
    return (Model(program, free, travel, options.output, options.jobs),
            SimpleNamespace(travel=travel, force=force))


def calibrate(model, data):
    """The values, their 95 % intervals, and what else is known of them."""
    import least_squares  # takes a second
    start = np.array([parameter.inward(parameter.start) for parameter in model.free])
    names = [parameter.name for parameter in model.free]
    refuse_beyond(model, start)
    slopes = least_squares.Slopes(model.jacobian,
                                  np.array([parameter.step for parameter in model.free]))
    least_squares.refuse_without_effect(names, slopes(start), data.force)
    found = least_squares.fit(model, slopes, data.force, start, bounds_of(model.free))
    x = found.x
    jacobian, fitted = slopes(x), model(x)
    refuse_beyond(model, x)
    least_squares.refuse_without_effect(names, jacobian, data.force)
    condition = least_squares.refuse_together(names, jacobian)
    result = least_squares.describe(jacobian, data.force - fitted)
    result.x, result.fitted, result.jacobian = x, fitted, jacobian
    result.condition = condition
    result.converged = found.status > 0
    result.alike = least_squares.are_alike(result.neighbours, len(fitted))
    result.rows = [row_of(*row) for row in zip(model.free, x, result.half_widths)]
    return result


def row_of(parameter, x, half_width):
    """A parameter's value and interval."""
    at_bound = min(abs(x - parameter.inward(bound))
                   for bound in (parameter.low, parameter.high)) < 0.01 * parameter.step
    return SimpleNamespace(
        name=parameter.name, start=parameter.start, value=parameter.outward(x),
        low=parameter.outward(x - half_width), high=parameter.outward(x + half_width),
        at_bound=at_bound)


def refuse_beyond(model, x):
    """Raises Refusal where the last cell of the data is not within the cut."""
    end = model.work(x)[0, -1]
    if model.ends[-1] > (1 + 1e-9) * end:
        raise Refusal(f"the curve goes to a travel of {model.ends[-1]:g}, with the last "
                      f"point's part, beyond the end of the cut at {end:g} with "
                      f"{words(model.settings_at(x))}")


def notes(model, result):
    """What is to be known before the intervals are believed."""
    if not result.converged:
        yield "the fit has not converged in 50 steps"
    for row in result.rows:
        if row.at_bound:
            yield f"{row.name} lies at its bound, so that its interval means nothing"
    if result.alike:
        yield ("neighbouring residuals are alike (correlation "
               f"{result.neighbours:.2f}): the model does not follow the curve, or its "
               "noise is not independent from point to point; the intervals are too narrow")


def write_table(result, path):
    """calibration.csv: a line for each parameter."""
    temporary = path.with_name(".writing-" + path.name)
    with open(temporary, "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["parameter", "start", "value", "low", "high",
                        *(f"correlation with {row.name}" for row in result.rows)])
        for row, correlations in zip(result.rows, result.correlations):
            table.writerow([row.name, *(f"{number:.8g}" for number in
                                        (row.start, row.value, row.low, row.high)),
                            *(f"{number:.6f}" for number in correlations)])
    os.replace(temporary, path)


def write_scene(model, result, path):
    """A scene that is the given one with the values that were found."""
    scene = pathlib.Path(model.program.scene)
    lines = ["# Values of the last lines are fitted.",
             f"include {os.path.relpath(scene, path.parent)}"]
    body = model.parameters.get("Body/File", "")
    settings = {"Body/File": os.path.relpath(scene.parent / body, path.parent)} \
        if body else {}
    settings.update(model.settings_at(result.x))
    for name, value in settings.items():
        *sections, last = name.split("/")
        lines += [f"subsection {section}" for section in sections]
        lines += [f"set {last} = {value}", *(["end"] * len(sections))]
    path.write_text("\n".join(lines) + "\n")


def report(model, data, result, directory):
    for row in result.rows:
        print(f"{row.name} = {row.value:.5g} (95 %: {row.low:.5g} to {row.high:.5g})")
    for i, row in enumerate(result.rows):
        for j in range(i):
            print(f"correlation of {result.rows[j].name} and {row.name}: "
                  f"{result.correlations[i, j]:.3f}")
    unit = model.parameters.get("Force unit", "")
    print(f"noise {result.noise:.3g} {unit}".rstrip() + f", {len(data.travel)} points, "
          f"{result.freedom} degrees of freedom, condition number {result.condition:.3g}, "
          f"{len(model.runs)} runs; {directory / 'calibration.csv'}")


def main(options):
    try:
        model, data = prepare(options)
        result = calibrate(model, data)
    except Refusal as refusal:
        print(f"scripts/calibrate: {refusal}.", file=sys.stderr)
        return 1
    from calibration_plot import plot_fit  # takes a second to import
    directory = model.directory
    write_table(result, directory / "calibration.csv")
    write_scene(model, result, directory / "fitted.prm")
    plot_fit(model, data, result, directory / "fit")
    report(model, data, result, directory)
    for note in notes(model, result):
        print(f"scripts/calibrate: {note}.", file=sys.stderr)
    return 0


def parse(words_given=None):
    parser = argparse.ArgumentParser(
        prog="scripts/calibrate", description="Fit parameters of a scene to a curve.")
    parser.add_argument("scene", help="whose other parameters stay (.prm)")
    parser.add_argument("curve", help="'travel [UNIT],force [UNIT]' and numbers (.csv)")
    parser.add_argument("--free", action="append", required=True, metavar="NAME",
                        help="a parameter to fit, such as Material/Toughness; repeat it")
    parser.add_argument("--bounds", action="append", default=[], metavar="NAME=LOW,HIGH",
                        help="of a free parameter (a hundredth to a hundred times the "
                        "scene's value)")
    parser.add_argument("--output", default="results/calibration", metavar="DIR",
                        help="for runs and results (results/calibration)")
    parser.add_argument("--jobs", type=int, default=1, help="runs at once (1)")
    parser.add_argument("--program", required=True, help=argparse.SUPPRESS)
    options = parser.parse_args(words_given)
    if options.jobs < 1:
        parser.error("--jobs must be at least 1")
    return options


if __name__ == "__main__":
    sys.exit(main(parse()))
