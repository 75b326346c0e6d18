# SPDX-License-Identifier: LGPL-2.1-or-later
"""scripts/calibrate: that its intervals hold the truth, what it writes and refuses.

usage: calibrate.py PROGRAM
"""

import csv
import pathlib
import re
import sys
import tempfile

from scripts import SCENE, Failure, needs, refuses, start

FREE = ["Material/Young's modulus", "Material/Toughness", "Blade/Friction"]
TRUTH = [20, 1, 0.2]
# From where the fits start.
OFF = SCENE.replace("= 20\n", "= 22\n").replace("Toughness       = 1\n",
                                                "Toughness       = 0.9\n")
NOISE = 0.02  # of the mean force
HEAD = "travel [mm],force [mN]\n"
POINTS = "1,1\n2,1\n3,2\n4,2\n5,2\n"
# A curve, what is free, and what the sentence must have.
WRONG = [
    ("", FREE, "curve.csv' is empty"),
    ("travel,force [mN]\n" + POINTS, FREE, r"no column 'travel \[UNIT\]'"),
    ("travel [mm],load [mN]\n" + POINTS, FREE, r"no column 'force \[UNIT\]'"),
    ("travel [inch],force [mN]\n" + POINTS, FREE, "'inch'.*m, cm, mm, um"),
    ("travel [mm],force [lbf]\n" + POINTS, FREE, "'lbf'.*N, kN, mN, uN, gf, kgf"),
    (HEAD + "1,1\n3,1\n2,2\n", FREE[:1], "curve.csv:4: .*'2' must be more"),
    (HEAD + "1,1\n2,one\n3,2\n", FREE[:1], "curve.csv:3: 'one' is not a number"),
    (HEAD + "1,1\n2\n3,2\n", FREE[:1], "curve.csv:3: '' is not a number"),
    (HEAD + "1,1\n2,nan\n3,2\n", FREE[:1], "curve.csv:3: 'nan' is not a number"),
    (HEAD + "1,1\n2,1\n3,2\n", FREE, "3 points.*at least 4 for 3 free"),
    (HEAD + "-2,0\n-1,0\n", FREE[:1], "ends before"),
    (HEAD + POINTS, ["Blade/Colour"], "no parameter 'Blade/Colour'"),
    (HEAD + POINTS, ["Blade/Shape"], "'wedge', which is not a number"),
    (HEAD + POINTS, ["Blade/Sharpness"], "Sharpness.* is 0: without --bounds"),
    (HEAD + POINTS, FREE[:1] * 2, "free twice"),
    (HEAD + POINTS, ["Material/Poisson's ratio"], "bound 30 of .*less than 0.5"),
    (HEAD + POINTS, [FREE[1], "--bounds", "Material/Toughness=2"], "not of the form"),
    (HEAD + POINTS, [FREE[1], "--bounds", "Material/Toughness=2,3"], "not between"),
    (HEAD + POINTS, [FREE[1], "--bounds", "Blade/Friction=0,1"], "not free"),
]


def arguments(free, scene="off.prm"):
    words, names = [scene, "curve.csv", "--output", "out"], list(free)
    while names:
        words += ([names.pop(0), names.pop(0)] if names[0] == "--bounds" else
                  ["--free", names.pop(0)])
    return words


def check_refusals(program, folder):
    for text, free, piece in WRONG:
        (folder / "curve.csv").write_text(text)
        refuses("calibrate", program, *arguments(free), folder=folder, pieces=[piece])
    (folder / "way.prm").write_text(SCENE.replace("= wedge\n",
                                                  "= wedge\n  set Travel = 5, 2\n"))
    refuses("calibrate", program, *arguments(FREE, "way.prm"), folder=folder,
            pieces=["Blade/Travel .*must be empty"])
    refuses("calibrate", program, *arguments(FREE, "other.prm"), folder=folder,
            pieces=["other.prm"])


def check_units():
    """Units are converted; what has none of the program's stays what it is."""
    from measured_curve import factor_of, LENGTHS, FORCES, columns_of
    scene = {"Length unit": "mm", "Force unit": "mN", "Dimension": "2"}
    for words, factors in ((["time [s]", "travel [cm]", "force [gf]"], [10, 9.80665]),
                           (["force [N/m]", "travel [um]"], [1e-3, 1])):
        places, found = columns_of("file", words, scene)
        if not np.allclose(found, factors, rtol=1e-12) or \
                [words[place][0] for place in places] != ["t", "f"]:
            raise Failure(f"the columns {words} are at {places}, with factors {found}")
    if factor_of("file", "foot", "foot", LENGTHS, "Length") != 1 or \
            factor_of("file", "kgf", "N", FORCES, "Force") != 9.80665:
        raise Failure("units are converted wrongly")


def check_cells():
    """Cells take a force that rises evenly exactly, from uneven points too, and their
    work is the trapezoid rule's; between yields the work rises evenly."""
    from measured_curve import cells_around, mean_forces, work_of
    travel = np.array([1., 2., 3., 5., 7.])
    ends = cells_around(travel)
    if list(ends) != [0.5, 1.5, 2.5, 4., 6., 8.]:
        raise Failure(f"the cells end at {ends}")
    dense = np.linspace(0, 9, 901)
    even = mean_forces(np.array([dense, dense**2]), ends)
    if not np.allclose(even, ends[1:] + ends[:-1], rtol=1e-9):
        raise Failure(f"the mean forces of 2 p are {even}")
    events = [("rest", 0, 0), ("travel", 1, 1), ("deform", 2, 4), ("yield", 2, 4),
              ("release", 2, 4), ("travel", 3, 4.2), ("deform", 4, 6), ("yield", 4, 6),
              ("yield", 4, 6), ("arrest", 5, 6.5), ("divide", 5, 3)]
    found = work_of([{"cut": 0, "event": event, "travel": float(travel), "work": work}
                     for event, travel, work in events])
    if found.T.tolist() != [[0, 0], [1, 1], [2, 4], [4, 6], [5, 6.5]]:
        raise Failure(f"the work is {found.T.tolist()}")


def check_statistics():
    """Errors of a straight line, in closed form, and the quantile of Student's t with 8
    degrees of freedom, out of tables."""
    from least_squares import describe
    x, noise = np.arange(10.), np.random.default_rng(1).normal(size=10)
    jacobian = np.stack([np.ones(10), x], axis=1)
    residuals = noise - jacobian @ np.linalg.lstsq(jacobian, noise, rcond=None)[0]
    found = describe(jacobian, residuals)
    spread = np.sum((x - x.mean())**2)
    s = np.sqrt(np.sum(residuals**2) / 8)
    if not np.allclose(found.errors, [s * np.sqrt(1 / 10 + x.mean()**2 / spread),
                                      s / np.sqrt(spread)]) or \
            not np.allclose(found.half_widths, 2.306004 * found.errors, rtol=1e-6) or \
            not np.isclose(found.correlations[0, 1],
                           -x.mean() / np.sqrt(np.mean(x**2))):
        raise Failure(f"the statistics of a line are {found}")


def check_sharing(n_tries=4000, n=60):
    """Intervals of points hold the truth in 95 % of tries, by their binomial error; those
    of the trapezoid rule's bins, of which neighbours share a point, in as many as
    P(|z| < 1.96 / sqrt(2)) = 83.4 %, unless they are whitened."""
    from least_squares import describe
    x = np.linspace(-1, 1, n)
    jacobian = np.stack([np.ones(n), x, x**2], axis=1)
    bins = (np.eye(n)[1:] + np.eye(n)[:-1]) / 2
    white = np.linalg.solve(np.linalg.cholesky(bins @ bins.T), bins)
    random = np.random.default_rng(2)
    held = np.zeros((3, 3))
    for _ in range(n_tries):
        noise = random.normal(size=n)
        for i, change in enumerate((np.eye(n), bins, white)):
            j, f = change @ jacobian, change @ noise
            found = np.linalg.lstsq(j, f, rcond=None)[0]
            held[i] += abs(found) < describe(j, f - j @ found).half_widths
    # Three binomial errors; the bins' ends, and 58 degrees of freedom, change 83.4 %.
    for part, wanted, off in zip(held / n_tries, (0.95, 0.834, 0.95), (0, 0.01, 0)):
        error = 3 * np.sqrt(wanted * (1 - wanted) / n_tries) + off
        if np.any(abs(part - wanted) > error):
            raise Failure(f"intervals hold the truth in {held / n_tries} of the tries")


def model_and_curve(program, folder):
    """The model of a calibration that starts from other values, and the true curve."""
    import calibrate
    travel = np.arange(0.1, 9, 0.2)
    (folder / "curve.csv").write_text(
        HEAD + "".join(f"{p:.12g},1\n" for p in travel))
    model, data = calibrate.prepare(calibrate.parse(
        [str(folder / "off.prm"), str(folder / "curve.csv"), "--program", program,
         "--output", str(folder / "tries"), "--jobs", "2",
         *(word for name in FREE for word in ("--free", name))]))
    return model, data, model(np.log(TRUTH))


def check_scale(model):
    """The slope for Young's modulus that follows from the others is that of two runs."""
    x, step = np.log(TRUTH), 0.03 * np.eye(3)[0]
    runs = (model(x + step) - model(x - step)) / 0.06
    follows = model.jacobian(x)[:, 0]
    if np.linalg.norm(runs - follows) > 0.01 * np.linalg.norm(runs):
        raise Failure(f"the slopes for Young's modulus are {runs} and {follows}")
    twice = model(x + np.log([2, 2, 1]))
    if not np.allclose(twice, 2 * model(x), rtol=1e-7, atol=1e-9):
        raise Failure("forces are not multiplied with modulus and toughness")


def check_tries(model, data, truth, n_tries=10):
    """Of ten noisy curves at most two miss a parameter: with 95 % more do so once in a
    hundred times."""
    import calibrate
    held = np.zeros(3, int)
    for seed in range(n_tries):
        random = np.random.default_rng(seed)
        data.force = truth + random.normal(0, NOISE * truth.mean(), len(truth))
        result = calibrate.calibrate(model, data)
        held += [row.low < value < row.high for row, value in zip(result.rows, TRUTH)]
        if any(row.high > 2 * row.low for row in result.rows[:2]):
            raise Failure("the intervals are too wide to tell anything")
    print("intervals that hold the truth:", held)
    if min(held) < n_tries - 2:
        raise Failure(f"the truth is held by {held} intervals of {n_tries}")


def check_files(program, folder, model, truth):
    """A scene and a table with the values, which without noise are the true ones."""
    (folder / "curve.csv").write_text(HEAD + "".join(
        f"{(a + b) / 2:.12g},{force:.12g}\n"
        for a, b, force in zip(model.ends, model.ends[1:], truth)))
    start("calibrate", program, *arguments(FREE), folder=folder)
    with open(folder / "out" / "calibration.csv", newline="") as file:
        lines = list(csv.DictReader(file))
    values = [float(line["value"]) for line in lines]
    if [line["parameter"] for line in lines] != FREE or \
            not np.allclose(values, TRUTH, rtol=1e-3):
        raise Failure(f"the table is {lines}")
    from program import Program
    fitted = Program(program, folder / "out" / "fitted.prm").parameters({}, folder)
    before = Program(program, folder / "off.prm").parameters({}, folder)
    if not np.allclose([float(fitted[name]) for name in FREE], values, rtol=1e-6) or \
            {**fitted, **dict.fromkeys(FREE)} != {**before, **dict.fromkeys(FREE)}:
        raise Failure(f"the fitted scene has {fitted}")
    for name in ("fit.png", "fit.pdf"):
        if (folder / "out" / name).stat().st_size < 1000:
            raise Failure(f"{name} is empty")


def check_undetermined(program, folder):
    """Refused behind the runs: a parameter without effect, two of which only a product
    counts (toughness x (1 - sharpness)), and a curve that goes on behind the cut."""
    (folder / "blunt.prm").write_text(SCENE.replace("Sharpness       = 0",
                                                    "Sharpness       = 0.1"))
    for scene, free, pieces in (
            ("off.prm", ["Material/Shear limit", FREE[2]], ["Shear limit.*no effect"]),
            ("blunt.prm", [FREE[1], "Blade/Sharpness", "--bounds",
                           "Blade/Sharpness=0.01,0.5"],
             ["Toughness and Blade/Sharpness apart", "condition number"])):
        message = start("calibrate", program, *arguments(free, scene), folder=folder,
                        status=1)
        require_sentence(message, pieces)
    (folder / "curve.csv").write_text(HEAD + POINTS + "30,2\n")
    require_sentence(start("calibrate", program, *arguments(FREE), folder=folder,
                           status=1), ["travel of 42.5, .*beyond the end of the cut at 9"])


def require_sentence(message, pieces):
    if len(message.splitlines()) != 1 or \
            not all(re.search(piece, message) for piece in pieces):
        raise Failure(f"the message is '{message}'")


def main(program):
    with tempfile.TemporaryDirectory() as directory:
        folder = pathlib.Path(directory)
        (folder / "off.prm").write_text(OFF)
        try:
            check_units()
            check_cells()
            check_statistics()
            check_sharing()
            check_refusals(program, folder)
            model, data, truth = model_and_curve(program, folder)
            check_scale(model)
            check_tries(model, data, truth)
            check_files(program, folder, model, truth)
            check_undetermined(program, folder)
        except Failure as failure:
            print(f"FAILED: {failure}")
            return 1
    return 0


if __name__ == "__main__":
    needs("tomllib", "matplotlib", "scipy")
    import numpy as np
    sys.exit(main(str(pathlib.Path(sys.argv[1]).resolve())))
