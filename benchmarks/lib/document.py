# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents in Markdown that are written by measuring."""

import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def prepare(programs=(), packages=()):
    """Build the program and those of benchmarks/programs; install Debian packages."""
    subprocess.run([str(ROOT / "scripts" / "setup")], check=True)
    if packages:
        subprocess.run(["bash", "-c", "source scripts/lib/packages.sh; "
                        f"install_packages {' '.join(packages)}"], cwd=ROOT, check=True)
    if programs:
        subprocess.run(["ninja", "-C", str(ROOT / "build"),
                        *(f"benchmark_{program}" for program in programs)],
                       check=True, stdout=subprocess.DEVNULL)


def make(name, sections):
    """Print what the sections give, behind benchmarks/NAME.d/introduction.md and each
    under what its function says; only some, if the command line names them. With --write
    all of them are doc/NAME.md."""
    words = sys.argv[1:]
    names = [word for word in words if word != "--write"]
    for word in names:
        if word not in sections:
            sys.exit(f"{word}: there are {', '.join(sections)}")
    text = (ROOT / "benchmarks" / f"{name}.d" / "introduction.md").read_text()
    for title in names or sections:
        comment = " ".join(sections[title].__doc__.split())
        text += f"\n## {title}\n\n{comment}\n\n{sections[title]()}\n"
    if "--write" in words and not names:
        (ROOT / "doc" / f"{name}.md").write_text(text)
    else:
        print(text)
