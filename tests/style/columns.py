# SPDX-License-Identifier: LGPL-2.1-or-later
"""doc/results.md has the table of statistics.csv's columns as the program declares
them (scripts/document writes it): columns.py DOCUMENT TABLE"""

import pathlib
import sys

document, table = (pathlib.Path(name).read_text() for name in sys.argv[1:])
_, begin, rest = document.partition("<!-- columns -->\n")
shown = rest.partition("<!-- end -->")[0].strip()
if not begin or shown != table.strip():
    sys.exit("doc/results.md is not up to date: run scripts/document")
