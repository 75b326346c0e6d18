# SPDX-License-Identifier: LGPL-2.1-or-later
"""What `cmake --install` puts into a directory runs from there, with its scenes.

usage: install.py CMAKE BUILD_DIRECTORY
"""

import pathlib
import subprocess
import sys
import tempfile

from run_files import broken_files, rows

# README.md links to the documents below it.
DOCUMENTS = ("README.md", "LICENSE", "doc/theory.md", "doc/images/film_strip.png")


def problems_of(prefix):
    documents = prefix / "share" / "doc" / "setsudan"
    yield from (f"{name} is missing" for name in DOCUMENTS
                if not (documents / name).is_file())
    scene = prefix / "share" / "setsudan" / "prm" / "kakefuda_1996" / "cut.prm"
    output = prefix / "results"
    result = subprocess.run(
        [prefix / "bin" / "setsudan", scene, "--output", output],
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, universal_newlines=True)
    if result.returncode != 0:
        yield f"the program does not run: {result.stderr.strip()}"
        return
    yield from broken_files(output)
    if "divide" not in {line[1] for line in rows(output / "statistics.csv")}:
        yield "the cut did not go through"


def main(cmake, build):
    with tempfile.TemporaryDirectory() as name:
        subprocess.run([cmake, "--install", build, "--prefix", name], check=True,
                       stdout=subprocess.DEVNULL)
        problems = list(problems_of(pathlib.Path(name)))
    print("\n".join(problems) or "the installed program runs")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
