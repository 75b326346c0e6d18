#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Materials by their names: the table is whole, and a scene that names one is that
which sets its values, in whatever units.
"""

import csv
import pathlib
import subprocess
import sys
import tempfile

import program
import tables

COLUMNS = ["material", "quantity", "value", "unit", "conditions", "source", "tag"]
# Young's modulus of 24 kPa.
IN_UNITS = {("mm", "N"): 0.024, ("m", "N"): 24e3, ("cm", "gf"): 2.4 / 9.80665e-3,
            ("mm", "mN"): 24., ("um", "uN"): 0.024}


def check_table(options):
    """All values have a source or are assumed, and are printed."""
    said = subprocess.run([options.program, "--print-materials"], capture_output=True,
                          text=True, check=True).stdout
    with open(options.table, newline="") as table:
        lines = list(csv.DictReader(table))
    if not lines or list(lines[0]) != COLUMNS:
        sys.exit(f"{options.table}: columns {list(lines[0]) if lines else None}")
    for line in lines:
        if (line["tag"], line["source"] == "-") not in (("published", False),
                                                         ("assumed", True)):
            sys.exit(f"neither published nor assumed: {line}")
        origin = line["tag"] if line["source"] == "-" else line["source"]
        if line["material"] not in said.splitlines() or origin not in said:
            sys.exit(f"not printed: {line}")
    print(f"{len(lines)} values of {len({line['material'] for line in lines})} materials")


def run(options, *settings):
    """What is said, the values of the run and its largest displacement."""
    with tempfile.TemporaryDirectory() as directory:
        said = program.run(options, options.scene, directory, (*program.QUIET, *settings))
        values = {}
        for line in (pathlib.Path(directory) / "parameters.prm").read_text().splitlines():
            words = line.split("#")[0].split("=")
            if len(words) == 2 and words[0].split()[:1] == ["set"]:
                values[" ".join(words[0].split()[1:])] = words[1].strip()
        last = tables.read(pathlib.Path(directory) / "statistics.csv")[-1]
    return said, values, float(last["max_displacement"])


def main():
    parser = program.parser(__doc__)
    parser.add_argument("--scene", required=True)
    parser.add_argument("--table", required=True)
    options = parser.parse_args()
    check_table(options)
    said, _, named = run(options)
    for word in ("Young's modulus = 24 kPa", "assumed", "Forte et al. 2015"):
        if word not in said:
            sys.exit(f"'{word}' is not said:\n{said}")
    for (length, force), modulus in IN_UNITS.items():
        _, values, _ = run(options, f"Length unit={length}", f"Force unit={force}",
                           "Load/Tractions=")
        found = float(values["Young's modulus"])
        if abs(found / modulus - 1) > 1e-14:
            sys.exit(f"in {length} and {force} Young's modulus is {found}")
    _, _, explicit = run(options, "Material/Preset=", "Material/Young's modulus=0.024",
                         "Material/Poisson's ratio=0.49")
    said, values, changed = run(options, "Material/Young's modulus=0.048")
    print(f"largest displacement: {named}, with its values {explicit}, half {changed}")
    if named != explicit or abs(changed / named - 0.5) > 1e-12 or \
            "Young's modulus" in said or values["Poisson's ratio"] != "0.49":
        sys.exit("a preset must be its values, which a scene overrides")


main()
