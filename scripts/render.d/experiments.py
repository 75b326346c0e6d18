# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures and tables of doc/kakefuda_1996.md, from the painted runs."""

import csv
import os
import re
import shutil

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402
from film_strip import MARGIN, draw_foot  # noqa: E402
from panel import Pictures, save_small  # noqa: E402
from run_directory import RunDirectory  # noqa: E402
from words import load, stage  # noqa: E402

RESULTS = "results/kakefuda_1996"
IMAGES = "doc/images"
REPORT = "doc/kakefuda_1996.md"
SCENES = {"cut": "the paper's scene", "figure_6_left": "E = 2.5",
          "figure_6_right": "E = 10", "figure_7_left": "ν = 0.1",
          "figure_7_right": "ν = 0.4", "figure_8_left": "limit 1, ramp",
          "figure_8_right": "limit 2, ramp"}
FINE = "figure_6_left_fine"
MEASURES = [("cutting_stress", "cutting stress [gf/cm²]"),
            ("blade_force", "blade force [gf]"),
            ("max_displacement", "largest displacement [cm]"),
            ("max_strain", "largest strain"),
            ("width_x", "width along x [cm]"),
            ("width_y", "width along y [cm]"),
            ("rise", "rise of the edge [cm]")]
STATEMENTS = [
    ("6", "stiffer: smaller deformation", "max_displacement", "falls"),
    ("7", "larger ν: wider across the force, along x", "width_x", "grows"),
    ("7", "larger ν: wider across the force, along y", "width_y", "grows"),
    ("8", "larger limit: more deformation before the split",
     "max_displacement", "grows")]


def main():
    os.makedirs(IMAGES, exist_ok=True)
    shutil.copy(f"{RESULTS}/cut/render/film_strip.png", IMAGES)
    draw_beside("figure_6", [1])
    draw_beside("figure_7", [1])
    draw_beside("figure_8", [1, 2])
    measured = {name: measure(name) for name in (*SCENES, FINE)}
    fill_report({"rows": rows_table(), "scenes": scenes_table(measured),
                 "statements": statements_table(measured),
                 "edge": edge_table(measured),
                 "finite": finite_table(measured)})


def draw_beside(figure_name, frames):
    """The same frames of a figure's left and right scene."""
    names = [f"{figure_name}_{side}" for side in ("left", "right")]
    sides = [Pictures(read_run(name)) for name in names]
    columns = 2 * len(frames)
    left, right, below, above = window = sides[0].window(MARGIN)
    panel = min(2.9, 7.1 / columns)
    tall = panel * (above - below) / (right - left)
    width, height = panel * columns, 0.42 + tall + 0.9
    figure = plt.figure(figsize=(width, height), dpi=150)
    for column in range(columns):
        side, frame = divmod(column, len(frames))
        pictures, frame = sides[side], frames[frame]
        axes = figure.add_axes([column / columns, 0.9 / height, 1 / columns,
                                tall / height])
        pictures.draw(axes, frame, font_size=7, window=window)
        figure.text((column + 0.03) / columns, 1 - 0.05 / height,
                    f"{SCENES[names[side]]}: {stage(pictures.run, frame)}\n"
                    f"{load(pictures.run, frame)}", fontsize=8, va="top")
    draw_foot(figure, sides[0], tall / (above - below))
    save_small(figure, f"{IMAGES}/{figure_name}.png")
    plt.close(figure)


def read_run(name):
    return RunDirectory(os.path.join(RESULTS, name))


def measure(name):
    """Numbers of the first deformed state; none where there is no such state."""
    folder = os.path.join(RESULTS, name)
    with open(f"{folder}/statistics.csv", newline="") as table:
        states = [line for line in csv.DictReader(table)
                  if line["event"] == "deform"]
    if not states:
        return None
    state = states[0]
    with open(f"{folder}/nodes_0001.csv", newline="") as table:
        nodes = [{key: float(line[key]) for key in
                  ("x", "y", "z", "ux", "uy", "uz")}
                 for line in csv.DictReader(table)]
    numbers = {key: float(state[key]) for key, _ in MEASURES if key in state}
    for axis in "xy":
        places = [node[axis] + node["u" + axis] for node in nodes]
        numbers["width_" + axis] = max(places) - min(places)
    edge = {node["x"]: node["uz"] for node in nodes
            if (node["y"], node["z"]) == (10, 10)}
    numbers["rise"] = edge[5] - edge[10]
    return numbers


def rows_table():
    lines = [line for line in read_run("cut").statistics
             if line["event"] == "deform"]
    return table(["row", "depth [cm]", "cutting stress [gf/cm²]",
                  "required [gf/cm²]", "strain energy [gf cm]",
                  "largest displacement [cm]"],
                 [[str(line["row"] + 1), f"{line['depth']:g}",
                   f"{line['cutting_stress']:.5g}",
                   f"{line['required_stress']:g}",
                   f"{line['strain_energy']:.5g}",
                   f"{line['max_displacement']:.5g}"] for line in lines])


def scenes_table(measured):
    return table(["scene", "changed", *(title for _, title in MEASURES)],
                 [[f"{name}.prm", change,
                   *(f"{measured[name][key]:#.4g}" for key, _ in MEASURES)]
                  for name, change in SCENES.items()])


def statements_table(measured):
    lines = []
    for figure, text, key, trend in STATEMENTS:
        left = measured[f"figure_{figure}_left"][key]
        right = measured[f"figure_{figure}_right"][key]
        holds = right > left if trend == "grows" else right < left
        lines.append([figure, text, dict(MEASURES)[key], f"{left:#.4g}",
                      f"{right:#.4g}", "yes" if holds else "no"])
    return table(["figure", "the paper says", "measured", "left", "right",
                  "holds"], lines)


def edge_table(measured):
    return table(["scene", "elements", dict(MEASURES)["rise"]],
                 [[f"{name}.prm", elements, f"{measured[name]['rise']:+.3f}"]
                  for name, elements in (("figure_6_left", "1 × 2 × 1"),
                                         ("figure_6_right", "1 × 2 × 1"),
                                         (FINE, "4 × 8 × 4"))])


def finite_table(measured):
    """Small and finite strain beside each other."""
    scenes = {name: (change, measured[name], measure(f"finite/{name}"))
              for name, change in SCENES.items()}
    scenes["figure_6_left, edge held"] = (
        "E = 2.5, front fixed along x", measure("small/figure_6_left_held"),
        measure("finite/figure_6_left_held"))

    def both(small, finite, key):
        sign = "+" if key == "rise" else "#"
        return (f"{small[key]:{sign}.4g} → " +
                (f"{finite[key]:{sign}.4g}" if finite else "–"))
    keys = [(key, title) for key, title in MEASURES if key != "max_strain"]
    return table(["scene", "changed", *(title for _, title in keys)],
                 [[name, change, *(both(small, finite, key) for key, _ in keys)]
                  for name, (change, small, finite) in scenes.items()])


def table(titles, lines):
    rows = [titles, ["---"] * len(titles), *lines]
    return "\n".join(f"| {' | '.join(row)} |" for row in rows)


def fill_report(tables):
    """Put each table between its markers."""
    with open(REPORT) as file:
        text = file.read()
    for name, content in tables.items():
        text = re.sub(rf"(<!-- {name} -->\n).*?(<!-- end -->)",
                      rf"\1\n{content}\n\n\2", text, flags=re.S)
    with open(REPORT, "w") as file:
        file.write(text)


main()
