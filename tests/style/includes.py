# SPDX-License-Identifier: LGPL-2.1-or-later
"""Headers include what they use of the standard library, and open no namespace for
those who include them. That deal.II's headers bring it along is luck.

usage: includes.py DIRECTORY
"""

import pathlib
import re
import sys

# Names of namespace std, and the headers any of which has them.
HEADERS = {
    "array": ["array"],
    "vector": ["vector"],
    "list": ["list"],
    "deque": ["deque"],
    "map": ["map"],
    "set": ["set"],
    "unordered_map": ["unordered_map"],
    "string": ["string"],
    "to_string": ["string"],
    "optional": ["optional"],
    "variant": ["variant"],
    "tuple": ["tuple"],
    "pair": ["utility"],
    "move": ["utility"],
    "function": ["functional"],
    "unique_ptr": ["memory"],
    "shared_ptr": ["memory"],
    "make_unique": ["memory"],
    "make_shared": ["memory"],
    "runtime_error": ["stdexcept"],
    "exception": ["exception"],
    "numeric_limits": ["limits"],
    "future": ["future"],
    "thread": ["thread"],
    "mutex": ["mutex"],
    "chrono": ["chrono"],
    "istream": ["iosfwd", "istream", "iostream"],
    "ostream": ["iosfwd", "ostream", "iostream"],
    "ostringstream": ["sstream"],
    "cout": ["iostream"],
    "max": ["algorithm"],
    "min": ["algorithm"],
    "sort": ["algorithm"],
    "accumulate": ["numeric"],
    "sqrt": ["cmath"],
}

COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
INCLUDE = re.compile(r"^\s*#\s*include\s*<([^>]+)>", re.MULTILINE)
NAME = re.compile(r"\bstd::(\w+)")


def problems_of(text):
    code = COMMENT.sub("", text)
    included = set(INCLUDE.findall(code))
    for name in sorted(set(NAME.findall(code))):
        if name in HEADERS and not included.intersection(HEADERS[name]):
            yield f"std::{name} needs #include <{HEADERS[name][0]}>"
    if re.search(r"^using namespace\b", code, re.MULTILINE):
        yield "'using namespace' reaches all who include it"


def main(directory):
    files = sorted(pathlib.Path(directory).rglob("*.h"))
    problems = [f"{path}: {problem}" for path in files
                for problem in problems_of(path.read_text())]
    print("\n".join(problems) or f"{len(files)} headers are whole")
    return 1 if problems or not files else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
